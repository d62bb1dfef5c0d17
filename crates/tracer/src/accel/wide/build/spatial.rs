//! Cuts along a plane: a candidate that crosses it goes to both sides, as two
//! parts in smaller boxes.
//!
//! Source: Stich, Friedrich and Dietrich, "Spatial Splits in Bounding Volume
//! Hierarchies", 2009.

use glam::{DVec3, Vec3};

use super::bounds::Bounds;
use super::clip::{slab, triangle_between};
use super::partition::Set;
use super::reference::Reference;
use super::units::Units;

/// Slabs per axis that planes are looked for between.
const SLABS: usize = 16;

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

/// What is in one of the slabs along an axis.
#[derive(Clone, Copy)]
struct Slab {
    bounds: Bounds,
    /// How many references start in it, and how many end.
    starts: u32,
    ends: u32,
}

impl Slab {
    #[inline]
    fn add(&mut self, bounds: Bounds) {
        self.bounds = self.bounds.union(bounds);
    }
}

/// The slabs along an axis of a set.
struct Slabs {
    axis: usize,
    base: f32,
    step: f32,
    per_step: f32,
    all: [Slab; SLABS],
}

impl Slabs {
    fn new(around: Bounds, axis: usize) -> Self {
        let empty = Slab { bounds: Bounds::EMPTY, starts: 0, ends: 0 };
        let step = (around.hi[axis] - around.lo[axis]) / SLABS as f32;
        Self { axis, base: around.lo[axis], step, per_step: 1.0 / step, all: [empty; SLABS] }
    }

    /// The plane before a slab.
    fn plane(&self, slab: usize) -> f32 {
        self.base + slab as f32 * self.step
    }

    fn slab_of(&self, x: f32) -> usize {
        // Saturating, and 0 for NaN.
        (((x - self.base) * self.per_step) as usize).min(SLABS - 1)
    }

    /// Puts a reference into the slabs. Boxes of parts are not conservative
    /// here: they only tell which plane to take.
    fn add(&mut self, reference: &Reference, knife: &Knife<'_>) {
        let bounds = reference.bounds();
        let ends = [bounds.lo[self.axis], bounds.hi[self.axis]].map(|x| self.slab_of(x));
        self.all[ends[0]].starts += 1;
        self.all[ends[1]].ends += 1;
        if ends[0] == ends[1] {
            self.all[ends[0]].add(bounds);
        } else if let Some(corners) = (knife.corners)(reference.number()) {
            self.add_triangle(corners.map(|c| knife.units.convert_point(c).as_vec3()), bounds);
        } else {
            for k in ends[0]..=ends[1] {
                self.all[k].add(slab(bounds, self.axis, [self.plane(k), self.plane(k + 1)]));
            }
        }
    }

    /// Puts its corners, and the points where edges go through planes, into the
    /// slabs that they are in or between; only what is in the box `within`, as
    /// far as the axis tells.
    fn add_triangle(&mut self, corners: [Vec3; 3], within: Bounds) {
        let axis = self.axis;
        let (lo, hi) = (within.lo[axis], within.hi[axis]);
        for k in 0..3 {
            let [a, b] = [corners[k], corners[(k + 1) % 3]];
            let point = |p: Vec3| {
                let p = p.extend(1.0).max(within.lo).min(within.hi);
                Bounds { lo: p, hi: p }
            };
            if lo <= a[axis] && a[axis] <= hi {
                self.all[self.slab_of(a[axis])].add(point(a));
            }
            let [from, to] = [a[axis].min(b[axis]).max(lo), a[axis].max(b[axis]).min(hi)];
            if !(from < to) {
                continue;
            }
            let slope = (b - a) / (b[axis] - a[axis]);
            let crossing = |x: f32| point(a + slope * (x - a[axis]));
            let [from_slab, to_slab] = [from, to].map(|x| self.slab_of(x));
            self.all[from_slab].add(crossing(from));
            self.all[to_slab].add(crossing(to));
            for k in from_slab + 1..=to_slab {
                let crossing = crossing(self.plane(k));
                self.all[k - 1].add(crossing);
                self.all[k].add(crossing);
            }
        }
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

/// The plane that costs least.
pub(super) fn best_plane(
    set: &Set,
    references: &[Reference],
    knife: &Knife<'_>,
    block_shift: u32,
) -> Option<Plane> {
    let mut best: Option<Plane> = None;
    for axis in 0..3 {
        let mut slabs = Slabs::new(set.bounds, axis);
        if !(slabs.step > 0.0) {
            continue;
        }
        for reference in references {
            slabs.add(reference, knife);
        }
        let plane = slabs.best_plane(block_shift);
        let better = plane.filter(|p| p.cost < best.map_or(f32::INFINITY, |b| b.cost));
        best = better.or(best);
    }
    best
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
    let (mut next, mut end) = (0, to.len());
    for reference in from {
        let bounds = reference.bounds();
        let (lo, hi) = (bounds.lo[plane.axis], bounds.hi[plane.axis]);
        let [left, right] = if hi <= plane.at {
            [Some(*reference), None]
        } else if lo >= plane.at {
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
            next += 1;
        }
        if let Some(right) = right {
            end -= 1;
            to[end] = right;
        }
    }
    let counts = [next, to.len() - end];
    let makes_progress = counts.iter().all(|n| (1..from.len()).contains(n));
    makes_progress.then(|| ([Set::of(&to[..next]), Set::of(&to[end..])], counts))
}
