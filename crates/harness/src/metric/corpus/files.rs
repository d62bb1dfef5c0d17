//! PNG files of a few pixels, as goldens might come to be.

use png::{BitDepth, ColorType, Encoder};
use tracer::{LinearImage, Rgb, Size};

use crate::encode::{EncodedImage, Transfer, encode};
use crate::golden::from_png;

/// What the harness reads from a PNG of one pixel with these bytes.
fn read(color: ColorType, depth: BitDepth, pixel: &[u8]) -> Result<EncodedImage, String> {
    let mut bytes = Vec::new();
    let mut encoder = Encoder::new(&mut bytes, 1, 1);
    encoder.set_color(color);
    encoder.set_depth(depth);
    let mut writer = encoder.write_header().map_err(|error| error.to_string())?;
    writer.write_image_data(pixel).map_err(|error| error.to_string())?;
    writer.finish().map_err(|error| error.to_string())?;
    from_png(&bytes).map(|golden| golden.picture)
}

/// The pixel of all these files.
pub(super) const PIXEL: [u8; 3] = [10, 20, 30];

/// A file with transparency, all of it opaque or not quite.
pub(super) fn with_alpha(alpha: u8) -> Result<EncodedImage, String> {
    let [r, g, b] = PIXEL;
    read(ColorType::Rgba, BitDepth::Eight, &[r, g, b, alpha])
}

/// A file of 16 bits a channel.
pub(super) fn sixteen_bits() -> Result<EncodedImage, String> {
    let [r, g, b] = PIXEL;
    read(ColorType::Rgb, BitDepth::Sixteen, &[r, r, g, g, b, b])
}

/// A file cut short.
pub(super) fn cut_short() -> Result<EncodedImage, String> {
    from_png(b"\x89PNG\r\n\x1a\n").map(|golden| golden.picture)
}

/// What becomes of a render with a NaN.
pub(super) fn not_a_number() -> Result<EncodedImage, String> {
    let nan = LinearImage::from_fn(Size { width: 2, height: 2 }, |x, y| {
        if (x, y) == (1, 1) { Rgb::from([0.0, f64::NAN, 0.0]) } else { Rgb::from([0.0; 3]) }
    });
    encode(&nan, Transfer::Srgb).map_err(|error| error.to_string())
}
