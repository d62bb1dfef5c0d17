//! `EncodedImage`: the 8-bit picture that is stored, shown and compared.
//!
//! It is not radiance: it shares no operation with `tracer::LinearImage` and
//! cannot be compared with one by mistake.

use tracer::Size;

/// Red, green and blue codes from 0 to 255, row-major, top row first.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct EncodedImage {
    size: Size,
    bytes: Vec<u8>,
}

impl EncodedImage {
    /// A picture from its codes, three bytes a pixel, row by row from the top;
    /// `None` where their count is not three times width times height.
    pub fn from_bytes(size: Size, bytes: Vec<u8>) -> Option<Self> {
        let pixels = (size.width as usize).checked_mul(size.height as usize)?;
        (pixels.checked_mul(3)? == bytes.len()).then_some(Self { size, bytes })
    }

    /// A picture whose pixel at column `x` and row `y` (from the top) is
    /// `pixel(x, y)`.
    pub fn from_fn(size: Size, mut pixel: impl FnMut(u32, u32) -> [u8; 3]) -> Self {
        let rows = 0..size.height;
        let bytes = rows.flat_map(|y| (0..size.width).map(move |x| (x, y)));
        Self { size, bytes: bytes.flat_map(|(x, y)| pixel(x, y)).collect() }
    }

    /// A picture whose length is known to be right, because it was counted
    /// along the pixels of a `LinearImage` of this size.
    pub(super) fn from_linear_size(size: Size, bytes: Vec<u8>) -> Self {
        debug_assert_eq!(bytes.len(), size.width as usize * size.height as usize * 3);
        Self { size, bytes }
    }

    /// Width and height.
    pub fn size(&self) -> Size {
        self.size
    }

    /// All codes, three a pixel, row by row from the top.
    pub fn bytes(&self) -> &[u8] {
        &self.bytes
    }

    /// All pixels, row by row from the top.
    pub fn pixels(&self) -> &[[u8; 3]] {
        self.bytes.as_chunks().0
    }

    /// The pixel at column `x` from the left and row `y` from the top; `None`
    /// outside.
    pub fn get(&self, x: u32, y: u32) -> Option<[u8; 3]> {
        let Size { width, height } = self.size;
        (x < width && y < height).then(|| self.pixels()[y as usize * width as usize + x as usize])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(width: u32, height: u32, bytes: usize, is_picture: bool) {
        let made = EncodedImage::from_bytes(Size { width, height }, vec![0; bytes]);
        assert_eq!(made.is_some(), is_picture, "{width}x{height} of {bytes} bytes");
    }

    #[test]
    fn the_length_is_checked() {
        check(u32::MAX, u32::MAX, 3, false);
        check(1 << 31, 1 << 31, 0, false);
        check(0, 0, 3, false);
        check(0, 0, 0, true);
        check(2, 2, 4, false);
        check(2, 2, 11, false);
        check(2, 2, 13, false);
        check(2, 2, 12, true);
    }

    #[test]
    fn pixels_are_row_major_from_the_top() {
        let size = Size { width: 2, height: 2 };
        let image = EncodedImage::from_bytes(size, (0..12).collect()).unwrap();
        assert_eq!(image.get(0, 0), Some([0, 1, 2]));
        assert_eq!(image.get(1, 0), Some([3, 4, 5]));
        assert_eq!(image.get(0, 1), Some([6, 7, 8]));
        assert_eq!(image.get(2, 0), None);
        assert_eq!(image.get(0, 2), None);
        assert_eq!(image.pixels()[3], [9, 10, 11]);
    }
}
