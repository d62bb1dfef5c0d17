//! Closed meshes have no holes: no ray from inside gets out, however it is
//! aimed.

use tracer::Interval;
use tracer::Ray;
use tracer::accel::Build;
use tracer::glam::{DVec3, dvec3};
use tracer::lecture::triangle_linear_system;
use tracer::shape::{Geometry, Mesh};

/// A closed ball of `rings` by `slices`, whose triangles are needles at the
/// poles when there are many slices.
fn ball(rings: u32, slices: u32) -> (Vec<DVec3>, Vec<[u32; 3]>) {
    let turn = |i: u32, n: u32| std::f64::consts::TAU * f64::from(i) / f64::from(n);
    let mut vertices = vec![DVec3::Z, -DVec3::Z];
    for ring in 1..rings {
        let (sin, cos) = libm::sincos(0.5 * turn(ring, rings));
        for slice in 0..slices {
            let (y, x) = libm::sincos(turn(slice, slices));
            vertices.push(dvec3(sin * x, sin * y, cos));
        }
    }
    let at = |ring: u32, slice: u32| match ring {
        0 => 0,
        ring if ring == rings => 1,
        ring => 2 + (ring - 1) * slices + slice % slices,
    };
    let mut faces = Vec::new();
    for ring in 0..rings {
        for slice in 0..slices {
            let (a, b) = (at(ring, slice), at(ring, slice + 1));
            let (c, d) = (at(ring + 1, slice), at(ring + 1, slice + 1));
            let quad = [[a, c, d], [a, d, b]];
            faces.extend(quad.into_iter().filter(|[p, q, r]| p != q && q != r && r != p));
        }
    }
    (vertices, faces)
}

/// How many of the rays aimed at edges and corners get out, of the tracer and
/// of the lecture's linear system.
fn leaks(rings: u32, slices: u32, rays: u32) -> (u32, u32) {
    let (vertices, faces) = ball(rings, slices);
    let mesh = Mesh::new(vertices.clone(), faces.clone(), None, Build::Bvh);
    let Ok(mesh) = mesh else { return (u32::MAX, 0) };
    let mut rng = fastrand::Rng::with_seed(12);
    let (mut ours, mut textbook) = (0, 0);
    for k in 0..rays {
        let number = |rng: &mut fastrand::Rng| rng.f64() - 0.5;
        let origin = 0.2 * dvec3(number(&mut rng), number(&mut rng), number(&mut rng));
        let face = faces[rng.usize(0..faces.len())].map(|i| vertices[i as usize]);
        // The second corner in one ray of four, else a point of an edge.
        let along = if k % 4 == 0 { 1.0 } else { rng.f64() };
        let target = face[0] + along * (face[1] - face[0]);
        let ray = Ray::new(origin, target - origin);
        ours += u32::from(mesh.intersect(&ray, Interval::AHEAD).is_none());
        // The textbook form is slow without a tree: a sample is enough.
        if k % 100 == 0 {
            let corners = |face: &[u32; 3]| face.map(|i| vertices[i as usize]);
            let hit = |face| triangle_linear_system(corners(face), &ray, Interval::AHEAD);
            textbook += u32::from(!faces.iter().any(|face| hit(face).is_some()));
        }
    }
    (ours, textbook)
}

#[test]
fn no_ray_leaves_a_ball_of_needles() {
    let (ours, textbook) = leaks(8, 2_000, 40_000);
    assert_eq!(ours, 0);
    assert!(textbook > 0, "the rays are not aimed well enough to tell");
}

#[test]
fn no_ray_leaves_a_coarse_ball() {
    assert_eq!(leaks(6, 9, 200_000).0, 0);
}
