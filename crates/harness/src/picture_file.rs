//! `PictureFile`: a PNG or EXR picture from anywhere, and EXR output.

use std::io::Cursor;

use image::{DynamicImage, ImageFormat, Rgb32FImage};
use tracer::{LinearImage, Rgb, Size};

use crate::encode::{EncodedImage, Transfer, encode};
use crate::golden;
use crate::lfs::pointer_problem;

/// A picture read from a file.
#[derive(Debug, Clone, PartialEq)]
pub enum PictureFile {
    /// 8 bits a channel, as stored.
    Encoded(EncodedImage),
    /// Linear, as stored in 32-bit floats.
    Linear(LinearImage),
}

impl PictureFile {
    /// Reads a PNG or EXR file, told apart by their first bytes.
    ///
    /// # Errors
    /// Why it is neither, or cannot be compared, as the rest of a sentence.
    pub fn read(bytes: &[u8]) -> Result<Self, String> {
        const EXR: &[u8] = &[0x76, 0x2f, 0x31, 0x01];
        const PNG: &[u8] = &[0x89, b'P', b'N', b'G'];
        if bytes.starts_with(PNG) {
            return Ok(Self::Encoded(golden::from_png(bytes)?.picture));
        }
        if !bytes.starts_with(EXR) {
            let problem = pointer_problem(bytes, "picture");
            return Err(problem.unwrap_or_else(|| "is neither a PNG nor an EXR file".to_owned()));
        }
        let mut reader = image::ImageReader::with_format(Cursor::new(bytes), ImageFormat::OpenExr);
        reader.limits(image::Limits::default());
        let picture = reader.decode().map_err(|error| format!("is not a readable EXR: {error}"))?;
        let picture = picture.into_rgb32f();
        let size = Size { width: picture.width(), height: picture.height() };
        Ok(Self::Linear(LinearImage::from_fn(size, |x, y| {
            let [r, g, b] = picture.get_pixel(x, y).0.map(f64::from);
            Rgb::new(r, g, b)
        })))
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

/// The EXR file of a linear picture, in 32-bit floats.
///
/// # Errors
/// What the encoder says.
pub fn to_exr(picture: &LinearImage) -> Result<Vec<u8>, String> {
    let Size { width, height } = picture.size();
    let floats = Rgb32FImage::from_fn(width, height, |x, y| {
        let channels = picture.get(x, y).unwrap_or_default().channels();
        image::Rgb(channels.map(|c| c as f32))
    });
    let mut bytes = Cursor::new(Vec::new());
    DynamicImage::ImageRgb32F(floats)
        .write_to(&mut bytes, ImageFormat::OpenExr)
        .map_err(|error| error.to_string())?;
    Ok(bytes.into_inner())
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
mod tests {
    use super::*;

    #[test]
    fn a_linear_picture_survives_as_floats() {
        let size = Size { width: 5, height: 4 };
        let picture = LinearImage::from_fn(size, |x, y| {
            Rgb::new(f64::from(x) / 3.0, f64::from(y) * 1e3, -0.25)
        });
        let bytes = to_exr(&picture).unwrap();
        let PictureFile::Linear(read) = PictureFile::read(&bytes).unwrap() else {
            panic!("an EXR is linear")
        };
        let largest = linear_max_abs(&picture, &read).unwrap();
        assert!(largest < 1e-7, "{largest}");
    }

    #[test]
    fn nan_is_far_from_everything_but_nan() {
        let size = Size { width: 1, height: 1 };
        let pixel = |v: f64| LinearImage::from_fn(size, |_, _| Rgb::WHITE * v);
        assert_eq!(linear_max_abs(&pixel(f64::NAN), &pixel(f64::NAN)), Some(0.0));
        assert_eq!(linear_max_abs(&pixel(f64::NAN), &pixel(0.0)), Some(f64::INFINITY));
        assert_eq!(linear_max_abs(&pixel(3.0), &pixel(1.0)), Some(2.0));
        let wide = LinearImage::from_fn(Size { width: 2, height: 1 }, |_, _| Rgb::BLACK);
        assert_eq!(linear_max_abs(&pixel(3.0), &wide), None);
    }

    #[test]
    fn other_files_are_named() {
        assert_eq!(PictureFile::read(b"GIF89a"), Err("is neither a PNG nor an EXR file".into()));
        assert!(PictureFile::read(&[0x76, 0x2f, 0x31, 0x01, 0]).is_err());
    }
}
