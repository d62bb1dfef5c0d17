//! `V3`: a vector of three numbers of the oracle.

use std::ops::{Add, Neg, Sub};

use tracer::glam::DVec3;

use super::Number;

/// A vector in any of the oracle's numbers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct V3<N> {
    /// Along x.
    pub x: N,
    /// Along y.
    pub y: N,
    /// Along z.
    pub z: N,
}

impl<N> V3<N> {
    /// A vector of its components.
    pub const fn new(x: N, y: N, z: N) -> Self {
        Self { x, y, z }
    }
}

impl<N: Number> V3<N> {
    /// `v`, exactly.
    #[inline]
    pub fn of(v: DVec3) -> Self {
        Self::new(N::of(v.x), N::of(v.y), N::of(v.z))
    }

    /// `a - b`, by [`Number::difference`].
    #[inline]
    pub fn difference(a: DVec3, b: DVec3) -> Self {
        Self::new(N::difference(a.x, b.x), N::difference(a.y, b.y), N::difference(a.z, b.z))
    }

    /// The nearest `f64` to each component.
    #[inline]
    pub fn to_f64(&self) -> DVec3 {
        DVec3::new(self.x.to_f64(), self.y.to_f64(), self.z.to_f64())
    }

    /// `factor` times this.
    #[inline]
    #[must_use]
    pub fn scale(&self, factor: &N) -> Self {
        let times = |component: &N| component.clone() * factor.clone();
        Self::new(times(&self.x), times(&self.y), times(&self.z))
    }

    /// `self . other`.
    #[inline]
    pub fn dot(&self, other: &Self) -> N {
        self.x.clone() * other.x.clone()
            + self.y.clone() * other.y.clone()
            + self.z.clone() * other.z.clone()
    }

    /// `self x other`.
    #[inline]
    #[must_use]
    pub fn cross(&self, other: &Self) -> Self {
        let minor = |a: &N, b: &N, c: &N, d: &N| a.clone() * b.clone() - c.clone() * d.clone();
        Self::new(
            minor(&self.y, &other.z, &self.z, &other.y),
            minor(&self.z, &other.x, &self.x, &other.z),
            minor(&self.x, &other.y, &self.y, &other.x),
        )
    }

    /// `self . self`.
    #[inline]
    pub fn length_squared(&self) -> N {
        self.x.square() + self.y.square() + self.z.square()
    }

    /// The Euclidean length. The squares are taken as they are: components
    /// stay within 2^-450 and 2^500 for [`Dd`](super::Dd).
    #[inline]
    pub fn length(&self) -> N {
        self.length_squared().sqrt()
    }

    /// Whether every component is a finite number.
    #[inline]
    pub fn is_finite(&self) -> bool {
        self.x.is_finite() && self.y.is_finite() && self.z.is_finite()
    }
}

impl<N: Number> Add for V3<N> {
    type Output = Self;

    #[inline]
    fn add(self, other: Self) -> Self {
        Self::new(self.x + other.x, self.y + other.y, self.z + other.z)
    }
}

impl<N: Number> Sub for V3<N> {
    type Output = Self;

    #[inline]
    fn sub(self, other: Self) -> Self {
        Self::new(self.x - other.x, self.y - other.y, self.z - other.z)
    }
}

impl<N: Number> Neg for V3<N> {
    type Output = Self;

    #[inline]
    fn neg(self) -> Self {
        Self::new(-self.x, -self.y, -self.z)
    }
}
