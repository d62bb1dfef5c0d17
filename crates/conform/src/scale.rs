//! `Scale`: what the errors of a picture's pixels are relative to.

use tracer::{LinearImage, Rgb};

/// What errors are relative to: a pixel's brightest channel, but for dark ones.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Scale {
    /// The least.
    floor: f64,
}

impl Scale {
    /// A pixel that is darker than this part of white, or of the picture's brightest
    /// channel where that is below white, is measured as if it were as bright: what
    /// is black has no relative error.
    const DARKEST: f64 = 0.01;

    /// That of a reference.
    pub(crate) fn of(picture: &LinearImage) -> Self {
        let brightest = picture.pixels().iter().map(|&pixel| brightest(pixel)).fold(0.0, f64::max);
        let white = if brightest > 0.0 { brightest.min(1.0) } else { 1.0 };
        Self { floor: Self::DARKEST * white }
    }

    /// What an error of this pixel is relative to.
    pub(crate) fn at(self, pixel: Rgb) -> f64 {
        brightest(pixel).max(self.floor)
    }

    /// The worst channel's distance, relative to the reference's pixel; NaN where one
    /// has a NaN, which is the worst that there is.
    pub(crate) fn error(self, reference: Rgb, actual: Rgb) -> f64 {
        let pairs = reference.channels().into_iter().zip(actual.channels());
        let distances = pairs.map(|(a, b)| (a - b).abs() / self.at(reference));
        distances.fold(0.0, |most, one| if one.is_nan() || one > most { one } else { most })
    }
}

/// The largest channel, whatever its sign.
fn brightest(pixel: Rgb) -> f64 {
    pixel.channels().into_iter().fold(0.0, |most, c| most.max(c.abs()))
}
