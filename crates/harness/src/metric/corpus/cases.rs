//! The cases of the corpus, by what is damaged.
//!
//! Ratings are in the order of [`METRICS`](super::super::METRICS): `max_abs`,
//! `differing_pixels`, the minimum and mean of SSIM and of SSIM in the uniform
//! window, the maximum and mean of FLIP, `rmse`, `psnr_db`, the two of
//! image-compare.

mod colors;
mod few_pixels;
mod not_compared;
mod small;
mod structure;
mod tones;

use tracer::Size;

use super::Case;
use super::patterns::Rgb;
use crate::encode::EncodedImage;

/// Every case: identical pictures first, pairs that are not compared last.
pub(super) fn cases() -> Vec<Case> {
    [
        few_pixels::cases(),
        tones::cases(),
        structure::cases(),
        colors::cases(),
        small::cases(),
        not_compared::cases(),
    ]
    .concat()
}

/// Most pictures are as wide and high.
const SIDE: u32 = 64;
/// Large ones are 255 by 255: one pixel by 255 codes is an rmse of exactly 1.
const LARGE: u32 = 255;

fn picture(width: u32, height: u32, pattern: impl Fn(u32, u32) -> Rgb) -> EncodedImage {
    EncodedImage::from_fn(Size { width, height }, pattern)
}

/// A case of two pictures of the same size.
fn sized(
    name: &'static str,
    (width, height): (u32, u32),
    golden: impl Fn(u32, u32) -> Rgb,
    actual: impl Fn(u32, u32) -> Rgb,
    expected: &'static str,
) -> Case {
    let [golden, actual] = [picture(width, height, golden), picture(width, height, actual)];
    Case { name, golden: Ok(golden), actual: Ok(actual), expected }
}

/// A case of two pictures as large as most.
fn pair(
    name: &'static str,
    golden: impl Fn(u32, u32) -> Rgb,
    actual: impl Fn(u32, u32) -> Rgb,
    expected: &'static str,
) -> Case {
    sized(name, (SIDE, SIDE), golden, actual, expected)
}

/// A pattern in one color.
fn flat(color: Rgb) -> impl Fn(u32, u32) -> Rgb + Copy {
    move |_, _| color
}

/// A pattern with some of its pixels in one color.
fn with(
    pattern: impl Fn(u32, u32) -> Rgb + Copy,
    color: Rgb,
    is_there: impl Fn(u32, u32) -> bool,
) -> impl Fn(u32, u32) -> Rgb {
    move |x, y| if is_there(x, y) { color } else { pattern(x, y) }
}

/// A pattern with a function applied to every code.
fn each_code(
    pattern: impl Fn(u32, u32) -> Rgb + Copy,
    code: impl Fn(u8) -> u8,
) -> impl Fn(u32, u32) -> Rgb {
    move |x, y| pattern(x, y).map(&code)
}

const BLACK: Rgb = [0; 3];
const WHITE: Rgb = [255; 3];
const GRAY: Rgb = [100; 3];
const RED: Rgb = [200, 0, 0];
