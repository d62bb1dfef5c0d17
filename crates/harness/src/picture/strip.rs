//! `strip`: golden, difference and actual side by side.

use tracer::Size;

use super::canvas::{Canvas, LETTER};
use crate::encode::EncodedImage;

const GAP: u32 = 4;
const PAPER: [u8; 3] = [32, 32, 36];
const INK: [u8; 3] = [230, 230, 230];

/// Panels narrower than this are enlarged, by whole numbers so that pixels stay
/// squares.
const READABLE_WIDTH: u32 = 320;

/// Colors of differences from 1, from 2, from 4 and so on to 128: none of them
/// gray, so that even a difference of 1 stands out, and brighter for more.
pub const HEAT: [[u8; 3]; 8] = [
    [88, 28, 160],
    [130, 36, 150],
    [175, 45, 125],
    [215, 60, 90],
    [240, 90, 55],
    [250, 135, 30],
    [252, 185, 40],
    [255, 240, 120],
];

/// The golden, the difference and the actual picture, from left to right, each
/// under its name. What there is not is left out: a golden, or the difference
/// of pictures of different sizes.
pub fn strip(golden: Option<&EncodedImage>, actual: &EncodedImage) -> EncodedImage {
    strip_of(("golden", golden), actual)
}

/// The same with another name in place of the golden's.
pub fn strip_of(
    (name, golden): (&str, Option<&EncodedImage>),
    actual: &EncodedImage,
) -> EncodedImage {
    let difference = golden.and_then(|golden| difference(golden, actual));
    let panels: Vec<(&str, &EncodedImage)> =
        [(name, golden), ("difference", difference.as_ref()), ("actual", Some(actual))]
            .into_iter()
            .filter_map(|(name, picture)| Some((name, picture?)))
            .collect();

    let widest = panels.iter().map(|p| p.1.size().width).max().unwrap_or(1);
    let side = (READABLE_WIDTH / widest).clamp(1, 16);
    let header = LETTER + 2 * GAP;
    let size = Size {
        width: panels.iter().map(|p| panel_width(p.1, side) + GAP).sum::<u32>() + GAP,
        height: header + panels.iter().map(|p| p.1.size().height * side).max().unwrap_or(1) + GAP,
    };
    let mut canvas = Canvas::new(size, PAPER);
    let mut left = GAP;
    for (name, picture) in panels {
        canvas.write(name, left, GAP, INK);
        canvas.put(picture, left, header, side);
        left += panel_width(picture, side) + GAP;
    }
    canvas.finish()
}

/// Wide enough for the picture and its name.
fn panel_width(picture: &EncodedImage, side: u32) -> u32 {
    (picture.size().width * side).max("difference".len() as u32 * LETTER)
}

/// Equal pixels dim and gray, differing ones in a color of [`HEAT`];
/// `None` for different sizes.
pub fn difference(golden: &EncodedImage, actual: &EncodedImage) -> Option<EncodedImage> {
    (golden.size() == actual.size()).then(|| {
        EncodedImage::from_fn(golden.size(), |x, y| {
            let (g, a) =
                (golden.get(x, y).unwrap_or_default(), actual.get(x, y).unwrap_or_default());
            let largest = g.iter().zip(a).map(|(g, a)| g.abs_diff(a)).max().unwrap_or(0);
            let gray = g.iter().map(|&c| u32::from(c)).sum::<u32>() / 3;
            largest.checked_ilog2().map_or([(gray / 4) as u8; 3], |step| HEAT[step as usize])
        })
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn gray(width: u32, value: impl Fn(u32, u32) -> u8) -> EncodedImage {
        EncodedImage::from_fn(Size { width, height: 30 }, |x, y| [value(x, y); 3])
    }

    #[test]
    fn a_difference_of_one_stands_out() {
        let golden = gray(40, |_, _| 200);
        let actual = gray(40, |x, y| if (x, y) == (3, 5) { 201 } else { 200 });
        let marked = difference(&golden, &actual).unwrap();
        assert_eq!(marked.get(3, 5), Some(HEAT[0]));
        assert_eq!(marked.get(4, 5), Some([50; 3]));
    }

    #[test]
    fn there_are_as_many_panels_as_there_is_to_show() {
        let width = |golden: Option<&EncodedImage>, actual| strip(golden, actual).size().width;
        let (small, large) = (gray(40, |_, _| 9), gray(60, |_, _| 9));
        assert_eq!(width(Some(&small), &small), 3 * (320 + GAP) + GAP);
        assert_eq!(width(None, &small), 320 + 2 * GAP);
        assert_eq!(width(Some(&small), &large), 200 + 300 + 3 * GAP, "no difference");
        let pixel = EncodedImage::from_fn(Size { width: 1, height: 1 }, |_, _| [0; 3]);
        assert_eq!(width(Some(&pixel), &pixel), 3 * (80 + GAP) + GAP, "wide enough for names");
    }
}
