//! PNM files: PPM (`P3`, `P6`) and PGM (`P2`, `P5`) with codes up to 65535.
//!
//! Source: the manual pages ppm(5) and pgm(5) of Netpbm. Codes above 255 take two
//! bytes, the higher one first.

use super::stored::{Depth, Stored, checked_size};
use super::words::Words;

/// What such a file holds.
///
/// # Errors
/// Why it cannot be read, as the rest of a sentence: a bad header, a code above
/// the largest, bytes that lack or are too many.
pub(super) fn read(bytes: &[u8]) -> Result<Stored, String> {
    let kind = bytes.get(1).copied().unwrap_or_default();
    let (is_text, channels) =
        (matches!(kind, b'2' | b'3'), if matches!(kind, b'3' | b'6') { 3 } else { 1 });
    let mut words = Words::behind_magic(bytes, true);
    let size = checked_size(words.number("a width")?, words.number("a height")?)?;
    let max: u16 = words.number("the largest code, from 1 to 65535,")?;
    if max == 0 {
        return Err("expected the largest code, from 1 to 65535, found 0".to_owned());
    }
    let count = size.width as usize * size.height as usize * channels;
    let codes = if is_text { in_text(words, count)? } else { in_bytes(words.body(), max, count)? };
    if let Some(code) = codes.iter().find(|&&code| code > max) {
        return Err(format!("has the code {code}: expected at most {max}, as its header says"));
    }
    let values: Vec<f64> =
        codes.iter().flat_map(|&code| std::iter::repeat_n(f64::from(code), 3 / channels)).collect();
    Stored::new(size, &values, Depth::Codes { max })
}

fn in_text(mut words: Words<'_>, count: usize) -> Result<Vec<u16>, String> {
    // A number takes a byte and a blank: so no file makes more room than it fills.
    if count > words.rest().len() {
        return Err(format!("is cut short: expected {count} codes"));
    }
    let mut codes = Vec::with_capacity(count);
    for _ in 0..count {
        let word = words.next().ok_or_else(|| format!("is cut short: expected {count} codes"))?;
        let code = word.parse().map_err(|_| {
            format!("expected a code from 0 to 65535, found \"{}\"", scene::visible(word))
        })?;
        codes.push(code);
    }
    if words.next().is_some() {
        return Err("has something behind its end".to_owned());
    }
    Ok(codes)
}

fn in_bytes(body: &[u8], max: u16, count: usize) -> Result<Vec<u16>, String> {
    let width = if max > 255 { 2 } else { 1 };
    if body.len() != count * width {
        return Err(wrong_length(count * width, body.len()));
    }
    let code = |bytes: &[u8]| bytes.iter().fold(0_u16, |code, &b| code << 8 | u16::from(b));
    Ok(body.chunks_exact(width).map(code).collect())
}

/// What is said of too few or too many bytes.
pub(super) fn wrong_length(expected: usize, found: usize) -> String {
    let what = if found < expected { "is cut short" } else { "has something behind its end" };
    format!("{what}: expected {expected} bytes behind its header, found {found}")
}
