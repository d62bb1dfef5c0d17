//! `Triangle`: the watertight intersection that renders.
//!
//! The lecture's two methods stand in [`crate::lecture`].

use glam::DVec3;

use super::{Contact, Geometry, SurfacePoint};
use crate::math::{UNIT_ROUNDOFF, difference_of_products, max_abs};
use crate::refused::{point, refuse_unless};
use crate::{Aabb, Interval, Ray, Refused, UnitVec};

/// The triangle of three corners; its front, where they run
/// counter-clockwise, is where its normal points. Both sides are hit.
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

impl Geometry for Triangle {
    fn bounds(&self) -> Aabb {
        bounds(self.corners)
    }

    fn intersect(&self, ray: &Ray, range: Interval) -> Option<Contact> {
        Shear::new(ray).intersect(self.corners, range)
    }

    fn surface(&self, _: &Ray, contact: &Contact) -> SurfacePoint {
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
    UnitVec::new(DVec3::new(
        difference_of_products(e.y, f.z, e.z, f.y),
        difference_of_products(e.z, f.x, e.x, f.z),
        difference_of_products(e.x, f.y, e.y, f.x),
    ))
}

/// Bounds of the corners.
pub(super) fn bounds(corners: [DVec3; 3]) -> Aabb {
    Aabb::around(corners)
}

/// The point by its corners' weights, which stays on the plane whatever the
/// error of `t`.
pub(super) fn surface([a, b, c]: [DVec3; 3], normal: UnitVec, contact: &Contact) -> SurfacePoint {
    let [beta, gamma] = contact.barycentric;
    let size = max_abs(a).max(max_abs(b)).max(max_abs(c));
    SurfacePoint {
        point: a + beta * (b - a) + gamma * (c - a),
        // The interpolation is off by 8 roundings at most; the factor also
        // covers the shear of a ray that leaves along the triangle.
        error: 16.0 * UNIT_ROUNDOFF * size,
        geometric_normal: normal,
        shading_normal: normal,
    }
}

/// A ray made ready for many triangles: the map that takes it to the positive
/// z axis through the origin.
///
/// Every triangle of a mesh sees its corners moved by the same rounded
/// arithmetic, and the sign of each edge function is exact for the moved
/// corners, so two triangles never both deny a ray through their shared edge.
///
/// Source: Woop, Benthin, Wald, "Watertight Ray/Triangle Intersection", JCGT
/// 2(1), 2013; the edge functions use W. Kahan's determinant instead of the
/// paper's fallback. The paper's swap that keeps the winding is left out:
/// both sides are hit, and without it mirrored rays have mirrored hits to the
/// bit.
pub(super) struct Shear {
    origin: DVec3,
    /// The axis along which the direction is longest, and the other two.
    axes: [usize; 3],
    slopes: [f64; 3],
}

impl Shear {
    /// The map for this ray.
    pub(super) fn new(ray: &Ray) -> Self {
        let d = ray.direction;
        let kz = if d.x.abs() >= d.y.abs() && d.x.abs() >= d.z.abs() {
            0
        } else if d.y.abs() >= d.z.abs() {
            1
        } else {
            2
        };
        let axes = [(kz + 1) % 3, (kz + 2) % 3, kz];
        let [kx, ky, kz] = axes;
        Self { origin: ray.origin, axes, slopes: [d[kx] / d[kz], d[ky] / d[kz], 1.0 / d[kz]] }
    }

    /// The contact of the ray with these corners.
    pub(super) fn intersect(&self, corners: [DVec3; 3], range: Interval) -> Option<Contact> {
        let [kx, ky, kz] = self.axes;
        let [sx, sy, sz] = self.slopes;
        let [a, b, c] = corners.map(|corner| {
            let p = corner - self.origin;
            [p[kx] - sx * p[kz], p[ky] - sy * p[kz], sz * p[kz]]
        });
        let u = difference_of_products(c[0], b[1], c[1], b[0]);
        let v = difference_of_products(a[0], c[1], a[1], c[0]);
        let w = difference_of_products(b[0], a[1], b[1], a[0]);
        // Positive tests: a NaN is neither, so it is a miss.
        let inside = (u >= 0.0 && v >= 0.0 && w >= 0.0) || (u <= 0.0 && v <= 0.0 && w <= 0.0);
        let det = u + v + w;
        if !(inside && det != 0.0) {
            return None;
        }
        let t = (u * a[2] + v * b[2] + w * c[2]) / det;
        range.contains(t).then(|| Contact { t, part: 0, barycentric: [v / det, w / det] })
    }
}

#[cfg(test)]
mod tests;
