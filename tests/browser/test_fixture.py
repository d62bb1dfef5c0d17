"""The page of a fixture beside its pictures: what is said, the source, commands, keys."""

import pytest
import suites


@pytest.fixture
def temple(open_page, broken_page):
    return open_page(broken_page).fixture(suites.DIFFERS)


def entry(look, name):
    return next(one for one in look.report()["fixtures"] if one["name"] == name)


def test_the_source_is_the_file_line_by_line(temple):
    lines = temple.page.eval_on_selector_all(".source li code", "(all) => all.map((one) => one.textContent)")
    assert "\n".join(lines) + "\n" == suites.text_of(suites.REPOSITORY, suites.DIFFERS)
    assert temple.texts(".source .ron-comment")[0].startswith("// A temple of steps")
    assert temple.texts(".source .ron-string")[0] == '"grass"'
    assert "LookAt" in temple.texts(".source .ron-thing")
    assert "fov_deg" in temple.texts(".source .ron-field")
    assert {"3.6", "120"} <= set(temple.texts(".source .ron-number"))


def test_blamed_lines_are_marked_and_led_to(temple):
    blamed = entry(temple, suites.DIFFERS)["blamed"]
    lines = {one["line"] for one in blamed if one["line"] is not None}
    marked = temple.page.eval_on_selector_all(
        ".source .is-blamed", "(all) => all.map((one) => Number(one.id.slice(5)))"
    )
    assert marked == sorted(lines) and len(lines) > 4
    first = blamed[0]
    temple.page.click(f".blame button:has-text('{first['kind']}, line {first['line']}')")
    assert temple.page.locator(".source .is-shown").get_attribute("id") == f"line-{first['line']}"
    box = temple.page.locator(".source .is-shown").bounding_box()
    assert 0 < box["y"] < 900, "it is in view"


def test_metrics_are_held_against_limits(open_page, broken_page):
    look = open_page(broken_page).fixture(suites.LIMITED)
    fixture = entry(look, suites.LIMITED)
    words = {limit["metric"]: limit for limit in fixture["limits"]}
    assert set(words) == {"ssim_mean", "ssim_min", "max_abs"}
    broken = look.page.eval_on_selector_all(
        ".metrics .is-broken", "(all) => all.map((one) => one.dataset.metric)"
    )
    assert (
        sorted(broken)
        == sorted(name for name, limit in words.items() if limit["broken"])
        == ["max_abs", "ssim_min"]
    )
    assert look.text("[data-metric=max_abs] td:nth-child(3)").startswith("≤ 9 ✗")
    assert look.text("[data-metric=ssim_mean] td:nth-child(3)").startswith("≥ 0.97 ✓")
    assert look.text("[data-metric=max_abs] td:nth-child(2)").split()[0] == str(fixture["max_abs"])
    look.page.click("[data-metric=max_abs] summary")
    metric = next(one for one in look.report()["metrics"] if one["name"] == "max_abs")
    said = look.texts("[data-metric=max_abs] details p")
    assert said == [
        f"Measures {metric['measures']}.",
        f"Range: {metric['range']}; lower is closer.",
        f"Blind to: {metric['blind_spot']}.",
    ]
    assert len(look.texts(".metrics tbody tr")) == len(look.report()["metrics"])


def test_a_limit_that_nothing_was_held_against_is_not_said_to_hold(open_page, broken_page):
    look = open_page(broken_page).fixture(suites.WRONG_SIZE)
    assert look.text("[data-metric=max_abs] td:nth-child(3)") == "≤ 9"
    assert look.text("[data-metric=max_abs] td:nth-child(2)") == "–"


def test_findings_are_said_in_full(open_page, broken_page):
    for name in (suites.DIFFERS, suites.REFUSED, suites.EXPECTATION, suites.WRONG_SIZE, suites.TAMPERED):
        look = open_page(broken_page).fixture(name)
        found = look.page.eval_on_selector_all(".findings li", "(all) => all.map((one) => one.textContent)")
        assert found == entry(look, name)["findings"]
    look = open_page(broken_page).fixture(suites.EXPECTATION)
    assert "cannot be accepted" in look.text(".findings .note")


def test_hundreds_of_findings_are_folded(open_page, odd_page):
    look = open_page(odd_page).fixture(suites.ODD)
    assert len(entry(look, suites.ODD)["findings"]) == 301
    visible = [one for one in look.page.locator(".findings li").all() if one.is_visible()]
    assert len(visible) == 12
    look.page.click(".findings summary")
    assert look.page.locator(".findings li:visible").count() == 301


def test_commands_are_copied(temple, goldray, broken_page):
    root = broken_page.parents[2]
    commands = temple.texts(".command code")
    assert commands == [
        f"cargo xtask --root {root} check {suites.DIFFERS}",
        f"cargo xtask --root {root} bless {suites.DIFFERS}",
    ]
    for number, command in enumerate(commands):
        temple.page.locator(".command button").nth(number).click()
        temple.page.wait_for_function(
            f"() => document.querySelectorAll('.command button')[{number}].textContent === 'Copied'"
        )
        assert temple.page.evaluate("navigator.clipboard.readText()") == command


def test_commands_of_a_name_with_spaces(open_page, broken_page):
    look = open_page(broken_page).fixture(suites.ORPHAN)
    assert look.texts(".command code")[-1].endswith(f"bless --prune '{suites.ORPHAN}'")
    assert look.page.locator(".source").count() == 0


def test_next_and_previous_follow_the_overview(look):
    look.page.select_option("#sort", "name")
    names = look.names()
    look.page.click(f".card[data-name='{names[1]}'] a")

    def h1(name):
        return look.page.wait_for_function(
            "(name) => document.querySelector('h1').textContent === name", arg=name
        )

    h1(names[1])
    look.press("j")
    h1(names[2])
    look.press("ArrowRight")
    h1(names[3])
    look.press("k", "ArrowLeft")
    h1(names[1])
    look.page.click("text=Previous")
    h1(names[0])
    assert look.page.locator("button:has-text('Previous')").is_disabled()
    look.press("k")
    h1(names[0])
    look.press("Escape")
    look.page.wait_for_selector(".sheet")
    assert look.hash() == "#/?sort=name" and look.names() == names
    look.page.go_back()
    h1(names[0])


def test_the_list_of_keys(temple):
    temple.press("?")
    assert temple.page.locator("#keys").is_visible()
    assert "next fixture" in temple.text("#keys")
    assert "accept" not in temple.text("#keys"), "a report decides nothing"
    temple.press("j")
    assert temple.text("h1") == suites.DIFFERS, "keys are those of the dialog"
    temple.press("Escape")
    assert not temple.page.locator("#keys").is_visible()
    assert temple.text("h1") == suites.DIFFERS


def test_keys_do_not_take_what_is_written(look):
    look.press("/")
    look.page.keyboard.type("?j1 k")
    assert look.page.input_value("#filter-text") == "?j1 k"
    assert not look.page.locator("#keys").is_visible()


@pytest.mark.parametrize("name", ["no/such", "%", "%E0%A4%A", "a?b"])
def test_a_name_that_no_fixture_has(open_page, broken_page, name):
    look = open_page(broken_page).go(f"#/fixture/{name}")
    assert look.text("h1") == "No such fixture"
    look.page.click("main a")
    look.page.wait_for_selector(".sheet")


def test_light_and_dark(temple):
    def paper():
        return temple.page.evaluate("getComputedStyle(document.body).backgroundColor")

    light = paper()
    temple.page.click("#theme")
    assert paper() != light
    temple.page.reload()
    temple.page.wait_for_selector(".viewer")
    assert paper() != light, "the choice holds over a reload"
    temple.page.click("#theme")
    assert paper() == light


@pytest.mark.parametrize(
    "name, words", [(suites.EXPECTATION, "expected here"), (suites.REFUSED, "refused here")]
)
def test_the_place_of_a_failure_is_marked_and_led_to(open_page, broken_page, axe, name, words):
    look = open_page(broken_page).fixture(name)
    line, column = entry(look, name)["line"], entry(look, name)["column"]
    assert look.texts(".source .is-named .blame-note") == [words]
    assert look.page.locator(".source .is-named").get_attribute("id") == f"line-{line}"
    look.page.click(f".findings button:has-text('line {line}, column {column}')")
    assert look.page.locator(".source .is-shown").get_attribute("id") == f"line-{line}"
    axe(look)


def test_a_blamed_line_is_not_marked_twice(temple):
    assert entry(temple, suites.DIFFERS)["line"] is not None
    assert temple.page.locator(".source .is-named").count() == 0


@pytest.mark.parametrize("width", [1280, 360])
def test_what_a_refused_fixture_is_told_is_read_without_scrolling(open_page, broken_page, width):
    look = open_page(broken_page, width=width).fixture(suites.REFUSED)
    report = look.page.locator(".findings pre")
    assert report.evaluate("(pre) => pre.scrollWidth <= pre.clientWidth")
    box, main = report.bounding_box(), look.page.locator("#main").bounding_box()
    assert box["width"] > main["width"] - 80
    assert box["y"] < look.page.locator(".source").bounding_box()["y"]


def test_the_share_of_blame_says_of_what_it_is(temple):
    assert "share of the sum of all differences of codes" in temple.text(".blame h2")


def test_the_golden_that_is_no_picture_is_as_one_that_is_not_there(open_page, unreadable_page, axe):
    look = open_page(unreadable_page).go()
    look.page.wait_for_function("() => document.querySelector('.frame img')?.naturalWidth > 0")
    look.fixture(suites.UNREADABLE)
    assert entry(look, suites.UNREADABLE)["verdict"] == "unreadable"
    disabled = look.page.eval_on_selector_all(
        ".views [aria-disabled]", "(all) => all.map((one) => one.dataset.view)"
    )
    assert disabled == ["sides", "blink", "swipe", "difference", "ssim", "flip", "threshold", "golden"]
    for view in disabled:
        title = look.page.get_attribute(f"[data-view={view}]", "title")
        assert title == "Not here: the golden cannot be read"
    assert "the golden cannot be read" in look.text(".viewer .note")
    expected = suites.codes(suites.golden_path(suites.REPOSITORY, suites.UNREADABLE))
    assert look.texts(".views [aria-pressed=true]") == ["Actual"]
    assert (look.seen() == expected).all()
    look.press("8")
    assert look.texts(".views [aria-pressed=true]") == ["Objects"]
    axe(look)
