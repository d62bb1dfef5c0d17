//! Files that are read, and files that are not: each says why.

use std::io::Cursor;

use image::{DynamicImage, ImageFormat, Rgb32FImage};
use tracer::Size;

use super::*;

/// Chunks and their checksums by the encoder itself.
fn png(size: (u32, u32), kind: ::png::ColorType, depth: ::png::BitDepth, data: &[u8]) -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut encoder = ::png::Encoder::new(&mut bytes, size.0, size.1);
    encoder.set_color(kind);
    encoder.set_depth(depth);
    encoder.write_header().unwrap().write_image_data(data).unwrap();
    bytes
}

#[track_caller]
fn check(bytes: &[u8], depth: Depth, expected: &[[f64; 3]]) {
    let stored = Stored::read(bytes).unwrap();
    assert_eq!((stored.depth(), stored.values()), (depth, expected));
}

#[track_caller]
fn refused(bytes: &[u8], why: &str) {
    let found = Stored::read(bytes).map(|stored| stored.size()).unwrap_err();
    assert!(found.contains(why), "expected {why:?}, found {found:?}");
}

/// An EXR file of 32-bit floats.
fn exr(size: Size, value: impl Fn(u32, u32) -> f32) -> Vec<u8> {
    let picture =
        Rgb32FImage::from_fn(size.width, size.height, |x, y| image::Rgb([value(x, y); 3]));
    let mut bytes = Cursor::new(Vec::new());
    DynamicImage::ImageRgb32F(picture).write_to(&mut bytes, ImageFormat::OpenExr).unwrap();
    bytes.into_inner()
}

const EIGHT: Depth = Depth::Codes { max: 255 };
const SIXTEEN: Depth = Depth::Codes { max: 65_535 };

#[test]
fn png_files_of_all_kinds() {
    use ::png::BitDepth::{Eight, Sixteen};
    use ::png::ColorType::{Grayscale, GrayscaleAlpha, Rgb, Rgba};
    check(
        &png((2, 1), Rgb, Eight, &[1, 2, 3, 4, 5, 6]),
        EIGHT,
        &[[1.0, 2.0, 3.0], [4.0, 5.0, 6.0]],
    );
    check(&png((1, 2), Grayscale, Eight, &[7, 8]), EIGHT, &[[7.0; 3], [8.0; 3]]);
    check(&png((1, 1), Rgba, Eight, &[1, 2, 3, 255]), EIGHT, &[[1.0, 2.0, 3.0]]);
    check(&png((1, 1), GrayscaleAlpha, Eight, &[9, 255]), EIGHT, &[[9.0; 3]]);
    let wide = [1, 2, 3, 4, 5, 6, 255, 255];
    check(&png((1, 1), Rgb, Sixteen, &wide[..6]), SIXTEEN, &[[258.0, 772.0, 1286.0]]);
    check(&png((1, 1), Rgba, Sixteen, &wide), SIXTEEN, &[[258.0, 772.0, 1286.0]]);
    check(&png((1, 1), Grayscale, Sixteen, &wide[..2]), SIXTEEN, &[[258.0; 3]]);
    check(&png((1, 1), GrayscaleAlpha, Sixteen, &[1, 2, 255, 255]), SIXTEEN, &[[258.0; 3]]);
    refused(&png((1, 1), Rgba, Eight, &[1, 2, 3, 254]), "transparent");
    refused(&png((1, 1), Rgba, Sixteen, &[1, 2, 3, 4, 5, 6, 255, 254]), "transparent");
}

#[test]
fn exr_files_in_full_and_half_precision() {
    let size = Size { width: 2, height: 1 };
    let file = exr(size, |x, _| x as f32 + 0.1);
    check(&file, Depth::Single, &[[f64::from(0.1_f32); 3], [f64::from(1.1_f32); 3]]);
    check(&exr(size, |_, _| f32::INFINITY), Depth::Single, &[[f64::INFINITY; 3]; 2]);
    // The same by hand, in halves, uncompressed: 1, 0.5 and 0.25.
    let mut half = vec![0x76, 0x2f, 0x31, 0x01, 2, 0, 0, 0];
    let mut attribute = |name: &str, kind: &str, value: &[u8]| {
        for word in [name, kind] {
            half.extend(word.as_bytes());
            half.push(0);
        }
        half.extend((value.len() as u32).to_le_bytes());
        half.extend(value);
    };
    let channel =
        |name: u8| [&[name, 0][..], &[1, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0]].concat();
    attribute(
        "channels",
        "chlist",
        &[channel(b'B'), channel(b'G'), channel(b'R'), vec![0]].concat(),
    );
    attribute("compression", "compression", &[0]);
    let window = [0_i32; 4].map(i32::to_le_bytes).concat();
    attribute("dataWindow", "box2i", &window);
    attribute("displayWindow", "box2i", &window);
    attribute("lineOrder", "lineOrder", &[0]);
    attribute("pixelAspectRatio", "float", &1.0_f32.to_le_bytes());
    attribute("screenWindowCenter", "v2f", &[0; 8]);
    attribute("screenWindowWidth", "float", &1.0_f32.to_le_bytes());
    half.push(0);
    half.extend((half.len() as u64 + 8).to_le_bytes());
    half.extend([0, 0, 0, 0, 6, 0, 0, 0, 0x00, 0x34, 0x00, 0x38, 0x00, 0x3c]);
    check(&half, Depth::Half, &[[1.0, 0.5, 0.25]]);
}

#[test]
fn pfm_files_are_from_the_bottom_up() {
    let floats = |values: &[f32], to: fn(f32) -> [u8; 4]| {
        values.iter().flat_map(|&v| to(v)).collect::<Vec<_>>()
    };
    let file = |head: &str, body: Vec<u8>| [head.as_bytes(), &body].concat();
    let gray = [[3.0; 3], [4.0; 3], [1.0; 3], [2.0; 3]];
    let body = [1.0, 2.0, 3.0, 4.0];
    check(&file("Pf\n2 2\n-1\n", floats(&body, f32::to_le_bytes)), Depth::Single, &gray);
    check(&file("Pf 2 2 1.0\n", floats(&body, f32::to_be_bytes)), Depth::Single, &gray);
    let color = file("PF\n1 1\n-1.0\n", floats(&[0.5, f32::MAX, -2.0], f32::to_le_bytes));
    check(&color, Depth::Single, &[[0.5, f64::from(f32::MAX), -2.0]]);
    refused(&color[..color.len() - 1], "cut short: expected 12 bytes");
    refused(&[&color[..], b"\n"].concat(), "behind its end");
    refused(b"PF\n1 1\n0.5\n", "scale of 1 or -1");
    refused(b"PF\n1 1\nNaN\n", "scale of 1 or -1");
    refused(b"PF\n60000 60000\n-1\n", "more pixels");
    refused(b"PF\n0 1\n-1\n", "at least one pixel");
    refused(b"PF\n1 x\n-1\n", "a height in its header, found \"x\"");
    refused(b"PF", "a width in its header, found nothing");
}

#[test]
fn pnm_files_in_text_and_bytes() {
    check(b"P6 1 1 255\n\x01\x02\x03", EIGHT, &[[1.0, 2.0, 3.0]]);
    check(
        b"P6\n# by hand\n1 1\n65535\n\x01\x02\x03\x04\x05\x06",
        SIXTEEN,
        &[[258.0, 772.0, 1286.0]],
    );
    check(
        b"P3 1 2 # two\n 100 1 2 3\n4 5 6",
        Depth::Codes { max: 100 },
        &[[1.0, 2.0, 3.0], [4.0, 5.0, 6.0]],
    );
    check(b"P5 2 1 255 \x07\x08", EIGHT, &[[7.0; 3], [8.0; 3]]);
    check(b"P2 1 1 9\n9\n", Depth::Codes { max: 9 }, &[[9.0; 3]]);
    refused(b"P6 1 1 255\n\x01\x02", "cut short: expected 3 bytes behind its header, found 2");
    refused(b"P6 1 1 255\n\x01\x02\x03\x04", "behind its end");
    refused(b"P6 1 1 100\n\x01\x02\xc8", "the code 200: expected at most 100");
    refused(b"P3 1 1 255 1 2", "cut short");
    refused(b"P3 1 1 255 1 2 3 4", "behind its end");
    refused(b"P3 1 1 255 1 2 -3", "found \"-3\"");
    refused(b"P3 8000 8000 255 1 2 3", "cut short");
    refused(b"P6 1 1 0 ", "largest code");
    refused(b"P6 1 1 65536 ", "largest code");
    refused(b"P6 4294967295 4294967295 255 ", "more pixels");
    refused(b"P6 99999999999999999999 1 255 ", "a width");
}

#[test]
fn absurd_sizes_and_garbage_are_said() {
    use ::png::{BitDepth, ColorType};
    let small = png((1, 1), ColorType::Rgb, BitDepth::Eight, &[1, 2, 3]);
    // The width and height of its header; the checksum is mended as well, so that
    // it is the size that is refused.
    let mut large = small.clone();
    let sixty_thousand = 60_000_u32.to_be_bytes();
    large[16..20].copy_from_slice(&sixty_thousand);
    large[20..24].copy_from_slice(&sixty_thousand);
    let sum = crc(&large[12..29]).to_be_bytes();
    large[29..33].copy_from_slice(&sum);
    refused(&large, "is 60000 x 60000, more pixels");
    refused(&small[..small.len() - 13], "is not a readable PNG");
    refused(b"", "is empty");
    refused(b"GIF89a", "is neither a PNG nor an EXR, PFM or PPM file");
    refused(&[0x76, 0x2f, 0x31, 0x01], "ends inside its header");
    refused(&[0x76, 0x2f, 0x31, 0x01, 2, 0, 0, 0, 0], "says nothing of its channels");
    let size = Size { width: 3, height: 2 };
    let mut far = exr(size, |_, _| 1.0);
    let at = far.windows(11).position(|name| name == b"dataWindow\0").unwrap() + 11 + 6 + 4;
    for corner in [8, 12] {
        far[at + corner..at + corner + 4].copy_from_slice(&59_999_i32.to_le_bytes());
    }
    refused(&far, "is not a readable EXR");
}

/// The checksum of PNG's chunks, by its specification.
fn crc(bytes: &[u8]) -> u32 {
    !bytes.iter().fold(!0, |sum: u32, &byte| {
        (0..8).fold(sum ^ u32::from(byte), |sum, _| {
            if sum & 1 == 1 { 0xedb8_8320 ^ (sum >> 1) } else { sum >> 1 }
        })
    })
}

#[test]
fn no_damage_to_a_file_makes_a_panic() {
    use ::png::{BitDepth, ColorType};
    let size = Size { width: 3, height: 2 };
    let files = [
        exr(size, |x, y| (x + y) as f32),
        png((2, 2), ColorType::Rgb, BitDepth::Sixteen, &[7; 24]),
        b"P3 1 2 # two\n 100 1 2 3\n4 5 6".to_vec(),
        b"PF\n1 1\n-1.0\n123456789012".to_vec(),
    ];
    for file in files {
        for cut in 0..file.len() {
            let _ = Stored::read(&file[..cut]);
        }
        for at in 0..file.len() {
            for change in [1, 0x80, 0xff] {
                let mut damaged = file.clone();
                damaged[at] ^= change;
                let _ = Stored::read(&damaged);
            }
        }
    }
}

#[test]
fn a_linear_picture_survives_as_floats() {
    let size = Size { width: 5, height: 4 };
    let picture =
        LinearImage::from_fn(size, |x, y| Rgb::new(f64::from(x) / 3.0, f64::from(y) * 1e3, -0.25));
    let bytes = to_exr(&picture).unwrap();
    let PictureFile::Linear(read) = PictureFile::read(&bytes).unwrap() else {
        panic!("an EXR is linear")
    };
    let largest = linear_max_abs(&picture, &read).unwrap();
    assert!(largest < 1e-7, "{largest}");
}

#[test]
fn what_has_no_meaning_in_8_bits_is_not_compared() {
    use ::png::{BitDepth, ColorType};
    let deep = png((1, 1), ColorType::Rgb, BitDepth::Sixteen, &[0; 6]);
    assert_eq!(PictureFile::read(&deep).unwrap_err(), "has 16 bits a channel: expected 8");
    assert_eq!(PictureFile::read(b"P2 1 1 9 9").unwrap_err(), "has codes up to 9: expected 255");
    let code = EncodedImage::from_bytes(Size { width: 1, height: 1 }, vec![1, 2, 3]).unwrap();
    assert_eq!(PictureFile::read(b"P6 1 1 255\n\x01\x02\x03"), Ok(PictureFile::Encoded(code)));
}

#[test]
fn nan_is_far_from_everything_but_nan() {
    let size = Size { width: 1, height: 1 };
    let pixel = |v: f64| LinearImage::from_fn(size, |_, _| Rgb::WHITE * v);
    assert_eq!(linear_max_abs(&pixel(f64::NAN), &pixel(f64::NAN)), Some(0.0));
    assert_eq!(linear_max_abs(&pixel(f64::NAN), &pixel(0.0)), Some(f64::INFINITY));
    assert_eq!(linear_max_abs(&pixel(3.0), &pixel(1.0)), Some(2.0));
    let wide = LinearImage::from_fn(Size { width: 2, height: 1 }, |_, _| Rgb::BLACK);
    assert_eq!(linear_max_abs(&pixel(3.0), &wide), None);
}
