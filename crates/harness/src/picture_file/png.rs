//! PNG files, 8 and 16 bits deep, as rows of red, green and blue.

use png::{BitDepth, ColorType, Decoder, Limits, Transformations};
use tracer::{Scene, Size};

use super::stored::{Depth, Stored};
use crate::lfs::pointer_problem;

/// The most memory that decoding may take beside the picture, in bytes.
const DECODER_BYTES: usize = 1 << 26;

/// A picture in a PNG file.
pub(crate) struct Decoded {
    pub(crate) size: Size,
    /// Bytes of a channel: 1, or 2 with the higher one first.
    pub(crate) width: usize,
    /// Three channels a pixel, row by row from the top.
    pub(crate) rgb: Vec<u8>,
    /// Its uncompressed texts, each after its keyword.
    pub(crate) texts: Vec<(String, String)>,
}

/// Reads a PNG file. Gray and palette pictures are taken as the colors they
/// stand for.
///
/// # Errors
/// Why it is no such picture, as the rest of a sentence: no PNG, cut short or
/// damaged, animated, too large, or partly transparent.
pub(crate) fn decode(bytes: &[u8]) -> Result<Decoded, String> {
    if let Some(problem) = pointer_problem(bytes, "picture") {
        return Err(problem);
    }
    check_chunks(bytes)?;
    let damaged = |error: png::DecodingError| format!("is not a readable PNG: {error}");
    let mut decoder =
        Decoder::new_with_limits(std::io::Cursor::new(bytes), Limits { bytes: DECODER_BYTES });
    decoder.set_transformations(Transformations::EXPAND);
    decoder.set_ignore_iccp_chunk(true);
    let mut reader = decoder.read_info().map_err(damaged)?;
    let Size { width, height } = Size { width: reader.info().width, height: reader.info().height };
    if u64::from(width) * u64::from(height) > Scene::MAX_PIXELS {
        return Err(format!("is {width} x {height}, more pixels than any picture here may have"));
    }
    let length = reader.output_buffer_size().ok_or("is too large to read")?;
    let mut pixels = vec![0; length];
    let frame = reader.next_frame(&mut pixels).map_err(damaged)?;
    // The rest of the file, its end mark included, must be there as well.
    reader.finish().map_err(damaged)?;
    pixels.truncate(frame.buffer_size());

    let width = if frame.bit_depth == BitDepth::Sixteen { 2 } else { 1 };
    let is_opaque = |channels: usize| {
        let mut pixels = pixels.chunks_exact(channels * width);
        pixels.all(|pixel| pixel[(channels - 1) * width..].iter().all(|&byte| byte == 255))
    };
    let rgb = match frame.color_type {
        ColorType::Rgb => pixels,
        ColorType::Rgba if is_opaque(4) => {
            pixels.chunks_exact(4 * width).flat_map(|p| p[..3 * width].to_vec()).collect()
        }
        ColorType::Grayscale => pixels.chunks_exact(width).flat_map(|v| v.repeat(3)).collect(),
        ColorType::GrayscaleAlpha if is_opaque(2) => {
            pixels.chunks_exact(2 * width).flat_map(|p| p[..width].repeat(3)).collect()
        }
        ColorType::Rgba | ColorType::GrayscaleAlpha => {
            return Err("is partly transparent: expected an opaque picture".to_owned());
        }
        ColorType::Indexed => return Err("has a palette that does not expand".to_owned()),
    };
    let size = Size { width: frame.width, height: frame.height };
    let texts = reader.info().uncompressed_latin1_text.iter();
    let texts = texts.map(|text| (text.keyword.clone(), text.text.clone())).collect();
    Ok(Decoded { size, width, rgb, texts })
}

/// What a PNG file holds.
///
/// # Errors
/// As [`decode`].
pub(super) fn read(bytes: &[u8]) -> Result<Stored, String> {
    let Decoded { size, width, rgb, .. } = decode(bytes)?;
    let code = |bytes: &[u8]| bytes.iter().fold(0_u16, |code, &b| code << 8 | u16::from(b));
    let values = rgb.chunks_exact(width).map(|bytes| f64::from(code(bytes)));
    let max = if width == 2 { u16::MAX } else { 255 };
    Stored::new(size, &values.collect::<Vec<_>>(), Depth::Codes { max })
}

/// Whether the file is one PNG picture and nothing else: whole chunks up to the
/// end mark, no animation, one note of goldray's at most.
fn check_chunks(bytes: &[u8]) -> Result<(), String> {
    const SIGNATURE: usize = 8;
    /// Length, type and checksum of a chunk.
    const FRAME: usize = 12;
    let mut rest = bytes.get(SIGNATURE..).unwrap_or_default();
    let mut notes = 0;
    while let Some((length, after)) = rest.split_first_chunk::<4>() {
        let length = u32::from_be_bytes(*length) as usize;
        let kind = after.get(..4).unwrap_or_default();
        match kind {
            b"acTL" => return Err("is animated: expected one picture".to_owned()),
            b"tEXt" if after[4..].starts_with(crate::golden::KEYWORD.as_bytes()) => notes += 1,
            b"IEND" if rest.len() > length.saturating_add(FRAME) => {
                return Err("has something behind its end".to_owned());
            }
            _ => {}
        }
        rest = rest.get(length.saturating_add(FRAME)..).unwrap_or_default();
    }
    if notes > 1 { Err(format!("has {notes} notes of its scene: expected one")) } else { Ok(()) }
}
