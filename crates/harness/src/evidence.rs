//! `Evidence`: what there is to see of a picture that is not its golden.

use std::io::Write as _;

use flate2::Compression;
use flate2::write::ZlibEncoder;
use scene::Place;
use tracer::{LinearImage, Size, objects_seen};

use crate::encode::EncodedImage;
use crate::expectation::Rendered;
use crate::fixture::Fixture;
use crate::golden;
use crate::metric::{Pair, flip_map, ssim_map};

/// The pictures of a failure, small enough to be kept until a report is written.
#[derive(Debug, Clone, PartialEq)]
pub struct Evidence {
    /// Today's picture as a PNG file.
    pub actual: Vec<u8>,
    /// The maps of the comparison; `None` where the two cannot be compared or are
    /// the same.
    pub maps: Option<Maps>,
    /// The picture's linear values: red, green and blue of each pixel, row by row
    /// from the top, as little-endian `f32`, compressed as zlib does; `None` for
    /// pictures of more than [`Evidence::MAX_LINEAR_PIXELS`].
    pub linear: Option<Vec<u8>>,
    /// Which object each pixel shows.
    pub objects: ObjectMap,
}

/// Two metrics pixel by pixel, as PNG files of 8-bit gray.
#[derive(Debug, Clone, PartialEq)]
pub struct Maps {
    /// The score of the window around each pixel: white for alike, black for a
    /// score of 0 and below.
    pub ssim: Vec<u8>,
    /// The error seen at each pixel: black for none, white for 1.
    pub flip: Vec<u8>,
}

/// Which object each pixel shows in its middle.
#[derive(Debug, Clone, PartialEq)]
pub struct ObjectMap {
    /// The objects by number, and where each is written.
    pub places: Vec<Place>,
    /// For each pixel, row by row from the top, the object's number and 1, or 0
    /// for the background, as little-endian `u32`, compressed as zlib does.
    pub numbers: Vec<u8>,
}

impl Evidence {
    /// The most pixels whose linear values are kept, a million: they take twelve
    /// bytes each and compress badly.
    pub const MAX_LINEAR_PIXELS: usize = 1 << 20;

    /// What there is to see of today's picture, beside a golden if there is one.
    ///
    /// # Errors
    /// What the encoder of PNG files says.
    pub fn of(
        fixture: &Fixture,
        picture: &Rendered,
        golden: Option<&EncodedImage>,
    ) -> Result<Self, String> {
        let pair = golden.and_then(|golden| Pair::new(golden, &picture.encoded));
        let maps = pair.filter(|pair| !pair.is_identical()).map(|pair| maps(&pair)).transpose()?;
        let is_small = picture.linear.pixels().len() <= Self::MAX_LINEAR_PIXELS;
        Ok(Self {
            actual: golden::page_png(&picture.encoded)?,
            maps,
            linear: is_small.then(|| zlib(linear_bytes(&picture.linear))),
            objects: object_map(fixture),
        })
    }
}

fn maps(pair: &Pair<'_>) -> Result<Maps, String> {
    let (ssim, flip) = (ssim_map(pair), flip_map(pair));
    Ok(Maps { ssim: gray_png(ssim.size, &ssim.scores)?, flip: gray_png(flip.size, &flip.errors)? })
}

/// From 0, and all below, as black to 1 as white.
fn gray_png(size: Size, values: &[f64]) -> Result<Vec<u8>, String> {
    let code = |value: &f64| [(value.clamp(0.0, 1.0) * 255.0).round() as u8; 3];
    let gray = EncodedImage::from_bytes(size, values.iter().flat_map(code).collect());
    golden::page_png(&gray.ok_or("a map is not of the picture's size")?)
}

fn linear_bytes(linear: &LinearImage) -> impl Iterator<Item = u8> {
    let channels = linear.pixels().iter().flat_map(|pixel| [pixel.r, pixel.g, pixel.b]);
    channels.flat_map(|channel| (channel as f32).to_le_bytes())
}

fn object_map(fixture: &Fixture) -> ObjectMap {
    let number = |object: Option<tracer::ObjectId>| object.map_or(0, |object| object.0 + 1);
    let numbers = objects_seen(&fixture.scene).into_iter().map(number);
    ObjectMap { places: fixture.object_places(), numbers: zlib(numbers.flat_map(u32::to_le_bytes)) }
}

fn zlib(bytes: impl Iterator<Item = u8>) -> Vec<u8> {
    let mut encoder = ZlibEncoder::new(Vec::new(), Compression::default());
    let bytes: Vec<u8> = bytes.collect();
    // Memory takes whatever is written to it.
    let _ = encoder.write_all(&bytes);
    encoder.finish().unwrap_or_default()
}
