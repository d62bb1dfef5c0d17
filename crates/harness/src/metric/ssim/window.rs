//! The sliding window: weighted means around every pixel, row by row.
//!
//! Its weights are separable, so every row is weighed along x once, kept while a
//! window reaches it, and then weighed along y.

use std::array;

use super::super::Pair;
use super::mirror::mirrored;

/// How many pixels the Gaussian window reaches from its center, to each side.
const GAUSSIAN_REACH: usize = 5;
/// The source's standard deviation, in pixels.
const SIGMA: f64 = 1.5;
/// How many pixels the uniform window reaches, to each side.
const UNIFORM_REACH: usize = 3;

/// What slides over both pictures.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Window {
    /// The weights along one direction, from the middle one outwards. With each
    /// but the middle one counted twice they sum to 1.
    half: Vec<f64>,
    /// What variances and covariances are multiplied by.
    pub(super) covariance_factor: f64,
}

impl Window {
    /// The source's: 11x11 pixels, weighed by a Gaussian.
    pub(super) fn gaussian() -> Self {
        let bell =
            |distance: usize| libm::exp(-((distance * distance) as f64) / (2.0 * SIGMA * SIGMA));
        let half: Vec<_> = (0..=GAUSSIAN_REACH).map(bell).collect();
        let total = half[0] + 2.0 * half[1..].iter().sum::<f64>();
        let half = half.into_iter().map(|weight| weight / total).collect();
        Self { half, covariance_factor: 1.0 }
    }

    /// 7x7 pixels that weigh the same, with the covariance of a sample: divided
    /// by one less than the number of pixels.
    pub(super) fn uniform() -> Self {
        let side = (1 + 2 * UNIFORM_REACH) as f64;
        let pixels = side * side;
        Self {
            half: vec![1.0 / side; 1 + UNIFORM_REACH],
            covariance_factor: pixels / (pixels - 1.0),
        }
    }

    /// How many pixels it reaches from its center, to each side.
    pub(super) fn reach(&self) -> usize {
        self.half.len() - 1
    }

    /// How many pixels it is wide and high.
    pub(super) fn side(&self) -> usize {
        1 + 2 * self.reach()
    }
}

/// Weighted means over each window of a row of windows, in the source's symbols:
/// x is the golden's channel, y the actual's.
pub(super) struct Moments {
    pub(super) x: Vec<f64>,
    pub(super) y: Vec<f64>,
    pub(super) xy: Vec<f64>,
    /// The sum of both squares, x*x + y*y: SSIM never needs one without the other.
    pub(super) xx_yy: Vec<f64>,
}

impl Moments {
    fn new(len: usize) -> Self {
        let [x, y, xy, xx_yy] = array::from_fn(|_| vec![0.0; len]);
        Self { x, y, xy, xx_yy }
    }

    fn each(&self) -> [&[f64]; 4] {
        [&self.x, &self.y, &self.xy, &self.xx_yy]
    }

    fn each_mut(&mut self) -> [&mut [f64]; 4] {
        [&mut self.x, &mut self.y, &mut self.xy, &mut self.xx_yy]
    }
}

/// Calls `each` with every row of windows over one channel, and with the row of
/// the picture their centers are in, from the top.
pub(super) fn slide(
    window: &Window,
    pair: &Pair<'_>,
    channel: usize,
    mut each: impl FnMut(usize, &Moments),
) {
    let (width, height) = (pair.size().width as usize, pair.size().height as usize);
    let (reach, side) = (window.reach(), window.side());
    let (columns, rows) = (mirrored(width, reach), mirrored(height, reach));

    let mut pixels = Moments::new(columns.len());
    // Row y of the picture, weighed along x, is `weighed[y % side]`. A mirrored
    // row needs no place of its own: it is always one that the window reaches.
    let mut weighed: Vec<_> = (0..side).map(|_| Moments::new(width)).collect();
    let mut row = Moments::new(width);

    let golden_rows = pair.golden().pixels().chunks_exact(width);
    let actual_rows = pair.actual().pixels().chunks_exact(width);
    let mut unread = golden_rows.zip(actual_rows).enumerate();
    for center in 0..height {
        // The first window needs all the rows it reaches, each further one the
        // next row; the last ones find the picture read to its end.
        let to_read = if center == 0 { 1 + reach } else { 1 };
        for (y, (golden, actual)) in unread.by_ref().take(to_read) {
            load(&mut pixels, golden, actual, &columns, channel);
            let outputs = weighed[y % side].each_mut();
            for (input, output) in pixels.each().into_iter().zip(outputs) {
                weigh(&window.half, |i| &input[i..i + width], output);
            }
        }
        for (moment, output) in row.each_mut().into_iter().enumerate() {
            weigh(&window.half, |i| weighed[rows[center + i] % side].each()[moment], output);
        }
        each(center, &row);
    }
}

/// The products of two rows of pixels, in one channel, at the given columns. All
/// are whole numbers, so nothing rounds.
fn load(
    row: &mut Moments,
    golden: &[[u8; 3]],
    actual: &[[u8; 3]],
    columns: &[usize],
    channel: usize,
) {
    for (i, &column) in columns.iter().enumerate() {
        let (x, y) = (f64::from(golden[column][channel]), f64::from(actual[column][channel]));
        row.x[i] = x;
        row.y[i] = y;
        row.xy[i] = x * y;
        row.xx_yy[i] = x * x + y * y;
    }
}

/// Sums `2 * half.len() - 1` lines into `sum`, each times its weight. Lines at
/// the same distance from the middle one are added first: it saves
/// multiplications, and a mirrored picture gives the mirrored bits.
fn weigh<'a>(half: &[f64], line: impl Fn(usize) -> &'a [f64], sum: &mut [f64]) {
    let middle = half.len() - 1;
    for (sum, &value) in sum.iter_mut().zip(line(middle)) {
        *sum = half[0] * value;
    }
    for (distance, &weight) in half.iter().enumerate().skip(1) {
        let pairs = line(middle - distance).iter().zip(line(middle + distance));
        for (sum, (&before, &after)) in sum.iter_mut().zip(pairs) {
            *sum += weight * (before + after);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_weights_sum_to_1() {
        for window in [Window::gaussian(), Window::uniform()] {
            let total = window.half[0] + 2.0 * window.half[1..].iter().sum::<f64>();
            assert!((total - 1.0).abs() < 1e-15, "{total}");
        }
        assert!(Window::gaussian().half.is_sorted_by(|a, b| a > b));
    }

    #[test]
    fn the_sides_are_those_of_the_sources() {
        assert_eq!([Window::gaussian().side(), Window::uniform().side()], [11, 7]);
        assert_eq!(Window::uniform().covariance_factor, 49.0 / 48.0);
    }
}
