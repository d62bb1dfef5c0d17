//! What the sets of rays promise.

use super::*;
use crate::meshes;
use crate::trace::goldray;

const SIZE: u32 = 24;

fn all() -> Vec<RaySet> {
    let scene = meshes::named("bumpy-1000").unwrap().unwrap();
    let exact = goldray::build(&scene.mesh, tracer::accel::Build::Bvh).unwrap();
    sets(&scene, &exact, SIZE, &Kind::ALL)
}

#[test]
fn there_is_a_bounce_and_a_shadow_ray_for_each_primary_hit() {
    let scene = meshes::named("bumpy-1000").unwrap().unwrap();
    let exact = goldray::build(&scene.mesh, tracer::accel::Build::Bvh).unwrap();
    let [primary, diffuse, shuffled, shadow] = &all()[..] else { panic!("four kinds") };
    let hits = primary.rays.iter().map(|ray| exact.intersect(&ray.exact(), Interval::AHEAD));
    let hits: Vec<_> = hits.collect();
    let count = hits.iter().flatten().count();
    assert_eq!(primary.rays.len() as u32, SIZE * SIZE);
    assert!(count > 100 && count < hits.len(), "{count}: the ball, and around it");
    assert_eq!([diffuse, shuffled, shadow].map(|set| set.rays.len()), [count; 3]);
    // They start where the primary rays end, on the side that these came from.
    let (pixels, _) = shadow.pixels.as_ref().unwrap();
    for ((bounce, shadow), &pixel) in diffuse.rays.iter().zip(&shadow.rays).zip(pixels) {
        let ray = primary.rays[pixel as usize].exact();
        let contact = hits[pixel as usize].unwrap();
        let surface = exact.surface(&ray, &contact);
        let start = bounce.exact();
        assert!((start.origin - surface.point).length() < 1e-4);
        assert_eq!(bounce.origin, shadow.origin);
        let normal = *surface.geometric_normal;
        let toward_eye = -normal.dot(ray.direction);
        assert!(normal.dot(start.origin - surface.point) * toward_eye > 0.0, "in front");
        assert!(normal.dot(start.direction) * toward_eye > -1e-6, "outwards");
        assert!((start.direction.length() - 1.0).abs() < 1e-6);
    }
}

#[test]
fn shuffled_rays_are_the_diffuse_ones_in_another_order() {
    let sets = all();
    let bits = |set: &RaySet| {
        let words = |r: &RayF32| [r.origin, r.direction].map(|v| v.map(f32::to_bits));
        set.rays.iter().map(words).collect::<Vec<_>>()
    };
    let (mut diffuse, mut shuffled) = (bits(&sets[1]), bits(&sets[2]));
    assert_ne!(diffuse, shuffled);
    diffuse.sort_unstable();
    shuffled.sort_unstable();
    assert_eq!(diffuse, shuffled);
}

#[test]
fn a_kind_is_the_same_with_and_without_the_others() {
    let scene = meshes::named("bumpy-1000").unwrap().unwrap();
    let exact = goldray::build(&scene.mesh, tracer::accel::Build::Bvh).unwrap();
    for (kind, set) in Kind::ALL.into_iter().zip(all()) {
        let alone = sets(&scene, &exact, SIZE, &[kind]);
        assert_eq!(alone[0].rays, set.rays, "{kind:?}");
    }
}

#[test]
fn bounces_are_as_likely_as_their_cosine() {
    let mut random = fastrand::Rng::with_seed(1);
    let count = 20_000;
    let cosines = (0..count).map(|_| cosine_around(DVec3::Z, &mut random).z);
    // The mean of cos under cos / pi over the half sphere is 2/3.
    let mean = cosines.sum::<f64>() / f64::from(count);
    assert!((mean - 2.0 / 3.0).abs() < 0.01, "{mean}");
}

#[test]
fn tiles_are_whole_and_hold_every_ray_once() {
    let primary = &all()[0];
    let order = primary.tiled(8);
    let tile = |ray: u32| (ray / SIZE / 8, ray % SIZE / 8);
    for chunk in order.chunks(64) {
        assert!(chunk.iter().all(|&ray| tile(ray) == tile(chunk[0])));
    }
    let mut sorted = order;
    sorted.sort_unstable();
    assert!(sorted.into_iter().eq(0..SIZE * SIZE));
    let diffuse = &all()[1];
    assert!(diffuse.tiled(8).into_iter().eq(0..diffuse.rays.len() as u32));
}
