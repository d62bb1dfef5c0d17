//! `edges`: pixels whose sample sees something else when it is moved a little.
//!
//! Two renderers that are both right may see either there. Everywhere else they
//! must agree, however the sample is rounded.

use glam::DVec3;
use rayon::prelude::*;

use super::pattern::spot;
use crate::meter::{Unmetered, Work};
use crate::plan::Candidates;
use crate::{Interval, ObjectId, Rgb, Scene, Size, Skipping};

/// What a pixel's sample sees in its place and moved around it, exposed: the
/// least and the most of each channel.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Around {
    /// The least.
    pub low: Rgb,
    /// The most.
    pub high: Rgb,
}

impl Around {
    fn of(color: Rgb) -> Self {
        Self { low: color, high: color }
    }

    /// The same with another one.
    #[must_use]
    pub fn with(self, color: Rgb) -> Self {
        let of = |f: fn(f64, f64) -> f64, a: Rgb, b: Rgb| {
            Rgb::new(f(a.r, b.r), f(a.g, b.g), f(a.b, b.b))
        };
        Self { low: of(f64::min, self.low, color), high: of(f64::max, self.high, color) }
    }
}

/// What is seen around each pixel that is an edge, row by row from the top;
/// `None` for the others.
///
/// A pixel is an edge if one of its samples, moved by `reach` pixels in one of
/// eight directions, sees another object, a normal that jumps, another part of a
/// texture, another light in shadow, or any of these in a mirror or through glass. Of a filter, the samples of all pixels in its reach count. Samples
/// that are added where they are needed are anywhere in the pixel: it is
/// looked at from its middle, a whole pixel around.
pub fn edges(scene: &Scene, reach: f64) -> Vec<Option<Around>> {
    let Size { width, height } = scene.size();
    let reach = if scene.error().is_some() { 1.0 } else { reach };
    let row = |y: u32| (0..width).map(|i| pixel(scene, (i, height - 1 - y), reach)).collect();
    let rows: Vec<Vec<_>> = (0..height).into_par_iter().map(row).collect();
    let alone = rows.concat();
    match scene.filter().reach() {
        0 => alone,
        reach => spread(scene.size(), &alone, reach),
    }
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

/// What is seen around a pixel, row 0 at the bottom, if it is an edge.
fn pixel(scene: &Scene, at: (u32, u32), reach: f64) -> Option<Around> {
    let camera = scene.camera();
    let step = [
        camera.view_width() / f64::from(scene.size().width) * reach,
        camera.view_height() / f64::from(scene.size().height) * reach,
    ];
    let mut is_edge = false;
    let mut around: Option<Around> = None;
    for k in 0..scene.samples().samples_per_pixel() {
        let [a, b] = spot(scene, at, k).window;
        let here = look(scene, [a, b]);
        let there = WAYS.map(|[x, y]| look(scene, [a + x * step[0], b + y * step[1]]));
        is_edge |= there.as_chunks::<2>().0.iter().any(|pair| is_between_two(&here, pair, reach));
        for color in there.iter().map(|seen| seen.color).chain([here.color]) {
            let color = color * scene.exposure();
            around = Some(around.map_or(Around::of(color), |around| around.with(color)));
        }
    }
    around.filter(|_| is_edge)
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

/// Edges of a picture whose pixels get light from others so far away.
fn spread(size: Size, alone: &[Option<Around>], reach: u32) -> Vec<Option<Around>> {
    let (width, height) = (size.width, size.height);
    let at = |x: u32, y: u32| alone[y as usize * width as usize + x as usize];
    let pixel = |(x, y): (u32, u32)| {
        let rows = y.saturating_sub(reach)..=(y + reach).min(height - 1);
        let columns = x.saturating_sub(reach)..=(x + reach).min(width - 1);
        let near = rows.flat_map(|y| columns.clone().map(move |x| (x, y)));
        near.filter_map(|(x, y)| at(x, y)).reduce(|a, b| a.with(b.low).with(b.high))
    };
    (0..height).flat_map(|y| (0..width).map(move |x| (x, y))).map(pixel).collect()
}

#[cfg(test)]
mod tests;
