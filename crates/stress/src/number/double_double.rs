//! `Dd`: a number as the unevaluated sum of two `f64`, the oracle's volume
//! number.
//!
//! With `u = 2^-53`, every operation has a relative error of a few `u^2`
//! (`u^2` is about 1.2e-32), stated where it is defined. The bounds hold while
//! no operand, partial product or result leaves about 2^-900 to 2^1000 in
//! magnitude; below, the error is absolute, about 2^-1074; above, the result
//! is not finite. Zero is inside.
//!
//! Source: Joldes, Muller, Popescu, "Tight and rigorous error bounds for basic
//! building blocks of double-word arithmetic", ACM TOMS 44(2), 2017, whose
//! algorithm numbers and bounds are quoted; machine-checked, and where it
//! differs tightened, by Muller and Rideau, "Formalization of double-word
//! arithmetic", ACM TOMS 48(1), 2022.

use std::cmp::Ordering;
use std::ops::{Add, Div, Mul, Neg, Sub};

use super::Number;

/// `hi + lo`, where `hi` is that sum rounded to the nearest `f64`.
///
/// That makes the two parts unique for a number, so that comparing `hi`, then
/// `lo`, is comparing the numbers.
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd)]
pub struct Dd {
    hi: f64,
    lo: f64,
}

impl Dd {
    /// `a + b`, exactly; so also the number whose two parts are `a` and `b`.
    ///
    /// Source: Knuth, "The Art of Computer Programming", volume 2, section
    /// 4.2.2 (`2Sum`).
    #[inline]
    pub fn sum(a: f64, b: f64) -> Self {
        let hi = a + b;
        let b_seen = hi - a;
        Self { hi, lo: (a - (hi - b_seen)) + (b - b_seen) }
    }

    /// `a b`, exactly, unless `0 < |a b| < 2^-968`: then within 2^-1074.
    #[inline]
    pub fn product(a: f64, b: f64) -> Self {
        let hi = a * b;
        Self { hi, lo: a.mul_add(b, -hi) }
    }

    /// `a + b`, exactly, if the exponent of `a` is not below that of `b`, or
    /// `a` is zero.
    ///
    /// Source: Dekker, "A Floating-Point Technique for Extending the Available
    /// Precision", 1971 (`Fast2Sum`).
    #[inline]
    fn sum_descending(a: f64, b: f64) -> Self {
        let hi = a + b;
        Self { hi, lo: b - (hi - a) }
    }

    /// The part that is the nearest `f64`.
    #[inline]
    pub const fn hi(self) -> f64 {
        self.hi
    }

    /// The rest, at most half a unit in the last place of [`Dd::hi`].
    #[inline]
    pub const fn lo(self) -> f64 {
        self.lo
    }
}

impl Add for Dd {
    type Output = Self;

    /// Relative error at most `3 u^2 + 13 u^3`, also where the terms cancel;
    /// commutative. Source: algorithm 6, `AccurateDWPlusDW`.
    #[inline]
    fn add(self, other: Self) -> Self {
        let high = Self::sum(self.hi, other.hi);
        let low = Self::sum(self.lo, other.lo);
        let most = Self::sum_descending(high.hi, high.lo + low.hi);
        Self::sum_descending(most.hi, low.lo + most.lo)
    }
}

impl Sub for Dd {
    type Output = Self;

    /// As addition.
    #[inline]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Dd {
    type Output = Self;

    /// Relative error at most `7 u^2` (2017; `5 u^2` by the proof of 2022).
    /// Commutative, unlike the variants with one more `mul_add`, so `a b - b a`
    /// is zero and a vector's cross product with itself vanishes.
    /// Source: algorithm 10, `DWTimesDW1`.
    #[inline]
    fn mul(self, other: Self) -> Self {
        let high = Self::product(self.hi, other.hi);
        let mixed = self.hi * other.lo + self.lo * other.hi;
        Self::sum_descending(high.hi, high.lo + mixed)
    }
}

impl Div for Dd {
    type Output = Self;

    /// Relative error at most `15 u^2 + 56 u^3`; `x / x` is 1. Not finite if
    /// `other` is zero. Source: algorithm 17, `DWDivDW2`.
    #[inline]
    fn div(self, other: Self) -> Self {
        let quotient = self.hi / other.hi;
        // The divisor times the quotient so far: algorithm 9, `DWTimesFP3`.
        let high = Self::product(other.hi, quotient);
        let taken = Self::sum_descending(high.hi, other.lo.mul_add(quotient, high.lo));
        let rest = (self.hi - taken.hi) + (self.lo - taken.lo);
        Self::sum_descending(quotient, rest / other.hi)
    }
}

impl Neg for Dd {
    type Output = Self;

    /// Exact.
    #[inline]
    fn neg(self) -> Self {
        Self { hi: -self.hi, lo: -self.lo }
    }
}

impl Number for Dd {
    #[inline]
    fn of(x: f64) -> Self {
        Self { hi: x, lo: 0.0 }
    }

    /// Relative error at most `25/8 u^2`; the root of an exact square of an
    /// `f64` is that `f64`.
    ///
    /// Source: Lefevre, Louvet, Muller, Picot, Rideau, "Accurate Calculation of
    /// Euclidean Norms Using Double-Word Arithmetic", ACM TOMS 49(1), 2023
    /// (`SQRTDWtoDW`).
    #[inline]
    fn sqrt(self) -> Self {
        if self.hi == 0.0 {
            return self;
        }
        let root = self.hi.sqrt();
        let rest = (-root).mul_add(root, self.hi) + self.lo;
        Self::sum_descending(root, rest / (2.0 * root))
    }

    #[inline]
    fn to_f64(&self) -> f64 {
        self.hi
    }

    #[inline]
    fn sign(&self) -> Ordering {
        // A rounded sum is zero only if the sum is: `hi` alone has the sign.
        self.hi.partial_cmp(&0.0).unwrap_or(Ordering::Less)
    }

    #[inline]
    fn is_finite(&self) -> bool {
        self.hi.is_finite() && self.lo.is_finite()
    }

    /// Exact, short of overflow.
    #[inline]
    fn difference(a: f64, b: f64) -> Self {
        Self::sum(a, -b)
    }
}
