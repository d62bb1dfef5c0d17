//! Plans: what is skipped where, and that no bit of a picture changes.

use glam::{DVec3, dvec3};

use super::*;
use crate::accel::Build;
use crate::shape::{AxisBox, Plane, Sphere};
use crate::{
    Camera, Convention, Falloff, Filter, Group, LinearImage, Member, Object, Samples, SceneParts,
    Size, Stats, Transform, render, render_counted,
};

const GRAY: Material = Material::Lambert { diffuse: Rgb::new(0.5, 0.5, 0.5) };

fn ball(center: DVec3, radius: f64) -> Member {
    Member::Object(Object::new(Sphere::new(center, radius).unwrap().into(), GRAY))
}

/// 64 x 48 pixels, four samples each, from (0, 0, 8).
fn scene(members: Vec<Member>, lights: Vec<Light>, show: Show) -> Scene {
    let size = Size { width: 64, height: 48 };
    let aspect = f64::from(size.width) / f64::from(size.height);
    Scene::new(SceneParts {
        camera: Camera::look_at(DVec3::Z * 8.0, DVec3::ZERO, DVec3::Y, 40.0, aspect).unwrap(),
        size,
        samples: Samples::grid(4).unwrap(),
        filter: Filter::BOX,
        error: None,
        world: Group::new(Transform::IDENTITY, members, Build::Bvh),
        lights,
        convention: Convention::Classic,
        shadows: true,
        bounces: Scene::DEFAULT_BOUNCES,
        background: Rgb::new(0.1, 0.2, 0.3),
        exposure: 1.7,
        show,
    })
    .unwrap()
}

fn lamp(intensity: Rgb) -> Light {
    Light::point(dvec3(2.0, 5.0, 4.0), intensity, Falloff::Constant).unwrap()
}

fn by(scene: &Scene, skipping: Skipping) -> (LinearImage, Stats) {
    render_counted(scene, &Plan::new(scene, skipping))
}

/// The picture's counts with skipping, after holding its bits against those
/// made without.
fn counts(scene: &Scene) -> Stats {
    let (with, stats) = by(scene, Skipping::On);
    let (without, all) = by(scene, Skipping::Off);
    assert!(with == without && with == render(scene));
    assert_eq!(all.get(Event::EyeRay), 64 * 48 * 4);
    stats
}

#[test]
fn nothing_is_done_for_an_empty_scene() {
    let scene = scene(vec![], vec![lamp(Rgb::WHITE)], Show::Shaded);
    let stats = counts(&scene);
    assert_eq!(stats.get(Event::SkippedPixel), 64 * 48);
    assert!(Event::ALL.into_iter().all(|e| e == Event::SkippedPixel || stats.get(e) == 0));
}

#[test]
fn a_small_ball_takes_a_few_tiles_and_no_other_code() {
    let scene = scene(vec![ball(DVec3::ZERO, 0.4)], vec![lamp(Rgb::WHITE)], Show::Shaded);
    let stats = counts(&scene);
    // It is 48 / (2 tan 20 degrees) x 0.4 / 8 pixels wide on each side of the
    // middle, 3.3: four tiles meet there.
    assert_eq!(stats.get(Event::Pixel), 4 * 64);
    assert_eq!(stats.get(Event::EyeRay), 4 * 64 * 4);
    let spheres = stats.get(Event::Sphere);
    assert!(spheres > 0 && stats.primitive_tests() == spheres);
    assert_eq!(stats.get(Event::HalfVector), 0);
    // No shadow ray from the side that is turned away.
    let (shadows, skipped) = (stats.get(Event::ShadowRay), stats.get(Event::SkippedShadowRay));
    assert!(shadows > 0 && skipped > 0);
    assert_eq!(shadows + skipped, stats.get(Event::ShadedHit));
}

#[test]
fn a_tile_is_held_against_what_it_shows_only() {
    // Seven balls in a row, so that there is a hierarchy, none over another.
    let row = (-3..=3).map(|x| ball(dvec3(f64::from(x) * 0.9, 0.0, 0.0), 0.3)).collect();
    let stats = counts(&scene(row, vec![], Show::Silhouette));
    assert_eq!(stats.get(Event::Node), 0, "no ray walks the hierarchy");
    assert!(stats.get(Event::Sphere) < 3 * stats.get(Event::EyeRay));
}

#[test]
fn many_members_are_left_to_the_hierarchy() {
    let row = |n: i32| (0..n).map(|x| ball(dvec3(0.0, 0.0, f64::from(-x)), 1.0)).collect();
    for n in [63, 64, 65, 200] {
        let stats = counts(&scene(row(n), vec![], Show::Normals));
        assert!(stats.get(Event::Node) > 0, "{n}");
    }
}

#[test]
fn what_is_not_shown_is_not_computed() {
    let balls = || vec![ball(DVec3::ZERO, 1.0)];
    let lights = || vec![lamp(Rgb::WHITE), lamp(Rgb::BLACK)];
    for show in [Show::Silhouette, Show::ObjectIds, Show::Depth { near: 1.0, far: 9.0 }] {
        let stats = counts(&scene(balls(), lights(), show));
        assert_eq!((stats.get(Event::ShadedHit), stats.get(Event::ShadowRay)), (0, 0));
    }
    let dark = counts(&scene(balls(), vec![lamp(Rgb::BLACK)], Show::Shaded));
    assert_eq!(dark.get(Event::ShadowRay), 0);
    let both = counts(&scene(balls(), lights(), Show::Shaded));
    let one = counts(&scene(balls(), vec![lamp(Rgb::WHITE)], Show::Shaded));
    assert_eq!(both.get(Event::ShadowRay), one.get(Event::ShadowRay));
}

#[test]
fn above_the_horizon_there_are_no_rays() {
    let floor = Plane::new(dvec3(0.0, -1.0, 0.0), DVec3::Y).unwrap();
    let floor = Member::Object(Object::new(floor.into(), GRAY));
    let stats = counts(&scene(vec![floor], vec![lamp(Rgb::WHITE)], Show::Shaded));
    // The horizon is the middle, between two rows of tiles.
    assert!(stats.get(Event::SkippedPixel) >= 64 * 16, "{stats:?}");
}

#[test]
fn who_was_in_the_way_is_asked_first() {
    // A wall in front of the light, and six balls in its shadow.
    let wall = AxisBox::new(dvec3(-9.0, 3.0, -9.0), dvec3(9.0, 3.1, 9.0)).unwrap();
    let mut members: Vec<_> = (-3..3).map(|x| ball(dvec3(f64::from(x), 0.0, 0.0), 0.45)).collect();
    members.push(Member::Object(Object::new(wall.into(), GRAY)));
    let eye_rays = counts(&scene(members.clone(), vec![], Show::Normals));
    let stats = counts(&scene(members, vec![lamp(Rgb::WHITE)], Show::Shaded));
    // One test of the wall, and no node, for nearly every shadow ray.
    let shadow_rays = stats.get(Event::ShadowRay);
    assert!(shadow_rays > 100);
    let nodes = stats.get(Event::Node) - eye_rays.get(Event::Node);
    assert!(nodes < shadow_rays / 10, "{nodes} of {shadow_rays}: {stats:?}");
}

#[test]
fn the_notes_say_what_is_done() {
    let text = |scene: &Scene| Plan::new(scene, Skipping::On).notes().join("\n");
    let empty = text(&scene(vec![], vec![], Show::Silhouette));
    assert!(empty.contains("in 0 of 48 tiles") && empty.contains("shapes: none;"), "{empty}");
    let lights = vec![lamp(Rgb::WHITE), lamp(Rgb::BLACK)];
    let lit = text(&scene(vec![ball(DVec3::ZERO, 1.0)], lights, Show::Shaded));
    for part in [
        "shapes: 1 sphere; no code runs for triangles, boxes,",
        "shading: 1 light; 1 of no intensity skipped",
        "shadow rays: towards 1 light,",
        "half vectors: none",
    ] {
        assert!(lit.contains(part), "{lit}");
    }
}

#[test]
fn mirrors_and_glass_are_skipped_by_halves_and_change_no_bit() {
    let shiny = |x: f64, material: Material| {
        let ball = Sphere::new(dvec3(x, 0.0, 0.0), 0.9).unwrap();
        Member::Object(Object::new(ball.into(), material.checked().unwrap()))
    };
    let whitted = |reflect, transmit| Material::Whitted {
        diffuse: Rgb::new(0.2, 0.1, 0.3),
        specular: Rgb::WHITE,
        exponent: 20.0,
        reflect,
        transmit,
        ior: 1.3,
        schlick: false,
    };
    let half = Rgb::new(0.5, 0.25, 0.0);
    let floor = Plane::new(dvec3(0.0, -1.0, 0.0), DVec3::Y).unwrap();
    let members = vec![
        Member::Object(Object::new(floor.into(), GRAY)),
        shiny(-2.0, Material::Dielectric { ior: 1.5, tint: half, schlick: false }),
        shiny(0.0, whitted(half, Rgb::BLACK)),
        shiny(2.0, whitted(Rgb::BLACK, half)),
    ];
    let scene = scene(members, vec![lamp(Rgb::WHITE)], Show::Shaded);
    let (with, some) = by(&scene, Skipping::On);
    let (without, all) = by(&scene, Skipping::Off);
    assert!(with == without && with == render(&scene));
    for event in [Event::ReflectedRay, Event::RefractedRay] {
        assert!(0 < some.get(event) && 2 * some.get(event) < all.get(event), "{some:?} {all:?}");
    }
    let notes = Plan::new(&scene, Skipping::On).notes().join("\n");
    assert!(notes.contains("from 3 objects, up to 5 times one after the other"), "{notes}");
    assert!(notes.contains("on 2 objects with a highlight"), "{notes}");
}
