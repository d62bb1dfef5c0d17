//! `heat_map`: a table of numbers in colors.

use tracer::Size;

use super::canvas::{Canvas, LETTER};
use crate::encode::EncodedImage;

const PAPER: [u8; 3] = [24, 24, 28];
const INK: [u8; 3] = [200, 200, 208];
const BLANK: [u8; 3] = [44, 44, 50];
const DARK: [u8; 3] = [16, 16, 20];
const GAP: u32 = 1;
const MARGIN: u32 = 8;
const ROW: u32 = LETTER + 4;

/// Rows above the table: the caption, an empty one, and two of titles.
const HEAD: u32 = 4;

/// Colors from cold to hot: the first up to [`COLDEST`], each other up to twice
/// as much as the one before. So the middle one is that of 1, and the warm ones
/// are above.
const COLORS: [[u8; 3]; 9] = [
    [38, 70, 110],
    [42, 96, 128],
    [48, 122, 134],
    [70, 146, 120],
    [128, 168, 92],
    [214, 190, 70],
    [236, 150, 52],
    [232, 100, 48],
    [206, 44, 52],
];

/// What is no hotter has the first color.
const COLDEST: f64 = 1.0 / 16.0;

/// A cell of the table.
#[derive(Debug, Clone, PartialEq)]
pub struct Heat {
    /// What is written in it.
    pub text: String,
    /// How hot it is: cold far below 1, hot far above; `None` for a blank one.
    pub heat: Option<f64>,
}

/// A row for each name, a column for each title and what stands below it, under
/// a caption; cells that a row lacks are left out.
pub fn heat_map(caption: &str, titles: &[[&str; 2]], rows: &[(String, Vec<Heat>)]) -> EncodedImage {
    let letters = |text: &str| text.chars().count() as u32;
    let names = rows.iter().map(|(name, _)| letters(name)).max().unwrap_or(0) * LETTER;
    let cells = rows.iter().flat_map(|(_, cells)| cells.iter().map(|cell| letters(&cell.text)));
    let widest =
        cells.chain(titles.as_flattened().iter().map(|title| letters(title))).max().unwrap_or(0);
    let pitch = (widest + 1) * LETTER + GAP;
    let left = MARGIN + names + LETTER;
    let size = Size {
        width: (left + pitch * titles.len() as u32).max(MARGIN + letters(caption) * LETTER)
            + MARGIN,
        height: MARGIN + ROW * (HEAD + rows.len() as u32) + MARGIN,
    };
    let mut canvas = Canvas::new(size, PAPER);
    canvas.write(caption, MARGIN, MARGIN, INK);
    for (i, title) in (0_u32..).zip(titles) {
        for (row, text) in (2..).zip(title) {
            canvas.write(text, left + i * pitch + LETTER / 2, MARGIN + row * ROW, INK);
        }
    }
    for (j, (name, cells)) in (HEAD..).zip(rows) {
        let top = MARGIN + j * ROW;
        canvas.write(name, MARGIN, top + 2, INK);
        for (i, cell) in (0_u32..).zip(cells) {
            let color = color(cell.heat);
            let at = left + i * pitch;
            for y in top..top + ROW - GAP {
                for x in at..at + pitch - GAP {
                    canvas.set(x, y, color);
                }
            }
            let is_light = color.iter().map(|&c| u32::from(c)).sum::<u32>() > 330;
            canvas.write(&cell.text, at + LETTER / 2, top + 2, if is_light { DARK } else { INK });
        }
    }
    canvas.finish()
}

fn color(heat: Option<f64>) -> [u8; 3] {
    let Some(heat) = heat else { return BLANK };
    let bounds = std::iter::successors(Some(COLDEST), |bound| Some(2.0 * bound));
    // A NaN is above none.
    COLORS[bounds.take(COLORS.len() - 1).filter(|bound| heat > *bound).count()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_above_1_is_warm() {
        assert_eq!(color(Some(1.0)), COLORS[4]);
        assert_eq!(color(Some(1.01)), COLORS[5]);
        assert_eq!(color(Some(2.5)), COLORS[6]);
        assert_eq!(color(Some(0.5)), COLORS[3]);
        assert_eq!((color(Some(0.0)), color(Some(f64::INFINITY))), (COLORS[0], COLORS[8]));
        assert_eq!(color(None), BLANK);
    }

    #[test]
    fn it_is_as_large_as_what_is_in_it() {
        let cell = |text: &str, heat| Heat { text: text.into(), heat };
        let rows = [("a".to_owned(), vec![cell("12", Some(9.0)), cell("", None)])];
        let picture = heat_map("", &[["x", "m"], ["y", "s"]], &rows);
        // A letter for the name, one between, two columns of three letters.
        let width = 2 * MARGIN + 8 + 8 + 2 * (24 + GAP);
        assert_eq!(picture.size(), Size { width, height: 2 * MARGIN + (HEAD + 1) * ROW });
        let at = |column: u32| picture.get(MARGIN + 16 + column * 25, MARGIN + HEAD * ROW);
        assert_eq!((at(0), at(1)), (Some(COLORS[8]), Some(BLANK)));
        assert_eq!(heat_map("abc", &[], &[]).size().width, 2 * MARGIN + 3 * LETTER);
    }
}
