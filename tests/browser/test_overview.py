"""The overview: what came out, filters, order, and links to it."""

import re
import time

import pytest
import suites
from conftest import MANY


def test_the_headline_and_the_chips_count_the_verdicts(look):
    summary = look.report()["summary"]
    failed = summary["total"] - summary["match"]
    assert look.text("h1") == f"{failed} of {summary['total']} fixtures fail"
    chips = dict(reversed(re.match(r"(\d+) (.*)", text).groups()) for text in look.texts(".chip"))
    verdicts = {verdict["words"]: summary[verdict["id"]] for verdict in look.report()["verdicts"]}
    assert chips == {words: str(count) for words, count in verdicts.items() if count > 0}
    assert len(chips) == 9, "the suite is broken in eight ways"


def test_failures_are_first(look):
    verdicts = look.page.eval_on_selector_all(".card", "(cards) => cards.map((card) => card.dataset.verdict)")
    first_match = verdicts.index("match")
    assert set(verdicts[first_match:]) == {"match"}
    assert len(verdicts[first_match:]) == len(suites.MATCHES)


def test_order_by_name(look):
    look.page.select_option("#sort", "name")
    assert look.names() == sorted(look.names())
    assert look.hash() == "#/?sort=name"


def test_order_by_distance_has_what_cannot_be_compared_first_and_matches_last(look):
    look.page.select_option("#sort", "distance")
    flip = {fixture["name"]: fixture["flip_mean"] for fixture in look.report()["fixtures"]}
    failed = [name for name in look.names() if name not in suites.MATCHES]
    unknown = [name for name in failed if flip[name] is None]
    assert set(unknown) == {suites.MISSING, suites.ORPHAN, suites.WRONG_SIZE, suites.REFUSED}
    assert failed[: len(unknown)] == unknown
    values = [flip[name] for name in failed[len(unknown) :]]
    assert values == sorted(values, reverse=True) and len(values) > 3, values


def test_order_by_time(look):
    look.page.select_option("#sort", "time")
    parts = ("render_ms", "compare_ms", "relate_ms")
    times = {fixture["name"]: sum(fixture[part] for part in parts) for fixture in look.report()["fixtures"]}
    assert look.names() == sorted(times, key=lambda name: (-times[name], name))


def test_filter_by_verdicts(look):
    look.page.click(".chip[data-verdict=stale_golden]")
    assert look.names() == [suites.STALE]
    look.page.click(".chip[data-verdict=wrong_size]")
    assert sorted(look.names()) == sorted([suites.STALE, suites.WRONG_SIZE])
    assert look.text(".found") == "2 fixtures of 14 shown"
    look.page.click(".chip[data-verdict=stale_golden]")
    assert look.names() == [suites.WRONG_SIZE]
    assert look.page.get_attribute(".chip[data-verdict=wrong_size]", "aria-pressed") == "true"


def test_filter_by_area_and_text(look):
    look.page.select_option("#filter-area", label="show (2)")
    assert sorted(look.names()) == sorted([suites.DIFFERS_SLIGHTLY, suites.EXPECTATION])
    look.page.fill("#filter-text", "DEP")
    assert look.names() == [suites.DIFFERS_SLIGHTLY]


def test_a_link_has_the_filters(look, open_page, broken_page):
    look.page.select_option("#filter-area", label="show (2)")
    look.page.fill("#filter-text", "e&=?")
    look.page.fill("#filter-text", "e")
    look.page.select_option("#sort", "name")
    look.page.click(".chip[data-verdict=differs]")
    other = open_page(broken_page).go(look.hash())
    assert other.names() == look.names() == [suites.DIFFERS_SLIGHTLY]
    assert other.page.input_value("#filter-text") == "e"
    assert other.page.input_value("#sort") == "name"
    assert other.page.input_value("#filter-area") == "/show"


@pytest.mark.parametrize("hash", ["#/?sort=toString&verdict=no,such", "#nothing", "#/?area", "#"])
def test_a_link_that_is_none_shows_everything(look, hash):
    look.go(hash)
    expected = 0 if hash == "#/?area" else 14
    assert len(look.names()) == expected


def test_pictures_are_shown_whole(look):
    look.page.wait_for_function("() => document.querySelectorAll('.frame img').length === 14")
    look.page.wait_for_function(
        "() => [...document.querySelectorAll('.frame img')].every((img) => img.complete)"
    )
    for frame in look.page.locator(".frame").all():
        inside, outside = frame.locator("img").bounding_box(), frame.bounding_box()
        for start, size in (("x", "width"), ("y", "height")):
            assert inside[start] >= outside[start] - 0.5
            assert inside[start] + inside[size] <= outside[start] + outside[size] + 0.5


def test_no_result_is_said(look, shoot):
    look.page.fill("#filter-text", "no such name")
    assert look.text(".empty") == "No fixture is as these filters ask."
    shoot(look, "overview-no-result")


def test_a_green_run(open_page, green_page, axe, shoot):
    look = open_page(green_page).go()
    assert look.text("h1") == "All 4 fixtures match"
    axe(look)
    shoot(look, "overview-green")


def test_an_empty_suite_is_said(open_page, empty_page, axe, shoot):
    look = open_page(empty_page).go()
    assert look.text("h1") == "Nothing was judged"
    assert look.text(".empty").startswith("There is no fixture")
    axe(look)
    shoot(look, "overview-empty")


def test_names_are_text(open_page, odd_page):
    look = open_page(odd_page).go()
    assert set(look.names()) == {suites.ODD, suites.LONG, suites.ONE_PIXEL, suites.WIDE, suites.LARGE}
    assert look.page.locator("main b b, .card b").count() == 0
    look.page.click(".card:has(.name:has-text('100 %')) a")
    look.page.wait_for_selector(".viewer")
    assert look.text("h1") == suites.ODD
    assert look.page.title() == f"{suites.ODD} · goldray"


def test_cards_by_keys(look):
    names = look.names()
    look.press("j", "j", "k", "j", "Enter")
    look.page.wait_for_selector(".viewer, .pictures .empty")
    assert look.text("h1") == names[1]
    assert look.page.evaluate("document.activeElement.id") == "main"
    look.press("Escape")
    focused = look.page.evaluate("document.activeElement.closest('.card')?.dataset.name")
    assert focused == names[1], "back where it was left"
    look.press("/")
    assert look.page.evaluate("document.activeElement.id") == "filter-text"


def test_two_thousand_fixtures(open_page, many_page, capsys, shoot):
    look = open_page(many_page)
    began = time.monotonic()
    look.page.goto(look.url)
    look.page.wait_for_function(
        "() => [...document.querySelectorAll('.frame img')].some((img) => img.complete && img.naturalWidth > 0)"
    )
    first_picture = time.monotonic() - began
    megabytes = many_page.stat().st_size / 1e6
    with capsys.disabled():
        print(f"\n{MANY} fixtures, {megabytes:.1f} MB: first picture after {first_picture:.2f} s")
    assert len(look.names()) == MANY
    shown = look.page.locator(".frame img").count()
    assert 0 < shown < MANY / 10, f"{shown} pictures are in the page before they are looked at"
    assert first_picture < 2
    shoot(look, "overview-2000")
    began = time.monotonic()
    look.page.fill("#filter-text", "sphere")
    look.page.wait_for_function("() => document.querySelectorAll('.card').length < 1000")
    assert time.monotonic() - began < 1
    look.page.fill("#filter-text", "")
    look.page.evaluate("scrollTo(0, document.body.scrollHeight)")
    look.page.wait_for_function(
        "() => document.querySelector('.card:last-child .frame img')?.naturalWidth > 0"
    )


def test_failures_first_are_the_worst_first_and_matches_last(look):
    fixtures = {one["name"]: one for one in look.report()["fixtures"]}
    ranks = [fixtures[name]["rank"] for name in look.names()]
    failures = [rank for rank in ranks if rank is not None]
    assert failures == list(range(len(failures))) and len(failures) > 5
    assert ranks[len(failures):] == [None] * (len(ranks) - len(failures)) != []


def test_no_time_is_told_of_what_was_not_rendered(look):
    look.page.select_option("#sort", "time")
    for name in (suites.REFUSED, suites.ORPHAN):
        assert look.text(f".card[data-name='{name}'] .number") == ""
        look.fixture(name)
        assert "rendered in" not in look.text(".fixture-header .line")
        look.press("Escape")
    look.fixture(suites.DIFFERS)
    assert "rendered in" in look.text(".fixture-header .line")


@pytest.mark.parametrize("way", ["key", "back"])
@pytest.mark.parametrize("at", [0.3, 0.9])
def test_the_way_back_leads_to_the_card_where_it_was(open_page, many_page, way, at):
    look = open_page(many_page).go()
    middle = int(MANY * at)
    card = look.page.locator(f".card:nth-child({middle})")
    card.scroll_into_view_if_needed()
    look.page.mouse.wheel(0, 3210)
    look.page.wait_for_timeout(300)
    name = look.page.evaluate("document.elementFromPoint(300, 400).closest('.card')?.dataset.name")

    def top():
        return look.page.evaluate(
            "(name) => document.querySelector(`.card[data-name='${name}']`).getBoundingClientRect().top", name
        )

    for _ in range(3):
        before = top()
        assert 0 < before + 200 < 900
        look.page.click(f".card[data-name='{name}'] a")
        look.page.wait_for_selector(".viewer")
        if way == "key":
            look.press("Escape")
        else:
            look.page.go_back()
        look.page.wait_for_selector(".sheet")
        look.page.wait_for_timeout(300)
        assert top() == pytest.approx(before, abs=2)
