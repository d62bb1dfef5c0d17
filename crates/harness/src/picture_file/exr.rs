//! EXR files whose channels are called R, G and B, in half or full precision.

use std::io::Cursor;

use image::{DynamicImage, ImageFormat, Rgb32FImage};
use tracer::{LinearImage, Size};

use super::stored::{Depth, Stored, checked_size};

/// What such a file holds. An alpha channel is not looked at: colors in these
/// files are multiplied by it.
///
/// # Errors
/// Why it cannot be read, as the rest of a sentence.
pub(super) fn read(bytes: &[u8]) -> Result<Stored, String> {
    let depth = depth(bytes)?;
    let mut reader = image::ImageReader::with_format(Cursor::new(bytes), ImageFormat::OpenExr);
    reader.limits(image::Limits::default());
    let picture = reader.decode().map_err(|error| format!("is not a readable EXR: {error}"))?;
    let picture = picture.into_rgb32f();
    let size = checked_size(picture.width(), picture.height())?;
    let values: Vec<f64> = picture.into_raw().into_iter().map(f64::from).collect();
    Stored::new(size, &values, depth)
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

/// How finely its colors are told apart: as the coarsest of R, G and B.
///
/// Source: "`OpenEXR` File Layout", sections "Header" and "Predefined attribute
/// types": attributes of a name, a type, a size and a value each; a list of
/// channels has for each its name, a type (1 is half, 2 float) and 12 bytes more.
fn depth(bytes: &[u8]) -> Result<Depth, String> {
    const MAGIC_AND_VERSION: usize = 8;
    const REST_OF_CHANNEL: usize = 12;
    const HALF: u32 = 1;
    let cut = || "is not a readable EXR: it ends inside its header".to_owned();
    let mut rest = bytes.get(MAGIC_AND_VERSION..).ok_or_else(cut)?;
    loop {
        let name = text(&mut rest).ok_or_else(cut)?;
        if name.is_empty() {
            return Err("is not a readable EXR: it says nothing of its channels".to_owned());
        }
        let kind = text(&mut rest).ok_or_else(cut)?;
        let length = number(&mut rest).ok_or_else(cut)? as usize;
        let (value, after) = rest.split_at_checked(length).ok_or_else(cut)?;
        rest = after;
        if (name, kind) != (b"channels", b"chlist") {
            continue;
        }
        let mut value = value;
        let mut depth = Depth::Single;
        while let Some(channel) = text(&mut value).filter(|name| !name.is_empty()) {
            let kind = number(&mut value).ok_or_else(cut)?;
            value = value.get(REST_OF_CHANNEL..).ok_or_else(cut)?;
            if matches!(channel, b"R" | b"G" | b"B") && kind == HALF {
                depth = Depth::Half;
            }
        }
        return Ok(depth);
    }
}

/// Takes a text that ends in a zero.
fn text<'a>(rest: &mut &'a [u8]) -> Option<&'a [u8]> {
    let end = rest.iter().position(|&byte| byte == 0)?;
    let found = &rest[..end];
    *rest = &rest[end + 1..];
    Some(found)
}

/// Takes a whole number.
fn number(rest: &mut &[u8]) -> Option<u32> {
    let (number, after) = rest.split_first_chunk::<4>()?;
    *rest = after;
    Some(u32::from_le_bytes(*number))
}
