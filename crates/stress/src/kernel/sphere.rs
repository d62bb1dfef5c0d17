//! The sphere's textbook kernels, in `f32` or `f64`, and in double-double.

use super::{Range, Ray, Real, Vector, along, dot, minus};
use crate::number::{Dd, Number, V3};

/// All points at `radius` from `center`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sphere<R> {
    /// The middle.
    pub center: Vector<R>,
    /// Above 0.
    pub radius: R,
}

/// The lower of two roots that is in the range.
#[inline]
fn first<R: Real>(near: R, far: R, range: Range<R>) -> Option<R> {
    if range.contains(near) {
        Some(near)
    } else if range.contains(far) {
        Some(far)
    } else {
        None
    }
}

/// The quadratic formula as it stands:
/// `t = (-d.p +- sqrt((d.p)^2 - (d.d)(p.p - r^2))) / d.d` with `p` from the
/// center.
///
/// Source: Cornell CS4620, "Ray Tracing Basics", 2011, slide "Ray-sphere
/// intersection: algebraic".
#[inline(never)]
pub fn algebraic<R: Real>(
    &Sphere { center, radius }: &Sphere<R>,
    ray: &Ray<R>,
    range: Range<R>,
) -> Option<R> {
    let d = ray.direction;
    let p = minus(ray.origin, center);
    let (a, b) = (dot(d, d), dot(d, p));
    // A negative discriminant has a NaN root, which no range contains.
    let root = (b * b - a * (dot(p, p) - radius * radius)).sqrt();
    first((-b - root) / a, (-b + root) / a, range)
}

/// Pythagoras with a unit direction: half the chord from how closely the ray
/// passes the center. The direction is normalized for each ray.
///
/// Source: the same slides, the unit-vector form read geometrically.
#[inline(never)]
pub fn geometric<R: Real>(
    &Sphere { center, radius }: &Sphere<R>,
    ray: &Ray<R>,
    range: Range<R>,
) -> Option<R> {
    let p = minus(ray.origin, center);
    let length = dot(ray.direction, ray.direction).sqrt();
    let d = ray.direction.map(|x| x / length);
    let middle = -dot(d, p);
    let half_chord = (radius * radius - (dot(p, p) - middle * middle)).sqrt();
    first((middle - half_chord) / length, (middle + half_chord) / length, range)
}

/// The discriminant from the remainder of `f` across the ray, and roots that
/// never subtract nearly equal numbers.
///
/// Source: Haines, Guenther, Akenine-Moeller, "Precision Improvements for
/// Ray/Sphere Intersection", Ray Tracing Gems, 2019, chapter 7.
#[inline(never)]
pub fn remainder<R: Real>(
    &Sphere { center, radius }: &Sphere<R>,
    ray: &Ray<R>,
    range: Range<R>,
) -> Option<R> {
    let d = ray.direction;
    let f = minus(ray.origin, center);
    let (a, b) = (dot(d, d), -dot(f, d));
    let across = along(f, b / a, d);
    let discriminant = radius * radius - dot(across, across);
    if !(discriminant >= R::ZERO) {
        return None;
    }
    let c = dot(f, f) - radius * radius;
    let root = (a * discriminant).sqrt();
    if b > R::ZERO {
        let q = b + root;
        first(c / q, q / a, range)
    } else {
        let q = b - root;
        first(q / a, c / q, range)
    }
}

/// The quadratic formula with about 32 digits; `t` is rounded once, at the
/// end. The roots are taken as in [`remainder`].
///
/// Source: as [`algebraic`] and [`remainder`]; the arithmetic is
/// [`Dd`]'s.
#[inline(never)]
pub fn double_double(
    &Sphere { center, radius }: &Sphere<f64>,
    ray: &Ray<f64>,
    range: Range<f64>,
) -> Option<f64> {
    let d = V3::of(ray.direction.into());
    let f = V3::<Dd>::difference(ray.origin.into(), center.into());
    let (a, b) = (d.length_squared(), -f.dot(&d));
    let c = f.length_squared() - Dd::product(radius, radius);
    let discriminant = b.square() - a * c;
    if !(discriminant >= Dd::zero()) {
        return None;
    }
    let root = discriminant.sqrt();
    if b > Dd::zero() {
        let q = b + root;
        first((c / q).to_f64(), (q / a).to_f64(), range)
    } else {
        let q = b - root;
        first((q / a).to_f64(), (c / q).to_f64(), range)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// All kernels in both precisions, for a sphere of radius 2 at (1, 0, 0).
    #[track_caller]
    fn check(origin: [f64; 3], direction: [f64; 3], expected: Option<f64>) {
        let ray = Ray { origin, direction };
        let narrow = |v: [f64; 3]| v.map(|x| x as f32);
        let ray32 = Ray { origin: narrow(origin), direction: narrow(direction) };
        let sphere = Sphere { center: [1.0, 0.0, 0.0], radius: 2.0 };
        let sphere32 = Sphere { center: [1.0, 0.0, 0.0], radius: 2.0 };
        for kernel in [algebraic, geometric, remainder, double_double] {
            assert_eq!(kernel(&sphere, &ray, Range::AHEAD), expected);
        }
        for kernel in [algebraic, geometric, remainder] {
            assert_eq!(kernel(&sphere32, &ray32, Range::AHEAD).map(f64::from), expected);
        }
    }

    #[test]
    fn outside_inside_behind_beside_tangent_and_no_number() {
        let toward = [0.0, 0.0, -1.0];
        check([1.0, 0.0, 5.0], toward, Some(3.0));
        check([1.0, 0.0, 5.0], [0.0, 0.0, -0.5], Some(6.0));
        check([1.0, 0.0, 0.0], toward, Some(2.0));
        check([1.0, 0.0, -5.0], toward, None);
        check([4.0, 0.0, 5.0], toward, None);
        check([3.0, 0.0, 5.0], toward, Some(5.0));
        check([f64::NAN, 0.0, 5.0], toward, None);
        check([1.0, 0.0, 5.0], [0.0; 3], None);
    }
}
