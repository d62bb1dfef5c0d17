//! `Sight`: a ray ready for blocks of triangles, and what it sees of one.

use super::blocks::{Block, Number};
use super::precision::Precision;
use crate::Ray;
use crate::math::{Real, UNIT_ROUNDOFF, max_abs};
use crate::simd::{Axis, Four, Simd};

use glam::DVec3;

/// How many times the relative error of its weights `t` may be off, in largest
/// distances of a corner. With both formulas' errors of weights, 120 of the 256
/// roundings that are [`Precision::DOUBT`], they need less than 4, and 10 of
/// their own roundings, which are no more than these; the rest is slack.
const DRAWN: f64 = 16.0;
/// Weights of which one may be off by more than this part of their sum say
/// nothing of `t`.
const MOST_DOUBT: f64 = 1.0 / 8.0;

/// Distances, and the product of one and a unit of `t`, between this and its
/// reciprocal have third powers and roundings of those in the range of `f64`. No
/// others are reckoned with here: all that they may meet is found out exactly.
const LEAST: f64 = 1.0 / (1_u128 << 100) as f64 / (1_u128 << 100) as f64 / (1_u128 << 100) as f64;

/// A ray sheared for blocks of triangles: what
/// [`Shear`](super::super::triangle::Shear) is for one, four at a time.
pub(super) struct Sight<S: Simd, P: Precision> {
    axes: [Axis; 3],
    origin: [P::Lanes<S>; 3],
    slopes: [P::Lanes<S>; 2],
    /// The error of an edge function, and its negative.
    doubt: P::Lanes<S>,
    minus_doubt: P::Lanes<S>,
    /// How much of `t` a unit of depth is, and how far off a `t` may be whose
    /// weights add up to 1.
    time: P::Lanes<S>,
    wrong: P::Lanes<S>,
}

/// What a ray sees of a block that it meets.
pub(super) struct Seen<V> {
    /// A bit for each triangle that it may meet.
    pub(super) met: u32,
    /// The lowest and the highest of the three edge functions, and one over their
    /// sum.
    lowest: V,
    highest: V,
    share: V,
    /// `t`, not quite.
    t: V,
    /// The edge functions across from the second and third corner.
    weights: [V; 2],
}

/// What is known of the triangles of a block, lane by lane.
pub(super) struct Meetings {
    /// A bit for each that is met for sure.
    pub(super) sure: u32,
    /// The `t` of those that are is between these.
    pub(super) lo: [f64; 4],
    pub(super) hi: [f64; 4],
}

/// Three corners, across the ray and along it, and the edge functions across from
/// each.
type Edges<V> = ([[V; 3]; 3], [V; 3]);

/// What a [`Sight`] is made of.
#[derive(Clone, Copy)]
pub(super) struct Sighted {
    axes: [Axis; 3],
    origin: [f64; 3],
    slopes: [f64; 2],
    doubt: f64,
    time: f64,
    wrong: f64,
}

impl Sighted {
    /// The ray, for blocks whose triangles are within `half` of `middle` along
    /// each axis.
    #[inline(always)]
    pub(super) fn new<P: Precision>(ray: &Ray, middle: DVec3, half: f64) -> Self {
        let (origin, direction) = (ray.origin.to_array(), ray.direction.to_array());
        let axes @ [kx, ky, kz] = Axis::from_longest(&direction);
        let farthest = max_abs(ray.origin - middle) + half;
        let time = 1.0 / *kz.of(&direction);
        let wrong = DRAWN * farthest * time.abs();
        // Not so for a NaN.
        let is_usual = LEAST < farthest && farthest < 1.0 / LEAST && LEAST < wrong;
        let doubt = if is_usual || P::DOUBT == 0.0 {
            P::DOUBT * farthest * farthest
        } else {
            f64::INFINITY
        };
        Self {
            axes,
            origin: [*kx.of(&origin), *ky.of(&origin), *kz.of(&origin)],
            slopes: [*kx.of(&direction) * time, *ky.of(&direction) * time],
            doubt,
            time,
            wrong,
        }
    }
}

impl<S: Simd, P: Precision> Sight<S, P> {
    /// The ray, ready for blocks.
    #[inline(always)]
    pub(super) fn new(simd: S, ray: Sighted) -> Self {
        let Sighted { axes, origin: [x, y, z], slopes: [sx, sy], doubt, time, wrong } = ray;
        Self {
            axes,
            origin: [P::splat(simd, x), P::splat(simd, y), P::splat(simd, z)],
            slopes: [P::splat(simd, sx), P::splat(simd, sy)],
            doubt: P::splat(simd, doubt),
            minus_doubt: P::splat(simd, -doubt),
            time: P::splat(simd, time),
            wrong: P::splat(simd, wrong),
        }
    }

    /// Four corners, moved by the shear: across the ray, and along it.
    #[inline(always)]
    fn moved<T: Number>(&self, simd: S, corner: &[[T; 4]; 3]) -> [P::Lanes<S>; 3] {
        let ([kx, ky, kz], [x, y, z], [sx, sy]) = (self.axes, self.origin, self.slopes);
        let z = T::load::<S, P>(simd, kz.of(corner)) - z;
        let x = T::load::<S, P>(simd, kx.of(corner)) - x;
        let y = T::load::<S, P>(simd, ky.of(corner)) - y;
        [x.minus_product(sx, z), y.minus_product(sy, z), z]
    }

    /// Three corners, moved, and the edge functions across from each.
    #[inline(always)]
    fn edges<T: Number>(&self, simd: S, [a, b, c]: &[[[T; 4]; 3]; 3]) -> Edges<P::Lanes<S>> {
        let (a, b, c) = (self.moved(simd, a), self.moved(simd, b), self.moved(simd, c));
        let u = P::determinant::<S>(c[0], b[1], c[1], b[0]);
        let v = P::determinant::<S>(a[0], c[1], a[1], c[0]);
        let w = P::determinant::<S>(b[0], a[1], b[1], a[0]);
        ([a, b, c], [u, v, w])
    }

    /// What the ray sees of the block; `None` if it surely passes by all of it.
    #[inline(always)]
    pub(super) fn look<T: Number>(&self, simd: S, block: &Block<T>) -> Option<Seen<P::Lanes<S>>> {
        let ([a, b, c], [u, v, w]) = self.edges(simd, &block.corners);
        let (lowest, highest) = (u.min(v).min(w), u.max(v).max(w));
        // NaN, which is nobody's triangle, is neither.
        let met = self.minus_doubt.is_at_most(lowest) | highest.is_at_most(self.doubt);
        if met == 0 {
            return None;
        }
        let sum = u + v + w;
        let depths = (u * a[2]).plus_product(v, b[2]).plus_product(w, c[2]);
        let share = P::splat(simd, 1.0) / sum;
        let t = depths * share * self.time;
        Some(Seen { met, lowest, highest, share, t, weights: [v, w] })
    }

    /// What is known of the triangles that were seen.
    ///
    /// With `m` the largest distance, `D` the error of a weight and `W` the
    /// weights' sum: the weighted sum of depths is off by `3 D m` and its
    /// roundings, `W` by `3 D`, so their quotient by `6 D m / (W - 3 D)`, which is
    /// less than `10 m D / W` where `W` is 8 `D` or more.
    #[inline(always)]
    pub(super) fn meetings(&self, simd: S, seen: &Seen<P::Lanes<S>>) -> Meetings {
        let doubts = self.doubt * seen.share.magnitude();
        let outside =
            seen.lowest.is_at_most(self.doubt) & self.minus_doubt.is_at_most(seen.highest);
        let plump = doubts.is_at_most(P::splat(simd, MOST_DOUBT));
        let wrong = self.wrong * (doubts + P::splat(simd, UNIT_ROUNDOFF));
        let (lo, hi) = (seen.t - wrong, seen.t + wrong);
        Meetings { sure: plump & !outside & seen.met, lo: lo.to_array(), hi: hi.to_array() }
    }
}

impl<V: Four> Seen<V> {
    /// `t` of each, where that is not looked at again; NaN for one seen edge-on.
    #[inline(always)]
    pub(super) fn t(&self) -> [f64; 4] {
        self.t.to_array()
    }

    /// The weights of the second and third corner of each.
    #[inline(always)]
    pub(super) fn weights(&self) -> [[f64; 4]; 2] {
        let [v, w] = self.weights;
        [(v * self.share).to_array(), (w * self.share).to_array()]
    }
}

#[cfg(test)]
mod tests;
