//! A small picture of a scene, as a file in letters.

use tracer::{LinearImage, Rgb, Size};

/// The exponent of the encoding: a plain power.
const GAMMA: f64 = 1.0 / 2.2;

/// The picture at this size, at most its own, as a PNG file in base 64.
///
/// # Errors
/// What the encoder says.
pub(super) fn base64(picture: &LinearImage, (width, height): (u32, u32)) -> Result<String, String> {
    let bytes: Vec<u8> = smaller(picture, Size { width, height })
        .pixels()
        .iter()
        .flat_map(|pixel| pixel.channels().map(encoded))
        .collect();
    let mut file = Vec::new();
    let mut encoder = png::Encoder::new(&mut file, width, height);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_compression(png::Compression::High);
    let written = encoder.write_header().and_then(|mut writer| {
        writer.write_image_data(&bytes)?;
        writer.finish()
    });
    written.map_err(|why| format!("the small picture of a scene: {why}"))?;
    Ok(letters(&file))
}

fn encoded(x: f64) -> u8 {
    (libm::pow(x.clamp(0.0, 1.0), GAMMA) * f64::from(u8::MAX)).round() as u8
}

/// The means of the pixels that are in each of the new ones.
fn smaller(picture: &LinearImage, size: Size) -> LinearImage {
    let from = picture.size();
    LinearImage::from_fn(size, |x, y| {
        let ends = |k: u32, n: u32, of: u32| (k * of / n)..((k + 1) * of / n).max(k * of / n + 1);
        let (mut sum, mut count) = (Rgb::BLACK, 0.0);
        for row in ends(y, size.height, from.height) {
            for column in ends(x, size.width, from.width) {
                sum += picture.get(column, row).unwrap_or_default();
                count += 1.0;
            }
        }
        sum * (1.0 / count)
    })
}

/// Base 64.
///
/// Source: RFC 4648, section 4.
fn letters(bytes: &[u8]) -> String {
    const ALPHABET: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    /// Three bytes are four letters of six bits each.
    const BYTES: usize = 3;
    const BITS: u32 = 6;
    let mut text = String::new();
    for chunk in bytes.chunks(BYTES) {
        let byte = |k: usize| u32::from(chunk.get(k).copied().unwrap_or(0));
        let all = byte(0) << 16 | byte(1) << 8 | byte(2);
        for letter in 0..=BYTES {
            let shift = BITS * (BYTES - letter) as u32;
            let index = (all >> shift) as usize % ALPHABET.len();
            text.push(if letter <= chunk.len() { char::from(ALPHABET[index]) } else { '=' });
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_examples_of_the_standard() {
        for (bytes, expected) in [
            ("", ""),
            ("f", "Zg=="),
            ("fo", "Zm8="),
            ("foo", "Zm9v"),
            ("foob", "Zm9vYg=="),
            ("fooba", "Zm9vYmE="),
            ("foobar", "Zm9vYmFy"),
        ] {
            assert_eq!(letters(bytes.as_bytes()), expected);
        }
    }

    #[test]
    fn small_pixels_are_means() {
        let picture = LinearImage::from_fn(Size { width: 4, height: 2 }, |x, y| {
            Rgb::WHITE * f64::from(x + 4 * y)
        });
        let small = smaller(&picture, Size { width: 2, height: 1 });
        assert_eq!(small.pixels(), [Rgb::WHITE * 2.5, Rgb::WHITE * 4.5]);
        let same = smaller(&picture, picture.size());
        assert_eq!(same, picture);
    }
}
