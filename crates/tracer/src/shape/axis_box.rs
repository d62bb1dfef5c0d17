//! `AxisBox`: an axis-aligned box by the lecture's three slabs.

use glam::DVec3;

use super::{Contact, Departure, Formulas, SurfacePoint};
use crate::fault::{Fault, seeded};
use crate::lecture::ray_slab;
use crate::math::UNIT_ROUNDOFF;
use crate::refused::{point, refuse_unless, show};
use crate::{Aabb, Interval, Ray, Refused, UnitVec};

/// All points with `min <= x <= max` in each axis. A box may be flat.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AxisBox {
    min: DVec3,
    max: DVec3,
}

impl AxisBox {
    /// A box from its lowest and its highest corner.
    ///
    /// # Errors
    /// Refuses corners that are not finite, and a `max` below `min`.
    pub fn new(min: DVec3, max: DVec3) -> Result<Self, Refused> {
        Refused::unless([
            point("min", min),
            point("max", max),
            refuse_unless(
                !(min.is_finite() && max.is_finite()) || min.cmple(max).all(),
                "max",
                format!("a corner that is nowhere below `min`, {}", show(min)),
                || show(max),
            ),
        ])?;
        Ok(Self { min, max })
    }
}

/// The line's way through the box: where, and by which axis' sides.
struct Crossing {
    enter: f64,
    leave: f64,
    enter_axis: usize,
    leave_axis: usize,
}

impl AxisBox {
    /// The three slabs' intervals, cut to their common part.
    ///
    /// Each quotient of [`ray_slab`] is off by at most 3/2 units in the last
    /// place, so a line through an edge may seem to enter one slab just after
    /// it has left the other; up to 4 units that is still a hit.
    #[inline(always)]
    fn crossing(&self, ray: &Ray) -> Option<Crossing> {
        let (mut enter, mut leave) = (f64::NEG_INFINITY, f64::INFINITY);
        let (mut enter_axis, mut leave_axis) = (0, 0);
        for axis in 0..3 {
            let (p, d) = (ray.origin[axis], ray.direction[axis]);
            let (t_in, t_out) = ray_slab(p, d, self.min[axis], self.max[axis])?;
            let is_last = if seeded(Fault::BoxEnteredTooEarly) { axis == 0 } else { t_in > enter };
            if is_last {
                (enter, enter_axis) = (t_in, axis);
            }
            if t_out < leave {
                (leave, leave_axis) = (t_out, axis);
            }
        }
        let slack = 8.0 * UNIT_ROUNDOFF * enter.abs().max(leave.abs());
        let met = enter <= leave + slack;
        // An infinite slack belongs to a zero direction, which hits nothing. On
        // a line through an edge the way inside has no length, not less.
        let leave = leave.max(enter);
        let is_met = met && slack.is_finite() && ray.direction.is_finite();
        is_met.then_some(Crossing { enter, leave, enter_axis, leave_axis })
    }
}

/// The number of a face: twice its axis, plus one for the higher side.
#[inline(always)]
fn face(axis: usize, higher: bool) -> u32 {
    2 * axis as u32 + u32::from(higher)
}

impl Formulas for AxisBox {
    fn extent(&self) -> Aabb {
        Aabb { min: self.min, max: self.max }
    }

    /// Outward it is, and where the box is flat.
    #[inline(always)]
    fn is_left_for_good(&self, from: Departure) -> bool {
        // A part that is no face of a box is taken for one.
        let axis = (from.part as usize / 2).min(2);
        from.outward || self.min[axis] == self.max[axis]
    }

    /// The side where the ray enters, or the one where it leaves if the entry
    /// is out of range, as for a ray from inside, or if the ray leaves the box
    /// inward.
    #[inline(always)]
    fn meet(&self, ray: &Ray, range: Interval, from: Option<Departure>) -> Option<Contact> {
        let crossing = self.crossing(ray)?;
        let d = ray.direction;
        let contact = |t, part| Contact { t, part, barycentric: [0.0; 2] };
        if from.is_none() && range.contains(crossing.enter) {
            let axis = crossing.enter_axis;
            Some(contact(crossing.enter, face(axis, d[axis] < 0.0)))
        } else if range.contains(crossing.leave) && !seeded(Fault::BoxLostFromInside) {
            let axis = crossing.leave_axis;
            Some(contact(crossing.leave, face(axis, d[axis] > 0.0)))
        } else {
            None
        }
    }

    #[inline(always)]
    fn surface_at(&self, ray: &Ray, contact: &Contact) -> SurfacePoint {
        let (axis, higher) = ((contact.part as usize / 2).min(2), contact.part % 2 == 1);
        let mut point = ray.at(contact.t).clamp(self.min, self.max);
        point[axis] = if higher { self.max[axis] } else { self.min[axis] };
        let normal = UnitVec::axis(axis);
        let normal = if higher ^ seeded(Fault::BoxNormalInward) { normal } else { -normal };
        SurfacePoint {
            point,
            // The point is on its side exactly; a start that is rounded again
            // is off by no more than this along the normal.
            error: 4.0 * UNIT_ROUNDOFF * point[axis].abs(),
            geometric_normal: normal,
            shading_normal: normal,
        }
    }
}

#[cfg(test)]
mod tests;
