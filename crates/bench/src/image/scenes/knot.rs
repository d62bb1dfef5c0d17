//! A tube along a torus knot.

use tracer::glam::DVec3;

use super::Triangles;

/// Cuts along the knot and around the tube.
const ALONG: u32 = 1_024;
const AROUND: u32 = 24;
/// How often the knot goes around the axis, and through the hole.
const TURNS: (f64, f64) = (2.0, 3.0);
/// The tube's radius, and how far the knot goes up, down, in and out.
const TUBE: f64 = 0.32;
const SWING: f64 = 0.45;
/// The angle that a difference is taken over for a tangent.
const STEP: f64 = 1e-4;

/// 49152 triangles, counter-clockwise from outside.
pub(super) fn knot() -> Triangles {
    let turn = |i: u32, n: u32| std::f64::consts::TAU * f64::from(i) / f64::from(n);
    let knot = |angle: f64| {
        let (s, c) = libm::sincos(TURNS.0 * angle);
        let (height, swing) = libm::sincos(TURNS.1 * angle);
        let r = 1.0 + SWING * swing;
        DVec3::new(r * c, SWING * height, r * s)
    };
    let mut triangles = Triangles::default();
    for i in 0..ALONG {
        let angle = turn(i, ALONG);
        let center = knot(angle);
        let tangent = (knot(angle + STEP) - knot(angle - STEP)).normalize();
        let (s, c) = libm::sincos(TURNS.0 * angle);
        // Away from the circle that the knot winds around: never along it.
        let side = (center - DVec3::new(c, 0.0, s)).reject_from(tangent).normalize();
        let up = tangent.cross(side);
        for j in 0..AROUND {
            let (s, c) = libm::sincos(turn(j, AROUND));
            let normal = c * side + s * up;
            triangles.vertices.push((center + TUBE * normal).as_vec3().to_array());
            triangles.normals.push(normal.as_vec3().to_array());
        }
    }
    let vertex = |i: u32, j: u32| i % ALONG * AROUND + j % AROUND;
    for (i, j) in (0..ALONG).flat_map(|i| (0..AROUND).map(move |j| (i, j))) {
        let [a, b, c, d] = [vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)];
        triangles.faces.extend([[a, c, b], [a, d, c]]);
    }
    triangles
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn triangles_look_where_their_normals_do() {
        let Triangles { vertices, normals, faces } = knot();
        assert_eq!(faces.len(), 49_152);
        for face in faces {
            let point = |i: usize| DVec3::from(vertices[face[i] as usize].map(f64::from));
            let across = (point(1) - point(0)).cross(point(2) - point(0)).normalize();
            let normal = DVec3::from(normals[face[0] as usize].map(f64::from));
            assert!(across.dot(normal) > 0.9, "{face:?}");
        }
    }
}
