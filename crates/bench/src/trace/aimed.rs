//! Rays aimed at edges and corners: where one triangle ends and the next
//! begins, a tracer may lose a ray between them.

use tracer::glam::DVec3;

use super::engine::Named;
use super::measure::count_wrong;
use super::rays::{Query, RayF32, RaySet};
use super::report::Aimed;
use crate::meshes::{SceneMesh, Viewpoint};

/// Rays of each set.
pub(crate) const COUNT: usize = 100_000;
/// What starts the random numbers.
const SEED: u64 = 0xed6e;
/// Rays from outside start this many half diagonals from the center, and those
/// from inside within this many.
const OUTSIDE: f64 = 2.0;
const INSIDE: f64 = 0.1;

/// The sets for a scene: from outside it, or where its eye is; for a closed
/// mesh from its middle as well. Each at corners, and at points of edges.
pub(crate) fn sets(scene: &SceneMesh, count: usize) -> Vec<RaySet> {
    let [lo, hi] = scene.mesh.bounds().map(DVec3::from_array);
    let (center, half) = (DVec3::midpoint(lo, hi), (hi - lo).length() / 2.0);
    let around = |middle: DVec3| move |r: &mut fastrand::Rng| middle + in_cube(r) * INSIDE * half;
    let mut sets = Vec::new();
    for at in [At::Corners, At::Edges] {
        match scene.view {
            Viewpoint::Outside => {
                let outside = |r: &mut fastrand::Rng| {
                    center + in_cube(r).normalize_or(DVec3::Y) * OUTSIDE * half
                };
                sets.push(set(scene, "outside", at, count, outside));
            }
            Viewpoint::Inside { eye, .. } => {
                sets.push(set(scene, "inside", at, count, around(DVec3::from_array(eye))));
            }
        }
        if scene.is_closed {
            sets.push(set(scene, "inside", at, count, around(center)));
        }
    }
    sets
}

/// What is aimed at.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum At {
    Corners,
    Edges,
}

fn set(
    scene: &SceneMesh,
    from: &str,
    at: At,
    count: usize,
    mut origin: impl FnMut(&mut fastrand::Rng) -> DVec3,
) -> RaySet {
    let mut random = fastrand::Rng::with_seed(SEED);
    let mesh = &scene.mesh;
    let ray = |_| {
        let face = mesh.faces[random.usize(..mesh.faces.len())];
        let corner = random.usize(..3);
        let [a, b] = [face[corner], face[(corner + 1) % 3]]
            .map(|i| DVec3::from_array(mesh.vertices[i as usize].map(f64::from)));
        let target = match at {
            At::Corners => a,
            At::Edges => a + random.f64() * (b - a),
        };
        // Through the target but for the rounding of its direction: what a
        // renderer that aims at a corner sends.
        let origin = origin(&mut random).as_vec3();
        let direction = (target - origin.as_dvec3()).as_vec3();
        RayF32 { origin: origin.to_array(), direction: direction.to_array() }
    };
    let name = format!("{from}, at {}", if at == At::Corners { "corners" } else { "edges" });
    let rays = (0..count).map(ray).collect();
    RaySet { name, query: Query::Closest, rays, far: f32::INFINITY, pixels: None }
}

/// A point of the cube from -1 to 1.
fn in_cube(random: &mut fastrand::Rng) -> DVec3 {
    DVec3::from_array([(); 3].map(|()| 2.0 * random.f64() - 1.0))
}

/// What each engine answers wrongly of a set.
pub(crate) fn measure(
    scene: &SceneMesh,
    engines: &mut [Named],
    set: &RaySet,
    reference: &[Option<f64>],
) -> Vec<Aimed> {
    let aimed = engines.iter_mut().map(|(name, engine)| {
        engine.load(set);
        engine.trace();
        let wrong = count_wrong(&engine.answers(), reference, set.query);
        Aimed {
            scene: scene.name.clone(),
            rays: set.name.clone(),
            engine: (*name).to_owned(),
            of: set.rays.len(),
            wrong: wrong.total(),
            hit_or_miss: wrong.hit_or_miss,
            elsewhere: wrong.elsewhere,
        }
    });
    aimed.collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::meshes;
    use crate::trace::exact_answers;
    use crate::trace::goldray;

    #[test]
    fn rays_are_aimed_at_what_they_say() {
        let scene = meshes::named("bumpy-1000").unwrap().unwrap();
        let exact = goldray::build(&scene.mesh, tracer::accel::Build::Bvh).unwrap();
        let sets = sets(&scene, 500);
        let names: Vec<_> = sets.iter().map(|set| &*set.name).collect();
        let expected =
            ["outside, at corners", "inside, at corners", "outside, at edges", "inside, at edges"];
        assert_eq!(names, expected);
        for set in &sets {
            let corners = set.name.ends_with("corners");
            for ray in &set.rays {
                let end = ray.exact().at(1.0);
                let is_corner = scene
                    .mesh
                    .vertices
                    .iter()
                    .any(|v| (DVec3::from_array(v.map(f64::from)) - end).length() < 1e-6);
                // An edge's point is a corner by chance only.
                assert_eq!(is_corner, corners, "{} {end}", set.name);
            }
            let answers = exact_answers(&exact, set);
            if set.name.starts_with("inside") {
                assert!(answers.iter().all(Option::is_some), "a closed mesh has no way out");
            }
            let near = answers.iter().flatten().filter(|t| (*t - 1.0).abs() < 1e-3).count();
            assert!(4 * near > set.rays.len(), "{near}: not all are behind something else");
        }
    }
}
