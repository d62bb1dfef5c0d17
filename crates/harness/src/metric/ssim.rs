//! Structural similarity: how far apart, seen through a window that slides over both.
//!
//! A window scores the two pictures by mean, contrast and correlation of what
//! it sees, its center weighing most. Every pixel is the center of one; beyond
//! the edges a window sees the picture mirrored. Each channel is scored alone,
//! so a change of hue is a change.
//!
//! There are two windows: the source's, a Gaussian, which decides, and the
//! uniform one that is scikit-image's default, for readers who know its numbers.
//!
//! Accuracy: within 1e-11 of scikit-image 0.26.0 on the recorded pictures, with
//! the uniform window within 1e-10; the test `agrees_with_scikit_image` prints the
//! largest deviations.
//!
//! Source: Z. Wang, A. C. Bovik, H. R. Sheikh, E. P. Simoncelli, "Image Quality
//! Assessment: From Error Visibility to Structural Similarity", IEEE
//! Transactions on Image Processing 13(4), 2004, section III.B and III.C. The
//! borders, which it leaves open, are those of scikit-image 0.26.0,
//! `skimage.metrics.structural_similarity`: its full map is mirrored, its mean
//! leaves out the windows that look over an edge.

mod mirror;
#[cfg(test)]
mod tests;
mod window;

use std::ops::Range;

use tracer::Size;

use super::{Direction, Metric, Pair};
use window::{Moments, Window, slide};

/// The source's K1 with L = 255, the constant that keeps dark windows stable.
const C1: f64 = (0.01 * 255.0) * (0.01 * 255.0);
/// The source's K2 with L = 255, the constant that keeps flat windows stable.
const C2: f64 = (0.03 * 255.0) * (0.03 * 255.0);

pub(super) const MEAN: Metric = Metric {
    name: "ssim_mean",
    measures: "structural similarity averaged over the windows inside, of the worst channel",
    range: "1 down to -1",
    unit: "1",
    direction: Direction::HigherIsBetter,
    blind_spot: "damage to few windows: a limit of 0.98 lets any damage to 1 % of them through; \
                 the outermost pixels, which few windows inside reach; brightness of flat areas",
    limit: Some("ssim"),
    value: |comparison| Some(comparison.ssim_mean),
};

pub(super) const MIN: Metric = Metric {
    name: "ssim_min",
    measures: "structural similarity of the worst window of any channel, one around each pixel",
    range: "1 down to -1",
    unit: "1",
    direction: Direction::HigherIsBetter,
    blind_spot: "how many windows are that bad; brightness of flat areas; small changes amid \
                 strong contrast",
    limit: Some("ssim, ssim_worst"),
    value: |comparison| Some(comparison.ssim_min),
};

pub(super) const UNIFORM_MEAN: Metric = Metric {
    name: "ssim_uniform_mean",
    measures: "what ssim_mean measures, in windows of 7x7 that weigh all pixels the same",
    range: "1 down to -1",
    unit: "1",
    direction: Direction::HigherIsBetter,
    blind_spot: "what ssim_mean is blind to",
    limit: None,
    value: |comparison| Some(comparison.ssim_uniform_mean),
};

pub(super) const UNIFORM_MIN: Metric = Metric {
    name: "ssim_uniform_min",
    measures: "what ssim_min measures, in windows of 7x7 that weigh all pixels the same",
    range: "1 down to -1",
    unit: "1",
    direction: Direction::HigherIsBetter,
    blind_spot: "what ssim_min is blind to",
    limit: None,
    value: |comparison| Some(comparison.ssim_uniform_min),
};

/// Structural similarity of two pictures: 1 where they are the same, 0 where
/// they have nothing in common, negative where one is the other's negative.
///
/// Identical pictures give exactly 1. The mean of others can round to 1 too,
/// where a few windows of millions differ by little; the minimum is then lower.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ssim {
    /// The lowest of `channel_means`.
    pub mean: f64,
    /// The mean of red, green and blue over the windows inside: those that
    /// look over no edge. In a direction in which the picture is smaller than a
    /// window, where none is inside, all count.
    pub channel_means: [f64; 3],
    /// The lowest window of any channel, those that look over an edge included.
    pub min: f64,
    /// Column and row of the center pixel of that window; the first one row by
    /// row from the top where several are equally low.
    pub min_at: (u32, u32),
}

/// The score of the window around every pixel, the lowest of its three channels.
#[derive(Debug, Clone, PartialEq)]
pub struct SsimMap {
    /// Width and height of the pictures.
    pub size: Size,
    /// One score per pixel, from -1 to 1, row by row from the top.
    pub scores: Vec<f64>,
}

/// Structural similarity in windows of 11x11 pixels, weighed by a Gaussian of
/// standard deviation 1.5.
///
/// Beyond its edges the picture is mirrored, outermost pixel included, as often
/// as the window needs; no picture is too small. One of a single color, such as
/// a single pixel, is compared by brightness only. Swapping the pictures changes
/// nothing.
pub fn ssim(pair: &Pair<'_>) -> Ssim {
    summed_up(pair, &Window::gaussian())
}

/// Structural similarity in windows of 7x7 pixels that all weigh the same, with
/// the covariance of a sample: what scikit-image computes unless told otherwise.
///
/// Borders are those of [`ssim`].
pub fn ssim_uniform(pair: &Pair<'_>) -> Ssim {
    summed_up(pair, &Window::uniform())
}

/// The scores that [`ssim`] sums up, pixel by pixel.
pub fn ssim_map(pair: &Pair<'_>) -> SsimMap {
    scan(pair, &Window::gaussian()).0
}

fn summed_up(pair: &Pair<'_>, window: &Window) -> Ssim {
    let (map, channel_means) = scan(pair, window);
    // The first of the lowest: scores hold no NaN, and `<` keeps the earlier.
    let (mut min, mut at) = (1.0, 0);
    for (i, &score) in map.scores.iter().enumerate() {
        if score < min {
            (min, at) = (score, i);
        }
    }
    let width = map.size.width as usize;
    Ssim {
        mean: channel_means.into_iter().fold(1.0, f64::min),
        channel_means,
        min,
        min_at: ((at % width) as u32, (at / width) as u32),
    }
}

/// The lowest score of every window, and the mean score of every channel.
fn scan(pair: &Pair<'_>, window: &Window) -> (SsimMap, [f64; 3]) {
    let size = pair.size();
    let (width, height) = (size.width as usize, size.height as usize);
    let (columns, rows) = (inside(width, window), inside(height, window));
    let mut lowest = vec![1.0; width * height];
    let mut scores = Vec::with_capacity(width);
    let channel_means = [0, 1, 2].map(|channel| {
        // What is missing from 1 is summed, not the scores: near 1 that keeps
        // more digits, and it is exactly 0 for identical pictures.
        let mut missing = 0.0;
        let mut lowest_rows = lowest.chunks_exact_mut(width);
        slide(window, pair, channel, |y, moments| {
            scores.clear();
            scores.extend(row_scores(moments, window.covariance_factor));
            if rows.contains(&y) {
                missing += scores[columns.clone()].iter().map(|score| 1.0 - score).sum::<f64>();
            }
            for (lowest, score) in lowest_rows.next().into_iter().flatten().zip(&scores) {
                *lowest = score.min(*lowest);
            }
        });
        1.0 - missing / (columns.len() * rows.len()) as f64
    });
    (SsimMap { size, scores: lowest }, channel_means)
}

/// The centers whose windows look over neither end of a line of `pixels`; all
/// of them where there is no such window.
fn inside(pixels: usize, window: &Window) -> Range<usize> {
    let reach = window.reach();
    if pixels < window.side() { 0..pixels } else { reach..pixels - reach }
}

/// The scores of a row of windows.
fn row_scores(row: &Moments, factor: f64) -> impl Iterator<Item = f64> {
    let means = row.x.iter().zip(&row.y);
    let seconds = row.xy.iter().zip(&row.xx_yy);
    means
        .zip(seconds)
        .map(move |((&mu_x, &mu_y), (&xy, &xx_yy))| score(mu_x, mu_y, xy, xx_yy, factor))
}

/// The index of one window from its means of x, y, xy and xx + yy, the source's
/// equation 13, its covariances times `factor`.
///
/// With x = y each factor above equals the one below it bit by bit, because
/// doubling does not round: the score is exactly 1. Cancellation leaves errors
/// in the variances that are small against C2, but they can lift a score over
/// its bound of 1, so it is cut there.
fn score(mu_x: f64, mu_y: f64, xy: f64, xx_yy: f64, factor: f64) -> f64 {
    let product = mu_x * mu_y;
    let squares = mu_x * mu_x + mu_y * mu_y;
    let covariance = factor * (xy - product);
    let variances = factor * (xx_yy - squares);
    let above = (2.0 * product + C1) * (2.0 * covariance + C2);
    let below = (squares + C1) * (variances + C2);
    (above / below).min(1.0)
}
