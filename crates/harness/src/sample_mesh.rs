//! The meshes that the fixtures use, made by code: a knotted tube and a ball.

use std::collections::BTreeMap;
use std::fmt::Write;

use tracer::glam::{DVec2, DVec3};

/// The files and their bytes, by path relative to the suite.
pub fn sample_meshes() -> Vec<(&'static str, Vec<u8>)> {
    vec![
        ("fixtures/mesh/assets/torus-knot.ply", torus_knot(256, 12)),
        ("fixtures/mesh/assets/icosphere.obj", icosphere(3).into_bytes()),
    ]
}

/// A tube along a (2, 3) torus knot as binary PLY with normals:
/// `2 * along * around` triangles, within 1.75 of the origin.
fn torus_knot(along: u32, around: u32) -> Vec<u8> {
    /// The tube's radius.
    const TUBE: f64 = 0.32;
    let turn = |i: u32, n: u32| std::f64::consts::TAU * f64::from(i % n) / f64::from(n);
    // The knot winds 2 times around the axis and 3 times through the hole.
    let knot = |angle: f64| {
        let (s2, c2) = libm::sincos(2.0 * angle);
        let (s3, c3) = libm::sincos(3.0 * angle);
        let r = 1.0 + 0.45 * c3;
        DVec3::new(r * c2, r * s2, 0.45 * s3)
    };
    let header = format!(
        "ply\nformat binary_little_endian 1.0\ncomment made by cargo xtask meshes\n\
         element vertex {}\nproperty float x\nproperty float y\nproperty float z\n\
         property float nx\nproperty float ny\nproperty float nz\n\
         element face {}\nproperty list uchar int vertex_indices\nend_header\n",
        along * around,
        2 * along * around
    );
    let mut bytes = header.into_bytes();
    for i in 0..along {
        let angle = turn(i, along);
        let center = knot(angle);
        // A frame that never twists off: the tangent, and across it the
        // direction away from the knot's middle circle.
        let step = 1e-4;
        let tangent = (knot(angle + step) - knot(angle - step)).normalize();
        let (s2, c2) = libm::sincos(2.0 * angle);
        let out = center - DVec3::new(c2, s2, 0.0);
        let side = out.reject_from(tangent).normalize();
        let up = tangent.cross(side);
        for j in 0..around {
            let (s, c) = libm::sincos(turn(j, around));
            let normal = c * side + s * up;
            for number in (center + TUBE * normal).to_array().into_iter().chain(normal.to_array()) {
                bytes.extend((number as f32).to_le_bytes());
            }
        }
    }
    let vertex = |i: u32, j: u32| i % along * around + j % around;
    for i in 0..along {
        for j in 0..around {
            let [a, b, c, d] =
                [vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)];
            // Counter-clockwise from outside.
            for corners in [[a, c, b], [a, d, c]] {
                bytes.push(3);
                bytes.extend(corners.iter().flat_map(|corner| corner.to_le_bytes()));
            }
        }
    }
    bytes
}

/// An icosahedron whose triangles are cut in four `times` times and put onto
/// the unit sphere, as OBJ with normals: `20 * 4^times` triangles.
fn icosphere(times: u32) -> String {
    let golden_ratio = f64::midpoint(1.0, 5.0_f64.sqrt());
    let mut vertices: Vec<DVec3> = Vec::new();
    for DVec2 { x, y } in [(-1.0, 1.0), (1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)].map(DVec2::from) {
        let (x, y) = (x, y * golden_ratio);
        vertices.extend([DVec3::new(x, y, 0.0), DVec3::new(0.0, x, y), DVec3::new(y, 0.0, x)]);
    }
    let vertices: Vec<DVec3> = vertices.into_iter().map(DVec3::normalize).collect();
    let (mut vertices, mut faces) = (vertices.clone(), hull_of_icosahedron(&vertices));
    for _ in 0..times {
        let mut middles = BTreeMap::new();
        let mut middle = |a: usize, b: usize| {
            *middles.entry((a.min(b), a.max(b))).or_insert_with(|| {
                vertices.push((vertices[a] + vertices[b]).normalize());
                vertices.len() - 1
            })
        };
        let cut = |[a, b, c]: [usize; 3]| {
            let (ab, bc, ca) = (middle(a, b), middle(b, c), middle(c, a));
            [[a, ab, ca], [b, bc, ab], [c, ca, bc], [ab, bc, ca]]
        };
        faces = faces.into_iter().flat_map(cut).collect();
    }
    let mut text = "# made by cargo xtask meshes\n".to_owned();
    // Writing to a String cannot fail.
    for v in &vertices {
        let _ = writeln!(text, "v {:.7} {:.7} {:.7}", v.x, v.y, v.z);
    }
    for v in &vertices {
        let _ = writeln!(text, "vn {:.7} {:.7} {:.7}", v.x, v.y, v.z);
    }
    for [a, b, c] in faces.into_iter().map(|face| face.map(|i| i + 1)) {
        let _ = writeln!(text, "f {a}//{a} {b}//{b} {c}//{c}");
    }
    text
}

/// All triples of corners that are next to each other, counter-clockwise from
/// outside.
fn hull_of_icosahedron(vertices: &[DVec3]) -> Vec<[usize; 3]> {
    // Neighbors of a unit icosahedron are 1.05 apart, all others 1.7 or more.
    let near = |a: usize, b: usize| vertices[a].distance(vertices[b]) < 1.2;
    let n = vertices.len();
    let mut faces = Vec::new();
    for (a, b, c) in
        (0..n).flat_map(|a| (a + 1..n).flat_map(move |b| (b + 1..n).map(move |c| (a, b, c))))
    {
        if near(a, b) && near(b, c) && near(c, a) {
            let [p, q, r] = [a, b, c].map(|i| vertices[i]);
            let outward = (q - p).cross(r - p).dot(p) > 0.0;
            faces.push(if outward { [a, b, c] } else { [a, c, b] });
        }
    }
    faces
}

#[cfg(test)]
mod tests {
    use tracer::Rgb;

    use super::*;
    use crate::fixture::{Build, Fixture};

    /// Whether every flat face looks the way its corners' normals do.
    fn faces_look_outward(name: &str, bytes: &[u8]) -> bool {
        let text = |flat: bool| {
            format!(
                "(version: 1, image: (24, 24), show: Normals, objects: [Mesh(file: \"{name}\", \
                 flat: {flat})], camera: LookAt(eye: (0, 1, 6), at: (0, 0, 0), fov_deg: 40))"
            )
        };
        let files = BTreeMap::from([(name.to_owned(), bytes.to_vec())]);
        let picture = |flat: bool| {
            let fixture = Fixture::read("mesh", &text(flat), &files, Build::Bvh).unwrap();
            fixture.render_linear()
        };
        let normal = |c: Rgb| DVec3::from_array(c.channels()) * 2.0 - 1.0;
        let (flat, smooth) = (picture(true), picture(false));
        let hit = flat.pixels().iter().zip(smooth.pixels()).filter(|(f, _)| **f != Rgb::BLACK);
        let dots: Vec<_> = hit.map(|(&f, &s)| normal(f).dot(normal(s))).collect();
        assert!(dots.len() > 50, "{} pixels hit", dots.len());
        dots.iter().all(|&dot| dot > 0.7)
    }

    #[test]
    fn triangles_are_counter_clockwise_from_outside() {
        assert!(faces_look_outward("a.ply", &torus_knot(256, 12)));
        assert!(faces_look_outward("a.obj", icosphere(3).as_bytes()));
    }

    #[test]
    fn the_meshes_have_the_promised_triangles() {
        let text = icosphere(3);
        let count = |start: &str| text.lines().filter(|line| line.starts_with(start)).count();
        assert_eq!((count("v "), count("f ")), (642, 1_280));
        let ply = torus_knot(256, 12);
        let header = String::from_utf8_lossy(&ply[..300]);
        assert!(header.contains("element face 6144"), "{header}");
    }
}
