//! `Golden`: an accepted picture as a PNG file, with a note of the scene it
//! was accepted for.

use png::{BitDepth, ColorType, Compression, Decoder, Encoder, Limits, Transformations};
use serde::{Deserialize, Serialize};
use tracer::{Scene, Size};

use crate::encode::EncodedImage;

/// The keyword of the PNG text chunk that holds the provenance.
const KEYWORD: &str = "goldray";

/// The most memory that decoding may take beside the picture, in bytes.
const DECODER_BYTES: usize = 1 << 26;

/// Which scene a golden was accepted for: content hashes that survive renames
/// and squashed histories, and that no comment or space in the fixture changes.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Provenance {
    /// The version of this note.
    pub schema: u32,
    /// Hash of the parsed scene: everything in it but its `check`.
    pub scene: String,
    /// Hash of the files that the scene names, with their names.
    pub assets: String,
}

/// An accepted picture.
#[derive(Debug, Clone, PartialEq)]
pub struct Golden {
    /// The picture.
    pub picture: EncodedImage,
    /// Its note; `None` where the file has none, as after another program has
    /// saved it.
    pub provenance: Option<Provenance>,
}

/// The PNG file of a golden.
///
/// # Errors
/// What the encoder says.
pub fn to_png(picture: &EncodedImage, provenance: Option<&Provenance>) -> Result<Vec<u8>, String> {
    let Size { width, height } = picture.size();
    let mut bytes = Vec::new();
    let mut encoder = Encoder::new(&mut bytes, width, height);
    encoder.set_color(ColorType::Rgb);
    encoder.set_depth(BitDepth::Eight);
    encoder.set_compression(Compression::High);
    if let Some(provenance) = provenance {
        let note = serde_json::to_string(provenance).map_err(|error| error.to_string())?;
        encoder.add_text_chunk(KEYWORD.to_owned(), note).map_err(|error| error.to_string())?;
    }
    let mut writer = encoder.write_header().map_err(|error| error.to_string())?;
    writer.write_image_data(picture.bytes()).map_err(|error| error.to_string())?;
    writer.finish().map_err(|error| error.to_string())?;
    Ok(bytes)
}

/// Reads a PNG file as an 8-bit RGB picture. Gray and palette pictures are
/// taken as the colors they stand for.
///
/// # Errors
/// Why it is not such a picture: no PNG, cut short or damaged, 16 bits deep,
/// or partly transparent, none of which can be compared without losing
/// something.
pub fn from_png(bytes: &[u8]) -> Result<Golden, String> {
    if bytes.starts_with(b"version https://git-lfs") {
        return Err("is a Git LFS pointer, not the picture: run `git lfs pull`".to_owned());
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

    if frame.bit_depth != BitDepth::Eight {
        return Err("has 16 bits a channel: expected 8".to_owned());
    }
    let opaque = |channels: usize| pixels.chunks_exact(channels).all(|p| p[channels - 1] == 255);
    let transparent = || "is partly transparent: expected an opaque picture".to_owned();
    let rgb = match frame.color_type {
        ColorType::Rgb => pixels,
        ColorType::Rgba if opaque(4) => {
            pixels.as_chunks::<4>().0.iter().flat_map(|&[r, g, b, _]| [r, g, b]).collect()
        }
        ColorType::Grayscale => pixels.iter().flat_map(|&v| [v; 3]).collect(),
        ColorType::GrayscaleAlpha if opaque(2) => {
            pixels.as_chunks::<2>().0.iter().flat_map(|&[v, _]| [v; 3]).collect()
        }
        ColorType::Rgba | ColorType::GrayscaleAlpha => return Err(transparent()),
        ColorType::Indexed => return Err("has a palette that does not expand".to_owned()),
    };
    let size = Size { width: frame.width, height: frame.height };
    let picture = EncodedImage::from_bytes(size, rgb).ok_or("has a wrong count of pixels")?;
    let mut texts = reader.info().uncompressed_latin1_text.iter();
    let provenance = texts
        .find(|text| text.keyword == KEYWORD)
        .and_then(|text| serde_json::from_str(&text.text).ok());
    Ok(Golden { picture, provenance })
}

/// Whether the file is one PNG picture and nothing else: whole chunks up to the
/// end mark, no animation, one note at most.
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
            b"tEXt" if after[4..].starts_with(KEYWORD.as_bytes()) => notes += 1,
            b"IEND" if rest.len() > length.saturating_add(FRAME) => {
                return Err("has something behind its end".to_owned());
            }
            _ => {}
        }
        rest = rest.get(length.saturating_add(FRAME)..).unwrap_or_default();
    }
    if notes > 1 { Err(format!("has {notes} notes of its scene: expected one")) } else { Ok(()) }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn picture() -> EncodedImage {
        let size = Size { width: 40, height: 3 };
        EncodedImage::from_bytes(size, (0..=255).cycle().take(360).collect()).unwrap()
    }

    fn note() -> Provenance {
        Provenance { schema: 1, scene: "abc".into(), assets: "def".into() }
    }

    #[test]
    fn a_golden_comes_back_with_its_note() {
        for provenance in [None, Some(note())] {
            let bytes = to_png(&picture(), provenance.as_ref()).unwrap();
            assert_eq!(from_png(&bytes).unwrap(), Golden { picture: picture(), provenance });
        }
    }

    #[test]
    fn every_way_of_cutting_it_short_is_noticed() {
        let bytes = to_png(&picture(), Some(&note())).unwrap();
        for length in 0..bytes.len() {
            assert!(from_png(&bytes[..length]).is_err(), "{length} of {} bytes", bytes.len());
        }
    }

    #[test]
    fn a_file_that_is_more_than_one_picture_is_refused() {
        let error = |bytes: &[u8]| from_png(bytes).unwrap_err();
        let mut bytes = to_png(&picture(), Some(&note())).unwrap();
        let text_at = bytes.windows(4).position(|w| w == b"tEXt").unwrap() - 4;
        let length = u32::from_be_bytes(bytes[text_at..text_at + 4].try_into().unwrap()) as usize;
        let text = bytes[text_at..text_at + length + 12].to_vec();
        let twice = [&bytes[..text_at], &text, &bytes[text_at..]].concat();
        assert!(error(&twice).contains("2 notes"));
        bytes.push(0);
        assert!(error(&bytes).contains("behind its end"));
    }

    #[test]
    fn a_picture_too_large_to_be_one_is_refused_before_it_is_read() {
        let mut bytes = Vec::new();
        let mut encoder = Encoder::new(&mut bytes, 18_000, 18_000);
        encoder.set_color(ColorType::Grayscale);
        encoder.set_depth(BitDepth::One);
        let mut writer = encoder.write_header().unwrap();
        writer.write_image_data(&vec![0; 18_000 / 8 * 18_000]).unwrap();
        writer.finish().unwrap();
        assert!(from_png(&bytes).unwrap_err().contains("more pixels than any picture"));
    }

    #[test]
    fn what_would_lose_something_is_refused() {
        let encoded = |color, depth, data: &[u8]| {
            let mut bytes = Vec::new();
            let mut encoder = Encoder::new(&mut bytes, 1, 1);
            encoder.set_color(color);
            encoder.set_depth(depth);
            let mut writer = encoder.write_header().unwrap();
            writer.write_image_data(data).unwrap();
            writer.finish().unwrap();
            from_png(&bytes).map(|golden| golden.picture.bytes().to_vec())
        };
        let eight = BitDepth::Eight;
        assert_eq!(encoded(ColorType::Rgba, eight, &[1, 2, 3, 255]), Ok(vec![1, 2, 3]));
        assert_eq!(encoded(ColorType::Grayscale, eight, &[7]), Ok(vec![7; 3]));
        assert_eq!(encoded(ColorType::GrayscaleAlpha, eight, &[7, 255]), Ok(vec![7; 3]));
        assert!(encoded(ColorType::Rgba, eight, &[1, 2, 3, 254]).unwrap_err().contains("transp"));
        let deep = encoded(ColorType::Rgb, BitDepth::Sixteen, &[0; 6]);
        assert!(deep.unwrap_err().contains("16 bits"));
        let faint = encoded(ColorType::GrayscaleAlpha, eight, &[7, 254]);
        assert!(faint.unwrap_err().contains("transparent"));
        assert!(from_png(b"").is_err() && from_png(b"P6 1 1 255 abc").is_err());
        let pointer = from_png(b"version https://git-lfs.github.com/spec/v1\noid sha256:0\n");
        assert!(pointer.unwrap_err().contains("git lfs pull"));
    }
}
