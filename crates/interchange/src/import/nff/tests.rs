//! NFF files, ugly ones first.

use std::fmt::Write as _;

use scene::NoAssets;
use scene::format::{Camera, Light, Material, Object};

use super::Reader;
use crate::import::text::Text;
use crate::import::{Imported, Lost, Source, Unreadable, Wishes, import};

const VIEW: &str = "b 0.1 0.2 0.3\nv\nfrom 0 -5 0\nat 0 0 0\nup 0 0 1\nangle 45\nhither 1\n\
                    resolution 64 48\n";

fn read(text: &str) -> Result<Imported, Vec<Unreadable>> {
    import(
        Source { name: "dir/my.balls.nff", bytes: text.as_bytes() },
        &Wishes::default(),
        &NoAssets,
    )
}

fn with(more: &str) -> Result<Imported, Vec<Unreadable>> {
    read(&format!("{VIEW}{more}"))
}

/// The problems of elements after the view, whose first line is 9.
#[track_caller]
fn refuses(more: &str, expected: &[&str]) {
    let problems = with(more).unwrap_err();
    let line = |p: &Unreadable| match p.place {
        Some((line, column)) => format!("{line}:{column}: {}", p.message),
        None => p.message.clone(),
    };
    let found: Vec<_> = problems.iter().map(line).collect();
    let fit = found.iter().zip(expected).all(|(found, expected)| found.contains(expected));
    assert!(fit && found.len() == expected.len(), "{found:#?}");
}

/// What is lost of elements after the view.
#[track_caller]
fn loses(more: &str, expected: &[&str]) -> Imported {
    let imported = with(more).unwrap();
    let line = |lost: &Lost| {
        let (line, column) = lost.place.unwrap_or_default();
        format!("{line}:{column}: {}: {}", lost.element, lost.what)
    };
    let found: Vec<_> = imported.lost.iter().map(line).collect();
    let fit = found.iter().zip(expected).all(|(found, expected)| found.contains(expected));
    assert!(fit && found.len() == expected.len(), "{found:#?}");
    imported
}

/// The objects of elements after the view, which lose nothing.
#[track_caller]
fn check(more: &str, expected: &[Object]) {
    let imported = loses(more, &[]);
    assert_eq!(imported.scene.objects, expected, "{more}");
    imported.text("my.nff").unwrap();
}

#[test]
fn problems_are_told_all_at_once() {
    refuses("s 1 2 3", &["9:8: s, number 4 of 4: expected a number, found the end"]);
    refuses(
        "s 1 2\ns 0 0 0 x\ns 0 0 0 1\n5\ns 0 0 0 nan",
        &[
            "10:1: s, number 3 of 4: expected a number, found \"s\"",
            "10:9: s, number 4 of 4: expected a number, found \"x\"",
            "12:1: expected an element's letter, found \"5\"",
            "13:9: s, number 4 of 4: expected a number, found \"nan\"",
        ],
    );
    refuses("s 0 0 0 1e999", &["expected a finite number, found \"1e999\""]);
    refuses("s 0 0 0 0", &["9:1: s: `radius`"]);
    refuses("c 0 0 0 1 0 0 0 1", &["9:1: c: `"]);
    refuses("c 0 0 0 0 0 0 1 0", &["9:1: c: `radius`"]);
    refuses("b -1 0 0", &["9:1: b: `background`"]);
    refuses("l 0 0 0 -1 0 0", &["9:1: l: `intensity`"]);
    refuses("f 1 1 1 -1 0 0 0 1", &["expected Kd of 0 or more", "f: `diffuse`"]);
    refuses("f 1 1 1 1 -1 1 0 1", &["expected Ks of 0 or more"]);
    refuses("l 0 0 0\n1 1 1", &["10:1: expected an element's letter, found \"1\""]);
    refuses("p 2 0 0 0 1 1 1", &["9:1: p: expected a number of corners from 3 to 10000, found 2"]);
    refuses("p 1e9", &["from 3 to 10000"]);
    refuses("p 3.5", &["from 3 to 10000"]);
    refuses("p -3", &["from 3 to 10000"]);
    refuses("p 3 0 0 0 1 0 0\n", &["10:1: p, number 1 of 3: expected a number, found the end"]);
    refuses("p 4 0 0 0 2 2 0 2 0 0 0 3 0", &["the edges from corner 1 and from corner 3 cross"]);
    // Its halves are as large as each other and go around opposite ways.
    refuses(
        "p 4 -1 -1 0 1 1 0 1 -1 0 -1 1 0",
        &[
            "9:1: p: expected a border that does not cross itself, found that the edges from corner 1 \
           and from corner 3 cross",
        ],
    );
    let bow = "pp 4 -1 -1 0 0 0 1 1 1 0 0 0 1 1 -1 0 0 0 1 -1 1 0 0 0 1";
    refuses(bow, &["9:1: pp: expected a border that does not cross itself"]);
    let eight = "p 6 0 0 0 3 -1 0 3 1 0 0 0 0 -3 -1 0 -3 1 0";
    refuses(eight, &["9:1: p: expected a border with an inside"]);
    refuses("pp 3 0 0 0 0 0 0 1 0 0 0 0 1 0 1 0 0 0 1", &["found one of length 0"]);
    refuses("p 3 0 0 0 1e300 0 0 0 1e300 0", &["9:1: p: `b`", "9:1: p: `c`"]);
    let many = "s 0 0 0 1\n".repeat(110_000);
    refuses(&many, &["expected at most 104857 spheres"]);
}

#[test]
fn a_view_is_needed() {
    let problems = read("s 0 0 0 1").unwrap_err();
    assert!(problems[0].message.contains("expected a viewpoint with a resolution"));
    let problems = read("v\nresolution 4 3\nfrom 0 0 1\nup 0 1 0").unwrap_err();
    let expected = "expected a viewpoint with from, at, up and angle, found no at, angle";
    assert_eq!(problems[0].message, expected);
    for (from, to, found) in [
        ("angle 45", "angle 180", "an angle between 0 and 180"),
        ("angle 45", "angle 0", "an angle between 0 and 180"),
        ("64 48", "64 1", "across 1"),
        ("64 48", "64.5 48", "two whole numbers"),
        ("64 48", "0 48", "two whole numbers"),
        ("64 48", "64 99999", "resolution: `"),
        ("at 0 0 0", "at 0 -5 0", "v: `view_dir`"),
        ("up 0 0 1", "up 0 1 0", "v: `"),
    ] {
        let problems = read(&VIEW.replace(from, to)).unwrap_err();
        assert!(problems.iter().all(|p| p.message.contains(found)), "{to}: {problems:?}");
    }
    let camera = Wishes::camera("LookAt(eye: (0, 0, 5), at: (0, 0, 0), fov_deg: 40)").unwrap();
    let wishes = Wishes { camera: Some(camera), image: Some((8, 6)), shading: None };
    let bare = Source { name: "a.nff", bytes: b"s 0 0 0 1" };
    let imported = import(bare, &wishes, &NoAssets).unwrap();
    assert_eq!((imported.scene.camera, imported.scene.image), (camera, (8, 6)));
}

#[test]
fn what_is_not_known_is_lost() {
    loses("tpp 3 1 2 3\n4 5 6\ns 0 0 0 1", &["9:1: tpp: is not known and is left out"]);
    loses("k 1 2 3\n\n hidden a b\n", &["9:1: k: is not known", "11:2: hidden: is not known"]);
    loses("s 0 0 0 -1", &["9:1: s: a negative radius asks for the inside alone"]);
    loses("c 0 0 0 -1 0 0 1 -1", &["c: a negative radius"]);
    loses("c 0 0 0 1 0 0 1 0.5", &["c: a cone that is cut off at the top"]);
    loses("b 0 0 0", &["9:1: b: stands twice"]);
    loses("v\nangle 30", &["9:1: v: stands twice"]);
    loses("f 1 1 1 1 1 0 0 1", &["a highlight of the exponent 0"]);
}

#[test]
fn fills_mirror_and_let_through_their_shares() {
    #[track_caller]
    fn check(numbers: &str, specular: f64, exponent: f64, (ks, t, ior): (f64, f64, f64)) {
        let imported = loses(&format!("f 1 0.5 0 {numbers}\ns 0 0 0 1"), &[]);
        let whitted = Material::Whitted {
            diffuse: Some([0.5, 0.25, 0.0]),
            specular: [specular; 3],
            exponent,
            reflect: [ks; 3],
            transmit: [t; 3],
            ior,
            schlick: false,
            texture: None,
        };
        assert_eq!(imported.scene.materials["f1"], whitted, "{numbers}");
        let said = imported.chosen.join("; ");
        assert!(said.contains("rays are followed over 5 surfaces"), "{said}");
        assert_eq!(imported.scene.bounces, 5);
        imported.text("my.nff").unwrap();
    }
    check("0.5 0.25 8 0.125 1.5", 0.25, 8.0, (0.25, 0.125, 1.5));
    check("0.5 0 0 0.125 1.5", 0.0, 1.0, (0.0, 0.125, 1.5));
    // The index has no bearing where nothing goes through, and is often 0.
    check("0.5 0.25 8 0 0", 0.25, 8.0, (0.25, 0.0, 1.0));
    refuses("f 1 1 1 1 0 0 0.5 0", &["9:1: f: `ior`"]);
    refuses("f 1 1 1 1 1.5 3 0 1", &["9:1: f: `reflect`"]);
    refuses("f 1 1 1 1 0 3 -0.5 1", &["expected T of 0 or more"]);
    // What says neither stays as it is.
    let plain = loses("f 1 1 1 0.5 0 9 0 0\ns 0 0 0 1", &[]);
    assert_eq!(
        plain.scene.materials["f1"],
        Material::Lambert { diffuse: Some([0.5; 3]), texture: None }
    );
    assert!(!plain.chosen.join("; ").contains("Whitted"));
}

#[test]
fn the_angle_is_between_the_middles_of_rows() {
    let scene = with("").unwrap().scene;
    assert_eq!((scene.image, scene.background), ((64, 48), [0.1, 0.2, 0.3]));
    let Camera::Perspective { view_dir, view_up, view_width, view_height, .. } = scene.camera
    else {
        panic!("perspective")
    };
    assert_eq!((view_dir, view_up), ([0.0, 5.0, 0.0], [0.0, 0.0, 1.0]));
    // The middle of the top row is seen under half the angle.
    let middle = view_height / 2.0 * (47.0 / 48.0);
    assert!((middle - (22.5_f64).to_radians().tan()).abs() < 1e-15);
    assert!((view_width / 64.0 - view_height / 48.0).abs() < 1e-16, "square pixels");
}

#[test]
fn lights_share_what_the_format_says() {
    #[track_caller]
    fn check(more: &str, expected: &[f64]) {
        let lights = with(more).unwrap().scene.lights;
        let red = |light: &Light| match light {
            Light::Point { intensity, .. } => intensity[0],
            _ => -1.0,
        };
        let found: Vec<_> = lights.iter().map(red).collect();
        assert_eq!(found, expected, "{more}");
    }
    check("", &[]);
    check("l 1 2 3", &[0.5]);
    check("l 1 2 3\nl 1 2 3\nl 1 2 3\nl 1 2 3", &[0.25; 4]);
    check("l 1 2 3 0.75 1 1\nl 1 2 3\nl 0 0 0 # 1 1 1\nl 0 0 0\n", &[0.75, 0.25, 0.25, 0.25]);
}

#[test]
fn shapes_become_objects() {
    let (o, z) = ([0.0; 3], [0.0, 0.0, 1.0]);
    let white = |object: Object| [object];
    check(
        "s 0 0 1 0.5 # a ball",
        &white(Object::Sphere { center: z, radius: 0.5, material: None }),
    );
    let tube = Object::Cylinder { a: o, b: z, radius: 0.5, open: true, material: None };
    check("c 0 0 0 0.5\n  0 0 1 0.5\n", &white(tube.clone()));
    check("c 0 0 0 0.5 0 0 1 0.5", &white(tube));
    let cone = Object::Cone { apex: z, base: o, radius: 0.5, open: true, material: None };
    check("c 0 0 0 0.5 0 0 1 0", &white(cone.clone()));
    check("c 0 0 1 0 0 0 0 0.5", &white(cone));
    let triangle = |b, c| Object::Triangle { a: o, b, c, material: None };
    let (x, y, xy) = ([1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.0]);
    check("p 4\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n", &[triangle(x, xy), triangle(xy, y)]);
    check("p 3 0 0 0 1 1 1 2 2 2", &[]);
    check("p 4 0 0 0 2 2 2 1 1 1 3 3 3", &[]);
}

#[test]
fn equal_fills_are_one_material() {
    let fills = "f 1 1 1 0.5 0 0 0 0\ns 0 0 0 1\nf 0 1 0 0.5 0 9 0 1\ns 0 0 0 1\n\
                 f 1 1 1 0.5 0 0 0 1\ns 0 0 0 1\n";
    let scene = loses(fills, &[]).scene;
    let named = |object: &Object| object.material().cloned();
    let expected = ["f1", "f2", "f1"].map(|name| Some(Material::Named(name.to_owned())));
    assert_eq!(scene.objects.iter().map(named).collect::<Vec<_>>(), expected);
    assert_eq!(
        scene.materials["f2"],
        Material::Lambert { diffuse: Some([0.0, 0.5, 0.0]), texture: None }
    );
}

#[test]
fn polygons_that_take_too_much_work_are_a_problem_once() {
    // A long spiral, where everything is within the box of every turn.
    let n = 3_000_i32;
    let corner = |i: i32, r: f64| {
        let (sin, cos) = libm::sincos(f64::from(i) * 0.05);
        let r = r + f64::from(i) * 0.01;
        format!("{:?} {:?} 0\n", r * cos, r * sin)
    };
    let out = (0..n).map(|i| corner(i, 2.0));
    let border: String = out.chain((0..n).rev().map(|i| corner(i, 1.5))).collect();
    let polygon = format!("p {}\n{border}", 2 * n);
    let written = format!("{VIEW}{polygon}s 0 0\n{polygon}p 3\n0 0 0\n1 0 0\n0 1 0\n");
    let text = Text::of(written.as_bytes()).unwrap();
    let mut reader = Reader::new(&text, "a.nff").unwrap();
    reader.polygons.cutter = crate::polygon::Cutter::spent();
    let problems = reader.scene(&Wishes::default()).unwrap_err();
    let said: Vec<_> = problems.iter().map(|problem| problem.message.as_str()).collect();
    assert_eq!(said.len(), 2, "{said:?}");
    assert!(said[0].starts_with("p: expected polygons that are cut with less work"), "{said:?}");
    assert!(said[1].starts_with("s, number 3 of 4"), "{said:?}");
    // There is enough for as many as a file has that somebody made.
    assert!(with(&polygon.repeat(3)).is_ok());
}

#[test]
fn many_polygons_become_a_mesh_and_patches_always_do() {
    let mut fan = String::new();
    for i in 0..40 {
        let next = i + 1;
        write!(fan, "p 3\n0 0 0\n1 {next} 0.1\n0.30000000000000004 1e-7 {i}.5\n").unwrap();
    }
    let imported = loses(&format!("f 1 1 1 1 0 0 0 1\n{fan}"), &[]);
    let file = "my-f1-polygons.obj".to_owned();
    let material = Some(Material::Named("f1".to_owned()));
    let mesh = Object::Mesh { file: file.clone(), flat: false, material };
    assert_eq!(imported.scene.objects, [mesh]);
    let obj = String::from_utf8(imported.files[&file].clone()).unwrap();
    assert!(
        obj.starts_with("v 0.0 0.0 0.0\nv 1.0 1.0 0.1\nv 0.30000000000000004 1e-7 0.5\n"),
        "{obj}"
    );
    assert!(obj.ends_with("f 118 119 120\n"), "{obj}");
    imported.text("my.nff").unwrap();

    let patch = "pp 4\n0 0 0 0 0 1\n1 0 0 0 0.5 1\n1 1 0 0 0 1\n0 1 0 -1 0 1\n";
    let imported = loses(patch, &[]);
    let obj = String::from_utf8(imported.files["my-plain-patches.obj"].clone()).unwrap();
    assert!(obj.contains("vn 0.0 0.5 1.0\n"), "{obj}");
    assert!(obj.ends_with("f 1//1 2//2 3//3\nf 1//1 3//3 4//4\n"), "{obj}");
    imported.text("my.nff").unwrap();
}

#[test]
fn what_the_format_leaves_open_is_said() {
    let said = with("l 1 2 3\nf 1 1 1 1 1 3 0 1\np 3 0 0 0 1 0 0 0 1 0").unwrap().chosen.join("\n");
    for expected in ["hither distance of 1.0", "sqrt(n)/(2n) = 0.5", "Blinn-Phong", "both sides"] {
        assert!(said.contains(expected), "{expected}: {said}");
    }
}
