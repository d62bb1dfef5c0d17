//! `contact_sheet`: all goldens at a glance.

use image::RgbImage;
use image::imageops::{FilterType, resize};
use tracer::Size;

use super::canvas::{Canvas, LETTER};
use crate::encode::EncodedImage;

const COLUMNS: u32 = 10;
const CELL: Size = Size { width: 96, height: 72 };
const GAP: u32 = 6;
const PAPER: [u8; 3] = [24, 24, 28];
const INK: [u8; 3] = [170, 170, 178];

/// The pictures in rows of ten, each fitted into a cell of 96 x 72 above the
/// last part of its name, in the order given.
pub fn contact_sheet(pictures: &[(String, EncodedImage)]) -> EncodedImage {
    let rows = (pictures.len() as u32).div_ceil(COLUMNS).max(1);
    let pitch = (CELL.width + GAP, CELL.height + LETTER + 2 * GAP);
    let size = Size { width: COLUMNS * pitch.0 + GAP, height: rows * pitch.1 + GAP };
    let mut canvas = Canvas::new(size, PAPER);
    for (i, (name, picture)) in (0_u32..).zip(pictures) {
        let (left, top) = (GAP + i % COLUMNS * pitch.0, GAP + i / COLUMNS * pitch.1);
        let thumbnail = fitted(picture);
        let Size { width, height } = thumbnail.size();
        canvas.put(
            &thumbnail,
            left + (CELL.width - width) / 2,
            top + (CELL.height - height) / 2,
            1,
        );
        let letters = (CELL.width / LETTER) as usize;
        let label: String = name.rsplit('/').next().unwrap_or(name).chars().take(letters).collect();
        canvas.write(&label, left, top + CELL.height + GAP / 2, INK);
    }
    canvas.finish()
}

/// The picture made to fit a cell: shrunk smoothly, or enlarged by a whole
/// number so that its pixels stay squares.
fn fitted(picture: &EncodedImage) -> EncodedImage {
    let Size { width, height } = picture.size();
    let times = (CELL.width / width).min(CELL.height / height);
    if times >= 1 {
        let size = Size { width: width * times, height: height * times };
        return EncodedImage::from_fn(size, |x, y| {
            picture.get(x / times, y / times).unwrap_or_default()
        });
    }
    let scale =
        (f64::from(CELL.width) / f64::from(width)).min(f64::from(CELL.height) / f64::from(height));
    let shrunk = |n: u32| ((f64::from(n) * scale) as u32).max(1);
    let whole =
        RgbImage::from_fn(width, height, |x, y| image::Rgb(picture.get(x, y).unwrap_or_default()));
    let small = resize(&whole, shrunk(width), shrunk(height), FilterType::Triangle);
    let size = Size { width: small.width(), height: small.height() };
    EncodedImage::from_fn(size, |x, y| small.get_pixel(x, y).0)
}
