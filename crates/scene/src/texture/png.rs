//! PNG files as texels: 8 or 16 bits, gray, colors or a palette, opaque.

use std::io::Cursor;

use png::{
    BitDepth, ColorType, Decoder, DecodingError, Encoder, EncodingError, Limits, Transformations,
};
use tracer::Size;
use tracer::texture::Texels;

/// What reading a file may take beside its texels, in bytes.
const DECODER_BYTES: usize = 16 << 20;

/// The codes of a picture, row by row from the top.
pub(super) struct Picture {
    pub(super) size: Size,
    pub(super) codes: Vec<[u16; 3]>,
    /// Whether they go to 65535 and not to 255.
    pub(super) is_deep: bool,
    /// Where the first texel is that is not opaque, from the upper left.
    pub(super) clear_at: Option<(usize, usize)>,
}

/// Gray is taken as three equal channels, a palette as the colors it stands
/// for, and fewer than 8 bits as the codes of 8 that they stand for. What the file
/// says about its own colors (`gAMA`, `iCCP` and so on) is not read: the scene
/// says it.
///
/// # Errors
/// No PNG, one that is damaged, too large or animated.
pub(super) fn read(bytes: &[u8]) -> Result<Picture, String> {
    let damaged = |error: DecodingError| format!("is not a readable PNG file: {error}");
    let limits = Limits { bytes: DECODER_BYTES };
    let mut decoder = Decoder::new_with_limits(Cursor::new(bytes), limits);
    decoder.set_transformations(Transformations::EXPAND);
    decoder.set_ignore_iccp_chunk(true);
    let mut reader = decoder.read_info().map_err(damaged)?;
    if reader.info().is_animated() {
        return Err("is animated: expected one picture".to_owned());
    }
    let Size { width, height } = Size { width: reader.info().width, height: reader.info().height };
    // Before anything is made of it.
    if width.max(height) > Texels::MAX_SIDE
        || u64::from(width) * u64::from(height) > Texels::MAX_TEXELS
    {
        return Err(format!(
            "is {width} x {height}: expected a texture of at most {} texels a side and {} in all",
            Texels::MAX_SIDE,
            Texels::MAX_TEXELS
        ));
    }
    let length = reader.output_buffer_size().ok_or("is too large to read")?;
    let mut pixels = vec![0; length];
    let frame = reader.next_frame(&mut pixels).map_err(damaged)?;
    // The rest of the file, its end mark included, must be there as well.
    reader.finish().map_err(damaged)?;
    pixels.truncate(frame.buffer_size());

    let is_deep = frame.bit_depth == BitDepth::Sixteen;
    let channels = frame.color_type.samples();
    let codes: Vec<u16> = if is_deep {
        pixels.as_chunks::<2>().0.iter().map(|&pair| u16::from_be_bytes(pair)).collect()
    } else {
        pixels.iter().map(|&byte| byte.into()).collect()
    };
    let texels = codes.chunks_exact(channels);
    let opaque = if is_deep { u16::MAX } else { u8::MAX.into() };
    let clear_at = match frame.color_type {
        ColorType::Rgba | ColorType::GrayscaleAlpha => texels
            .clone()
            .position(|texel| texel[channels - 1] != opaque)
            .map(|i| (i % width as usize, i / width as usize)),
        _ => None,
    };
    let color = |texel: &[u16]| match *texel {
        [r, g, b] | [r, g, b, _] => [r, g, b],
        _ => [texel[0]; 3],
    };
    let codes = texels.map(color).collect();
    Ok(Picture { size: Size { width, height }, codes, is_deep, clear_at })
}

/// The same colors as a PNG file without alpha.
///
/// # Errors
/// What the encoder says.
pub(super) fn write(picture: &Picture) -> Result<Vec<u8>, EncodingError> {
    let Picture { size, codes, is_deep, .. } = picture;
    let mut file = Vec::new();
    let mut encoder = Encoder::new(&mut file, size.width, size.height);
    encoder.set_color(ColorType::Rgb);
    encoder.set_depth(if *is_deep { BitDepth::Sixteen } else { BitDepth::Eight });
    let all = codes.as_flattened().iter().flat_map(|code| code.to_be_bytes());
    // Of codes up to 255 the upper byte is 0.
    let data: Vec<u8> =
        all.skip(usize::from(!is_deep)).step_by(if *is_deep { 1 } else { 2 }).collect();
    let mut writer = encoder.write_header()?;
    writer.write_image_data(&data)?;
    writer.finish()?;
    Ok(file)
}
