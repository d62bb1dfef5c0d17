//! The box of the part of a triangle that is between two planes.

use glam::{DVec3, Vec4};

use super::bounds::Bounds;
use super::units::Units;
use crate::Aabb;
use crate::math::UNIT_ROUNDOFF;

/// What a point of an edge may be off by, in units of the roundoff and of the
/// corners' largest coordinate. `a + (p - a) / (b - a) * (b - a)` rounds each
/// of a difference below 2, a quotient below 1 known to three roundings, a
/// product below 2 and a sum: 2 (1 + 3 + 1) + 1 = 11, and a little more.
const ROUNDINGS: f64 = 12.0;

/// The box of what is inside of `within` of the triangle with these corners
/// between the planes `lo` and `hi` across an axis; `None` where there is
/// nothing. `within` and the planes are in `units`, the corners in the scene's.
pub(super) fn triangle_between(
    corners: [DVec3; 3],
    units: Units,
    within: Bounds,
    axis: usize,
    [lo, hi]: [f32; 2],
) -> Option<Bounds> {
    let slab = slab(within, axis, [lo, hi]);
    let corners = corners.map(|corner| units.convert_point(corner));
    let planes = [slab.lo[axis], slab.hi[axis]].map(f64::from);
    let mut part = Aabb::EMPTY;
    for (k, &a) in corners.iter().enumerate() {
        if planes[0] <= a[axis] && a[axis] <= planes[1] {
            part = part.union(Aabb { min: a, max: a });
        }
        let b = corners[(k + 1) % corners.len()];
        for plane in planes {
            let [above_a, above_b] = [a[axis] > plane, b[axis] > plane];
            if above_a != above_b {
                let crossing = a + (plane - a[axis]) / (b[axis] - a[axis]) * (b - a);
                part = part.union(Aabb { min: crossing, max: crossing });
            }
        }
    }
    let largest = Aabb::around(corners).max_abs();
    // The least normal number is for the corners' own rounding in units in
    // which they underflow.
    let part = part.widened(ROUNDINGS * UNIT_ROUNDOFF * largest + f64::MIN_POSITIVE);
    let unscaled = Units::SCENE;
    let lane = |x: DVec3, round: fn(Units, f64) -> f32| {
        let [x, y, z] = x.to_array().map(|x| round(unscaled, x));
        Vec4::new(x, y, z, 1.0)
    };
    let part = Bounds { lo: lane(part.min, Units::below), hi: lane(part.max, Units::above) };
    let clipped = Bounds { lo: part.lo.max(slab.lo), hi: part.hi.min(slab.hi) };
    (!clipped.is_empty()).then_some(clipped)
}

/// What of a box is between the planes.
#[inline(always)]
pub(super) fn slab(within: Bounds, axis: usize, [lo, hi]: [f32; 2]) -> Bounds {
    let (mut min, mut max) = (within.lo, within.hi);
    min[axis] = min[axis].max(lo);
    max[axis] = max[axis].min(hi);
    Bounds { lo: min, hi: max }
}
