//! Pictures of other renderers, and how far pictures are apart.

use tracer::{LinearImage, Rgb, Size};

/// The root of the mean square of all differences: over all pixels and the three
/// linear channels, nothing cut off; infinite for pictures of different sizes.
pub(crate) fn rmse(one: &LinearImage, other: &LinearImage) -> f64 {
    /// Channels of a pixel.
    const CHANNELS: f64 = 3.0;
    if one.size() != other.size() {
        return f64::INFINITY;
    }
    let pairs = one.pixels().iter().zip(other.pixels());
    let squares: f64 = pairs
        .map(|(p, q)| (*p + *q * -1.0).channels().into_iter().map(|x| x * x).sum::<f64>())
        .sum();
    (squares / (one.pixels().len() as f64 * CHANNELS)).sqrt()
}

/// A picture from three `f32` in little-endian order for each pixel.
///
/// # Errors
/// Says how many bytes were expected.
pub(crate) fn from_floats(bytes: &[u8], size: Size) -> Result<LinearImage, String> {
    let (numbers, _) = bytes.as_chunks::<4>();
    let numbers: Vec<_> = numbers.iter().map(|x| f64::from(f32::from_le_bytes(*x))).collect();
    let (pixels, _) = numbers.as_chunks::<3>();
    let pixels = pixels.iter().map(|pixel| Rgb::from(*pixel)).collect();
    LinearImage::from_pixels(size, pixels).ok_or_else(|| {
        let Size { width, height } = size;
        format!("expected {width} x {height} pixels of 12 bytes, found {} bytes", bytes.len())
    })
}

/// A picture from a PNG file of 16 bits a channel, linear.
///
/// # Errors
/// Says what of the file is not so.
pub(crate) fn from_png16(bytes: &[u8], size: Size) -> Result<LinearImage, String> {
    let mut reader = png::Decoder::new(std::io::Cursor::new(bytes))
        .read_info()
        .map_err(|why| format!("expected a PNG file: {why}"))?;
    let mut buffer = vec![0; reader.output_buffer_size().unwrap_or(0)];
    let frame =
        reader.next_frame(&mut buffer).map_err(|why| format!("a broken PNG file: {why}"))?;
    let found = (frame.width, frame.height, frame.bit_depth, frame.color_type);
    let expected = (size.width, size.height, png::BitDepth::Sixteen, png::ColorType::Rgb);
    if found != expected {
        return Err(format!("expected a PNG file of {expected:?}, found {found:?}"));
    }
    let (numbers, _) = buffer.as_chunks::<2>();
    let numbers: Vec<_> =
        numbers.iter().map(|x| f64::from(u16::from_be_bytes(*x)) / f64::from(u16::MAX)).collect();
    let (pixels, _) = numbers.as_chunks::<3>();
    LinearImage::from_pixels(size, pixels.iter().map(|pixel| Rgb::from(*pixel)).collect())
        .ok_or_else(|| "a PNG file with pixels missing".into())
}

#[cfg(test)]
mod tests {
    use super::*;

    const SIZE: Size = Size { width: 2, height: 1 };

    #[test]
    fn errors_of_known_pictures() {
        let black = LinearImage::from_fn(SIZE, |_, _| Rgb::BLACK);
        let one = LinearImage::from_fn(SIZE, |x, _| Rgb::new(0.0, f64::from(x) * 0.6, 0.0));
        assert_eq!(rmse(&black, &black), 0.0);
        assert!((rmse(&black, &one) - 0.06_f64.sqrt()).abs() < 1e-15);
        let other = LinearImage::from_fn(Size { width: 1, height: 1 }, |_, _| Rgb::BLACK);
        assert_eq!(rmse(&black, &other), f64::INFINITY);
    }

    #[test]
    fn floats_are_read_back() {
        let bytes: Vec<u8> =
            [0.5_f32, 0.25, 1.0, 0.0, 2.0, 4.0].iter().flat_map(|x| x.to_le_bytes()).collect();
        let picture = from_floats(&bytes, SIZE).unwrap();
        assert_eq!(picture.get(1, 0), Some(Rgb::new(0.0, 2.0, 4.0)));
        let why = from_floats(&bytes[4..], SIZE).unwrap_err();
        assert!(why.contains("found 20 bytes"), "{why}");
    }

    #[test]
    fn png_files_of_16_bits_are_read_back_and_others_refused() {
        let encode = |depth: png::BitDepth, data: &[u8]| {
            let mut bytes = Vec::new();
            let mut encoder = png::Encoder::new(&mut bytes, 2, 1);
            encoder.set_color(png::ColorType::Rgb);
            encoder.set_depth(depth);
            encoder.write_header().unwrap().write_image_data(data).unwrap();
            bytes
        };
        let mut data = [0; 12];
        data[6..8].copy_from_slice(&u16::MAX.to_be_bytes());
        let picture = from_png16(&encode(png::BitDepth::Sixteen, &data), SIZE).unwrap();
        assert_eq!(picture.pixels(), [Rgb::BLACK, Rgb::new(1.0, 0.0, 0.0)]);
        let why = from_png16(&encode(png::BitDepth::Eight, &data[..6]), SIZE).unwrap_err();
        assert!(why.contains("Sixteen") && why.contains("Eight"), "{why}");
        assert!(from_png16(b"no", SIZE).unwrap_err().contains("expected a PNG file"));
    }
}
