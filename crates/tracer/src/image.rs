//! `LinearImage`: the picture a render returns, before any encoding.
//!
//! Row-major, top row first, three `f64` channels a pixel. It is not an
//! 8-bit picture and cannot be compared with one by mistake.

use crate::Rgb;

/// Width and height of a picture in pixels, each at least 1.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Size {
    /// Pixels in a row, the lecture's `nx`.
    pub width: u32,
    /// Rows, the lecture's `ny`.
    pub height: u32,
}

/// Linear radiance, row-major, top row first.
#[derive(Debug, Clone, PartialEq)]
pub struct LinearImage {
    size: Size,
    pixels: Vec<Rgb>,
}

impl LinearImage {
    /// A picture whose pixel at column `x` and row `y` (from the top) is
    /// `pixel(x, y)`.
    pub fn from_fn(size: Size, mut pixel: impl FnMut(u32, u32) -> Rgb) -> Self {
        let mut pixels = Vec::with_capacity(size.width as usize * size.height as usize);
        for y in 0..size.height {
            for x in 0..size.width {
                pixels.push(pixel(x, y));
            }
        }
        Self { size, pixels }
    }

    /// A picture from its rows; `None` where the count of pixels is not
    /// width times height.
    pub fn from_pixels(size: Size, pixels: Vec<Rgb>) -> Option<Self> {
        (pixels.len() == size.width as usize * size.height as usize)
            .then_some(Self { size, pixels })
    }

    /// Width and height.
    pub fn size(&self) -> Size {
        self.size
    }

    /// All pixels, row by row from the top.
    pub fn pixels(&self) -> &[Rgb] {
        &self.pixels
    }

    /// The pixel at column `x` from the left and row `y` from the top; `None`
    /// outside.
    pub fn get(&self, x: u32, y: u32) -> Option<Rgb> {
        (x < self.size.width && y < self.size.height)
            .then(|| self.pixels[y as usize * self.size.width as usize + x as usize])
    }
}
