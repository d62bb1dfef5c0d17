//! `shift-right`, `shift-down`: the whole picture moved by a part of a pixel or
//! by some.

use super::{Defect, Place, Strengths, between, clamped, everywhere};
use crate::encode::EncodedImage;

pub(super) const ACROSS: Defect = Defect {
    name: "shift-right",
    does: "moves the picture to the right",
    unit: "pixels",
    strengths: STRENGTHS,
    visible: VISIBLE,
    places: everywhere,
    inject: |picture, _: Place, by| shifted(picture, by, |x, y, back| (x - back, y)),
};

pub(super) const DOWN: Defect = Defect {
    name: "shift-down",
    does: "moves the picture down",
    unit: "pixels",
    strengths: STRENGTHS,
    visible: VISIBLE,
    places: everywhere,
    inject: |picture, _: Place, by| shifted(picture, by, |x, y, back| (x, y - back)),
};

/// Below the weakest no edge from 0 to 255 changes a code.
const STRENGTHS: Strengths = Strengths { least: 1.0 / 512.0, most: 8.0, whole: false };

/// Half a pixel: what sampling at corners in place of middles does.
const VISIBLE: f64 = 0.5;

/// Between whole pixels the two neighbors are mixed; what moves in is the
/// outermost pixel.
fn shifted(
    picture: &EncodedImage,
    by: f64,
    back: impl Fn(i64, i64, i64) -> (i64, i64),
) -> EncodedImage {
    EncodedImage::from_fn(picture.size(), |x, y| {
        between(by, |by| {
            let (x, y) = back(x.into(), y.into(), by);
            clamped(picture, x, y)
        })
    })
}

#[cfg(test)]
mod tests {
    use tracer::Size;

    use super::*;

    #[track_caller]
    fn check(by: f64, expected: [u8; 4]) {
        let size = Size { width: 4, height: 1 };
        let picture = EncodedImage::from_fn(size, |x, _| [[0, 100, 200, 50][x as usize]; 3]);
        let moved = (ACROSS.inject)(&picture, Place::Whole, by);
        assert_eq!(moved.pixels(), expected.map(|v| [v; 3]));
        let upright =
            EncodedImage::from_bytes(Size { width: 1, height: 4 }, picture.bytes().into());
        let moved = (DOWN.inject)(&upright.unwrap(), Place::Whole, by);
        assert_eq!(moved.pixels(), expected.map(|v| [v; 3]));
    }

    #[test]
    fn parts_of_a_pixel_are_mixtures() {
        check(0.0, [0, 100, 200, 50]);
        check(0.25, [0, 75, 175, 88]);
        check(1.0, [0, 0, 100, 200]);
        check(1.5, [0, 0, 50, 150]);
        check(9.0, [0, 0, 0, 0]);
    }
}
