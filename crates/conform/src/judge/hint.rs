//! What would make a picture right that is not: the usual mistakes of adapters and
//! of first renderers.

use harness::picture_file::Stored;
use tracer::{Filter, Interval, Rgb, Scene, Size, pixel_center};

use super::levels::pixel_of;
use super::single::{ENOUGH, looks_single};
use super::{Allowance, Judged, Level, Reference, error};
use crate::adapter::{DEFAULT_REACH, Meaning, Rounding, Transfer};
use crate::scale::Scale;

/// What a picture was meant to be that it is not.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Guess {
    /// What its file means.
    meaning: Meaning,
    /// Whether left and right are exchanged.
    is_mirrored: bool,
}

/// By what the interior of a picture would be right that is not, in a sentence.
pub(super) fn hint(
    reference: &Reference<'_>,
    (stored, grid): (&Stored, u32),
    meaning: Meaning,
    (allowance, judged): (Allowance, &Judged),
) -> Option<String> {
    if judged.numbers.interior_off == 0 {
        return None;
    }
    let linear = &reference.rendered.linear;
    let Size { width, .. } = linear.size();
    let scale = Scale::of(linear);
    let is_near =
        |color: Rgb, levels: &[Level; 3]| error(color, levels, scale) <= allowance.tolerance;
    // What is off comes first: most guesses are wrong, and end there.
    let (off, right): (Vec<_>, Vec<_>) = (0..judged.off.len()).partition(|&at| judged.off[at]);
    let all = || off.iter().chain(&right).copied();
    let place = |at: usize| (at as u32 % width, at as u32 / width);
    let is_right = |guess: &Guess| {
        let mut interior = all().filter(|&at| reference.around[at].is_none());
        interior.all(|at| {
            let (x, y) = place(at);
            let x = if guess.is_mirrored { width - 1 - x } else { x };
            let levels = pixel_of(stored, grid, guess.meaning, (x, y));
            is_near(linear.pixels()[at], &levels)
        })
    };
    if let Some(guess) = guesses(meaning).find(is_right) {
        return Some(words(meaning, guess));
    }
    let interior = (0..judged.off.len()).filter(|&at| reference.around[at].is_none());
    let interior = interior.map(|at| (at, pixel_of(stored, grid, meaning, place(at))));
    if allowance.tolerance < ENOUGH && looks_single(linear, interior) {
        return Some(format!(
            "it looks like single precision: all of its interior is within {ENOUGH:e}, most of it by \
             far (`tolerance: {ENOUGH:e}` in its adapter)"
        ));
    }
    let scene = &reference.fixture.scene;
    if grid > 1 || !has_middles(scene) {
        return None;
    }
    let is_of_corner = |corner: &(&str, [f64; 2])| {
        all().all(|at| {
            let levels = pixel_of(stored, grid, meaning, place(at));
            seen_at(scene, place(at), corner.1).any(|color| is_near(color, &levels))
        })
    };
    let (corner, _) = CORNERS.into_iter().find(is_of_corner)?;
    Some(format!(
        "it would be right if its samples were in the middles of pixels: they are in the {corner} \
         corners, half a pixel off"
    ))
}

/// All that a picture may have been meant to be, what is nearest first.
fn guesses(meaning: Meaning) -> impl Iterator<Item = Guess> {
    let mirrored = [false, true].into_iter();
    let turned = mirrored.flat_map(move |is_mirrored| {
        [meaning.rows, meaning.rows.turned()].map(|rows| (is_mirrored, rows))
    });
    let curved = turned
        .flat_map(|(is_mirrored, rows)| Transfer::ALL.map(|curve| (is_mirrored, rows, curve)));
    curved.flat_map(move |(is_mirrored, rows, transfer)| {
        Rounding::ALL
            .map(|rounding| Guess { meaning: Meaning { transfer, rounding, rows }, is_mirrored })
    })
}

fn words(meaning: Meaning, Guess { meaning: other, is_mirrored }: Guess) -> String {
    let mut words = Vec::new();
    if is_mirrored {
        words.push("mirrored left to right".to_owned());
    }
    if other.rows != meaning.rows {
        words.push(format!("upside down (`rows: {:?}` in its adapter)", other.rows));
    }
    if other.transfer != meaning.transfer {
        words.push(format!("with another curve (`transfer: {:?}` in its adapter)", other.transfer));
    }
    if other.rounding != meaning.rounding {
        let rounding = other.rounding;
        words.push(format!(
            "with codes rounded otherwise (`rounding: {rounding:?}` in its adapter)"
        ));
    }
    format!("its interior would be right {}", words.join(" and "))
}

/// The corners of a pixel, from its middle, to the right and up, in pixels.
const CORNERS: [(&str, [f64; 2]); 4] = [
    ("top left", [-0.5, 0.5]),
    ("bottom left", [-0.5, -0.5]),
    ("top right", [0.5, 0.5]),
    ("bottom right", [0.5, -0.5]),
];

/// Whether each pixel is one sample in its middle.
fn has_middles(scene: &Scene) -> bool {
    scene.samples().samples_per_pixel() == 1
        && scene.error().is_none()
        && scene.filter() == Filter::BOX
}

/// The colors that are seen so far from the middle of a pixel, in pixels: there first,
/// then as little around it as may be either side of an edge.
fn seen_at(scene: &Scene, (x, y): (u32, u32), [right, up]: [f64; 2]) -> impl Iterator<Item = Rgb> {
    const NEAR: [f64; 3] = [0.0, -DEFAULT_REACH, DEFAULT_REACH];
    let Size { width, height } = scene.size();
    let camera = scene.camera();
    let of_window = [camera.view_width(), camera.view_height()];
    let middle =
        [pixel_center(x, width, of_window[0]), pixel_center(height - 1 - y, height, of_window[1])];
    let step = [of_window[0] / f64::from(width), of_window[1] / f64::from(height)];
    let near = NEAR.into_iter().flat_map(|b| NEAR.map(|a| (a, b)));
    near.map(move |(a, b)| {
        let ray = camera.ray(middle[0] + (right + a) * step[0], middle[1] + (up + b) * step[1]);
        scene.trace(&ray, Interval::AHEAD) * scene.exposure()
    })
}
