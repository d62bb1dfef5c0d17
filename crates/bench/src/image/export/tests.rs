//! What is exported, and what is refused.

use super::*;
use crate::image::scenes::{Source, all};

fn source(objects: &str) -> Source {
    let text = format!(
        "(version: 1, image: (640, 480), shading: Radiometric, \
         camera: LookAt(eye: (0, 0, 5), at: (0, 0, 0), fov_deg: 90), objects: [{objects}], \
         lights: [Point(position: (1, 2, 3), intensity: (4, 5, 6))])"
    );
    let mut mesh = Triangles::default();
    mesh.add(&[[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.5]]);
    let meshes = BTreeMap::from([("a.ply".to_owned(), mesh)]);
    Source { name: "test", about: "", text, meshes, is_disk: false }
}

const EACH: &str = "
    Sphere(center: (1, 2, 3), radius: 0.5, material: Lambert(diffuse: (0.1, 0.2, 0.3))),
    Box(min: (0, 0, 0), max: (1, 1, 1), material: Lambert(diffuse: (0.5, 0.5, 0.5))),
    Triangle(a: (0, 0, 0), b: (1, 0, 0), c: (0, 1, 0), material: Lambert(diffuse: (0.5, 0.5, 0.5))),
    Disk(center: (0, 1, 0), normal: (0, 2, 0), radius: 7, material: Constant(color: (1, 0, 0.5))),
    Cylinder(a: (0, 0, 0), b: (0, 1, 0), radius: 0.1, material: Lambert(diffuse: (1, 1, 1))),
    Mesh(file: \"a.ply\", flat: true, material: Lambert(diffuse: (1, 1, 0))),
";

#[test]
fn povray_is_told_every_object() {
    let source = source(EACH);
    let read = source.read(None).unwrap();
    let text = povray(&Model::new(&read, &source.meshes).unwrap());
    let lines: Vec<_> = text.lines().collect();
    let expected = [
        "sphere { <1,2,3>,0.5 pigment { rgb <0.1,0.2,0.3> } }",
        "box { <0,0,0>,<1,1,1> pigment { rgb <0.5,0.5,0.5> } }",
        "triangle { <0,0,0>,<1,0,0>,<0,1,0> pigment { rgb <0.5,0.5,0.5> } }",
        "disc { <0,1,0>,<0,2,0>,7 pigment { rgb <1,0,0.5> } finish { diffuse 0 emission 1 } }",
        "cylinder { <0,0,0>,<0,1,0>,0.1 pigment { rgb <1,1,1> } }",
        "mesh2 {",
        "  vertex_vectors { 3, <0,0,0>,<1,0,0>,<0,1,0.5> }",
        "  face_indices { 1, <0,1,2> }",
        "pigment { rgb <1,1,0> } }",
    ];
    assert_eq!(lines[lines.len() - expected.len()..], expected);
    let light = lines.iter().find(|line| line.starts_with("light_source")).unwrap();
    // 4 / (2 pi 1e-6): what is left at the distance r is 4 / pi / r^2.
    assert!(light.starts_with("light_source { <1,2,3> rgb <636619.77"), "{light}");
    let camera = lines.iter().find(|line| line.starts_with("camera")).unwrap();
    let numbers: Vec<f64> =
        camera.split(['<', ',', '>']).filter_map(|word| word.parse().ok()).collect();
    // Height 2 at distance 1 is 90 degrees.
    let expected = [0.0, 0.0, 5.0, 0.0, 0.0, -1.0, 8.0 / 3.0, 0.0, 0.0, 0.0, 2.0, 0.0];
    assert_eq!(numbers.len(), expected.len(), "{camera}");
    assert!(numbers.iter().zip(expected).all(|(x, y)| (x - y).abs() < 1e-12), "{camera}");
}

#[test]
fn mitsuba_is_told_every_object_and_flat_ones_at_once() {
    let source = source(EACH);
    let read = source.read(None).unwrap();
    let files = mitsuba(&Model::new(&read, &source.meshes).unwrap());
    let names: Vec<_> = files.keys().map(String::as_str).collect();
    assert_eq!(names, ["a.ply", "flat-0.ply", "scene.xml"]);
    // The box and the triangle are of the same stuff.
    let flat = String::from_utf8_lossy(&files["flat-0.ply"]).into_owned();
    assert!(flat.contains("element face 13\n"), "{flat}");
    let text = String::from_utf8(files["scene.xml"].clone()).unwrap();
    let count = |what: &str| text.matches(what).count();
    let kinds = ["sphere", "disk", "cylinder", "ply"].map(|kind| {
        let shape = format!("<shape type=\"{kind}\">");
        count(&shape)
    });
    // A cylinder has two disks at its ends.
    assert_eq!(kinds, [1, 3, 1, 2]);
    for part in [
        "<emitter type=\"area\"><rgb name=\"radiance\" value=\"1, 0, 0.5\"/></emitter>",
        "<point name=\"center\" x=\"1\" y=\"2\" z=\"3\"/><float name=\"radius\" value=\"0.5\"/>",
        "<point name=\"position\" x=\"1\" y=\"2\" z=\"3\"/><rgb name=\"intensity\" value=\"4, 5, 6\"/>",
        "<scale value=\"7\"/><lookat origin=\"0, 1, 0\" target=\"0, 2, 0\"",
    ] {
        assert_eq!(count(part), 1, "{part} in {text}");
    }
    assert_eq!(count("<"), count(">"));
    assert_eq!(count("<shape"), count("</shape>"));
}

#[test]
fn all_scenes_are_exported() {
    for source in all() {
        let read = source.read(None).unwrap();
        let model = Model::new(&read, &source.meshes).unwrap();
        assert!(povray(&model).len() > 100 && !mitsuba(&model).is_empty(), "{}", source.name);
    }
}

#[test]
fn what_others_cannot_show_alike_is_refused() {
    #[track_caller]
    fn check(source: &Source, expected: &str) {
        let read = source.read(None).unwrap();
        let why = Model::new(&read, &source.meshes).err().unwrap();
        assert!(why.contains(expected), "{why}");
    }
    check(&source("Plane(point: (0, 0, 0), normal: (0, 1, 0))"), "found Plane");
    check(&source("Sphere(center: (0, 0, 0), radius: 1, material: Normal)"), "found Some(Normal)");
    let other = |from: &str, to: &str| {
        let source = source("");
        Source { text: source.text.replace(from, to), ..source }
    };
    check(&other("Radiometric", "Classic"), "`Radiometric`");
    check(
        &other("Point(position: (1, 2, 3), intensity: (4, 5, 6))", "Ambient(intensity: (1, 1, 1))"),
        "point lights",
    );
    check(
        &other(
            "LookAt(eye: (0, 0, 5), at: (0, 0, 0), fov_deg: 90)",
            "Parallel(view_point: (0, 0, 0))",
        ),
        "perspective",
    );
    check(
        &other(
            "LookAt(eye: (0, 0, 5), at: (0, 0, 0), fov_deg: 90)",
            "Perspective(view_point: (0, 0, 0))",
        ),
        "square",
    );
}
