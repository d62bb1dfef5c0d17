//! A closed mesh and rays from inside at its seams: every one of them hits.

use tracer::glam::DVec3;

use crate::random::{f32_of, f32_point};
use crate::{Case, Random};

/// Rings of vertices between the poles, and vertices to a ring.
const RINGS: usize = 15;
const AROUND: usize = 16;

/// How far the surface goes in and out, as a share of the radius.
const BUMPS: f64 = 0.2;

/// A closed mesh.
pub(super) struct Mesh {
    vertices: Vec<DVec3>,
    faces: Vec<[usize; 3]>,
}

/// A ray at a vertex or an edge.
pub(super) struct Aimed {
    origin: DVec3,
    direction: DVec3,
    /// One or two vertices that it is aimed at or between.
    at: [usize; 2],
}

impl Mesh {
    /// A sphere of parallels and meridians with random bumps, its corners of
    /// `f32`; every point of it is seen from the center.
    pub(super) fn new() -> Self {
        let mut random = Random::of_chunk(0, "bench/mesh", 0);
        let mut bump = |way: DVec3| f32_point(way * random.between(1.0 - BUMPS, 1.0 + BUMPS));
        let mut vertices = vec![bump(DVec3::Z), bump(DVec3::NEG_Z)];
        for ring in 0..RINGS {
            let polar = std::f64::consts::PI * (ring + 1) as f64 / (RINGS + 1) as f64;
            for k in 0..AROUND {
                let (sin, cos) = libm::sincos(std::f64::consts::TAU * k as f64 / AROUND as f64);
                let (sine, cosine) = libm::sincos(polar);
                vertices.push(bump(DVec3::new(sine * cos, sine * sin, cosine)));
            }
        }
        let at = |ring: usize, k: usize| 2 + ring * AROUND + k % AROUND;
        let mut faces = Vec::new();
        for k in 0..AROUND {
            faces.push([0, at(0, k), at(0, k + 1)]);
            faces.push([1, at(RINGS - 1, k + 1), at(RINGS - 1, k)]);
            for ring in 1..RINGS {
                let [a, b] = [at(ring - 1, k), at(ring - 1, k + 1)];
                let [c, d] = [at(ring, k), at(ring, k + 1)];
                faces.extend([[a, c, d], [a, d, b]]);
            }
        }
        Self { vertices, faces }
    }

    /// A ray from about the center at a vertex, a point of an edge, or one
    /// that divides an edge into quarters.
    pub(super) fn aim(&self, random: &mut Random) -> Aimed {
        /// One ray of this many starts at the center itself, where whole
        /// products vanish.
        const FROM_CENTER: usize = 4;
        /// How far from the center the others start.
        const APART: f64 = 0.2;
        let face = self.faces[random.below(self.faces.len())];
        let corner = random.below(3);
        let (p, q) = (face[corner], face[(corner + 1) % 3]);
        let share = match random.below(3) {
            0 => 0.0,
            1 => random.unit(),
            _ => f32_of(0.25 * (1 + random.below(3)) as f64),
        };
        let target = self.vertices[p] * (1.0 - share) + self.vertices[q] * share;
        let origin = if random.below(FROM_CENTER) == 0 {
            DVec3::ZERO
        } else {
            f32_point(random.point() * APART)
        };
        let direction = f32_point(target - origin);
        Aimed { origin, direction, at: [p, if share == 0.0 { p } else { q }] }
    }

    /// The ray against the triangles that have all that it is aimed at.
    pub(super) fn around<'a>(&'a self, ray: &'a Aimed) -> impl Iterator<Item = Case> + 'a {
        let meets = |face: &&[usize; 3]| ray.at.iter().all(|corner| face.contains(corner));
        self.faces.iter().filter(meets).map(|face| self.case(*face, ray))
    }

    /// The ray against every triangle.
    pub(super) fn everywhere<'a>(&'a self, ray: &'a Aimed) -> impl Iterator<Item = Case> + 'a {
        self.faces.iter().map(|face| self.case(*face, ray))
    }

    fn case(&self, face: [usize; 3], ray: &Aimed) -> Case {
        let corners = face.map(|corner| self.vertices[corner]);
        let case = corners.into_iter().fold(Case::EMPTY, Case::with_point);
        case.with_point(ray.origin).with_point(ray.direction)
    }
}
