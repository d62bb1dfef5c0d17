//! Scores of the `image-compare` crate: how far apart, seen as that crate sees it.
//!
//! They are reported for readers who know them and never decide a verdict:
//! - Its MSSIM divides the means of a window by its number of pixels but not
//!   the variances, so its constant C2 is 64 times too small: noise nobody sees
//!   on a smooth surface costs most of the score. Its windows of 8x8 do not
//!   overlap, so the score depends on where damage falls among them.
//! - Its hybrid score merges the two chroma channels by the length of the
//!   vector of their similarities, clamped to 1. A whole channel may be lost
//!   where the other is intact: red (200, 0, 0) and green (0, 102, 0) score 1.
//!
//! Each of these is seen by a test below.

use image::{GrayImage, RgbImage};
use image_compare::{Algorithm, gray_similarity_structure, rgb_hybrid_compare};

use super::{Direction, Metric, Pair};
use crate::encode::EncodedImage;

pub(super) const MSSIM: Metric = Metric {
    name: "image_compare_mssim",
    measures: "the mean structural similarity of luma, after the crate image-compare",
    range: "1 down to -1",
    unit: "1",
    direction: Direction::HigherIsBetter,
    blind_spot: "hue at equal luma; too harsh on faint noise, its C2 is 64 times too small",
    limit: None,
    value: |comparison| comparison.image_compare_mssim,
};

pub(super) const HYBRID: Metric = Metric {
    name: "image_compare_hybrid",
    measures: "structure of luma and difference of chroma, after the crate image-compare",
    range: "1 down to 0",
    unit: "1",
    direction: Direction::HigherIsBetter,
    blind_spot: "a lost chroma channel: red (200, 0, 0) and green (0, 102, 0) score 1",
    limit: None,
    value: |comparison| comparison.image_compare_hybrid,
};

/// The scores of the `image-compare` crate, 1 for identical pictures; `None`
/// where the crate returns an error or no finite number.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ImageCompare {
    /// Its gray MSSIM (`gray_similarity_structure`, `MSSIMSimple`), from -1 to
    /// 1, of `floor((2126 R + 7152 G + 722 B) / 10000)`.
    pub mssim: Option<f64>,
    /// Its `rgb_hybrid_compare`, from 0 to 1.
    pub hybrid: Option<f64>,
}

/// Both scores of the `image-compare` crate, version 0.5.
pub fn image_compare(pair: &Pair<'_>) -> ImageCompare {
    ImageCompare {
        mssim: mssim(pair).filter(|score| score.is_finite()),
        hybrid: hybrid(pair).filter(|score| score.is_finite()),
    }
}

fn mssim(pair: &Pair<'_>) -> Option<f64> {
    let (golden, actual) = (luma(pair.golden())?, luma(pair.actual())?);
    let found = gray_similarity_structure(&Algorithm::MSSIMSimple, &golden, &actual).ok()?;
    Some(found.score)
}

fn hybrid(pair: &Pair<'_>) -> Option<f64> {
    let (golden, actual) = (rgb(pair.golden())?, rgb(pair.actual())?);
    Some(rgb_hybrid_compare(&golden, &actual).ok()?.score)
}

fn rgb(image: &EncodedImage) -> Option<RgbImage> {
    RgbImage::from_raw(image.size().width, image.size().height, image.bytes().to_vec())
}

/// Luma in whole numbers, with the weights of ITU-R BT.709 in ten-thousandths.
///
/// It is computed here because the `image` crate has several conversions to
/// gray, and which of them is meant by one name is its own affair.
fn luma(image: &EncodedImage) -> Option<GrayImage> {
    let weigh = |&[r, g, b]: &[u8; 3]| {
        let sum = 2126 * u32::from(r) + 7152 * u32::from(g) + 722 * u32::from(b);
        (sum / 10_000) as u8
    };
    let gray = image.pixels().iter().map(weigh).collect();
    GrayImage::from_raw(image.size().width, image.size().height, gray)
}

#[cfg(test)]
mod tests {
    use super::super::ssim;
    use super::*;
    use tracer::Size;

    fn image(width: u32, height: u32, pixel: impl Fn(u32, u32) -> [u8; 3]) -> EncodedImage {
        let bytes = (0..height).flat_map(|y| (0..width).flat_map(move |x| [(x, y)]));
        let bytes = bytes.flat_map(|(x, y)| pixel(x, y)).collect();
        EncodedImage::from_bytes(Size { width, height }, bytes).unwrap()
    }

    fn scores(golden: &EncodedImage, actual: &EncodedImage) -> ImageCompare {
        image_compare(&Pair::new(golden, actual).unwrap())
    }

    #[test]
    fn pictures_smaller_than_a_window_have_scores() {
        for (width, height) in [(1, 1), (1, 9), (7, 2), (8, 8), (9, 1)] {
            let black = image(width, height, |_, _| [0; 3]);
            let white = image(width, height, |_, _| [255; 3]);
            let found = scores(&black, &white);
            assert!(found.mssim.unwrap() < 0.001, "{width}x{height} {found:?}");
            assert!(found.hybrid.unwrap() < 0.001, "{width}x{height} {found:?}");
        }
    }

    #[test]
    fn luma_is_the_weighted_sum_rounded_down() {
        let one = |rgb| luma(&image(1, 1, |_, _| rgb)).unwrap().into_raw()[0];
        assert_eq!(one([0; 3]), 0);
        assert_eq!(one([255; 3]), 255);
        assert_eq!(one([255, 0, 0]), 54);
        assert_eq!(one([0, 255, 0]), 182);
        assert_eq!(one([0, 0, 255]), 18);
        assert_eq!(one([200, 0, 0]), 42);
        assert_eq!(one([0, 0, 13]), 0);
    }

    #[test]
    fn the_hybrid_score_takes_red_for_green() {
        let red = image(16, 16, |_, _| [200, 0, 0]);
        let green = image(16, 16, |_, _| [0, 102, 0]);
        assert_eq!(scores(&red, &green).hybrid, Some(1.0));
    }

    #[test]
    fn mssim_does_not_see_hue_at_equal_luma() {
        let red = image(16, 16, |_, _| [200, 0, 0]);
        let green = image(16, 16, |_, _| [0, 60, 0]);
        assert_eq!(scores(&red, &green).mssim, Some(1.0));
    }

    #[test]
    fn mssim_is_too_harsh_on_faint_noise() {
        let mut rng = fastrand::Rng::with_seed(3);
        let noise: Vec<u8> = (0..64 * 64).map(|_| rng.u8(0..=6)).collect();
        let ramp = image(64, 64, |x, y| [(100 + x / 2 + y / 4) as u8; 3]);
        let noisy =
            image(64, 64, |x, y| [(97 + x / 2 + y / 4) as u8 + noise[(y * 64 + x) as usize]; 3]);
        let mssim = scores(&ramp, &noisy).mssim.unwrap();
        let ssim = ssim(&Pair::new(&ramp, &noisy).unwrap()).mean;
        assert!(mssim < 0.85 && 0.93 < ssim, "{mssim} {ssim}");
    }

    #[test]
    fn mssim_of_one_window_is_that_of_sums_in_place_of_means() {
        let golden = image(8, 8, |x, _| [(10 * x) as u8; 3]);
        let actual = image(8, 8, |_, y| [(10 * y) as u8; 3]);
        // The mean of both is 35, the sum of squares about it 64 * 525, and the
        // two gradients are at right angles, so their covariance is 0.
        let c2 = (0.03 * 255.0_f64).powi(2);
        let expected = c2 / (2.0 * 64.0 * 525.0 + c2);
        assert!((scores(&golden, &actual).mssim.unwrap() - expected).abs() < 1e-12);
    }

    #[test]
    fn one_change_scores_differently_where_it_straddles_windows() {
        let plain = image(16, 16, |x, y| [(8 * x + 4 * y) as u8; 3]);
        let dot = |from: u32| {
            image(16, 16, |x, y| {
                let inside = (from..from + 4).contains(&x) && (from..from + 4).contains(&y);
                if inside { [255; 3] } else { [(8 * x + 4 * y) as u8; 3] }
            })
        };
        let inside = scores(&plain, &dot(2)).mssim.unwrap();
        let across = scores(&plain, &dot(6)).mssim.unwrap();
        assert!(across < inside - 0.1, "{across} {inside}");
    }
}
