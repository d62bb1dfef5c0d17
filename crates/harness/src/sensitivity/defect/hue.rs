//! `hue`: every color turned to another of the same luma.

use super::{Defect, Place, Strengths, code, everywhere};
use crate::encode::EncodedImage;

pub(super) const HUE: Defect = Defect {
    name: "hue",
    does: "turns every hue at equal luma",
    unit: "degrees",
    strengths: Strengths { least: 0.25, most: 180.0, whole: false },
    // People put the 85 caps of the Farnsworth-Munsell test in order, which are 4.2
    // degrees apart.
    visible: 5.0,
    places: everywhere,
    inject,
};

/// The weights of red and blue in luma, those of ITU-R BT.709; green has the
/// rest.
const RED: f64 = 0.2126;
const BLUE: f64 = 0.0722;

/// Turns the two color differences of BT.709 against each other. A color that
/// leaves the range is cut there, and its luma changes.
fn inject(picture: &EncodedImage, _: Place, degrees: f64) -> EncodedImage {
    let (sin, cos) = libm::sincos(degrees.to_radians());
    EncodedImage::from_fn(picture.size(), |x, y| {
        let [r, g, b] = picture.get(x, y).unwrap_or_default();
        if r == g && g == b {
            // Gray has no hue, and should not get one by rounding.
            return [r, g, b];
        }
        let [r, g, b] = [r, g, b].map(f64::from);
        let luma = RED * r + (1.0 - RED - BLUE) * g + BLUE * b;
        let [cb, cr] = [(b - luma) / (2.0 * (1.0 - BLUE)), (r - luma) / (2.0 * (1.0 - RED))];
        let [cb, cr] = [cos * cb - sin * cr, sin * cb + cos * cr];
        let [b, r] = [luma + 2.0 * (1.0 - BLUE) * cb, luma + 2.0 * (1.0 - RED) * cr];
        let g = (luma - RED * r - BLUE * b) / (1.0 - RED - BLUE);
        [r, g, b].map(code)
    })
}

#[cfg(test)]
mod tests {
    use tracer::Size;

    use super::*;

    fn turned(color: [u8; 3], degrees: f64) -> [u8; 3] {
        let picture = EncodedImage::from_fn(Size { width: 1, height: 1 }, |_, _| color);
        inject(&picture, Place::Whole, degrees).get(0, 0).unwrap()
    }

    #[test]
    fn luma_stays_and_gray_has_no_hue() {
        let luma = |[r, g, b]: [u8; 3]| {
            RED * f64::from(r) + (1.0 - RED - BLUE) * f64::from(g) + BLUE * f64::from(b)
        };
        for color in [[120, 100, 110], [90, 140, 100], [100, 110, 150]] {
            for degrees in [5.0, 60.0, 180.0] {
                let found = turned(color, degrees);
                assert!((luma(found) - luma(color)).abs() < 1.0, "{color:?} {degrees} {found:?}");
                assert_ne!(found, color, "{degrees}");
            }
            assert_eq!(turned(color, 0.0), color);
            assert_eq!(turned(color, 360.0), color);
        }
        assert_eq!(turned([77; 3], 90.0), [77; 3]);
    }
}
