//! `Plane`: the lecture's second condition, `(x - a).n = 0`, alone.

use glam::DVec3;

use super::{Contact, Departure, Formulas, SurfacePoint};
use crate::fault::{Fault, seeded};
use crate::math::{UNIT_ROUNDOFF, dot, dot_of_difference, max_abs};
use crate::refused::{direction, point};
use crate::{Aabb, Interval, Ray, Refused, UnitVec};

/// The infinite plane through `point` with this `normal`; both sides are hit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Plane {
    point: DVec3,
    /// As it was given: rounding it to unit length would tilt the plane.
    across: DVec3,
    normal: UnitVec,
}

impl Plane {
    /// A plane; the normal may have any length.
    ///
    /// # Errors
    /// Refuses numbers that are not finite and a normal of no length.
    pub fn new(point_: DVec3, normal: DVec3) -> Result<Self, Refused> {
        Refused::unless([point("point", point_), direction("normal", normal)])?;
        // Checked above; the axis is never used.
        Ok(Self {
            point: point_,
            across: normal,
            normal: UnitVec::new(normal).unwrap_or(UnitVec::Z),
        })
    }

    /// A point of it.
    pub(crate) fn point(&self) -> DVec3 {
        self.point
    }

    /// Its normal.
    pub(super) fn normal(&self) -> UnitVec {
        self.normal
    }

    /// Its normal, as long as it was given.
    pub(crate) fn across(&self) -> DVec3 {
        self.across
    }

    /// The directions of `u` and `v`, of unit length, so that `u x v` is the normal `n`.
    ///
    /// On a wall, `u` is level, `y x n`, and `v` leads up. Where the normal's y is its
    /// largest component, `u` is the x axis laid into the plane, and `v` follows: on
    /// a floor it leads along `-z`.
    pub fn tangents(&self) -> [DVec3; 2] {
        let n = *self.normal;
        let is_floor = n.y.abs() > n.x.abs().max(n.z.abs());
        let u = if is_floor { DVec3::X - n.x * n } else { DVec3::new(n.z, 0.0, -n.x) };
        // Neither is shorter than a half.
        let u = UnitVec::new(u).map_or(DVec3::X, |u| *u);
        [u, n.cross(u)]
    }

    /// Which `t` puts the ray on the plane: `t = (a - p).n / d.n`, where
    /// neither product loses digits, however flat the ray. Infinite or NaN
    /// for a ray along the plane and NaN for an infinite direction, which no
    /// interval contains.
    #[inline(always)]
    pub(super) fn t(&self, ray: &Ray) -> f64 {
        let approach = dot(ray.direction, self.across);
        let is_lost = seeded(Fault::PlaneOneSided) && approach > 0.0;
        if approach.is_infinite() || is_lost {
            return f64::NAN;
        }
        dot_of_difference(self.point, ray.origin, self.across) / approach
    }
}

impl Formulas for Plane {
    fn extent(&self) -> Aabb {
        Aabb::EVERYTHING
    }

    /// A flat surface is.
    #[inline(always)]
    fn is_left_for_good(&self, _: Departure) -> bool {
        true
    }

    #[inline(always)]
    fn meet(&self, ray: &Ray, range: Interval, _: Option<Departure>) -> Option<Contact> {
        let t = self.t(ray);
        range.contains(t).then_some(Contact::at(t))
    }

    #[inline(always)]
    fn surface_at(&self, ray: &Ray, contact: &Contact) -> SurfacePoint {
        let n = *self.normal;
        let x = ray.at(contact.t);
        // Put back onto the plane along its normal.
        let point = x - (x - self.point).dot(n) * n;
        SurfacePoint {
            point,
            error: 16.0 * UNIT_ROUNDOFF * (max_abs(point) + max_abs(self.point)),
            geometric_normal: self.normal,
            shading_normal: self.normal,
        }
    }

    /// Lengths along two directions in the plane, from its point: see
    /// [`Plane::tangents`].
    fn uv_at(&self, surface: &SurfacePoint) -> Option<[f64; 2]> {
        let from_point = surface.point - self.point;
        Some(self.tangents().map(|tangent| from_point.dot(tangent)))
    }
}

#[cfg(test)]
mod tests {
    use glam::dvec3;

    use super::*;
    use crate::shape::Geometry;

    #[track_caller]
    fn check(p: [f64; 3], d: [f64; 3], expected: Option<f64>) {
        let plane = Plane::new(dvec3(5.0, 1.0, 0.0), dvec3(0.0, 3.0, 0.0)).unwrap();
        let ray = Ray::new(DVec3::from_array(p), DVec3::from_array(d));
        assert_eq!(plane.intersect(&ray, Interval::AHEAD).map(|c| c.t), expected);
    }

    #[test]
    fn above_below_away_and_along() {
        check([0.0, 3.0, 0.0], [0.0, -0.5, 7.0], Some(4.0));
        check([0.0, -3.0, 0.0], [0.0, 0.5, 7.0], Some(8.0));
        check([0.0, 3.0, 0.0], [0.0, 0.5, 0.0], None);
        check([0.0, 3.0, 0.0], [1.0, 0.0, 0.0], None);
        check([0.0, 1.0, 0.0], [1.0, 0.0, 0.0], None);
        check([0.0, f64::NAN, 0.0], [0.0, -1.0, 0.0], None);
    }

    #[test]
    fn the_normal_does_not_turn() {
        let plane = Plane::new(DVec3::ZERO, dvec3(0.0, 3.0, 0.0)).unwrap();
        for y in [2.0, -2.0] {
            let ray = Ray::new(dvec3(1.0, y, 0.0), dvec3(0.0, -y, 0.0));
            let surface = plane.surface(&ray, &Contact::at(1.0));
            assert_eq!(surface.geometric_normal, UnitVec::Y);
            assert_eq!(surface.point, dvec3(1.0, 0.0, 0.0));
        }
    }

    #[test]
    fn bad_planes_are_refused() {
        assert!(Plane::new(DVec3::ZERO, DVec3::ZERO).is_err());
        assert!(Plane::new(DVec3::ZERO, dvec3(f64::NAN, 1.0, 0.0)).is_err());
    }
}
