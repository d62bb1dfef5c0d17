//! `edges`: pixels whose sample sees something else when it is moved a little.
//!
//! Two renderers that are both right may see either there. Everywhere else they
//! must agree, however the sample is rounded.

use glam::DVec3;
use rayon::prelude::*;

use super::pattern::{Spot, spot};
use crate::meter::{Unmetered, Work};
use crate::plan::Candidates;
use crate::{Interval, ObjectId, Rgb, Scene, Size, Skipping};

/// What the samples at an edge see in their place and moved around it, exposed, each
/// as it counts in its pixel. What the pixel's other samples see is not among it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Around {
    /// What they see in their place.
    pub here: Rgb,
    /// The least of each channel.
    pub low: Rgb,
    /// The most.
    pub high: Rgb,
    /// How much they count, of the 1 that all samples of a pixel are: 1 for a pixel of
    /// one sample.
    pub weight: f64,
}

impl Around {
    /// Of nothing.
    const NONE: Self = Self { here: Rgb::BLACK, low: Rgb::BLACK, high: Rgb::BLACK, weight: 0.0 };

    /// Of colors that one sample sees, the first of them in its place.
    fn of(colors: &[Rgb]) -> Self {
        let here = colors.first().copied().unwrap_or_default();
        let all = |f: fn(f64, f64) -> f64| {
            let of = |a: Rgb, b: &Rgb| Rgb::new(f(a.r, b.r), f(a.g, b.g), f(a.b, b.b));
            colors.iter().fold(here, of)
        };
        Self { here, low: all(f64::min), high: all(f64::max), weight: 1.0 }
    }

    /// The same that counts so much; what counts against a pixel is the least of it
    /// where it is the most.
    fn counting(self, weight: f64) -> Self {
        let (low, high) = if weight < 0.0 { (self.high, self.low) } else { (self.low, self.high) };
        Self {
            here: self.here * weight,
            low: low * weight,
            high: high * weight,
            weight: self.weight * weight.abs(),
        }
    }

    /// Both together.
    fn and(self, other: Self) -> Self {
        Self {
            here: self.here + other.here,
            low: self.low + other.low,
            high: self.high + other.high,
            weight: self.weight + other.weight,
        }
    }
}

/// Samples that are added where they are needed are anywhere in the pixel, and so
/// few of them see another side of an edge by rounding that they count no more than
/// this.
const ADDED: f64 = 0.125;

/// What is seen around each pixel that is an edge, row by row from the top;
/// `None` for the others.
///
/// A pixel is an edge if one of its samples, moved by `reach` pixels in one of
/// eight directions, sees another object, a normal that jumps, another part of a
/// texture, another light in shadow, or any of these in a mirror or through glass. Of
/// a filter, the samples of all pixels in its reach count. Samples that are added
/// where they are needed are anywhere in the pixel: it is looked at from its middle, a
/// whole pixel around, and of [`Around`] the place is then not that of a sample.
pub fn edges(scene: &Scene, reach: f64) -> Vec<Option<Around>> {
    let Size { width, height } = scene.size();
    let reach = if scene.error().is_some() { 1.0 } else { reach };
    // Row 0 at the bottom, as samples are.
    let row = |j: u32| (0..width).map(|i| samples_at_edges(scene, (i, j), reach)).collect();
    let rows: Vec<Vec<_>> = (0..height).into_par_iter().map(row).collect();
    let line = |y: u32| (0..width).map(|i| pixel(scene, &rows, (i, height - 1 - y))).collect();
    let lines: Vec<Vec<_>> = (0..height).into_par_iter().map(line).collect();
    lines.concat()
}

/// A sample at an edge: how far right and up of its pixel's middle it is, and what is
/// seen around it.
type AtEdge = ([f64; 2], Around);

/// What a pixel shows of samples at edges, its own and those that a filter brings.
fn pixel(scene: &Scene, rows: &[Vec<Vec<AtEdge>>], (i, j): (u32, u32)) -> Option<Around> {
    let (Size { width, height }, filter) = (scene.size(), scene.filter());
    let reach = filter.reach();
    let rows_near = j.saturating_sub(reach)..=(j + reach).min(height - 1);
    let columns = i.saturating_sub(reach)..=(i + reach).min(width - 1);
    let near = || rows_near.clone().flat_map(|y| columns.clone().map(move |x| (x, y)));
    let at = |(x, y): (u32, u32)| &rows[y as usize][x as usize];
    if near().all(|place| at(place).is_empty()) {
        return None;
    }
    let count = scene.samples().samples_per_pixel();
    let density = |(x, y): (u32, u32), [right, up]: [f64; 2]| {
        if reach == 0 {
            return 1.0;
        }
        let away = |from: u32, to: u32| f64::from(from) - f64::from(to);
        filter.density(away(x, i) + right) * filter.density(away(y, j) + up)
    };
    let (mut all, mut found) = (0.0, Around::NONE);
    for place in near() {
        all += (0..count).map(|k| density(place, spot(scene, place, k).offset)).sum::<f64>();
        for &(offset, around) in at(place) {
            found = found.and(around.counting(density(place, offset)));
        }
    }
    let share = if scene.error().is_some() { ADDED } else { 1.0 } / all;
    (found.weight > 0.0).then(|| found.counting(share))
}

/// What one look sees.
struct Seen {
    color: Rgb,
    /// Which object, and the normal that it is shaded by.
    surface: Option<(ObjectId, DVec3)>,
    /// What else tells one part of a picture from another that lies on the same
    /// surface: the part of its texture, and the lights in shadow, or all that is seen
    /// in a mirror or through glass.
    mark: (u32, u64),
}

/// The eight ways that a sample is moved, each beside its opposite.
const WAYS: [[f64; 2]; 8] = [
    [1.0, 0.0],
    [-1.0, 0.0],
    [0.0, 1.0],
    [0.0, -1.0],
    [1.0, 1.0],
    [-1.0, -1.0],
    [1.0, -1.0],
    [-1.0, 1.0],
];

/// Those of a pixel's samples that are at an edge, row 0 at the bottom.
fn samples_at_edges(scene: &Scene, at: (u32, u32), reach: f64) -> Vec<AtEdge> {
    let camera = scene.camera();
    let step = [
        camera.view_width() / f64::from(scene.size().width) * reach,
        camera.view_height() / f64::from(scene.size().height) * reach,
    ];
    let sample = |k: u32| {
        let Spot { window: [a, b], offset } = spot(scene, at, k);
        let here = look(scene, [a, b]);
        let there = WAYS.map(|[x, y]| look(scene, [a + x * step[0], b + y * step[1]]));
        let is_edge =
            there.as_chunks::<2>().0.iter().any(|pair| is_between_two(&here, pair, reach));
        let colors = [&here].into_iter().chain(&there).map(|seen| seen.color * scene.exposure());
        is_edge.then(|| (offset, Around::of(&colors.collect::<Vec<_>>())))
    };
    (0..scene.samples().samples_per_pixel()).filter_map(sample).collect()
}

fn look(scene: &Scene, [a, b]: [f64; 2]) -> Seen {
    let ray = scene.camera().ray(a, b);
    let work = Work::new(Unmetered, Skipping::On, scene.lights().len());
    let range = Interval::AHEAD;
    let hit = scene.world().intersect_among(Candidates::All, &ray, range, &work.meter);
    let Some(hit) = hit else {
        return Seen { color: scene.background(), surface: None, mark: (0, 0) };
    };
    let look = scene.trace_among(Candidates::All, &ray, range, &work);
    Seen {
        color: look.color,
        surface: Some((hit.object, *hit.shading_normal)),
        mark: (look.texel, look.shadows),
    }
}

/// Whether something changes from one side of `here` to the other.
fn is_between_two(here: &Seen, sides: &[Seen; 2], reach: f64) -> bool {
    /// How far the middle normal may be from the mean of those beside it, twice, at
    /// the shortest reach. At a crease it is off by the whole turn.
    const JUMP: f64 = 1e-3;
    // On what is smooth it is off by the square of what it turns by: of a ball of a
    // pixel's radius, by the square of the reach.
    let jump = JUMP + reach * reach;
    let is_alike = |side: &Seen| {
        side.mark == here.mark
            && side.surface.map(|(object, _)| object) == here.surface.map(|(object, _)| object)
    };
    if !sides.iter().all(is_alike) {
        return true;
    }
    let normal = |seen: &Seen| seen.surface.map_or(DVec3::ZERO, |(_, normal)| normal);
    let bend = normal(&sides[0]) + normal(&sides[1]) - 2.0 * normal(here);
    bend.length() > jump
}

#[cfg(test)]
mod tests;
