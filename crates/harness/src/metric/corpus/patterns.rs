//! What the pictures of the corpus show, as functions of column and row.

/// A pixel.
pub(super) type Rgb = [u8; 3];

const WHITE: Rgb = [255; 3];
const BLACK: Rgb = [0; 3];

/// A shaded disc before a sky that brightens to the right and downwards.
pub(super) fn scene(x: u32, y: u32) -> Rgb {
    const CENTER: (u32, u32) = (26, 36);
    const RADIUS_SQUARED: u32 = 400;
    let distance_squared = x.abs_diff(CENTER.0).pow(2) + y.abs_diff(CENTER.1).pow(2);
    let sky = [80 + x.min(100), 100 + y.min(100), 140 + (x + y).min(200) / 2];
    let light = RADIUS_SQUARED.saturating_sub(distance_squared);
    let disc = [60 + 150 * light / RADIUS_SQUARED, 40 + light / 5, 30 + light / 8];
    (if light > 0 { disc } else { sky }).map(|code| code as u8)
}

/// A number that looks random, the same for the same place.
pub(super) fn noise(x: u32, y: u32, channel: usize) -> u8 {
    // A mix of bits by two odd factors; any that spread them would do.
    const SPREAD: u32 = 0x9e37_79b1;
    const MIX: u32 = 0x85eb_ca6b;
    // A prime longer than any row of the corpus.
    const ROW: u32 = 1009;
    let place = (y * ROW + x) * 3 + channel as u32;
    let mixed = place.wrapping_mul(SPREAD);
    let mixed = (mixed ^ (mixed >> 15)).wrapping_mul(MIX);
    (mixed >> 24) as u8
}

/// Noise in all three channels.
pub(super) fn noise_rgb(x: u32, y: u32) -> Rgb {
    [0, 1, 2].map(|channel| noise(x, y, channel))
}

/// A pixel with noise of up to `reach` codes either way.
pub(super) fn noisy(pixel: Rgb, (x, y): (u32, u32), reach: u8) -> Rgb {
    let steps = 2 * u16::from(reach) + 1;
    [0, 1, 2].map(|c| {
        let step = u16::from(noise(x, y, c)) * steps / 256;
        (u16::from(pixel[c]) + step).saturating_sub(reach.into()).min(255) as u8
    })
}

/// A checkerboard of black and white squares, 8 pixels wide.
pub(super) fn checkerboard(x: u32, y: u32) -> Rgb {
    if (x / 8 + y / 8).is_multiple_of(2) { WHITE } else { BLACK }
}

/// A board of single pixels in two hues, in turns from `phase` on, which fade into
/// one color towards the edges of 64 x 64 pixels, so that the board has no end to
/// be seen.
pub(super) fn fine_hues(x: u32, y: u32, phase: u32) -> Rgb {
    const LAST: u32 = 63;
    const FADE: u32 = 24;
    const BETWEEN: [f64; 3] = [140.0, 103.0, 120.0];
    const AMPLITUDE: [f64; 3] = [32.0, -12.0, -40.0];
    let from_edge = x.min(y).min(LAST - x).min(LAST - y).min(FADE);
    let sign = if (x + y + phase).is_multiple_of(2) { 1.0 } else { -1.0 };
    let share = sign * f64::from(from_edge) / f64::from(FADE);
    [0, 1, 2].map(|c| (BETWEEN[c] + share * AMPLITUDE[c]).round() as u8)
}

/// The eight corners of the cube of colors, a bar each.
pub(super) fn bars(x: u32, _: u32) -> Rgb {
    [x / 8, x / 16, x / 32].map(|count| if count.is_multiple_of(2) { 0 } else { u8::MAX })
}

/// The mean of a pattern over the 3 x 3 pixels around one.
pub(super) fn blurred(pattern: impl Fn(u32, u32) -> Rgb, x: u32, y: u32) -> Rgb {
    let around = |i: u32| [i.saturating_sub(1), i, i + 1];
    let mut sums = [0_u16; 3];
    for (row, column) in around(y).into_iter().flat_map(|row| around(x).map(|c| (row, c))) {
        let pixel = pattern(column, row);
        sums = [0, 1, 2].map(|c| sums[c] + u16::from(pixel[c]));
    }
    sums.map(|sum| (sum / 9) as u8)
}

/// A code encoded once more, as if it were linear.
pub(super) fn gamma_again(code: u8) -> u8 {
    const GAMMA: f64 = 2.2;
    (255.0 * libm::pow(f64::from(code) / 255.0, 1.0 / GAMMA)).round() as u8
}
