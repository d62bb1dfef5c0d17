//! `Rgb`: linear radiance or reflectance in three channels.
//!
//! Components are plain `f64` without a unit or an upper bound. An encoded
//! 8-bit colour is another type and lives in another crate.

use std::ops::{Add, AddAssign, Mul};

/// A linear colour: radiance of a pixel, intensity of a light, or reflectance
/// of a surface, depending on where it stands.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Rgb {
    /// Red.
    pub r: f64,
    /// Green.
    pub g: f64,
    /// Blue.
    pub b: f64,
}

impl Rgb {
    /// No light.
    pub const BLACK: Self = Self::new(0.0, 0.0, 0.0);
    /// One in each channel.
    pub const WHITE: Self = Self::new(1.0, 1.0, 1.0);

    /// A colour from its channels.
    pub const fn new(r: f64, g: f64, b: f64) -> Self {
        Self { r, g, b }
    }

    /// The channels in the order red, green, blue.
    pub const fn channels(self) -> [f64; 3] {
        [self.r, self.g, self.b]
    }

    /// Whether every channel is a finite number.
    pub fn is_finite(self) -> bool {
        self.r.is_finite() && self.g.is_finite() && self.b.is_finite()
    }
}

impl From<[f64; 3]> for Rgb {
    fn from([r, g, b]: [f64; 3]) -> Self {
        Self { r, g, b }
    }
}

impl Add for Rgb {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self::new(self.r + other.r, self.g + other.g, self.b + other.b)
    }
}

impl AddAssign for Rgb {
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

/// Scales every channel.
impl Mul<f64> for Rgb {
    type Output = Self;
    fn mul(self, s: f64) -> Self {
        Self::new(self.r * s, self.g * s, self.b * s)
    }
}

/// Channel by channel: reflectance times light.
impl Mul for Rgb {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self::new(self.r * other.r, self.g * other.g, self.b * other.b)
    }
}
