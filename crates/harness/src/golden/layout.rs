//! `Layout`: a picture's pixels as one of the color types of PNG holds them.

use std::collections::BTreeSet;

use png::{BitDepth, ColorType, DeflateCompression, Encoder, Filter};
use tracer::Size;

use super::KEYWORD;
use crate::encode::EncodedImage;

/// The best that `deflate` does.
const BEST: DeflateCompression = DeflateCompression::Level(9);

/// The most colors of a palette.
const MAX_COLORS: usize = 256;

/// Samples before they are filtered and compressed.
pub(super) struct Layout {
    color: ColorType,
    depth: BitDepth,
    palette: Option<Vec<u8>>,
    samples: Vec<u8>,
}

impl Layout {
    /// Three bytes a pixel, which holds any picture.
    pub(super) fn rgb(picture: &EncodedImage) -> Self {
        Self {
            color: ColorType::Rgb,
            depth: BitDepth::Eight,
            palette: None,
            samples: picture.bytes().to_vec(),
        }
    }

    /// Every layout that holds the picture and may be the smallest: gray and
    /// palette where they can, in as few bits as they can, and RGB.
    pub(super) fn all(picture: &EncodedImage) -> Vec<Self> {
        let mut layouts: Vec<_> =
            [Self::gray(picture), Self::palette(picture)].into_iter().flatten().collect();
        layouts.push(Self::rgb(picture));
        layouts
    }

    /// `None` where a pixel has a color.
    pub(super) fn gray(picture: &EncodedImage) -> Option<Self> {
        let gray = |&[r, g, b]: &[u8; 3]| (r == g && g == b).then_some(r);
        let values: Vec<u8> = picture.pixels().iter().map(gray).collect::<Option<_>>()?;
        // A depth holds the multiples of what its highest code stands for.
        let holds = |bits: u32| values.iter().all(|v| v.is_multiple_of(step(bits)));
        let bits = [1, 2, 4].into_iter().find(|&bits| holds(bits)).unwrap_or(8);
        let codes = values.iter().map(|v| v / step(bits));
        Some(Self {
            color: ColorType::Grayscale,
            depth: depth(bits),
            palette: None,
            samples: packed(picture.size(), bits, codes),
        })
    }

    /// `None` where there are too many colors. The palette is sorted.
    fn palette(picture: &EncodedImage) -> Option<Self> {
        let mut colors = BTreeSet::new();
        for pixel in picture.pixels() {
            colors.insert(*pixel);
            if colors.len() > MAX_COLORS {
                return None;
            }
        }
        let colors: Vec<_> = colors.into_iter().collect();
        let bits = [1, 2, 4].into_iter().find(|&bits| colors.len() <= 1 << bits).unwrap_or(8);
        let code = |pixel: &[u8; 3]| colors.binary_search(pixel).unwrap_or_default() as u8;
        Some(Self {
            color: ColorType::Indexed,
            depth: depth(bits),
            samples: packed(picture.size(), bits, picture.pixels().iter().map(code)),
            palette: Some(colors.concat()),
        })
    }

    /// The PNG file, with a note in a text chunk.
    pub(super) fn to_png(
        &self,
        Size { width, height }: Size,
        filter: Filter,
        note: Option<&str>,
    ) -> Result<Vec<u8>, String> {
        let mut bytes = Vec::new();
        let mut encoder = Encoder::new(&mut bytes, width, height);
        encoder.set_color(self.color);
        encoder.set_depth(self.depth);
        encoder.set_deflate_compression(BEST);
        encoder.set_filter(filter);
        if let Some(palette) = &self.palette {
            encoder.set_palette(palette);
        }
        let failed = |error: png::EncodingError| error.to_string();
        if let Some(note) = note {
            encoder.add_text_chunk(KEYWORD.to_owned(), note.to_owned()).map_err(failed)?;
        }
        let mut writer = encoder.write_header().map_err(failed)?;
        writer.write_image_data(&self.samples).map_err(failed)?;
        writer.finish().map_err(failed)?;
        Ok(bytes)
    }
}

/// What one step of a code of so many bits is, of 255.
fn step(bits: u32) -> u8 {
    match bits {
        1 => 255,
        2 => 85,
        4 => 17,
        _ => 1,
    }
}

fn depth(bits: u32) -> BitDepth {
    match bits {
        1 => BitDepth::One,
        2 => BitDepth::Two,
        4 => BitDepth::Four,
        _ => BitDepth::Eight,
    }
}

/// Codes of so many bits, the first in the highest bits of a byte; each row
/// starts at a byte.
fn packed(size: Size, bits: u32, codes: impl Iterator<Item = u8>) -> Vec<u8> {
    let per_byte = 8 / bits as usize;
    let codes: Vec<u8> = codes.collect();
    let byte = |codes: &[u8]| {
        let shifted = codes.iter().enumerate();
        shifted.fold(0, |byte, (i, code)| byte | code << (8 - bits as usize * (i + 1)))
    };
    let rows = codes.chunks(size.width.max(1) as usize);
    rows.flat_map(|row| row.chunks(per_byte)).map(byte).collect()
}
