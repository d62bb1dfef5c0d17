//! `row`: one row moved to the right.

use super::{Defect, Place, Strengths, between, clamped};
use crate::encode::EncodedImage;

pub(super) const ROW: Defect = Defect {
    name: "row",
    does: "moves one row to the right",
    unit: "pixels",
    // Below the weakest no edge from 0 to 255 changes a code; a wider step than
    // the strongest is a wrong picture, not a defect of one.
    strengths: Strengths { least: 1.0 / 512.0, most: 32.0, whole: false },
    // The eye tells breaks of a line from less than a pixel on.
    visible: 1.0,
    places,
    inject,
};

/// The most rows that are tried: of more, as many spread evenly.
const MOST_ROWS: usize = 32;

/// Between whole pixels the two neighbors are mixed; what moves in from the left
/// is the row's first pixel.
fn inject(picture: &EncodedImage, place: Place, strength: f64) -> EncodedImage {
    let by = |y: u32| if place == Place::Row(y) { strength } else { 0.0 };
    EncodedImage::from_fn(picture.size(), |x, y| {
        between(by(y), |back| clamped(picture, i64::from(x) - back, y.into()))
    })
}

/// The rows that are not of one color; the first where all are.
fn places(picture: &EncodedImage) -> Vec<Place> {
    let width = picture.size().width.max(1) as usize;
    let rows = picture.pixels().chunks_exact(width).zip(0..);
    let uneven: Vec<u32> =
        rows.filter(|(row, _)| row.iter().any(|pixel| *pixel != row[0])).map(|(_, y)| y).collect();
    let tried = uneven.len().clamp(1, MOST_ROWS);
    let spread = (0..tried).filter_map(|i| uneven.get(i * uneven.len() / tried));
    let places: Vec<_> = spread.map(|&y| Place::Row(y)).collect();
    if places.is_empty() { vec![Place::Row(0)] } else { places }
}

#[cfg(test)]
mod tests {
    use tracer::Size;

    use super::*;

    #[test]
    fn one_row_moves_and_no_other() {
        let size = Size { width: 4, height: 2 };
        let picture = EncodedImage::from_fn(size, |x, y| [(10 * x + y) as u8; 3]);
        let moved = inject(&picture, Place::Row(1), 2.0);
        let row = |y: u32| (0..4).map(|x| moved.get(x, y).unwrap()[0]).collect::<Vec<_>>();
        assert_eq!(row(0), [0, 10, 20, 30]);
        assert_eq!(row(1), [1, 1, 1, 11]);
        let part = inject(&picture, Place::Row(0), 0.25);
        assert_eq!(part.get(3, 0), Some([28; 3]), "27.5, rounded");
    }

    #[test]
    fn only_rows_that_can_show_it_are_tried() {
        let size = Size { width: 8, height: 200 };
        let picture = |first: u32| {
            EncodedImage::from_fn(size, |x, y| [if y >= first && x == 3 { 9 } else { 0 }; 3])
        };
        assert_eq!(places(&picture(198)), [Place::Row(198), Place::Row(199)]);
        assert_eq!(places(&picture(200)), [Place::Row(0)]);
        assert_eq!(places(&picture(0)).len(), MOST_ROWS);
    }
}
