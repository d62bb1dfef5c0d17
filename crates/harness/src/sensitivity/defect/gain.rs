//! `gain`: the whole picture darker than it should be.

use super::{Defect, Place, Strengths, code, everywhere};
use crate::encode::EncodedImage;

pub(super) const GAIN: Defect = Defect {
    name: "gain",
    does: "multiplies every code by less than 1",
    unit: "%",
    // Half a code of white, and black.
    strengths: Strengths { least: 0.2, most: 100.0, whole: false },
    // 5 codes of white, and 4.3 % of its light: more than twice the 1 to 2 % at
    // which neighboring areas begin to look different.
    visible: 2.0,
    places: everywhere,
    inject,
};

/// Darker, as a white that is lighter cannot be stored.
fn inject(picture: &EncodedImage, _: Place, percent: f64) -> EncodedImage {
    let factor = 1.0 - percent / 100.0;
    EncodedImage::from_fn(picture.size(), |x, y| {
        picture.get(x, y).unwrap_or_default().map(|c| code(factor * f64::from(c)))
    })
}

#[cfg(test)]
mod tests {
    use tracer::Size;

    use super::*;

    #[test]
    fn it_is_in_percent_of_the_code() {
        let picture = EncodedImage::from_fn(Size { width: 1, height: 1 }, |_, _| [0, 100, 255]);
        let gained = |percent: f64| inject(&picture, Place::Whole, percent).get(0, 0);
        assert_eq!(gained(2.0), Some([0, 98, 250]));
        assert_eq!(gained(0.1), Some([0, 100, 255]));
        assert_eq!(gained(100.0), Some([0; 3]));
    }
}
