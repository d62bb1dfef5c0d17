//! The textbook's torus: the quartic's coefficients about the ray's origin in
//! `f64`, its roots bracketed by those of its derivatives; shown beside the
//! kernel that renders.

use super::torus::RAY_AT;
use crate::Case;

/// Halvings from any two numbers of one size to neighbors, and some more.
const HALVINGS: usize = 80;

/// The first `t` above 0.
pub(super) fn first_hit(case: &Case) -> Option<f64> {
    let ray = case.ray(RAY_AT);
    let (major, minor) = (case.number(6), case.number(7));
    let axis = case.point(3).normalize();
    let length = ray.direction.length();
    let (o, d) = (ray.origin - case.point(0), ray.direction / length);
    let (oo, od) = (o.dot(o), o.dot(d));
    let (on, dn) = (o.dot(axis), d.dot(axis));
    let k = oo + major * major - minor * minor;
    let four = 4.0 * major * major;
    let quartic = [
        k * k - four * (oo - on * on),
        4.0 * k * od - 2.0 * four * (od - on * dn),
        4.0 * od * od + 2.0 * k - four * (1.0 - dn * dn),
        4.0 * od,
        1.0,
    ];
    let reach = major + minor;
    let (lo, hi) = ((-od - reach).max(0.0), -od + reach);
    if !(lo < hi && hi < f64::INFINITY) {
        return None;
    }
    let (roots, count) = roots(&quartic, lo, hi);
    roots[..count].iter().copied().find(|&t| t > 0.0).map(|t| t / length)
}

fn value(coefficients: &[f64], x: f64) -> f64 {
    coefficients.iter().rev().fold(0.0, |sum, c| sum * x + c)
}

/// The roots of a polynomial of degree 1 to 4 between two ends, ascending.
fn roots(coefficients: &[f64], lo: f64, hi: f64) -> ([f64; 4], usize) {
    let degree = coefficients.len() - 1;
    let (mut found, mut count) = ([0.0; 4], 0);
    if degree == 0 {
        return (found, count);
    }
    let mut slope = [0.0; 4];
    for (k, c) in coefficients.iter().enumerate().skip(1) {
        slope[k - 1] = k as f64 * c;
    }
    let (extrema, between) = roots(&slope[..degree], lo, hi);
    let mut from = lo;
    for &to in extrema[..between].iter().chain(std::iter::once(&hi)) {
        let rising = value(coefficients, to) > 0.0;
        if rising != (value(coefficients, from) > 0.0) && count < found.len() {
            let (mut below, mut above) = (from, to);
            for _ in 0..HALVINGS {
                let middle = 0.5 * (below + above);
                if (value(coefficients, middle) > 0.0) == rising {
                    above = middle;
                } else {
                    below = middle;
                }
            }
            found[count] = above;
            count += 1;
        }
        from = to;
    }
    (found, count)
}
