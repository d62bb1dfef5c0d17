//! `Triangle`: the watertight intersection that renders.
//!
//! The lecture's two methods stand in [`crate::lecture`].

mod shear;

pub(super) use shear::{Line, Shear};

use glam::DVec3;

use super::{Contact, Departure, Formulas, SurfacePoint};
use crate::fault::{Fault, seeded};
use crate::math::{
    Long, UNIT_ROUNDOFF, determinant, difference_of_products, long_product, long_sum, max_abs,
    two_sum,
};
use crate::refused::{point, refuse_unless};
use crate::{Aabb, Interval, Ray, Refused, UnitVec};

/// The triangle of three corners; its front, where they run
/// counter-clockwise, is where its normal points. Both sides are hit, and so
/// are its edges and corners.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Triangle {
    corners: [DVec3; 3],
    normal: UnitVec,
}

impl Triangle {
    /// A triangle from its corners `a`, `b` and `c`.
    ///
    /// # Errors
    /// Refuses corners that are not finite, and three corners on a line.
    pub fn new(a: DVec3, b: DVec3, c: DVec3) -> Result<Self, Refused> {
        Refused::unless([point("a", a), point("b", b), point("c", c)])?;
        let normal = normal([a, b, c]);
        Refused::unless([refuse_unless(
            normal.is_some(),
            "c",
            "a corner off the line through `a` and `b`",
            || crate::refused::show(c),
        )])?;
        Ok(Self { corners: [a, b, c], normal: normal.unwrap_or(UnitVec::Z) })
    }
}

impl Formulas for Triangle {
    fn extent(&self) -> Aabb {
        bounds(self.corners)
    }

    /// A flat surface is.
    #[inline(always)]
    fn is_left_for_good(&self, _: Departure) -> bool {
        true
    }

    #[inline(always)]
    fn meet(&self, ray: &Ray, range: Interval, _: Option<Departure>) -> Option<Contact> {
        Shear::new(ray).intersect_closed(self.corners, range)
    }

    #[inline(always)]
    fn surface_at(&self, _: &Ray, contact: &Contact) -> SurfacePoint {
        surface(self.corners, self.normal, contact)
    }
}

/// The unit normal `(b - a) x (c - a)`; `None` for corners on a line. Each
/// component has its exact sign for the rounded edges, so a thin triangle that
/// can be hit has a normal.
pub(super) fn normal([a, b, c]: [DVec3; 3]) -> Option<UnitVec> {
    let (e, f) = (b - a, c - a);
    // Scaled so that products neither overflow nor underflow.
    let (e, f) = (e / max_abs(e), f / max_abs(f));
    let (e, f) = if seeded(Fault::WindingIgnored) && e.x < f.x { (f, e) } else { (e, f) };
    UnitVec::new(DVec3::new(
        difference_of_products(e.y, f.z, e.z, f.y),
        difference_of_products(e.z, f.x, e.x, f.z),
        difference_of_products(e.x, f.y, e.y, f.x),
    ))
}

/// Whether a triangle has a [`normal`].
///
/// Proof that the quick answer is the other one. Let `m` and `n` be the largest
/// components of the edges. A product of two components is off by a roundoff `u`
/// of at most `m n`, their difference by another, and by next to nothing where
/// they underflow: where it is found above `16 u m n`, it is above `12 u m n`.
/// `normal` divides the edges by `m` and `n`, which moves each component by `u`
/// of itself and the difference by `4 u` at most, so that what it finds is above
/// `8 u`, and no zero.
#[inline(always)]
pub(super) fn has_normal([a, b, c]: [DVec3; 3]) -> bool {
    /// See the proof.
    const CLEAR: f64 = 16.0 * UNIT_ROUNDOFF;
    /// A product from here on keeps `u` of itself in the range of `f64`.
    const LEAST: f64 = f64::MIN_POSITIVE / (UNIT_ROUNDOFF * UNIT_ROUNDOFF);
    let (e, f) = (b - a, c - a);
    let largest = max_abs(e) * max_abs(f);
    let is_clear = largest >= LEAST && max_abs(e.cross(f)) > CLEAR * largest;
    is_clear || normal([a, b, c]).is_some()
}

/// Bounds of the corners.
#[inline(always)]
pub(super) fn bounds(corners: [DVec3; 3]) -> Aabb {
    let [a, b, c] = corners;
    Aabb { min: a.min(b).min(c), max: a.max(b).max(c) }
}

/// The point by its corners' weights, which stays on the plane whatever the
/// error of `t`.
pub(super) fn surface([a, b, c]: [DVec3; 3], normal: UnitVec, contact: &Contact) -> SurfacePoint {
    let [beta, gamma] = weights(contact);
    SurfacePoint {
        point: a + beta * (b - a) + gamma * (c - a),
        error: point_error([a, b, c]),
        geometric_normal: normal,
        shading_normal: normal,
    }
}

/// How much the second and the third corner count at a contact.
#[inline(always)]
pub(super) fn weights(contact: &Contact) -> [f64; 2] {
    let [beta, gamma] = contact.barycentric;
    if seeded(Fault::WeightsSwapped) { [gamma, beta] } else { [beta, gamma] }
}

/// How far off the triangle a point of it may be by rounding: the
/// interpolation is off by 8 roundings at most, and the factor also covers the
/// shear of a ray that leaves along the triangle.
fn point_error(corners: [DVec3; 3]) -> f64 {
    16.0 * UNIT_ROUNDOFF * corners.into_iter().map(max_abs).fold(0.0, f64::max)
}

/// Whether `direction` leads away from the triangle's plane to the side on
/// which all of `start`'s corners are: whatever point of `start` a ray comes
/// from, it cannot meet the triangle.
///
/// A corner that is as close to the plane as the start of a ray may be by its
/// own rounding, such as a shared one, is on either side. Everything else is
/// decided with twice the digits: the normal of a sliver has few of its own.
pub(super) fn is_turned_from([a, b, c]: [DVec3; 3], start: [DVec3; 3], direction: DVec3) -> bool {
    /// Of numbers with twice the digits, some of which have cancelled: what is
    /// left of the normal of a triangle as thin as can be is above this.
    const DOUBT: f64 = UNIT_ROUNDOFF * UNIT_ROUNDOFF * 64.0;
    let difference = |p: DVec3| [0, 1, 2].map(|k| two_sum(p[k], -a[k]));
    let (e, f) = (difference(b), difference(c));
    let normal = [[1, 2], [2, 0], [0, 1]].map(|[k, l]| determinant(e[k], f[l], e[l], f[k]));
    let along_normal = |v: [Long; 3]| {
        let [x, y, z] = [0, 1, 2].map(|k| long_product(v[k], normal[k]));
        long_sum(long_sum(x, y), z).0
    };
    let forward = along_normal(direction.to_array().map(|d| (d, 0.0)));
    let doubt = DOUBT * max_abs(b - a) * max_abs(c - a) * max_abs(direction);
    if !(forward.abs() > doubt) {
        return false;
    }
    let length = DVec3::from_array(normal.map(|n| n.0)).length();
    let start_error = point_error(start) * length;
    start.into_iter().all(|p| forward.signum() * along_normal(difference(p)) >= -start_error)
}

#[cfg(test)]
mod tests;
