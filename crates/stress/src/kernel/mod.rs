//! The textbook kernels: plain functions from a primitive's numbers and a ray
//! to the first `t` in a range, each in the precision it is given.
//!
//! They are what goldray is compared with, so each is written from its method
//! as a careful implementer would, without a trick that the method does not
//! have. All take directions of any length, return the lowest `t` strictly
//! inside the range, and accept by positive tests, so that a NaN is a miss.
//!
//! Every kernel is kept out of line: whoever times them pays one call for
//! each, as for a kernel of the tracer, which is in another crate.

pub mod of_case;
pub mod sphere;
pub mod triangle;

use std::ops::{Add, Div, Mul, Neg, Sub};

/// The arithmetic that the kernels need of `f32` and `f64`. Everything is
/// rounded as IEEE 754 says and nothing is fused.
pub trait Real:
    Copy
    + PartialOrd
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// 0.
    const ZERO: Self;
    /// 1.
    const ONE: Self;
    /// Positive infinity.
    const INFINITY: Self;

    /// The nearest number.
    fn of(x: f64) -> Self;

    /// The square root; NaN below zero.
    #[must_use]
    fn sqrt(self) -> Self;

    /// The magnitude.
    #[must_use]
    fn abs(self) -> Self;
}

macro_rules! real {
    ($name:ident) => {
        impl Real for $name {
            const ZERO: Self = 0.0;
            const ONE: Self = 1.0;
            const INFINITY: Self = $name::INFINITY;

            #[inline]
            fn of(x: f64) -> Self {
                x as $name
            }

            #[inline]
            fn sqrt(self) -> Self {
                $name::sqrt(self)
            }

            #[inline]
            fn abs(self) -> Self {
                $name::abs(self)
            }
        }
    };
}

real!(f32);
// A cast to the type itself is what the macro writes for the wider one.
mod double {
    #![allow(clippy::cast_lossless, clippy::unnecessary_cast)]
    use super::Real;
    real!(f64);
}

/// Three coordinates.
pub type Vector<R> = [R; 3];

/// A half line `origin + t direction`, with a direction of any length.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ray<R> {
    /// Where it starts.
    pub origin: Vector<R>,
    /// Where it goes.
    pub direction: Vector<R>,
}

/// The open range of `t` in which a hit counts; NaN is never inside.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Range<R> {
    /// The lower end.
    pub lo: R,
    /// The upper end; may be infinite.
    pub hi: R,
}

impl<R: Real> Range<R> {
    /// Everything in front of the ray's origin.
    pub const AHEAD: Self = Self { lo: R::ZERO, hi: R::INFINITY };

    /// Whether `t` is strictly inside.
    #[inline]
    pub fn contains(self, t: R) -> bool {
        self.lo < t && t < self.hi
    }
}

#[inline]
fn minus<R: Real>(a: Vector<R>, b: Vector<R>) -> Vector<R> {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// `a + s b`.
#[inline]
fn along<R: Real>(a: Vector<R>, s: R, b: Vector<R>) -> Vector<R> {
    [a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]]
}

#[inline]
fn dot<R: Real>(a: Vector<R>, b: Vector<R>) -> R {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

#[inline]
fn cross<R: Real>(a: Vector<R>, b: Vector<R>) -> Vector<R> {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// The number of the axis along which the vector is longest, and of the two
/// that follow it in turn: `[x, y, z]` such that `z` is the longest.
#[inline]
fn axes_of<R: Real>(v: Vector<R>) -> [usize; 3] {
    let [x, y, z] = v.map(R::abs);
    if x >= y && x >= z {
        [1, 2, 0]
    } else if y >= z {
        [2, 0, 1]
    } else {
        [0, 1, 2]
    }
}
