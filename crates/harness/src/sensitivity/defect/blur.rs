//! `blur`: the whole picture seen through a Gaussian.

use tracer::Size;

use super::{Defect, Place, Strengths, code, everywhere};
use crate::encode::EncodedImage;

pub(super) const BLUR: Defect = Defect {
    name: "blur",
    does: "blurs the picture; sigma",
    unit: "pixels",
    // A narrower Gaussian has less than half a code of 255 beside its middle.
    strengths: Strengths { least: 0.25, most: 8.0, whole: false },
    // A neighbor then weighs a seventh of the middle, which softens every edge.
    visible: 0.5,
    places: everywhere,
    inject,
};

/// How far the Gaussian reaches, in sigmas: beyond it weighs less than a code.
const REACH: f64 = 3.5;

/// Along x and then along y; beyond the edges is the outermost pixel.
fn inject(picture: &EncodedImage, _: Place, sigma: f64) -> EncodedImage {
    let weights = weights(sigma);
    let Size { width, height } = picture.size();
    let (width, height) = (width as usize, height as usize);
    let channels: Vec<[f64; 3]> = picture.pixels().iter().map(|p| p.map(f64::from)).collect();
    let across =
        blurred(&channels, &weights, |i| (i - i % width.max(1), i % width.max(1), 1, width));
    let down = blurred(&across, &weights, |i| (i % width.max(1), i / width.max(1), width, height));
    let bytes = down.iter().flat_map(|pixel| pixel.map(code)).collect();
    EncodedImage::from_bytes(picture.size(), bytes).unwrap_or_else(|| picture.clone())
}

/// Each pixel as the weighted mean of those along its line. `line` says of a
/// pixel's number where its line starts, how far along it is, how far apart its
/// pixels are and how many there are.
fn blurred(
    pixels: &[[f64; 3]],
    weights: &[f64],
    line: impl Fn(usize) -> (usize, usize, usize, usize),
) -> Vec<[f64; 3]> {
    let one = |i: usize| {
        let (start, at, stride, count) = line(i);
        let pixel = |at: usize| pixels[start + at.min(count - 1) * stride];
        let mut sum = pixel(at).map(|c| weights[0] * c);
        for (distance, weight) in weights.iter().enumerate().skip(1) {
            let (before, after) = (pixel(at.saturating_sub(distance)), pixel(at + distance));
            sum = [0, 1, 2].map(|c| sum[c] + weight * (before[c] + after[c]));
        }
        sum
    };
    (0..pixels.len()).map(one).collect()
}

/// From the middle outwards; with each but the middle one counted twice they
/// sum to 1.
fn weights(sigma: f64) -> Vec<f64> {
    let reach = (REACH * sigma).ceil() as usize;
    let bell = |distance: usize| {
        let d = distance as f64 / sigma;
        libm::exp(-d * d / 2.0)
    };
    let half: Vec<f64> = (0..=reach).map(bell).collect();
    let total = half[0] + 2.0 * half[1..].iter().sum::<f64>();
    half.iter().map(|weight| weight / total).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_dot_becomes_a_bell_of_the_same_light() {
        let size = Size { width: 31, height: 21 };
        let dot = EncodedImage::from_fn(size, |x, y| [if (x, y) == (15, 10) { 255 } else { 0 }; 3]);
        let blurred = inject(&dot, Place::Whole, 0.5);
        let at = |x, y| blurred.get(x, y).unwrap()[0];
        // Weights 0.786, 0.106 along each axis.
        assert_eq!((at(15, 10), at(14, 10), at(15, 11), at(14, 9)), (158, 21, 21, 3));
        let light: u32 = blurred.pixels().iter().map(|p| u32::from(p[0])).sum();
        assert_eq!(light, 158 + 4 * 21 + 4 * 3);
    }

    #[test]
    fn a_flat_picture_stays_itself_up_to_its_edges() {
        let flat = EncodedImage::from_fn(Size { width: 5, height: 3 }, |_, _| [7, 200, 31]);
        for sigma in [0.1, 1.0, 8.0] {
            assert_eq!(inject(&flat, Place::Whole, sigma), flat);
        }
    }
}
