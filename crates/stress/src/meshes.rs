//! `Solid`: closed meshes to shoot at from inside, with exact predicates that
//! say what a ray from inside must find.
//!
//! Every solid is made of indexed corners, so that its triangles share edges
//! and corners to the bit, and is closed whatever moving and rounding its
//! corners does to their places.

use std::cmp::Ordering;
use std::collections::{BTreeMap, BTreeSet};
use std::f64::consts::{PI, TAU};

use tracer::glam::DVec3;

use crate::Random;
use crate::number::{Big, Dd, Number, V3};
use crate::random::f32_point;

/// A closed mesh, its triangles counter-clockwise seen from outside.
#[derive(Debug, Clone, PartialEq)]
pub struct Solid {
    /// The corners.
    pub vertices: Vec<DVec3>,
    /// For each triangle, the indices of its corners.
    pub faces: Vec<[u32; 3]>,
    /// Axis-aligned cubes inside it that rays start from: middle and half the
    /// width, a power of two before it is moved.
    pub starts: Vec<(DVec3, f64)>,
}

/// How a solid is placed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Place {
    /// What its coordinates are multiplied with, first.
    pub scale: f64,
    /// What is added to them.
    pub offset: DVec3,
    /// Whether its corners are rounded to `f32` at their place.
    pub single: bool,
}

impl Solid {
    /// A sphere of 16 rings by 16 slices with a radius between 0.9 and 1.1 at
    /// each corner, as in pbrt-v4's watertightness test.
    pub fn noisy_sphere() -> Self {
        let mut random = Random::of_chunk(0, "noisy sphere", 0);
        ball(16, 16, 1.0 / 16.0, || random.between(0.9, 1.1))
    }

    /// A sphere of 100 rings by 200 slices.
    pub fn fine_sphere() -> Self {
        ball(100, 200, 0.25, || 1.0)
    }

    /// A sphere of 8 rings by 2,000 slices: at its poles the triangles are
    /// needles of 1 to 300, and 2,000 of them meet in one corner.
    pub fn needle_poles() -> Self {
        ball(8, 2_000, 0.25, || 1.0)
    }

    /// A cube from -4 to 4 whose faces are 8 by 8 squares of whole
    /// coordinates, each cut along one of its diagonals.
    pub fn lattice_cube() -> Self {
        /// Half of its width.
        const HALF: i32 = 4;
        let mut corners = Corners::default();
        let mut faces = Vec::new();
        for axis in 0..3 {
            for side in [-HALF, HALF] {
                for i in -HALF..HALF {
                    for j in -HALF..HALF {
                        let mut at = |di: i32, dj: i32| {
                            let mut p = [side; 3];
                            p[(axis + 1) % 3] = i + di;
                            p[(axis + 2) % 3] = j + dj;
                            corners.index(p)
                        };
                        let (p, q, r, s) = (at(0, 0), at(1, 0), at(1, 1), at(0, 1));
                        let cut = if (i + j) % 2 == 0 {
                            [[p, q, r], [p, r, s]]
                        } else {
                            [[p, q, s], [q, r, s]]
                        };
                        faces.extend(
                            cut.map(|[a, b, c]| if side > 0 { [a, b, c] } else { [a, c, b] }),
                        );
                    }
                }
            }
        }
        let vertices = corners.all.iter().map(|p| DVec3::from_array(p.map(f64::from))).collect();
        Self { vertices, faces, starts: vec![(DVec3::ZERO, 2.0)] }
    }

    /// An icosahedron whose triangles are cut in four `levels` times, with
    /// all corners on the unit sphere.
    pub fn icosphere(levels: u32) -> Self {
        let long = 0.5 * (1.0 + 5.0_f64.sqrt());
        let mut vertices = Vec::new();
        for k in 0..3 {
            for (a, b) in [(1.0, long), (-1.0, long), (1.0, -long), (-1.0, -long)] {
                let mut p = DVec3::ZERO;
                (p[k], p[(k + 1) % 3]) = (a, b);
                vertices.push(p.normalize());
            }
        }
        // The edges of an icosahedron are its shortest distances.
        let near = |i: usize, j: usize| i != j && vertices[i].dot(vertices[j]) > 0.4;
        let mut faces = Vec::new();
        for i in 0..12 {
            for j in i + 1..12 {
                for k in j + 1..12 {
                    if near(i, j) && near(j, k) && near(k, i) {
                        let outward = vertices[i].cross(vertices[j]).dot(vertices[k]) > 0.0;
                        let (j, k) = if outward { (j, k) } else { (k, j) };
                        faces.push([i as u32, j as u32, k as u32]);
                    }
                }
            }
        }
        for _ in 0..levels {
            let mut middles = BTreeMap::new();
            let mut middle = |i: u32, j: u32| {
                *middles.entry((i.min(j), i.max(j))).or_insert_with(|| {
                    let sum = vertices[i as usize] + vertices[j as usize];
                    vertices.push(sum.normalize());
                    (vertices.len() - 1) as u32
                })
            };
            let mut finer = Vec::with_capacity(4 * faces.len());
            for [a, b, c] in faces {
                let (ab, bc, ca) = (middle(a, b), middle(b, c), middle(c, a));
                finer.extend([[a, ab, ca], [b, bc, ab], [c, ca, bc], [ab, bc, ca]]);
            }
            faces = finer;
        }
        Self { vertices, faces, starts: vec![(DVec3::ZERO, 0.25)] }
    }

    /// A torus of radii 1 and 0.35, 24 by 16: of genus 1 and with a middle
    /// that sees no side of it whole, so that a ray from inside may cross it
    /// any odd number of times.
    pub fn torus() -> Self {
        const RINGS: u32 = 24;
        const SLICES: u32 = 16;
        const TUBE: f64 = 0.35;
        let mut vertices = Vec::new();
        let mut faces = Vec::new();
        for ring in 0..RINGS {
            let (sin, cos) = libm::sincos(TAU * f64::from(ring) / f64::from(RINGS));
            for slice in 0..SLICES {
                let (up, out) = libm::sincos(TAU * f64::from(slice) / f64::from(SLICES));
                let from_axis = 1.0 + TUBE * out;
                vertices.push(DVec3::new(from_axis * cos, from_axis * sin, TUBE * up));
                let at = |i: u32, j: u32| (ring + i) % RINGS * SLICES + (slice + j) % SLICES;
                let (p, q, r, s) = (at(0, 0), at(1, 0), at(1, 1), at(0, 1));
                faces.extend([[p, q, r], [p, r, s]]);
            }
        }
        let middles = [DVec3::X, DVec3::Y, -DVec3::X, -DVec3::Y];
        Self { vertices, faces, starts: middles.map(|middle| (middle, 1.0 / 16.0)).to_vec() }
    }

    /// The solid at its place.
    #[must_use]
    pub fn placed(&self, place: Place) -> Self {
        let map = |p: DVec3| place.offset + place.scale * p;
        let round = |p: DVec3| if place.single { f32_point(p) } else { p };
        Self {
            // The solid itself is of `f32` numbers, wherever it goes.
            vertices: self.vertices.iter().map(|&p| round(map(f32_point(p)))).collect(),
            faces: self.faces.clone(),
            starts: self.starts.iter().map(|&(p, half)| (map(p), place.scale * half)).collect(),
        }
    }

    /// The corners of a triangle.
    pub fn corners(&self, face: usize) -> [DVec3; 3] {
        self.faces[face].map(|i| self.vertices[i as usize])
    }

    /// For each corner, the triangles around it.
    pub fn rings(&self) -> Vec<Vec<u32>> {
        let mut rings = vec![Vec::new(); self.vertices.len()];
        for (face, corners) in self.faces.iter().enumerate() {
            for &corner in corners {
                rings[corner as usize].push(face as u32);
            }
        }
        rings
    }

    /// Whether every edge is shared by two triangles that run along it in
    /// opposite directions: then a line crosses it an even number of times.
    pub fn is_closed(&self) -> bool {
        let edges = self.faces.iter().flat_map(|&[a, b, c]| [(a, b), (b, c), (c, a)]);
        let mut once = BTreeSet::new();
        edges.clone().all(|edge| once.insert(edge))
            && edges.clone().all(|(a, b)| once.contains(&(b, a)))
    }

    /// Whether every triangle turns its back on every point that rays start
    /// from, exactly: then the directions from there cover the solid evenly,
    /// and if it is a sphere folded nowhere, every ray crosses it once.
    ///
    /// On which side of a plane a point is, is linear in the point: the
    /// corners of a cube speak for all of it.
    pub fn is_star_shaped(&self) -> bool {
        let eyes: Vec<DVec3> = self.starts.iter().flat_map(|&(p, half)| cube(p, half)).collect();
        (0..self.faces.len()).all(|face| {
            let corners = self.corners(face);
            eyes.iter().all(|&eye| turn(eye, corners) == Ordering::Greater)
        })
    }
}

/// The corners of an axis-aligned cube.
fn cube(middle: DVec3, half: f64) -> [DVec3; 8] {
    std::array::from_fn(|i| {
        let sign = |bit: usize| if i >> bit & 1 == 0 { -half } else { half };
        middle + DVec3::new(sign(0), sign(1), sign(2))
    })
}

/// The exact sign of `(a - eye) . ((b - eye) x (c - eye))`: `Greater` where
/// the corners run counter-clockwise seen from beyond the triangle.
pub fn turn(eye: DVec3, corners: [DVec3; 3]) -> Ordering {
    /// Far above the error of the volume in [`Dd`], a few hundred 2^-106 of
    /// its largest product.
    const DECIDED: f64 = 1e-28;
    let volume = |[a, b, c]: [V3<Dd>; 3]| a.dot(&b.cross(&c)).to_f64();
    let fast = volume(corners.map(|p| V3::difference(p, eye)));
    let lengths = corners.map(|p| (p - eye).length());
    if fast.abs() > DECIDED * (lengths[0] * lengths[1] * lengths[2]) {
        return fast.total_cmp(&0.0);
    }
    let [a, b, c] = corners.map(|p| V3::<Big>::difference(p, eye));
    a.dot(&b.cross(&c)).sign()
}

/// Corners of whole coordinates, each once.
#[derive(Default)]
struct Corners {
    all: Vec<[i32; 3]>,
    index: BTreeMap<[i32; 3], u32>,
}

impl Corners {
    fn index(&mut self, p: [i32; 3]) -> u32 {
        *self.index.entry(p).or_insert_with(|| {
            self.all.push(p);
            (self.all.len() - 1) as u32
        })
    }
}

/// A ball of `rings` by `slices` with one corner at each pole.
fn ball(rings: u32, slices: u32, start: f64, mut radius: impl FnMut() -> f64) -> Solid {
    let mut vertices = vec![DVec3::Z * radius(), -DVec3::Z * radius()];
    for ring in 1..rings {
        let (sin, cos) = libm::sincos(PI * f64::from(ring) / f64::from(rings));
        for slice in 0..slices {
            let (y, x) = libm::sincos(TAU * f64::from(slice) / f64::from(slices));
            vertices.push(radius() * DVec3::new(sin * x, sin * y, cos));
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
            // At a pole two corners are one, and one triangle is none.
            let halves = [[a, c, d], [a, d, b]];
            faces.extend(halves.into_iter().filter(|[p, q, r]| p != q && q != r && r != p));
        }
    }
    Solid { vertices, faces, starts: vec![(DVec3::ZERO, start)] }
}

#[cfg(test)]
mod tests {
    use super::*;

    const HERE: Place = Place { scale: 1.0, offset: DVec3::ZERO, single: true };

    #[test]
    fn every_solid_is_closed_and_all_but_the_torus_are_seen_whole_from_inside() {
        let spheres = [
            Solid::noisy_sphere(),
            Solid::fine_sphere(),
            Solid::needle_poles(),
            Solid::lattice_cube(),
            Solid::icosphere(3),
        ];
        for solid in &spheres {
            assert!(solid.is_closed());
            assert!(solid.placed(HERE).is_star_shaped(), "{} faces", solid.faces.len());
            // Spheres by Euler's formula: vertices - edges + faces = 2.
            assert_eq!(2 * solid.vertices.len(), solid.faces.len() + 4);
        }
        let torus = Solid::torus();
        assert!(torus.is_closed() && !torus.placed(HERE).is_star_shaped());
        assert_eq!(2 * torus.vertices.len(), torus.faces.len());
    }

    #[test]
    fn rounding_far_away_folds_what_is_small() {
        // A unit of f32 at 2e5 is a 64th.
        let offset = DVec3::new(148_376.0, 1234.0, -223_423.0);
        let far = |single| Place { scale: 1.0, offset, single };
        assert!(!Solid::fine_sphere().placed(far(true)).is_star_shaped());
        assert!(Solid::fine_sphere().placed(far(false)).is_star_shaped());
    }

    #[test]
    fn a_point_in_the_plane_is_told_from_one_beside_it() {
        let corners = [DVec3::X, DVec3::Y, DVec3::Z];
        let eye = DVec3::splat(1.0 / 3.0);
        // A third is rounded down, and so below the plane x + y + z = 1.
        assert_eq!(turn(eye, corners), Ordering::Greater);
        assert_eq!(turn(DVec3::new(0.5, 0.25, 0.25), corners), Ordering::Equal);
        assert_eq!(turn(DVec3::new(0.5, 0.25, 0.25_f64.next_up()), corners), Ordering::Less);
    }
}
