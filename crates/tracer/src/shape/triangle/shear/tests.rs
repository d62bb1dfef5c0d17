//! The point that a ray meets against the triangle in exact arithmetic: what
//! the boxes of hierarchies are widened for.

use glam::dvec3;

use super::*;
use crate::exact::Exact;

/// How far `o + t d` may be from the triangle along an axis, in roundings of
/// the largest coordinates of the origin and of the corners together.
const CLAIM: f64 = 32.0;

/// The corners seen from `o + t d`, each rounded once.
fn seen_from_hit(ray: &Ray, t: f64, corners: [DVec3; 3]) -> [DVec3; 3] {
    let t = Exact::of(t);
    corners.map(|corner| {
        DVec3::from_array([0, 1, 2].map(|k| {
            let [o, d, x] = [ray.origin[k], ray.direction[k], corner[k]].map(Exact::of);
            (&x - &(&o + &(&t * &d))).about()
        }))
    })
}

/// At least the distance of the origin from the triangle along an axis: that
/// from its edges, and from the point of these weights.
fn distance_at_most([a, b, c]: [DVec3; 3], [beta, gamma]: [f64; 2]) -> f64 {
    let along = |p: DVec3, q: DVec3| {
        let share = -p.dot(q - p) / (q - p).length_squared();
        max_abs(p + share.clamp(0.0, 1.0) * (q - p))
    };
    let inside = max_abs((1.0 - beta - gamma) * a + beta * b + gamma * c);
    [along(a, b), along(b, c), along(c, a), inside].into_iter().fold(f64::INFINITY, f64::min)
}

/// A triangle as thin as a few roundings, or plump, and a ray at it.
fn case(any: &mut fastrand::Rng) -> ([DVec3; 3], Ray) {
    let one = |any: &mut fastrand::Rng| 2.0 * any.f64() - 1.0;
    let point = |any: &mut fastrand::Rng| dvec3(one(any), one(any), one(any));
    let (a, b) = (point(any), point(any));
    let width = libm::exp2(-60.0 * any.f64());
    let c = a + one(any) * 2.0 * (b - a) + width * point(any);
    let share = any.f64();
    let at = a + share * (c - a) + any.f64() * (1.0 - share) * (b - a);
    let at = at + [0.0, 1e-16, 3e-16][any.usize(0..3)] * point(any);
    let origin = 2.0 * point(any);
    ([a, b, c], Ray::new(origin, at - origin))
}

#[test]
fn what_is_met_is_on_the_triangle_but_for_few_roundings() {
    let mut any = fastrand::Rng::with_seed(3);
    let (mut hits, mut worst) = (0, 0.0_f64);
    for _ in 0..100_000 {
        let (corners, ray) = case(&mut any);
        let Some(contact) = Shear::new(&ray).decide(corners, Interval::AHEAD) else { continue };
        hits += 1;
        let size = max_abs(ray.origin) + corners.map(max_abs).into_iter().fold(0.0, f64::max);
        let seen = seen_from_hit(&ray, contact.t, corners);
        let off = distance_at_most(seen, contact.barycentric) / (UNIT_ROUNDOFF * size);
        assert!(off < CLAIM, "{off}: {corners:?} {ray:?} {contact:?}");
        worst = worst.max(off);
    }
    assert!(hits > 50_000 && worst > 2.0, "{hits} hits, off by {worst}, say nothing");
}
