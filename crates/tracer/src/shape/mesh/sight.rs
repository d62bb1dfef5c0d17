//! `Sight`: a ray ready for blocks of triangles, and what it sees of one.

use super::blocks::{Block, Number};
use super::precision::Precision;
use crate::Ray;
use crate::accel::wide::{Abreast, longest};
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

/// A ray sheared for blocks of triangles, four at a time: what
/// [`Shear`](super::super::triangle::Shear) is for one. Its numbers stay in
/// memory, as there are more of them than a processor has places for.
#[derive(Clone, Copy)]
pub(super) struct Sight<'a, S: Simd, P: Precision> {
    simd: S,
    ray: &'a Sighted<P>,
}

/// What a ray sees of a block.
pub(super) struct Seen<V> {
    /// A bit for each triangle that it may meet inside the range.
    pub(super) met: u32,
    /// A bit for each of those that it meets for sure, though not that it does
    /// so inside the range.
    pub(super) sure: u32,
    /// The `t` of those that are sure is between these.
    lo: V,
    hi: V,
    /// `t`, not quite; NaN for a triangle seen edge-on.
    t: V,
    /// The edge functions across from the second and third corner, and one over
    /// the sum of all.
    weights: [V; 2],
    share: V,
}

/// Three corners, across the ray and along it, and the edge functions across from
/// each.
type Edges<V> = ([[V; 3]; 3], [V; 3]);

/// A ray along its axes, of which the last is the one that its direction is
/// longest in.
#[derive(Clone, Copy)]
pub(super) struct Sighted<P: Precision> {
    axes: [Axis; 3],
    origin: [P::Number; 3],
    slopes: [P::Number; 2],
    /// The error of an edge function, and its negative.
    doubt: P::Number,
    minus_doubt: P::Number,
    /// How much of `t` a unit of depth is, and how far off a `t` may be whose
    /// weights add up to 1.
    time: P::Number,
    wrong: P::Number,
}

impl<P: Precision> Sighted<P> {
    /// None yet.
    #[inline(always)]
    pub(super) fn nothing() -> Self {
        let zero = P::round(0.0);
        Self {
            axes: Axis::from_longest(&[0.0; 3]),
            origin: [zero; 3],
            slopes: [zero; 2],
            doubt: zero,
            minus_doubt: zero,
            time: zero,
            wrong: zero,
        }
    }

    /// The ray, for blocks whose triangles are within `half` of `middle` along
    /// each axis.
    #[inline(always)]
    pub(super) fn new(ray: &Ray, middle: DVec3, half: f64) -> Self {
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
        let slope = |k: Axis| P::round(*k.of(&direction) * time);
        let start = |k: Axis| P::round(*k.of(&origin));
        Self {
            axes,
            origin: [start(kx), start(ky), start(kz)],
            slopes: [slope(kx), slope(ky)],
            doubt: P::round(doubt),
            minus_doubt: P::round(-doubt),
            time: P::round(time),
            wrong: P::round(wrong),
        }
    }

    /// [`Sighted::new`] of four rays, which are `abreast`.
    #[inline(always)]
    pub(super) fn fill<S: Simd>(
        simd: S,
        sighted: &mut [Self; 4],
        rays: &[&Ray; 4],
        abreast: &Abreast<S::D4>,
        (middle, half): (DVec3, f64),
    ) {
        let [x, y, z] = abreast.origin;
        let (x, y) = (x - simd.four_long(middle.x), y - simd.four_long(middle.y));
        let z = z - simd.four_long(middle.z);
        let farthest = longest([x, y, z]) + simd.four_long(half);
        let [x, y, z] = abreast.direction;
        let (x, y, z) = (x.magnitude(), y.magnitude(), z.magnitude());
        let wrong = simd.four_long(DRAWN) * farthest / x.max(y).max(z);
        let least = simd.four_long(LEAST);
        let is_usual = least.is_at_most(farthest)
            & farthest.is_at_most(simd.four_long(1.0 / LEAST))
            & least.is_at_most(wrong);
        let doubt = (simd.four_long(P::DOUBT) * farthest * farthest).to_array();
        let wrong = wrong.to_array();
        let is_x = y.is_at_most(x) & z.is_at_most(x);
        let is_z = !z.is_at_most(y) & !is_x;
        for lane in 0..4 {
            let (origin, direction) = (rays[lane].origin.as_ref(), rays[lane].direction.as_ref());
            let axes @ [kx, ky, kz] = Axis::cycle(is_x >> lane, is_z >> lane);
            let is_usual = is_usual >> lane & 1 == 1 || P::DOUBT == 0.0;
            let doubt = if is_usual { doubt[lane] } else { f64::INFINITY };
            let time = 1.0 / *kz.of(direction);
            sighted[lane] = Self {
                axes,
                origin: [
                    P::round(*kx.of(origin)),
                    P::round(*ky.of(origin)),
                    P::round(*kz.of(origin)),
                ],
                slopes: [P::round(*kx.of(direction) * time), P::round(*ky.of(direction) * time)],
                doubt: P::round(doubt),
                minus_doubt: P::round(-doubt),
                time: P::round(time),
                wrong: P::round(wrong[lane]),
            };
        }
    }
}

impl<'a, S: Simd, P: Precision> Sight<'a, S, P> {
    /// The ray, ready for blocks.
    #[inline(always)]
    pub(super) fn new(simd: S, ray: &'a Sighted<P>) -> Self {
        Self { simd, ray }
    }

    /// Four times one of the ray's numbers.
    #[inline(always)]
    fn four(&self, x: P::Number) -> P::Lanes<S> {
        P::splat(self.simd, x)
    }

    /// Four corners, moved by the shear: across the ray, and along it.
    #[inline(always)]
    fn moved<T: Number>(&self, corner: &[[T; 4]; 3]) -> [P::Lanes<S>; 3] {
        let Sighted { axes: [kx, ky, kz], origin: [x, y, z], slopes: [sx, sy], .. } = *self.ray;
        let z = T::load::<S, P>(self.simd, kz.of(corner)) - self.four(z);
        let x = T::load::<S, P>(self.simd, kx.of(corner)) - self.four(x);
        let y = T::load::<S, P>(self.simd, ky.of(corner)) - self.four(y);
        [x.minus_product(self.four(sx), z), y.minus_product(self.four(sy), z), z]
    }

    /// Three corners, moved, and the edge functions across from each.
    #[inline(always)]
    fn edges<T: Number>(&self, [a, b, c]: &[[[T; 4]; 3]; 3]) -> Edges<P::Lanes<S>> {
        let (a, b, c) = (self.moved(a), self.moved(b), self.moved(c));
        let u = P::determinant::<S>(c[0], b[1], c[1], b[0]);
        let v = P::determinant::<S>(a[0], c[1], a[1], c[0]);
        let w = P::determinant::<S>(b[0], a[1], b[1], a[0]);
        ([a, b, c], [u, v, w])
    }

    /// What the ray sees of the block from `from` to `to`. All is found before it
    /// is asked whether anything is met, as a guess would be wrong too often.
    ///
    /// With `m` the largest distance, `D` the error of a weight and `W` the
    /// weights' sum: the weighted sum of depths is off by `3 D m` and its
    /// roundings, `W` by `3 D`, so their quotient by `6 D m / (W - 3 D)`, which is
    /// less than `10 m D / W` where `W` is 8 `D` or more.
    #[inline(always)]
    pub(super) fn look<T: Number>(
        &self,
        block: &Block<T>,
        (from, to): (f64, f64),
    ) -> Seen<P::Lanes<S>> {
        let ([a, b, c], [u, v, w]) = self.edges(&block.corners);
        let (lowest, highest) = (u.min(v).min(w), u.max(v).max(w));
        let (doubt, minus_doubt) = (self.four(self.ray.doubt), self.four(self.ray.minus_doubt));
        // NaN, which is nobody's triangle, is neither.
        let met = minus_doubt.is_at_most(lowest) | highest.is_at_most(doubt);
        let sum = u + v + w;
        let depths = (u * a[2]).plus_product(v, b[2]).plus_product(w, c[2]);
        let share = self.four(P::round(1.0)) / sum;
        let t = depths * share * self.four(self.ray.time);
        let (from, to) = (self.four(P::round(from)), self.four(P::round(to)));
        let (lo, hi, sure, met) = if P::DOUBT == 0.0 {
            (t, t, met, met & from.is_at_most(t) & t.is_at_most(to))
        } else {
            let doubts = doubt * share.magnitude();
            let outside = lowest.is_at_most(doubt) & minus_doubt.is_at_most(highest);
            let plump = doubts.is_at_most(self.four(P::round(MOST_DOUBT)));
            let wrong = self.four(self.ray.wrong) * (doubts + self.four(P::round(UNIT_ROUNDOFF)));
            let (lo, hi) = (t - wrong, t + wrong);
            let sure = plump & !outside;
            (lo, hi, sure, met & (!sure | from.is_at_most(hi) & lo.is_at_most(to)))
        };
        Seen { met, sure: sure & met, lo, hi, t, weights: [v, w], share }
    }
}

impl<V: Four> Seen<V> {
    /// Between which `t` those are that are sure.
    #[inline(always)]
    pub(super) fn range(&self) -> [[f64; 4]; 2] {
        [self.lo.to_array(), self.hi.to_array()]
    }

    /// `t` of each, where that is not looked at again.
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
