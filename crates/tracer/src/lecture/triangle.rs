//! Ray-triangle intersection by the lecture's two methods: the plane and three
//! inside-edge tests, and a linear system.

use glam::DVec3;

use crate::{Interval, Ray};

/// First the plane, then three half spaces.
///
/// 1. The point is on the ray, `r(t) = p + t d`, and on the plane,
///    `(x - a).n = 0`, so `t = (a - p).n / d.n`.
/// 2. It is inside all three edges: with the corners counter-clockwise about
///    `n`, the vector of each edge crossed with the vector to `x` points along
///    `n`. Edges and corners count as inside.
///
/// Two triangles that share an edge round this test differently, so rays aimed
/// at the edge can pass between them. Products of four coordinates overflow
/// and underflow early. A triangle without an area is never hit.
///
/// Source: slides "Ray-triangle intersection" and "Inside-edge test".
pub fn triangle_inside_edges([a, b, c]: [DVec3; 3], ray: &Ray, range: Interval) -> Option<f64> {
    let n = (b - a).cross(c - a);
    let t = (a - ray.origin).dot(n) / ray.direction.dot(n);
    if !range.contains(t) {
        return None;
    }
    let x = ray.at(t);
    let inside = (b - a).cross(x - a).dot(n) >= 0.0
        && (c - b).cross(x - b).dot(n) >= 0.0
        && (a - c).cross(x - c).dot(n) >= 0.0;
    inside.then_some(t)
}

/// Solves `a + beta (b - a) + gamma (c - a) = p + t d` for `beta`, `gamma` and
/// `t` by Cramer's rule; a hit has `beta >= 0`, `gamma >= 0` and
/// `beta + gamma <= 1`.
///
/// Returns `(t, beta, gamma)`. The letters `A` to `L` and `M` are the book's.
///
/// Source: slide "Ray-triangle intersection" ("a more efficient method based
/// on linear systems"), which points to Shirley and Marschner, "Fundamentals
/// of Computer Graphics", 3rd edition, section 4.4.2.
pub fn triangle_linear_system(
    [v_a, v_b, v_c]: [DVec3; 3],
    ray: &Ray,
    range: Interval,
) -> Option<(f64, f64, f64)> {
    let [a, b, c] = (v_a - v_b).to_array();
    let [d, e, f] = (v_a - v_c).to_array();
    let [g, h, i] = ray.direction.to_array();
    let [j, k, l] = (v_a - ray.origin).to_array();
    let m = a * (e * i - h * f) + b * (g * f - d * i) + c * (d * h - e * g);
    let t = -(f * (a * k - j * b) + e * (j * c - a * l) + d * (b * l - k * c)) / m;
    let gamma = (i * (a * k - j * b) + h * (j * c - a * l) + g * (b * l - k * c)) / m;
    let beta = (j * (e * i - h * f) + k * (g * f - d * i) + l * (d * h - e * g)) / m;
    let hit = range.contains(t) && gamma >= 0.0 && beta >= 0.0 && beta + gamma <= 1.0;
    hit.then_some((t, beta, gamma))
}

#[cfg(test)]
mod tests {
    use glam::dvec3;

    use super::*;

    const CORNERS: [DVec3; 3] = [dvec3(0.0, 0.0, 0.0), dvec3(4.0, 0.0, 0.0), dvec3(0.0, 2.0, 0.0)];

    /// Both methods, both windings, one expected `t`.
    #[track_caller]
    fn check(p: [f64; 3], d: [f64; 3], range: Interval, expected: Option<f64>) {
        let ray = Ray::new(DVec3::from_array(p), DVec3::from_array(d));
        let [a, b, c] = CORNERS;
        for corners in [[a, b, c], [a, c, b], [c, a, b]] {
            assert_eq!(triangle_inside_edges(corners, &ray, range), expected, "inside edges");
            let system = triangle_linear_system(corners, &ray, range).map(|(t, ..)| t);
            assert_eq!(system, expected, "linear system");
        }
    }

    #[test]
    fn inside_outside_edges_and_corners() {
        let d = [0.0, 0.0, -2.0];
        let ahead = Interval::AHEAD;
        check([1.0, 0.5, 8.0], d, ahead, Some(4.0));
        check([1.0, 0.5, -8.0], [0.0, 0.0, 2.0], ahead, Some(4.0));
        check([3.0, 1.0, 8.0], d, ahead, None);
        check([-0.5, 1.0, 8.0], d, ahead, None);
        check([1.0, -0.5, 8.0], d, ahead, None);
        check([2.0, 1.0, 8.0], d, ahead, Some(4.0));
        check([2.0, 0.0, 8.0], d, ahead, Some(4.0));
        check([0.0, 0.0, 8.0], d, ahead, Some(4.0));
        check([4.0, 0.0, 8.0], d, ahead, Some(4.0));
    }

    #[test]
    fn behind_out_of_range_and_parallel() {
        let d = [0.0, 0.0, -2.0];
        check([1.0, 0.5, -8.0], d, Interval::AHEAD, None);
        check([1.0, 0.5, 8.0], d, Interval::new(0.0, 4.0), None);
        check([1.0, 0.5, 8.0], d, Interval::new(4.0, 9.0), None);
        check([1.0, 0.5, 8.0], [1.0, 0.0, 0.0], Interval::AHEAD, None);
        check([-1.0, 0.5, 0.0], [1.0, 0.0, 0.0], Interval::AHEAD, None);
    }

    #[test]
    fn the_system_also_gives_the_weights_of_the_corners() {
        let ray = Ray::new(dvec3(1.0, 0.5, 3.0), dvec3(0.0, 0.0, -1.0));
        let hit = triangle_linear_system(CORNERS, &ray, Interval::AHEAD);
        assert_eq!(hit, Some((3.0, 0.25, 0.25)));
    }

    #[test]
    fn a_triangle_without_an_area_is_never_hit() {
        let line = [dvec3(0.0, 0.0, 0.0), dvec3(1.0, 0.0, 0.0), dvec3(2.0, 0.0, 0.0)];
        let ray = Ray::new(dvec3(0.5, 0.0, 3.0), dvec3(0.0, 0.0, -1.0));
        assert_eq!(triangle_inside_edges(line, &ray, Interval::AHEAD), None);
        assert_eq!(triangle_linear_system(line, &ray, Interval::AHEAD), None);
    }
}
