//! `judge`: another renderer's picture beside goldray's own.
//!
//! goldray's linear picture is the reference. Interior pixels must be within the
//! adapter's tolerance of it, each channel relative to the brightest of the pixel.
//! Edge pixels, whose sample sees something else when it is moved a little
//! ([`tracer::edges`]), may show either side, and are counted. What a fixture
//! expects on paper is asked of the foreign picture as well.

mod expect;
mod hint;
mod levels;
mod single;

pub use levels::{Level, Levels};

use harness::expectation::Rendered;
use harness::fixture::Fixture;
use tracer::{Around, LinearImage, Rgb, Size};

use crate::Numbers;
use crate::adapter::{Adapter, Meaning};
use crate::card::counted;
use crate::scale::Scale;
use harness::picture_file::Stored;

/// How much a picture may differ.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Allowance {
    /// Of an interior pixel, relative.
    pub tolerance: f64,
    /// Which share of the edge pixels may be off.
    pub edges: f64,
}

impl Allowance {
    /// What an adapter allows.
    pub fn of(adapter: &Adapter) -> Self {
        Self { tolerance: adapter.tolerance, edges: adapter.edges }
    }
}

/// What a picture is held against.
#[derive(Debug, Clone, Copy)]
pub struct Reference<'a> {
    /// What its pixels are expected to be.
    pub fixture: &'a Fixture,
    /// goldray's picture of it.
    pub rendered: &'a Rendered,
    /// What is seen around each edge pixel, row by row from the top.
    pub around: &'a [Option<Around>],
}

/// What is found of a picture.
#[derive(Debug, Clone, PartialEq)]
pub struct Judged {
    /// How it compares.
    pub numbers: Numbers,
    /// Whether each pixel is beyond the tolerance, row by row from the top.
    pub off: Vec<bool>,
    /// What is wrong with it, in sentences; empty if nothing is.
    pub findings: Vec<String>,
}

/// Judges a picture of the reference's size.
pub fn judge(reference: &Reference<'_>, levels: &Levels, allowance: Allowance) -> Judged {
    let linear = &reference.rendered.linear;
    let scale = Scale::of(linear);
    let errors: Vec<f64> = linear
        .pixels()
        .iter()
        .zip(levels.pixels())
        .map(|(pixel, levels)| error(*pixel, levels, scale))
        .collect();
    let is_off = |error: f64| !(error <= allowance.tolerance);
    let off: Vec<bool> = errors.iter().map(|&error| is_off(error)).collect();
    let numbers = numbers(linear.size(), &errors, &off, reference.around);
    let mut findings = Vec::new();
    if let (true, Some(at)) = (numbers.interior_off > 0, numbers.worst_at) {
        findings.push(interior(&numbers, at, linear, levels, allowance.tolerance));
    }
    let share = allowance.edges * numbers.edge_pixels as f64;
    if numbers.edge_off as f64 > share {
        findings.push(format!(
            "{} of {} edge pixels differ: expected at most {}",
            numbers.edge_off,
            numbers.edge_pixels,
            share.floor()
        ));
    }
    if 2 * numbers.edge_off > numbers.pixels {
        // Between both sides is then nearly everything.
        findings.push(format!(
            "{} of {} pixels are at edges and differ: expected at least half of the picture to \
             agree",
            numbers.edge_off, numbers.pixels
        ));
    }
    findings.extend(strange(reference, levels, &off, scale, allowance.tolerance));
    findings.extend(expect::broken(reference, levels, scale, allowance.tolerance));
    Judged { numbers, off, findings }
}

/// What would make the interior of a picture right that is judged not to be, if that is
/// simple: another meaning of its file, sides that are exchanged, samples in the corners
/// of pixels.
pub fn hint(
    reference: &Reference<'_>,
    stored: (&Stored, u32),
    meaning: Meaning,
    judged: (Allowance, &Judged),
) -> Option<String> {
    hint::hint(reference, stored, meaning, judged)
}

/// How far a pixel is from the nearest that the file could stand for.
fn error(pixel: Rgb, levels: &[Level; 3], scale: Scale) -> f64 {
    let distances = pixel.channels().into_iter().zip(levels);
    distances.map(|(c, level)| level.distance(c)).fold(0.0, f64::max) / scale.at(pixel)
}

fn numbers(size: Size, errors: &[f64], off: &[bool], around: &[Option<Around>]) -> Numbers {
    let width = size.width as usize;
    let mut numbers = Numbers {
        pixels: errors.len() as u64,
        edge_pixels: 0,
        edge_off: 0,
        interior_off: 0,
        worst_interior: 0.0,
        worst_at: None,
    };
    for (at, ((&error, &off), around)) in errors.iter().zip(off).zip(around).enumerate() {
        if around.is_some() {
            numbers.edge_pixels += 1;
            numbers.edge_off += u64::from(off);
            continue;
        }
        numbers.interior_off += u64::from(off);
        if error > numbers.worst_interior {
            numbers.worst_interior = error;
            numbers.worst_at = Some(((at % width) as u32, (at / width) as u32));
        }
    }
    numbers
}

/// The sentence about interior pixels.
fn interior(
    numbers: &Numbers,
    (x, y): (u32, u32),
    linear: &LinearImage,
    levels: &Levels,
    tolerance: f64,
) -> String {
    let expected = linear.get(x, y).unwrap_or_default().channels();
    let found = levels.nominal().get(x, y).unwrap_or_default().channels();
    let interior = numbers.pixels - numbers.edge_pixels;
    format!(
        "{} of {interior} interior pixels differ by more than {tolerance:e}, the worst ({x}, {y}) \
         by {:.3e}: expected {}, found {}",
        numbers.interior_off,
        numbers.worst_interior,
        triple(expected),
        triple(found)
    )
}

/// A color as people read it.
fn triple(color: [f64; 3]) -> String {
    let [r, g, b] = color.map(|c| format!("{c:.7}"));
    format!("({r}, {g}, {b})")
}

/// The same of each channel.
fn by_channel(f: fn(f64, f64) -> f64) -> impl Fn(Rgb, Rgb) -> Rgb {
    move |a, b| Rgb::new(f(a.r, b.r), f(a.g, b.g), f(a.b, b.b))
}

/// Edge pixels that show neither side, nor anything between. Of several samples only
/// those at an edge may show either.
fn strange(
    reference: &Reference<'_>,
    levels: &Levels,
    off: &[bool],
    scale: Scale,
    tolerance: f64,
) -> Option<String> {
    /// How far beyond both sides a pixel may be, in parts of the brightest: what
    /// lies right at a silhouette may be a little brighter than what is seen a
    /// hundredth of a pixel beside it.
    const BEYOND: f64 = 0.1;
    let linear = &reference.rendered.linear;
    let Size { width, height } = linear.size();
    let is_added = reference.fixture.scene.error().is_some();
    let is_strange = |&at: &usize| {
        let Some(around) = reference.around[at].filter(|_| off[at]) else { return false };
        let expected = linear.pixels()[at];
        let (x, y) = (at as u32 % width, at as u32 / width);
        let rows = y.saturating_sub(1)..=(y + 1).min(height - 1);
        let columns = x.saturating_sub(1)..=(x + 1).min(width - 1);
        let near = rows.flat_map(|y| columns.clone().map(move |x| (x, y)));
        let near = near.filter_map(|(x, y)| linear.get(x, y));
        let near: Vec<Rgb> = near.collect();
        let (least, most) = (by_channel(f64::min), by_channel(f64::max));
        let of_all =
            |f: &dyn Fn(Rgb, Rgb) -> Rgb| near.iter().copied().reduce(f).unwrap_or_default();
        // Of samples that are added where they are needed the place is not known.
        let here = if is_added { expected * around.weight } else { around.here };
        let others = expected + here * -1.0;
        let low = others + least(around.low, of_all(&least) * around.weight);
        let high = others + most(around.high, of_all(&most) * around.weight);
        let slack = (BEYOND * around.weight + tolerance) * scale.at(high).max(scale.at(low));
        let between = low.channels().into_iter().zip(high.channels());
        let mut pairs = between.zip(&levels.pixels()[at]);
        pairs.any(|((low, high), level)| !level.meets(Level { low, high }.widened(slack)))
    };
    let strange: Vec<usize> = (0..off.len()).filter(is_strange).collect();
    let &first = strange.first()?;
    let (x, y) = (first as u32 % width, first as u32 / width);
    let found = levels.nominal().get(x, y).unwrap_or_default().channels();
    Some(format!(
        "{} neither of what is on both sides, the first ({x}, {y}): found {}",
        counted(strange.len() as u64, "edge pixel shows", "edge pixels show"),
        triple(found)
    ))
}

#[cfg(test)]
mod tests;
