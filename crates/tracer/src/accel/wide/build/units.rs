//! `Units`: lengths in which a scene's boxes are neither so large nor so small
//! that the products of the surface area heuristic leave the range of `f32`.

use glam::DVec3;

use super::Box32;
use super::bounds::Bounds;

/// The largest power of two by which coordinates are multiplied or divided: it
/// and its inverse times any `f64` below 2^23 are in the range of `f64`.
const MAX_EXPONENT: i64 = 1000;
/// Bits of an `f64` behind its exponent, and what is added to that.
const EXPONENT_SHIFT: u32 = 52;
const EXPONENT_BIAS: i64 = 1023;

/// The power of two that a scene's coordinates are multiplied by.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Units {
    scale: f64,
}

impl Units {
    /// The scene's own.
    pub(super) const SCENE: Self = Self { scale: 1.0 };

    /// Those in which `largest`, which is finite and not negative, is from 1 to
    /// 2, or as close to it as [`MAX_EXPONENT`] allows.
    pub(super) fn of(largest: f64) -> Self {
        let exponent = (largest.to_bits() >> EXPONENT_SHIFT).cast_signed() - EXPONENT_BIAS;
        let power = (-exponent).clamp(-MAX_EXPONENT, MAX_EXPONENT);
        Self { scale: f64::from_bits(((power + EXPONENT_BIAS).cast_unsigned()) << EXPONENT_SHIFT) }
    }

    /// A point of the scene in these units, rounded where it underflows.
    pub(super) fn convert_point(self, point: DVec3) -> DVec3 {
        point * self.scale
    }

    /// The highest `f32` that in these units is not above `x`.
    #[inline]
    pub(super) fn below(self, x: f64) -> f32 {
        if self.scale == 1.0 {
            return round_down(x);
        }
        // Only where it underflows is the product not exact.
        let product = x * self.scale;
        round_down(if product / self.scale == x { product } else { product.next_down() })
    }

    /// The lowest `f32` that in these units is not below `x`.
    #[inline]
    pub(super) fn above(self, x: f64) -> f32 {
        -self.below(-x) + 0.0
    }

    /// The box in the scene's own lengths.
    ///
    /// A quotient that underflows is rounded to the nearest multiple of the
    /// least `f64`, and so not past any `f64` that the box held.
    pub(super) fn scene_box(self, bounds: Bounds) -> Box32 {
        let (min, max) = (bounds.lo.truncate().to_array(), bounds.hi.truncate().to_array());
        if self.scale == 1.0 {
            return Box32 { min, max };
        }
        Box32 {
            min: min.map(|x| round_down(f64::from(x) / self.scale)),
            max: max.map(|x| -round_down(-f64::from(x) / self.scale) + 0.0),
        }
    }
}

/// The highest `f32` that is not above `x`, without the sign of a zero, so that
/// equal numbers are equal bits.
#[inline]
fn round_down(x: f64) -> f32 {
    let nearest = x as f32;
    // A step down is one back in the bits of a positive number, and one on in
    // those of a negative one; -0.0 is where negative ones round to that are
    // too small.
    let bits = nearest.to_bits().cast_signed();
    let down = if bits < 0 { 1 } else { -1 };
    let step = if f64::from(nearest) > x { down } else { 0 };
    f32::from_bits((bits + step).cast_unsigned()) + 0.0
}
