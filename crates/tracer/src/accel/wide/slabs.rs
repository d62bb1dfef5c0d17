//! `Slabs`: a ray made ready for tests of eight boxes at a time, in `f32`, that
//! never keep a ray out of a box that it meets.

use super::Wide;
use crate::math::{Real, UNIT_ROUNDOFF, max_abs, power_of_two_below};
use crate::simd::{Eight, Four, Side, Simd};
use crate::{Interval, Ray};

/// Half the distance from 1 to the next `f32`.
const UNIT_ROUNDOFF_F32: f64 = (f32::EPSILON / 2.0) as f64;

/// How many roundings of the largest coordinates of an axis, the boxes' and the
/// origin's, near and far sides are moved apart by. `docs/accuracy.md` proves
/// that 3 are enough; the rest is slack for products of errors.
const ROUNDINGS: f64 = 6.0;

/// The widening of boxes for the rounding of the candidates' own formulas, in
/// roundings of `S`, the origin's largest coordinate plus the boxes':
/// where a shape's test returns `t`, the point `o + t d` is within `32 u S` of
/// the shape's box (`docs/accuracy.md` goes through the shapes).
const PADDING: f64 = 64.0;

/// Boxes are widened by this part of `S` besides, so that a ray along a side is
/// inside as long as it is near.
const THICKNESS: f64 = 1.0 / (1_u64 << 30) as f64;

/// How much boxes are widened, in `S`, whose candidates round so many times more
/// than a shape's own formulas.
pub(super) fn thickness(rounding: f64) -> f64 {
    THICKNESS + PADDING * UNIT_ROUNDOFF * rounding
}

/// The largest reciprocal of a direction's component: a smaller component is
/// taken for one of this size.
pub(super) const LARGEST: f64 = (1_u64 << 60) as f64;
/// The longest component of a direction is between this and its reciprocal,
/// or brought there by a power of two.
pub(super) const LONGEST: f64 = (1_u64 << 20) as f64;
/// An origin farther away than this many times the boxes' largest coordinate
/// would leave the range of `f32`: such a ray enters every box.
pub(super) const FARTHEST: f64 = (1_u64 << 30) as f64;

/// A ray seen by the boxes of a hierarchy. Its parameter is the ray's own times
/// a power of two.
pub(super) struct Slabs<S: Simd> {
    /// For each axis the reciprocal of the direction.
    recip: [S::F8; 3],
    /// What is added to a near side times that, and to a far side.
    near: [S::F8; 3],
    far: [S::F8; 3],
    /// For each axis the side that the ray enters by, and the one it leaves by.
    entry: [Side; 3],
    exit: [Side; 3],
    /// From where on hits count.
    t_min: S::F8,
}

/// From a ray's parameter to that of its [`Slabs`]: two powers of two, whose
/// product may leave the range of `f64`.
#[derive(Clone, Copy)]
pub(crate) struct TimeScale([f64; 2]);

impl TimeScale {
    /// For those who do not walk.
    pub(crate) const ANY: Self = Self([1.0; 2]);

    /// Of rays that are computed with as they are.
    #[inline(always)]
    pub(super) fn of(wide: &Wide) -> Self {
        Self([1.0, wide.scale])
    }

    /// At most the slabs' parameter at the ray's `t`; a NaN, which bounds nothing,
    /// for a `t` of infinity.
    #[inline(always)]
    pub(super) fn down(self, t: f64) -> f32 {
        let t = t * self.0[0] * self.0[1];
        (t - rounding_f32(t)) as f32
    }

    /// At least the slabs' parameter at the ray's `t`; a NaN, which bounds nothing,
    /// for a `t` of minus infinity.
    #[inline(always)]
    pub(crate) fn up(self, t: f64) -> f32 {
        let t = t * self.0[0] * self.0[1];
        (t + rounding_f32(t)) as f32
    }
}

/// More than rounding to `f32` moves a number, but for those so small that it is
/// nothing beside the thickness of a box. 0 stays 0, as a walk's order is that of
/// numbers that are not negative.
#[inline(always)]
fn rounding_f32(x: f64) -> f64 {
    x.abs() * (2.0 * UNIT_ROUNDOFF_F32)
}

/// The largest coordinate of the ray's origin plus the boxes', scaled.
#[inline(always)]
fn reach(wide: &Wide, ray: &Ray) -> f64 {
    max_abs(ray.origin) * wide.scale + wide.largest
}

/// Whether the ray can be computed with as it is: not so for an infinity anywhere.
/// With a NaN nothing is met, and so it does not matter which boxes are entered.
#[inline(always)]
fn is_usual(wide: &Wide, ray: &Ray, reach: f64) -> bool {
    let longest = max_abs(ray.direction);
    1.0 / LONGEST < longest && longest < LONGEST && reach < wide.farthest
}

impl<S: Simd> Slabs<S> {
    /// The ray, with its range, for the boxes of this hierarchy.
    #[inline(always)]
    pub(super) fn new(simd: S, wide: &Wide, ray: &Ray, range: Interval) -> (Self, TimeScale) {
        let reach = reach(wide, ray);
        if !is_usual(wide, ray, reach) {
            return Self::unusual(simd, wide, ray, range);
        }
        let time = TimeScale::of(wide);
        (Self::usual(simd, wide, ray, reach, time.down(range.lo)), time)
    }

    /// A ray whose direction is to be brought to a length that can be computed
    /// with, or that enters every box.
    #[cold]
    fn unusual(simd: S, wide: &Wide, ray: &Ray, range: Interval) -> (Self, TimeScale) {
        let longest = max_abs(ray.direction);
        let reach = reach(wide, ray);
        let unit = power_of_two_below(longest).filter(|_| reach < wide.farthest);
        let time = TimeScale([unit.unwrap_or(1.0), wide.scale]);
        let t_min = time.down(range.lo);
        let slabs = if let Some(unit) = unit {
            let ray = Ray { direction: ray.direction / unit, ..*ray };
            Self::usual(simd, wide, &ray, reach, t_min)
        } else {
            let (near, far) = ([f32::NEG_INFINITY; 3], [f32::INFINITY; 3]);
            Self::of(simd, [0.0; 3], near, far, t_min)
        };
        (slabs, time)
    }

    #[inline(always)]
    fn usual(simd: S, wide: &Wide, ray: &Ray, reach: f64, t_min: f32) -> Self {
        let (o, d) = (ray.origin, ray.direction);
        let origin = simd.load_four_long(&[o.x, o.y, o.z, 1.0]) * simd.four_long(wide.scale);
        let direction = simd.load_four_long(&[d.x, d.y, d.z, 1.0]);
        // That of a component taken for 0 is infinite, or too large.
        let recip = simd.four_long(1.0) / direction;
        let recip = recip.min(simd.four_long(LARGEST)).max(simd.four_long(-LARGEST));
        let extent = simd.load_four_long(&wide.extent);
        let apart =
            Self::apart(simd, wide, origin, extent, simd.four_long(reach)) * recip.magnitude();
        let at = origin * recip;
        let (near, far) = ((-(at + apart)).to_singles(), (apart - at).to_singles());
        let [x, y, z, _] = recip.to_singles();
        let three = |[x, y, z, _]: [f32; 4]| [x, y, z];
        Self::of(simd, [x, y, z], three(near), three(far), t_min)
    }

    /// How far the sides of boxes are moved apart, as lengths.
    #[inline(always)]
    pub(super) fn apart(simd: S, wide: &Wide, origin: S::D4, extent: S::D4, reach: S::D4) -> S::D4 {
        let sizes = origin.magnitude() + extent;
        let roundings = simd.four_long(ROUNDINGS * UNIT_ROUNDOFF_F32);
        (simd.four_long(wide.thickness) * reach).plus_product(sizes, roundings)
    }

    /// The slabs of these numbers.
    #[inline(always)]
    pub(super) fn of(simd: S, recip: [f32; 3], near: [f32; 3], far: [f32; 3], t_min: f32) -> Self {
        let entry @ [x, y, z] = Side::entries(recip);
        Self {
            recip: eights(simd, recip),
            near: eights(simd, near),
            far: eights(simd, far),
            entry,
            exit: [x.other(), y.other(), z.other()],
            t_min: simd.eight(t_min),
        }
    }

    /// A bit for each of the boxes that the ray may meet from its start to
    /// `t_max`, and where it enters each.
    #[inline(always)]
    pub(super) fn enter(&self, simd: S, planes: &[[[f32; 8]; 2]; 3], t_max: f32) -> (u32, S::F8) {
        let [x, y, z] = [0, 1, 2];
        let near = [
            self.side(simd, self.entry[x].of(planes), x, self.near[x]),
            self.side(simd, self.entry[y].of(planes), y, self.near[y]),
            self.side(simd, self.entry[z].of(planes), z, self.near[z]),
        ];
        let far = [
            self.side(simd, self.exit[x].of(planes), x, self.far[x]),
            self.side(simd, self.exit[y].of(planes), y, self.far[y]),
            self.side(simd, self.exit[z].of(planes), z, self.far[z]),
        ];
        // A ray that enters every box multiplies the infinite sides of a child that
        // is not there by 0: the NaN goes through to the comparison.
        let enter = self.t_min.max(near[0]).max(near[1].max(near[2]));
        let leave = simd.eight(t_max).min(far[0]).min(far[1].min(far[2]));
        (enter.is_at_most(leave), enter)
    }

    /// Where the ray crosses one side of each of the boxes.
    #[inline(always)]
    fn side(&self, simd: S, planes: &[f32; 8], axis: usize, plus: S::F8) -> S::F8 {
        simd.load_eight(planes).times_plus(self.recip[axis], plus)
    }
}

#[inline(always)]
fn eights<S: Simd>(simd: S, [x, y, z]: [f32; 3]) -> [S::F8; 3] {
    [simd.eight(x), simd.eight(y), simd.eight(z)]
}

#[cfg(test)]
mod tests;
