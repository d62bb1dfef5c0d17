//! What goldens' files keep, and which files are refused.

use png::{BitDepth, ColorType, Decoder, Encoder};
use tracer::Size;

use super::*;

fn picture() -> EncodedImage {
    let size = Size { width: 40, height: 3 };
    EncodedImage::from_bytes(size, (0..=255).cycle().take(360).collect()).unwrap()
}

fn note() -> Provenance {
    Provenance { schema: Provenance::SCHEMA, scene: "abc".into(), assets: "def".into() }
}

#[test]
fn a_golden_comes_back_with_its_note() {
    for provenance in [None, Some(note())] {
        let bytes = to_png(&picture(), provenance.as_ref()).unwrap();
        let golden = from_png(&bytes).unwrap();
        assert!(!golden.is_tampered());
        assert_eq!((golden.picture, golden.provenance), (picture(), provenance));
        assert_eq!(golden.file_bytes, bytes.len());
    }
}

/// A picture of this size whose pixels are made of their number.
fn of(width: u32, height: u32, pixel: impl Fn(u32) -> [u8; 3]) -> EncodedImage {
    EncodedImage::from_fn(Size { width, height }, |x, y| pixel(y * width + x))
}

/// Every layout and filter reads back as the picture; the smallest file has
/// this color type and depth.
#[track_caller]
fn check_smallest(picture: &EncodedImage, color: ColorType, depth: BitDepth) {
    for layout in Layout::all(picture) {
        for filter in [Filter::NoFilter, Filter::Paeth, Filter::Adaptive] {
            let png = layout.to_png(picture.size(), filter, None).unwrap();
            assert!(from_png(&png).unwrap().picture == *picture, "{filter:?}");
        }
    }
    let smallest = smallest_png(picture, &note()).unwrap();
    let golden = from_png(&smallest).unwrap();
    assert!(golden.picture == *picture && !golden.is_tampered());
    assert_eq!(golden.provenance, Some(note()));
    assert!(smallest.len() <= to_png(picture, Some(&note())).unwrap().len());
    assert_eq!(smallest, smallest_png(picture, &note()).unwrap(), "the same bytes each time");
    let reader = Decoder::new(std::io::Cursor::new(&smallest)).read_info().unwrap();
    assert_eq!((reader.info().color_type, reader.info().bit_depth), (color, depth));
}

#[test]
fn the_smallest_file_is_the_same_picture() {
    use BitDepth::{Eight, Four, One, Two};
    use ColorType::{Grayscale, Indexed, Rgb};
    // Numbers that no filter foresees.
    let noise = |i: u32| fastrand::Rng::with_seed(i.into()).u8(..);
    // Widths that end within a byte.
    for width in [1, 3, 7, 13] {
        let gray =
            |levels: u8| of(width, 90, move |i| [noise(i) % levels * (255 / (levels - 1)); 3]);
        check_smallest(&gray(2), Grayscale, One);
        check_smallest(&gray(4), Grayscale, Two);
        check_smallest(&gray(16), Grayscale, Four);
        let colors = |count: u8| of(width, 900, move |i| [noise(i) % count * 9, 7, 200]);
        check_smallest(&colors(2), Indexed, One);
        check_smallest(&colors(4), Indexed, Two);
        check_smallest(&colors(16), Indexed, Four);
    }
    let many = of(64, 64, |i| [noise(i) % 16 * 9, 7, noise(i + 5) % 8 * 9]);
    check_smallest(&many, Indexed, Eight);
    check_smallest(&of(64, 64, |i| [noise(i); 3]), Grayscale, Eight);
    check_smallest(&of(64, 64, |i| [noise(i), noise(i + 9), noise(i + 5)]), Rgb, Eight);
}

/// The text chunk of a golden's file: where it is, and its bytes.
fn text_chunk(bytes: &[u8]) -> std::ops::Range<usize> {
    let at = bytes.windows(4).position(|w| w == b"tEXt").unwrap() - 4;
    let length = u32::from_be_bytes(bytes[at..at + 4].try_into().unwrap()) as usize;
    at..at + length + 12
}

#[test]
fn a_picture_that_its_note_was_not_written_for_is_noticed() {
    let honest = to_png(&picture(), Some(&note())).unwrap();
    let other = to_png(&of(40, 3, |i| [i as u8; 3]), None).unwrap();
    // Behind the header of 25 bytes and the signature of 8.
    let text = &honest[text_chunk(&honest)];
    let doctored = from_png(&[&other[..33], text, &other[33..]].concat()).unwrap();
    assert_eq!(doctored.provenance, Some(note()));
    assert!(doctored.is_tampered());
}

#[test]
fn a_note_says_what_its_version_promises_or_is_none() {
    let provenance = |text: &str| Note::read(text).map(|note| note.provenance.schema);
    assert_eq!(provenance(r#"{"schema":1,"scene":"a","assets":"b"}"#), Some(1));
    assert_eq!(provenance(r#"{"schema":2,"scene":"a","assets":"b","picture":"c"}"#), Some(2));
    assert_eq!(provenance(r#"{"schema":2,"scene":"a","assets":"b"}"#), None);
    assert_eq!(provenance(r#"{"schema":2,"scene":"a","picture":"c"}"#), None);
    assert_eq!(provenance("{"), None);
    assert_eq!(provenance(r#"{"schema":3,"seen":"a"}"#), Some(3), "of which nothing is known");
    assert_eq!(provenance(r#"{"schema":0}"#), None);
    assert_eq!(provenance(r#"{"schema":"3"}"#), None);
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
    let text = text_chunk(&bytes);
    let twice = [&bytes[..text.end], &bytes[text.start..]].concat();
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
