"""Every page and view for everybody: axe's rules, light and dark, phones, the keyboard."""

import pytest
import suites

VIEWS = ["sides", "blink", "swipe", "difference", "ssim", "flip", "threshold", "objects", "golden", "actual"]


@pytest.mark.parametrize("colors", ["light", "dark"])
def test_the_overview(open_page, broken_page, axe, shoot, colors):
    look = open_page(broken_page, colors=colors).go()
    axe(look)
    shoot(look, f"overview-{colors}")
    look.page.click(".chip[data-verdict=differs]")
    axe(look)
    look.press("?")
    axe(look)
    shoot(look, f"keys-{colors}")


@pytest.mark.parametrize("colors", ["light", "dark"])
def test_every_view(open_page, broken_page, axe, shoot, colors):
    look = open_page(broken_page, colors=colors, width=1440, height=1000).fixture(suites.DIFFERS)
    for view in VIEWS:
        look.page.click(f"[data-view={view}]")
        axe(look)
        shoot(look, f"view-{view}-{colors}")
    look.page.click("[data-view=sides]")
    look.page.click("text=Worst FLIP")
    axe(look)
    shoot(look, f"view-zoomed-{colors}")


@pytest.mark.parametrize("colors", ["light", "dark"])
@pytest.mark.parametrize(
    "name",
    [suites.LIMITED, suites.REFUSED, suites.ORPHAN, suites.WRONG_SIZE, suites.EXPECTATION, suites.MATCHES[0]],
)
def test_every_kind_of_fixture(open_page, broken_page, axe, shoot, name, colors):
    look = open_page(broken_page, colors=colors).fixture(name)
    for summary in look.page.locator(".metrics summary").all():
        summary.click()
    axe(look)
    shoot(look, f"fixture-{name.replace('/', '-').replace(' ', '-')}-{colors}")


def is_too_wide(look):
    return look.page.evaluate("document.documentElement.scrollWidth > document.documentElement.clientWidth")


def test_a_phone(open_page, broken_page, axe, shoot):
    look = open_page(broken_page, width=360, height=740).go()
    assert not is_too_wide(look)
    axe(look)
    shoot(look, "phone-overview")
    for name in (suites.DIFFERS, suites.LIMITED, suites.REFUSED):
        look.fixture(name)
        for view in VIEWS:
            look.page.click(f"[data-view={view}]", force=True)
            assert not is_too_wide(look), view
        axe(look)
    look.fixture(suites.DIFFERS, "threshold")
    shoot(look, "phone-fixture")


def test_a_phone_with_odd_names(open_page, odd_page, shoot):
    look = open_page(odd_page, width=360, height=740).go()
    assert not is_too_wide(look)
    for name in (suites.LONG, suites.ODD, suites.WIDE):
        look.fixture(name)
        assert not is_too_wide(look), name
    shoot(look, "phone-wide-picture")


def test_all_by_keyboard(open_page, broken_page):
    """From one end of a page to the other by the tab key, always to be seen."""
    look = open_page(broken_page).fixture(suites.DIFFERS, "swipe")
    reached = set()
    for _ in range(120):
        look.press("Tab")
        here, is_seen = look.page.evaluate(
            """() => {
                const { outlineStyle, outlineWidth } = getComputedStyle(document.activeElement);
                const at = document.activeElement;
                return [at.id || at.dataset.view || at.getAttribute("role") || at.tagName, outlineStyle !== "none" && outlineWidth !== "0px"];
            }"""
        )
        if here == "BODY":
            break
        assert is_seen, f"the focus on {here} is not seen"
        reached.add(here)
    assert {
        "theme",
        "show-keys",
        "sides",
        "actual",
        "slider",
        "application",
        "SUMMARY",
        "CODE",
        "OL",
    } <= reached


def test_the_table_of_a_pixel_on_a_phone(open_page, broken_page):
    look = open_page(broken_page, width=360, height=740).fixture(suites.DIFFERS)
    for words in ("Worst FLIP", "First differing"):
        look.page.click(f"text={words}")
        cut = look.page.eval_on_selector_all(
            ".readout :is(td, th)",
            "(all) => all.filter((one) => one.scrollWidth > one.clientWidth).map((one) => one.textContent)",
        )
        assert cut == []


def test_the_header_of_a_phone_has_two_rows(open_page, broken_page):
    look = open_page(broken_page, width=360, height=740).go()
    tops = {round(look.page.locator(one).bounding_box()["y"]) for one in (".brand", "#theme", "#show-keys")}
    assert len(tops) == 1, "one without a review"
