//! Blind spots: what the metrics say that they cannot see, each shown by a case.

/// How a case, or two, show a blind spot of a metric.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Shown {
    /// The metric lets this case pass, though it is damaged.
    Passes(&'static str),
    /// The metric has the very same value for both, though one is damaged
    /// otherwise than the other.
    Alike(&'static str, &'static str),
    /// The metric finds large damage where the other one named finds none that is.
    Harsher(&'static str, &'static str),
}

use Shown::{Alike, Harsher, Passes};

const ONE_PIXEL: &str = "one pixel black on white";
const FOUR_PIXELS: &str = "four pixels black on white";
const ONE_OF_MANY: &str = "one pixel black on a large white";
const BLOT_OF_MANY: &str = "a blot of 8 x 8 in a large picture";
const FLAT: &str = "flat, ten codes up";
const FINE: &str = "hues swapped pixel by pixel";

/// Each metric with what it cannot see, a clause of its `blind_spot`, and how
/// that is shown.
pub(super) const BLIND_SPOTS: &[(&str, &str, Shown)] = &[
    (
        "max_abs",
        "how many pixels differ, and whether they form a shape",
        Alike(ONE_PIXEL, FOUR_PIXELS),
    ),
    ("differing_pixels", "how far each of them is off", Passes(ONE_PIXEL)),
    ("ssim_min", "how many windows are that bad", Alike(ONE_PIXEL, FOUR_PIXELS)),
    ("ssim_min", "brightness of flat areas", Passes(FLAT)),
    ("ssim_min", "small changes amid strong contrast", Passes("one pixel by 8 codes amid noise")),
    (
        "ssim_mean",
        "damage to few windows: a limit of 0.98 lets any damage to 1 % of them through",
        Passes(BLOT_OF_MANY),
    ),
    (
        "ssim_mean",
        "the outermost pixels, which few windows inside reach",
        Passes("the last row lost"),
    ),
    ("ssim_mean", "brightness of flat areas", Passes(FLAT)),
    ("ssim_uniform_min", "what ssim_min is blind to", Passes(FLAT)),
    ("ssim_uniform_mean", "what ssim_mean is blind to", Passes(BLOT_OF_MANY)),
    ("flip_max", "how many pixels are that bad", Alike(ONE_PIXEL, FOUR_PIXELS)),
    ("flip_max", "patterns finer than the eye resolves", Passes(FINE)),
    ("flip_mean", "damage to few pixels of a large picture", Passes(BLOT_OF_MANY)),
    ("flip_mean", "patterns finer than the eye resolves", Passes(FINE)),
    ("rmse", "damage to few pixels of a large picture", Passes(ONE_OF_MANY)),
    ("rmse", "where it is, and its shape", Alike("every code one up", ONE_OF_MANY)),
    ("psnr_db", "what rmse is blind to", Alike("every code one up", ONE_OF_MANY)),
    ("image_compare_mssim", "hue at equal luma", Passes("another hue of equal luma")),
    (
        "image_compare_mssim",
        "too harsh on faint noise, its C2 is 64 times too small",
        Harsher("faint noise on gray", "ssim_mean"),
    ),
    (
        "image_compare_hybrid",
        "a lost chroma channel: red (200, 0, 0) and green (0, 102, 0) score 1",
        Passes("another hue of equal chroma"),
    ),
];
