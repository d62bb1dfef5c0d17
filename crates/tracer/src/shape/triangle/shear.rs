//! `Shear`: a ray made ready for many triangles, the heart of the watertight
//! intersection.

use glam::DVec3;

use super::super::Contact;
use crate::fault::{Fault, seeded};
use crate::math::{
    Long, Real, UNIT_ROUNDOFF, determinant, difference_of_products, long_product, long_quotient,
    long_sum, max_abs, power_of_two_below, two_sum,
};
use crate::simd::Axis;
use crate::{Interval, Ray};

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
pub(in super::super) struct Shear {
    /// The axis along which the direction is longest, last, and the other two.
    axes: [Axis; 3],
    /// The ray along these axes.
    line: Line<f64>,
    /// One over the power of two below the longest component of the direction:
    /// without it short and long directions would leave the range of products.
    scale: f64,
    /// The direction's first two over its last.
    slopes: [f64; 2],
    /// To which side of a tie the ray is taken to run, along the first two
    /// axes: 1 or -1.
    beside: [f64; 2],
}

/// The origin and the direction of a ray along its axes, the direction over a
/// power of two: of one ray, or of several at a time.
#[derive(Clone, Copy)]
pub(in super::super) struct Line<R> {
    pub(in super::super) origin: [R; 3],
    pub(in super::super) d: [R; 3],
}

/// A triangle seen along the ray: its corners, moved, and its edge functions,
/// which are twice the areas that the ray's point spans with each edge, the
/// ones across from `a`, `b` and `c`.
pub(in super::super) struct Edges<R> {
    /// Across the ray in the first two, in multiples of the ray's last
    /// component, and along the last axis.
    moved: [[R; 3]; 3],
    pub(in super::super) u: R,
    pub(in super::super) v: R,
    pub(in super::super) w: R,
}

/// What is met inside all three edges.
pub(in super::super) struct Mean<R> {
    /// `t` over the direction's power of two.
    pub(in super::super) t: R,
    /// The weights of the second and third corner.
    pub(in super::super) barycentric: [R; 2],
    /// If the first is larger than the second, `t` is not as exact as it should
    /// be.
    pub(in super::super) drawn: [R; 2],
}

impl<R: Real> Line<R> {
    /// A corner, along the axes, as the origin sees it, exactly.
    #[inline(always)]
    fn corner_seen(&self, [x, y, z]: [R; 3]) -> [(R, R); 3] {
        let [ox, oy, oz] = self.origin;
        [two_sum(x, -ox), two_sum(y, -oy), two_sum(z, -oz)]
    }

    #[inline(always)]
    fn moved(&self, corner: [R; 3]) -> [R; 3] {
        let [dx, dy, dz] = self.d;
        let [x, y, z] = self.corner_seen(corner);
        [across(x, z, dx, dz), across(y, z, dy, dz), z.0]
    }

    /// A triangle's edge functions.
    #[inline(always)]
    pub(in super::super) fn edges(&self, [a, b, c]: [[R; 3]; 3]) -> Edges<R> {
        let moved @ [a, b, c] = [self.moved(a), self.moved(b), self.moved(c)];
        Edges {
            moved,
            u: difference_of_products(c[0], b[1], c[1], b[0]),
            v: difference_of_products(a[0], c[1], a[1], c[0]),
            w: difference_of_products(b[0], a[1], b[1], a[0]),
        }
    }

    /// What is met of a triangle that has these. The weights are of one sign, so
    /// nothing cancels: `t` stays between those of the corners.
    #[inline(always)]
    pub(in super::super) fn mean(&self, edges: &Edges<R>) -> Mean<R> {
        let Edges { moved: [a, b, c], u, v, w } = *edges;
        let det = u + v + w;
        let along = (u * a[2] + v * b[2] + w * c[2]) / det;
        let drawn = draw(c, b, a, along) + draw(a, c, b, along) + draw(b, a, c, along);
        Mean {
            t: along / self.d[2],
            barycentric: [v / det, w / det],
            drawn: [drawn, det.like(MOST_DRAWN) * (det * along).magnitude()],
        }
    }

    /// [`Line::moved`] with twice the digits.
    #[inline(always)]
    fn long_moved(&self, corner: [R; 3]) -> [Long<R>; 3] {
        let ([x, y, z], [dx, dy, dz]) = (self.corner_seen(corner), self.d);
        let zero = dx.like(0.0);
        let dz = (dz, zero);
        [determinant(x, dz, (dx, zero), z), determinant(y, dz, (dy, zero), z), z]
    }

    /// [`Line::mean`] with twice the digits, for a hit on a needle, or at a flat
    /// angle, or near where the ray starts. An area that is of the other sign
    /// than the rounded one, which decided the hit, counts as 0: `t` stays
    /// between those of the corners. On a sliver no wider than the moved corners'
    /// rounding that, or what is left of the areas, may be the mean of a point
    /// that the ray passes far away from: `t` is then not finite, nor is it where
    /// nothing is left, and [`Line::mean`]'s, which is near, has to do.
    #[inline(always)]
    pub(in super::super) fn long_mean(&self, [a, b, c]: [[R; 3]; 3], edges: &Edges<R>) -> Mean<R> {
        let [a, b, c] = [self.long_moved(a), self.long_moved(b), self.long_moved(c)];
        let side = edges.u + edges.v + edges.w;
        let side = side / side.magnitude();
        let (u, v, w) = (long_area(c, b, side), long_area(a, c, side), long_area(b, a, side));
        let det = long_sum(long_sum(u, v), w);
        let mean =
            long_sum(long_sum(long_product(u, a[2]), long_product(v, b[2])), long_product(w, c[2]));
        let zero = side.like(0.0);
        let depths =
            (u.0 * a[2].0).magnitude() + (v.0 * b[2].0).magnitude() + (w.0 * c[2].0).magnitude();
        let depths = depths * self.d[2].magnitude();
        let weighted = |k: usize| [u.0 * a[k].0, v.0 * b[k].0, w.0 * c[k].0];
        // Above 0 is near, in both axes.
        let is_near = zero.like(1.0).where_positive(room(weighted(0), depths));
        let is_near = is_near.where_positive(room(weighted(1), depths));
        Mean {
            t: long_quotient(mean, long_product(det, (self.d[2], zero))) / is_near,
            barycentric: [long_quotient(v, det), long_quotient(w, det)],
            drawn: [zero; 2],
        }
    }
}

impl Shear {
    /// The map for this ray.
    #[inline(always)]
    pub(in super::super) fn new(ray: &Ray) -> Self {
        let (p, d) = (ray.origin.to_array(), ray.direction.to_array());
        let axes @ [kx, ky, kz] = Axis::from_longest(&d);
        let p = [*kx.of(&p), *ky.of(&p), *kz.of(&p)];
        let d = [*kx.of(&d), *ky.of(&d), *kz.of(&d)];
        // A direction that is zero or not finite makes everything NaN: a miss.
        let scale = 1.0 / power_of_two_below(d[2].abs()).unwrap_or(f64::NAN);
        // Against the direction, or else towards the origin's plane: a
        // mirrored ray is taken to run on the mirrored side. The moved corners
        // are mirrored where the ray looks down its axis.
        let beside = |k: usize| {
            let side = if d[k] == 0.0 { p[k] } else { d[k] };
            if (side > 0.0) == (d[2] > 0.0) { -1.0 } else { 1.0 }
        };
        Self {
            axes,
            line: Line { origin: p, d: [d[0] * scale, d[1] * scale, d[2] * scale] },
            scale,
            slopes: [d[0] / d[2], d[1] / d[2]],
            beside: [beside(0), beside(1)],
        }
    }

    /// Whether the ray surely passes the triangle by; false for NaN. What most
    /// candidates need, at a fraction of the cost.
    ///
    /// With `m` the largest distance of a corner from the ray's origin along an
    /// axis, corners are moved here to within 5 roundings of `m`, and are at
    /// most `2 m` across; the edge functions are off by 50 roundings of `m^2`.
    #[inline(always)]
    fn is_passed_by(&self, corners: [DVec3; 3]) -> bool {
        const ROUNDINGS: f64 = 64.0;
        let [sx, sy] = self.slopes;
        let mut m = 0.0_f64;
        let [a, b, c] = corners.map(|corner| {
            let corner = corner.to_array();
            let [x, y, z] = [0, 1, 2].map(|k| *self.axes[k].of(&corner) - self.line.origin[k]);
            m = m.max(max_abs(DVec3::new(x, y, z)));
            [x - sx * z, y - sy * z]
        });
        let doubt = ROUNDINGS * UNIT_ROUNDOFF * (m * m);
        let u = c[0] * b[1] - c[1] * b[0];
        let v = a[0] * c[1] - a[1] * c[0];
        let w = b[0] * a[1] - b[1] * a[0];
        let (u, v, w) = wrong((u, v, w));
        (u > doubt || v > doubt || w > doubt) && (u < -doubt || v < -doubt || w < -doubt)
    }

    /// The corners along the axes.
    #[inline(always)]
    pub(in super::super) fn turned(&self, [a, b, c]: [DVec3; 3]) -> [[f64; 3]; 3] {
        [self.turn(a), self.turn(b), self.turn(c)]
    }

    #[inline(always)]
    fn turn(&self, corner: DVec3) -> [f64; 3] {
        let (corner, [kx, ky, kz]) = (corner.to_array(), self.axes);
        [*kx.of(&corner), *ky.of(&corner), *kz.of(&corner)]
    }

    /// A corner that was turned along the axes.
    pub(in super::super) fn turned_back(&self, corner: [f64; 3]) -> DVec3 {
        let mut back = [0.0; 3];
        for (axis, x) in self.axes.into_iter().zip(corner) {
            *axis.of_mut(&mut back) = x;
        }
        DVec3::from_array(back)
    }

    /// The ray along its axes, and one over the power of two that its direction
    /// is multiplied by.
    #[inline(always)]
    pub(in super::super) fn line(&self) -> (Line<f64>, f64) {
        (self.line, self.scale)
    }

    /// The contact of the ray with a triangle that counts its edges and
    /// corners as inside.
    #[inline(always)]
    pub(in super::super) fn intersect_closed(
        &self,
        corners: [DVec3; 3],
        range: Interval,
    ) -> Option<Contact> {
        if self.is_passed_by(corners) {
            return None;
        }
        let edges = self.line.edges(self.turned(corners));
        let Edges { u, v, w, .. } = edges;
        // Positive tests: a NaN is neither, so it is a miss.
        let (u, v, w) = wrong((u, v, w));
        let inside = (u >= 0.0 && v >= 0.0 && w >= 0.0) || (u <= 0.0 && v <= 0.0 && w <= 0.0);
        if inside { self.contact(corners, &edges, range) } else { None }
    }

    /// The contact of the ray with a triangle of a mesh, which shares its
    /// edges and corners with others.
    pub(in super::super) fn intersect(
        &self,
        corners: [DVec3; 3],
        range: Interval,
    ) -> Option<Contact> {
        if self.is_passed_by(corners) { None } else { self.decide(corners, range) }
    }

    /// [`Shear::intersect`] for a triangle that the ray hardly passes by.
    #[inline(always)]
    pub(in super::super) fn decide(&self, corners: [DVec3; 3], range: Interval) -> Option<Contact> {
        let edges = self.line.edges(self.turned(corners));
        let Edges { moved: [a, b, c], u, v, w } = edges;
        let u = if u == 0.0 { self.tie(c, b) } else { u };
        let v = if v == 0.0 { self.tie(a, c) } else { v };
        let w = if w == 0.0 { self.tie(b, a) } else { w };
        let (u, v, w) = wrong((u, v, w));
        let inside = (u > 0.0 && v > 0.0 && w > 0.0) || (u < 0.0 && v < 0.0 && w < 0.0);
        if inside { self.contact(corners, &edges, range) } else { None }
    }

    /// The sign of the edge function of `p` and `q`, where it is 0, for a ray
    /// moved by `(x e, y e^2)` with `e` above 0 and smaller than any number:
    /// that of `x (p_y - q_y) e + y (q_x - p_x) e^2`. Only for an edge without
    /// length it is 0 again.
    #[inline(always)]
    fn tie(&self, p: [f64; 3], q: [f64; 3]) -> f64 {
        let [x, y] = self.beside;
        if p[1] == q[1] { y * (q[0] - p[0]) } else { x * (p[1] - q[1]) }
    }

    /// The contact inside all three edges.
    #[inline(always)]
    fn contact(&self, corners: [DVec3; 3], edges: &Edges<f64>, range: Interval) -> Option<Contact> {
        let Mean { t, barycentric, drawn } = self.line.mean(edges);
        let mut found = (t * self.scale, barycentric);
        if drawn[0] > drawn[1] {
            let Mean { t, barycentric, .. } = self.line.long_mean(self.turned(corners), edges);
            let t = t * self.scale;
            if t.is_finite() {
                found = (t, barycentric);
            }
        }
        let (t, barycentric) = found;
        let is_hit = edges.u + edges.v + edges.w != 0.0 && range.contains(t);
        is_hit.then_some(Contact { t, part: 0, barycentric })
    }
}

/// The edge functions, or what a fault makes of them.
#[inline(always)]
fn wrong((u, v, w): (f64, f64, f64)) -> (f64, f64, f64) {
    let u = if seeded(Fault::EdgeTestInverted) { -u } else { u };
    let w = if seeded(Fault::EdgeTestMissing) { v } else { w };
    if seeded(Fault::BackFaceCulled) && u > 0.0 { (u, -v, w) } else { (u, v, w) }
}

/// `t` is computed again with twice the digits where rounding the areas may draw
/// it by more than this many times 8 roundings. With the 5 of the mean and the
/// 4 of the quotients that leaves less than 16.
const MOST_DRAWN: f64 = 0.5;

/// `p_x d_z - d_x p_z`, from both parts of `p`.
#[inline(always)]
fn across<R: Real>(p: (R, R), p_z: (R, R), d: R, d_z: R) -> R {
    difference_of_products(p.0, d_z, d, p_z.0) + (p.1 * d_z - d * p_z.1)
}

/// How far the rounding of the area between `p` and `q` may draw the weighted
/// mean of the depths towards its corner, in 8 roundings of the sum of all
/// areas: the moved corners are off by 3 roundings, and so the areas by 8 of
/// their products.
#[inline(always)]
fn draw<R: Real>(p: [R; 3], q: [R; 3], corner: [R; 3], along: R) -> R {
    ((p[0] * q[1]).magnitude() + (p[1] * q[0]).magnitude()) * (corner[2] - along).magnitude()
}

/// How much farther the mean of three weighted places across the ray may be from
/// it, if its weights are those of the point that is met: what the rounding of
/// the places, the weights, the products and the two sums may move it by, 5
/// roundings of each at most, and a little for what twice the digits lose.
#[inline(always)]
fn room<R: Real>([a, b, c]: [R; 3], depths: R) -> R {
    const ROUNDINGS: f64 = 6.0;
    let sizes = a.magnitude() + b.magnitude() + c.magnitude();
    let bound = a.like(ROUNDINGS * UNIT_ROUNDOFF) * sizes + a.like(UNIT_ROUNDOFF) * depths;
    bound - (a + b + c).magnitude()
}

/// The area between two corners; 0 if it is of the other sign than `side`, which
/// is 1 or -1.
#[inline(always)]
fn long_area<R: Real>(p: [Long<R>; 3], q: [Long<R>; 3], side: R) -> Long<R> {
    let area = determinant(p[0], q[1], p[1], q[0]);
    let test = area.0 * side;
    (area.0.where_positive(test), area.1.where_positive(test))
}

#[cfg(test)]
mod tests;
