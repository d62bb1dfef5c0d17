//! Meshes: identity of the triangle hit, interpolated normals, refusals.

use glam::dvec3;

use super::*;
use crate::accel::{Build, Coherence};

/// The square [0, 2]^2 at z = 0 as two triangles that share a diagonal, and
/// four more out of the way, so that there is a hierarchy.
fn square(normals: Option<MeshNormals>, build: Build) -> Mesh {
    let vertices = vec![
        dvec3(0.0, 0.0, 0.0),
        dvec3(2.0, 0.0, 0.0),
        dvec3(2.0, 2.0, 0.0),
        dvec3(0.0, 2.0, 0.0),
        dvec3(9.0, 9.0, 9.0),
    ];
    let away = [[1, 2, 4]; 4];
    let faces = [[0, 1, 2], [0, 2, 3]].into_iter().chain(away).collect();
    Mesh::new(vertices, faces, normals, build).unwrap()
}

fn down(x: f64, y: f64) -> Ray {
    Ray::new(dvec3(x, y, 3.0), dvec3(0.0, 0.0, -1.0))
}

#[test]
fn says_which_triangle_and_only_one_on_a_shared_edge() {
    for build in [Build::List, Build::Bvh] {
        let mesh = square(None, build);
        let part = |ray| mesh.intersect(&ray, Interval::AHEAD).map(|c| (c.t, c.part));
        assert_eq!(part(down(1.5, 0.5)), Some((3.0, 0)));
        assert_eq!(part(down(0.5, 1.5)), Some((3.0, 1)));
        assert_eq!(part(down(1.0, 1.0)), Some((3.0, 1)), "the shared edge");
        let crossings = |ray| mesh.crossings(&ray, Interval::AHEAD);
        assert_eq!(crossings(down(1.0, 1.0)), 1);
        assert_eq!(crossings(down(-0.1, 1.0)), 0);
        assert_eq!(part(down(-0.1, 1.0)), None);
        assert!(mesh.occludes(&down(1.0, 1.0), Interval::AHEAD));
        assert!(!mesh.occludes(&down(1.0, 1.0), Interval::new(0.0, 3.0)));
    }
}

#[test]
fn a_closed_mesh_is_crossed_once_from_inside_through_every_edge_and_corner() {
    // The octahedron, and rays from its middle through the corners, the
    // middles of the edges and the middles of the faces.
    let corners = [DVec3::X, DVec3::Y, DVec3::Z, -DVec3::X, -DVec3::Y, -DVec3::Z];
    let faces = (0..8_u32).map(|k| [k & 1, k >> 1 & 1, k >> 2].map(|bit| 3 * bit));
    let faces: Vec<_> = faces.map(|[x, y, z]| [x, y + 1, z + 2]).collect();
    for build in [Build::List, Build::Bvh] {
        let mesh = Mesh::new(corners.to_vec(), faces.clone(), None, build).unwrap();
        for (x, y, z) in (0..27).map(|k| (k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1)) {
            let ray = Ray::new(DVec3::ZERO, dvec3(f64::from(x), f64::from(y), f64::from(z)));
            let expected = u32::from(ray.direction != DVec3::ZERO);
            assert_eq!(mesh.crossings(&ray, Interval::AHEAD), expected, "{ray:?}");
            assert_eq!(mesh.intersect(&ray, Interval::AHEAD).is_some(), expected == 1);
            // From outside it goes in and out, or passes by.
            let line = Ray::new(-3.0 * ray.direction, ray.direction);
            assert_eq!(mesh.crossings(&line, Interval::AHEAD), 2 * expected, "{ray:?}");
        }
    }
}

#[test]
fn a_ray_that_leaves_a_triangle_does_not_meet_it_again_but_meets_the_others() {
    let mesh = square(None, Build::Bvh);
    let ray = down(1.5, 0.5);
    let leaving = |part| {
        let from = Departure { part, outward: false };
        let occluded = mesh.occludes_leaving(&ray, Interval::AHEAD, from);
        (mesh.intersect_leaving(&ray, Interval::AHEAD, from).is_some(), occluded)
    };
    assert_eq!(leaving(0), (false, false));
    assert_eq!(leaving(1), (false, false), "the other half of the square, in one plane with it");
    assert_eq!(leaving(2), (true, true), "one that stands on the square");
}

#[test]
fn a_ray_that_leaves_what_is_not_there_leaves_nothing() {
    let mesh = square(None, Build::Bvh);
    let from = Departure { part: 99, outward: true };
    assert!(mesh.intersect_leaving(&down(1.5, 0.5), Interval::AHEAD, from).is_some());
    assert!(mesh.occludes_leaving(&down(1.5, 0.5), Interval::AHEAD, from));
}

#[test]
fn a_ray_from_a_crease_meets_neither_of_its_sides() {
    // A fold of 45 degrees along y, from a start as far behind the slope as
    // rounding may put it.
    let vertices = vec![
        dvec3(0.0, 0.0, 0.0),
        dvec3(0.0, 2.0, 0.0),
        dvec3(2.0, 1.0, 0.0),
        dvec3(2.0, 1.0, 2.0),
    ];
    let mesh = Mesh::new(vertices, vec![[0, 2, 1], [0, 1, 3]], None, Build::Bvh).unwrap();
    let start = dvec3(0.0, 1.0, 1e-15);
    let meets = |towards: DVec3| {
        let ray = Ray::new(start, towards - start);
        let from = Departure { part: 0, outward: true };
        let occluded = mesh.occludes_leaving(&ray, Interval::AHEAD, from);
        assert_eq!(mesh.intersect_leaving(&ray, Interval::AHEAD, from).is_some(), occluded);
        occluded
    };
    let between = dvec3(2.0, 1.0, 1.0);
    assert!(mesh.occludes(&Ray::new(start, between - start), Interval::AHEAD));
    assert!(!meets(between), "out of the fold");
    // From farther out on the floor the slope is in the way.
    let ray = Ray::new(dvec3(1.0, 1.0, 1e-15), dvec3(-0.5, 0.0, 1.0));
    assert!(mesh.occludes_leaving(&ray, Interval::AHEAD, Departure { part: 0, outward: true }));
}

#[test]
fn normals_are_interpolated_where_there_are_any() {
    let tilted = dvec3(3.0, 0.0, 4.0);
    let straight = dvec3(0.0, 0.0, 9.0);
    let normals = MeshNormals {
        normals: vec![straight, tilted, DVec3::ZERO],
        faces: [[0, 1, 1], [2, 0, 0]].into_iter().chain([[0; 3]; 4]).collect(),
    };
    let mesh = square(Some(normals), Build::Bvh);
    let shading = |ray: Ray| {
        let contact = mesh.intersect(&ray, Interval::AHEAD).unwrap();
        let surface = mesh.surface(&ray, &contact);
        assert_eq!(surface.geometric_normal, UnitVec::Z);
        surface.shading_normal.to_array()
    };
    assert_eq!(shading(down(0.0, 0.0)), [0.0, 0.0, 1.0]);
    let [x, _, z] = shading(down(2.0, 1.0));
    assert!((x - 0.6).abs() < 1e-15 && (z - 0.8).abs() < 1e-15);
    let [x, _, z] = shading(down(1.0, 0.5));
    assert!((x / z - 0.3 / 0.9).abs() < 1e-15, "half way, then normalized");
    assert_eq!(shading(down(0.5, 1.5)), [0.0, 0.0, 1.0], "a corner without one: the true normal");
}

#[test]
fn bad_meshes_are_refused() {
    let v = vec![DVec3::ZERO, DVec3::X, DVec3::Y];
    let fields = |vertices, faces, normals| {
        let refused = Mesh::new(vertices, faces, normals, Build::Bvh).unwrap_err();
        refused.refusals().iter().map(|r| r.field).collect::<Vec<_>>()
    };
    assert_eq!(fields(v.clone(), vec![], None), ["faces"]);
    assert_eq!(fields(v.clone(), vec![[0, 1, 3]], None), ["faces"]);
    assert_eq!(fields(v.clone(), vec![[0, 1, 1]], None), ["faces"]);
    let nan = vec![DVec3::ZERO, DVec3::X, dvec3(0.0, f64::NAN, 0.0)];
    assert_eq!(fields(nan, vec![[0, 1, 2]], None), ["vertices"]);
    let normals = MeshNormals { normals: vec![DVec3::Z], faces: vec![[0, 0, 1]] };
    assert_eq!(fields(v.clone(), vec![[0, 1, 2]], Some(normals)), ["normals"]);
    let none = MeshNormals { normals: vec![], faces: vec![] };
    assert_eq!(fields(v, vec![[0, 1, 2]], Some(none)), ["normals"]);
}

#[test]
fn a_triangle_without_an_area_is_kept_and_never_hit() {
    let vertices = vec![DVec3::ZERO, DVec3::X, DVec3::Y];
    let mesh = Mesh::new(vertices, vec![[0, 0, 1], [0, 1, 2]], None, Build::Bvh).unwrap();
    assert_eq!(mesh.triangle_count(), 2);
    let hit = mesh.intersect(&down(0.25, 0.25), Interval::AHEAD).unwrap();
    assert_eq!(hit.part, 1);
}

#[test]
fn packets_give_the_answers_of_the_list() {
    let mut any = fastrand::Rng::with_seed(9);
    let mut hits = 0;
    for round in 0..12 {
        let (vertices, faces) = bumpy(&mut any, round % 2 == 0);
        let mesh = |build| Mesh::new(vertices.clone(), faces.clone(), None, build).unwrap();
        let list = mesh(Build::List);
        // Beside each other from one eye, from a small patch, at the seams, and
        // along an axis; with some left over behind the last whole packet.
        let eye = dvec3(3.0, 2.0, 1.0) * (any.f64() - 0.5);
        let rays: Vec<_> = (0..16 * 12 + 5)
            .map(|k| {
                let patch = dvec3(any.f64(), any.f64(), any.f64()) * [0.0, 0.1][round / 2 % 2];
                let face = faces[(k / 3) % faces.len()].map(|i| vertices[i as usize]);
                let target = [face[0], 0.5 * (face[0] + face[1]), face[0] + 0.01 * any.f64()];
                let mut direction = target[k % 3] - eye - patch;
                if round == 5 {
                    direction.y = 0.0;
                }
                Ray::new(eye + patch, direction)
            })
            .collect();
        let range = Interval::new(0.0, [f64::INFINITY, 1.0][round % 3 / 2]);
        let expected: Vec<_> = rays.iter().map(|ray| list.intersect(ray, range)).collect();
        hits += expected.iter().flatten().count();
        for level in crate::simd::Level::all() {
            let mesh = mesh(Build::Bvh).at(level);
            let mut contacts = vec![None; rays.len()];
            mesh.intersect_batch(&rays, range, Coherence::Coherent, &mut contacts);
            assert_eq!(contacts, expected, "{level:?}");
            let mut occluded = vec![false; rays.len()];
            mesh.occludes_batch(&rays, range, Coherence::Coherent, &mut occluded);
            let expected: Vec<_> = expected.iter().map(Option::is_some).collect();
            assert_eq!(occluded, expected, "{level:?}");
        }
    }
    assert!(hits > 800, "{hits} hits are too few to say anything");
}

#[test]
fn a_ray_that_is_no_ray_takes_none_out_of_its_packet() {
    let mut any = fastrand::Rng::with_seed(12);
    let (vertices, faces) = bumpy(&mut any, true);
    let mesh = |build| Mesh::new(vertices.clone(), faces.clone(), None, build).unwrap();
    let list = mesh(Build::List);
    let at = |level| mesh(Build::Bvh).at(level);
    let meshes: Vec<_> = crate::simd::Level::all().into_iter().map(at).collect();
    let mut hits = 0;
    for round in 0..600 {
        let (nobody, axis) = (round % 16, round / 16 % 3);
        // Most in a corner of the ball, and one that is alone at its end.
        let mut rays: Vec<_> = (0..16)
            .map(|k| {
                let end = if k == (nobody + 8) % 16 { 0.6 } else { -0.6 };
                let place = end + 0.4 * dvec3(any.f64(), any.f64(), any.f64());
                Ray::new(place - dvec3(1.0, 2.0, 3.0), dvec3(1.0, 2.0, 3.0))
            })
            .collect();
        rays[nobody].origin[axis] = f64::NAN;
        let expected: Vec<_> =
            rays.iter().map(|ray| list.intersect(ray, Interval::AHEAD)).collect();
        hits += expected.iter().flatten().count();
        for mesh in &meshes {
            let mut contacts = vec![None; rays.len()];
            mesh.intersect_batch(&rays, Interval::AHEAD, Coherence::Coherent, &mut contacts);
            assert_eq!(contacts, expected, "{:?}, {nobody}, {axis}", mesh.level);
        }
    }
    assert!(hits > 4000, "{hits} hits are too few to say anything");
}

/// A ball of random bumps, of `f32` corners or not, with a ray at its corners and
/// edges and some that are no one's.
pub(super) fn bumpy(any: &mut fastrand::Rng, is_single: bool) -> (Vec<DVec3>, Vec<[u32; 3]>) {
    let (rings, around) = (7, 12);
    let mut vertices = Vec::new();
    for ring in 0..=rings {
        for k in 0..around {
            let (up, turn) = (
                std::f64::consts::PI * (f64::from(ring) + 0.5) / f64::from(rings + 1),
                std::f64::consts::TAU * f64::from(k) / f64::from(around),
            );
            let (sin, cos) = libm::sincos(up);
            let (sine, cosine) = libm::sincos(turn);
            let p = dvec3(sin * cosine, sin * sine, cos) * (0.8 + 0.4 * any.f64());
            let single = DVec3::from_array(p.to_array().map(|x| f64::from(x as f32)));
            vertices.push(if is_single { single } else { p });
        }
    }
    let at = |ring: u32, k: u32| ring * around + k % around;
    let faces = (0..rings).flat_map(|ring| {
        (0..around).flat_map(move |k| {
            let [a, b] = [at(ring, k), at(ring, k + 1)];
            let [c, d] = [at(ring + 1, k), at(ring + 1, k + 1)];
            [[a, c, d], [a, d, b]]
        })
    });
    (vertices, faces.collect())
}

#[test]
fn every_level_batch_and_single_ray_gives_the_answers_of_the_list() {
    let mut any = fastrand::Rng::with_seed(4);
    for round in 0..12 {
        let (vertices, faces) = bumpy(&mut any, round % 2 == 0);
        let mesh = |build| Mesh::new(vertices.clone(), faces.clone(), None, build).unwrap();
        let list = mesh(Build::List);
        let point = |any: &mut fastrand::Rng| {
            dvec3(any.f64() - 0.5, any.f64() - 0.5, any.f64() - 0.5) * 6.0
        };
        let rays: Vec<_> = (0..400)
            .map(|k| {
                let origin = point(&mut any);
                let face = faces[any.usize(0..faces.len())].map(|i| vertices[i as usize]);
                let target = match k % 4 {
                    0 => face[0],
                    1 => 0.5 * (face[0] + face[1]),
                    _ => point(&mut any),
                };
                let mut direction = (target - origin) * libm::exp2(8.0 * any.f64() - 4.0);
                if k % 16 == 3 {
                    direction[any.usize(0..3)] = 0.0;
                }
                Ray::new(origin, direction)
            })
            .collect();
        let range = Interval::new(0.0, [f64::INFINITY, 1.0][round % 3 / 2]);
        let expected: Vec<_> = rays.iter().map(|ray| list.intersect(ray, range)).collect();
        for level in crate::simd::Level::all() {
            let mesh = mesh(Build::Bvh).at(level);
            for coherence in [Coherence::Incoherent, Coherence::Coherent] {
                let mut contacts = vec![None; rays.len()];
                mesh.intersect_batch(&rays, range, coherence, &mut contacts);
                assert_eq!(contacts, expected, "{level:?}");
            }
            let mut occluded = vec![false; rays.len()];
            mesh.occludes_batch(&rays, range, Coherence::Coherent, &mut occluded);
            for ((ray, expected), occluded) in rays.iter().zip(&expected).zip(occluded) {
                assert_eq!(mesh.intersect(ray, range), *expected, "{level:?} {ray:?}");
                assert_eq!(mesh.occludes(ray, range), expected.is_some(), "{level:?} {ray:?}");
                assert_eq!(occluded, expected.is_some(), "{level:?} {ray:?}");
                assert_eq!(
                    mesh.crossings(ray, range),
                    list.crossings(ray, range),
                    "{level:?} {ray:?}"
                );
            }
        }
    }
}

#[test]
fn hierarchy_and_list_agree_at_the_ends_of_the_range_of_numbers() {
    let mut any = fastrand::Rng::with_seed(6);
    for exponent in [-1000, -540, -520, -515, -345, -341, 338, 340, 341, 508, 511, 900] {
        let size = libm::exp2(f64::from(exponent));
        let (vertices, faces) = bumpy(&mut any, true);
        let vertices: Vec<_> = vertices.into_iter().map(|v| v * size).collect();
        let mesh = |build| Mesh::new(vertices.clone(), faces.clone(), None, build);
        // Where the areas are no numbers there is no mesh.
        let (Ok(list), Ok(tree)) = (mesh(Build::List), mesh(Build::Bvh)) else { continue };
        for k in 0..400 {
            let origin = 2.0 * size * dvec3(any.f64() - 0.5, any.f64() - 0.5, any.f64() - 0.5);
            let target = vertices[any.usize(0..vertices.len())];
            let direction = (target - origin) * libm::exp2([0.0, 40.0, -40.0][k % 3]);
            let ray = Ray::new(origin, direction);
            let expected = list.intersect(&ray, Interval::AHEAD);
            assert_eq!(tree.intersect(&ray, Interval::AHEAD), expected, "2^{exponent} {ray:?}");
        }
    }
}
