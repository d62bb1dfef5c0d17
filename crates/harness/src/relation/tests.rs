//! Each relation met by a scene, and broken by what it is there to find.

use scene::NoAssets;
use scene::format::Object;
use tracer::accel::Build;
use tracer::glam::DVec3;
use tracer::{Rgb, Size};

use super::*;

mod sense;
mod textured;

/// Nothing in it is its own image in any way: each shape, groups in groups,
/// lights of each kind, shadows, a camera that looks from nowhere special.
const SCENE: &str = r#"(
    version: 1, image: (24, 20),
    camera: Perspective(view_point: (1, 2, 7), view_dir: (-0.2, -0.25, -1), view_up: (0.1, 1, 0),
        view_width: 1.2, view_height: 0.9, proj_distance: 1.4),
    shading: Attenuated,
    background: (0.05, 0.1, 0.2),
    materials: { "gold": BlinnPhong(diffuse: (0.8, 0.5, 0.1), specular: (0.5, 0.5, 0.5), exponent: 9) },
    objects: [
        Plane(point: (0, -1, 0), normal: (0.1, 1, 0.05), material: Lambert(diffuse: (0.6, 0.6, 0.5))),
        Sphere(center: (-1.2, 0.2, 0.3), radius: 0.7, material: Named("gold")),
        Triangle(a: (0.2, 1.1, -1), b: (1.9, 1.4, -0.7), c: (0.7, 2.1, -0.9)),
        Disk(center: (-0.4, 1.3, 0), normal: (1, 0.5, 2), radius: 0.35, material: Constant(color: (0.3, 0.9, 0.4))),
        Cylinder(a: (-1.8, -0.8, 1.4), b: (-1.3, -0.6, 1.9), radius: 0.2),
        Cone(apex: (0.6, 0.9, 1), base: (0.3, -0.1, 1.2), radius: 0.3, open: true),
        Torus(center: (1.6, 0.5, 0.4), axis: (0.3, 1, 0.4), major_radius: 0.5, minor_radius: 0.15),
        Group(
            transform: [Scale(0.7, 0.4, 0.5), RotateDeg(10, 25, 40), Translate(0.9, -0.4, 1.1)],
            objects: [
                Box(min: (-0.5, -0.7, -0.9), max: (0.8, 0.6, 0.4), material: Named("gold")),
                Group(transform: [Translate(-1.4, 0.2, 0.4)], objects: [Sphere(center: (0, 0, 0), radius: 0.6)]),
            ],
        ),
        Box(min: (-0.6, -0.9, -1.3), max: (-0.1, 0.4, -0.6)),
    ],
    lights: [
        Point(position: (3, 5, 4), intensity: (25, 24, 22)),
        Point(position: (-4, 3, 2), intensity: (0.3, 0.4, 0.6), falloff: Constant),
        Directional(direction: (0.4, -1, -0.7), intensity: (0.2, 0.2, 0.3)),
        Ambient(intensity: (0.05, 0.05, 0.06)),
    ],
)"#;

/// One of each, by which [`SCENE`] has to stand.
const RELATIONS: &[&str] = &[
    "Translate(by: (1, -2, 4))",
    "QuarterTurn(axis: X)",
    "QuarterTurn(axis: Y)",
    "QuarterTurn(axis: Z)",
    "Mirror(axis: X)",
    "Mirror(axis: Y)",
    "Mirror(axis: Z)",
    "ScaleUnits(by: 3)",
    "ScaleWindow(by: 3)",
    "SplitBoxes()",
    "FlattenGroups()",
    "PermuteObjects()",
    "SumOfLights()",
    "Exposure(by: 2)",
    "Exposure(by: 0.3)",
    "Crop(at: (3, 11), size: (14, 8))",
    "IdentityGroup",
    "Threads",
    "NoAccelerator",
    "NoSkipping",
];

/// The scene held to this relation.
fn text(scene: &str, relation: &str) -> String {
    let (all, _) = scene.rsplit_once(')').unwrap();
    format!("{}, check: (relations: [{relation}]))", all.trim_end().trim_end_matches(','))
}

fn fixture(scene: &str, relation: &str) -> Fixture {
    Fixture::read("a", &text(scene, relation), &NoAssets, Build::Bvh).unwrap()
}

/// What is said of this picture.
fn said(fixture: &Fixture, picture: &LinearImage) -> Result<(), String> {
    fixture.check.relations[0].check(fixture, picture).map_err(|broken| broken.to_string())
}

#[track_caller]
fn holds(scene: &str, relation: &str) {
    let fixture = fixture(scene, relation);
    assert_eq!(said(&fixture, &fixture.render_linear()), Ok(()), "{relation}");
}

/// The picture with one pixel lighter by a part of it.
fn doctored(picture: &LinearImage, at: (u32, u32), by: f64) -> LinearImage {
    let pixel = |x, y| picture.get(x, y).unwrap() * if (x, y) == at { 1.0 + by } else { 1.0 };
    LinearImage::from_fn(picture.size(), pixel)
}

#[test]
fn every_relation_is_tried() {
    for name in Relation::NAMES {
        assert!(RELATIONS.iter().any(|r| r.split('(').next() == Some(name)), "{name}");
    }
}

#[test]
fn a_good_scene_keeps_every_relation() {
    for relation in RELATIONS {
        holds(SCENE, relation);
    }
}

#[test]
fn one_pixel_that_is_off_by_a_millionth_breaks_every_relation() {
    for relation in RELATIONS {
        let fixture = fixture(SCENE, relation);
        let picture = doctored(&fixture.render_linear(), (9, 14), 1e-6);
        let why = said(&fixture, &picture).expect_err(relation);
        assert!(why.starts_with(&format!("relation {relation}: ")), "{why}");
        assert!(why.contains("expected [") && why.contains("; 1 of "), "{why}");
    }
}

#[test]
fn a_finding_names_relation_place_values_and_count() {
    let fixture = fixture(
        "(version: 1, image: (4, 2), background: (0.25, 0.5, 1),
            camera: Parallel(view_point: (0, 0, 5), view_width: 4, view_height: 2),
            objects: [Sphere(center: (0, 9, 0), radius: 1)])",
        "Translate(by: (1, 2, 4))",
    );
    let picture = LinearImage::from_fn(Size { width: 4, height: 2 }, |x, y| {
        Rgb::new(0.25, 0.5, 1.0) * if y == 1 && x > 1 { 2.0 } else { 1.0 }
    });
    assert_eq!(
        said(&fixture, &picture).unwrap_err(),
        "relation Translate(by: (1, 2, 4)): pixel (2, 1): expected [0.5, 1.0, 2.0], found \
         [0.25, 0.5, 1.0]; 2 of 8 pixels differ"
    );
}

#[test]
fn a_related_scene_that_is_refused_breaks_the_relation() {
    let fixture = fixture(SCENE, "Translate(by: (0, 1e200, 0.5))");
    assert_eq!(
        said(&fixture, &fixture.render_linear()).unwrap_err(),
        "relation Translate(by: (0, 1e200, 0.5)): the related scene is refused: `position`: \
         expected three finite numbers of at most 1e60, found (3, 1e200, 4.5); and 16 more"
    );
}

#[test]
fn four_quarter_turns_and_two_mirrors_are_none() {
    let file = fixture(SCENE, "Threads").file;
    for axis in [Axis::X, Axis::Y, Axis::Z] {
        let (turn, mirror) = (Motion::quarter_turn(axis), Motion::mirror(axis));
        // Groups keep their steps, so the pictures are compared, not the files.
        let turned = (0..4).fold(file.clone(), |file, _| turn.file(&file));
        let mirrored = mirror.file(&mirror.file(&file));
        assert_eq!((turned.camera, &turned.lights), (file.camera, &file.lights), "{axis:?}");
        assert_eq!(turned.objects[..7], file.objects[..7], "{axis:?}");
        assert_eq!((mirrored.camera, &mirrored.lights), (file.camera, &file.lights));
        assert_eq!(mirrored.objects[..7], file.objects[..7]);
        let fixture = fixture(SCENE, "Threads");
        let alike = Alike { within: 1e-12, edge_pixels: 0 };
        let found = fixture.render_related(&turned).unwrap();
        assert_eq!(alike.compare(&fixture.render_linear(), &found), Ok(()));
        assert_ne!(turn.file(&file), file);
    }
}

/// An object, a light or the camera that does not go along is noticed, whichever
/// it is: what a tracer does that knows some of them by the world's axes.
#[test]
fn what_stays_behind_is_noticed() {
    let fixture = fixture(SCENE, "Threads");
    let (file, picture) = (&fixture.file, fixture.render_linear());
    let motions = [
        Motion::translation([1.0, -2.0, 4.0]),
        Motion::quarter_turn(Axis::Y),
        Motion::mirror(Axis::X),
        Motion::scale(3.0),
    ];
    let alike = Alike { within: LOOSEST, edge_pixels: 2 };
    for motion in motions {
        let differs = |moved: &File| {
            let found = fixture.render_related(moved).unwrap();
            alike.compare(&motion.picture(file, &picture), &found).is_err()
        };
        let moved = motion.file(file);
        assert!(!differs(&moved));
        for i in 0..file.objects.len() {
            let mut stays = moved.clone();
            stays.objects[i] = file.objects[i].clone();
            assert!(differs(&stays), "{motion:?} {:?}", file.objects[i]);
        }
        for i in 0..2 {
            let mut stays = moved.clone();
            stays.lights[i] = file.lights[i];
            assert!(differs(&stays), "{motion:?} {:?}", file.lights[i]);
        }
        assert!(differs(&File { camera: file.camera, ..moved.clone() }), "{motion:?}");
    }
}

#[test]
fn colors_of_normals_turn_with_the_scene() {
    let normals = SCENE.replace("shading: Attenuated", "show: Normals, samples_per_pixel: 4");
    for axis in ["X", "Y", "Z"] {
        holds(&normals, &format!("QuarterTurn(axis: {axis})"));
        holds(&normals, &format!("Mirror(axis: {axis})"));
    }
    holds(&normals, "Translate(by: (0, 0, 1))");
    let depth = SCENE.replace("shading: Attenuated", "show: Depth(near: 4, far: 9)");
    holds(&depth, "ScaleUnits(by: 2)");
    let depth = fixture(&depth, "ScaleUnits(by: 2)").file;
    let moved = File { show: depth.show, ..Motion::scale(2.0).file(&depth) };
    let found = fixture(SCENE, "Threads").render_related(&moved).unwrap();
    let expected = fixture(SCENE, "Threads").render_related(&depth).unwrap();
    assert!(Alike { within: LOOSEST, edge_pixels: 2 }.compare(&expected, &found).is_err());
}

#[test]
fn every_camera_can_be_cropped() {
    let perspective = "Perspective(view_point: (1, 2, 7), view_dir: (-0.2, -0.25, -1), view_up: \
                       (0.1, 1, 0),\n        view_width: 1.2, view_height: 0.9, proj_distance: 1.4)";
    assert!(SCENE.contains(perspective));
    for camera in [
        "LookAt(eye: (1, 2, 7), at: (0, 0.1, 0), fov_deg: 40)",
        "Parallel(view_point: (1, 2, 7), view_dir: (-1, -2, -7), view_width: 5, view_height: 4)",
        "Parallel(view_point: (1, 2, 7), view_dir: (-1, -2, -7), proj_normal: (1, 0.4, 5), \
         view_width: 5, view_height: 4)",
        "Perspective(view_point: (1, 2, 7), view_dir: (-1, -2, -7), proj_normal: (1, 0.4, 5), \
         view_width: 1, view_height: 0.8, proj_distance: 1.3)",
    ] {
        let scene = SCENE.replace(perspective, camera);
        for crop in
            ["at: (0, 0), size: (5, 4)", "at: (22, 18), size: (2, 2)", "at: (4, 2), size: (20, 9)"]
        {
            holds(&scene, &format!("Crop({crop})"));
        }
        if !camera.starts_with("Parallel") {
            holds(&scene, "ScaleWindow(by: 0.3)");
        }
    }
}

#[test]
fn boxes_become_triangles_that_face_outward() {
    let file = fixture(SCENE, "SplitBoxes()").file;
    let split = SplitBoxes::related(&file);
    let count = |file: &File| {
        let all = objects::all(&file.objects);
        let boxes = all.iter().filter(|o| matches!(o, Object::Box { .. })).count();
        let triangles = all.iter().filter(|o| matches!(o, Object::Triangle { .. })).count();
        (boxes, triangles)
    };
    assert_eq!((count(&file), count(&split)), ((2, 1), (0, 25)));
    // Each triangle is half a face, and faces away from the middle.
    let (min, max) = (DVec3::new(-0.6, -0.9, -1.3), DVec3::new(-0.1, 0.4, -0.6));
    let mut areas = DVec3::ZERO;
    for object in &split.objects[split.objects.len() - 12..] {
        let Object::Triangle { a, b, c, .. } = object else { panic!("{object:?}") };
        let [a, b, c] = [a, b, c].map(|p| DVec3::from_array(*p));
        let (normal, out) = ((b - a).cross(c - a), (a + b + c) / 3.0 - 0.5 * (min + max));
        assert_eq!((normal.abs().cmpgt(DVec3::ZERO)).bitmask().count_ones(), 1);
        assert!(normal.dot(out) > 0.0, "{object:?}");
        areas += 0.5 * normal.abs();
    }
    let size = max - min;
    let faces = 2.0 * DVec3::new(size.y * size.z, size.x * size.z, size.x * size.y);
    assert!((areas - faces).length() < 1e-12, "{areas} {faces}");
}

#[test]
fn shapes_are_put_where_their_groups_put_them() {
    let file = fixture(SCENE, "Threads").file;
    let (flat, taken_out) = FlattenGroups::related(&file);
    // The box; the ball is no ball any more.
    assert_eq!((taken_out, flat.objects.len()), (1, 7 + 12 + 1 + 1));
    let inside = |steps: &str| {
        let own = "Translate(0.9, -0.4, 1.1)],\n            objects: [";
        assert!(SCENE.contains(own));
        let all = "Plane(point: (0, -1, 0), normal: (0, 1, 0.1)), Sphere(center: (0.3, 0.2, 0), \
                   radius: 0.5), Disk(center: (0.5, 0.4, 1), normal: (1, 2, 3), radius: 0.6), \
                   Cone(apex: (-1, 1, 0), base: (-1, 0, 0.5), radius: 0.4, open: true), \
                   Torus(center: (1, 0.5, 0), axis: (1, 1, 2), major_radius: 0.5, minor_radius: \
                   0.2), Cylinder(a: (0, -1, 1), b: (0.4, -0.6, 1.2), radius: 0.3, open: true), \
                   Triangle(a: (0, 0, 1.5), b: (1, 0.2, 1.5), c: (0.2, 0.9, 1.2)),";
        let grown = SCENE.replace(own, &format!("{own}{all}"));
        grown.replace("Scale(0.7, 0.4, 0.5)", steps)
    };
    for (steps, expected) in
        [("Scale(0.8, 0.8, 0.8)", 9), ("Scale(-0.8, 0.8, 0.8)", 9), ("Scale(0.8, 0.9, -0.8)", 3)]
    {
        let scene = inside(steps);
        assert_eq!(FlattenGroups::related(&fixture(&scene, "Threads").file).1, expected, "{steps}");
        holds(&scene, "FlattenGroups()");
        let normals = scene.replace("shading: Attenuated", "show: Normals");
        holds(&normals, "FlattenGroups()");
    }
    // Each step counts, and their order.
    let picture = fixture(SCENE, "Threads").render_linear();
    for (from, to) in [
        ("RotateDeg(10, 25, 40)", "RotateDeg(25, 10, 40)"),
        (
            "Scale(0.7, 0.4, 0.5), RotateDeg(10, 25, 40)",
            "RotateDeg(10, 25, 40), Scale(0.7, 0.4, 0.5)",
        ),
        ("Translate(0.9, -0.4, 1.1)", "Translate(0.9, -0.4, 1.2)"),
    ] {
        let other = SCENE.replace(from, to);
        assert!(said(&fixture(&other, "FlattenGroups()"), &picture).is_err(), "{from}");
    }
}

#[test]
fn the_second_of_two_surfaces_at_one_place_is_a_tie() {
    let tie = "(version: 1, image: (20, 20),
        camera: Parallel(view_point: (0, 0, 5), view_width: 20, view_height: 20),
        objects: [
            Box(min: (-9, -9, 0), max: (9, 9, 0), material: Constant(color: (1, 0, 0))),
            Box(min: (0, 0, 0), max: (1, 2, 0), material: Constant(color: (0, 1, 0))),
        ])";
    let fixture = fixture(tie, "PermuteObjects()");
    let why = said(&fixture, &fixture.render_linear()).unwrap_err();
    assert!(why.ends_with("; 2 of 400 pixels differ"), "{why}");
    holds(tie, "PermuteObjects(edge_pixels: 2)");
}
