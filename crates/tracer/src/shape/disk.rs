//! `Disk`: the part of a plane within a radius.

use glam::DVec3;

use super::{Contact, Departure, Formulas, Plane, SurfacePoint};
use crate::fault::{Fault, seeded};
use crate::math::offset_at;
use crate::refused::{direction, length, point};
use crate::{Aabb, Interval, Ray, Refused};

/// The points of the plane through `center` across `normal` at most `radius`
/// from the center; both sides are hit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Disk {
    plane: Plane,
    center: DVec3,
    radius: f64,
}

impl Disk {
    /// A disk; the normal may have any length.
    ///
    /// # Errors
    /// Refuses numbers that are not finite, a normal of no length and a radius
    /// that is not above 0.
    pub fn new(center: DVec3, normal: DVec3, radius: f64) -> Result<Self, Refused> {
        Refused::unless([
            point("center", center),
            direction("normal", normal),
            length("radius", radius),
        ])?;
        Ok(Self { plane: Plane::new(center, normal)?, center, radius })
    }
}

impl Formulas for Disk {
    fn extent(&self) -> Aabb {
        Aabb::around_circle(self.center, self.plane.normal(), self.radius)
    }

    /// A flat surface is.
    #[inline(always)]
    fn is_left_for_good(&self, _: Departure) -> bool {
        true
    }

    #[inline(always)]
    fn meet(&self, ray: &Ray, range: Interval, _: Option<Departure>) -> Option<Contact> {
        let t = self.plane.t(ray);
        let from_center = offset_at(ray, t, self.center);
        let inside = from_center.length_squared() <= self.radius * self.radius;
        let inside = inside || seeded(Fault::DiskWithoutRim);
        (inside && range.contains(t)).then_some(Contact::at(t))
    }

    #[inline(always)]
    fn surface_at(&self, ray: &Ray, contact: &Contact) -> SurfacePoint {
        self.plane.surface_at(ray, contact)
    }
}

#[cfg(test)]
mod tests {
    use glam::dvec3;

    use super::*;
    use crate::shape::Geometry;

    #[track_caller]
    fn check(p: [f64; 3], d: [f64; 3], expected: Option<f64>) {
        let disk = Disk::new(dvec3(5.0, 1.0, 0.0), dvec3(0.0, -3.0, 0.0), 2.0).unwrap();
        let ray = Ray::new(DVec3::from_array(p), DVec3::from_array(d));
        assert_eq!(disk.intersect(&ray, Interval::AHEAD).map(|c| c.t), expected);
    }

    #[test]
    fn inside_rim_outside_behind_and_along() {
        check([5.0, 3.0, 0.0], [0.0, -0.5, 0.0], Some(4.0));
        check([7.0, 3.0, 0.0], [0.0, -0.5, 0.0], Some(4.0));
        check([7.0_f64.next_up(), 3.0, 0.0], [0.0, -0.5, 0.0], None);
        check([5.0, 3.0, -2.0], [0.0, -0.5, 0.5], Some(4.0));
        check([5.0, 3.0, 0.0], [0.0, 0.5, 0.0], None);
        check([0.0, 1.0, 0.0], [1.0, 0.0, 0.0], None);
        check([5.0, f64::NAN, 0.0], [0.0, -1.0, 0.0], None);
    }

    #[test]
    fn bad_disks_are_refused() {
        let refused = Disk::new(DVec3::ZERO, DVec3::ZERO, 0.0).unwrap_err();
        assert_eq!(refused.refusals().len(), 2);
    }
}
