//! Cuts along a plane: a candidate that crosses it goes to both sides, as two
//! parts in smaller boxes.
//!
//! Source: Stich, Friedrich and Dietrich, "Spatial Splits in Bounding Volume
//! Hierarchies", 2009.

use glam::{DVec3, Vec4};
use rayon::prelude::*;

use super::bins::SHARED;
use super::bounds::Bounds;
use super::clip::{slab, triangle_between};
use super::partition::Set;
use super::reference::Reference;
use super::units::Units;
use crate::simd::{Level, Simd, Work};

/// Slabs that planes are looked for between.
const SLABS: usize = 16;
/// References of large sets are put into slabs by this many at a time.
const CHUNK: usize = 1 << 12;

/// A plane across an axis.
#[derive(Debug, Clone, Copy)]
pub(super) struct Plane {
    axis: usize,
    at: f32,
    /// The sum over both sides of area times blocks, as far as the slabs tell.
    pub cost: f32,
}

/// The clipping of candidates.
pub(super) struct Knife<'a> {
    pub units: Units,
    /// A candidate's corners, if it is a triangle.
    pub corners: &'a (dyn Fn(u32) -> Option<[DVec3; 3]> + Sync),
}

impl Knife<'_> {
    /// The part of a reference between two planes; `None` where there is none.
    fn part(&self, reference: &Reference, axis: usize, planes: [f32; 2]) -> Option<Reference> {
        let (within, number) = (reference.bounds(), reference.number());
        let bounds = match (self.corners)(number) {
            Some(corners) => triangle_between(corners, self.units, within, axis, planes)?,
            None => slab(within, axis, planes),
        };
        let xyz = |v: glam::Vec4| v.truncate().to_array();
        Some(Reference::new(xyz(bounds.lo), xyz(bounds.hi), number))
    }
}

/// What is in one of the slabs.
#[derive(Clone, Copy)]
struct Slab {
    bounds: Bounds,
    /// How many references start in it, and how many end.
    starts: u32,
    ends: u32,
}

/// The slabs of a set along an axis.
struct Slabs {
    axis: usize,
    base: f32,
    step: f32,
    per_step: f32,
    all: [Slab; SLABS],
}

impl Slabs {
    fn new(around: Bounds, axis: usize) -> Self {
        let step = (around.hi[axis] - around.lo[axis]) / SLABS as f32;
        let empty = Slab { bounds: Bounds::EMPTY, starts: 0, ends: 0 };
        Self { axis, base: around.lo[axis], step, per_step: 1.0 / step, all: [empty; SLABS] }
    }

    /// The plane before a slab.
    #[inline(always)]
    fn plane(&self, slab: usize) -> f32 {
        self.base + slab as f32 * self.step
    }

    #[inline(always)]
    fn slab_of(&self, x: f32) -> usize {
        // Saturating, and 0 for NaN.
        (((x - self.base) * self.per_step) as usize).min(SLABS - 1)
    }

    /// Puts a reference into the slabs that its box is in. That the part of a
    /// triangle is smaller than that of its box is left out: it hardly ever
    /// makes another plane the best, and takes five times as long.
    #[inline(always)]
    fn add(&mut self, reference: &Reference) {
        let bounds = reference.bounds();
        let [start, end] = [bounds.lo[self.axis], bounds.hi[self.axis]].map(|x| self.slab_of(x));
        self.all[start].starts += 1;
        self.all[end].ends += 1;
        if start == end {
            let slot = &mut self.all[start].bounds;
            *slot = slot.union(bounds);
        } else {
            for k in start..=end {
                let part = slab(bounds, self.axis, [self.plane(k), self.plane(k + 1)]);
                let slot = &mut self.all[k].bounds;
                *slot = slot.union(part);
            }
        }
    }

    /// All of both, which are slabs of one set.
    fn union(mut self, other: &Self) -> Self {
        for (slab, other) in self.all.iter_mut().zip(&other.all) {
            slab.bounds = slab.bounds.union(other.bounds);
            slab.starts += other.starts;
            slab.ends += other.ends;
        }
        self
    }

    fn best_plane(&self, block_shift: u32) -> Option<Plane> {
        let blocks = |n: u32| n.div_ceil(1 << block_shift) as f32;
        let mut right_costs = [0.0; SLABS];
        let (mut bounds, mut count) = (Bounds::EMPTY, 0);
        for k in (1..SLABS).rev() {
            bounds = bounds.union(self.all[k].bounds);
            count += self.all[k].ends;
            right_costs[k] = bounds.half_area() * blocks(count);
        }
        let mut best: Option<Plane> = None;
        let (mut bounds, mut count) = (Bounds::EMPTY, 0);
        for (k, slab) in (1..SLABS).zip(&self.all) {
            bounds = bounds.union(slab.bounds);
            count += slab.starts;
            // NaN where a side is empty.
            let cost = bounds.half_area() * blocks(count) + right_costs[k];
            if cost < best.map_or(f32::INFINITY, |b| b.cost) {
                best = Some(Plane { axis: self.axis, at: self.plane(k), cost });
            }
        }
        best
    }
}

/// Puts references into slabs.
struct Fill<'a> {
    slabs: &'a mut Slabs,
    references: &'a [Reference],
}

impl Work for Fill<'_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self, _: S) {
        for reference in self.references {
            self.slabs.add(reference);
        }
    }
}

/// The plane that costs least across the longest axis, or across a shorter one if
/// none across a longer one costs less than `limit`; `None` if none does at all.
///
/// That another axis has an even better one is rare, and looking there takes as
/// long again.
pub(super) fn first_plane(
    level: Level,
    set: &Set,
    references: &[Reference],
    block_shift: u32,
    limit: f32,
) -> Option<Plane> {
    let mut axes = [0, 1, 2];
    let width = |axis: usize| set.bounds.hi[axis] - set.bounds.lo[axis];
    axes.sort_by(|&a, &b| width(b).total_cmp(&width(a)));
    let plane = |axis| best_plane(level, set.bounds, axis, references, block_shift);
    axes.into_iter().filter_map(plane).find(|plane| plane.cost < limit)
}

/// The plane across an axis that costs least.
fn best_plane(
    level: Level,
    around: Bounds,
    axis: usize,
    references: &[Reference],
    block_shift: u32,
) -> Option<Plane> {
    let fill = |references: &[Reference]| {
        let mut slabs = Slabs::new(around, axis);
        level.run(Fill { slabs: &mut slabs, references });
        slabs
    };
    let slabs = if references.len() < SHARED {
        fill(references)
    } else {
        let empty = || Slabs::new(around, axis);
        references.par_chunks(CHUNK).map(fill).reduce(empty, |a, b| a.union(&b))
    };
    slabs.best_plane(block_shift)
}

/// Puts the parts on the left of the plane at the start of `to`, and those on
/// the right at its end; returns the sides and how many are in each. `None`
/// if there is no room, or a side is empty or has as many as the whole.
pub(super) fn cut_along(
    plane: Plane,
    from: &[Reference],
    to: &mut [Reference],
    knife: &Knife<'_>,
) -> Option<([Set; 2], [usize; 2])> {
    // In the other lanes nothing is beyond the plane.
    let (mut left_end, mut right_end) = (Vec4::INFINITY, Vec4::NEG_INFINITY);
    left_end[plane.axis] = plane.at;
    right_end[plane.axis] = plane.at;
    let (mut next, mut end) = (0, to.len());
    let mut sides = [Set::EMPTY; 2];
    for reference in from {
        let bounds = reference.bounds();
        let [left, right] = if bounds.hi.cmple(left_end).all() {
            [Some(*reference), None]
        } else if bounds.lo.cmpge(right_end).all() {
            [None, Some(*reference)]
        } else {
            let part = |planes| knife.part(reference, plane.axis, planes);
            [part([f32::NEG_INFINITY, plane.at]), part([plane.at, f32::INFINITY])]
        };
        if end - next < usize::from(left.is_some()) + usize::from(right.is_some()) {
            return None;
        }
        if let Some(left) = left {
            to[next] = left;
            sides[0] = sides[0].with(&left);
            next += 1;
        }
        if let Some(right) = right {
            end -= 1;
            to[end] = right;
            sides[1] = sides[1].with(&right);
        }
    }
    let counts = [next, to.len() - end];
    let makes_progress = counts.iter().all(|n| (1..from.len()).contains(n));
    makes_progress.then_some((sides, counts))
}
