//! What is seen of evidence on a page: goldray's picture, the renderer's, and where
//! they differ, as PNG files.

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD as BASE64;
use harness::encode::{EncodedImage, Transfer, encode};
use harness::golden::page_png;
use harness::picture::HEAT;
use tracer::LinearImage;

use crate::Evidence;
use crate::scale::Scale;

/// The color of edge pixels beyond the tolerance, which are no failure.
pub(crate) const EDGE: [u8; 3] = [64, 148, 232];

/// Each color of [`HEAT`] is for errors up to so many times those of the one before;
/// the first begins at the tolerance.
pub(crate) const STEP: f64 = 4.0;

/// A linear picture as people see it; `None` where a pixel is no number.
pub(crate) fn seen(linear: &LinearImage) -> Option<EncodedImage> {
    encode(linear, Transfer::Gamma22).ok()
}

/// A PNG file in base64; `None` where there is no picture.
pub(crate) fn base64(picture: Option<&EncodedImage>) -> Option<String> {
    Some(BASE64.encode(page_png(picture?).ok()?))
}

/// Where two pictures differ: the reference, dim and gray; interior pixels beyond the
/// tolerance in a color of [`HEAT`], by how far they are off; edge pixels beyond it in
/// [`EDGE`]. `None` for evidence of several sizes.
pub(crate) fn difference(evidence: &Evidence, tolerance: f64) -> Option<EncodedImage> {
    /// So much of the reference is seen.
    const DIMMED: u32 = 4;
    let size = evidence.reference.size();
    let count = evidence.reference.pixels().len();
    let lengths = [evidence.actual.pixels().len(), evidence.edges.len(), evidence.off.len()];
    if evidence.actual.size() != size || lengths != [count; 3] {
        return None;
    }
    let dim = seen(&evidence.reference);
    let scale = Scale::of(&evidence.reference);
    Some(EncodedImage::from_fn(size, |x, y| {
        let pixel = y as usize * size.width as usize + x as usize;
        if !evidence.off[pixel] {
            let codes = dim.as_ref().and_then(|dim| dim.get(x, y)).unwrap_or_default();
            let gray = codes.iter().map(|&code| u32::from(code)).sum::<u32>() / 3;
            return [(gray / DIMMED) as u8; 3];
        }
        if evidence.edges[pixel] {
            return EDGE;
        }
        let (a, b) = (evidence.reference.pixels()[pixel], evidence.actual.pixels()[pixel]);
        HEAT[heat(scale.error(a, b) / tolerance)]
    }))
}

/// Which color is for an error of so many tolerances.
fn heat(times: f64) -> usize {
    let mut bound = STEP;
    for color in 0..HEAT.len() - 1 {
        if times < bound {
            return color;
        }
        bound *= STEP;
    }
    HEAT.len() - 1
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::trial::judged;
    use tracer::Size;

    #[track_caller]
    fn check(times: f64, expected: usize) {
        assert_eq!(heat(times), expected, "{times}");
    }

    #[test]
    fn colors_are_warmer_for_more() {
        check(f64::NAN, 7);
        check(f64::INFINITY, 7);
        check(0.0, 0);
        check(3.9, 0);
        check(4.0, 1);
        check(15.0, 1);
        check(16.0, 2);
        check(1e9, 7);
    }

    #[test]
    fn what_is_off_is_seen_and_edges_apart() {
        let row = |values: &[f64]| {
            let pixels = values.iter().map(|&v| tracer::Rgb::new(v, 0.0, v)).collect();
            LinearImage::from_pixels(Size { width: values.len() as u32, height: 1 }, pixels)
        };
        let reference = row(&[1.0, 0.5, 0.5, 0.5, 0.5]).unwrap();
        let actual = row(&[1.0, 0.5 + 6e-6, 0.6, 0.6, f64::NAN]).unwrap();
        let mut evidence = judged(reference, actual, vec![false, false, false, true, false]);
        let picture = difference(&evidence, 1e-5).unwrap();
        // Two thirds of white, a quarter of it.
        let expected = [[42; 3], HEAT[0], HEAT[7], EDGE, HEAT[7]];
        assert_eq!(picture.pixels(), expected);
        assert!(seen(&evidence.actual).is_none() && seen(&evidence.reference).is_some());
        evidence.edges.pop();
        assert_eq!(difference(&evidence, 1e-5), None);
        assert_eq!(base64(None), None);
    }
}
