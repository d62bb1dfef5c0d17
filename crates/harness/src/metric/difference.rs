//! Largest difference: how far apart, seen code by code.
//!
//! The difference of a pixel is the largest of its three channels, in codes
//! from 0 to 255. Nothing is averaged and nothing rounds, so the smallest
//! change of a single pixel is seen, and so is nothing about its meaning.

use super::{Direction, Metric, Pair};

/// The differences over which pixels are counted, in codes.
pub const DIFFERENCE_STEPS: [u8; 8] = [1, 2, 4, 8, 16, 32, 64, 128];

pub(super) const MAX_ABS: Metric = Metric {
    name: "max_abs",
    measures: "the largest difference of any channel of any pixel",
    range: "0 to 255",
    unit: "codes",
    direction: Direction::LowerIsBetter,
    blind_spot: "how many pixels differ, and whether they form a shape",
    limit: Some("max_abs"),
    value: |comparison| Some(f64::from(comparison.max_abs)),
};

pub(super) const DIFFERING_PIXELS: Metric = Metric {
    name: "differing_pixels",
    measures: "the number of pixels that are not the same in every channel",
    range: "0 to width times height",
    unit: "pixels",
    direction: Direction::LowerIsBetter,
    blind_spot: "how far each of them is off",
    limit: Some("differing_pixels"),
    value: |comparison| Some(comparison.differing_pixels as f64),
};

/// How far apart the codes of two pictures are.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Difference {
    /// The largest difference of any channel of any pixel, in codes.
    pub max_abs: u8,
    /// How many pixels differ in any channel.
    pub differing_pixels: u64,
    /// Column and row of the first pixel that differs, row by row from the top.
    pub first_differing: Option<(u32, u32)>,
    /// How many pixels differ by more than each of [`DIFFERENCE_STEPS`].
    pub pixels_over: [u64; DIFFERENCE_STEPS.len()],
}

/// The difference of every pixel, summed up. Swapping the pictures changes
/// nothing.
pub fn difference(pair: &Pair<'_>) -> Difference {
    let mut counts = [0_u64; 256];
    let mut first = None;
    for (i, (golden, actual)) in pair.pixels().enumerate() {
        let largest = largest_channel(golden, actual);
        counts[usize::from(largest)] += 1;
        if 0 < largest && first.is_none() {
            first = Some(i);
        }
    }
    let over = |step: u8| counts[usize::from(step) + 1..].iter().sum();
    let width = pair.size().width as usize;
    Difference {
        max_abs: counts.iter().rposition(|&count| 0 < count).unwrap_or(0) as u8,
        differing_pixels: over(0),
        first_differing: first.map(|i| ((i % width) as u32, (i / width) as u32)),
        pixels_over: DIFFERENCE_STEPS.map(over),
    }
}

fn largest_channel(a: [u8; 3], b: [u8; 3]) -> u8 {
    let [r, g, b] = [0, 1, 2].map(|c| a[c].abs_diff(b[c]));
    r.max(g).max(b)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::encode::EncodedImage;
    use tracer::Size;

    #[track_caller]
    fn check(width: u32, golden: &[u8], actual: &[u8], expected: Difference) {
        let height = golden.len() as u32 / 3 / width;
        let image = |bytes: &[u8]| {
            EncodedImage::from_bytes(Size { width, height }, bytes.to_vec()).unwrap()
        };
        let (golden, actual) = (image(golden), image(actual));
        assert_eq!(difference(&Pair::new(&golden, &actual).unwrap()), expected);
        assert_eq!(difference(&Pair::new(&actual, &golden).unwrap()), expected);
    }

    #[test]
    fn one_black_pixel_against_white() {
        let expected = Difference {
            max_abs: 255,
            differing_pixels: 1,
            first_differing: Some((0, 0)),
            pixels_over: [1; 8],
        };
        check(1, &[0; 3], &[255; 3], expected);
    }

    #[test]
    fn identical_pixels() {
        check(2, &[7, 0, 255, 3, 3, 3], &[7, 0, 255, 3, 3, 3], Difference::default());
    }

    #[test]
    fn one_code_in_the_last_channel_of_the_last_pixel() {
        let mut actual = [9; 18];
        actual[17] = 10;
        let expected = Difference {
            max_abs: 1,
            differing_pixels: 1,
            first_differing: Some((1, 2)),
            pixels_over: [0; 8],
        };
        check(2, &[9; 18], &actual, expected);
    }

    #[test]
    fn a_step_counts_only_what_is_greater() {
        let golden = [100, 100, 100, 100, 100, 100, 100, 100, 100];
        let actual = [101, 98, 100, 100, 100, 100, 84, 100, 110];
        let expected = Difference {
            max_abs: 16,
            differing_pixels: 2,
            first_differing: Some((0, 0)),
            pixels_over: [2, 1, 1, 1, 0, 0, 0, 0],
        };
        check(3, &golden, &actual, expected);
    }
}
