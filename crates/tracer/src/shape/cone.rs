//! `Cone`: a round cone around any axis, closed by its base or open.

use glam::DVec3;

use super::axial::{
    Approach, Axis, Crossing, Near, SIDE, apart, difference_of_squares, roots, size,
};
use super::{Contact, Departure, Formulas, SurfacePoint};
use crate::fault::{Fault, seeded};
use crate::math::{UNIT_ROUNDOFF, difference_of_products, dot};
use crate::refused::{length, point};
use crate::{Aabb, Interval, Ray, Refused, UnitVec};

/// The part that is the base; the side is [`SIDE`].
const BASE: u32 = 1;

/// The segments from `apex` to the circle of `radius` around `base` across
/// the axis; with caps, also the disk within the circle. Its parts are the
/// side and the disk.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cone {
    axis: Axis,
    radius: f64,
    caps: bool,
}

/// `q2 s^2 + 2 q1 s + q0` for the double cone `|m|^2 - (k h)^2`: with
/// `m = M + s D` and `h = H + s g` it has `q2 = D.D - (k g)^2`,
/// `q1 = M.D - k^2 H g` and `q0 = M.M - (k H)^2`.
///
/// Its discriminant is `q1^2 - q2 q0 = k^2 |F|^2 - |M x D|^2` with
/// `F = g M - H D`, which is `g` times the line's `m` where it is as high as
/// the apex.
struct Quadratic {
    q2: f64,
    q1: f64,
    q0: f64,
    f: DVec3,
}

impl Cone {
    /// A cone from its `apex` to the disk around `base`, with or without it.
    ///
    /// # Errors
    /// Refuses points that are not finite or not apart, and a radius that is
    /// not above 0.
    pub fn new(apex: DVec3, base: DVec3, radius: f64, caps: bool) -> Result<Self, Refused> {
        Refused::unless([
            point("apex", apex),
            point("base", base),
            length("radius", radius),
            apart("base", "apex", apex, base),
        ])?;
        Ok(Self { axis: Axis::new(apex, base), radius, caps })
    }

    /// How fast it widens: the tangent of half the angle at the apex.
    #[inline(always)]
    fn slope(&self) -> f64 {
        self.radius / self.axis.unit / self.axis.length
    }

    /// The quadratic whose sign says on which side of the side a line is:
    /// `|m| <= k h` inside, with the slope `k` and for `h >= 0`.
    #[inline(always)]
    fn quadratic(&self, ray: &Approach) -> Quadratic {
        let (m, d, g, h) = (ray.m, ray.sideways, ray.climb, ray.height());
        let k = self.slope();
        let f = DVec3::new(
            difference_of_products(g, m.x, h, d.x),
            difference_of_products(g, m.y, h, d.y),
            difference_of_products(g, m.z, h, d.z),
        );
        Quadratic {
            q2: difference_of_squares(size(d), k * g),
            q1: (-(k * h)).mul_add(k * g, dot(m, d)),
            q0: difference_of_squares(size(m), k * h),
            f,
        }
    }

    /// `|m|` at the rim of the base.
    #[inline(always)]
    fn reach(&self) -> f64 {
        self.radius / self.axis.unit * self.axis.length
    }

    /// The ray as seen from close by.
    ///
    /// Closest to the apex is best where the line glides along the side, which
    /// only its distance from the apex tells from a hit. But that point may be
    /// many radii from a narrow cone; then the nearer root is closer.
    #[inline(always)]
    fn approach(&self, ray: &Ray) -> Option<Approach> {
        let near = self.axis.approach(ray, &Near::FirstEnd)?;
        if size(near.m) <= self.reach() {
            return Some(near);
        }
        let Quadratic { q2, q1, .. } = self.quadratic(&near);
        let middle = -q1 / q2;
        let s = self.side(&near).map_or(middle, |[low, high]| low.max(high.min(0.0)));
        Some(if s.is_finite() { near.moved(s) } else { near })
    }

    /// Between which `s` the line is inside the endless side.
    #[inline(always)]
    fn side(&self, ray: &Approach) -> Option<[f64; 2]> {
        let Quadratic { q2, q1, q0, f } = self.quadratic(ray);
        let k = self.slope();
        let discriminant = difference_of_squares(k * size(f), ray.moment());
        let reach =
            (size(ray.m) + k * ray.height().abs()) / (size(ray.sideways) + k * ray.climb.abs());
        let [one, other] = roots(q2, q1, q0, discriminant, reach)?;
        if q2 < 0.0 {
            // Steeper than the side: through both halves, each endless.
            Some(if ray.climb > 0.0 {
                [one.max(other), f64::INFINITY]
            } else {
                [f64::NEG_INFINITY, one.min(other)]
            })
        } else {
            // Between the roots, in the half where their middle is: its height
            // is `H - g q1 / q2 = -F.D / q2`.
            (f.dot(ray.sideways) <= 0.0).then(|| [one.min(other), one.max(other)])
        }
    }

    #[inline(always)]
    fn crossing(&self, ray: &Ray) -> Option<Crossing> {
        if self.axis.is_passed_by(ray, self.radius) {
            return None;
        }
        let ray = self.approach(ray)?;
        ray.cut(self.side(&ray), [None, Some(BASE)], self.reach(), self.caps)
    }

    /// The point of the side next to one that is off it by rounding, as its
    /// height in units and its offset from the axis, and the outward normal.
    #[inline(always)]
    fn onto_side(&self, height: f64, across: DVec3) -> (f64, DVec3, UnitVec) {
        let k = self.slope();
        // Along the line from the apex, in the plane of the point and the axis.
        let on_side = k.mul_add(across.length(), height) / k.mul_add(k, 1.0);
        let height = on_side.clamp(0.0, self.axis.length);
        // The apex has no normal of its own; this one is between all others.
        let at_apex = -self.axis.direction;
        match UnitVec::new(across) {
            Some(outward) => {
                let tilt = if seeded(Fault::ConeNormalOfCylinder) { 0.0 } else { k };
                let normal = UnitVec::new(*outward - tilt * *self.axis.direction);
                (height, k * height * *outward, normal.unwrap_or(at_apex))
            }
            None => (height, DVec3::ZERO, at_apex),
        }
    }
}

impl Formulas for Cone {
    fn extent(&self) -> Aabb {
        self.axis.disk_bounds(1, self.radius).union(Aabb::around([self.axis.ends[0]]))
    }

    /// The side is convex, so a ray that leaves it outward never comes back,
    /// nor does one from the base.
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
        let axis = &self.axis;
        let near = self.approach(ray);
        let (point, normal) = match (near, contact.part) {
            // No contact of a ray that is not finite was ever returned.
            (None, _) => (axis.ends[0], -axis.direction),
            (Some(near), SIDE) => {
                let s = near.nearest(self.side(&near).unwrap_or([f64::NAN; 2]), contact.t);
                let across = axis.across(near.m + s * near.sideways);
                let (height, across, normal) = self.onto_side(near.height_at(s), across);
                (axis.point(height, across), normal)
            }
            (Some(near), _) => (near.point_of_cap(1, self.radius / axis.unit), axis.direction),
        };
        SurfacePoint {
            point,
            error: 16.0 * UNIT_ROUNDOFF * (axis.coordinates() + self.radius),
            geometric_normal: normal,
            shading_normal: normal,
        }
    }
}

#[cfg(test)]
mod tests;
