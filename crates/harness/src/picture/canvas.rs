//! `Canvas`: an 8-bit picture to put other pictures and words on.

use font8x8::legacy::BASIC_LEGACY;
use tracer::Size;

use crate::encode::EncodedImage;

/// Height and width of a letter in pixels.
pub(super) const LETTER: u32 = 8;

/// An 8-bit RGB picture in the making.
pub(super) struct Canvas {
    size: Size,
    pixels: Vec<[u8; 3]>,
}

impl Canvas {
    /// A canvas of one color.
    pub(super) fn new(size: Size, color: [u8; 3]) -> Self {
        Self { size, pixels: vec![color; size.width as usize * size.height as usize] }
    }

    /// Sets a pixel; nothing outside.
    pub(super) fn set(&mut self, x: u32, y: u32, color: [u8; 3]) {
        if x < self.size.width && y < self.size.height {
            self.pixels[y as usize * self.size.width as usize + x as usize] = color;
        }
    }

    /// Puts a picture with its upper left corner at `(left, top)`, each of its
    /// pixels as a square of this side.
    pub(super) fn put(&mut self, picture: &EncodedImage, left: u32, top: u32, side: u32) {
        let Size { width, height } = picture.size();
        for y in 0..height * side {
            for x in 0..width * side {
                if let Some(color) = picture.get(x / side, y / side) {
                    self.set(left + x, top + y, color);
                }
            }
        }
    }

    /// Writes a line of ASCII; what has no letter is left blank.
    pub(super) fn write(&mut self, text: &str, left: u32, top: u32, color: [u8; 3]) {
        for (i, letter) in (0_u32..).zip(text.chars()) {
            let rows = BASIC_LEGACY.get(letter as usize).copied().unwrap_or_default();
            for (y, row) in (0_u32..).zip(rows) {
                for x in (0..LETTER).filter(|x| row >> x & 1 == 1) {
                    self.set(left + i * LETTER + x, top + y, color);
                }
            }
        }
    }

    /// The finished picture.
    pub(super) fn finish(self) -> EncodedImage {
        EncodedImage::from_fn(self.size, |x, y| {
            self.pixels[y as usize * self.size.width as usize + x as usize]
        })
    }
}
