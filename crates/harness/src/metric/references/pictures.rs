//! The picture pairs that other people's programs were asked about, drawn again.
//!
//! `pictures.py` draws them by the same formulas; change neither alone.

use tracer::Size;

use crate::encode::EncodedImage;

/// The code of a picture at column, row and channel.
type Code = fn(i64, i64, i64) -> i64;

/// Two pictures and what they are called in the records.
pub(super) struct NamedPair {
    pub(super) name: &'static str,
    pub(super) golden: EncodedImage,
    pub(super) actual: EncodedImage,
}

fn draw(width: u32, height: u32, code: Code) -> EncodedImage {
    let mut bytes = Vec::new();
    for y in 0..height.into() {
        for x in 0..width.into() {
            bytes.extend((0..3).map(|c| u8::try_from(code(x, y, c)).unwrap()));
        }
    }
    EncodedImage::from_bytes(Size { width, height }, bytes).unwrap()
}

fn noise(x: i64, y: i64, c: i64, seed: i64) -> i64 {
    let sum = x * 374_761_393 + y * 668_265_263 + c * 2_246_822_519 + seed * 3_266_489_917;
    let v = sum as u32;
    let v = (v ^ (v >> 15)).wrapping_mul(2_246_822_519);
    let v = (v ^ (v >> 13)).wrapping_mul(3_266_489_917);
    (v >> 24).into()
}

fn clamp(v: i64) -> i64 {
    v.clamp(0, 255)
}

fn slope(x: i64, y: i64, c: i64) -> i64 {
    clamp(20 + 2 * x + y + 30 * c)
}

fn stripes(x: i64, y: i64, c: i64) -> i64 {
    (3 * x + 2 * y + 40 * c) % 200 + 20
}

fn disc(x: i64, y: i64, c: i64, left: i64, color: [i64; 3]) -> i64 {
    let inside = (x - left).pow(2) + (y - 22).pow(2) <= 150;
    if inside { color[c as usize] } else { slope(x, y, c) }
}

fn checker(x: i64, y: i64) -> i64 {
    if (x / 4 + y / 4) % 2 == 0 { 230 } else { 25 }
}

fn box_blur(x: i64, y: i64, c: i64) -> i64 {
    let nine = (0..3).flat_map(|i| (0..3).map(move |j| noise(x + i, y + j, c, 5)));
    nine.sum::<i64>() / 9
}

fn hue_board(n: i64, c: i64) -> i64 {
    let color = if n % 2 == 0 { RUST } else { FLIPPED };
    color[c as usize]
}

const RUST: [i64; 3] = [200, 80, 40];
const FLIPPED: [i64; 3] = [80, 200, 40];

fn pair(name: &'static str, width: u32, height: u32, golden: Code, actual: Code) -> NamedPair {
    NamedPair { name, golden: draw(width, height, golden), actual: draw(width, height, actual) }
}

/// `PAIRS` of `pictures.py`.
pub(super) fn pairs() -> Vec<NamedPair> {
    let rust_disc: Code = |x, y, c| disc(x, y, c, 30, RUST);
    let board: Code = |x, y, _| checker(x, y);
    vec![
        pair("faint_noise", 64, 48, slope, |x, y, c| {
            clamp(slope(x, y, c) + noise(x, y, c, 1) % 9 - 4)
        }),
        pair("heavy_noise", 64, 48, slope, |x, y, c| {
            clamp(slope(x, y, c) + noise(x, y, c, 2) % 81 - 40)
        }),
        pair("disc_shifted", 60, 44, rust_disc, |x, y, c| disc(x, y, c, 31, RUST)),
        pair("disc_hue_swapped", 60, 44, rust_disc, |x, y, c| disc(x, y, c, 30, FLIPPED)),
        pair("disc_missing", 60, 44, rust_disc, slope),
        pair("checker_shifted", 33, 33, board, |x, y, _| checker(x + 1, y)),
        pair("checker_negative", 33, 33, board, |x, y, _| checker(x + 4, y)),
        pair("one_pixel_inverted", 40, 40, stripes, |x, y, c| {
            let code = stripes(x, y, c);
            if (x, y) == (21, 13) { 255 - code } else { code }
        }),
        pair("corner_pixel_inverted", 40, 40, stripes, |x, y, c| {
            let code = stripes(x, y, c);
            if (x, y) == (39, 0) { 255 - code } else { code }
        }),
        pair("edge_pixel_inverted", 40, 40, stripes, |x, y, c| {
            let code = stripes(x, y, c);
            if (x, y) == (0, 20) { 255 - code } else { code }
        }),
        pair("last_row_faded", 40, 40, stripes, |x, y, c| {
            let code = stripes(x, y, c);
            if y == 39 { code / 2 } else { code }
        }),
        pair("one_code_in_the_corner", 40, 40, stripes, |x, y, c| {
            stripes(x, y, c) + i64::from((x, y, c) == (0, 0, 1))
        }),
        pair("identical", 40, 40, stripes, stripes),
        pair("channels_rotated", 50, 20, stripes, |x, y, c| stripes(x, y, (c + 1) % 3)),
        pair("blue_only", 50, 20, stripes, |x, y, c| {
            if c == 2 { noise(x, y, c, 3) } else { stripes(x, y, c) }
        }),
        pair("dimmed", 64, 48, stripes, |x, y, c| stripes(x, y, c) * 49 / 50),
        pair("upside_down", 37, 41, stripes, |x, y, c| stripes(x, 40 - y, c)),
        pair(
            "noise_negative",
            31,
            17,
            |x, y, c| noise(x, y, c, 4),
            |x, y, c| 255 - noise(x, y, c, 4),
        ),
        pair("noise_blurred", 45, 30, |x, y, c| noise(x + 1, y + 1, c, 5), box_blur),
        pair("flat_brighter", 20, 20, |_, _, _| 100, |_, _, _| 110),
        pair("flat_black_white", 20, 20, |_, _, _| 0, |_, _, _| 255),
        pair("flat_against_noise", 20, 20, |_, _, _| 128, |x, y, c| 127 + noise(x, y, c, 6) % 3),
        pair("single_window", 11, 11, |x, y, c| noise(x, y, c, 7), |x, y, c| noise(x, y, c, 8)),
        pair("narrow", 12, 30, |x, y, c| noise(x, y, c, 9), |x, y, c| noise(x, y, c, 9) / 2 + 60),
        pair("wide_single_row", 60, 11, slope, |x, y, c| slope(y, x, c)),
    ]
}

/// `SMALL_PAIRS` of `pictures.py`.
pub(super) fn small_pairs() -> Vec<NamedPair> {
    vec![
        pair("pixel", 1, 1, |_, _, c| 40 * c + 30, |_, _, c| 200 - 60 * c),
        pair("pixel_black_white", 1, 1, |_, _, _| 0, |_, _, _| 255),
        pair(
            "pixel_green_blue",
            1,
            1,
            |_, _, c| [0, 255, 0][c as usize],
            |_, _, c| [0, 0, 255][c as usize],
        ),
        pair("column", 1, 9, |x, y, c| noise(x, y, c, 10), |x, y, c| noise(x, y, c, 11)),
        pair("row", 40, 1, |x, y, c| noise(x, y, c, 12), |x, y, c| noise(x + 1, y, c, 12)),
        pair("two_by_three", 2, 3, |x, y, c| noise(x, y, c, 13), |x, y, c| noise(x, y, c, 14)),
        pair("smaller_than_a_window", 6, 5, stripes, |x, y, c| stripes(x, 4 - y, c)),
    ]
}

/// `SEEN_PAIRS` of `pictures.py`.
pub(super) fn seen_pairs() -> Vec<NamedPair> {
    vec![
        pair(
            "dark_noise",
            30,
            21,
            |x, y, c| noise(x, y, c, 15) % 12,
            |x, y, c| noise(x, y, c, 16) % 12,
        ),
        pair(
            "hue_board_inverted",
            24,
            24,
            |x, y, c| hue_board(x + y, c),
            |x, y, c| hue_board(x + y + 1, c),
        ),
        pair("line_drawn", 50, 40, |_, _, _| 180, |x, y, _| if x == y { 30 } else { 180 }),
    ]
}
