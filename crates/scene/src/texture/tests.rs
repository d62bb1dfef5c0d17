//! Texture files, good ones and broken ones.

use ::png::{BitDepth, ColorType, Encoder};
use tracer::Size;

use super::*;

/// A PNG file of these bytes.
fn file(size: (u32, u32), color: ColorType, depth: BitDepth, data: &[u8]) -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut encoder = Encoder::new(&mut bytes, size.0, size.1);
    encoder.set_color(color);
    encoder.set_depth(depth);
    if color == ColorType::Indexed {
        encoder.set_palette(vec![0, 0, 0, 255, 128, 0]);
    }
    encoder.write_header().unwrap().write_image_data(data).unwrap();
    bytes
}

/// What is read as linear texels of these codes.
#[track_caller]
fn check(color: ColorType, depth: BitDepth, data: &[u8], codes: [[u16; 3]; 2]) {
    let found = read(&file((2, 1), color, depth, data), TexelEncoding::Linear).unwrap();
    let white = if depth == BitDepth::Sixteen { u16::MAX } else { 255 };
    let levels = levels::levels(TexelEncoding::Linear, white);
    let size = Size { width: 2, height: 1 };
    assert_eq!(found, Texels::new(size, codes.to_vec(), levels).unwrap(), "{color:?} {depth:?}");
}

#[test]
fn every_kind_of_color() {
    use BitDepth::{Eight, Four, One, Sixteen};
    use ColorType::{Grayscale, GrayscaleAlpha, Indexed, Rgb, Rgba};
    check(Rgb, Eight, &[1, 2, 3, 4, 5, 255], [[1, 2, 3], [4, 5, 255]]);
    check(Rgba, Eight, &[1, 2, 3, 255, 4, 5, 6, 255], [[1, 2, 3], [4, 5, 6]]);
    check(Grayscale, Eight, &[7, 9], [[7; 3], [9; 3]]);
    check(GrayscaleAlpha, Eight, &[7, 255, 9, 255], [[7; 3], [9; 3]]);
    check(Indexed, Eight, &[1, 0], [[255, 128, 0], [0; 3]]);
    check(Indexed, One, &[0b0100_0000], [[0; 3], [255, 128, 0]]);
    check(Grayscale, One, &[0b0100_0000], [[0; 3], [255; 3]]);
    check(Grayscale, Four, &[0x1f], [[17; 3], [255; 3]]);
    check(Grayscale, Sixteen, &[1, 2, 255, 255], [[258; 3], [65_535; 3]]);
    let deep = [0, 1, 0, 2, 1, 0, 255, 255, 0, 3, 0, 4, 0, 5, 255, 255];
    check(Rgba, Sixteen, &deep, [[1, 2, 256], [3, 4, 5]]);
}

#[test]
fn curves_are_those_that_are_asked_for() {
    let bytes = file((2, 1), ColorType::Grayscale, BitDepth::Eight, &[0, 128]);
    let encodings = [TexelEncoding::Srgb, TexelEncoding::Gamma22, TexelEncoding::Linear];
    let all = encodings.map(|encoding| read(&bytes, encoding).unwrap());
    assert!(all[0] != all[1] && all[1] != all[2] && all[0] != all[2]);
}

#[track_caller]
fn check_error(bytes: &[u8], expected: &str) {
    let error = read(bytes, TexelEncoding::Srgb).unwrap_err();
    assert!(error.contains(expected), "{error:?} does not contain {expected:?}");
}

#[test]
fn broken_files() {
    use BitDepth::{Eight, Sixteen};
    check_error(b"", "is not a readable PNG file");
    check_error(b"GIF89a", "is not a readable PNG file");
    let good = file((2, 1), ColorType::Grayscale, Eight, &[0, 128]);
    check_error(&good[..good.len() - 20], "is not a readable PNG file");
    check_error(&good[..good.len() - 4], "is not a readable PNG file");
    let mut flipped = good.clone();
    flipped[20] ^= 1;
    check_error(&flipped, "is not a readable PNG file");
    let clear = [0, 0, 0, 255, 0, 0, 0, 254];
    let at = "is not opaque, first at (1, 0) from its upper left";
    check_error(&file((2, 1), ColorType::Rgba, Eight, &clear), at);
    check_error(&file((1, 2), ColorType::GrayscaleAlpha, Eight, &[9, 255, 9, 0]), "at (0, 1)");
    let clear = [0, 0, 255, 255, 0, 0, 255, 254];
    check_error(&file((2, 1), ColorType::GrayscaleAlpha, Sixteen, &clear), at);
    let wide = file((16_385, 1), ColorType::Grayscale, Eight, &vec![0; 16_385]);
    check_error(&wide, "is 16385 x 1: expected a texture of at most 16384 texels a side");
}

#[test]
fn alpha_is_taken_off_and_colors_stay() {
    use BitDepth::{Eight, Sixteen};
    #[track_caller]
    fn check(color: ColorType, depth: BitDepth, clear: &[u8], opaque: &[u8]) {
        let without = without_alpha(&file((2, 1), color, depth, clear)).unwrap().unwrap();
        let expected = file((2, 1), color, depth, opaque);
        let read = |bytes: &[u8]| read(bytes, TexelEncoding::Linear).unwrap();
        assert_eq!(read(&without), read(&expected), "{color:?} {depth:?}");
        assert_eq!(without_alpha(&expected), Ok(None));
    }
    check(ColorType::Rgba, Eight, &[1, 2, 3, 0, 4, 5, 6, 9], &[1, 2, 3, 255, 4, 5, 6, 255]);
    check(ColorType::GrayscaleAlpha, Eight, &[7, 254, 9, 255], &[7, 255, 9, 255]);
    let deep = [1, 2, 255, 254, 3, 4, 0, 0];
    check(ColorType::GrayscaleAlpha, Sixteen, &deep, &[1, 2, 255, 255, 3, 4, 255, 255]);
    assert!(without_alpha(b"GIF89a").unwrap_err().contains("is not a readable PNG file"));
}

#[test]
fn every_kind_of_file_becomes_rgb_of_as_many_bits() {
    use BitDepth::{Eight, Four, Sixteen};
    use ColorType::{Grayscale, Indexed, Rgb};
    #[track_caller]
    fn check(color: ColorType, depth: BitDepth, data: &[u8], rgb: &[u8], rgb_depth: BitDepth) {
        let (written, size) = as_rgb(&file((2, 1), color, depth, data)).unwrap();
        let mut reader = ::png::Decoder::new(std::io::Cursor::new(written)).read_info().unwrap();
        let mut found = vec![0; reader.output_buffer_size().unwrap()];
        let frame = reader.next_frame(&mut found).unwrap();
        assert_eq!((frame.color_type, frame.bit_depth, size), (Rgb, rgb_depth, [2, 1]));
        assert_eq!(found, rgb, "{color:?} {depth:?}");
    }
    check(Grayscale, Eight, &[7, 9], &[7, 7, 7, 9, 9, 9], Eight);
    check(Grayscale, Four, &[0x1f], &[17, 17, 17, 255, 255, 255], Eight);
    check(Indexed, Eight, &[1, 0], &[255, 128, 0, 0, 0, 0], Eight);
    check(Grayscale, Sixteen, &[1, 2, 3, 4], &[1, 2, 1, 2, 1, 2, 3, 4, 3, 4, 3, 4], Sixteen);
    assert!(as_rgb(b"GIF89a").unwrap_err().contains("is not a readable PNG file"));
}

#[test]
fn a_size_that_is_only_claimed_takes_no_memory() {
    // Its header says 2^31 - 1 by 2^31 - 1 texels, with a good checksum.
    let mut bytes = b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR\x7f\xff\xff\xff\x7f\xff\xff\xff".to_vec();
    bytes.extend(b"\x08\x02\0\0\0");
    bytes.extend(crc(&bytes[12..]).to_be_bytes());
    bytes.extend(b"\0\0\0\0IDAT");
    bytes.extend(crc(b"IDAT").to_be_bytes());
    let error = read(&bytes, TexelEncoding::Srgb).unwrap_err();
    assert!(error.contains("2147483647 x 2147483647") || error.contains("readable"), "{error}");
}

/// The checksum of a chunk.
fn crc(bytes: &[u8]) -> u32 {
    let mut crc = u32::MAX;
    for &byte in bytes {
        crc ^= u32::from(byte);
        for _ in 0..8 {
            crc = if crc & 1 == 1 { (crc >> 1) ^ 0xedb8_8320 } else { crc >> 1 };
        }
    }
    !crc
}

#[test]
fn mutated_files_never_panic() {
    let mut rng = fastrand::Rng::with_seed(6);
    let good = file((3, 2), ColorType::Rgb, BitDepth::Eight, &[9; 18]);
    for _ in 0..5_000 {
        let mut bytes = good.clone();
        for _ in 0..rng.usize(1..4) {
            let at = rng.usize(0..bytes.len());
            match rng.u8(0..3) {
                0 => bytes[at] = rng.u8(..),
                1 => bytes.insert(at, rng.u8(..)),
                _ => drop(bytes.drain(at..(at + rng.usize(0..9)).min(bytes.len()))),
            }
        }
        // Either way is fine; coming back at all is what counts.
        let _ = read(&bytes, TexelEncoding::Srgb);
    }
}

#[test]
fn endings() {
    for path in ["a.png", "deep/B.PNG"] {
        assert!(is_texture(path), "{path}");
    }
    for path in ["a.jpg", "png", "a.png.obj", ""] {
        assert!(!is_texture(path), "{path}");
    }
}
