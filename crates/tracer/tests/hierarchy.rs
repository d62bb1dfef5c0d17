//! The hierarchy is the list, only sooner: the same hits of the same objects.
#![allow(clippy::unwrap_used)]

mod random;

use random::{Any, there_from_here};
use tracer::accel::Build;
use tracer::glam::{DVec3, dvec3};
use tracer::shape::{AxisBox, Cone, Cylinder, Disk, Plane, Shape, Sphere, Torus, Triangle};
use tracer::{Group, Interval, Material, Member, Object, Ray, Transform};

const AHEAD: Interval = Interval::AHEAD;

#[test]
fn the_hierarchy_gives_the_answers_of_the_list() {
    let mut any = Any::new(8);
    let mut hits = 0;
    for round in 0..60 {
        // Few and many, spread out and on one spot, with planes among them,
        // and with copies, whose ties the first must win.
        let spread = [1.0, 0.05, 0.0][round % 3];
        let mut members = Vec::new();
        for _ in 0..[3, 20, 150][round / 3 % 3] {
            let center = any.point() * spread;
            let shape: Shape = match any.0.u8(0..29) {
                0 => Plane::new(center, any.direction()).unwrap().into(),
                20..23 => Cylinder::new(center, center + 0.3 * any.direction(), 0.03, true)
                    .unwrap()
                    .into(),
                23..26 => {
                    Cone::new(center, center + 0.3 * any.direction(), 0.1, false).unwrap().into()
                }
                26..29 => Torus::new(center, any.direction(), 0.15, 0.05).unwrap().into(),
                1..5 => Disk::new(center, any.direction(), 0.2).unwrap().into(),
                5..10 => AxisBox::new(center - 0.05, center + 0.05).unwrap().into(),
                10..15 => {
                    let corner = |p: DVec3| center + 0.2 * p;
                    let (a, b, c) = (any.point(), any.point(), any.point());
                    Triangle::new(corner(a), corner(b), corner(c)).unwrap().into()
                }
                _ => Sphere::new(center, 0.1).unwrap().into(),
            };
            for _ in 0..any.0.u8(1..3) {
                members.push(Member::Object(Object::new(shape.clone(), Material::Normal)));
            }
        }
        let scene = |build| {
            let group = Group::new(Transform::IDENTITY, members.clone(), build);
            numbered(group)
        };
        let (list, bvh) = (scene(Build::List), scene(Build::Bvh));
        for _ in 0..2_000 {
            let mut ray = any.ray();
            if any.0.bool() {
                // Axis-parallel rays have infinite reciprocals.
                let axis = any.0.usize(0..3);
                ray.direction = DVec3::ZERO;
                ray.direction[axis] = any.number();
            }
            let range = Interval::new(0.0, [f64::INFINITY, 1.0, 0.3][any.0.usize(0..3)]);
            let (one, other) = (list.intersect(&ray, range), bvh.intersect(&ray, range));
            assert_eq!(one, other, "{ray:?}");
            assert_eq!(list.occludes(&ray, range), bvh.occludes(&ray, range), "{ray:?}");
            hits += u32::from(one.is_some());
        }
    }
    assert!(hits > 10_000, "{hits} hits are too few to say anything");
}

#[test]
fn the_hierarchy_gives_the_answers_of_the_list_for_groups_seen_edge_on() {
    let mut any = Any::new(10);
    let (mut hits, mut rays) = (0, 0);
    for stretch in [1.0, 1e-3, 1e-5, 1e4] {
        for _ in 0..40 {
            let transform = any.stretching(stretch);
            let cube = AxisBox::new(DVec3::splat(-1.0), DVec3::ONE).unwrap();
            let object = || Member::Object(Object::new(cube.into(), Material::Normal));
            let group = |build| Member::Group(Group::new(transform, vec![object()], build));
            let scene = |build| {
                let mut members = vec![group(build)];
                // Enough others that there is a tree at all.
                members.extend((0..5).map(|k| {
                    let ball = Sphere::new(dvec3(20.0 + f64::from(k), 0.0, 0.0), 0.1).unwrap();
                    Member::Object(Object::new(ball.into(), Material::Normal))
                }));
                numbered(Group::new(Transform::IDENTITY, members, build))
            };
            let (list, bvh) = (scene(Build::List), scene(Build::Bvh));
            let bounds = list_bounds(&transform);
            for _ in 0..500 {
                // Past the corners that touch the group's box, by about
                // nothing, from near and far.
                let corner = there_from_here(&transform, any.corner());
                let axis = any.0.usize(0..3);
                let mut target = corner;
                let nudge = [0.0, 1e-15, -1e-15, 1e-13, -1e-13][any.0.usize(0..5)];
                target[axis] += nudge * bounds;
                let mut direction = any.direction();
                direction[axis] = 0.0;
                let ray = Ray::new(target - direction * [1.0, 1e3][any.0.usize(0..2)], direction);
                let (one, other) = (list.intersect(&ray, AHEAD), bvh.intersect(&ray, AHEAD));
                assert_eq!(one, other, "x {stretch} {ray:?}");
                hits += u32::from(one.is_some());
                rays += 1;
            }
        }
    }
    assert!(hits > rays / 50 && hits < rays, "{hits} hits of {rays} rays");
}

/// The largest coordinate of the unit cube's corners through the transform.
fn list_bounds(transform: &Transform) -> f64 {
    let cube = tracer::Aabb { min: DVec3::splat(-1.0), max: DVec3::ONE };
    cube.corners()
        .map(|c| there_from_here(transform, c).abs().max_element())
        .into_iter()
        .fold(0.0, f64::max)
}

/// The group with its objects numbered, as a scene numbers them.
fn numbered(group: Group) -> Group {
    let camera = tracer::Camera::look_at(DVec3::Z, DVec3::ZERO, DVec3::Y, 40.0, 1.0).unwrap();
    let parts = tracer::SceneParts {
        camera,
        size: tracer::Size { width: 1, height: 1 },
        samples: tracer::Samples::ONE,
        filter: tracer::Filter::BOX,
        error: None,
        world: group,
        lights: Vec::new(),
        convention: tracer::Convention::Classic,
        shadows: true,
        bounces: tracer::Scene::DEFAULT_BOUNCES,
        background: tracer::Rgb::BLACK,
        exposure: 1.0,
        show: tracer::Show::Shaded,
    };
    tracer::Scene::new(parts).unwrap().world().clone()
}
