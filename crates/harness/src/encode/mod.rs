//! From linear radiance to the 8-bit picture that is stored and compared.
//!
//! Every code is the exactly rounded one: it depends on the `f64` it is made
//! from and on nothing else, neither the platform nor its math library. A
//! picture that holds a NaN has no encoding and is refused.

mod encoded;
mod faulty;
#[cfg(test)]
mod proof;
mod thresholds;
mod transfer;

use std::error::Error;
use std::fmt;

use tracer::LinearImage;

pub use encoded::EncodedImage;
pub use tracer::Size;
pub use transfer::Transfer;

/// The 8-bit picture of `linear`, pixel by pixel through `transfer`.
///
/// Zero, negative values and minus infinity give code 0; one, greater values
/// and plus infinity give code 255.
///
/// # Errors
/// [`NotANumber`] where any channel of any pixel is NaN.
pub fn encode(linear: &LinearImage, transfer: Transfer) -> Result<EncodedImage, NotANumber> {
    let mut bytes = Vec::with_capacity(linear.pixels().len() * 3);
    for pixel in linear.pixels() {
        let channels = pixel.channels();
        if channels.iter().any(|c| c.is_nan()) {
            return Err(NotANumber::of(linear));
        }
        bytes.extend(faulty::codes(channels, transfer));
    }
    Ok(EncodedImage::from_linear_size(linear.size(), bytes))
}

/// Where a picture has NaN instead of radiance, so that it cannot be encoded.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct NotANumber {
    /// Column of the first NaN pixel, from the left.
    pub x: u32,
    /// Row of the first NaN pixel, from the top.
    pub y: u32,
    /// The first channel of that pixel that is NaN: `"red"`, `"green"` or `"blue"`.
    pub channel: &'static str,
    /// How many pixels have at least one NaN channel, this one included.
    pub count: u64,
}

impl NotANumber {
    /// Describes the NaN pixels of `linear`, which has at least one.
    fn of(linear: &LinearImage) -> Self {
        let mut found = Self { x: 0, y: 0, channel: "red", count: 0 };
        let width = linear.size().width as usize;
        for (i, pixel) in linear.pixels().iter().enumerate() {
            let named = [(pixel.r, "red"), (pixel.g, "green"), (pixel.b, "blue")];
            let Some((_, channel)) = named.into_iter().find(|(c, _)| c.is_nan()) else {
                continue;
            };
            if found.count == 0 {
                (found.x, found.y) = ((i % width) as u32, (i / width) as u32);
                found.channel = channel;
            }
            found.count += 1;
        }
        found
    }
}

impl fmt::Display for NotANumber {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { x, y, channel, count } = self;
        let pixels = if *count == 1 { "pixel" } else { "pixels" };
        write!(f, "{count} {pixels} with NaN; the first is ({x}, {y}), channel {channel}")
    }
}

impl Error for NotANumber {}

#[cfg(test)]
mod tests {
    use super::*;
    use tracer::{Rgb, Size};

    fn picture(width: u32, height: u32, pixels: &[[f64; 3]]) -> LinearImage {
        let pixels = pixels.iter().map(|&p| Rgb::from(p)).collect();
        LinearImage::from_pixels(Size { width, height }, pixels).unwrap()
    }

    #[track_caller]
    fn check(input: [f64; 3], expected: [u8; 3]) {
        let encoded = encode(&picture(1, 1, &[input]), Transfer::default()).unwrap();
        assert_eq!(encoded.get(0, 0), Some(expected), "{input:?}");
    }

    #[test]
    fn out_of_range_clamps() {
        check([f64::NEG_INFINITY, f64::INFINITY, -0.0], [0, 255, 0]);
        check([-1.0, 1e300, -1e-300], [0, 255, 0]);
        check([f64::MIN_POSITIVE, f64::MAX, 5e-324], [0, 255, 0]);
    }

    #[test]
    fn channels_stay_in_place() {
        check([0.0, 0.5, 1.0], [0, 186, 255]);
    }

    #[test]
    fn nan_is_refused_and_counted() {
        let n = f64::NAN;
        let black = [0.0; 3];
        let linear = picture(2, 3, &[black, black, black, [1.0, n, n], [-n; 3], [0.0, 0.0, n]]);
        let refused = encode(&linear, Transfer::Gamma22).unwrap_err();
        assert_eq!(refused, NotANumber { x: 1, y: 1, channel: "green", count: 3 });
        assert_eq!(refused.to_string(), "3 pixels with NaN; the first is (1, 1), channel green");
    }

    #[test]
    fn nan_in_the_last_channel_of_the_last_pixel_is_refused() {
        let linear = picture(2, 1, &[[0.0; 3], [0.0, 0.0, f64::NAN]]);
        let refused = encode(&linear, Transfer::Srgb).unwrap_err();
        assert_eq!(refused, NotANumber { x: 1, y: 0, channel: "blue", count: 1 });
    }

    #[test]
    fn an_empty_picture_encodes_to_an_empty_one() {
        let encoded = encode(&picture(0, 0, &[]), Transfer::Gamma22).unwrap();
        assert_eq!(encoded.bytes(), &[] as &[u8]);
    }
}
