//! What mirrors and glass show, in scenes whose colors are known.

use glam::{DVec3, dvec3};

use super::*;
use crate::accel::Build;
use crate::meter::Unmetered;
use crate::shape::{AxisBox, Cone, Cylinder, Mesh, MeshNormals, Plane, Shape, Sphere, Torus};
use crate::{
    Camera, Convention, Falloff, Filter, Group, Light, Material, Member, Object, Samples,
    SceneParts, Show, Size, Skipping, Transform, UnitVec,
};

fn object(shape: impl Into<Shape>, material: Material) -> Member {
    Member::Object(Object::new(shape.into(), material.checked().unwrap()))
}

fn plane(point: DVec3, normal: DVec3) -> Plane {
    Plane::new(point, normal).unwrap()
}

fn ball(center: DVec3, radius: f64) -> Sphere {
    Sphere::new(center, radius).unwrap()
}

const SKY: Rgb = Rgb::new(0.25, 0.5, 0.75);
const GRAY: Rgb = Rgb::new(0.5, 0.5, 0.5);
const MIRROR: Material = Material::Mirror { reflectance: Rgb::WHITE, schlick: false };

fn glass(ior: f64) -> Material {
    Material::Dielectric { ior, tint: Rgb::WHITE, schlick: false }
}

fn scene(members: Vec<Member>, bounces: u32) -> Scene {
    let lamp = Light::point(dvec3(2.0, 9.0, 4.0), Rgb::WHITE, Falloff::Constant).unwrap();
    Scene::new(SceneParts {
        camera: Camera::look_at(DVec3::Z * 8.0, DVec3::ZERO, DVec3::Y, 40.0, 1.0).unwrap(),
        size: Size { width: 1, height: 1 },
        samples: Samples::ONE,
        filter: Filter::BOX,
        error: None,
        world: Group::world(members),
        lights: vec![lamp],
        convention: Convention::Classic,
        shadows: true,
        bounces,
        background: SKY,
        exposure: 1.0,
        show: Show::Shaded,
    })
    .unwrap()
}

fn color(scene: &Scene, origin: DVec3, direction: DVec3) -> [f64; 3] {
    scene.trace(&Ray::new(origin, direction), Interval::AHEAD).channels()
}

/// A floor of this material, seen from the height 1 at this slope.
#[track_caller]
fn check_floor(material: Material, slope: f64, expected: [f64; 3]) {
    let scene = scene(vec![object(plane(DVec3::ZERO, DVec3::Y), material)], 5);
    let found = color(&scene, DVec3::Y, dvec3(1.0, -slope, 0.0));
    let close = found.iter().zip(expected).all(|(f, e)| (f - e).abs() < 1e-14);
    assert!(close, "{material:?}: {found:?}");
}

#[test]
fn a_floor_of_each_material_under_the_sky() {
    let [r, g, b] = SKY.channels();
    let third = Rgb::new(1.0, 0.5, 0.25);
    check_floor(MIRROR, 1.0, [r, g, b]);
    let tinted = Material::Mirror { reflectance: third, schlick: false };
    check_floor(tinted, 0.01, [r, 0.5 * g, 0.25 * b]);
    // The cosine is 3/5, and (1 - 3/5)^5 = 32/3125.
    let schlick = Material::Mirror { reflectance: third, schlick: true };
    let grown = |r0: f64| r0 + (1.0 - r0) * 32.0 / 3125.0;
    check_floor(schlick, 0.75, [r, grown(0.5) * g, grown(0.25) * b]);
    let whitted = Material::Whitted {
        diffuse: Rgb::BLACK,
        specular: Rgb::BLACK,
        exponent: 1.0,
        reflect: third,
        transmit: Rgb::BLACK,
        ior: 1.0,
        schlick: true,
    };
    check_floor(whitted, 0.75, [r, grown(0.5) * g, grown(0.25) * b]);
    // All of it is sky, whatever the share.
    check_floor(glass(1.5), 0.3, [r, g, b]);
    // Straight down 1/25 is reflected.
    let down = scene(vec![object(plane(DVec3::ZERO, DVec3::Y), tint(1.5, third))], 5);
    let found = color(&down, DVec3::Y, -DVec3::Y);
    let expected = [r, g * (0.04 + 0.96 * 0.5), b * (0.04 + 0.96 * 0.25)];
    assert!(found.iter().zip(expected).all(|(f, e)| (f - e).abs() < 1e-15), "{found:?}");
    // Of a glaze over black only the reflection is seen, and from under it none.
    let glaze = Material::Glazed {
        ior: 1.5,
        schlick: false,
        diffuse: Rgb::BLACK,
        specular: Rgb::BLACK,
        exponent: 1.0,
    };
    let floor = scene(vec![object(plane(DVec3::ZERO, DVec3::Y), glaze)], 5);
    let found = color(&floor, DVec3::Y, -DVec3::Y);
    assert!((found[1] - 0.04 * g).abs() < 1e-16, "{found:?}");
    assert_eq!(color(&floor, -DVec3::Y, DVec3::Y), [0.0; 3]);
}

#[test]
fn rays_that_are_sent_on_are_those_that_show_something() {
    let way = Ray::new(DVec3::Y, dvec3(0.6, -0.8, 0.0));
    let sent = |material: Material| {
        let scene = scene(vec![object(plane(DVec3::ZERO, DVec3::Y), material)], 5);
        let hit = scene.world().intersect(&way, Interval::AHEAD).unwrap();
        let on = rays_sent_on(&way, &hit);
        on.iter().map(|ray| ray.direction.to_array()).collect::<Vec<_>>()
    };
    assert_eq!(sent(MIRROR), [[0.6, 0.8, 0.0]]);
    let black = Material::Mirror { reflectance: Rgb::BLACK, schlick: false };
    assert_eq!(sent(black), [[0.0; 3]; 0]);
    assert_eq!(sent(Material::Lambert { diffuse: Rgb::WHITE }), [[0.0; 3]; 0]);
    // Into a medium of index 3/4 the sine 3/5 becomes 4/5.
    let [reflected, refracted] = sent(glass(0.75)).try_into().unwrap();
    assert_eq!(reflected, [0.6, 0.8, 0.0]);
    let expected = [0.8, -0.6, 0.0];
    assert!(refracted.iter().zip(expected).all(|(f, e)| (f - e).abs() < 1e-15), "{refracted:?}");
    // And of index 1/2 it would be 6/5.
    assert_eq!(sent(glass(0.5)), [[0.6, 0.8, 0.0]]);
}

fn tint(ior: f64, tint: Rgb) -> Material {
    Material::Dielectric { ior, tint, schlick: false }
}

#[test]
fn beyond_the_critical_angle_everything_is_reflected() {
    // From inside of glass with a black sky below, the sine is 1.5 times 0.8.
    let shown = |material: Material| {
        let ceiling = object(plane(DVec3::ZERO, DVec3::Y), material);
        let below = object(plane(-DVec3::Y * 9.0, DVec3::Y), Material::Constant(Rgb::WHITE));
        color(&scene(vec![ceiling, below], 5), -DVec3::Y, dvec3(0.8, 0.6, 0.0))
    };
    assert_eq!(shown(tint(1.5, Rgb::BLACK)), [1.0; 3]);
    let whitted = Material::Whitted {
        diffuse: Rgb::BLACK,
        specular: Rgb::BLACK,
        exponent: 1.0,
        reflect: Rgb::new(0.125, 0.25, 0.5),
        transmit: Rgb::new(0.25, 0.25, 0.25),
        ior: 1.5,
        schlick: false,
    };
    assert_eq!(shown(whitted), [0.375, 0.5, 0.75]);
}

/// A ray that meets four mirrors, each of which halves it, and then a wall.
#[test]
fn a_ray_is_sent_on_as_often_as_the_scene_says() {
    let half = Material::Mirror { reflectance: GRAY, schlick: false };
    let seen = |bounces| {
        let mirrors = [1.0, -1.0].map(|z| object(plane(DVec3::Z * z, DVec3::Z), half));
        let wall = object(plane(DVec3::X * 8.0, DVec3::X), Material::Constant(Rgb::WHITE));
        let scene = scene([Vec::from(mirrors), vec![wall]].concat(), bounces);
        color(&scene, DVec3::ZERO, dvec3(1.0, 0.0, 1.0))[0]
    };
    let expected = [0.0, 0.0, 0.0, 0.0, 0.0625, 0.0625];
    assert_eq!([0, 1, 2, 3, 4, 16].map(seen), expected);
}

/// The deepest way there is, on a stack an eighth of what a thread has.
#[test]
fn the_most_bounces_need_little_stack() {
    const STACK: usize = 1 << 18;
    let deepest = || {
        let mirrors = [1.0, -1.0].map(|z| object(plane(DVec3::Z * z, DVec3::Z), MIRROR));
        let scene = scene(mirrors.into(), Scene::MAX_BOUNCES);
        color(&scene, DVec3::ZERO, dvec3(1.0, 0.5, 3.0))
    };
    let thread = std::thread::Builder::new().stack_size(STACK).spawn(deepest).unwrap();
    assert_eq!(thread.join().unwrap(), [0.0; 3]);
    let refused =
        |bounces| Scene::new(SceneParts { bounces, ..scene(vec![], 0).parts().clone() }).is_err();
    assert!(!refused(Scene::MAX_BOUNCES) && refused(Scene::MAX_BOUNCES + 1));
}

/// Things above a floor: what a mirror there shows is what is seen from under it.
#[test]
fn a_mirror_shows_the_mirrored_scene() {
    let things = || {
        let blue = Material::BlinnPhong {
            diffuse: Rgb::new(0.1, 0.2, 0.8),
            specular: GRAY,
            exponent: 30.0,
        };
        let cube = AxisBox::new(dvec3(-2.0, 0.5, -1.0), dvec3(-1.0, 1.5, 0.0)).unwrap();
        let torus = Torus::new(dvec3(0.0, 2.0, -2.0), dvec3(0.2, 1.0, 0.5), 1.0, 0.3).unwrap();
        vec![
            object(ball(dvec3(0.5, 1.2, 0.0), 1.0), blue),
            object(cube, Material::Lambert { diffuse: GRAY }),
            object(torus, blue),
        ]
    };
    let floor = object(plane(DVec3::ZERO, DVec3::Y), MIRROR);
    let (with, without) = (scene([things(), vec![floor]].concat(), 1), scene(things(), 1));
    let mut any = fastrand::Rng::with_seed(1);
    let (mut met, mut off) = (0, 0);
    for _ in 0..4000 {
        let eye = dvec3(0.3, 2.0, 6.0);
        let on_floor = dvec3(6.0 * any.f64() - 3.0, 0.0, 6.0 * any.f64() - 1.0);
        let down = on_floor - eye;
        let first = with.world().intersect(&Ray::new(eye, down), Interval::AHEAD).unwrap();
        if first.object.0 != 3 {
            continue;
        }
        let up = |v: DVec3| dvec3(v.x, -v.y, v.z);
        let (seen, mirrored) = (color(&with, eye, down), color(&without, up(eye), up(down)));
        met += u32::from(mirrored != SKY.channels());
        off += u32::from(seen.iter().zip(mirrored).any(|(a, b)| (a - b).abs() > 1e-12));
    }
    assert!(met > 400, "{met}");
    assert_eq!(off, 0);
}

/// Closed shapes around the origin, with bodies of their own inside.
fn closed() -> Vec<(&'static str, Member)> {
    let side = |x: f64| {
        [dvec3(x, -1.0, -1.0), dvec3(x, 1.0, -1.0), dvec3(x, 1.0, 1.0), dvec3(x, -1.0, 1.0)]
    };
    let corners = [side(-1.0), side(1.0)].concat();
    let faces =
        [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [3, 7, 6, 2], [0, 4, 7, 3], [1, 2, 6, 5]];
    let halves = |&[a, b, c, d]: &[u32; 4]| [[a, b, c], [a, c, d]];
    let triangles: Vec<_> = faces.iter().flat_map(halves).collect();
    let normals = MeshNormals { normals: corners.clone(), faces: triangles.clone() };
    let mesh = |normals| Mesh::new(corners.clone(), triangles.clone(), normals, Build::Bvh);
    let turned = |member| {
        let turn = Transform::rotation_deg(dvec3(20.0, 30.0, 40.0)).unwrap();
        let stretch = Transform::scale(dvec3(1.3, -0.7, 1.0)).unwrap();
        Member::Group(Group::new(turn.then(stretch).unwrap(), vec![member], Build::Bvh))
    };
    let cube = AxisBox::new(-DVec3::ONE, DVec3::ONE).unwrap();
    let any = glass(1.5);
    vec![
        ("sphere", object(ball(dvec3(0.1, 0.2, -0.1), 1.0), any)),
        ("box", object(cube, any)),
        ("mesh", object(mesh(None).unwrap(), any)),
        ("smooth mesh", object(mesh(Some(normals)).unwrap(), any)),
        ("cylinder", object(Cylinder::new(-DVec3::X, DVec3::ONE, 0.7, true).unwrap(), any)),
        ("cone", object(Cone::new(DVec3::Y, dvec3(0.2, -1.0, 0.1), 1.0, true).unwrap(), any)),
        ("torus", object(Torus::new(DVec3::ZERO, dvec3(1.0, 2.0, 3.0), 1.0, 0.4).unwrap(), any)),
        ("box in a group", turned(object(cube, any))),
        ("mesh in a group", turned(object(mesh(None).unwrap(), any))),
        ("sphere in a group", turned(object(ball(DVec3::ZERO, 1.0), any))),
    ]
}

/// Rays that are refracted and reflected at random: one that has entered leaves
/// before it enters again, and is never lost inside.
#[test]
fn no_ray_is_lost_at_the_surface_of_what_is_closed() {
    const RAYS: usize = 3000;
    const STEPS: usize = 40;
    let mut any = fastrand::Rng::with_seed(3);
    for (name, member) in closed() {
        let world = Group::world(vec![member]);
        let (mut inner, mut total) = (0, 0);
        for _ in 0..RAYS {
            let mut point = || dvec3(any.f64(), any.f64(), any.f64()) * 2.0 - 1.0;
            let origin = point() * 5.0 + dvec3(9.0, 0.0, 0.0);
            let mut ray = Ray::new(origin, point() - origin);
            let ior = [0.6, 1.0, 1.5, 2.4][any.usize(0..4)];
            let mut inside = false;
            for _ in 0..STEPS {
                let Some(mut hit) = world.intersect(&ray, Interval::AHEAD) else {
                    assert!(!inside, "{name}: {ray:?} is lost inside");
                    break;
                };
                hit.material = glass(ior);
                let parts = Parts::of(&ray, &hit);
                assert_eq!(parts.leaves, inside, "{name}: {ray:?} {hit:?}");
                inner += u32::from(inside);
                total += u32::from(parts.refracted.is_none());
                let goes_through = parts.refracted.filter(|_| any.f64() < 0.6);
                let (direction, outward) = match (goes_through, parts.reflected) {
                    (Some((direction, _)), _) => {
                        inside = !inside;
                        (direction, parts.leaves)
                    }
                    (None, Some((direction, _))) => (direction, !parts.leaves),
                    (None, None) => panic!("{name}: {hit:?} sends nothing on"),
                };
                ray = hit.leaving_on(outward, direction);
            }
        }
        assert!(inner > 1000 && total > 100, "{name}: {inner} hits from inside, {total} total");
    }
}

/// Whatever the shading normal, both ways are on the proper sides.
#[test]
fn interpolated_normals_send_no_ray_through_a_mirror() {
    let world = Group::world(vec![object(plane(DVec3::ZERO, DVec3::Z), MIRROR)]);
    let any_hit = world.intersect(&Ray::new(DVec3::Z, -DVec3::Z), Interval::AHEAD).unwrap();
    let mut any = fastrand::Rng::with_seed(5);
    let mut bent = 0;
    for _ in 0..5000 {
        let mut unit = || {
            let v = dvec3(any.f64(), any.f64(), any.f64()) * 2.0 - 1.0;
            UnitVec::new(v).unwrap_or(UnitVec::Z)
        };
        let (d, geometric_normal, shading_normal) = (unit(), unit(), unit());
        let material = glass(1.5);
        let hit = Hit { geometric_normal, shading_normal, material, ..any_hit };
        let parts = Parts::of(&Ray::new(-*d, *d * 3.0), &hit);
        let before =
            if geometric_normal.dot(*d) > 0.0 { -geometric_normal } else { geometric_normal };
        let (reflected, _) = parts.reflected.unwrap();
        assert!(before.dot(reflected) > 0.0, "{hit:?}");
        assert!(parts.refracted.is_none_or(|(way, _)| before.dot(way) < 0.0), "{hit:?}");
        bent += u32::from((reflected - optics::reflect(*d, geometric_normal)).length() > 1e-9);
    }
    assert!((500..4500).contains(&bent), "{bent}");
}

/// A mirror before two walls of the same color: samples are told apart by which
/// of them they saw.
#[test]
fn what_is_seen_in_a_mirror_tells_samples_apart() {
    let mirror = object(plane(-DVec3::Z, DVec3::Z), MIRROR);
    let walls = [1.0, -1.0].map(|x| {
        let min = dvec3(x - 0.99, -9.0, 9.0);
        let wall = AxisBox::new(min, min + dvec3(1.98, 18.0, 1.0)).unwrap();
        object(wall, Material::Constant(GRAY))
    });
    let scene = scene([vec![mirror], Vec::from(walls)].concat(), 5);
    let trail = |x: f64, skipping| {
        let work = Work::new(Unmetered, skipping, 1);
        let ray = Ray::new(DVec3::ZERO, dvec3(x, 0.0, -1.0));
        let look = scene.trace_among(Candidates::All, &ray, Interval::AHEAD, &work);
        assert_eq!((look.color, look.surface.unwrap().0), (GRAY, crate::ObjectId(0)));
        look.shadows
    };
    let on = Skipping::On;
    assert_eq!(trail(0.05, on), trail(0.06, on));
    assert_ne!(trail(0.05, on), trail(-0.05, on));
    assert_eq!(trail(0.05, on), trail(0.05, Skipping::Off));
}
