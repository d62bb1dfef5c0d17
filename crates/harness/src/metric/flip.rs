//! FLIP: the difference somebody sees who flips between the two pictures on a display.
//!
//! Each picture is seen as an eye at [`PIXELS_PER_DEGREE`] sees it: colors are
//! blurred by what the eye resolves, then compared where equal distances look
//! equally far apart; where an edge or a point is in one picture only, the
//! difference counts more. What the display fades, fades here.
//!
//! The codes are taken as sRGB, those of a fixture encoded with `Gamma22` too:
//! it is how a display shows them.
//!
//! Accuracy: within 1e-4 of NVIDIA's `flip-evaluator` 1.7 at every pixel of the
//! recorded pictures, which is what that program's single precision allows; within
//! 1e-5 in the mean, but for pairs whose features cancel. The test
//! `agrees_with_the_flip_evaluator` prints the largest deviations.
//!
//! Source: P. Andersson, J. Nilsson, T. Akenine-Möller, M. Oskarsson, K. Åström,
//! M. D. Fairchild, "FLIP: A Difference Evaluator for Alternating Images",
//! Proceedings of the ACM on Computer Graphics and Interactive Techniques 3(2),
//! 2020: section 4.1 for colors, 4.2 for features, 4.3 for both together. The
//! borders, which it leaves open, are those of `flip-evaluator`: the outermost
//! pixel goes on.

mod color;
mod eye;
mod features;
mod kernel;
mod sensitivity;
#[cfg(test)]
mod tests;

use std::f64::consts::{PI, SQRT_2};

use tracer::Size;
use tracer::glam::DVec3;

use super::{Direction, Metric, Pair};
use color::{Colors, hyab};
use eye::{Eye, Seen};

/// The source's observer: so far in front of a display so wide, in meters.
const DISTANCE_M: f64 = 0.7;
const DISPLAY_WIDTH_M: f64 = 0.7;
/// The pixels side by side on that display.
const DISPLAY_WIDTH_PX: f64 = 3840.0;
/// How many pixels of the display one degree of the observer's view holds,
/// about 67.
pub const PIXELS_PER_DEGREE: f64 = DISTANCE_M * DISPLAY_WIDTH_PX / DISPLAY_WIDTH_M * PI / 180.0;

/// The source's `q_c`: large differences of color count less than in proportion.
const Q_C: f64 = 0.7;
/// The source's `p_c` and `p_t`: differences up to the share `P_C` of the largest
/// one are spread over the errors from 0 to `P_T`.
const P_C: f64 = 0.4;
const P_T: f64 = 0.95;

pub(super) const MEAN: Metric = Metric {
    name: "flip_mean",
    measures: "the difference seen when flipping between the two, averaged over the pixels",
    range: "0 to 1",
    unit: "1",
    direction: Direction::LowerIsBetter,
    blind_spot: "damage to few pixels of a large picture; patterns finer than the eye resolves",
    limit: Some("flip"),
    value: |comparison| Some(comparison.flip_mean),
};

pub(super) const MAX: Metric = Metric {
    name: "flip_max",
    measures: "the difference seen when flipping between the two, at the worst pixel",
    range: "0 to 1",
    unit: "1",
    direction: Direction::LowerIsBetter,
    blind_spot: "how many pixels are that bad; patterns finer than the eye resolves",
    limit: Some("flip, flip_worst"),
    value: |comparison| Some(comparison.flip_max),
};

/// FLIP of two pictures: 0 where they are the same, 1 where they are as far
/// apart as green and blue.
///
/// Identical pictures give exactly 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Flip {
    /// The mean error of all pixels.
    pub mean: f64,
    /// The largest error of any pixel.
    pub max: f64,
    /// Column and row of that pixel; the first one row by row from the top where
    /// several are equally bad.
    pub max_at: (u32, u32),
}

/// The error seen at every pixel.
#[derive(Debug, Clone, PartialEq)]
pub struct FlipMap {
    /// Width and height of the pictures.
    pub size: Size,
    /// One error per pixel, from 0 to 1, row by row from the top.
    pub errors: Vec<f64>,
}

/// FLIP at [`PIXELS_PER_DEGREE`].
///
/// Beyond its edges the picture goes on as its outermost pixels, which count for
/// more by that, most of all in corners; no picture is too small. Swapping the
/// pictures changes nothing.
pub fn flip(pair: &Pair<'_>) -> Flip {
    let (mut sum, mut count) = (0.0, 0_u64);
    let (mut max, mut at) = (0.0, 0);
    scan(pair, |error| {
        // The first of the largest: errors hold no NaN, and `>` keeps the earlier.
        if error > max {
            (max, at) = (error, count);
        }
        sum += error;
        count += 1;
    });
    let width = u64::from(pair.size().width);
    Flip { mean: sum / count as f64, max, max_at: ((at % width) as u32, (at / width) as u32) }
}

/// The errors that [`flip`] sums up, pixel by pixel.
pub fn flip_map(pair: &Pair<'_>) -> FlipMap {
    let mut errors = Vec::with_capacity(pair.golden().pixels().len());
    scan(pair, |error| errors.push(error));
    FlipMap { size: pair.size(), errors }
}

/// Calls `each` with the error of every pixel, row by row from the top.
fn scan(pair: &Pair<'_>, mut each: impl FnMut(f64)) {
    let colors = Colors::new();
    let scale = ColorScale::new(&colors);
    let mut eyes = [pair.golden(), pair.actual()].map(|picture| Eye::new(picture, &colors));
    for y in 0..pair.size().height as usize {
        let [golden, actual] = eyes.each_mut().map(|eye| eye.row(y));
        for (a, b) in golden.iter().zip(actual) {
            let color = scale.error(a.color, b.color);
            // The source's equation 20. Equal colors are no error, however
            // unlike the features: 0 to any power but 0.
            each(if color == 0.0 { 0.0 } else { libm::pow(color, 1.0 - feature_error(a, b)) });
        }
    }
}

/// The source's equation 19, from 0 to 1.
fn feature_error(a: &Seen, b: &Seen) -> f64 {
    let edge = (a.edge - b.edge).abs();
    let point = (a.point - b.point).abs();
    // The source's q_f is 1/2: small differences count more than in proportion.
    (edge.max(point) / SQRT_2).sqrt()
}

/// How far apart two colors are on the scale of what a display can show.
struct ColorScale {
    /// The largest difference, that of green and blue.
    largest: f64,
}

impl ColorScale {
    fn new(colors: &Colors) -> Self {
        let [green, blue] = [DVec3::Y, DVec3::Z].map(|rgb| colors.perceived(rgb));
        Self { largest: libm::pow(hyab(green, blue), Q_C) }
    }

    /// From 0 to 1, the end of section 4.1 of the source.
    fn error(&self, a: DVec3, b: DVec3) -> f64 {
        let difference = libm::pow(hyab(a, b), Q_C);
        let knee = P_C * self.largest;
        if difference < knee {
            P_T / knee * difference
        } else {
            P_T + (difference - knee) / (self.largest - knee) * (1.0 - P_T)
        }
    }
}
