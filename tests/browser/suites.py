"""Suites for the browser to look at: fixtures of the repository, copied and broken on purpose."""

import re
import shutil
import struct
import subprocess
from pathlib import Path

import numpy
from PIL import Image, PngImagePlugin

REPOSITORY = Path(__file__).resolve().parents[2]

# What each fixture of the broken suite is broken by.
DIFFERS = "scene/temple"
DIFFERS_SLIGHTLY = "show/depth"
LIMITED = "sphere/facing"
STALE = "camera/roll"
MISSING = "box/inside"
TAMPERED = "light/two-colors"
ORPHAN = "disk/gone for good"
WRONG_SIZE = "cone/oblique"
REFUSED = "torus/annulus"
EXPECTATION = "show/silhouette"
UNREADABLE = "sphere/tangent"
MATCHES = ["encoding/srgb-ramp", "mesh/knot-flat", "scene/balls-on-floor", "sphere/tangent"]

# A name as bad as a file system allows, and one as long.
ODD = """odd/it's "100 %" <b>&amp;ünï #1?"""
LONG = "odd/" + "averylongnamewithoutabreak" * 8
ONE_PIXEL = "odd/one-pixel"
WIDE = "odd/wide"
LARGE = "odd/large"

# Where the golden of DIFFERS is changed, rows by columns: a patch by much, a
# band by little, a pixel by one code, and one in blue alone.
PATCH = (slice(34, 52), slice(60, 92))
BAND = (slice(96, 104), slice(20, 140))
PIXEL = (3, 5)
BLUE_PIXEL = (110, 7)

# In a picture larger than a screen.
LAST_OF_A_ROW = (700, 1599)


class Goldray:
    """The program under test."""

    def __init__(self, program):
        self.program = program

    def run(self, root, *arguments, expected=0):
        """Runs a verb on a suite; its exit code must be the expected one."""
        command = [self.program, "--root", root, *arguments]
        ran = subprocess.run(command, capture_output=True, text=True, env={"PATH": "/usr/bin:/bin"})
        said = ran.stdout + ran.stderr
        assert ran.returncode == expected, (
            f"{arguments}: exit code {ran.returncode}, expected {expected}\n{said}"
        )
        return said

    def check(self, root, *arguments, expected=1):
        """Checks a suite; the page that was written."""
        self.run(root, "check", *arguments, expected=expected)
        return root / "target/goldray/report.html"


def copy(root, *names):
    """Copies fixtures with their goldens and the meshes they name."""
    for name in names:
        duplicate(root, name, name)
        for mesh in re.findall(r'file: "([^"]+)"', text_of(root, name)):
            place(
                REPOSITORY / "fixtures" / Path(name).parent / mesh,
                root / "fixtures" / Path(name).parent / mesh,
            )


def duplicate(root, name, other):
    """Copies a fixture with its golden to another name."""
    place(REPOSITORY / f"fixtures/{name}.ron", root / f"fixtures/{other}.ron")
    place(golden_path(REPOSITORY, name), golden_path(root, other))


def place(source, target):
    target.parent.mkdir(parents=True, exist_ok=True)
    shutil.copy(source, target)


def golden_path(root, name):
    return root / f"golden/{name}.png"


def text_of(root, name):
    return (root / f"fixtures/{name}.ron").read_text()


def edit(root, name, old, new):
    text = text_of(root, name)
    assert old in text, f"{name} does not say {old!r}"
    (root / f"fixtures/{name}.ron").write_text(text.replace(old, new, 1))


def write(root, name, text):
    path = root / f"fixtures/{name}.ron"
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text)


def codes(png):
    """The codes of a PNG file: rows of pixels of three."""
    return numpy.array(Image.open(png).convert("RGB"))


def change_golden(root, name, change, keeps_note=False):
    """Rewrites a golden's picture. Its note says for which scene and picture it
    was accepted: without one the golden differs, with it somebody tampered."""
    path = golden_path(root, name)
    info = PngImagePlugin.PngInfo()
    if keeps_note:
        info.add_text("goldray", Image.open(path).text["goldray"])
    picture = codes(path).astype(int)
    change(picture)
    Image.fromarray(picture.clip(0, 255).astype("uint8")).save(path, pnginfo=info)


def change_temple(picture):
    picture[PATCH] += (60, -40, 20)
    picture[BAND] += (0, 4, 0)
    picture[PIXEL] += (1, 0, 0)
    picture[BLUE_PIXEL] += (0, 0, 9)


def change_two(picture):
    picture[PIXEL] += (9, 0, 0)
    picture[LAST_OF_A_ROW] += (9, 0, 0)


def lighten(picture):
    picture += 1


def cut(picture):
    """Puts a corner in the dark."""
    picture[:8, :8] = 0


def broken(root):
    """Every verdict but those of a broken relation and of a file's size."""
    names = [
        DIFFERS,
        DIFFERS_SLIGHTLY,
        LIMITED,
        STALE,
        MISSING,
        TAMPERED,
        WRONG_SIZE,
        REFUSED,
        EXPECTATION,
        *MATCHES,
    ]
    copy(root, *names)
    change_golden(root, DIFFERS, change_temple)
    change_golden(root, DIFFERS_SLIGHTLY, lighten)
    change_golden(root, LIMITED, cut)
    edit(
        root,
        LIMITED,
        "check: (",
        'check: (limits: (ssim: 0.97, ssim_worst: 0.9, max_abs: 9, reason: "a trial of limits"), ',
    )
    edit(root, STALE, "camera:", "samples_per_pixel: 16, camera:")
    golden_path(root, MISSING).unlink()
    change_golden(root, TAMPERED, cut, keeps_note=True)
    place(golden_path(REPOSITORY, "disk/facing"), golden_path(root, ORPHAN))
    Image.fromarray(codes(golden_path(root, WRONG_SIZE))[:50, :90]).save(golden_path(root, WRONG_SIZE))
    edit(root, WRONG_SIZE, "check: (", 'check: (limits: (max_abs: 9, reason: "a trial of limits"), ')
    edit(root, REFUSED, "objects: [", "objects: [Spere(center: (0, 0, 0), radius: -1), ")
    edit(root, EXPECTATION, "expect: [", "expect: [Pixel(at: (0, 0), rgb: (9, 9, 9)), ")


SMALL_SCENE = """// A ball.
(
    version: 1,
    image: {size},
    camera: Parallel(view_point: (0, 0, 5), view_width: 4, view_height: 3),
    show: Normals,
    objects: [Sphere(center: (0, 0, 0), radius: 1)],
    {check}
)
"""


def odd(root, goldray):
    """Names and sizes that are hard on a page, and hundreds of findings."""
    expectations = ", ".join(f"Pixel(at: (0, 0), rgb: ({i % 256}, 7, {i // 256}))" for i in range(300))
    write(root, ODD, SMALL_SCENE.format(size="(40, 30)", check=f"check: (expect: [{expectations}])"))
    write(root, LONG, SMALL_SCENE.format(size="(40, 30)", check=""))
    write(root, ONE_PIXEL, SMALL_SCENE.format(size="(1, 1)", check=""))
    write(root, WIDE, SMALL_SCENE.format(size="(4096, 16)", check=""))
    write(
        root,
        LARGE,
        SMALL_SCENE.format(size="(1600, 1200)", check='check: (large: "it is larger than a pane")'),
    )
    goldray.run(root, "bless", ONE_PIXEL, WIDE, LARGE)
    change_golden(root, LARGE, change_two)
    change_golden(root, ONE_PIXEL, lighten)
    every_code(golden_path(root, WIDE))


def every_code(path):
    """A golden with every code, that says it is to be shown far too dark."""
    ramp = numpy.arange(4096 * 16 * 3, dtype=numpy.uint64).reshape(16, 4096, 3)
    info = PngImagePlugin.PngInfo()
    info.add(b"gAMA", struct.pack(">I", 100_000))
    Image.fromarray((ramp * 7 // 3 % 256).astype("uint8")).save(path, pnginfo=info)


def unreadable(root):
    """A golden that is no picture."""
    copy(root, UNREADABLE)
    golden_path(root, UNREADABLE).write_bytes(b"no picture at all " * 20)


def green(root):
    copy(root, *MATCHES)


def empty(root):
    (root / "fixtures").mkdir(parents=True)


def many(root, count):
    """So many fixtures, each twentieth a failure."""
    names = [
        str(path.relative_to(REPOSITORY / "golden"))[:-4]
        for path in sorted((REPOSITORY / "golden").rglob("*.png"))
    ]
    names = [name for name in names if 'file: "' not in text_of(REPOSITORY, name)]
    for i in range(count):
        name, other = (
            names[i % len(names)],
            f"copy-{i // len(names):02}/{names[i % len(names)].replace('/', '-')}",
        )
        duplicate(root, name, other)
        if i % 20 == 0:
            change_golden(root, other, lighten)
