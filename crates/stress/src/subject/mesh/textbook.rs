//! Textbook ray-triangle tests on the triangles around an aimed edge or
//! corner, to show beside the mesh that renders: no accelerator, and no rule
//! for edges.

use tracer::glam::DVec3;
use tracer::lecture::{triangle_inside_edges, triangle_linear_system};
use tracer::{Interval, Ray};

use crate::Kernel;
use crate::kernel::of_case::AtTriangle;
use crate::kernel::{self, Range, Real};
use crate::meshes::Solid;

/// Whether a triangle is hit ahead of the ray.
pub(super) type Test = fn([DVec3; 3], &Ray) -> bool;

/// The kernels with their tests.
pub(super) const ALL: [(Kernel, Test); 4] = [
    (Kernel::textbook("moeller-trumbore-f32"), moeller_trumbore::<f32>),
    (Kernel::textbook("moeller-trumbore-f64"), moeller_trumbore::<f64>),
    (Kernel::textbook("inside-edges-f64"), |corners, ray| {
        triangle_inside_edges(corners, ray, Interval::AHEAD).is_some()
    }),
    (Kernel::textbook("linear-system-f64"), |corners, ray| {
        triangle_linear_system(corners, ray, Interval::AHEAD).is_some()
    }),
];

/// Whether the kernel of this precision hits the triangle.
fn moeller_trumbore<R: Real>(corners: [DVec3; 3], ray: &Ray) -> bool {
    let at = AtTriangle::<R>::of(corners, ray);
    kernel::triangle::moeller_trumbore(&at.corners, &at.ray, Range::AHEAD).is_some()
}

/// How many of these triangles the test hits; if it is none, 1 if it hits any
/// other triangle of the solid, as rounding may have moved the ray to one.
pub(super) fn hits(solid: &Solid, near: &[u32], ray: &Ray, test: Test) -> usize {
    let hit = |face: usize| test(solid.corners(face), ray);
    match near.iter().filter(|&&face| hit(face as usize)).count() {
        0 => usize::from((0..solid.faces.len()).any(hit)),
        some => some,
    }
}
