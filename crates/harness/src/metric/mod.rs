//! Numbers that say how far today's picture is from its golden.
//!
//! A metric judges nothing: limits and verdicts are made elsewhere. Each has a
//! file of its own and an entry in [`METRICS`], which says what it measures and
//! what it cannot see.

pub mod corpus;
mod difference;
mod flip;
mod image_compare;
mod pair;
#[cfg(test)]
mod references;
mod rmse;
mod ssim;
#[cfg(test)]
mod tests;

use crate::encode::EncodedImage;

pub use difference::{DIFFERENCE_STEPS, Difference, difference};
pub use flip::{Flip, FlipMap, PIXELS_PER_DEGREE, flip, flip_map};
pub use image_compare::{ImageCompare, image_compare};
pub use pair::Pair;
pub use rmse::{Rmse, rmse};
pub use ssim::{Ssim, SsimMap, ssim, ssim_map, ssim_uniform};

/// What a metric is, in words a command can print.
#[derive(Debug, Clone, Copy)]
pub struct Metric {
    /// The name used in limits and reports.
    pub name: &'static str,
    /// What is measured.
    pub measures: &'static str,
    /// The values it can take; the first is that of identical pictures.
    pub range: &'static str,
    /// The unit; `"1"` for a bare ratio.
    pub unit: &'static str,
    /// Which way is closer to the golden.
    pub direction: Direction,
    /// Damage it is blind to, or nearly so.
    pub blind_spot: &'static str,
    /// The limits of a fixture that decide by it; `None` where it is reported
    /// only.
    pub limit: Option<&'static str>,
    /// Its value in a comparison; `None` where it has none.
    pub value: fn(&Comparison) -> Option<f64>,
}

/// Which way along the number line the pictures are more alike.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Direction {
    /// Greater values are closer.
    HigherIsBetter,
    /// Smaller values are closer.
    LowerIsBetter,
}

impl Direction {
    /// As people say it.
    pub fn words(self) -> &'static str {
        match self {
            Self::HigherIsBetter => "higher is better",
            Self::LowerIsBetter => "lower is better",
        }
    }
}

/// Every metric, in the order of a report.
pub const METRICS: &[Metric] = &[
    difference::MAX_ABS,
    difference::DIFFERING_PIXELS,
    ssim::MIN,
    ssim::MEAN,
    ssim::UNIFORM_MIN,
    ssim::UNIFORM_MEAN,
    flip::MAX,
    flip::MEAN,
    rmse::RMSE,
    rmse::PSNR,
    image_compare::MSSIM,
    image_compare::HYBRID,
];

/// Every metric of one pair of pictures.
#[derive(Debug, Clone, PartialEq)]
pub struct Comparison {
    /// [`Ssim::mean`].
    pub ssim_mean: f64,
    /// [`Ssim::min`].
    pub ssim_min: f64,
    /// [`Ssim::min_at`].
    pub ssim_min_at: (u32, u32),
    /// [`Ssim::mean`] of [`ssim_uniform`].
    pub ssim_uniform_mean: f64,
    /// [`Ssim::min`] of [`ssim_uniform`].
    pub ssim_uniform_min: f64,
    /// [`Flip::mean`].
    pub flip_mean: f64,
    /// [`Flip::max`].
    pub flip_max: f64,
    /// [`Flip::max_at`].
    pub flip_max_at: (u32, u32),
    /// [`Difference::max_abs`].
    pub max_abs: u8,
    /// [`Difference::differing_pixels`].
    pub differing_pixels: u64,
    /// [`Difference::first_differing`].
    pub first_differing: Option<(u32, u32)>,
    /// [`Difference::pixels_over`], one count for each of [`DIFFERENCE_STEPS`].
    pub pixels_over: [u64; DIFFERENCE_STEPS.len()],
    /// [`Rmse::rmse`].
    pub rmse: f64,
    /// [`Rmse::psnr_db`].
    pub psnr_db: Option<f64>,
    /// [`ImageCompare::mssim`].
    pub image_compare_mssim: Option<f64>,
    /// [`ImageCompare::hybrid`].
    pub image_compare_hybrid: Option<f64>,
}

impl Comparison {
    /// Whether every byte of the two pictures is the same.
    pub fn is_identical(&self) -> bool {
        self.differing_pixels == 0
    }
}

/// Every metric of `actual` against `golden`; `None` where their sizes differ
/// or they have no pixel.
///
/// Swapping the two gives the same numbers.
pub fn compare(golden: &EncodedImage, actual: &EncodedImage) -> Option<Comparison> {
    let pair = Pair::new(golden, actual)?;
    Some(if pair.is_identical() { of_identical() } else { of_any(&pair) })
}

/// What [`of_any`] gives for identical pictures, without the work. Each score
/// of a window is a quotient of two equal numbers there, hence exactly 1, and
/// so are their means; no color of FLIP is any distance from itself; the test `identical_pictures_take_no_other_value` holds
/// the two functions against each other.
fn of_identical() -> Comparison {
    Comparison {
        ssim_mean: 1.0,
        ssim_min: 1.0,
        ssim_min_at: (0, 0),
        ssim_uniform_mean: 1.0,
        ssim_uniform_min: 1.0,
        flip_mean: 0.0,
        flip_max: 0.0,
        flip_max_at: (0, 0),
        max_abs: 0,
        differing_pixels: 0,
        first_differing: None,
        pixels_over: [0; DIFFERENCE_STEPS.len()],
        rmse: 0.0,
        psnr_db: None,
        image_compare_mssim: Some(1.0),
        image_compare_hybrid: Some(1.0),
    }
}

fn of_any(pair: &Pair<'_>) -> Comparison {
    let ssim = ssim(pair);
    let ssim_uniform = ssim_uniform(pair);
    let flip = flip(pair);
    let difference = difference(pair);
    let rmse = rmse(pair);
    let image_compare = image_compare(pair);
    Comparison {
        ssim_mean: ssim.mean,
        ssim_min: ssim.min,
        ssim_min_at: ssim.min_at,
        ssim_uniform_mean: ssim_uniform.mean,
        ssim_uniform_min: ssim_uniform.min,
        flip_mean: flip.mean,
        flip_max: flip.max,
        flip_max_at: flip.max_at,
        max_abs: difference.max_abs,
        differing_pixels: difference.differing_pixels,
        first_differing: difference.first_differing,
        pixels_over: difference.pixels_over,
        rmse: rmse.rmse,
        psnr_db: rmse.psnr_db,
        image_compare_mssim: image_compare.mssim,
        image_compare_hybrid: image_compare.hybrid,
    }
}
