//! `side_by_side`: pictures in a terminal, two pixels to a letter.

use harness::encode::EncodedImage;
use harness::picture::HEAT;

/// What there is to draw with.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Ink {
    /// Half blocks in all colors.
    Colors,
    /// Letters from dark to light, and digits for differences.
    Letters,
}

/// What is drawn, under its name.
#[derive(Debug, Clone, Copy)]
pub(super) struct Panel<'a> {
    pub(super) name: &'static str,
    pub(super) picture: &'a EncodedImage,
    /// Whether it is differences in the colors of [`HEAT`] over a dim gray
    /// picture.
    pub(super) is_difference: bool,
}

impl Panel<'_> {
    /// How large a difference this is the color of; `None` for anything else.
    fn step(&self, pixel: [u8; 3]) -> Option<usize> {
        HEAT.iter().position(|heat| self.is_difference && *heat == pixel)
    }
}

/// Letters from dark to light.
const RAMP: &[u8] = b" .:-=+*#%@";

/// Columns between pictures.
const GAP: usize = 1;

/// Small pictures are enlarged, but to no more than so many columns.
const LARGE: usize = 48;

/// The pictures from left to right, in at most so many columns and rows, under
/// their names; each keeps its proportions, and they are scaled alike.
pub(super) fn side_by_side(
    panels: &[Panel<'_>],
    columns: usize,
    rows: usize,
    ink: Ink,
) -> Vec<String> {
    let sizes = || panels.iter().map(|panel| panel.picture.size());
    let Some(widest) = sizes().map(|size| size.width).max() else { return Vec::new() };
    let tallest = sizes().map(|size| size.height).max().unwrap_or(1);
    let count = panels.len();
    let room = columns.saturating_sub(GAP * (count - 1)) / count;
    // A letter is twice as high as wide, and so has two square pixels.
    let scale = (room.clamp(1, LARGE) as f64 / f64::from(widest))
        .min(2.0 * rows.max(1) as f64 / f64::from(tallest));
    let side = |pixels: u32| ((f64::from(pixels) * scale).round() as usize).max(1);
    let scale = |panel: &Panel<'_>| {
        let size = panel.picture.size();
        Scaled::new(panel, side(size.width), side(size.height))
    };
    let scaled: Vec<_> = panels.iter().map(scale).collect();
    let rows = scaled.iter().map(|picture| picture.height.div_ceil(2)).max().unwrap_or(0);
    let join = |parts: Vec<String>| parts.join(&" ".repeat(GAP)).trim_end().to_owned();
    let name =
        |(panel, picture): (&Panel<'_>, &Scaled)| format!("{:1$.1$}", panel.name, picture.width);
    let mut lines = vec![join(panels.iter().zip(&scaled).map(name).collect())];
    let line = |row| join(scaled.iter().map(|picture| picture.line(row, ink)).collect());
    lines.extend((0..rows).map(line));
    lines
}

/// A picture in another size.
struct Scaled {
    width: usize,
    height: usize,
    cells: Vec<Cell>,
}

/// A pixel, and how large a difference it is the color of.
type Cell = ([u8; 3], Option<usize>);

impl Scaled {
    fn new(panel: &Panel<'_>, width: usize, height: usize) -> Self {
        let size = panel.picture.size();
        // At least one pixel: that of the near corner where it is enlarged.
        let range = |at: usize, to: usize, from: u32| {
            let start = at * from as usize / to;
            start as u32..((at + 1) * from as usize / to).max(start + 1) as u32
        };
        let cell = |x: usize, y: usize| {
            let columns = range(x, width, size.width);
            let all = range(y, height, size.height)
                .flat_map(|row| columns.clone().map(move |column| (column, row)))
                .filter_map(|(column, row)| panel.picture.get(column, row));
            one(panel, all)
        };
        let places = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
        Self { width, height, cells: places.map(|(x, y)| cell(x, y)).collect() }
    }

    fn get(&self, x: usize, y: usize) -> Option<Cell> {
        if y < self.height { self.cells.get(y * self.width + x).copied() } else { None }
    }

    /// A line of letters, two rows of pixels.
    fn line(&self, row: usize, ink: Ink) -> String {
        let pairs = (0..self.width).map(|x| (self.get(x, 2 * row), self.get(x, 2 * row + 1)));
        match ink {
            Ink::Letters => pairs.map(|(upper, lower)| letter(upper, lower)).collect(),
            Ink::Colors => pairs.map(half_block).collect::<String>() + "\u{1b}[0m",
        }
    }
}

/// One pixel for several: their mean, but the largest difference where there is
/// one, which is not to vanish among what is alike.
fn one(panel: &Panel<'_>, pixels: impl Iterator<Item = [u8; 3]>) -> Cell {
    let (mut sum, mut count, mut worst) = ([0_u32; 3], 0, None);
    for pixel in pixels {
        worst = worst.max(panel.step(pixel));
        count += 1;
        for (sum, value) in sum.iter_mut().zip(pixel) {
            *sum += u32::from(value);
        }
    }
    let mean = sum.map(|sum| (sum / count.max(1)) as u8);
    (worst.map_or(mean, |step| HEAT[step]), worst)
}

fn letter(upper: Option<Cell>, lower: Option<Cell>) -> char {
    let both = [upper, lower].into_iter().flatten();
    if let Some(step) = both.clone().filter_map(|cell| cell.1).max() {
        return char::from_digit(step as u32 + 1, 10).unwrap_or('9');
    }
    let light: u32 = both.clone().map(|cell| luma(cell.0)).sum();
    let light = light / (both.count() as u32).max(1);
    char::from(RAMP[light as usize * (RAMP.len() - 1) / 255])
}

/// Rec. 601, in hundredths rounded to whole numbers.
fn luma([r, g, b]: [u8; 3]) -> u32 {
    (30 * u32::from(r) + 59 * u32::from(g) + 11 * u32::from(b)) / 100
}

fn half_block((upper, lower): (Option<Cell>, Option<Cell>)) -> String {
    match (upper, lower) {
        (None, _) => "\u{1b}[0m ".to_owned(),
        (Some(([r, g, b], _)), None) => format!("\u{1b}[0m\u{1b}[38;2;{r};{g};{b}m▀"),
        (Some(([r, g, b], _)), Some(([s, h, c], _))) => {
            format!("\u{1b}[38;2;{r};{g};{b}m\u{1b}[48;2;{s};{h};{c}m▀")
        }
    }
}

#[cfg(test)]
mod tests {
    use harness::encode::Size;
    use harness::picture::difference;

    use super::*;

    fn picture(bytes: &[u8], width: u32) -> EncodedImage {
        let size = Size { width, height: bytes.len() as u32 / width };
        EncodedImage::from_bytes(size, bytes.iter().flat_map(|&v| [v; 3]).collect()).unwrap()
    }

    fn panel(picture: &EncodedImage) -> Panel<'_> {
        Panel { name: "name", picture, is_difference: false }
    }

    #[test]
    fn a_picture_is_letters_from_dark_to_light() {
        let ramp = picture(&[0, 128, 255, 0, 128, 255], 3);
        let lines = side_by_side(&[panel(&ramp)], 3, 9, Ink::Letters);
        assert_eq!(lines, ["nam", " =@"]);
        let twice = [panel(&ramp), panel(&ramp)];
        assert_eq!(side_by_side(&twice, 7, 9, Ink::Letters), ["nam nam", " =@  =@"]);
        let color = HEAT[0];
        let violet = EncodedImage::from_fn(ramp.size(), |_, _| color);
        let lines = side_by_side(&[panel(&violet)], 3, 9, Ink::Letters);
        assert_eq!(lines[1], ":::", "a color of differences is none in a picture");
    }

    #[test]
    fn no_difference_vanishes_when_it_is_made_small() {
        let golden = picture(&[90; 1600], 40);
        let mut bytes = [90; 1600];
        (bytes[0], bytes[1599]) = (91, 218);
        let marked = difference(&golden, &picture(&bytes, 40)).unwrap();
        let marked = [Panel { is_difference: true, ..panel(&marked) }];
        assert_eq!(side_by_side(&marked, 4, 9, Ink::Letters), ["name", "1", "   8"]);
        let colors = side_by_side(&marked, 4, 9, Ink::Colors).concat();
        for step in [0, 7] {
            let [r, g, b] = HEAT[step];
            assert!(colors.contains(&format!("2;{r};{g};{b}m")), "{colors:?}");
        }
    }

    #[test]
    fn it_fits() {
        let (small, odd) = (picture(&[255], 1), picture(&[255; 70], 7));
        for (columns, rows) in [(0, 0), (1, 1), (5, 3), (40, 9), (200, 60)] {
            let all = [panel(&small), panel(&odd), panel(&odd)];
            let lines = side_by_side(&all, columns, rows, Ink::Letters);
            let widest = lines.iter().map(|line| line.chars().count()).max();
            // Each picture has a pixel, whatever happens.
            assert!(widest <= Some(columns.max(5)), "{columns}: {lines:?}");
            assert!(lines.len() <= 1 + rows.max(1), "{rows}: {lines:?}");
        }
        assert!(side_by_side(&[], 40, 9, Ink::Colors).is_empty());
    }
}
