//! The arithmetic that more than one formula needs, with the same bits on
//! every system.
//!
//! `+ - * /`, `sqrt` and `mul_add` are exact in IEEE 754; everything else
//! comes from `libm`, which is the same code everywhere.

use std::ops::{Add, Div, Mul, Neg, Sub};

use glam::DVec3;

use crate::Ray;

/// Half the distance from 1 to the next `f64`: the largest relative error of
/// one rounding.
pub(crate) const UNIT_ROUNDOFF: f64 = f64::EPSILON / 2.0;

/// A number, or several that the same is done with: what makes one formula serve
/// a single ray and four at a time, with the same bits.
pub(crate) trait Real:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// `self times + plus`, rounded once.
    fn fused(self, times: Self, plus: Self) -> Self;
    /// Without its sign.
    fn magnitude(self) -> Self;
    /// This number, as many times.
    fn like(self, x: f64) -> Self;
    /// The number where `test` is above 0, else 0.
    fn where_positive(self, test: Self) -> Self;
}

impl Real for f64 {
    #[inline(always)]
    fn fused(self, times: Self, plus: Self) -> Self {
        self.mul_add(times, plus)
    }
    #[inline(always)]
    fn magnitude(self) -> Self {
        self.abs()
    }
    #[inline(always)]
    fn like(self, x: f64) -> Self {
        x
    }
    #[inline(always)]
    fn where_positive(self, test: Self) -> Self {
        if test > 0.0 { self } else { 0.0 }
    }
}

/// `a b - c d` with an error of at most 1.5 units in the last place and,
/// short of underflow, the exact sign.
///
/// Source: W. Kahan's fused-multiply-add determinant; error bound by
/// Jeannerod, Louvet and Muller, "Further analysis of Kahan's algorithm for
/// the accurate computation of 2x2 determinants", 2013.
#[inline(always)]
pub(crate) fn difference_of_products<R: Real>(a: R, b: R, c: R, d: R) -> R {
    let cd = c * d;
    let error = (-c).fused(d, cd);
    a.fused(b, -cd) + error
}

/// `a + b` as a rounded sum and what the rounding left out; exact together.
///
/// Source: Knuth, "The Art of Computer Programming", volume 2, section 4.2.2.
#[inline(always)]
pub(crate) fn two_sum<R: Real>(a: R, b: R) -> (R, R) {
    let sum = a + b;
    let b_seen = sum - a;
    (sum, (a - (sum - b_seen)) + (b - b_seen))
}

/// `a b` as a rounded product and what the rounding left out; exact together,
/// short of underflow.
#[inline(always)]
pub(crate) fn two_product<R: Real>(a: R, b: R) -> (R, R) {
    let product = a * b;
    (product, a.fused(b, -product))
}

/// A number as a rounded value and a rest below its last place: twice the
/// digits.
pub(crate) type Long<R = f64> = (R, R);

/// `a b` of long numbers, right to a few `u^2`.
#[inline(always)]
pub(crate) fn long_product<R: Real>(a: Long<R>, b: Long<R>) -> Long<R> {
    let (product, rest) = two_product(a.0, b.0);
    (product, rest + (a.0 * b.1 + a.1 * b.0))
}

/// `a + b` of long numbers, right to a few `u^2` of the larger.
#[inline(always)]
pub(crate) fn long_sum<R: Real>(a: Long<R>, b: Long<R>) -> Long<R> {
    let (sum, rest) = two_sum(a.0, b.0);
    two_sum(sum, rest + (a.1 + b.1))
}

/// `a / b` of long numbers, rounded once but for a few `u^2`.
#[inline(always)]
pub(crate) fn long_quotient<R: Real>(a: Long<R>, b: Long<R>) -> R {
    let quotient = a.0 / b.0;
    let left = (-quotient).fused(b.0, a.0) + (a.1 - quotient * b.1);
    quotient + left / b.0
}

/// `a b - c d` of long numbers, right to a few `u^2` of the products.
#[inline(always)]
pub(crate) fn determinant<R: Real>(a: Long<R>, b: Long<R>, c: Long<R>, d: Long<R>) -> Long<R> {
    let (minus, rest) = long_product(c, d);
    long_sum(long_product(a, b), (-minus, -rest))
}

/// `a . b` as if computed with twice the digits and rounded once, so that
/// nothing is lost where the products cancel.
///
/// Source: Ogita, Rump, Oishi, "Accurate Sum and Dot Product", 2005 (`Dot2`).
#[inline(always)]
pub(crate) fn dot(a: DVec3, b: DVec3) -> f64 {
    let (sum, rest) = dot_unrounded(a, b);
    sum + rest
}

/// `(a - b) . c` like [`dot`], the difference unrounded.
#[inline(always)]
pub(crate) fn dot_of_difference(a: DVec3, b: DVec3, c: DVec3) -> f64 {
    let (x, x_rest) = two_sum(a.x, -b.x);
    let (y, y_rest) = two_sum(a.y, -b.y);
    let (z, z_rest) = two_sum(a.z, -b.z);
    let (sum, rest) = dot_unrounded(DVec3::new(x, y, z), c);
    sum + (rest + DVec3::new(x_rest, y_rest, z_rest).dot(c))
}

/// `a . b` as a sum and what its rounding left out, but for a few roundings of
/// the latter.
#[inline(always)]
fn dot_unrounded(a: DVec3, b: DVec3) -> (f64, f64) {
    let (x, x_rest) = two_product(a.x, b.x);
    let (y, y_rest) = two_product(a.y, b.y);
    let (z, z_rest) = two_product(a.z, b.z);
    let (xy, xy_rest) = two_sum(x, y);
    let (xyz, xyz_rest) = two_sum(xy, z);
    (xyz, (x_rest + y_rest) + (z_rest + (xy_rest + xyz_rest)))
}

/// `a x b`, each component with the accuracy and the sign of
/// [`difference_of_products`].
#[inline(always)]
pub(crate) fn cross(a: DVec3, b: DVec3) -> DVec3 {
    DVec3::new(
        difference_of_products(a.y, b.z, b.y, a.z),
        difference_of_products(a.z, b.x, b.z, a.x),
        difference_of_products(a.x, b.y, b.x, a.y),
    )
}

/// `r(t) - center`, each component rounded once although the terms cancel:
/// what a curved shape needs to be met as exactly from far away as from near.
#[inline(always)]
pub(crate) fn offset_at(ray: &Ray, t: f64, center: DVec3) -> DVec3 {
    offset_with_rest_at(ray, t, center).0
}

/// [`offset_at`] and what its rounding left out.
#[inline(always)]
pub(crate) fn offset_with_rest_at(ray: &Ray, t: f64, center: DVec3) -> (DVec3, DVec3) {
    let (p, d) = (ray.origin, ray.direction);
    let x = coordinate_with_rest_at(p.x, d.x, t, center.x);
    let y = coordinate_with_rest_at(p.y, d.y, t, center.y);
    let z = coordinate_with_rest_at(p.z, d.z, t, center.z);
    (DVec3::new(x.0, y.0, z.0), DVec3::new(x.1, y.1, z.1))
}

/// `p + t d - center` of one axis, and what its rounding left out.
#[inline(always)]
fn coordinate_with_rest_at(p: f64, d: f64, t: f64, center: f64) -> (f64, f64) {
    let (way, way_rest) = two_product(t, d);
    let (from_center, from_center_rest) = two_sum(p, -center);
    let (sum, sum_rest) = two_sum(from_center, way);
    two_sum(sum, sum_rest + (from_center_rest + way_rest))
}

/// The largest power of two that is not above `x`; `None` unless `x` is a
/// normal number above 0.
#[inline(always)]
pub(crate) fn power_of_two_below(x: f64) -> Option<f64> {
    const EXPONENT: u64 = 0x7ff0_0000_0000_0000;
    (x.is_normal() && x > 0.0).then(|| f64::from_bits(x.to_bits() & EXPONENT))
}

/// `x^y`, correct to below one unit in the last place.
pub(crate) fn pow(x: f64, y: f64) -> f64 {
    libm::pow(x, y)
}

/// Tangent of an angle in radians.
pub(crate) fn tan(angle: f64) -> f64 {
    libm::tan(angle)
}

/// The angle of `(x, y)` from the x axis, in radians from -pi to pi, correct to
/// below one unit in the last place.
pub(crate) fn atan2(y: f64, x: f64) -> f64 {
    libm::atan2(y, x)
}

/// `e^x`, correct to below one unit in the last place.
pub(crate) fn exp(x: f64) -> f64 {
    libm::exp(x)
}

/// The error function, correct to below one unit in the last place.
pub(crate) fn erf(x: f64) -> f64 {
    libm::erf(x)
}

/// Sine and cosine of an angle in degrees, exact at every quarter turn.
pub(crate) fn sin_cos_deg(angle_deg: f64) -> (f64, f64) {
    let quarter_turns = (angle_deg / 90.0).round();
    let rest = (angle_deg - quarter_turns * 90.0).to_radians();
    let (sin, cos) = libm::sincos(rest);
    match quarter_turns.rem_euclid(4.0) {
        0.0 => (sin, cos),
        1.0 => (cos, -sin),
        2.0 => (-sin, -cos),
        _ => (-cos, sin),
    }
}

/// The largest absolute component.
#[inline(always)]
pub(crate) fn max_abs(v: DVec3) -> f64 {
    v.abs().max_element()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn difference_of_products_keeps_the_sign_where_the_naive_form_loses_it() {
        // (1 + 2^-27)^2 - (1 + 2^-26) * 1 = 2^-54, which the naive form rounds away.
        let a = 1.0 + f64::from(2.0_f32.powi(-27));
        let c = 1.0 + f64::from(2.0_f32.powi(-26));
        assert_eq!(a * a - c * 1.0, 0.0);
        assert_eq!(difference_of_products(a, a, c, 1.0), 5.551_115_123_125_783e-17);
    }

    #[test]
    fn sums_and_products_come_with_what_they_lost() {
        assert_eq!(two_sum(1.0, 1e-20), (1.0, 1e-20));
        assert_eq!(two_sum(1e-20, 1.0), (1.0, 1e-20));
        let x = 1.0 + f64::EPSILON;
        assert_eq!(two_product(x, x), (1.0 + 2.0 * f64::EPSILON, f64::EPSILON * f64::EPSILON));
    }

    #[test]
    fn long_numbers_keep_twice_the_digits() {
        // (1/3)^2 - 1/9 and a third of 1, both to 2^-105.
        let third = (1.0 / 3.0, 1.0 / 3.0_f64 * f64::EPSILON / 4.0);
        let ninth = long_product(third, third);
        let (nines, rest) = long_product(ninth, (9.0, 0.0));
        let off = long_sum((nines, rest), (-1.0, 0.0));
        assert!((off.0 + off.1).abs() < 1e-31, "{off:?}");
        assert_eq!(long_quotient((1.0, 0.0), (3.0, 0.0)), 1.0 / 3.0);
        // 1 + 2^-53 is no number; divided by 1 - 2^-53 it is 1 + 2^-52 after one rounding.
        let rest = UNIT_ROUNDOFF;
        assert_eq!(long_quotient((1.0, rest), (1.0, -rest)), 1.0 + f64::EPSILON);
    }

    #[test]
    fn a_dot_product_keeps_what_cancels() {
        let (a, b) = (DVec3::new(1e16, 1.0, -1e16), DVec3::new(1.0, 0.5, 1.0));
        assert_eq!(a.dot(b), 0.0);
        assert_eq!(dot(a, b), 0.5);
        // 1e16 + 1.5 is no number: the difference is rounded only at the end.
        let (a, b) = (DVec3::splat(1e16), DVec3::new(-1.5, 0.0, 0.0));
        assert_eq!(dot_of_difference(a, b, DVec3::new(1.0, -1.0, 0.0)), 1.5);
    }

    #[test]
    fn an_offset_from_far_away_is_rounded_once() {
        // 3 x 1e16/3 is off by 1 from 1e16, which the plain form loses.
        let ray = Ray::new(DVec3::splat(-1e16 - 2.0), DVec3::splat(1e16 / 3.0));
        let exact = 3.0_f64.mul_add(1e16 / 3.0, -1e16) - 2.0 - 0.25;
        assert_eq!(offset_at(&ray, 3.0, DVec3::splat(0.25)), DVec3::splat(exact));
    }

    #[test]
    fn quarter_turns_are_exact() {
        assert_eq!(sin_cos_deg(0.0), (0.0, 1.0));
        assert_eq!(sin_cos_deg(90.0), (1.0, -0.0));
        assert_eq!(sin_cos_deg(180.0), (-0.0, -1.0));
        assert_eq!(sin_cos_deg(-90.0), (-1.0, 0.0));
        assert_eq!(sin_cos_deg(630.0), (-1.0, 0.0));
        let (sin, cos) = sin_cos_deg(30.0);
        assert!((sin - 0.5).abs() < 1e-16 && (cos * cos - 0.75).abs() < 1e-15);
        let (sin, cos) = sin_cos_deg(150.0);
        assert!((sin - 0.5).abs() < 1e-15 && cos < -0.86);
    }
}
