//! `Sphere`: the stable intersection that renders.
//!
//! The lecture's algebraic and geometric forms stand in [`crate::lecture`].

use glam::DVec3;

use super::{Contact, Geometry, SurfacePoint};
use crate::math::{UNIT_ROUNDOFF, max_abs};
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

impl Geometry for Sphere {
    fn bounds(&self) -> Aabb {
        let r = DVec3::splat(self.radius);
        Aabb { min: self.center - r, max: self.center + r }
    }

    /// The quadratic `a t^2 - 2 b' t + c = 0` with `f = p - center`,
    /// `a = d.d`, `b' = -f.d`, `c = f.f - r^2`.
    ///
    /// Two cancellations of the textbook form are avoided: the discriminant
    /// comes from the part of `f` across the ray, `r^2 - |f + (b'/a) d|^2`, and
    /// the two roots are `q/a` and `c/q` with `q = b' + sign(b') sqrt(a disc)`,
    /// which never subtracts nearly equal numbers.
    ///
    /// Source: Haines, Guenther, Akenine-Moeller, "Precision Improvements for
    /// Ray/Sphere Intersection", Ray Tracing Gems, 2019, chapter 7.
    fn intersect(&self, ray: &Ray, range: Interval) -> Option<Contact> {
        let d = ray.direction;
        let f = ray.origin - self.center;
        let a = d.dot(d);
        let b = -f.dot(d);
        let across = f + (b / a) * d;
        let discriminant = self.radius * self.radius - across.dot(across);
        // Positive tests: a NaN anywhere is a miss.
        if !(discriminant >= 0.0) {
            return None;
        }
        let c = f.dot(f) - self.radius * self.radius;
        let root = (a * discriminant).sqrt();
        let (near, far) = if b > 0.0 {
            let q = b + root;
            (c / q, q / a)
        } else {
            let q = b - root;
            (q / a, c / q)
        };
        [near, far].into_iter().find(|&t| range.contains(t)).map(Contact::at)
    }

    fn surface(&self, ray: &Ray, contact: &Contact) -> SurfacePoint {
        let outward = (ray.origin - self.center) + contact.t * ray.direction;
        // A radius above zero rules out a point at the center.
        let normal = UnitVec::new(outward).unwrap_or(UnitVec::Z);
        SurfacePoint {
            point: self.center + self.radius * *normal,
            error: 8.0 * UNIT_ROUNDOFF * (self.radius + max_abs(self.center)),
            geometric_normal: normal,
            shading_normal: normal,
        }
    }
}

#[cfg(test)]
mod tests;
