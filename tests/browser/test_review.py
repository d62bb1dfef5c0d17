"""A review in a browser: what is decided there is done to the files, and can be taken back."""

import os
import re
import signal
import subprocess
import time

import pytest
import suites


class Server:
    """A review or a watch that runs for the time of a test."""

    def __init__(self, goldray, verb, root):
        self.root = root
        self.process = subprocess.Popen(
            [goldray.program, "--root", root, verb],
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            text=True,
            env={"PATH": os.environ["PATH"]},
        )
        self.url = self.find_url()

    def find_url(self):
        for line in self.process.stdout:
            found = re.search(r"http://\S+", line)
            if found:
                return found[0]
        raise AssertionError("no address was printed")

    def stop(self):
        if self.process.poll() is None:
            self.process.send_signal(signal.SIGINT)
        return self.process.communicate(timeout=20)[0]


@pytest.fixture
def serve(tmp_path, goldray):
    """Starts a verb on a broken suite of its own."""
    servers = []

    def serve(verb):
        suites.broken(tmp_path / "suite")
        servers.append(Server(goldray, verb, tmp_path / "suite"))
        return servers[-1]

    yield serve
    for server in servers:
        server.stop()


@pytest.fixture
def review(serve, open_page):
    """The page of a review, on the overview."""
    server = serve("review")
    look = open_page(server.url).go()
    look.server = server
    look.page.wait_for_function("() => document.querySelector('#progress').textContent !== ''")
    return look


def goldens(root):
    """Every golden with its bytes."""
    return {
        str(path.relative_to(root / "golden"))[:-4]: path.read_bytes()
        for path in (root / "golden").rglob("*.png")
    }


def changed(before, after):
    return {name for name in before.keys() | after.keys() if before.get(name) != after.get(name)}


def wait_for_decision(look, name, decision):
    card = f".card[data-name='{name}'] .decision, .fixture-header .decision"
    look.page.wait_for_function(
        "([card, decision]) => document.querySelector(card)?.textContent === decision", arg=[card, decision]
    )


def progress(look, words):
    look.page.wait_for_function(
        "(words) => document.querySelector('#progress').textContent === words", arg=words
    )


def test_accept_writes_one_golden_and_undo_brings_its_bytes_back(review, axe, shoot):
    root = review.server.root
    before = goldens(root)
    review.fixture(suites.DIFFERS)
    review.page.wait_for_selector(".accept:enabled")
    axe(review)
    review.page.click(".accept")
    wait_for_decision(review, suites.DIFFERS, "accepted")
    progress(review, "1 of 10 decided")
    after = goldens(root)
    assert changed(before, after) == {suites.DIFFERS}
    expected = suites.codes(suites.golden_path(suites.REPOSITORY, suites.DIFFERS))
    assert (suites.codes(suites.golden_path(root, suites.DIFFERS)) == expected).all()
    assert review.page.locator(".accept").is_disabled()
    axe(review)
    shoot(review, "review-accepted")
    review.page.click(".undo")
    wait_for_decision(review, suites.DIFFERS, "")
    assert goldens(root) == before
    progress(review, "0 of 10 decided")


def test_a_golden_that_was_missing_is_missing_again_after_undo(review):
    root = review.server.root
    before = goldens(root)
    review.fixture(suites.MISSING)
    review.page.wait_for_selector(".accept:enabled")
    review.press("a")
    wait_for_decision(review, suites.MISSING, "accepted")
    assert changed(before, goldens(root)) == {suites.MISSING}
    review.press("u")
    wait_for_decision(review, suites.MISSING, "")
    assert goldens(root) == before


def test_an_orphan_is_accepted_by_removing_it(review):
    root = review.server.root
    before = goldens(root)
    review.fixture(suites.ORPHAN)
    review.page.wait_for_selector(".accept:enabled")
    review.press("a")
    review.page.wait_for_selector("#confirm[open]")
    assert review.text("#confirm h2") == f"Remove 1 golden without a fixture: {suites.ORPHAN}?"
    review.press("Enter")
    wait_for_decision(review, suites.ORPHAN, "accepted")
    assert goldens(root).keys() == before.keys() - {suites.ORPHAN}
    review.press("u")
    wait_for_decision(review, suites.ORPHAN, "")
    assert goldens(root) == before


def test_reject_writes_nothing_and_holds_over_a_reload(review):
    before = goldens(review.server.root)
    review.fixture(suites.STALE)
    review.page.wait_for_selector(".reject:enabled")
    review.press("r")
    wait_for_decision(review, suites.STALE, "rejected")
    review.page.reload()
    wait_for_decision(review, suites.STALE, "rejected")
    assert goldens(review.server.root) == before
    review.press("Escape")
    wait_for_decision(review, suites.STALE, "rejected")


def test_what_breaks_its_word_cannot_be_accepted_and_is_told_why(review, axe):
    before = goldens(review.server.root)
    review.fixture(suites.EXPECTATION)
    review.page.wait_for_selector(".reject:enabled")
    assert review.page.locator(".accept").is_disabled()
    review.press("a")
    review.page.wait_for_selector("#messages li")
    assert suites.EXPECTATION in review.text("#messages")
    axe(review)
    review.page.click("[aria-label='Close messages']")
    assert review.page.locator("#messages li").count() == 0
    assert goldens(review.server.root) == before


def test_what_moved_is_not_accepted_and_says_so(review):
    root = review.server.root
    suites.edit(root, suites.DIFFERS_SLIGHTLY, "radius: 1,", "radius: 0.9,")
    before = goldens(root)
    review.fixture(suites.DIFFERS_SLIGHTLY)
    review.page.wait_for_selector(".accept:enabled")
    review.press("a")
    review.page.wait_for_selector("#messages li")
    assert suites.DIFFERS_SLIGHTLY in review.text("#messages")
    assert goldens(root) == before


@pytest.mark.parametrize("colors", ["light", "dark"])
def test_a_selection_is_decided_at_once(serve, open_page, axe, shoot, colors):
    server = serve("review")
    look = open_page(server.url, colors=colors).go()
    before = goldens(server.root)
    look.page.wait_for_function("() => document.querySelector('#progress').textContent !== ''")
    chosen = [suites.DIFFERS, suites.DIFFERS_SLIGHTLY, suites.EXPECTATION]
    for name in chosen:
        look.page.check(f".card[data-name='{name}'] input")
    assert look.text(".batch .words") == "3 selected"
    axe(look)
    shoot(look, f"review-selection-{colors}")
    look.page.click(".batch .accept")
    look.page.wait_for_selector("#confirm[open]")
    axe(look)
    shoot(look, f"review-question-{colors}")
    look.press("Enter")
    progress(look, "2 of 10 decided")
    assert look.text("#messages p") == "2 accepted, 1 not:"
    assert look.texts("#messages li")[0].startswith(f"{suites.EXPECTATION} is not accepted: ")
    assert look.page.text_content("#spoken").startswith(f"2 accepted, 1 not: {suites.EXPECTATION} is not")
    axe(look)
    assert changed(before, goldens(server.root)) == {suites.DIFFERS, suites.DIFFERS_SLIGHTLY}
    look.page.click("text=Select none")
    assert look.text(".batch .words") == "0 selected"
    assert look.page.locator(".batch .undo").is_disabled()
    look.page.click("text=Select all shown")
    assert look.text(".batch .words") == "10 selected"
    look.page.click(".batch .undo")
    progress(look, "0 of 10 decided")
    assert look.text("#messages").startswith("2 undone.")
    assert goldens(server.root) == before


def test_many_are_not_accepted_without_a_word(review):
    before = goldens(review.server.root)
    review.page.click("text=Select all shown")
    review.page.focus(".batch .accept")
    review.press("a")
    review.page.wait_for_selector("#confirm[open]")
    assert review.text("#confirm h2") == "Accept 7 pictures as goldens?"
    assert review.text("#confirm p").startswith(f"1 golden without a fixture is removed: {suites.ORPHAN}.")
    assert review.page.evaluate("document.activeElement.textContent") == "Accept"
    review.press("a", "r", "u", "Escape")
    assert not review.page.locator("#confirm").is_visible()
    assert review.page.evaluate("document.activeElement.dataset.action") == "accept", "the focus is back"
    review.page.click(".batch .accept")
    review.page.click("#confirm button:has-text('Cancel')")
    review.page.wait_for_timeout(300)
    assert goldens(review.server.root) == before
    assert review.text("#progress") == "0 of 10 decided"


def test_what_is_accepted_can_be_rejected_and_the_other_way(review):
    root = review.server.root
    before = goldens(root)
    review.fixture(suites.DIFFERS)
    review.page.wait_for_selector(".accept:enabled")
    assert any(" bless " in command for command in review.texts(".command:visible code"))
    review.press("a")
    wait_for_decision(review, suites.DIFFERS, "accepted")
    assert not any(" bless " in command for command in review.texts(".command:visible code"))
    assert goldens(root) != before
    review.page.click(".reject")
    wait_for_decision(review, suites.DIFFERS, "rejected")
    assert goldens(root) == before
    assert review.page.locator(".reject").is_disabled()
    assert not any(" bless " in command for command in review.texts(".command:visible code"))
    review.page.click(".accept")
    wait_for_decision(review, suites.DIFFERS, "accepted")
    review.press("r")
    wait_for_decision(review, suites.DIFFERS, "rejected")
    assert goldens(root) == before
    review.press("u")
    wait_for_decision(review, suites.DIFFERS, "")
    assert any(" bless " in command for command in review.texts(".command:visible code"))


def test_the_header_of_a_review_on_a_phone_is_two_rows(serve, open_page):
    look = open_page(serve("review").url, width=360, height=740).go()
    look.page.wait_for_function("() => document.querySelector('#progress').textContent !== ''")
    tops = [
        look.page.locator(one).bounding_box()["y"] for one in (".brand", "#theme", "#show-keys", "#progress")
    ]
    assert round(tops[0]) == round(tops[1]) == round(tops[2]) < tops[3]
    assert look.page.locator(".bar").bounding_box()["height"] < 80
    assert look.page.locator(".batch").bounding_box()["height"] < 90


def test_cards_are_selected_and_decided_by_keys(review):
    names = review.names()
    review.press("j", "x", "j", "j", "x")
    assert review.text(".batch .words") == "2 selected"
    review.press("r")
    progress(review, "2 of 10 decided")
    for name in (names[0], names[2]):
        wait_for_decision(review, name, "rejected")


def test_another_tab_hears_of_it(review, open_page):
    other = open_page(review.server.url).go()
    other.page.wait_for_function("() => document.querySelector('#progress').textContent !== ''")
    review.fixture(suites.DIFFERS)
    review.page.wait_for_selector(".reject:enabled")
    review.press("r")
    wait_for_decision(other, suites.DIFFERS, "rejected")
    progress(other, "1 of 10 decided")


def test_keys_decide_nothing_where_there_is_nothing(review):
    before = goldens(review.server.root)
    review.press("a", "u")
    review.go("#/fixture/no/such")
    review.press("a", "r", "x", "j")
    assert review.text("h1") == "No such fixture"
    assert goldens(review.server.root) == before


def test_the_keys_of_a_review_are_listed(review):
    review.press("?")
    assert "accept" in review.text("#keys") and "reject" in review.text("#keys")


def test_a_server_that_stops_is_noticed(review, axe):
    assert not review.page.locator("#lost").is_visible()
    said = review.server.stop()
    review.page.wait_for_selector("#lost:visible")
    assert review.text("#lost").startswith("The server has stopped")
    axe(review)
    review.problems.clear()  # The browser says that the stream is gone, as it should.
    assert "left" in said


def test_a_watch_comes_back_to_the_same_place(serve, open_page):
    server = serve("watch")
    look = open_page(server.url).fixture(suites.DIFFERS, "flip")
    look.page.click("text=Worst FLIP")
    where = look.text(".readout .place"), look.scale()
    look.page.evaluate("window.isOld = true")
    suites.edit(server.root, suites.STALE, "samples_per_pixel: 16", "samples_per_pixel: 4")
    look.page.wait_for_function("() => !window.isOld && document.querySelector('.viewer')", timeout=20_000)
    look.page.wait_for_function("() => document.querySelector('.readout .place').textContent.startsWith('x')")
    assert look.texts(".views [aria-pressed=true]") == ["FLIP"]
    time.sleep(0.2)
    assert (look.text(".readout .place"), look.scale()) == where
