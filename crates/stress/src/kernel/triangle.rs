//! The triangle's textbook kernels, in `f32` or `f64`, and in double-double.
//!
//! A triangle is its three corners; both of its sides are hit, and its edges
//! and corners belong to it.

use super::{Range, Ray, Real, Vector, along, axes_of, cross, dot, minus};
use crate::number::{Dd, Number, V3};

/// Three corners.
pub type Corners<R> = [Vector<R>; 3];

/// First the plane, then three half spaces.
///
/// Source: Cornell CS4620, "Ray Tracing Basics", 2011, slides "Ray-triangle
/// intersection" and "Inside-edge test".
#[inline(never)]
pub fn inside_edges<R: Real>([a, b, c]: &Corners<R>, ray: &Ray<R>, range: Range<R>) -> Option<R> {
    let n = cross(minus(*b, *a), minus(*c, *a));
    let t = dot(minus(*a, ray.origin), n) / dot(ray.direction, n);
    if !range.contains(t) {
        return None;
    }
    let x = along(ray.origin, t, ray.direction);
    let left_of =
        |p: &Vector<R>, q: &Vector<R>| dot(cross(minus(*q, *p), minus(x, *p)), n) >= R::ZERO;
    (left_of(a, b) && left_of(b, c) && left_of(c, a)).then_some(t)
}

/// `a + beta (b - a) + gamma (c - a) = origin + t direction` by Cramer's rule.
///
/// Source: the same slides, which point to Shirley and Marschner,
/// "Fundamentals of Computer Graphics", 3rd edition, section 4.4.2.
#[inline(never)]
pub fn linear_system<R: Real>([a, b, c]: &Corners<R>, ray: &Ray<R>, range: Range<R>) -> Option<R> {
    // The columns of the system and its right-hand side.
    let (first, second, third) = (minus(*a, *b), minus(*a, *c), ray.direction);
    let right = minus(*a, ray.origin);
    let across = cross(second, third);
    let m = dot(first, across);
    let beta = dot(right, across) / m;
    let turned = cross(first, right);
    let gamma = dot(third, turned) / m;
    let t = -dot(second, turned) / m;
    let inside = beta >= R::ZERO && gamma >= R::ZERO && beta + gamma <= R::ONE;
    (inside && range.contains(t)).then_some(t)
}

/// The same system with the triple products shared and early ways out. The
/// determinant is compared with zero and no epsilon.
///
/// Source: Moeller, Trumbore, "Fast, Minimum Storage Ray/Triangle
/// Intersection", Journal of Graphics Tools 2(1), 1997.
#[inline(never)]
pub fn moeller_trumbore<R: Real>(
    [a, b, c]: &Corners<R>,
    ray: &Ray<R>,
    range: Range<R>,
) -> Option<R> {
    let (e, f) = (minus(*b, *a), minus(*c, *a));
    let p = cross(ray.direction, f);
    let det = dot(e, p);
    if det == R::ZERO {
        return None;
    }
    let inverse = R::ONE / det;
    let s = minus(ray.origin, *a);
    let u = dot(s, p) * inverse;
    if !(u >= R::ZERO && u <= R::ONE) {
        return None;
    }
    let q = cross(s, e);
    let v = dot(ray.direction, q) * inverse;
    if !(v >= R::ZERO && u + v <= R::ONE) {
        return None;
    }
    let t = dot(f, q) * inverse;
    range.contains(t).then_some(t)
}

/// A triangle as the affine map that takes it to the corners (0, 0), (1, 0)
/// and (0, 1) of the plane 0: nine numbers, as the third row is 1 along the
/// normal's longest axis and the first two are 0 there.
///
/// Source: Baldwin, Weber, "Fast Ray-Triangle Intersections by Coordinate
/// Transformation", JCGT 5(3), 2016.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Affine<R> {
    /// The axis of the ones and zeros last, the two others before it.
    axes: [usize; 3],
    /// For `beta`, `gamma` and the height: the factors of the two other axes,
    /// and what is added.
    rows: [Vector<R>; 3],
}

impl<R: Real> Affine<R> {
    /// The map of these corners, made in the precision in which it is used;
    /// full of NaN for corners on a line, so that nothing hits it.
    pub fn new([a, b, c]: &Corners<R>) -> Self {
        let (e, f) = (minus(*b, *a), minus(*c, *a));
        let n = cross(e, f);
        let axes = axes_of(n);
        let [x, y, z] = axes;
        let over = |row: Vector<R>| row.map(|number| number / n[z]);
        let rows = [
            over([f[y], -f[x], f[x] * a[y] - f[y] * a[x]]),
            over([-e[y], e[x], e[y] * a[x] - e[x] * a[y]]),
            over([n[x], n[y], -dot(n, *a)]),
        ];
        Self { axes, rows }
    }
}

/// A ray against a triangle's map: the height gives `t`, and the other two
/// rows the weights there.
///
/// Source: as [`Affine`].
#[inline(never)]
pub fn baldwin_weber<R: Real>(map: &Affine<R>, ray: &Ray<R>, range: Range<R>) -> Option<R> {
    let [x, y, z] = map.axes;
    let [beta, gamma, height] = &map.rows;
    let Ray { origin: o, direction: d } = ray;
    let rise = height[0] * d[x] + height[1] * d[y] + d[z];
    let t = -(height[0] * o[x] + height[1] * o[y] + o[z] + height[2]) / rise;
    if !range.contains(t) {
        return None;
    }
    let (px, py) = (o[x] + t * d[x], o[y] + t * d[y]);
    let beta = beta[0] * px + beta[1] * py + beta[2];
    let gamma = gamma[0] * px + gamma[1] * py + gamma[2];
    (beta >= R::ZERO && gamma >= R::ZERO && beta + gamma <= R::ONE).then_some(t)
}

/// Corners sheared so that the ray is the z axis, then three edge functions in
/// the plane; where one is zero, all three again in `f64`, where the products
/// are exact. What the method prepares for a ray is made for each test.
///
/// Source: Woop, Benthin, Wald, "Watertight Ray/Triangle Intersection", JCGT
/// 2(1), 2013.
#[inline(never)]
pub fn woop(corners: &Corners<f32>, ray: &Ray<f32>, range: Range<f32>) -> Option<f32> {
    let d = ray.direction;
    let [mut x, mut y, z] = axes_of(d);
    if d[z] < 0.0 {
        // Keeps the winding.
        std::mem::swap(&mut x, &mut y);
    }
    let (sx, sy, sz) = (d[x] / d[z], d[y] / d[z], 1.0 / d[z]);
    let [a, b, c] = corners.map(|corner| {
        let p = minus(corner, ray.origin);
        [p[x] - sx * p[z], p[y] - sy * p[z], p[z]]
    });
    let edge = |p: Vector<f32>, q: Vector<f32>| p[0] * q[1] - p[1] * q[0];
    let (mut u, mut v, mut w) = (edge(c, b), edge(a, c), edge(b, a));
    if u == 0.0 || v == 0.0 || w == 0.0 {
        let edge = |p: Vector<f32>, q: Vector<f32>| {
            let ([px, py, _], [qx, qy, _]) = (p.map(f64::from), q.map(f64::from));
            (px * qy - py * qx) as f32
        };
        (u, v, w) = (edge(c, b), edge(a, c), edge(b, a));
    }
    let inside = (u >= 0.0 && v >= 0.0 && w >= 0.0) || (u <= 0.0 && v <= 0.0 && w <= 0.0);
    let det = u + v + w;
    if !(inside && det != 0.0) {
        return None;
    }
    let t = (u * (sz * a[2]) + v * (sz * b[2]) + w * (sz * c[2])) * (1.0 / det);
    range.contains(t).then_some(t)
}

/// Three volumes for the edges and the plane for `t`, with about 32 digits;
/// `t` is rounded once, at the end.
///
/// Source: the volumes of the ray with each edge, as in Segura and Feito,
/// "Algorithms to test ray-triangle intersection: comparative study", WSCG
/// 2001; the arithmetic is [`Dd`]'s.
#[inline(never)]
pub fn double_double(corners: &Corners<f64>, ray: &Ray<f64>, range: Range<f64>) -> Option<f64> {
    let d = V3::<Dd>::of(ray.direction.into());
    let [a, b, c] = corners.map(|p| V3::<Dd>::difference(p.into(), ray.origin.into()));
    let (u, v, w) = (d.dot(&c.cross(&b)), d.dot(&a.cross(&c)), d.dot(&b.cross(&a)));
    let zero = Dd::zero();
    let inside = (u >= zero && v >= zero && w >= zero) || (u <= zero && v <= zero && w <= zero);
    if !inside {
        return None;
    }
    let [p, q, r] = corners.map(Into::into);
    let n = V3::difference(q, p).cross(&V3::difference(r, p));
    let t = (n.dot(&a) / n.dot(&d)).to_f64();
    range.contains(t).then_some(t)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// All kernels in both precisions and windings, for the triangle
    /// (0, 0, 0), (4, 0, 0), (0, 2, 0).
    #[track_caller]
    fn check(origin: [f64; 3], direction: [f64; 3], expected: Option<f64>) {
        let narrow = |v: [f64; 3]| v.map(|x| x as f32);
        let ray = Ray { origin, direction };
        let ray32 = Ray { origin: narrow(origin), direction: narrow(direction) };
        let [a, b, c] = [[0.0; 3], [4.0, 0.0, 0.0], [0.0, 2.0, 0.0]];
        // Turned as well, so that each axis is the longest of the normal.
        for turn in 0..3 {
            let turned = |v: [f64; 3]| std::array::from_fn(|k| v[(k + turn) % 3]);
            let ray = Ray { origin: turned(ray.origin), direction: turned(ray.direction) };
            let ray32 = Ray {
                origin: std::array::from_fn(|k| ray32.origin[(k + turn) % 3]),
                direction: std::array::from_fn(|k| ray32.direction[(k + turn) % 3]),
            };
            for corners in [[a, b, c], [c, b, a], [b, c, a]] {
                let corners = corners.map(turned);
                let corners32 = corners.map(narrow);
                let ahead = Range::AHEAD;
                let all = [inside_edges, linear_system, moeller_trumbore, double_double]
                    .map(|kernel| kernel(&corners, &ray, ahead));
                assert_eq!(all, [expected; 4]);
                assert_eq!(baldwin_weber(&Affine::new(&corners), &ray, ahead), expected);
                let ahead = Range::AHEAD;
                let all = [inside_edges, linear_system, moeller_trumbore, woop]
                    .map(|kernel| kernel(&corners32, &ray32, ahead).map(f64::from));
                assert_eq!(all, [expected; 4]);
                let single = baldwin_weber(&Affine::new(&corners32), &ray32, ahead);
                assert_eq!(single.map(f64::from), expected);
            }
        }
    }

    #[test]
    fn inside_outside_edges_corners_both_sides_and_no_number() {
        let d = [0.0, 0.0, -2.0];
        check([1.0, 0.5, 8.0], d, Some(4.0));
        check([1.0, 0.5, -8.0], [0.0, 0.0, 2.0], Some(4.0));
        check([1.0, 0.5, -8.0], d, None);
        check([3.0, 1.0, 8.0], d, None);
        check([-0.5, 1.0, 8.0], d, None);
        check([1.0, -0.5, 8.0], d, None);
        check([2.0, 1.0, 8.0], d, Some(4.0));
        check([2.0, 0.0, 8.0], d, Some(4.0));
        check([4.0, 0.0, 8.0], d, Some(4.0));
        check([1.0, 0.5, 8.0], [1.0, 0.0, 0.0], None);
        check([f64::NAN, 0.5, 8.0], d, None);
        check([1.0, 0.5, 8.0], [f64::NAN, 0.0, -1.0], None);
    }
}
