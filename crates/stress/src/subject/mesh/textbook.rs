//! Textbook ray-triangle tests on the triangles around an aimed edge or
//! corner, to show beside the mesh that renders: no accelerator, and no rule
//! for edges.

use tracer::glam::DVec3;
use tracer::lecture::{triangle_inside_edges, triangle_linear_system};
use tracer::{Interval, Ray};

use crate::Kernel;
use crate::meshes::Solid;

/// Whether a triangle is hit ahead of the ray.
pub(super) type Test = fn([DVec3; 3], &Ray) -> bool;

/// The kernels with their tests.
pub(super) const ALL: [(Kernel, Test); 4] = [
    (Kernel::textbook("moeller-trumbore-f32"), |corners, ray| {
        let single = |p: DVec3| p.to_array().map(|x| x as f32);
        moeller_trumbore_f32(corners.map(single), single(ray.origin), single(ray.direction))
    }),
    (Kernel::textbook("moeller-trumbore-f64"), |corners, ray| {
        let corners = corners.map(|p| p.to_array());
        moeller_trumbore_f64(corners, ray.origin.to_array(), ray.direction.to_array())
    }),
    (Kernel::textbook("inside-edges-f64"), |corners, ray| {
        triangle_inside_edges(corners, ray, Interval::AHEAD).is_some()
    }),
    (Kernel::textbook("linear-system-f64"), |corners, ray| {
        triangle_linear_system(corners, ray, Interval::AHEAD).is_some()
    }),
];

/// Makes the test in one precision.
///
/// Source: Moeller, Trumbore, "Fast, Minimum Storage Ray/Triangle
/// Intersection", 1997, without the paper's absolute tolerance.
macro_rules! moeller_trumbore {
    ($name:ident, $float:ty) => {
        fn $name([a, b, c]: [[$float; 3]; 3], p: [$float; 3], d: [$float; 3]) -> bool {
            type V = [$float; 3];
            let minus = |a: V, b: V| -> V { [a[0] - b[0], a[1] - b[1], a[2] - b[2]] };
            let dot = |a: V, b: V| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
            let cross = |a: V, b: V| -> V {
                [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
            };
            let (e, f) = (minus(b, a), minus(c, a));
            let across = cross(d, f);
            let inverse = 1.0 / dot(e, across);
            let from_a = minus(p, a);
            let u = dot(from_a, across) * inverse;
            let turned = cross(from_a, e);
            let v = dot(d, turned) * inverse;
            let t = dot(f, turned) * inverse;
            u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t > 0.0 && t < <$float>::INFINITY
        }
    };
}

moeller_trumbore!(moeller_trumbore_f32, f32);
moeller_trumbore!(moeller_trumbore_f64, f64);

/// How many of these triangles the test hits; if it is none, 1 if it hits any
/// other triangle of the solid, as rounding may have moved the ray to one.
pub(super) fn hits(solid: &Solid, near: &[u32], ray: &Ray, test: Test) -> usize {
    let hit = |face: usize| test(solid.corners(face), ray);
    match near.iter().filter(|&&face| hit(face as usize)).count() {
        0 => usize::from((0..solid.faces.len()).any(hit)),
        some => some,
    }
}
