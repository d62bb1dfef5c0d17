//! The exact first hit of a sphere, and the exact point and normal there.
//!
//! A case is the center, the radius and the ray: ten numbers.

use std::cmp::Ordering;

use tracer::Ray;
use tracer::glam::DVec3;

use super::{Truth, UNDECIDED, first_ahead, is_tie};
use crate::Case;
use crate::number::{Big, Dd, Number, V3};

/// The lower root of `|p + t d - center| = r` above 0, else the higher.
pub fn sphere(case: &Case) -> Truth {
    let (truth, sure) = first_hit::<Dd>(case);
    if sure { truth } else { first_hit::<Big>(case).0 }
}

/// The quadratic of a case, of which `t = (b +- root) / a` are the roots.
struct Quadratic<N> {
    /// From the center to the ray's origin.
    from_center: V3<N>,
    direction: V3<N>,
    a: N,
    b: N,
    /// `|f x d|^2`: the square of the ray's distance from the center, times `a`.
    across: N,
    discriminant: N,
}

impl<N: Number> Quadratic<N> {
    /// `b^2 - a c`, written by Lagrange's identity: `a r^2 - |f x d|^2`.
    fn new(center: DVec3, radius: f64, ray: &Ray) -> Self {
        let direction = V3::<N>::of(ray.direction);
        let from_center = V3::<N>::difference(ray.origin, center);
        let a = direction.length_squared();
        let b = -from_center.dot(&direction);
        let across = from_center.cross(&direction).length_squared();
        let discriminant = a.clone() * N::of(radius).square() - across.clone();
        Self { from_center, direction, a, b, across, discriminant }
    }
}

pub(super) fn first_hit<N: Number>(case: &Case) -> (Truth, bool) {
    let (center, radius, ray) = (case.point(0), case.number(3), case.ray(4));
    let q = Quadratic::<N>::new(center, radius, &ray);
    let a = q.a.to_f64();
    let still = ray.origin.length() + center.length() + radius;
    let length = ray.direction.length();
    // How far the surface and the ray's point at `t` move against each other.
    let moves = |t: f64| still + t.abs() * length;
    let distance = (q.across.to_f64() / a).sqrt();
    // The discriminant is `a (r - distance) (r + distance)`.
    let moves_discriminant = a * (radius + distance) * moves(q.b.to_f64() / a);
    let discriminant = q.discriminant.to_f64();
    let sure = discriminant.abs() > UNDECIDED * moves_discriminant;
    if is_tie(discriminant, moves_discriminant) {
        return (Truth::TIE, sure);
    }
    if q.discriminant.sign() != Ordering::Greater {
        return (Truth::MISS, sure);
    }
    let root = q.discriminant.sqrt();
    // At a hit, `root` is `|n . d|` for the normal `n` of length `r`.
    let steep = radius / root.to_f64();
    let roots = [q.b.clone() - root.clone(), q.b + root].map(|numerator| {
        let t = numerator / q.a.clone();
        let condition = steep * moves(t.to_f64());
        (t, condition)
    });
    (first_ahead(roots), sure)
}

/// From the center to the exact hit of which `near` is the parameter, roughly:
/// a vector of length `radius`. `None` for a miss.
pub fn sphere_point(case: &Case, near: f64) -> Option<V3<Dd>> {
    let q = Quadratic::<Dd>::new(case.point(0), case.number(3), &case.ray(4));
    if q.discriminant.sign() != Ordering::Greater {
        return None;
    }
    let root = q.discriminant.sqrt();
    let (low, high) = ((q.b - root) / q.a, (q.b + root) / q.a);
    let t = if (low.to_f64() - near).abs() <= (high.to_f64() - near).abs() { low } else { high };
    Some(q.from_center + q.direction.scale(&t))
}
