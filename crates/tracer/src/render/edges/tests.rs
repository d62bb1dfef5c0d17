//! Edges: where something changes, and nowhere else.

use glam::{DVec3, dvec3};

use super::*;
use crate::accel::Build;
use crate::shape::{AxisBox, Plane, Sphere};
use crate::{
    Camera, Convention, Falloff, Filter, Group, Light, Material, Member, Object, Projection,
    Samples, SceneParts, Show, Transform, View,
};

const REACH: f64 = 1.0 / 64.0;

fn object(shape: impl Into<crate::shape::Shape>, color: Rgb) -> Member {
    Member::Object(Object::new(shape.into(), Material::Lambert { diffuse: color }))
}

/// 16 x 16 pixels of a quarter each, from above along parallel rays.
fn parts(members: Vec<Member>, lights: Vec<Light>) -> SceneParts {
    let view = View {
        view_point: DVec3::Z * 10.0,
        view_dir: DVec3::NEG_Z,
        view_up: DVec3::Y,
        proj_normal: None,
        view_width: 4.0,
        view_height: 4.0,
    };
    SceneParts {
        camera: Camera::new(&view, Projection::Parallel).unwrap(),
        size: Size { width: 16, height: 16 },
        samples: Samples::ONE,
        filter: Filter::BOX,
        error: None,
        world: Group::new(Transform::IDENTITY, members, Build::Bvh),
        lights,
        convention: Convention::Classic,
        shadows: true,
        bounces: 2,
        background: Rgb::BLACK,
        exposure: 2.0,
        show: Show::Shaded,
    }
}

/// The pixels that are edges, as columns and rows from the top.
fn found(parts: SceneParts, reach: f64) -> Vec<(usize, usize)> {
    let edges = edges(&Scene::new(parts).unwrap(), reach);
    let is_edge = |(_, edge): &(usize, &Option<Around>)| edge.is_some();
    edges.iter().enumerate().filter(is_edge).map(|(n, _)| (n % 16, n / 16)).collect()
}

fn square(x: f64) -> Member {
    let shape = AxisBox::new(dvec3(-9.0, -9.0, -1.0), dvec3(x, 9.0, 1.0)).unwrap();
    object(shape, Rgb::WHITE)
}

#[test]
fn a_border_is_an_edge_only_if_a_sample_is_near() {
    // Pixel 8 spans 0 to 0.25, its sample is at 0.125.
    #[track_caller]
    fn check(x: f64, columns: &[usize]) {
        let lit = vec![Light::ambient(Rgb::WHITE).unwrap()];
        let found = found(parts(vec![square(x)], lit), REACH);
        let expected: Vec<_> =
            (0..16).flat_map(|row| columns.iter().map(move |&column| (column, row))).collect();
        assert_eq!(found, expected, "{x}");
    }
    check(0.125 + 0.25 / 65.0, &[8]);
    check(0.125 - 0.25 / 65.0, &[8]);
    check(0.125 + 0.25 / 63.0, &[]);
    check(0.0, &[]);
    check(20.0, &[]);
}

#[test]
fn what_an_edge_shows_is_between_both_sides() {
    let lit = vec![Light::ambient(Rgb::new(0.25, 0.5, 1.0)).unwrap()];
    let scene = Scene::new(parts(vec![square(0.126)], lit)).unwrap();
    let edges = edges(&scene, REACH);
    let lit = Rgb::new(0.5, 1.0, 2.0);
    let around = Around { here: lit, low: Rgb::BLACK, high: lit, weight: 1.0 };
    assert_eq!(edges[8], Some(around), "exposed by 2");
}

#[test]
fn what_an_edge_shows_is_of_its_samples_alone() {
    #[track_caller]
    fn check(found: Option<Around>, weight: f64, [low, high]: [f64; 2]) {
        let found = found.unwrap();
        assert!((found.weight - weight).abs() < 1e-12, "{found:?}");
        assert!((found.low.b - low).abs() < 1e-12 && (found.high.b - high).abs() < 1e-12);
        assert!((found.here.b - low).abs() < 1e-12 || (found.here.b - high).abs() < 1e-12);
    }
    let around = |x: f64, samples: u32, filter: Filter, column: usize| {
        let samples = Samples::grid(samples).unwrap();
        let lit = vec![Light::ambient(Rgb::new(0.25, 0.25, 0.5)).unwrap()];
        let parts = SceneParts { samples, filter, ..parts(vec![square(x)], lit) };
        edges(&Scene::new(parts).unwrap(), REACH)[16 * 3 + column]
    };
    // Of four columns of samples in pixel 8 the second is at 0.09375.
    check(around(0.0938, 16, Filter::BOX, 8), 0.25, [0.0, 0.25]);
    // A tent of two pixels: the one sample of pixel 8 counts a half there, and a quarter beside.
    let tent = Filter::tent(2.0).unwrap();
    check(around(0.126, 1, tent, 8), 0.5, [0.0, 0.5]);
    check(around(0.126, 1, tent, 7), 0.25, [0.0, 0.25]);
    assert_eq!(around(0.126, 1, tent, 6), None);
    // Mitchell's counts against pixels that are farther away than one.
    let mitchell = Filter::mitchell(2.0).unwrap();
    let far = around(0.0626, 4, mitchell, 6).unwrap();
    assert!(far.low.b < -far.high.b && far.weight > 0.0, "{far:?}");
}

#[test]
fn round_things_have_no_edge_but_their_rim() {
    let ball = Sphere::new(dvec3(0.1, 0.03, 0.0), 1.5).unwrap();
    let lit = || vec![Light::directional(DVec3::NEG_ONE, Rgb::WHITE).unwrap()];
    let near = found(parts(vec![object(ball, Rgb::WHITE)], lit()), REACH);
    for (x, y) in near {
        let (a, b) = (x as f64 * 0.25 - 1.875, 1.875 - y as f64 * 0.25);
        let from_rim = (dvec3(a - 0.1, b - 0.03, 0.0).length() - 1.5).abs() / 0.25;
        assert!(from_rim < 0.2, "({x}, {y}) is {from_rim} pixels from the rim");
    }
    let all = found(parts(vec![object(ball, Rgb::WHITE)], lit()), 0.5);
    assert!((20..60).contains(&all.len()), "{}", all.len());
}

#[test]
fn a_crease_and_a_shadow_are_edges() {
    // A cube of 100 turned about y: its corner (0, 1) of x and z is the ridge.
    let cube = AxisBox::new(DVec3::ZERO, dvec3(100.0, 100.0, 100.0)).unwrap();
    let ridge = 100.0 * std::f64::consts::FRAC_1_SQRT_2;
    let turn = Transform::rotation_deg(dvec3(0.0, 45.0, 0.0)).unwrap();
    let there = Transform::translation(dvec3(0.124 - ridge, -50.0, -80.0)).unwrap();
    let cube = vec![object(cube, Rgb::WHITE)];
    let cube = Member::Group(Group::new(turn.then(there).unwrap(), cube, Build::Bvh));
    let lit = || vec![Light::ambient(Rgb::WHITE).unwrap()];
    let columns =
        |found: Vec<(usize, usize)>| found.into_iter().map(|(x, _)| x).collect::<Vec<_>>();
    assert_eq!(columns(found(parts(vec![cube], lit()), REACH)), [8; 16]);

    // The top of a wall left of x = -3 throws its shadow as far as x = 0.124.
    let floor = object(Plane::new(DVec3::ZERO, DVec3::Z).unwrap(), Rgb::WHITE);
    let wall = AxisBox::new(dvec3(-9.0, -9.0, 0.0), dvec3(-3.0, 9.0, 3.124)).unwrap();
    let sun = Light::directional(dvec3(1.0, 0.0, -1.0), Rgb::WHITE).unwrap();
    let lit = found(parts(vec![floor, object(wall, Rgb::WHITE)], vec![sun]), REACH);
    assert_eq!(columns(lit), [8; 16]);
}

#[test]
fn samples_filters_and_errors_widen_them() {
    let lit = || vec![Light::ambient(Rgb::WHITE).unwrap()];
    let columns = |parts: SceneParts| {
        let row = |found: Vec<(usize, usize)>| found.into_iter().filter(|&(_, y)| y == 3);
        row(found(parts, REACH)).map(|(x, _)| x).collect::<Vec<_>>()
    };
    // Samples of pixel 8 in halves: at 0.0625 and 0.1875.
    let halves = Samples::grid(4).unwrap();
    let four = |x: f64| SceneParts { samples: halves, ..parts(vec![square(x)], lit()) };
    assert_eq!(columns(four(0.0626)), [8]);
    assert_eq!(columns(four(0.1874)), [8]);
    assert_eq!(columns(four(0.126)), [0; 0]);
    let one = || parts(vec![square(0.126)], lit());
    let tent = |radius| SceneParts { filter: Filter::tent(radius).unwrap(), ..one() };
    // A sample in the middle of a pixel counts for those around it if they are nearer than that.
    assert_eq!(columns(tent(1.0)), [8]);
    assert_eq!(columns(tent(1.1)), [7, 8, 9]);
    assert_eq!(columns(SceneParts { error: Some(0.1), ..one() }), [8, 9]);
}

#[test]
fn a_lamp_without_shadow_makes_no_edge() {
    let lamp = Light::point(dvec3(-20.0, 0.0, 20.0), Rgb::WHITE, Falloff::Constant).unwrap();
    let floor = object(Plane::new(DVec3::ZERO, DVec3::Z).unwrap(), Rgb::WHITE);
    assert_eq!(found(parts(vec![floor], vec![lamp]), 0.5), []);
}
