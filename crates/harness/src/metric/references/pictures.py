"""The picture pairs that other people's programs are asked about.

Each picture is a function of column, row and channel in whole numbers, written
the same way in `pictures.rs`; change neither alone. The checksums in what is
recorded tell whether both sides drew the same bytes.
"""

import numpy


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


def board(n, c):
    return (RUST if n % 2 == 0 else FLIPPED)[c]


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

# Those smaller than a window of SSIM, which scikit-image refuses.
SMALL_PAIRS = [
    ("pixel", 1, 1, lambda x, y, c: 40 * c + 30, lambda x, y, c: 200 - 60 * c),
    ("pixel_black_white", 1, 1, lambda x, y, c: 0, lambda x, y, c: 255),
    ("pixel_green_blue", 1, 1, lambda x, y, c: 255 if c == 1 else 0, lambda x, y, c: 255 if c == 2 else 0),
    ("column", 1, 9, lambda x, y, c: noise(x, y, c, 10), lambda x, y, c: noise(x, y, c, 11)),
    ("row", 40, 1, lambda x, y, c: noise(x, y, c, 12), lambda x, y, c: noise(x + 1, y, c, 12)),
    ("two_by_three", 2, 3, lambda x, y, c: noise(x, y, c, 13), lambda x, y, c: noise(x, y, c, 14)),
    ("smaller_than_a_window", 6, 5, stripes, lambda x, y, c: stripes(x, 4 - y, c)),
]

# Those that only the sight of an eye is asked about.
SEEN_PAIRS = [
    ("dark_noise", 30, 21, lambda x, y, c: noise(x, y, c, 15) % 12, lambda x, y, c: noise(x, y, c, 16) % 12),
    ("hue_board_inverted", 24, 24, lambda x, y, c: board(x + y, c), lambda x, y, c: board(x + y + 1, c)),
    ("line_drawn", 50, 40, lambda x, y, c: 180, lambda x, y, c: 30 if x == y else 180),
]


def draw(width, height, value):
    pixels = [[[value(x, y, c) for c in range(3)] for x in range(width)] for y in range(height)]
    return numpy.array(pixels, dtype=numpy.uint8)


def fnv1a(picture):
    h = 0xCBF29CE484222325
    for byte in picture.tobytes():
        h = (h ^ byte) * 0x100000001B3 % 2**64
    return f"{h:016x}"
