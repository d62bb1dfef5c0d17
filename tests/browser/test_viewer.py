"""The views of a fixture's pictures: what each shows, pixel by pixel, against numpy's own reading."""

import re
import time

import numpy
import pytest
import suites
from looking import codes_of, numbers_of


@pytest.fixture
def temple(open_page, broken_page):
    return open_page(broken_page).fixture(suites.DIFFERS)


def pair(look, name=suites.DIFFERS):
    """The golden and the actual picture of a fixture."""
    evidence = look.evidence(name)
    return codes_of(evidence["golden"]), codes_of(evidence["actual"])


def differences(look, name=suites.DIFFERS):
    golden, actual = pair(look, name)
    return abs(golden - actual)


def pressed(look):
    return look.texts(".views [aria-pressed=true]")


def test_the_pictures_of_the_page_are_those_of_the_files(temple, broken_page):
    golden, actual = pair(temple)
    root = broken_page.parents[2]
    assert (golden == suites.codes(suites.golden_path(root, suites.DIFFERS))).all()
    assert (actual == suites.codes(suites.golden_path(suites.REPOSITORY, suites.DIFFERS))).all()


def test_side_by_side(temple):
    golden, actual = pair(temple)
    assert pressed(temple) == ["Side by side"]
    assert temple.texts("figcaption") == ["Golden", "Actual", "Difference × 4"], "255 / 60 is 4.25"
    assert (temple.seen(0) == golden).all()
    assert (temple.seen(1) == actual).all()
    assert (temple.seen(2) == 4 * abs(golden - actual)).all()


def test_single_pictures(temple):
    golden, actual = pair(temple)
    temple.press("g")
    assert (temple.seen() == golden).all()
    temple.press("p")
    assert (temple.seen() == actual).all()


@pytest.mark.parametrize("gain", [1, 4, 5, 100])
def test_difference_is_amplified(temple, gain):
    temple.press("4")
    temple.slide(gain)
    expected = (gain * differences(temple)).clip(0, 255)
    assert (temple.seen() == expected).all()
    assert temple.text(".controls output") == f"× {gain}"


@pytest.mark.parametrize("threshold", [0, 1, 3, 4, 19, 20, 59, 60, 255])
def test_threshold_marks_and_counts(temple, threshold):
    temple.press("7")
    temple.slide(threshold)
    over = differences(temple).max(axis=2) > threshold
    assert temple.text(".controls output").startswith(f"> {threshold}: {over.sum():,} pixel")
    marked = (temple.seen() == (255, 64, 48)).all(axis=2)
    assert (marked == over).all()


def test_single_marks_are_seen_in_a_picture_larger_than_the_screen(open_page, odd_page):
    look = open_page(odd_page, width=360).fixture(suites.LARGE, "threshold")
    scale = look.scale()
    assert scale < 0.25 and look.text(".controls output").startswith("> 0: 2 pixels ")
    red, green, _ = numpy.moveaxis(look.drawn(), 2, 0)
    rows, columns = numpy.nonzero(red - green > 60)
    left, right = columns < columns.mean(), columns > columns.mean()
    assert left.any() and right.any(), "both are seen"
    assert numpy.ptp(rows[left]) <= 2 and numpy.ptp(columns[left]) <= 2, "as a point"
    assert numpy.ptp(rows[right]) <= 2 and numpy.ptp(columns[right]) <= 2, (
        "that does not go on in the next row"
    )
    look.slide(9)
    red, green, _ = numpy.moveaxis(look.drawn(), 2, 0)
    assert not (red - green > 60).any()


def test_the_threshold_agrees_with_the_report(temple):
    fixture = next(one for one in temple.report()["fixtures"] if one["name"] == suites.DIFFERS)
    temple.press("7")
    for threshold, count in {"0": fixture["differing_pixels"], **fixture["pixels_over"]}.items():
        temple.slide(threshold)
        assert temple.text(".controls output").split()[2] == f"{count:,}"


@pytest.mark.parametrize("view, key, worst", [("ssim", "5", 0), ("flip", "6", 255)])
def test_maps_are_brighter_where_it_is_worse(temple, view, key, worst):
    temple.press(key)
    assert temple.page.locator(".legend").inner_text().strip() != ""
    codes = codes_of(temple.evidence(suites.DIFFERS)[view])[:, :, 0]
    badness = abs(255 - worst - codes)
    light = (temple.seen() * (0.2126, 0.7152, 0.0722)).sum(axis=2)
    by_badness = [light[badness == value] for value in numpy.unique(badness)]
    assert all(numpy.ptp(same) == 0 for same in by_badness), "a value has a color"
    means = [same.mean() for same in by_badness]
    assert len(means) > 50 and all(low <= high + 1 for low, high in zip(means, means[1:], strict=False))
    assert (temple.seen()[badness == 0] == (0, 0, 4)).all()


def test_objects_are_told_apart_and_named(temple):
    evidence = temple.evidence(suites.DIFFERS)
    golden, _ = pair(temple)
    numbers = numbers_of(evidence["objects"]["numbers"], "<u4").reshape(golden.shape[:2])
    temple.press("8")
    box = numbers[40, 70]
    place = evidence["objects"]["places"][box - 1]
    temple.point(70, 40)
    assert temple.text(".readout .place") == f"x 70, y 40 · {place['kind']}, line {place['line']}"
    sky = tuple(map(int, numpy.argwhere(numbers == 0)[0][::-1]))
    temple.point(*sky)
    assert temple.text(".readout .place").endswith("· background")
    shares = [share for share in temple.texts(".objects strong")]
    blamed = [one for one in temple.report()["fixtures"] if one["name"] == suites.DIFFERS][0]["blamed"]
    assert len(shares) == len([one for one in blamed if one["line"] is not None])
    first = temple.texts(".objects button")[0]
    assert first.startswith(f"{blamed[0]['kind']}, line {blamed[0]['line']}")
    temple.page.mouse.move(0, 0)
    temple.page.mouse.move(5, 5)
    before = temple.seen()
    temple.page.hover(".objects li:nth-child(2) button")
    changed = (temple.seen() != before).any(axis=2)
    second = blamed[1]["object"] + 1
    assert not changed[numbers == second].any() and not changed[numbers == 0].any()
    assert changed[(numbers != second) & (numbers != 0)].mean() > 0.99, "the others fade"


def test_blink_by_space(temple):
    golden, actual = pair(temple)
    temple.press("2")
    shown = []
    for _ in range(3):
        shown.append(
            (temple.text("figcaption"), (temple.seen() == golden).all(), (temple.seen() == actual).all())
        )
        temple.press(" ")
    assert shown == [("Golden", True, False), ("Actual", False, True), ("Golden", True, False)]


def test_blink_by_space_after_a_click(temple):
    temple.page.click("[data-view=blink]")
    temple.press(" ")
    assert temple.text("figcaption") == "Actual"


def count_of_flips(look, seconds):
    return look.page.evaluate(
        """(ms) => new Promise((resolve) => {
            let flips = 0;
            const observer = new MutationObserver(() => flips++);
            observer.observe(document.querySelector("figcaption"), { childList: true, characterData: true, subtree: true });
            setTimeout(() => resolve(flips), ms);
        })""",
        1000 * seconds,
    )


def test_blink_by_itself_is_twice_a_second(open_page, broken_page):
    look = open_page(broken_page, motion="no-preference").fixture(suites.DIFFERS, "blink")
    assert count_of_flips(look, 3) in (5, 6, 7)
    look.press(" ")
    assert count_of_flips(look, 1) == 0, "by hand it is still"
    look.page.check(".controls input")
    assert count_of_flips(look, 2) in (3, 4, 5)
    look.press("4")
    time.sleep(0.6)
    assert look.texts("figcaption") == ["Difference"]


def test_blink_is_still_where_motion_is_not_wanted(open_page, broken_page):
    look = open_page(broken_page, motion="reduce").fixture(suites.DIFFERS, "blink")
    assert count_of_flips(look, 1.2) == 0


def test_swipe_by_keys_and_by_pointer(temple):
    golden, actual = pair(temple)
    temple.press("3")
    handle = temple.page.get_by_role("slider", name="Golden up to here")
    handle.focus()
    temple.press("Home")
    assert handle.get_attribute("aria-valuenow") == "0" and (temple.seen() == actual).all()
    temple.press("End")
    assert handle.get_attribute("aria-valuenow") == "100" and (temple.seen() == golden).all()
    temple.press("ArrowLeft", "Shift+ArrowLeft", "PageDown", "ArrowRight")
    assert handle.get_attribute("aria-valuenow") == "80"
    x, y = temple.place(76, 40)
    box = handle.bounding_box()
    temple.page.mouse.move(box["x"] + box["width"] / 2, y)
    temple.page.mouse.down()
    temple.page.mouse.move(x, y, steps=4)
    temple.page.mouse.up()
    seen = temple.seen()
    assert (seen[:, :75] == golden[:, :75]).all() and (seen[:, 78:] == actual[:, 78:]).all()
    assert not (golden[34:52, 78:92] == actual[34:52, 78:92]).all(), "the line is across what differs"


def test_the_numbers_of_a_pixel(temple):
    golden, actual = pair(temple)
    linear = numbers_of(temple.evidence(suites.DIFFERS)["linear"], "<f4").reshape(golden.shape)
    for x, y in [(5, 3), (0, 0), (159, 119), (70, 40), (90, 100)]:
        temple.point(x, y)
        assert temple.text(".readout .place").startswith(f"x {x}, y {y}")
        assert temple.readout("golden")[:3] == [str(code) for code in golden[y, x]]
        assert temple.readout("actual")[:3] == [str(code) for code in actual[y, x]]
        signs = [f"{code:+d}".replace("-", "−") if code else "0" for code in actual[y, x] - golden[y, x]]
        assert temple.readout("difference")[:3] == signs
        told = [numpy.float32(value) for value in temple.readout("actual")[3:]]
        assert told == list(linear[y, x]), "exactly"
        codes = [int(255 * min(max(float(value), 0), 1) ** (1 / 2.2) + 0.5) for value in told]
        assert codes == list(actual[y, x]), "linear values are of this very picture"
        for value, code in zip(temple.readout("golden")[3:], golden[y, x], strict=False):
            assert value.startswith("≈ ")
            assert float(value[2:]) == pytest.approx((code / 255) ** 2.2, rel=5e-3)


def test_codes_are_those_of_the_file_whatever_it_says_of_color(open_page, odd_page):
    """The golden has every code, and a chunk that says they are linear light."""
    root = odd_page.parents[2]
    expected = suites.codes(suites.golden_path(root, suites.WIDE))
    assert b"gAMA" in suites.golden_path(root, suites.WIDE).read_bytes()
    assert len(numpy.unique(expected)) == 256
    look = open_page(odd_page, width=1400).fixture(suites.WIDE, "golden")
    look.canvas().focus()
    told = set()
    for _ in range(100):
        look.press("ArrowRight", "Shift+ArrowRight", "ArrowDown")
        x, y = map(int, re.findall(r"\d+", look.text(".readout .place"))[:2])
        assert look.readout("golden")[:3] == [str(code) for code in expected[y, x]]
        told.update(expected[y, x])
    assert len(told) > 100, "of 256 codes, many are looked at"


def test_a_code_of_srgb_is_decoded_by_its_own_curve(open_page, broken_page):
    look = open_page(broken_page).fixture("encoding/srgb-ramp")
    golden = codes_of(look.evidence("encoding/srgb-ramp")["golden"])

    def decode(f):
        return f / 12.92 if f <= 0.04045 else ((f + 0.055) / 1.055) ** 2.4

    for x, y in [(2, 20), (10, 20), (30, 2), (60, 30)]:
        look.point(x, y)
        for row in ("golden", "actual"):
            values = [float(value.removeprefix("≈ ")) for value in look.readout(row)[3:]]
            assert values == pytest.approx([decode(code / 255) for code in golden[y, x]], rel=5e-3)


@pytest.mark.parametrize("x, y", [(76, 39), (20, 100), (150, 10)])
def test_zoom_by_wheel_keeps_what_is_under_the_pointer(temple, x, y):
    temple.point(x, y)
    for _ in range(8):
        temple.page.mouse.wheel(0, -100)
        assert temple.text(".readout .place").startswith(f"x {x}, y {y}")
    scale = temple.scale()
    assert scale > 8
    temple.page.mouse.wheel(0, 1000)
    assert temple.scale() < scale


def test_zoom_by_keys_buttons_and_double_click(temple):
    fitted = temple.scale()
    temple.press("+", "+")
    assert temple.scale() > fitted
    temple.press("-")
    temple.press("0")
    assert temple.scale() == fitted
    temple.page.click("[aria-label=Larger]")
    assert temple.scale() > fitted
    temple.page.click("text=Fit")
    assert temple.scale() == fitted
    temple.canvas(1).scroll_into_view_if_needed()
    temple.page.mouse.dblclick(*temple.place(20, 20, 1))
    assert temple.scale() == 16
    temple.canvas(1).dblclick()
    assert temple.scale() == fitted


def test_single_pixels_are_crisp_with_a_grid(temple):
    golden, _ = pair(temple)
    temple.page.click("text=First differing")
    assert temple.scale() == 16
    shown = temple.drawn(0)
    middle = shown.shape[0] // 2, shown.shape[1] // 2
    inner = shown[middle[0] - 4 : middle[0] + 4, middle[1] + 16 - 4 : middle[1] + 16 + 4]
    assert (inner == golden[3, 6]).all(), "the next pixel is one color"
    row = shown[middle[0], :].astype(int)
    edges = numpy.flatnonzero((abs(numpy.diff(row, axis=0)).max(axis=1)) > 0)
    assert len(edges) > 10, "lines part pixels of one color"


def test_panes_move_together(temple):
    temple.page.click("text=Worst FLIP")
    before = [temple.drawn(pane) for pane in range(3)]
    box = temple.canvas(0).bounding_box()
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    temple.page.mouse.move(x, y)
    temple.page.mouse.down()
    temple.page.mouse.move(x + 64, y + 32, steps=5)
    temple.page.mouse.up()
    for pane in range(3):
        after = temple.drawn(pane)
        assert (after[60:150, 90:200] == before[pane][28:118, 26:136]).mean() > 0.99, f"pane {pane}"


@pytest.mark.parametrize(
    "words, key",
    [("Worst window", "ssim_min_at"), ("Worst FLIP", "flip_max_at"), ("First differing", "first_differing")],
)
def test_jumps(temple, words, key):
    at = next(one for one in temple.report()["fixtures"] if one["name"] == suites.DIFFERS)[key]
    temple.page.click(f"text={words}")
    assert temple.text(".readout .place").startswith(f"x {at[0]}, y {at[1]}")
    assert temple.scale() == 16


def test_the_cursor_goes_by_arrows_and_is_heard(temple):
    golden, actual = pair(temple)
    temple.page.click("text=First differing")
    temple.canvas().focus()
    temple.press("ArrowRight", "ArrowDown", "Shift+ArrowDown")
    x, y = suites.PIXEL[1] + 1, suites.PIXEL[0] + 11
    assert temple.text(".readout .place").startswith(f"x {x}, y {y}")
    told = temple.page.text_content("#spoken")

    def words(codes):
        return " ".join(map(str, codes))

    assert told.startswith(
        f"x {x}, y {y}, golden {words(golden[y, x])}, actual {words(actual[y, x])}, difference 0 0 0"
    )
    temple.press(*["Shift+ArrowLeft"] * 3, *["Shift+ArrowUp"] * 3)
    assert temple.text(".readout .place").startswith("x 0, y 0"), "it stays inside"
    assert temple.hash().startswith(f"#/fixture/{suites.DIFFERS}"), (
        "arrows on a picture are not those of the page"
    )


@pytest.mark.parametrize(
    "name, disabled, reason",
    [
        (
            suites.WRONG_SIZE,
            ["difference", "ssim", "flip", "threshold"],
            "the golden has 90 × 50 pixels, the picture 96 × 72",
        ),
        (
            suites.MISSING,
            ["sides", "blink", "swipe", "difference", "ssim", "flip", "threshold", "golden"],
            "there is no golden",
        ),
        (
            suites.REFUSED,
            ["sides", "blink", "swipe", "difference", "ssim", "flip", "threshold", "objects", "actual"],
            "there is no picture of this run",
        ),
        (
            suites.ORPHAN,
            ["sides", "blink", "swipe", "difference", "ssim", "flip", "threshold", "objects", "actual"],
            "there is no picture of this run",
        ),
        (
            suites.EXPECTATION,
            ["sides", "blink", "swipe", "difference", "ssim", "flip", "threshold"],
            "the picture is the golden, byte for byte",
        ),
        (
            suites.MATCHES[0],
            ["sides", "blink", "swipe", "difference", "ssim", "flip", "threshold", "objects"],
            "the picture is the golden, byte for byte",
        ),
    ],
)
def test_views_without_data_say_why(open_page, broken_page, name, disabled, reason):
    look = open_page(broken_page).fixture(name)
    found = look.page.eval_on_selector_all(
        ".views [aria-disabled]", "(all) => all.map((one) => one.dataset.view)"
    )
    assert found == disabled
    assert reason in look.text(".viewer .note")
    for view in disabled:
        assert len(look.page.get_attribute(f"[data-view={view}]", "title")) > len("Not here: ")
    shown = pressed(look)
    look.page.click(f"[data-view={disabled[0]}]", force=True)
    assert pressed(look) == shown and "is not here" in look.text(".viewer .note")


def test_a_match_shows_the_golden_as_its_picture(open_page, broken_page):
    look = open_page(broken_page).fixture("scene/balls-on-floor")
    golden = codes_of(look.evidence("scene/balls-on-floor")["golden"])
    assert pressed(look) == ["Actual"]
    assert (look.seen() == golden).all()


@pytest.mark.parametrize("name, size", [(suites.ONE_PIXEL, (1, 1)), (suites.WIDE, (4096, 16))])
def test_odd_sizes_are_shown_in_every_view(open_page, odd_page, name, size):
    look = open_page(odd_page).fixture(name)
    evidence = look.evidence(name)
    assert codes_of(evidence["actual"]).shape[1::-1] == size
    for key in "12345678gp":
        look.press(key)
        box = look.canvas().bounding_box()
        assert box["width"] > 100 and box["height"] > 50
    look.canvas().focus()
    look.press("ArrowRight", "+", "+", "0")
    assert "x " in look.text(".readout .place")


def test_the_view_is_in_the_link_and_goes_on_to_the_next_fixture(temple, open_page, broken_page):
    temple.press("6")
    assert temple.hash() == f"#/fixture/{suites.DIFFERS}?view=flip"
    other = open_page(broken_page).go(temple.hash())
    other.page.wait_for_selector(".viewer")
    assert pressed(other) == ["FLIP"]
    order = open_page(broken_page).go().names()
    following = order[order.index(suites.DIFFERS) + 1]
    temple.press("j")
    temple.page.wait_for_function(
        "(name) => document.querySelector('h1').textContent === name && document.querySelector('.viewer')",
        arg=following,
    )
    assert pressed(temple) == ["FLIP"]


def test_a_click_keeps_a_pixel_and_a_drag_does_not(temple):
    temple.point(70, 40)
    temple.page.mouse.down()
    temple.page.mouse.up()
    temple.page.mouse.move(1, 1)
    assert temple.text(".readout .place").startswith("x 70, y 40")
    temple.point(20, 20)
    temple.page.mouse.down()
    temple.page.mouse.move(100, 300, steps=3)
    temple.page.mouse.up()
    temple.page.mouse.move(1, 1)
    assert temple.text(".readout .place").startswith("x 70, y 40")


def test_two_fingers_pinch(open_page, broken_page):
    look = open_page(broken_page, touch=True).fixture(suites.DIFFERS, "golden")
    fitted = look.scale()
    x, y = look.place(80, 60)
    session = look.page.context.new_cdp_session(look.page)

    def touch(kind, *points):
        places = [{"x": px, "y": py, "id": i} for i, (px, py) in enumerate(points)]
        session.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": places})

    touch("touchStart", (x - 20, y), (x + 20, y))
    for step in range(1, 11):
        touch("touchMove", (x - 20 - 4 * step, y), (x + 20 + 4 * step, y))
    touch("touchEnd")
    assert look.scale() == pytest.approx(3 * fitted, rel=0.1)
    look.page.mouse.move(x, y)
    assert look.text(".readout .place").startswith(
        ("x 80, y 60", "x 79, y 60", "x 80, y 59", "x 79, y 59")
    ), "it stays between them"


def scroll_of(look):
    look.page.wait_for_timeout(300)
    return look.page.evaluate("scrollY")


def test_the_wheel_stops_at_the_whole_picture_and_then_scrolls_the_page(temple):
    temple.point(20, 20)
    fitted = temple.scale()
    temple.page.mouse.wheel(0, -300)
    temple.page.wait_for_function(
        "(scale) => Number(document.querySelector('.zoomed').dataset.scale) > scale", arg=fitted
    )
    at = scroll_of(temple)
    temple.page.mouse.wheel(0, 900)
    assert scroll_of(temple) == at and temple.scale() == fitted
    assert temple.page.locator(".stage.is-fitted").count() == 1
    temple.page.mouse.wheel(0, 120)
    assert scroll_of(temple) > at and temple.scale() == fitted


@pytest.mark.parametrize("name, first, last", [("ssim", "1 alike", "0 and below: nothing alike")])
def test_a_legend_says_its_ends(temple, name, first, last):
    temple.page.click(f"[data-view={name}]")
    words = temple.text(".legend")
    assert words.startswith(first) and words.endswith(last)


def test_every_object_of_the_legend_is_seen(temple):
    temple.press("8")
    legend = temple.page.locator(".objects")
    assert temple.page.locator(".objects li").count() > 10
    assert legend.evaluate("(list) => list.scrollHeight <= list.clientHeight")


def test_keys_and_buttons_zoom_about_the_pixel_that_is_kept(temple):
    temple.press("p")
    temple.point(30, 90)
    temple.page.mouse.down()
    temple.page.mouse.up()
    temple.page.mouse.move(1, 1)
    box = temple.canvas().bounding_box()
    x, y = temple.place(30, 90)
    temple.press("+", "+", "+", "+")
    temple.page.click("[aria-label=Larger]")
    assert temple.scale() >= 16
    temple.page.mouse.move(x, y)
    assert temple.text(".readout .place").startswith("x 30, y 90"), "it stays where it is"
    temple.page.mouse.move(box["x"] + 10, box["y"] + box["height"] / 2)
    temple.page.mouse.down()
    temple.page.mouse.move(box["x"] + box["width"] - 10, box["y"] + box["height"] / 2, steps=3)
    temple.page.mouse.up()
    temple.press("+")
    left = temple.page.evaluate("document.querySelector('.readout .place').textContent")
    assert left  # out of view it is brought back, and only then made larger
    drawn = temple.drawn()
    assert (drawn == (255, 255, 255)).all(axis=2).any(), "its frame is seen"
