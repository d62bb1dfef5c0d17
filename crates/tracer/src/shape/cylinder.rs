//! `Cylinder`: a round cylinder around any axis, closed by caps or open.

use glam::DVec3;

use super::axial::{
    Approach, Axis, Crossing, Near, SIDE, apart, difference_of_squares, roots, size,
};
use super::{Contact, Departure, Formulas, SurfacePoint};
use crate::math::{UNIT_ROUNDOFF, dot};
use crate::refused::{length, point};
use crate::{Aabb, Interval, Ray, Refused, UnitVec};

/// The part of each cap; the side is [`SIDE`].
const CAPS: [u32; 2] = [1, 2];

/// The points at distance `radius` from the line through `a` and `b`, between
/// the planes through these across the line; with caps, also the two disks
/// that close it. Its parts are the side, the cap at `a` and the cap at `b`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cylinder {
    axis: Axis,
    radius: f64,
    caps: bool,
}

impl Cylinder {
    /// A cylinder from `a` to `b`, with or without caps.
    ///
    /// # Errors
    /// Refuses ends that are not finite or not apart, and a radius that is not
    /// above 0.
    pub fn new(a: DVec3, b: DVec3, radius: f64, caps: bool) -> Result<Self, Refused> {
        Refused::unless([
            point("a", a),
            point("b", b),
            length("radius", radius),
            apart("b", "a", a, b),
        ])?;
        Ok(Self { axis: Axis::new(a, b), radius, caps })
    }

    /// `R = r |A|`, the `|m|` of the side.
    #[inline(always)]
    fn reach(&self) -> f64 {
        self.radius / self.axis.unit * self.axis.length
    }

    /// Between which `s` the line is inside the endless side.
    ///
    /// `|m| <= R` is the quadratic
    /// `(D.D) s^2 + 2 (M.D) s + (M.M - R^2)`, and its discriminant
    /// `(M.D)^2 - (D.D)(M.M - R^2) = R^2 D.D - |M x D|^2`.
    #[inline(always)]
    fn side(&self, ray: &Approach) -> Option<[f64; 2]> {
        let (m, d) = (ray.m, ray.sideways);
        let reach = self.reach();
        let outside = difference_of_squares(size(m), reach);
        if d == DVec3::ZERO {
            // Along the axis it never crosses the side, which is inside.
            return (outside <= 0.0).then_some([f64::NEG_INFINITY, f64::INFINITY]);
        }
        let discriminant = difference_of_squares(reach * size(d), ray.moment());
        let [one, other] = roots(d.dot(d), dot(m, d), outside, discriminant, size(m) / size(d))?;
        Some([one.min(other), one.max(other)])
    }

    #[inline(always)]
    fn crossing(&self, ray: &Ray) -> Option<Crossing> {
        if self.axis.is_passed_by(ray, self.radius) {
            return None;
        }
        let ray = self.axis.approach(ray, &Near::Axis)?;
        ray.cut(self.side(&ray), CAPS.map(Some), self.reach(), self.caps)
    }
}

impl Formulas for Cylinder {
    fn extent(&self) -> Aabb {
        self.axis.disk_bounds(0, self.radius).union(self.axis.disk_bounds(1, self.radius))
    }

    /// The side is convex, so a ray that leaves it outward never comes back,
    /// nor does one from a cap.
    #[inline(always)]
    fn is_left_for_good(&self, from: Departure) -> bool {
        from.outward
    }

    /// A ray that leaves it inward meets only what it leaves by.
    #[inline(always)]
    fn meet(&self, ray: &Ray, range: Interval, from: Option<Departure>) -> Option<Contact> {
        let crossing = self.crossing(ray)?;
        if from.is_none() { crossing.first(range) } else { crossing.last(range) }
    }

    #[inline(always)]
    fn surface_at(&self, ray: &Ray, contact: &Contact) -> SurfacePoint {
        let (axis, radius) = (&self.axis, self.radius / self.axis.unit);
        let near = axis.approach(ray, &Near::Axis);
        let (local, normal) = match (near, contact.part) {
            // No contact of a ray that is not finite was ever returned.
            (None, _) => (axis.ends[0], axis.direction),
            (Some(near), SIDE) => {
                let s = near.nearest(self.side(&near).unwrap_or([f64::NAN; 2]), contact.t);
                let outward = axis.across(near.m + s * near.sideways);
                // A radius above zero rules out a point on the axis.
                let normal = UnitVec::new(outward).unwrap_or(UnitVec::Z);
                let height = near.height_at(s).clamp(0.0, axis.length);
                (axis.point(height, radius * *normal), normal)
            }
            (Some(near), part) => {
                let end = usize::from(part == CAPS[1]);
                let normal = if end == 0 { -axis.direction } else { axis.direction };
                (near.point_of_cap(end, radius), normal)
            }
        };
        SurfacePoint {
            point: local,
            error: 16.0 * UNIT_ROUNDOFF * (axis.coordinates() + self.radius),
            geometric_normal: normal,
            shading_normal: normal,
        }
    }
}

#[cfg(test)]
mod tests;
