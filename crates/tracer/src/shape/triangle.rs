//! `Triangle`: the watertight intersection that renders.
//!
//! The lecture's two methods stand in [`crate::lecture`].

use glam::DVec3;

use super::{Contact, Departure, Geometry, SurfacePoint};
use crate::math::{
    Long, UNIT_ROUNDOFF, difference_of_products, long_product, long_quotient, long_sum, max_abs,
    power_of_two_below, two_sum,
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

impl Geometry for Triangle {
    fn bounds(&self) -> Aabb {
        bounds(self.corners)
    }

    fn intersect(&self, ray: &Ray, range: Interval) -> Option<Contact> {
        Shear::new(ray).intersect_closed(self.corners, range)
    }

    /// A flat surface is left for good.
    fn intersect_leaving(&self, _: &Ray, _: Interval, _: Departure) -> Option<Contact> {
        None
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
    SurfacePoint {
        point: a + beta * (b - a) + gamma * (c - a),
        error: point_error([a, b, c]),
        geometric_normal: normal,
        shading_normal: normal,
    }
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

/// A ray made ready for many triangles: the map that takes it to the positive
/// z axis through the origin.
///
/// Every triangle of a mesh sees its corners moved by the same arithmetic, and
/// the sign of each edge function is exact for the moved corners. So whether a
/// ray passes left or right of an edge is one answer for all who share the
/// edge, and no two of them both deny the ray. On the edge itself
/// [`Shear::intersect`] decides as if the ray ran beside it by less than any
/// number: of the triangles around an edge or a corner that together cover it
/// once, exactly one is hit.
///
/// Corners are moved with twice the digits and rounded once, so that a corner
/// of whole numbers is exactly where it belongs; what surely passes by is sorted
/// out before that in plain arithmetic.
///
/// Source: Woop, Benthin, Wald, "Watertight Ray/Triangle Intersection", JCGT
/// 2(1), 2013. Unlike there the shear does not divide, the edge functions use
/// W. Kahan's determinant instead of a fallback, ties are broken by
/// Edelsbrunner and Muecke, "Simulation of Simplicity", 1990, and there is no
/// swap that keeps the winding: both sides are hit, and without it mirrored
/// rays have mirrored hits to the bit.
pub(super) struct Shear {
    origin: DVec3,
    /// The axis along which the direction is longest, last, and the other two.
    axes: [usize; 3],
    /// The direction along these axes, over `unit`.
    d: [f64; 3],
    /// The power of two below the longest component of the direction: without
    /// it short and long directions would leave the range of products.
    unit: f64,
    /// The direction's first two over its last.
    slopes: [f64; 2],
    /// To which side of a tie the ray is taken to run, along the first two
    /// axes: 1 or -1.
    beside: [f64; 2],
}

/// A triangle seen along the ray: its corners, moved, and its edge functions,
/// which are twice the areas that the ray's point spans with each edge, the
/// ones across from `a`, `b` and `c`.
struct Edges {
    /// Across the ray in the first two, in multiples of the ray's last
    /// component, and along the last axis.
    moved: [[f64; 3]; 3],
    u: f64,
    v: f64,
    w: f64,
}

impl Shear {
    /// The map for this ray.
    pub(super) fn new(ray: &Ray) -> Self {
        let (p, d) = (ray.origin, ray.direction);
        let kz = if d.x.abs() >= d.y.abs() && d.x.abs() >= d.z.abs() {
            0
        } else if d.y.abs() >= d.z.abs() {
            1
        } else {
            2
        };
        let axes = [(kz + 1) % 3, (kz + 2) % 3, kz];
        let [kx, ky, kz] = axes;
        // A direction that is zero or not finite makes everything NaN: a miss.
        let unit = power_of_two_below(d[kz].abs()).unwrap_or(f64::NAN);
        // Against the direction, or else towards the origin's plane: a
        // mirrored ray is taken to run on the mirrored side. The moved corners
        // are mirrored where the ray looks down its axis.
        let beside = |k: usize| {
            let side = if d[k] == 0.0 { p[k] } else { d[k] };
            if (side > 0.0) == (d[kz] > 0.0) { -1.0 } else { 1.0 }
        };
        Self {
            origin: p,
            axes,
            d: axes.map(|k| d[k] / unit),
            unit,
            slopes: [d[kx] / d[kz], d[ky] / d[kz]],
            beside: [beside(kx), beside(ky)],
        }
    }

    /// Whether the ray surely passes the triangle by; false for NaN. What most
    /// candidates need, at a fraction of the cost.
    ///
    /// With `m` the largest distance of a corner from the ray's origin along an
    /// axis, corners are moved here to within 5 roundings of `m`, and are at
    /// most `2 m` across; the edge functions are off by 50 roundings of `m^2`.
    fn is_passed_by(&self, corners: [DVec3; 3]) -> bool {
        const ROUNDINGS: f64 = 64.0;
        let [kx, ky, kz] = self.axes;
        let [sx, sy] = self.slopes;
        let mut m = 0.0_f64;
        let [a, b, c] = corners.map(|corner| {
            let p = corner - self.origin;
            m = m.max(max_abs(p));
            [p[kx] - sx * p[kz], p[ky] - sy * p[kz]]
        });
        let doubt = ROUNDINGS * UNIT_ROUNDOFF * (m * m);
        let u = c[0] * b[1] - c[1] * b[0];
        let v = a[0] * c[1] - a[1] * c[0];
        let w = b[0] * a[1] - b[1] * a[0];
        (u > doubt || v > doubt || w > doubt) && (u < -doubt || v < -doubt || w < -doubt)
    }

    fn moved(&self, corner: DVec3) -> [f64; 3] {
        let [dx, dy, dz] = self.d;
        let [x, y, z] = self.axes.map(|k| two_sum(corner[k], -self.origin[k]));
        // p_x d_z - d_x p_z, from both parts of p.
        let across = |(p, rest): (f64, f64), d: f64| {
            difference_of_products(p, dz, d, z.0) + (rest * dz - d * z.1)
        };
        [across(x, dx), across(y, dy), z.0]
    }

    fn edges(&self, corners: [DVec3; 3]) -> Edges {
        let moved = corners.map(|corner| self.moved(corner));
        let [a, b, c] = moved;
        Edges {
            moved,
            u: difference_of_products(c[0], b[1], c[1], b[0]),
            v: difference_of_products(a[0], c[1], a[1], c[0]),
            w: difference_of_products(b[0], a[1], b[1], a[0]),
        }
    }

    /// The contact of the ray with a triangle that counts its edges and
    /// corners as inside.
    pub(super) fn intersect_closed(&self, corners: [DVec3; 3], range: Interval) -> Option<Contact> {
        if self.is_passed_by(corners) {
            return None;
        }
        let edges = self.edges(corners);
        let Edges { u, v, w, .. } = edges;
        // Positive tests: a NaN is neither, so it is a miss.
        let inside = (u >= 0.0 && v >= 0.0 && w >= 0.0) || (u <= 0.0 && v <= 0.0 && w <= 0.0);
        if inside { self.contact(corners, &edges, range) } else { None }
    }

    /// The contact of the ray with a triangle of a mesh, which shares its
    /// edges and corners with others.
    pub(super) fn intersect(&self, corners: [DVec3; 3], range: Interval) -> Option<Contact> {
        if self.is_passed_by(corners) {
            return None;
        }
        let edges = self.edges(corners);
        let Edges { moved: [a, b, c], u, v, w } = edges;
        let u = if u == 0.0 { self.tie(c, b) } else { u };
        let v = if v == 0.0 { self.tie(a, c) } else { v };
        let w = if w == 0.0 { self.tie(b, a) } else { w };
        let inside = (u > 0.0 && v > 0.0 && w > 0.0) || (u < 0.0 && v < 0.0 && w < 0.0);
        if inside { self.contact(corners, &edges, range) } else { None }
    }

    /// The sign of the edge function of `p` and `q`, where it is 0, for a ray
    /// moved by `(x e, y e^2)` with `e` above 0 and smaller than any number:
    /// that of `x (p_y - q_y) e + y (q_x - p_x) e^2`. Only for an edge without
    /// length it is 0 again.
    fn tie(&self, p: [f64; 3], q: [f64; 3]) -> f64 {
        let [x, y] = self.beside;
        if p[1] == q[1] { y * (q[0] - p[0]) } else { x * (p[1] - q[1]) }
    }

    /// The contact inside all three edges. The weights are of one sign, so
    /// nothing cancels: `t` stays between those of the corners.
    fn contact(&self, corners: [DVec3; 3], edges: &Edges, range: Interval) -> Option<Contact> {
        let Edges { moved: [a, b, c], u, v, w } = *edges;
        let det = u + v + w;
        let along = (u * a[2] + v * b[2] + w * c[2]) / det;
        // The moved corners are off by 3 roundings, and so the areas by 8 of
        // their products; each draws the mean towards its corner.
        let draw = |p: [f64; 3], q: [f64; 3], corner: [f64; 3]| {
            ((p[0] * q[1]).abs() + (p[1] * q[0]).abs()) * (corner[2] - along).abs()
        };
        let drawn = draw(c, b, a) + draw(a, c, b) + draw(b, a, c);
        let plain = || (along / self.d[2] / self.unit, [v / det, w / det]);
        let (t, barycentric) = if drawn > MOST_DRAWN * (det * along).abs() {
            self.long_mean(corners, edges).unwrap_or_else(plain)
        } else {
            plain()
        };
        let is_hit = det != 0.0 && range.contains(t);
        is_hit.then_some(Contact { t, part: 0, barycentric })
    }

    /// `t` and the weights of the second and third corner with twice the
    /// digits, for a hit on a needle, or at a flat angle, or near where the ray
    /// starts. An area that is of the other sign than the rounded one, which
    /// decided the hit, counts as 0: `t` stays between those of the corners.
    /// `None` if nothing is left then.
    fn long_mean(&self, corners: [DVec3; 3], edges: &Edges) -> Option<(f64, [f64; 2])> {
        let d = self.d.map(|d| (d, 0.0));
        let [a, b, c] = corners.map(|corner| {
            let [x, y, z] = self.axes.map(|k| two_sum(corner[k], -self.origin[k]));
            [determinant(x, d[2], d[0], z), determinant(y, d[2], d[1], z), z]
        });
        let side = edges.u + edges.v + edges.w;
        let area = |p: [Long; 3], q: [Long; 3]| {
            let area = determinant(p[0], q[1], p[1], q[0]);
            if area.0 * side.signum() > 0.0 { area } else { (0.0, 0.0) }
        };
        let (u, v, w) = (area(c, b), area(a, c), area(b, a));
        let det = long_sum(long_sum(u, v), w);
        let mean =
            long_sum(long_sum(long_product(u, a[2]), long_product(v, b[2])), long_product(w, c[2]));
        let t = long_quotient(mean, long_product(det, d[2])) / self.unit;
        let weights = [long_quotient(v, det), long_quotient(w, det)];
        (det.0 != 0.0 && t.is_finite()).then_some((t, weights))
    }
}

/// `t` is computed again with twice the digits where rounding the areas may draw
/// it by more than this many times 8 roundings. With the 5 of the mean and the
/// 4 of the quotients that leaves less than 16.
const MOST_DRAWN: f64 = 0.5;

/// `a b - c d` of long numbers, right to a few `u^2` of the products.
fn determinant(a: Long, b: Long, c: Long, d: Long) -> Long {
    let (minus, rest) = long_product(c, d);
    long_sum(long_product(a, b), (-minus, -rest))
}

#[cfg(test)]
mod tests;
