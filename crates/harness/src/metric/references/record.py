"""Records what scikit-image says about the picture pairs of `pictures.rs`.

    pip install numpy==2.4.6 scikit-image==0.26.0
    python record.py > references.txt

Each picture is a function of column, row and channel in whole numbers, written
the same way in `pictures.rs`; the checksums in the output tell whether both
sides drew the same bytes. The means are scikit-image's, which leave out the
windows that look over an edge; the minimum is that of its full map, which
mirrors the picture there. Pictures smaller than its window of 11x11 cannot be
asked for here; `ssim/tests.rs` covers them from the definition.
"""

import numpy
import skimage
from skimage.metrics import structural_similarity


def noise(x, y, c, seed):
    v = (x * 374761393 + y * 668265263 + c * 2246822519 + seed * 3266489917) % 2**32
    v = (v ^ (v >> 15)) * 2246822519 % 2**32
    v = (v ^ (v >> 13)) * 3266489917 % 2**32
    return v >> 24


def clamp(v):
    return min(max(v, 0), 255)


def slope(x, y, c):
    return clamp(20 + 2 * x + y + 30 * c)


def stripes(x, y, c):
    return (3 * x + 2 * y + 40 * c) % 200 + 20


def disc(x, y, c, left, color):
    inside = (x - left) ** 2 + (y - 22) ** 2 <= 150
    return color[c] if inside else slope(x, y, c)


def checker(x, y):
    return 230 if (x // 4 + y // 4) % 2 == 0 else 25


def box_blur(x, y, c):
    return sum(noise(x + i, y + j, c, 5) for i in range(3) for j in range(3)) // 9


RUST = (200, 80, 40)
FLIPPED = (80, 200, 40)


PAIRS = [
    ("faint_noise", 64, 48, slope, lambda x, y, c: clamp(slope(x, y, c) + noise(x, y, c, 1) % 9 - 4)),
    ("heavy_noise", 64, 48, slope, lambda x, y, c: clamp(slope(x, y, c) + noise(x, y, c, 2) % 81 - 40)),
    ("disc_shifted", 60, 44, lambda x, y, c: disc(x, y, c, 30, RUST), lambda x, y, c: disc(x, y, c, 31, RUST)),
    ("disc_hue_swapped", 60, 44, lambda x, y, c: disc(x, y, c, 30, RUST), lambda x, y, c: disc(x, y, c, 30, FLIPPED)),
    ("disc_missing", 60, 44, lambda x, y, c: disc(x, y, c, 30, RUST), slope),
    ("checker_shifted", 33, 33, lambda x, y, c: checker(x, y), lambda x, y, c: checker(x + 1, y)),
    ("checker_negative", 33, 33, lambda x, y, c: checker(x, y), lambda x, y, c: checker(x + 4, y)),
    ("one_pixel_inverted", 40, 40, stripes, lambda x, y, c: 255 - stripes(x, y, c) if (x, y) == (21, 13) else stripes(x, y, c)),
    ("corner_pixel_inverted", 40, 40, stripes, lambda x, y, c: 255 - stripes(x, y, c) if (x, y) == (39, 0) else stripes(x, y, c)),
    ("edge_pixel_inverted", 40, 40, stripes, lambda x, y, c: 255 - stripes(x, y, c) if (x, y) == (0, 20) else stripes(x, y, c)),
    ("last_row_faded", 40, 40, stripes, lambda x, y, c: stripes(x, y, c) // 2 if y == 39 else stripes(x, y, c)),
    ("one_code_in_the_corner", 40, 40, stripes, lambda x, y, c: stripes(x, y, c) + (1 if (x, y, c) == (0, 0, 1) else 0)),
    ("identical", 40, 40, stripes, stripes),
    ("channels_rotated", 50, 20, stripes, lambda x, y, c: stripes(x, y, (c + 1) % 3)),
    ("blue_only", 50, 20, stripes, lambda x, y, c: noise(x, y, c, 3) if c == 2 else stripes(x, y, c)),
    ("dimmed", 64, 48, stripes, lambda x, y, c: stripes(x, y, c) * 49 // 50),
    ("upside_down", 37, 41, stripes, lambda x, y, c: stripes(x, 40 - y, c)),
    ("noise_negative", 31, 17, lambda x, y, c: noise(x, y, c, 4), lambda x, y, c: 255 - noise(x, y, c, 4)),
    ("noise_blurred", 45, 30, lambda x, y, c: noise(x + 1, y + 1, c, 5), box_blur),
    ("flat_brighter", 20, 20, lambda x, y, c: 100, lambda x, y, c: 110),
    ("flat_black_white", 20, 20, lambda x, y, c: 0, lambda x, y, c: 255),
    ("flat_against_noise", 20, 20, lambda x, y, c: 128, lambda x, y, c: 127 + noise(x, y, c, 6) % 3),
    ("single_window", 11, 11, lambda x, y, c: noise(x, y, c, 7), lambda x, y, c: noise(x, y, c, 8)),
    ("narrow", 12, 30, lambda x, y, c: noise(x, y, c, 9), lambda x, y, c: noise(x, y, c, 9) // 2 + 60),
    ("wide_single_row", 60, 11, slope, lambda x, y, c: slope(y, x, c)),
]


def draw(width, height, value):
    pixels = [[[value(x, y, c) for c in range(3)] for x in range(width)] for y in range(height)]
    return numpy.array(pixels, dtype=numpy.uint8)


def fnv1a(picture):
    h = 0xCBF29CE484222325
    for byte in picture.tobytes():
        h = (h ^ byte) * 0x100000001B3 % 2**64
    return f"{h:016x}"


def worst(scores):
    """The lowest score and its column and row, `-` where others come within 1e-9."""
    lowest = scores.min()
    near = numpy.argwhere(scores < lowest + 1e-9)
    if len(near) > 1:
        return lowest, "-", "-"
    y, x = near[0]
    return lowest, x, y


def record(name, width, height, golden, actual):
    golden, actual = draw(width, height, golden), draw(width, height, actual)
    means, maps = [], []
    for c in range(3):
        mean, scores = structural_similarity(
            golden[..., c],
            actual[..., c],
            gaussian_weights=True,
            sigma=1.5,
            use_sample_covariance=False,
            data_range=255,
            full=True,
        )
        means.append(mean)
        maps.append(scores)
    # The three channels at once must be what they are one by one.
    at_once = structural_similarity(
        golden,
        actual,
        gaussian_weights=True,
        sigma=1.5,
        use_sample_covariance=False,
        data_range=255,
        channel_axis=2,
    )
    assert abs(at_once - sum(means) / 3) < 1e-12
    rmse = numpy.sqrt(numpy.mean((golden.astype(float) - actual.astype(float)) ** 2))
    lowest, x, y = worst(numpy.minimum.reduce(maps))
    values = [*means, lowest]
    print(name, width, height, fnv1a(golden), fnv1a(actual), *map(repr, map(float, values)), x, y, repr(float(rmse)))


print(f"# Written by record.py with scikit-image {skimage.__version__}, numpy {numpy.__version__}.")
print("# name width height fnv1a(golden) fnv1a(actual) ssim_red ssim_green ssim_blue ssim_min min_x min_y rmse")
for pair in PAIRS:
    record(*pair)
