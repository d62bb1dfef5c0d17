//! The lecture's sphere and triangle formulas in `f32`: what goldray would
//! lose if it computed as most renderers do.
//!
//! The case's numbers are rounded to `f32` first, which changes nothing where
//! they are `f32` already.

use crate::Case;

type V = [f32; 3];

fn number(case: &Case, i: usize) -> f32 {
    case.number(i) as f32
}

fn point(case: &Case, i: usize) -> V {
    [number(case, i), number(case, i + 1), number(case, i + 2)]
}

fn sub(a: V, b: V) -> V {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn dot(a: V, b: V) -> f32 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: V, b: V) -> V {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn is_ahead(t: f32) -> bool {
    0.0 < t && t < f32::INFINITY
}

fn first_ahead(roots: [f32; 2]) -> Option<f64> {
    roots.into_iter().find(|&t| is_ahead(t)).map(f64::from)
}

/// A sphere of a center, a radius and a ray by the quadratic formula.
///
/// Source: [`tracer::lecture::sphere_algebraic`].
pub fn sphere_algebraic(case: &Case) -> Option<f64> {
    let (p, d, r) = (sub(point(case, 4), point(case, 0)), point(case, 7), number(case, 3));
    let discriminant = dot(d, p) * dot(d, p) - dot(d, d) * (dot(p, p) - r * r);
    let root = discriminant.sqrt();
    first_ahead([(-dot(d, p) - root) / dot(d, d), (-dot(d, p) + root) / dot(d, d)])
}

/// A sphere by the closest approach and half the chord.
///
/// Source: [`tracer::lecture::sphere_geometric`].
pub fn sphere_geometric(case: &Case) -> Option<f64> {
    let (p, d, r) = (sub(point(case, 4), point(case, 0)), point(case, 7), number(case, 3));
    let length = dot(d, d).sqrt();
    let d = d.map(|x| x / length);
    let t_m = -dot(d, p);
    let half_chord = (r * r - (dot(p, p) - t_m * t_m)).sqrt();
    first_ahead([(t_m - half_chord) / length, (t_m + half_chord) / length])
}

/// A triangle of three corners and a ray by the plane and three half spaces.
///
/// Source: [`tracer::lecture::triangle_inside_edges`].
pub fn triangle_inside_edges(case: &Case) -> Option<f64> {
    let [a, b, c] = [0, 3, 6].map(|i| point(case, i));
    let (p, d) = (point(case, 9), point(case, 12));
    let n = cross(sub(b, a), sub(c, a));
    let t = dot(sub(a, p), n) / dot(d, n);
    let x = [p[0] + t * d[0], p[1] + t * d[1], p[2] + t * d[2]];
    let is_inside = |from: V, to: V| dot(cross(sub(to, from), sub(x, from)), n) >= 0.0;
    let inside = is_inside(a, b) && is_inside(b, c) && is_inside(c, a);
    (is_ahead(t) && inside).then_some(f64::from(t))
}

/// A triangle by Cramer's rule.
///
/// Source: [`tracer::lecture::triangle_linear_system`].
pub fn triangle_linear_system(case: &Case) -> Option<f64> {
    let [v_a, v_b, v_c] = [0, 3, 6].map(|i| point(case, i));
    let [a, b, c] = sub(v_a, v_b);
    let [d, e, f] = sub(v_a, v_c);
    let [g, h, i] = point(case, 12);
    let [j, k, l] = sub(v_a, point(case, 9));
    let m = a * (e * i - h * f) + b * (g * f - d * i) + c * (d * h - e * g);
    let t = -(f * (a * k - j * b) + e * (j * c - a * l) + d * (b * l - k * c)) / m;
    let gamma = (i * (a * k - j * b) + h * (j * c - a * l) + g * (b * l - k * c)) / m;
    let beta = (j * (e * i - h * f) + k * (g * f - d * i) + l * (d * h - e * g)) / m;
    let hit = is_ahead(t) && gamma >= 0.0 && beta >= 0.0 && beta + gamma <= 1.0;
    hit.then_some(f64::from(t))
}
