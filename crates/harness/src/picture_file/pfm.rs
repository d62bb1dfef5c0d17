//! PFM files: 32-bit floats, gray (`Pf`) or in color (`PF`).
//!
//! Source: the manual page pfm(5) of Netpbm. The lowest row comes first; a
//! negative scale says that the lowest byte of each number does as well.

use super::pnm::wrong_length;
use super::stored::{Depth, Stored, checked_size};
use super::words::Words;

/// What such a file holds.
///
/// # Errors
/// Why it cannot be read, as the rest of a sentence: a bad header, a scale other
/// than 1 and -1, of which programs differ what it means, bytes that lack or are
/// too many.
pub(super) fn read(bytes: &[u8]) -> Result<Stored, String> {
    let channels = if bytes.starts_with(b"PF") { 3 } else { 1 };
    let mut words = Words::behind_magic(bytes, false);
    let size = checked_size(words.number("a width")?, words.number("a height")?)?;
    let scale: f64 = words.number("a scale of 1 or -1")?;
    if scale.abs() != 1.0 {
        return Err(format!("expected a scale of 1 or -1 in its header, found {scale}"));
    }
    let body = words.body();
    let row = size.width as usize * channels;
    let length = row * size.height as usize * size_of::<f32>();
    if body.len() != length {
        return Err(wrong_length(length, body.len()));
    }
    let float = |bytes: &[u8; 4]| {
        f64::from(if scale < 0.0 { f32::from_le_bytes(*bytes) } else { f32::from_be_bytes(*bytes) })
    };
    let floats: Vec<f64> = body.as_chunks().0.iter().map(float).collect();
    let rows = floats.chunks_exact(row).rev();
    let values: Vec<f64> =
        rows.flatten().flat_map(|&value| std::iter::repeat_n(value, 3 / channels)).collect();
    Stored::new(size, &values, Depth::Single)
}
