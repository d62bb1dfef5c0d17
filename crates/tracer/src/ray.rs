//! `Ray`: the lecture's `r(t) = p + t d`, with `d` of any length.

use glam::DVec3;

use crate::ObjectId;
use crate::shape::Departure;

/// A half line `r(t) = p + t d`.
///
/// The direction is **not** assumed to be of unit length: a ray that goes
/// through a group's transform is not renormalized, so `t` stays the same
/// number in world and object space.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ray {
    /// The lecture's `p`.
    pub origin: DVec3,
    /// The lecture's `d`; any length but zero.
    pub direction: DVec3,
    /// The surface that the ray is known to leave; see [`crate::Hit::leaving`].
    pub leaving: Option<(ObjectId, Departure)>,
}

impl Ray {
    /// A ray from its origin `p` and direction `d`, which leaves no surface.
    pub const fn new(origin: DVec3, direction: DVec3) -> Self {
        Self { origin, direction, leaving: None }
    }

    /// The point `r(t) = p + t d`.
    pub fn at(&self, t: f64) -> DVec3 {
        self.origin + t * self.direction
    }
}
