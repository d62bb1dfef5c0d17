"""A page that is looked at: every request, error and warning of it is kept, and must be none."""

import base64
import io
import json
import re
import zlib

import numpy
from PIL import Image


class Look:
    """A report in a browser."""

    def __init__(self, page, url):
        self.page = page
        self.url = url
        self.problems = []
        page.on(
            "console",
            lambda message: message.type in ("error", "warning") and self.problems.append(message.text),
        )
        page.on("pageerror", lambda error: self.problems.append(str(error)))
        page.on("request", lambda request: self.keep_request(request.url))

    def keep_request(self, url):
        """Only the page itself, its own server, and what is in it."""
        own = self.url.split("#")[0]
        if not url.startswith(("data:", "blob:")) and not url.startswith(own):
            self.problems.append(f"asked for {url}")

    def go(self, hash=""):
        self.page.goto(f"{self.url}{hash}")
        self.page.wait_for_selector("main h1")
        return self

    def fixture(self, name, view=None):
        """Opens a fixture by its link, and waits for its pictures."""
        path = self.page.evaluate("(name) => name.split('/').map(encodeURIComponent).join('/')", name)
        self.go(f"#/fixture/{path}{f'?view={view}' if view else ''}")
        self.page.wait_for_selector(".viewer")
        return self

    def texts(self, selector):
        return [text.strip() for text in self.page.locator(selector).all_text_contents()]

    def text(self, selector):
        return self.page.locator(selector).inner_text().strip()

    def names(self):
        """Of the cards, in their order."""
        return self.page.eval_on_selector_all(".card", "(cards) => cards.map((card) => card.dataset.name)")

    def hash(self):
        return self.page.evaluate("location.hash")

    def press(self, *keys):
        for key in keys:
            self.page.keyboard.press(key)

    def slide(self, value):
        """Moves the slider of a view."""
        self.page.locator(".view-controls input[type=range]").fill(str(value))

    def canvas(self, pane=0):
        return self.page.locator(".stage canvas").nth(pane)

    def scale(self):
        return float(self.page.get_attribute(".zoomed", "data-scale"))

    def drawn(self, pane=0):
        """The codes of a pane's canvas, as large as it is on the screen."""
        size, codes = self.page.evaluate(
            """(pane) => {
                const canvas = document.querySelectorAll(".stage canvas")[pane];
                const { width, height } = canvas;
                const context = new OffscreenCanvas(width, height).getContext("2d", { willReadFrequently: true });
                context.drawImage(canvas, 0, 0);
                const { data } = context.getImageData(0, 0, width, height);
                return [[height, width, 4], btoa(Array.from(data, (code) => String.fromCharCode(code)).join(""))];
            }""",
            pane,
        )
        codes = numpy.frombuffer(base64.b64decode(codes), dtype=numpy.uint8)
        return codes.reshape(size)[:, :, :3].astype(int)

    def size(self, pane=0):
        """The width and height of the picture in a pane, in its own pixels."""
        label = self.canvas(pane).get_attribute("aria-label")
        return tuple(map(int, re.search(r"(\d+) by (\d+)", label).groups()))

    def seen(self, pane=0):
        """The codes that a pane shows of each pixel of the whole picture, read in
        each pixel's middle."""
        drawn, scale = self.drawn(pane), self.scale()
        places = [
            numpy.floor(
                numpy.floor(on_screen / 2 - side / 2 * scale + 0.5) + (numpy.arange(side) + 0.5) * scale
            ).astype(int)
            for on_screen, side in zip(drawn.shape[1::-1], self.size(pane), strict=False)
        ]
        return drawn[numpy.ix_(places[1], places[0])]

    def place(self, x, y, pane=0):
        """Where on the screen the middle of a pixel of the whole picture is."""
        box = self.canvas(pane).bounding_box()
        width, height = self.size(pane)
        middle = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
        return middle[0] + (x + 0.5 - width / 2) * self.scale(), middle[1] + (
            y + 0.5 - height / 2
        ) * self.scale()

    def point(self, x, y, pane=0):
        self.canvas(pane).scroll_into_view_if_needed()
        self.page.mouse.move(*self.place(x, y, pane))

    def readout(self, row):
        """The six numbers of a row: three codes, three linear values."""
        return self.texts(f".readout tr[data-row={row}] td")

    def report(self):
        return json.loads(self.page.locator("#report").text_content())

    def evidence(self, name):
        index = [fixture["name"] for fixture in self.report()["fixtures"]].index(name)
        return json.loads(self.page.locator(f"#fixture-{index}").text_content())


def codes_of(base64_png):
    """The codes of a picture in the page: rows of pixels of three."""
    return numpy.array(Image.open(io.BytesIO(base64.b64decode(base64_png))).convert("RGB")).astype(int)


def numbers_of(base64_zlib, kind):
    return numpy.frombuffer(zlib.decompress(base64.b64decode(base64_zlib)), dtype=kind)
