//! `Precision`: the numbers in which a leaf's triangles are held against a ray.

use crate::math::UNIT_ROUNDOFF;
use crate::simd::{Four, Simd};

/// What a leaf computes in.
pub(super) trait Precision: Copy {
    /// A number.
    type Number: Copy;
    /// Four of them.
    type Lanes<S: Simd>: Four;

    /// The largest error of an edge function, as a part of the square of the
    /// farthest corner's distance from the ray's origin; 0 where it is not asked
    /// for and its sign is taken as it is.
    const DOUBT: f64;

    /// The number, rounded.
    fn round(x: f64) -> Self::Number;
    /// Four times `x`.
    fn splat<S: Simd>(simd: S, x: Self::Number) -> Self::Lanes<S>;
    /// Four numbers.
    fn singles<S: Simd>(simd: S, x: &[f32; 4]) -> Self::Lanes<S>;
    /// Four numbers.
    fn doubles<S: Simd>(simd: S, x: &[f64; 4]) -> Self::Lanes<S>;
    /// `a b - c d`.
    fn determinant<S: Simd>(
        a: Self::Lanes<S>,
        b: Self::Lanes<S>,
        c: Self::Lanes<S>,
        d: Self::Lanes<S>,
    ) -> Self::Lanes<S>;
}

/// In `f64`, to be decided exactly where that is not enough.
#[derive(Clone, Copy)]
pub(super) struct Accurate;

/// In `f32`, for good.
#[derive(Clone, Copy)]
pub(super) struct Fast;

impl Precision for Accurate {
    type Number = f64;
    type Lanes<S: Simd> = S::D4;

    /// With `m` the distance: corners are moved to within 7 roundings of `m`
    /// and are at most `2 m` across, so an edge function, two products of them,
    /// is off by `2 (2 * 2 * 7 + 4) + 8 = 72` roundings of `m^2`; the one that
    /// decides, [`Shear`](super::super::triangle::Shear)'s, whose corners are
    /// within 6, has the sign of one that is off by 48. The rest is slack.
    const DOUBT: f64 = 256.0 * UNIT_ROUNDOFF;

    #[inline(always)]
    fn round(x: f64) -> f64 {
        x
    }
    #[inline(always)]
    fn splat<S: Simd>(simd: S, x: f64) -> S::D4 {
        simd.four_long(x)
    }
    #[inline(always)]
    fn singles<S: Simd>(simd: S, x: &[f32; 4]) -> S::D4 {
        simd.widen_four(x)
    }
    #[inline(always)]
    fn doubles<S: Simd>(simd: S, x: &[f64; 4]) -> S::D4 {
        simd.load_four_long(x)
    }
    #[inline(always)]
    fn determinant<S: Simd>(a: S::D4, b: S::D4, c: S::D4, d: S::D4) -> S::D4 {
        (a * b).minus_product(c, d)
    }
}

impl Precision for Fast {
    type Number = f32;
    type Lanes<S: Simd> = S::F4;

    const DOUBT: f64 = 0.0;

    #[inline(always)]
    fn round(x: f64) -> f32 {
        x as f32
    }
    #[inline(always)]
    fn splat<S: Simd>(simd: S, x: f32) -> S::F4 {
        simd.four(x)
    }
    #[inline(always)]
    fn singles<S: Simd>(simd: S, x: &[f32; 4]) -> S::F4 {
        simd.load_four(x)
    }
    #[inline(always)]
    fn doubles<S: Simd>(simd: S, x: &[f64; 4]) -> S::F4 {
        simd.narrow_four(x)
    }
    /// Both products rounded: the two triangles at an edge, which see it in
    /// opposite directions, then get exactly opposite numbers, and no ray goes
    /// between them.
    #[inline(always)]
    fn determinant<S: Simd>(a: S::F4, b: S::F4, c: S::F4, d: S::F4) -> S::F4 {
        a * b - c * d
    }
}
