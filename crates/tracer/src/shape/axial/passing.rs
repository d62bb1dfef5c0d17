//! Whether a ray surely passes by everything around an axis: what most rays
//! need, at a fraction of the cost.

use super::Axis;
use crate::Ray;
use crate::math::{UNIT_ROUNDOFF, max_abs};

/// How many roundings of its largest terms the test allows for, of which
/// `docs/accuracy.md` proves that 270 are enough.
const DOUBT: f64 = 512.0;

/// Far above what squares lose that underflow.
const LEAST_SQUARE: f64 = 1e-290;

impl Axis {
    /// Whether the ray surely stays farther than `radius` from the whole line
    /// through both ends; false for NaN. One that does is never met by the
    /// formulas of a solid of that radius, however they round.
    ///
    /// The distance is `|F.D| / |D|`, with `F` from the first end to the ray's
    /// origin and `D = d x A`.
    #[inline(always)]
    pub(in super::super) fn is_passed_by(&self, ray: &Ray, radius: f64) -> bool {
        let from_end = ray.origin - self.ends[0];
        let sideways = ray.direction.cross(self.along);
        let reach = max_abs(ray.origin) + self.coordinates() + radius;
        let size = max_abs(ray.direction) * max_abs(self.along);
        let apart = from_end.dot(sideways).abs() - DOUBT * UNIT_ROUNDOFF * reach * size;
        apart > 0.0 && apart * apart > radius * radius * sideways.dot(sideways) + LEAST_SQUARE
    }
}

#[cfg(test)]
mod tests {
    use glam::{DVec3, dvec3};

    use super::*;
    use crate::exact::Exact;

    /// What the formulas may round, in roundings of the reach along each axis,
    /// as the distance of a point.
    const PROMISED: f64 = 56.0;

    fn exact_cross(a: [&Exact; 3], b: [&Exact; 3]) -> [Exact; 3] {
        [[1, 2], [2, 0], [0, 1]].map(|[k, l]| &(a[k] * b[l]) - &(a[l] * b[k]))
    }

    fn exact_dot([a, b, c]: [&Exact; 3], [x, y, z]: [&Exact; 3]) -> Exact {
        &(&(a * x) + &(b * y)) + &(c * z)
    }

    /// Whether the line is as far from the axis as the radius and the promise
    /// together, without rounding.
    fn is_apart(axis: &Axis, ray: &Ray, radius: f64) -> bool {
        let exact = |v: DVec3| v.to_array().map(Exact::of);
        let (o, d, [a, b]) = (exact(ray.origin), exact(ray.direction), axis.ends.map(exact));
        let along = [0, 1, 2].map(|k| &b[k] - &a[k]);
        let from_end = [0, 1, 2].map(|k| &o[k] - &a[k]);
        let sideways = exact_cross(d.each_ref(), along.each_ref());
        let product = exact_dot(from_end.each_ref(), sideways.each_ref());
        let reach = max_abs(ray.origin) + axis.coordinates() + radius;
        let room = &Exact::of(radius) + &Exact::of(PROMISED * UNIT_ROUNDOFF * reach);
        let square = exact_dot(sideways.each_ref(), sideways.each_ref());
        &product * &product > &(&room * &room) * &square
    }

    #[test]
    fn who_passes_by_is_apart_without_rounding() {
        let mut rng = fastrand::Rng::with_seed(41);
        let mut number = move || 2.0 * rng.f64() - 1.0;
        let (mut passing, mut close, mut in_doubt) = (0, 0, 0);
        for round in 0..60_000 {
            let mut point = || dvec3(number(), number(), number());
            let far = [0.0, 1.0, 1e3, 1e8][round % 4];
            let long = [1e-6, 1.0, 1e5][round / 4 % 3];
            let middle = point() * far;
            let axis = Axis::new(middle, middle + point() * long);
            let (towards, across) = (point(), point());
            let radius = [1e-9, 0.01, 1.0][round / 12 % 3];
            // Nearly along the axis, or any way, past it by about the radius.
            let tilt = [1.0, 1e-3, 1e-7][round / 36 % 3];
            let direction = *axis.direction + across * tilt;
            let sideways = direction.cross(*axis.direction).normalize_or(DVec3::X);
            let nudge = [0.0, 1e-15, 1e-12, 1e-6, 0.5][round / 108 % 5];
            let touched = middle + sideways * radius * (1.0 + nudge * towards.x);
            let scale = [1e-30, 0.7, 1e30][round % 3];
            let back = towards.y * [1.0, 1e4][round % 2];
            let ray = Ray::new(touched - direction * back, direction * scale);
            let is_apart = is_apart(&axis, &ray, radius);
            if axis.is_passed_by(&ray, radius) {
                assert!(is_apart, "{axis:?} {radius} {ray:?}");
                passing += 1;
                close += u32::from(nudge < 1e-5);
            } else {
                in_doubt += u32::from(is_apart);
            }
        }
        assert!(passing > 4_000 && close > 1_000, "{passing} {close} of them close, {in_doubt}");
    }

    #[test]
    fn what_is_no_ray_or_beside_the_axis_does_not_pass_by() {
        let axis = Axis::new(DVec3::ZERO, DVec3::Z * 3.0);
        let passes = |o: [f64; 3], d: [f64; 3]| {
            axis.is_passed_by(&Ray::new(DVec3::from_array(o), DVec3::from_array(d)), 1.0)
        };
        assert!(passes([1.0 + 1e-12, 0.0, 9.0], [0.0, 1.0, -1.0]));
        assert!(passes([2.0, 0.0, 9.0], [0.0, 1e-140, 0.0]));
        assert!(passes([2.0, 0.0, 9.0], [0.0, 1e140, 0.0]));
        assert!(!passes([1.0, 0.0, 9.0], [0.0, 1.0, -1.0]));
        // Along the axis there is no sideways to measure by.
        assert!(!passes([5.0, 0.0, 9.0], [0.0, 0.0, -1.0]));
        for bad in [f64::NAN, f64::INFINITY] {
            assert!(!passes([bad, 0.0, 9.0], [0.0, 1.0, -1.0]));
            assert!(!passes([2.0, 0.0, 9.0], [0.0, bad, -1.0]));
        }
        assert!(!passes([2.0, 0.0, 9.0], [0.0; 3]));
    }
}
