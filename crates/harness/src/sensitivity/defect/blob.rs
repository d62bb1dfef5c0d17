//! `blob-1`, `blob-2`, `blob-4`: a square of some pixels, lighter or darker than
//! it should be.

use std::ops::Range;

use tracer::Size;

use super::{Defect, Place, Strengths};
use crate::encode::EncodedImage;

pub(super) const ONE: Defect = blob::<1>("blob-1", "moves the codes of 1 pixel");
pub(super) const TWO: Defect = blob::<2>("blob-2", "moves the codes of 2 x 2 pixels");
pub(super) const FOUR: Defect = blob::<4>("blob-4", "moves the codes of 4 x 4 pixels");

/// What a spot needs to be seen: codes times pixels. It is 16 codes on 2 x 2
/// pixels, and spots this small are seen by their light alone: those of a
/// quarter of the area need four times the contrast.
///
/// Source: A. Ricco, "Relazione fra il minimo angolo visuale e l'intensita
/// luminosa", Memorie della Societa degli Spettroscopisti Italiani 6, 1877.
const VISIBLE: f64 = 64.0;

/// Places along each side of the grid that is searched, its ends on the
/// picture's edges.
const GRID: u32 = 8;

/// How far around a pixel the codes are looked at to find where they vary most:
/// as far as a window of SSIM reaches, which is most patient there.
const REACH: u32 = 5;

const fn blob<const SIDE: u32>(name: &'static str, does: &'static str) -> Defect {
    Defect {
        name,
        does,
        unit: "codes",
        strengths: Strengths { least: 1.0, most: 255.0, whole: true },
        visible: VISIBLE / (SIDE * SIDE) as f64,
        places: places::<SIDE>,
        inject: inject::<SIDE>,
    }
}

/// Each channel goes towards the end of its range that is farther away, so that
/// there is room for every strength up to 128.
fn inject<const SIDE: u32>(picture: &EncodedImage, place: Place, strength: f64) -> EncodedImage {
    let Place::At(left, top) = place else { return picture.clone() };
    let by = strength as u8;
    let moved = |code: u8| {
        if code < 128 { code.saturating_add(by) } else { code.saturating_sub(by) }
    };
    EncodedImage::from_fn(picture.size(), |x, y| {
        let pixel = picture.get(x, y).unwrap_or_default();
        let inside = (left..left + SIDE).contains(&x) && (top..top + SIDE).contains(&y);
        if inside { pixel.map(moved) } else { pixel }
    })
}

/// A grid over the whole picture, and where its codes vary most.
fn places<const SIDE: u32>(picture: &EncodedImage) -> Vec<Place> {
    let Size { width, height } = picture.size();
    let along = |count: u32| {
        let room = count.saturating_sub(SIDE);
        let mut all: Vec<_> = (0..GRID).map(|i| room * i / (GRID - 1)).collect();
        all.dedup();
        all
    };
    let rows = along(height);
    let grid = along(width).into_iter().flat_map(|x| rows.iter().map(move |&y| Place::At(x, y)));
    let mut places: Vec<_> = grid.collect();
    let (x, y) = busiest(picture);
    let busiest = Place::At(x.min(width.saturating_sub(SIDE)), y.min(height.saturating_sub(SIDE)));
    if !places.contains(&busiest) {
        places.push(busiest);
    }
    places
}

/// The pixel around which the codes vary most, the first of several row by row.
fn busiest(picture: &EncodedImage) -> (u32, u32) {
    let Size { width, height } = picture.size();
    let value = |x, y| -> i64 {
        let pixel = picture.get(x, y).unwrap_or_default();
        pixel.iter().map(|&c| i64::from(c)).sum()
    };
    let sums = Sums::new(picture.size(), value);
    let squares = Sums::new(picture.size(), |x, y| value(x, y).pow(2));
    let around = |at: u32, count: u32| at.saturating_sub(REACH)..(at + REACH + 1).min(count);
    let mut most = (-1, (0, 0));
    for (x, y) in (0..height).flat_map(|y| (0..width).map(move |x| (x, y))) {
        let (columns, rows) = (around(x, width), around(y, height));
        let count = i64::from(columns.end - columns.start) * i64::from(rows.end - rows.start);
        let sum = sums.of(&columns, &rows);
        // The variance, times the squared count of pixels.
        let variance = count * squares.of(&columns, &rows) - sum * sum;
        if variance > most.0 {
            most = (variance, (x, y));
        }
    }
    most.1
}

/// For each pixel the sum of all values above and to the left of it.
struct Sums {
    pitch: usize,
    sums: Vec<i64>,
}

impl Sums {
    fn new(Size { width, height }: Size, value: impl Fn(u32, u32) -> i64) -> Self {
        let pitch = width as usize + 1;
        let mut sums = vec![0; pitch * (height as usize + 1)];
        for y in 0..height as usize {
            let mut row = 0;
            for x in 0..width as usize {
                row += value(x as u32, y as u32);
                sums[(y + 1) * pitch + x + 1] = sums[y * pitch + x + 1] + row;
            }
        }
        Self { pitch, sums }
    }

    /// The sum over a rectangle.
    fn of(&self, columns: &Range<u32>, rows: &Range<u32>) -> i64 {
        let at = |x: u32, y: u32| self.sums[y as usize * self.pitch + x as usize];
        at(columns.end, rows.end) - at(columns.start, rows.end) - at(columns.end, rows.start)
            + at(columns.start, rows.start)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn picture(width: u32, height: u32, pixel: impl Fn(u32, u32) -> u8) -> EncodedImage {
        EncodedImage::from_fn(Size { width, height }, |x, y| [pixel(x, y); 3])
    }

    #[test]
    fn it_is_square_and_goes_where_there_is_room() {
        let gray = picture(6, 5, |x, _| if x < 3 { 127 } else { 128 });
        let blob = inject::<2>(&gray, Place::At(2, 1), 100.0);
        let changed = blob.pixels().iter().zip(gray.pixels()).filter(|(a, b)| a != b).count();
        assert_eq!(changed, 4);
        assert_eq!((blob.get(2, 1), blob.get(3, 2)), (Some([227; 3]), Some([28; 3])));
    }

    #[test]
    fn the_grid_reaches_every_corner() {
        let places = places::<4>(&picture(160, 120, |_, _| 9));
        for corner in [(0, 0), (156, 0), (0, 116), (156, 116)] {
            assert!(places.contains(&Place::At(corner.0, corner.1)), "{corner:?}");
        }
        assert_eq!(places.len(), 64, "a flat picture varies most at its first pixel");
        assert_eq!(super::places::<4>(&picture(2, 2, |_, _| 9)), [Place::At(0, 0)]);
    }

    #[test]
    fn what_varies_most_is_among_the_places() {
        let texture = picture(64, 48, |x, y| {
            let inside = (20..31).contains(&x) && (10..21).contains(&y);
            if inside && (x + y) % 2 == 0 { 255 } else { 0 }
        });
        assert_eq!(busiest(&texture), (25, 15));
    }
}
