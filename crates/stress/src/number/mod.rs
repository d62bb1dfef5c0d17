//! The oracle's numbers: one formula, evaluated in two precisions.
//!
//! [`Dd`] (106 bits, fast) answers in volume, [`Big`] (512 bits, slow) settles
//! what [`Dd`] cannot, and [`Number`] is what a formula needs of either.
//! [`agreement`] measures how far apart the two are.

pub mod agreement;
mod arbitrary;
mod double_double;
mod vector;

use std::cmp::Ordering;
use std::fmt::Debug;
use std::ops::{Add, Div, Mul, Neg, Sub};

pub use agreement::{Agreement, RaySphere};
pub use arbitrary::Big;
pub use double_double::Dd;
pub use vector::V3;

/// A real number of some precision, as far as a formula of geometry needs it.
///
/// Whatever is not a finite number (a NaN or an infinity given to
/// [`Number::of`], a division by zero, the root of a negative number, an
/// overflow) is not [`Number::is_finite`], makes every result it enters not
/// finite, and after one operation compares with nothing. So tests that
/// accept, as `if discriminant >= N::zero()`, refuse it.
pub trait Number:
    Clone
    + Debug
    + PartialOrd
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// `x`, exactly.
    fn of(x: f64) -> Self;

    /// The square root; not finite below zero. A caller for whom a negative
    /// number is a rounding error writes `x.max(N::zero()).sqrt()`.
    #[must_use]
    fn sqrt(self) -> Self;

    /// The nearest `f64`; infinite beyond `f64::MAX`, NaN for what is no number.
    fn to_f64(&self) -> f64;

    /// The order of `self` to zero: `Less` is negative. What is no number is
    /// `Less`, as a miss is the answer that claims nothing.
    fn sign(&self) -> Ordering;

    /// Whether this is a number at all, and not infinite.
    fn is_finite(&self) -> bool;

    /// 0.
    fn zero() -> Self {
        Self::of(0.0)
    }

    /// 1.
    fn one() -> Self {
        Self::of(1.0)
    }

    /// `a - b`: exact wherever the precision holds the difference.
    fn difference(a: f64, b: f64) -> Self {
        Self::of(a) - Self::of(b)
    }

    /// `self^2`, rounded once, as `self * self` is.
    #[must_use]
    fn square(&self) -> Self {
        self.clone() * self.clone()
    }

    /// The magnitude.
    #[must_use]
    fn abs(self) -> Self {
        if self.sign() == Ordering::Less { -self } else { self }
    }

    /// The larger; `other` if either is no number.
    #[must_use]
    fn max(self, other: Self) -> Self {
        if self >= other { self } else { other }
    }

    /// The smaller; `other` if either is no number.
    #[must_use]
    fn min(self, other: Self) -> Self {
        if self <= other { self } else { other }
    }
}

#[cfg(test)]
mod tests;
