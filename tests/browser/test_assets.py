"""The files the page is made of: what they must say, and what they must not."""

import re

import pytest
import suites

PAGE = suites.REPOSITORY / "crates/harness/src/report/page"
SCRIPTS = sorted((PAGE / "script").rglob("*.js"))

# Ways for text of a suite to become markup, or code.
FORBIDDEN = [
    "innerHTML",
    "outerHTML",
    "insertAdjacentHTML",
    "document.write",
    "eval(",
    "new Function",
    "srcdoc",
]


def test_every_script_is_in_the_page_once():
    named = re.findall(r'include_str!\("(script/[^"]+)"\)', (PAGE / "assets.rs").read_text())
    assert sorted(named) == [str(path.relative_to(PAGE)) for path in SCRIPTS] and len(named) > 30


@pytest.mark.parametrize("path", SCRIPTS, ids=lambda path: path.stem)
def test_a_script_says_what_it_is_and_is_one_idea_long(path):
    text = path.read_text()
    assert re.match(r"// [A-Z][^\n]+\.\n\n", text), "expected a sentence and an empty line at the start"
    assert len(text.splitlines()) <= 250
    assert [word for word in FORBIDDEN if word in text] == []


def test_the_page_may_ask_for_nothing():
    policy = re.search(
        r'http-equiv="Content-Security-Policy" content="([^"]+)"', (PAGE / "page.html").read_text()
    )[1]
    parts = dict(part.strip().split(" ", 1) for part in policy.split(";"))
    assert parts["default-src"] == "'none'" and parts["connect-src"] == "'self'"
    assert parts["img-src"] == "data: blob:"
    assert not re.search(r"https?://(?!www\.w3\.org/2000/svg)", (PAGE / "page.html").read_text())
    for style in PAGE.glob("*.css"):
        assert "url(" not in style.read_text()


def test_every_style_is_in_the_page_once_and_one_idea_long():
    named = re.findall(r'include_str!\("([^"]+\.css)"\)', (PAGE / "assets.rs").read_text())
    assert sorted(named) == sorted(path.name for path in PAGE.glob("*.css")) and len(named) == 3
    for name in named:
        text = (PAGE / name).read_text()
        assert text.startswith("/* ") and len(text.splitlines()) <= 250, name
