//! `Distance`: how far a rendered picture is from somebody else's of the scene.

use std::fmt;

use crate::encode::Size;
use crate::expectation::{At, Rendered};
use crate::picture_file::PictureFile;

/// What may differ.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Allowed {
    /// The largest difference of a channel in pictures of 8 bits.
    pub codes: u8,
    /// In how many pixels of those.
    pub pixels: usize,
    /// The largest difference of a channel in linear pictures, absolute.
    pub linear: f64,
}

/// The difference of two pictures of one size.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Distance {
    /// The largest difference of a channel: in codes of 8 bits, or absolute.
    /// Infinite where one of two linear values is no number.
    pub largest: f64,
    /// Where it is.
    pub at: At,
    /// How many pixels differ at all.
    pub differing: usize,
    /// How many there are.
    pub pixels: usize,
    /// Whether they are compared before encoding.
    pub is_linear: bool,
}

impl Distance {
    /// The difference from a picture of another program: of the encoded pictures
    /// if it has 8 bits, of the linear ones otherwise.
    ///
    /// # Errors
    /// It has another size.
    pub fn of(rendered: &Rendered, reference: &PictureFile) -> Result<Self, String> {
        match reference {
            PictureFile::Encoded(reference) => {
                same_size(reference.size(), rendered.encoded.size())?;
                let pairs = rendered.encoded.pixels().iter().zip(reference.pixels());
                let of_pixel = |(a, b): (&[u8; 3], &[u8; 3])| {
                    let channels = a.iter().zip(b);
                    channels.map(|(a, b)| f64::from(a.abs_diff(*b))).fold(0.0, f64::max)
                };
                Ok(Self::over(reference.size(), false, pairs.map(of_pixel)))
            }
            PictureFile::Linear(reference) => {
                same_size(reference.size(), rendered.linear.size())?;
                let pairs = rendered.linear.pixels().iter().zip(reference.pixels());
                let of_pixel = |(a, b): (&tracer::Rgb, &tracer::Rgb)| {
                    let channels = a.channels().into_iter().zip(b.channels());
                    // A NaN is as far from anything as can be.
                    let far = |(a, b): (f64, f64)| {
                        let far = (a - b).abs();
                        if far.is_nan() { f64::INFINITY } else { far }
                    };
                    channels.map(far).fold(0.0, f64::max)
                };
                Ok(Self::over(reference.size(), true, pairs.map(of_pixel)))
            }
        }
    }

    fn over(size: Size, is_linear: bool, pixels: impl Iterator<Item = f64>) -> Self {
        let (mut largest, mut at, mut differing, mut count) = (0.0, (0, 0), 0, 0_u32);
        for difference in pixels {
            if difference > largest {
                (largest, at) = (difference, (count % size.width, count / size.width));
            }
            differing += usize::from(difference > 0.0);
            count += 1;
        }
        Self { largest, at, differing, pixels: count as usize, is_linear }
    }

    /// Whether it is no more than may be.
    pub fn is_within(&self, allowed: Allowed) -> bool {
        if self.is_linear {
            self.largest <= allowed.linear
        } else {
            self.largest <= f64::from(allowed.codes) && self.differing <= allowed.pixels
        }
    }
}

impl fmt::Display for Distance {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { largest, at: (x, y), differing, pixels, is_linear } = self;
        if *differing == 0 {
            return write!(f, "no difference in {pixels} pixels");
        }
        match is_linear {
            true => write!(f, "largest difference {largest:.2e} (linear) at ({x}, {y})")?,
            false => write!(f, "largest difference {largest}/255 at ({x}, {y})")?,
        }
        write!(f, ", {differing} of {pixels} pixels differ")
    }
}

fn same_size(expected: Size, found: Size) -> Result<(), String> {
    if expected == found {
        return Ok(());
    }
    let show = |size: Size| format!("{} x {}", size.width, size.height);
    Err(format!(
        "expected a picture of {} as the reference is, found {}",
        show(expected),
        show(found)
    ))
}

#[cfg(test)]
mod tests {
    use tracer::{LinearImage, Rgb};

    use super::*;
    use crate::encode::{EncodedImage, Transfer, encode};

    const SIZE: Size = Size { width: 3, height: 2 };

    fn rendered() -> Rendered {
        let linear = LinearImage::from_fn(SIZE, |x, y| Rgb::new(f64::from(x), f64::from(y), 0.5));
        let encoded = encode(&linear, Transfer::Gamma22).unwrap();
        Rendered { linear, encoded }
    }

    #[test]
    fn every_pixel_counts() {
        let rendered = rendered();
        let allowed = Allowed { codes: 1, pixels: 1, linear: 1e-3 };
        let encoded = |change: &dyn Fn(u32, u32, [u8; 3]) -> [u8; 3]| {
            let picture = EncodedImage::from_fn(SIZE, |x, y| {
                change(x, y, rendered.encoded.get(x, y).unwrap())
            });
            Distance::of(&rendered, &PictureFile::Encoded(picture)).unwrap()
        };
        let same = encoded(&|_, _, p| p);
        assert_eq!((same.largest, same.differing, same.is_within(allowed)), (0.0, 0, true));
        assert_eq!(same.to_string(), "no difference in 6 pixels");
        let one = encoded(&|x, y, [r, g, b]| [r, g, if (x, y) == (2, 1) { b - 1 } else { b }]);
        assert_eq!((one.largest, one.at, one.differing), (1.0, (2, 1), 1));
        assert!(one.is_within(allowed) && !one.is_within(Allowed { pixels: 0, ..allowed }));
        assert!(!one.is_within(Allowed { codes: 0, ..allowed }));
        assert_eq!(one.to_string(), "largest difference 1/255 at (2, 1), 1 of 6 pixels differ");
        let all = encoded(&|_, _, [r, g, b]| [r, g, b + 2]);
        assert_eq!((all.largest, all.differing, all.is_within(allowed)), (2.0, 6, false));
    }

    #[test]
    fn linear_pictures_are_compared_as_they_are() {
        let rendered = rendered();
        let linear = |by: f64| {
            let picture = LinearImage::from_fn(SIZE, |x, y| {
                let Rgb { r, g, b } = rendered.linear.get(x, y).unwrap();
                Rgb::new(r, g, if (x, y) == (1, 1) { b + by } else { b })
            });
            Distance::of(&rendered, &PictureFile::Linear(picture)).unwrap()
        };
        let allowed = Allowed { codes: 255, pixels: 6, linear: 0.25 };
        assert!(linear(0.25).is_within(allowed) && !linear(0.5).is_within(allowed));
        assert_eq!(linear(-0.5).at, (1, 1));
        assert_eq!(linear(f64::NAN).largest, f64::INFINITY);
        let expected = "largest difference 5.00e-1 (linear) at (1, 1), 1 of 6 pixels differ";
        assert_eq!(linear(0.5).to_string(), expected);
        let wide = LinearImage::from_fn(Size { width: 4, height: 2 }, |_, _| Rgb::BLACK);
        let why = Distance::of(&rendered, &PictureFile::Linear(wide)).unwrap_err();
        assert_eq!(why, "expected a picture of 4 x 2 as the reference is, found 3 x 2");
    }
}
