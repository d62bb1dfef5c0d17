//! `Stored`: the numbers of a picture file as they are stored, with how finely
//! they are told apart.
//!
//! What they mean (which curve was applied, which row is on top) is not in most
//! files: that is for the caller to know.

use tracer::{Scene, Size};

use crate::lfs::pointer_problem;
use crate::picture_file::{exr, pfm, png, pnm};

/// How finely the numbers of a file are told apart.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Depth {
    /// Whole numbers from 0 to `max`, which stands for white.
    Codes {
        /// The largest.
        max: u16,
    },
    /// 16-bit floating point numbers.
    Half,
    /// 32-bit floating point numbers.
    Single,
}

/// A picture file's numbers.
#[derive(Debug, Clone, PartialEq)]
pub struct Stored {
    size: Size,
    values: Vec<[f64; 3]>,
    depth: Depth,
}

impl Stored {
    /// Reads a PNG, EXR, PFM or PNM file, told apart by their first bytes.
    ///
    /// # Errors
    /// Why it is none of them or cannot be read, as the rest of a sentence.
    pub fn read(bytes: &[u8]) -> Result<Self, String> {
        match bytes {
            [0x89, b'P', b'N', b'G', ..] => png::read(bytes),
            [0x76, 0x2f, 0x31, 0x01, ..] => exr::read(bytes),
            [b'P', b'F' | b'f', ..] => pfm::read(bytes),
            [b'P', b'2' | b'3' | b'5' | b'6', ..] => pnm::read(bytes),
            [] => Err("is empty".to_owned()),
            _ => Err(pointer_problem(bytes, "picture")
                .unwrap_or_else(|| "is neither a PNG nor an EXR, PFM or PPM file".to_owned())),
        }
    }

    /// A picture of numbers, three a pixel, row by row from the top.
    ///
    /// # Errors
    /// Their count is not three times width times height.
    pub(super) fn new(size: Size, values: &[f64], depth: Depth) -> Result<Self, String> {
        let pixels = u64::from(size.width) * u64::from(size.height);
        if values.len() as u64 != 3 * pixels {
            return Err("has a wrong count of pixels".to_owned());
        }
        Ok(Self { size, values: values.as_chunks().0.to_vec(), depth })
    }

    /// Width and height.
    pub fn size(&self) -> Size {
        self.size
    }

    /// Red, green and blue of each pixel, row by row from the top.
    pub fn values(&self) -> &[[f64; 3]] {
        &self.values
    }

    /// How finely they are told apart.
    pub fn depth(&self) -> Depth {
        self.depth
    }
}

/// The size that a header says.
///
/// # Errors
/// Nothing, or more than any picture here may have, as the rest of a sentence.
pub(super) fn checked_size(width: u32, height: u32) -> Result<Size, String> {
    if width == 0 || height == 0 {
        return Err(format!("is {width} x {height}: expected at least one pixel"));
    }
    if u64::from(width) * u64::from(height) > Scene::MAX_PIXELS {
        return Err(format!("is {width} x {height}, more pixels than any picture here may have"));
    }
    Ok(Size { width, height })
}
