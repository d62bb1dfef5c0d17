//! `Sphere`: the stable intersection that renders.
//!
//! The lecture's algebraic and geometric forms stand in [`crate::lecture`].

use std::f64::consts::{PI, TAU};

use glam::DVec3;

use super::{Contact, Departure, Formulas, SurfacePoint};
use crate::fault::{Fault, seeded};
use crate::math::{UNIT_ROUNDOFF, atan2, dot, max_abs, offset_with_rest_at, two_product, two_sum};
use crate::refused::{length, point};
use crate::{Aabb, Interval, Ray, Refused, UnitVec};

/// All points at distance `radius` from `center`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sphere {
    center: DVec3,
    radius: f64,
}

impl Sphere {
    /// A sphere.
    ///
    /// # Errors
    /// Refuses a center that is not finite and a radius that is not above 0.
    pub fn new(center: DVec3, radius: f64) -> Result<Self, Refused> {
        Refused::unless([point("center", center), length("radius", radius)])?;
        Ok(Self { center, radius })
    }

    /// The center.
    pub fn center(&self) -> DVec3 {
        self.center
    }

    /// The radius.
    pub fn radius(&self) -> f64 {
        self.radius
    }
}

/// A ray seen from close to the sphere's center: the quadratic
/// `a s^2 + 2 e s - h = 0` of `s = t - t_c`, where the ray at `t_c` is at `m`
/// from the center, `a = d.d`, `e = m.d` and `h = r^2 - m.m`.
struct Approach {
    t_c: f64,
    m: DVec3,
    /// The roots, lower first.
    s: [f64; 2],
}

impl Sphere {
    /// The ray's two meetings with the sphere; `None` where it passes by.
    ///
    /// Three cancellations of the textbook form are avoided. The ray is first
    /// moved to where it is closest to the center, with twice the digits, so
    /// that the distance it comes from costs nothing: this is the remainder
    /// vector of the source, computed exactly. `r^2 - m.m` is summed with twice
    /// the digits too, which a ray along the silhouette needs. And `t_c` need
    /// not be the closest point: `e` makes up for its rounding.
    ///
    /// Source: after Haines, Guenther, Akenine-Moeller, "Precision
    /// Improvements for Ray/Sphere Intersection", Ray Tracing Gems, 2019,
    /// chapter 7.
    #[inline(always)]
    fn approach(&self, ray: &Ray) -> Option<Approach> {
        let d = ray.direction;
        let f = ray.origin - self.center;
        let a = if seeded(Fault::DirectionTakenAsUnit) { 1.0 } else { dot(d, d) };
        let t_c = -f.dot(d) / a;
        if self.is_passed_by(f + t_c * d, f) {
            return None;
        }
        let (m, rest) = offset_with_rest_at(ray, t_c, self.center);
        let e = dot(m, d) + rest.dot(d);
        let discriminant = e * e + a * self.inside_by(m, rest);
        // A positive test: a NaN anywhere is a miss.
        if !(discriminant >= 0.0) {
            return None;
        }
        let root = discriminant.sqrt();
        Some(Approach { t_c, m, s: [(-e - root) / a, (-e + root) / a] })
    }

    /// Whether a ray that is roughly at `m` when it is closest surely passes
    /// by; false for NaN. What most rays need, at a fraction of the cost.
    ///
    /// `m = f + t_c d` is off by 4 roundings of `|f|` across the ray and 8 along
    /// it, from the two products in `t_c`, which only make it longer.
    #[inline(always)]
    fn is_passed_by(&self, m: DVec3, f: DVec3) -> bool {
        const ROUNDINGS: f64 = 32.0;
        let reach = self.radius + ROUNDINGS * UNIT_ROUNDOFF * (self.radius + max_abs(f));
        m.dot(m) > reach * reach
    }

    /// `r^2 - |m + rest|^2` with twice the digits, rounded once: how far a point
    /// is inside, in the geometer's units. What is below `rest` is left out.
    #[inline(always)]
    fn inside_by(&self, m: DVec3, rest: DVec3) -> f64 {
        let factor = if seeded(Fault::RadiusNotSquared) { 1.0 } else { self.radius };
        let (mut sum, mut lost) = two_product(self.radius, factor);
        for x in m.to_array() {
            let (square, square_rest) = two_product(x, x);
            let (next, next_rest) = two_sum(sum, -square);
            sum = next;
            lost += next_rest - square_rest;
        }
        sum + (lost - 2.0 * m.dot(rest))
    }

    /// `t` of both roots of an approach, lower first: `t_c + s`, or where that
    /// cancels, as it does for an origin close to the surface, from the other
    /// root by their product `c / a`, with `c = f.f - r^2`.
    #[inline(always)]
    fn roots(&self, ray: &Ray, approach: &Approach) -> [f64; 2] {
        let Approach { t_c, s: [low, high], .. } = *approach;
        let [near, far] = [t_c + low, t_c + high];
        // A difference of two numbers within a factor of 2 of each other is
        // what loses digits.
        let cancels = |t: f64| t.abs() < 0.5 * t_c.abs();
        if !(cancels(near) || cancels(far)) {
            return [near, far];
        }
        let a = dot(ray.direction, ray.direction);
        let (f, rest) = offset_with_rest_at(ray, 0.0, self.center);
        let product = -self.inside_by(f, rest) / a;
        if cancels(near) { [far.min(product / far), far] } else { [near, near.max(product / near)] }
    }
}

impl Formulas for Sphere {
    fn extent(&self) -> Aabb {
        let r = DVec3::splat(self.radius);
        Aabb { min: self.center - r, max: self.center + r }
    }

    /// Outward it is.
    #[inline(always)]
    fn is_left_for_good(&self, from: Departure) -> bool {
        from.outward
    }

    /// Of a ray that leaves it inward only the far side is met.
    #[inline(always)]
    fn meet(&self, ray: &Ray, range: Interval, from: Option<Departure>) -> Option<Contact> {
        let approach = self.approach(ray)?;
        let [near, far] = self.roots(ray, &approach);
        if from.is_none() && range.contains(near) && !seeded(Fault::FarRootOfSphere) {
            return Some(Contact::at(near));
        }
        if seeded(Fault::SphereLostFromInside) {
            return None;
        }
        range.contains(far).then_some(Contact::at(far))
    }

    #[inline(always)]
    fn surface_at(&self, ray: &Ray, contact: &Contact) -> SurfacePoint {
        // Seen from close by, so that the normal of a far hit keeps its digits.
        let outward = self.approach(ray).map_or(ray.at(contact.t) - self.center, |approach| {
            let Approach { t_c, m, s: [low, high] } = approach;
            let s = contact.t - t_c;
            let s = if (s - low).abs() <= (s - high).abs() { low } else { high };
            DVec3::splat(s).mul_add(ray.direction, m)
        });
        // A radius above zero rules out a point at the center.
        let normal = UnitVec::new(outward).unwrap_or(UnitVec::Z);
        SurfacePoint {
            point: self.center + self.radius * *normal,
            // One rounding of each coordinate, and those of the normal.
            error: 4.0 * UNIT_ROUNDOFF * (self.radius + max_abs(self.center)),
            geometric_normal: normal,
            shading_normal: normal,
        }
    }

    /// Longitude and latitude about the y axis: `u = 1/2 + atan2(x, z) / 2 pi`,
    /// from 0 up to below 1, and `v = 1/2 + asin(y) / pi`, from 0 at the lowest point
    /// to 1 at the highest, where `(x, y, z)` is the normal. The middle `u = 1/2`
    /// faces along z, `u = 3/4` along x, and the seam is at the back. At both
    /// poles `u` is 1/2.
    ///
    /// Both are off by less than 3e-16 from those of the normal as it is.
    ///
    /// Source: the sphere of the assignment "Ray 2" of Cornell CS4620, in its own
    /// program.
    fn uv_at(&self, surface: &SurfacePoint) -> Option<[f64; 2]> {
        let n = *surface.geometric_normal;
        let longitude = if n.x == 0.0 && n.z == 0.0 { 0.0 } else { atan2(n.x, n.z) };
        // As exact at the poles as anywhere, which the arc sine is not.
        let latitude = atan2(n.y, (n.x * n.x + n.z * n.z).sqrt());
        let u = 0.5 + longitude / TAU;
        Some([if u < 1.0 { u } else { 0.0 }, 0.5 + latitude / PI])
    }
}

#[cfg(test)]
mod tests;
