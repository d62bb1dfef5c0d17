//! The place of a value by its path, and which values are doubtful.

use super::super::{Step, Tree, diagnose};
use super::schema::Scene;
use super::{GOOD, ODD};

/// A path as it is written in messages: `a.b[1]["key"]`.
fn path(text: &'static str) -> Vec<Step> {
    let mut steps = Vec::new();
    for part in text.split(['.', '[']).filter(|part| !part.is_empty()) {
        let inner = part.trim_end_matches(']');
        steps.push(match (part == inner, inner.parse::<usize>()) {
            (true, _) => Step::from(inner),
            (false, Ok(index)) => Step::from(index),
            (false, Err(_)) => Step::key(inner.trim_matches('"')),
        });
    }
    steps
}

#[track_caller]
fn check(text: &str, at: &'static str, value: &str) {
    let (tree, _) = Tree::read(text);
    let shown = |span: super::super::Span| text[span.start..span.end].to_owned();
    assert_eq!(shown(tree.locate(&path(at))), value, "{at}");
}

#[test]
fn values_are_found() {
    check(GOOD, "version", "1");
    check(GOOD, "image[1]", "48");
    check(GOOD, "camera.look_from[2]", "-3e0");
    check(GOOD, "camera.fov_deg", "Some(40.0)");
    check(GOOD, "materials[\"dark\"]", "Black");
    check(GOOD, "materials[\"mix\"][2]", "0.5");
    check(GOOD, "objects[0].radius", "1.0");
    check(GOOD, "objects[1].objects[2][0].radius", "2");
    check(ODD, "camera.focus[1]", "2");
    check(ODD, "objects[0].name", "Some \"x\"");
}

#[test]
fn what_is_left_out_is_near_what_is_there() {
    check(GOOD, "objects[0].color", "Sphere");
    check(GOOD, "objects[9].radius", "[");
    check(GOOD, "lights[0].color[1]", "(");
    check(GOOD, "materials[\"none\"].albedo", "{");
    check("1", "a", "1");
}

/// A scene with two objects, the second of which is `object`.
fn is_doubtful(object: &str, at: &'static str) -> bool {
    let text = super::objects(&format!("objects: [Group(objects: []), {object}]"));
    diagnose::<Scene>(&text).is_doubtful(&path(at))
}

#[test]
fn stand_ins_are_doubtful() {
    assert!(is_doubtful(
        "Sphere(center: (0,0,0), radius: x, material: \"a\")",
        "objects[1].radius"
    ));
    assert!(is_doubtful("Sphere(center: (0,0,0), material: \"a\")", "objects[1].radius"));
    assert!(is_doubtful(
        "Sphere(center: (0,0), radius: 1, material: \"a\")",
        "objects[1].center[2]"
    ));
    assert!(is_doubtful(
        "Sphere(center: (0,x,0), radius: 1, material: \"a\")",
        "objects[1].center"
    ));
    assert!(is_doubtful("Cone(radius: 1)", "objects[1].radius"));
    assert!(is_doubtful("Sphere(center: (0,0,0), \"a\")", "objects[1].radius"));
}

#[test]
fn what_is_written_is_not_doubtful() {
    let sphere = "Sphere(center: (0,x,0), radius: 1, material: \"a\", size: 1)";
    assert!(!is_doubtful(sphere, "objects[1].radius"));
    assert!(!is_doubtful(sphere, "objects[0]"));
    assert!(!is_doubtful(sphere, "image"));
    // A field that may be left out is not made up.
    assert!(!is_doubtful(sphere, "sky"));
    assert!(!is_doubtful(
        "Sphere(center: (0,0,0), raduis: 1, material: \"a\")",
        "objects[1].radius"
    ));
}
