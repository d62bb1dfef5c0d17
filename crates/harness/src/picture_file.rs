//! `PictureFile`: a picture from anywhere that can be compared, and EXR output.
//!
//! To add a format: write its file, and add its first bytes to [`Stored::read`].

pub(crate) mod png;

mod exr;
mod pfm;
mod pnm;
mod stored;
mod words;

pub use exr::to_exr;
pub use stored::{Depth, Stored};
use tracer::{LinearImage, Rgb};

use crate::encode::{EncodedImage, Transfer, encode};

/// A picture read from a file.
#[derive(Debug, Clone, PartialEq)]
pub enum PictureFile {
    /// 8 bits a channel, as stored.
    Encoded(EncodedImage),
    /// Linear, as stored in floats.
    Linear(LinearImage),
}

impl PictureFile {
    /// Reads a PNG, EXR, PFM or PPM file, told apart by their first bytes.
    ///
    /// # Errors
    /// Why it is none, or cannot be compared, as the rest of a sentence.
    pub fn read(bytes: &[u8]) -> Result<Self, String> {
        let stored = Stored::read(bytes)?;
        let (size, values) = (stored.size(), stored.values());
        match stored.depth() {
            Depth::Codes { max: 255 } => {
                let codes = values.as_flattened().iter().map(|&code| code as u8).collect();
                let picture = EncodedImage::from_bytes(size, codes);
                Ok(Self::Encoded(picture.ok_or("has a wrong count of pixels")?))
            }
            Depth::Codes { max: u16::MAX } => Err("has 16 bits a channel: expected 8".to_owned()),
            Depth::Codes { max } => Err(format!("has codes up to {max}: expected 255")),
            Depth::Half | Depth::Single => {
                let pixels = values.iter().map(|&pixel| Rgb::from(pixel)).collect();
                let picture = LinearImage::from_pixels(size, pixels);
                Ok(Self::Linear(picture.ok_or("has a wrong count of pixels")?))
            }
        }
    }

    /// The 8-bit picture; a linear one is encoded.
    ///
    /// # Errors
    /// A picture with a NaN in it.
    pub fn encoded(&self, transfer: Transfer) -> Result<EncodedImage, String> {
        match self {
            Self::Encoded(picture) => Ok(picture.clone()),
            Self::Linear(picture) => encode(picture, transfer).map_err(|nan| nan.to_string()),
        }
    }
}

/// The largest absolute difference of two linear pictures in any channel;
/// `None` where their sizes differ. Infinite where one has a NaN and the other
/// not.
pub fn linear_max_abs(a: &LinearImage, b: &LinearImage) -> Option<f64> {
    let difference = |a: f64, b: f64| {
        if a == b || (a.is_nan() && b.is_nan()) {
            return 0.0;
        }
        let difference = (a - b).abs();
        if difference.is_nan() { f64::INFINITY } else { difference }
    };
    let of_pixels = |(a, b): (&Rgb, &Rgb)| {
        let channels = a.channels().into_iter().zip(b.channels());
        channels.map(|(a, b)| difference(a, b)).fold(0.0, f64::max)
    };
    (a.size() == b.size())
        .then(|| a.pixels().iter().zip(b.pixels()).map(of_pixels).fold(0.0, f64::max))
}

#[cfg(test)]
mod tests;
