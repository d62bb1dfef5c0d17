//! `Big`: a number of 512 bits, the oracle's arbiter.
//!
//! Every operation is the exact result rounded once, half to even, to
//! [`Big::BITS`] bits. The exponent is a machine word, so nothing that starts
//! from an `f64` overflows or underflows in a formula of geometry.

use std::cmp::Ordering;
use std::ops::{Add, Div, Mul, Neg, Sub};

use dashu_float::round::Rounded;
use dashu_float::round::mode::HalfEven;
use dashu_float::{Context, FBig, Repr};

use super::{Dd, Number};

/// How every operation rounds.
const ROUNDED: Context<HalfEven> = Context::new(Big::BITS);

/// A binary floating-point number of [`Big::BITS`] bits, with one zero; or,
/// as `None`, what is no finite number, which compares with nothing.
#[derive(Debug, Clone)]
pub struct Big(Option<Repr<2>>);

impl Big {
    /// The precision. A ray-sphere discriminant, of degree 4 in its inputs, is
    /// exact in 512 bits while the inputs' exponents are within about 60 of
    /// each other: `4 (53 + 60)` bits and a few carries.
    pub const BITS: usize = 512;

    /// A result, if it is a finite number. The library's negative zero is
    /// dropped: it would not equal the positive one.
    fn of_result(value: Option<Repr<2>>) -> Self {
        Self(
            value
                .filter(Repr::is_finite)
                .map(|v| if v.significand().is_zero() { Repr::zero() } else { v }),
        )
    }

    /// `operation(self, other)` if both are numbers.
    fn with(
        self,
        other: Self,
        operation: impl FnOnce(Repr<2>, Repr<2>) -> Option<Repr<2>>,
    ) -> Self {
        Self::of_result(self.0.zip(other.0).and_then(|(a, b)| operation(a, b)))
    }
}

/// The number of a result that carries its rounding.
fn number(result: Rounded<FBig<HalfEven>>) -> Repr<2> {
    result.value().into_repr()
}

impl From<Dd> for Big {
    /// Exact if the two parts span at most [`Big::BITS`] bits, as they do for
    /// every result that was rounded; else rounded.
    fn from(x: Dd) -> Self {
        Self::of(x.hi()) + Self::of(x.lo())
    }
}

impl PartialEq for Big {
    fn eq(&self, other: &Self) -> bool {
        self.partial_cmp(other) == Some(Ordering::Equal)
    }
}

impl PartialOrd for Big {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.0.as_ref()?.cmp(other.0.as_ref()?))
    }
}

impl Add for Big {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        self.with(other, |a, b| ROUNDED.add(&a, &b).ok().map(number))
    }
}

impl Sub for Big {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self.with(other, |a, b| ROUNDED.sub(&a, &b).ok().map(number))
    }
}

impl Mul for Big {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        self.with(other, |a, b| ROUNDED.mul(&a, &b).ok().map(number))
    }
}

impl Div for Big {
    type Output = Self;

    /// Not finite if `other` is zero.
    fn div(self, other: Self) -> Self {
        self.with(other, |a, b| ROUNDED.div(&a, &b).ok().map(number))
    }
}

impl Neg for Big {
    type Output = Self;

    fn neg(self) -> Self {
        Self::of_result(self.0.map(|v| -v))
    }
}

impl Number for Big {
    fn of(x: f64) -> Self {
        Self::of_result(Repr::try_from(x).ok())
    }

    fn sqrt(self) -> Self {
        Self::of_result(self.0.and_then(|v| ROUNDED.sqrt(&v).ok().map(number)))
    }

    /// The nearest `f64`, ties to even, subnormals included.
    fn to_f64(&self) -> f64 {
        self.0.as_ref().map_or(f64::NAN, |v| v.to_f64().value())
    }

    fn sign(&self) -> Ordering {
        self.0.as_ref().map_or(Ordering::Less, |v| v.cmp(&Repr::zero()))
    }

    fn is_finite(&self) -> bool {
        self.0.is_some()
    }

    fn square(&self) -> Self {
        Self::of_result(self.0.as_ref().and_then(|v| ROUNDED.sqr(v).ok().map(number)))
    }
}
