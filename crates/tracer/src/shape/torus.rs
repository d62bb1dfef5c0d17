//! `Torus`: a tube bent into a ring, met as exactly from far away as from near.

mod cubic;
mod line;

use glam::DVec3;

use self::line::{Line, Span};
use super::{Contact, Departure, Formulas, SurfacePoint};
use crate::fault::{Fault, seeded};
use crate::math::{UNIT_ROUNDOFF, max_abs, offset_at};
use crate::refused::{direction, length, number, point, refuse_unless};
use crate::{Aabb, Interval, Ray, Refused, UnitVec};

/// All points at distance `minor_radius` from the ring: the circle of
/// `major_radius` around `center`, in the plane across `axis`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Torus {
    center: DVec3,
    axis: UnitVec,
    major: f64,
    minor: f64,
}

impl Torus {
    /// A torus; the axis may have any length. Equal radii give a horn torus,
    /// whose hole has shrunk to a point.
    ///
    /// # Errors
    /// Refuses numbers that are not finite, an axis of no length, radii that
    /// are not above 0, and a tube thicker than the ring is wide
    /// (`minor_radius > major_radius`): such a surface cuts itself, so that it
    /// has no one outward side.
    pub fn new(
        center: DVec3,
        axis: DVec3,
        major_radius: f64,
        minor_radius: f64,
    ) -> Result<Self, Refused> {
        Refused::unless([
            point("center", center),
            direction("axis", axis),
            length("major_radius", major_radius),
            length("minor_radius", minor_radius).or_else(|| {
                let or_less = number(major_radius);
                refuse_unless(
                    !(minor_radius > major_radius),
                    "minor_radius",
                    format!("at most the `major_radius`, {or_less}, as the tube would cut itself"),
                    || number(minor_radius),
                )
            }),
        ])?;
        // Checked above; the other axis is never used.
        let axis = UnitVec::new(axis).unwrap_or(UnitVec::Z);
        Ok(Self { center, axis, major: major_radius, minor: minor_radius })
    }

    /// How far a computed point may be from the true surface.
    #[inline(always)]
    fn error(&self) -> f64 {
        // The unit vectors across and along the axis and the sum with the
        // center round by less than this many units.
        const UNITS: f64 = 8.0;
        UNITS * UNIT_ROUNDOFF * (self.major + self.minor + max_abs(self.center))
    }
}

impl Formulas for Torus {
    /// The tightest box: the tube reaches `r` farther than the ring.
    fn extent(&self) -> Aabb {
        Aabb::around_circle(self.center, self.axis, self.major).widened(self.minor)
    }

    /// From the inner side of the tube it is met again.
    #[inline(always)]
    fn is_left_for_good(&self, _: Departure) -> bool {
        false
    }

    /// The first of up to four roots; `torus/line.rs` says how none is lost.
    ///
    /// Of a ray that leaves it the side on which it starts is known, so that what
    /// lies ahead follows from where the line is inside and where outside,
    /// whatever the rounding of the start. Roots behind the start are no contacts
    /// then, not even in a range that holds them.
    #[inline(always)]
    fn meet(&self, ray: &Ray, range: Interval, from: Option<Departure>) -> Option<Contact> {
        let line = Line::new(self, ray)?;
        let span = line.span()?;
        let span: Span = match from {
            None => span,
            Some(from) => span.starting_at(line.start(), from.outward),
        };
        line.first_crossing(&span, range).map(Contact::at)
    }

    #[inline(always)]
    fn surface_at(&self, ray: &Ray, contact: &Contact) -> SurfacePoint {
        let offset = offset_at(ray, contact.t, self.center);
        let (spoke, normal) = self.frame(offset);
        SurfacePoint {
            point: self.center + (self.major * spoke + self.minor * *normal),
            error: self.error(),
            geometric_normal: normal,
            shading_normal: normal,
        }
    }
}

impl Torus {
    /// The parts of an offset from the center along the axis and across it.
    #[inline(always)]
    fn parts(&self, offset: DVec3) -> (f64, DVec3) {
        let n = *self.axis;
        let along = crate::math::dot(offset, n);
        (along, DVec3::splat(-along).mul_add(n, offset))
    }

    /// The unit vector from the center to the nearest point of the ring, and
    /// the outward normal: away from there.
    ///
    /// On the axis every spoke is as near. The only surface point there is the
    /// middle of a horn torus, which has no normal; any two opposite vectors
    /// lead back to it, and the axis gives them without a choice.
    #[inline(always)]
    fn frame(&self, offset: DVec3) -> (DVec3, UnitVec) {
        let (along, across) = self.parts(offset);
        let Some(spoke) = UnitVec::new(across) else {
            return (*self.axis, -self.axis);
        };
        let ring = if seeded(Fault::TorusNormalFromCenter) { 0.0 } else { self.major };
        let beyond_ring = across.length() - ring;
        let normal = UnitVec::new(beyond_ring * *spoke + along * *self.axis).unwrap_or(spoke);
        (*spoke, normal)
    }
}

#[cfg(test)]
mod tests;
