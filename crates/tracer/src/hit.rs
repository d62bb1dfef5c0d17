//! `Hit`: where a ray met which object, and how a new ray leaves from there.

use glam::DVec3;

use crate::fault::{Fault, seeded};
use crate::shape::Departure;
use crate::{Material, Ray, UnitVec, accel};

/// The number of an object in its scene, in the order of the scene's
/// description, groups opened in place.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
pub struct ObjectId(pub u32);

/// The closest meeting of a ray with a scene.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hit {
    /// The ray parameter, in units of the direction's length.
    pub t: f64,
    /// The point on the surface: put back onto it by the shape, so more
    /// accurate than `origin + t direction`.
    pub point: DVec3,
    /// The true surface is no farther from `point` than this: a bound of its
    /// rounding error, in world units.
    pub point_error: f64,
    /// The outward normal of the true surface, not turned towards the viewer.
    pub geometric_normal: UnitVec,
    /// The normal to shade with: interpolated where a mesh has normals, else
    /// the geometric one.
    pub shading_normal: UnitVec,
    /// What the surface is made of.
    pub material: Material,
    /// Which object was hit.
    pub object: ObjectId,
    /// Which part of its shape; see [`crate::shape::Contact::part`].
    pub part: u32,
}

impl Hit {
    /// The ray that leaves this point along `direction`.
    ///
    /// Its origin is moved off the surface, to the side it leaves on, by twice
    /// the point's error bound and no fixed distance; and it knows which
    /// surface it leaves, so that no rounding makes it meet that at once. It is
    /// a ray for the group that gave this hit: in another one the object's
    /// number is another object's.
    pub fn leaving(&self, direction: DVec3) -> Ray {
        self.leaving_on(self.is_outward(direction), direction)
    }

    /// The ray that leaves along `direction` on the side of the geometric normal,
    /// or on the other one; rounding of a direction along the surface decides
    /// nothing.
    pub(crate) fn leaving_on(&self, outward: bool, direction: DVec3) -> Ray {
        self.leave(outward, |_| direction)
    }

    /// The ray that leaves this point and reaches `target` at `t = 1`.
    pub fn leaving_to(&self, target: DVec3) -> Ray {
        self.leave(self.is_outward(target - self.point), |origin| target - origin)
    }

    /// Whether it leads to the side of the geometric normal, as one along the
    /// surface does.
    fn is_outward(&self, direction: DVec3) -> bool {
        !(self.geometric_normal.dot(direction) < 0.0)
    }

    fn leave(&self, outward: bool, direction: impl FnOnce(DVec3) -> DVec3) -> Ray {
        if seeded(Fault::ShadowAcne) {
            return Ray::new(self.point, direction(self.point));
        }
        let n = *self.geometric_normal;
        let side = if outward { 1.0 } else { -1.0 };
        let origin = self.point + n * (side * 2.0 * self.point_error);
        let departure = Departure { part: self.part, outward };
        Ray { origin, direction: direction(origin), leaving: Some((self.object, departure)) }
    }
}

impl accel::Candidate for Hit {
    fn t(&self) -> f64 {
        self.t
    }
}
