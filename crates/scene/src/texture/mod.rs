//! Texture files: bytes of a PNG to texels of linear values.

mod levels;
mod png;

use tracer::texture::Texels;

use crate::format::TexelEncoding;

/// Whether a file's name is one that a scene may name as a texture.
pub fn is_texture(path: &str) -> bool {
    check_ending(path).is_ok()
}

/// Whether a file's name is that of a texture.
///
/// # Errors
/// What is wrong, as the end of a sentence that starts with the file's name.
pub(crate) fn check_ending(path: &str) -> Result<(), String> {
    let ending = path.rsplit_once('.').map_or("", |(_, ending)| ending);
    if ending.eq_ignore_ascii_case("png") {
        return Ok(());
    }
    Err("is no PNG file by its name: expected one that ends in .png".to_owned())
}

/// Reads a texture whose codes are stored like this.
///
/// # Errors
/// What is wrong, as the end of a sentence that starts with the file's name.
pub(crate) fn read(bytes: &[u8], encoding: TexelEncoding) -> Result<Texels, String> {
    let png::Picture { size, codes, is_deep, clear_at } = png::read(bytes)?;
    if let Some((x, y)) = clear_at {
        return Err(format!(
            "is not opaque, first at ({x}, {y}) from its upper left: expected no alpha below 1"
        ));
    }
    let levels = levels::levels(encoding, if is_deep { u16::MAX } else { u8::MAX.into() });
    Texels::new(size, codes, levels).map_err(|refused| format!("makes no texture: {refused}"))
}

/// A PNG file with the same colors and no alpha, for formats that say it does not
/// count; `None` where the file has none below 1.
///
/// # Errors
/// Why the file is no texture, as the end of a sentence that starts with its name.
pub fn without_alpha(bytes: &[u8]) -> Result<Option<Vec<u8>>, String> {
    let picture = png::read(bytes)?;
    if picture.clear_at.is_none() {
        return Ok(None);
    }
    png::write(&picture).map(Some).map_err(|why| format!("cannot be written without alpha: {why}"))
}

/// A PNG file with the same colors and nothing else, and its width and height: three
/// channels of 8 or 16 bits, without alpha and what a file says about its own colors,
/// for programs that heed it or read gray and palettes otherwise.
///
/// # Errors
/// Why the file is no texture, as the end of a sentence that starts with its name.
pub fn as_rgb(bytes: &[u8]) -> Result<(Vec<u8>, [u32; 2]), String> {
    let picture = png::read(bytes)?;
    let written = png::write(&picture).map_err(|why| format!("cannot be written as RGB: {why}"))?;
    Ok((written, [picture.size.width, picture.size.height]))
}

#[cfg(test)]
mod tests;
