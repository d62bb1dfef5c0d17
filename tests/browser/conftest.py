"""What the tests share: the program, the suites with their pages, and a browser that notices everything."""

import json
import re
import subprocess
from pathlib import Path

import pytest
import suites
from axe_playwright_python.sync_playwright import Axe
from looking import Look
from playwright.sync_api import sync_playwright

# All that there is of WCAG up to 2.2 AA, and what axe holds to be good practice.
AXE_TAGS = ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa", "best-practice"]

MANY = 2000


def pytest_addoption(parser):
    parser.addoption("--program", required=True, help="the xtask to test")
    parser.addoption("--scorecards", required=True, help="the example that writes scorecards")
    parser.addoption("--chromium", required=True, help="the browser's program")
    parser.addoption("--shots", help="a folder for pictures of the pages")


@pytest.fixture(scope="session")
def goldray(request):
    return suites.Goldray(request.config.getoption("--program"))


@pytest.fixture(scope="session")
def folder(tmp_path_factory):
    return tmp_path_factory.mktemp("suites")


def suite_page(name, make, expected):
    """A fixture of pytest: the page of a suite that is made once."""

    @pytest.fixture(scope="session", name=f"{name}_page")
    def page(folder, goldray):
        make(folder / name, goldray)
        return goldray.check(folder / name, expected=expected)

    return page


broken_page = suite_page("broken", lambda root, _: suites.broken(root), 1)
odd_page = suite_page("odd", suites.odd, 1)
unreadable_page = suite_page("unreadable", lambda root, _: suites.unreadable(root), 1)
green_page = suite_page("green", lambda root, _: suites.green(root), 0)
many_page = suite_page("many", lambda root, _: suites.many(root, MANY), 1)


@pytest.fixture(scope="session")
def cards(folder, request):
    """Scorecards and a grade, by the names of their folders."""
    out = folder / "cards"
    subprocess.run([request.config.getoption("--scorecards"), suites.REPOSITORY, out], check=True)
    return out


def changed_page(page, name, change):
    """A page with another report in it."""
    text = page.read_text()
    report = json.loads(re.search(r'id="report">(.*?)</script>', text)[1])
    change(report)
    told = json.dumps(report).replace("<", "\\u003c")
    text = re.sub(r'id="report">.*?</script>', lambda _: f'id="report">{told}</script>', text)
    path = page.parent / f"{name}.html"
    path.write_text(text)
    return path


@pytest.fixture(scope="session")
def empty_page(green_page):
    """The page of a run over nothing: a check refuses it, a watch may come to it."""

    def change(report):
        report["fixtures"] = []
        report["summary"] = {key: 0 for key in report["summary"]} | {"green": False}

    path = changed_page(green_page, "empty", change)
    text = re.sub(r'<script type="application/json" id="fixture-.*?</script>', "", path.read_text())
    path.write_text(text)
    return path


@pytest.fixture(scope="session")
def browser(request):
    with sync_playwright() as playwright:
        program = request.config.getoption("--chromium")
        browser = playwright.chromium.launch(executable_path=program, args=["--no-sandbox"])
        yield browser
        browser.close()


@pytest.fixture
def open_page(browser):
    """Opens a page; at the end of the test nothing must have gone wrong on any."""
    opened = []

    def open_page(path, *, width=1280, height=900, colors="light", motion="reduce", touch=False):
        context = browser.new_context(
            viewport={"width": width, "height": height},
            color_scheme=colors,
            reduced_motion=motion,
            has_touch=touch,
            permissions=["clipboard-read", "clipboard-write"],
        )
        url = path if isinstance(path, str) else path.as_uri()
        look = Look(context.new_page(), url)
        opened.append(look)
        return look

    yield open_page
    for look in opened:
        assert look.problems == [], look.problems
        look.page.context.close()


@pytest.fixture
def look(open_page, broken_page):
    """The broken suite, on the overview."""
    return open_page(broken_page).go()


@pytest.fixture
def shoot(request):
    """Writes what a page looks like, where pictures are asked for."""
    target = request.config.getoption("--shots")

    def shoot(look, name):
        if target:
            Path(target).mkdir(parents=True, exist_ok=True)
            look.page.screenshot(path=Path(target) / f"{name}.png")

    return shoot


@pytest.fixture(scope="session")
def axe():
    def axe(look):
        found = Axe().run(look.page, options={"runOnly": {"type": "tag", "values": AXE_TAGS}})
        assert found.violations_count == 0, found.generate_report()

    return axe
