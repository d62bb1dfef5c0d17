//! `disagreement`: the opinions of a scene as a picture.

use harness::encode::EncodedImage;

use super::{MOST_VOTERS, Opinion, Told};

/// The color of each voter where it stands alone, by number; told apart by people
/// who see few colors.
///
/// Source: Okabe and Ito, "Color Universal Design", 2008, reordered, and a violet in
/// place of its black.
pub const COLORS: [[u8; 3]; MOST_VOTERS] = [
    [240, 228, 66],
    [86, 180, 233],
    [230, 159, 0],
    [0, 158, 115],
    [204, 121, 167],
    [0, 114, 178],
    [213, 94, 0],
    [150, 150, 250],
];

/// The color of pixels where several are against the majority.
pub const SEVERAL: [u8; 3] = [205, 205, 205];

/// The color of pixels without a majority.
pub const UNDECIDED: [u8; 3] = [255, 60, 160];

/// The picture of who stands alone where, over the dimmed reference: `base` is its
/// picture for people. Edge pixels have half the brightness of interior ones.
/// `None` where all agree, and for a base of another size.
pub fn disagreement(told: &Told, base: &EncodedImage, edges: &[bool]) -> Option<EncodedImage> {
    /// So much of the reference is seen where all agree.
    const DIMMED: u32 = 3;
    if told.map.is_empty() || base.size() != told.size {
        return None;
    }
    let width = told.size.width as usize;
    Some(EncodedImage::from_fn(told.size, |x, y| {
        let pixel = y as usize * width + x as usize;
        let color = match told.map.get(pixel).copied().unwrap_or(Opinion::Agree) {
            Opinion::Agree => {
                let codes = base.get(x, y).unwrap_or_default();
                let gray = codes.iter().map(|&code| u32::from(code)).sum::<u32>() / 3;
                return [(gray / DIMMED) as u8; 3];
            }
            Opinion::Against(odd) => odd.only().map_or(SEVERAL, |i| COLORS[i]),
            Opinion::Halves(..) | Opinion::AllDiffer | Opinion::Unclear => UNDECIDED,
        };
        let is_edge = edges.get(pixel).copied().unwrap_or(false);
        if is_edge { color.map(|code| code / 2) } else { color }
    }))
}
