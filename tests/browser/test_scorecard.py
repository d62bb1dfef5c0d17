"""The pages of a scorecard and of a grade: what they say, their pictures, and whether everybody can use them."""

import base64
import io
import json
import re

import numpy
import pytest
import suites
from PIL import Image

CONFORM = suites.REPOSITORY / "crates/conform/src"
SCRIPTS = sorted(CONFORM.rglob("*.js"))

# Ways for text of a renderer to become markup, or code.
FORBIDDEN = ["innerHTML", "outerHTML", "insertAdjacentHTML", "document.write", "eval(", "new Function", "srcdoc"]

# Every kind of page.
PAGES = [
    ("few", ""),
    ("few", "#/cell/limited/BlinnPhong"),
    ("few", "#/cell/exact/Silhouette"),
    ("few", "#/cell/limited/Normals"),
    ("few", "#/fixture/scene/temple"),
    ("few", "#/fixture/torus/annulus"),
    ("few", "#/nowhere/at/all"),
    ("few", "#/fixture/not/there"),
    ("few", "#/cell/exact/Nothing"),
    ("one", ""),
    ("one", "#/fixture/shadow/hard"),
    ("empty", ""),
    ("grade", ""),
    ("grade", "#/cell/limited/Torus"),
    ("grade", "#/fixture/torus/chain"),
]


@pytest.fixture
def open_card(open_page, cards):
    def open_card(name, hash="", **how):
        file = "grade" if name == "grade" else "scorecard"
        return open_page(cards / name / f"{file}.html", **how).go(hash)

    return open_card


def told(cards, name="few", file="scorecard"):
    return json.loads((cards / name / f"{file}.json").read_text())


def unfold(look):
    """Opens everything that is folded, and waits until it is filled."""
    look.page.evaluate("for (const one of document.querySelectorAll('details')) one.open = true")
    look.page.wait_for_function(
        "[...document.querySelectorAll('details.result .body')].every((body) => body.childElementCount > 0)"
    )


def is_too_wide(look):
    return look.page.evaluate("document.documentElement.scrollWidth > document.documentElement.clientWidth")


def picture(look, index):
    """The codes of a picture that is seen."""
    source = look.page.locator("figure img").nth(index).get_attribute("src")
    data = base64.b64decode(source.removeprefix("data:image/png;base64,"))
    return numpy.array(Image.open(io.BytesIO(data)).convert("RGB")).astype(int)


@pytest.mark.parametrize("colors", ["light", "dark"])
@pytest.mark.parametrize("name, hash", PAGES, ids=lambda part: re.sub(r"\W+", "-", part))
def test_every_page_for_everybody(open_card, axe, shoot, name, hash, colors):
    look = open_card(name, hash, colors=colors)
    unfold(look)
    axe(look)
    shoot(look, f"card-{name}{re.sub(r'[^A-Za-z]+', '-', hash)}-{colors}")


@pytest.mark.parametrize("name, hash", PAGES, ids=lambda part: re.sub(r"\W+", "-", part))
def test_a_phone(open_card, axe, shoot, name, hash):
    look = open_card(name, hash, width=360, height=740)
    unfold(look)
    assert not is_too_wide(look)
    axe(look)
    shoot(look, f"card-{name}{re.sub(r'[^A-Za-z]+', '-', hash)}-phone")


def test_renderers_are_told_as_they_are(open_card, cards):
    look = open_card("few")
    assert look.text("h1") == "4 renderers, 8 fixtures"
    for renderer in told(cards)["renderers"]:
        card = look.page.locator(f"[data-id={renderer['id']}]")
        tally = renderer["tally"]
        words = card.inner_text()
        assert words.startswith(renderer["name"]), "markup in a name is text"
        assert f"{tally['outcomes']['pass']} of {tally['total']} fixtures pass" in words
        for outcome, count in tally["outcomes"].items():
            shown = f"{count} {outcome.replace('_', ' ')}" in words
            assert shown == (count > 0 and outcome != "pass"), (outcome, words)
        assert f"{tally['edge_off']:,} of {tally['edge_pixels']:,}" in words
    assert "may be common to all" in look.text("[data-id=gamma]")
    assert "may be common to all" not in look.text("[data-id=limited]")


def test_a_part_of_the_suite_is_told_as_one(open_card, cards):
    selection = told(cards)["selection"]
    assert selection["fixtures"] == 8 < selection["of"]
    assert open_card("few").text(".selection") == f"{selection['words']}."
    assert told(cards, "many")["selection"] is None
    assert open_card("many").page.locator(".selection").count() == 0


def test_the_matrix_says_what_the_runs_say(open_card, cards):
    look = open_card("few")
    rows = look.page.locator(".matrix").first.locator("tr:has(th[scope=row])")
    document = told(cards)
    assert rows.count() == len(document["features"])
    words = {standing["id"]: standing["words"] for standing in document["standings"]}
    for row, feature in zip(rows.all(), document["features"], strict=True):
        assert row.locator("th").inner_text().replace("\u200b", "") == feature["feature"]
        cells = row.locator("td").all_text_contents()
        for cell, renderer in zip(cells, document["renderers"], strict=True):
            told_of = feature["cells"][renderer["id"]]
            passed, total = told_of["tally"]["outcomes"]["pass"], told_of["tally"]["total"]
            assert cell.startswith(f"{words[told_of['standing']]} {passed}/{total}"), (cell, told_of)


def test_a_cell_leads_to_its_fixtures_and_back(open_card, cards):
    look = open_card("few")
    look.page.click('a[href="#/cell/limited/BlinnPhong"]')
    look.page.wait_for_function("document.querySelector('h1').textContent.startsWith('BlinnPhong with ')")
    assert look.page.evaluate("document.activeElement.id") == "main", "the reader is where the page is"
    outcomes = look.texts("details.result .badge")
    having = [f for f in told(cards)["fixtures"] if "BlinnPhong" in f["features"] and "limited" in f["results"]]
    assert sorted(outcomes) == sorted(f["results"]["limited"]["outcome"].replace("_", " ") for f in having)
    ranks = [["fail", "crashed", "pass", "unsupported"].index(outcome) for outcome in outcomes]
    assert [rank > 1 for rank in ranks] == sorted(rank > 1 for rank in ranks), "failures first"
    first = look.page.locator("details.result").first
    assert first.get_attribute("open") is not None and first.locator("img").count() == 3
    second = look.page.locator("details.result").nth(1)
    assert second.locator("img").count() == 0, "what is folded is not decoded"
    second.locator("summary").press("Enter")
    second.locator("img").first.wait_for()
    look.page.go_back()
    look.page.wait_for_selector(".matrix")
    assert look.page.title() == "goldray scorecard: Exact, No gamma, Recolored, Limited <b>&amp;"


def test_pictures_are_the_reference_the_actual_and_where_they_differ(open_card, cards):
    look = open_card("few", "#/fixture/show/silhouette")
    section = look.page.locator("section:has(#with-recolored)")
    assert section.locator("figcaption").all_text_contents() == ["goldray", "Recolored", "Difference"]
    look.page.wait_for_function("[...document.images].every((image) => image.complete && image.naturalWidth > 0)")
    sources = [image.get_attribute("src") for image in section.locator("img").all()]
    shown = [image.get_attribute("src") for image in look.page.locator("figure img").all()]
    reference, actual, difference = (picture(look, shown.index(source)) for source in sources)
    golden = suites.codes(suites.golden_path(suites.REPOSITORY, "show/silhouette"))
    assert (reference == golden).all(), "goldray's picture is as its golden"
    is_off = (difference != difference[:, :, :1]).any(axis=2)
    # More than white is off, and has the codes of white.
    assert is_off.any() and (is_off | (reference == actual).all(axis=2)).all()
    numbers = next(f for f in told(cards)["fixtures"] if f["name"] == "show/silhouette")["results"]["recolored"]["numbers"]
    assert is_off.sum() == numbers["interior_off"] + numbers["edge_off"]
    edge = (difference == json.loads(look.page.locator("#card").text_content())["colors"]["edge"]).all(axis=2)
    assert edge.sum() == numbers["edge_off"]


def test_the_ring_is_around_the_worst_pixel(open_card, cards):
    look = open_card("few", "#/fixture/shading/classic")
    fixture = next(f for f in told(cards)["fixtures"] if f["name"] == "shading/classic")
    x, y = fixture["results"]["recolored"]["numbers"]["worst_at"]
    section = look.page.locator("section:has(#with-recolored)")
    size = json.loads(look.page.locator(f"#fixture-{told(cards)['fixtures'].index(fixture)}").text_content())["size"]
    for image, ring in zip(section.locator("img").all(), section.locator(".ring").all(), strict=True):
        box, mark = image.bounding_box(), ring.bounding_box()
        middle = mark["x"] + mark["width"] / 2 - box["x"], mark["y"] + mark["height"] / 2 - box["y"]
        scale = box["width"] / size[0]
        assert middle == pytest.approx(((x + 0.5) * scale, (y + 0.5) * scale), abs=1)
    assert f"at ({x}, {y}), on the " in section.inner_text()
    assert look.page.locator("section:has(#with-exact) .ring").count() == 0


def test_a_failure_says_what_it_may_be(open_card):
    look = open_card("few", "#/fixture/shading/classic")
    said = look.text("section:has(#with-limited) .suspects")
    assert said == "It may be BlinnPhong: the only feature of it that no passing fixture has."
    assert look.page.locator("section:has(#with-exact) .suspects").count() == 0


def test_the_consensus_of_a_scene(open_card, cards):
    look = open_card("few", "#/fixture/shadow/hard")
    fixture = next(f for f in told(cards)["fixtures"] if f["name"] == "shadow/hard")
    consensus = fixture["consensus"]
    section = look.page.locator("section:has(#told)")
    assert "Heard: goldray, Exact, No gamma, Recolored, Limited <b>&amp;." in section.inner_text()
    rows = section.locator("tbody tr")
    assert rows.count() == len(consensus["regions"]) > 1
    for row, region in zip(rows.all(), consensus["regions"], strict=True):
        cells = row.locator("td").all_text_contents()
        assert cells[:4] == [
            f"{region['pixels']:,}",
            f"({region['from'][0]}, {region['from'][1]})",
            f"({region['to'][0]}, {region['to'][1]})",
            region["words"],
        ]
    images = look.page.locator("figure img").count()
    drawn = picture(look, images - 1)
    colors = json.loads(look.page.locator("#card").text_content())["colors"]
    alone = next(one for one in consensus["opinions"] if one["against"] == ["gamma"])
    yellow = colors["voters"][consensus["voters"].index("gamma")]
    assert (drawn == yellow).all(axis=2).sum() == alone["interior"]


def test_fixtures_are_filtered(open_card, cards):
    look = open_card("few")
    rows = look.page.locator("table.fixtures tbody tr")
    assert rows.count() == 8
    look.page.fill("#wanted", "TORUS")
    assert rows.count() == 2 and look.text(".found") == "2 fixtures of 8 shown"
    look.page.fill("#wanted", "")
    look.page.select_option("#outcome", "crashed")
    assert look.texts("table.fixtures tbody th") == ["torus/chain"]
    look.page.select_option("#outcome", "timed_out")
    assert rows.count() == 0
    look.page.select_option("#outcome", "")
    assert rows.count() == 8


def test_many_fixtures_open_at_once(open_card, cards, axe, shoot):
    look = open_card("many", width=1280)
    count = len(told(cards, "many")["fixtures"])
    assert count > 100 and look.page.locator("table.fixtures tbody tr").count() == count
    loading = look.page.evaluate(
        "() => { const [entry] = performance.getEntriesByType('navigation'); return entry.domContentLoadedEventEnd; }"
    )
    assert loading < 3000, f"{loading} ms"
    axe(look)
    shoot(look, "card-many")
    look = open_card("many", "#/cell/gamma/Sphere")
    assert look.page.locator("details.result").count() > 20


def test_the_matrix_is_scrolled_alone_and_names_stay(open_card):
    look = open_card("few", width=360, height=740)
    region = look.page.get_by_role("region", name="Features by renderers")
    region.focus()
    name = region.locator("th[scope=row]").first
    left = name.bounding_box()["x"]
    region.evaluate("(region) => region.scrollTo(200, 0)")
    assert region.evaluate("(region) => region.scrollLeft") > 100
    assert name.bounding_box()["x"] == pytest.approx(left, abs=1)


def test_all_by_keyboard(open_card):
    look = open_card("few")
    reached = set()
    for _ in range(200):
        look.press("Tab")
        here, is_seen = look.page.evaluate(
            """() => {
                const at = document.activeElement;
                const { outlineStyle, outlineWidth } = getComputedStyle(at);
                return [at.id || at.className || at.tagName, outlineStyle !== "none" && outlineWidth !== "0px"];
            }"""
        )
        if here == "BODY":
            break
        assert is_seen, f"the focus on {here} is not seen"
        reached.add(here)
    assert {"theme", "cell", "name", "scrolled", "wanted", "outcome", "SUMMARY"} <= reached


def test_a_grade_adds_up_and_has_its_evidence(open_card, cards):
    look = open_card("grade")
    grade = told(cards, "grade", "grade")
    assert look.text("h1") == f"{grade['title']}: {grade['points']:g} of {grade['of']:g} points"
    rows = [row.locator("th, td").all_text_contents() for row in look.page.locator(".marks tbody tr").all()]
    assert [row[0] for row in rows] == [one["name"] for one in grade["parts"] + grade["penalties"]] + ["All"]
    shown = [float(row[1].replace("−", "-")) for row in rows]
    assert sum(shown[:-1]) == pytest.approx(shown[-1], abs=1e-9) and shown[-1] == grade["points"]
    for index, part in enumerate(grade["parts"]):
        section = look.page.locator(f"section.part:has(#part-{index})")
        failing = [one["name"] for one in part["fixtures"] if one["outcome"] != "pass"]
        assert section.locator("details.result summary .name").all_text_contents() == failing
        is_open = [one.get_attribute("open") is not None for one in section.locator("details.result").all()]
        ended = [one["outcome"] for one in part["fixtures"] if one["outcome"] != "pass"]
        assert is_open == [outcome != "unsupported" for outcome in ended]
        if failing and part["fixtures"][-1]["outcome"] == "fail":
            assert section.locator("img").count() >= 3


@pytest.mark.parametrize("name, hash", [("few", ""), ("few", "#/fixture/torus/annulus"), ("grade", "")])
def test_a_frame_is_as_wide_as_its_table(open_card, name, hash):
    look = open_card(name, hash)
    look.page.set_viewport_size({"width": 1280, "height": 900})
    gaps = look.page.evaluate(
        """[...document.querySelectorAll(".scrolled")].map((frame) =>
            frame.clientWidth - frame.querySelector("table").getBoundingClientRect().width)"""
    )
    assert gaps and all(abs(gap) <= 1 for gap in gaps), gaps


@pytest.mark.parametrize("path", SCRIPTS, ids=lambda path: f"{path.parent.name}-{path.stem}")
def test_a_script_says_what_it_is_and_is_one_idea_long(path):
    text = path.read_text()
    assert re.match(r"// [A-Z][^\n]+\.\n\n", text), "expected a sentence and an empty line at the start"
    assert len(text.splitlines()) <= 250
    assert [word for word in FORBIDDEN if word in text] == []


def test_every_script_is_in_a_page_once():
    sources = [path.read_text() for path in CONFORM.rglob("*.rs")]
    named = [name for text in sources for name in re.findall(r'include_str!\("([^"]+\.js)"\)', text)]
    assert sorted(name.split("/")[-1] for name in named) == sorted(path.name for path in SCRIPTS)


@pytest.mark.parametrize("name", ["few", "grade"])
def test_the_page_may_ask_for_nothing(cards, name):
    file = "grade" if name == "grade" else "scorecard"
    text = (cards / name / f"{file}.html").read_text()
    policy = re.search(r'http-equiv="Content-Security-Policy" content="([^"]+)"', text)[1]
    parts = dict(part.strip().split(" ", 1) for part in policy.split(";"))
    assert parts["default-src"] == "'none'" and parts["img-src"] == "data:"
    assert "connect-src" not in parts
    assert "url(" not in (CONFORM / "page/style.css").read_text()
