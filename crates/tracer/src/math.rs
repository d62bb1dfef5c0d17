//! The arithmetic that more than one formula needs, with the same bits on
//! every system.
//!
//! `+ - * /`, `sqrt` and `mul_add` are exact in IEEE 754; everything else
//! comes from `libm`, which is the same code everywhere.

use glam::DVec3;

/// Half the distance from 1 to the next `f64`: the largest relative error of
/// one rounding.
pub(crate) const UNIT_ROUNDOFF: f64 = f64::EPSILON / 2.0;

/// `a b - c d` with an error of at most 1.5 units in the last place and,
/// short of underflow, the exact sign.
///
/// Source: W. Kahan's fused-multiply-add determinant; error bound by
/// Jeannerod, Louvet and Muller, "Further analysis of Kahan's algorithm for
/// the accurate computation of 2x2 determinants", 2013.
pub(crate) fn difference_of_products(a: f64, b: f64, c: f64, d: f64) -> f64 {
    let cd = c * d;
    let error = (-c).mul_add(d, cd);
    a.mul_add(b, -cd) + error
}

/// `x^y`, correct to below one unit in the last place.
pub(crate) fn pow(x: f64, y: f64) -> f64 {
    libm::pow(x, y)
}

/// Tangent of an angle in radians.
pub(crate) fn tan(angle: f64) -> f64 {
    libm::tan(angle)
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
