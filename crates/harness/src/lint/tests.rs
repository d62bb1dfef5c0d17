//! Small suites that break each rule in turn.

use super::*;
use crate::{bless, store};

/// Two spheres and a light, in color; `{check}` is what it is held to.
const SPHERES: &str = r"(
    version: 1,
    image: (32, 24),
    camera: LookAt(eye: (0, 0, 6), at: (0, 0, 0), fov_deg: 40),
    background: (0.2, 0.3, 0.5),
    objects: [
        Sphere(center: (-0.8, 0, 0), radius: 0.7),
        Group(objects: [Sphere(center: (0.8, 0, 0), radius: 0.7)]),
    ],
    lights: [Directional(direction: (-1, -2, -2))],
)";

fn spheres(from: &str, to: &str) -> String {
    assert!(SPHERES.contains(from), "{from}");
    SPHERES.replace(from, to)
}

fn checked(check: &str) -> String {
    spheres("lights:", &format!("check: ({check}),\n    lights:"))
}

/// The findings of a suite of these fixtures, as `fixture:line rule`, all blessed.
fn findings(fixtures: &[(&str, &str)]) -> (Vec<String>, Vec<Finding>) {
    let folder = tempfile::tempdir().unwrap();
    for (name, text) in fixtures {
        let path = folder.path().join(format!("fixtures/{name}.ron"));
        store::write(&path, text.as_bytes()).unwrap();
    }
    let suite = Suite::open(folder.path()).unwrap();
    let selection = suite.select(&[]).unwrap();
    bless::bless(&suite, &selection, false).unwrap();
    let found = lint(&suite, &selection.fixtures, &Visible::default(), &|_| ()).unwrap();
    let short = found.iter().map(|f| format!("{}:{} {}", f.fixture, f.line, f.rule)).collect();
    (short, found)
}

#[track_caller]
fn check(fixtures: &[(&str, &str)], expected: &[&str]) {
    let (short, found) = findings(fixtures);
    assert_eq!(short, expected, "{found:#?}");
}

#[test]
fn a_good_fixture_has_no_findings() {
    check(&[("a", SPHERES)], &[]);
}

#[test]
fn what_cannot_be_asked_is_a_finding() {
    let folder = tempfile::tempdir().unwrap();
    let write = |path: &str, text: &str| store::write(&folder.path().join(path), text.as_bytes());
    write("fixtures/a.ron", SPHERES).unwrap();
    write("fixtures/b.ron", "(").unwrap();
    let suite = Suite::open(folder.path()).unwrap();
    let lint_all = || {
        let names = suite.select(&[]).unwrap().fixtures;
        let found = lint(&suite, &names, &Visible::default(), &|_| ()).unwrap();
        found.iter().map(|f| format!("{} {}", f.fixture, f.rule)).collect::<Vec<_>>()
    };
    assert_eq!(lint_all(), ["a matches", "b matches"]);
    let selection = suite.select(&["a".to_owned()]).unwrap();
    bless::bless(&suite, &selection, false).unwrap();
    assert_eq!(lint_all(), ["b matches"]);
    write("fixtures/a.ron", &spheres("radius: 0.7)]", "radius: 0.6)]")).unwrap();
    assert_eq!(lint_all(), ["a matches", "b matches"]);
}

#[test]
fn a_part_that_nobody_would_miss_is_found() {
    let behind = "Sphere(center: (0, 0, 9), radius: 1),\n        Group(";
    check(&[("a", &spheres("Group(", behind))], &["a:8 idle-part"]);
    let inside = "Group(objects: [Sphere(center: (-0.8, 0, 0), radius: 0.1), ";
    check(&[("a", &spheres("Group(objects: [", inside))], &["a:8 idle-part"]);
    let group = "Group(objects: [Sphere(center: (0, 0, 9), radius: 1)]),\n        Group(";
    check(&[("a", &spheres("Group(", group))], &["a:8 idle-part"]);
    let dark = "Ambient(intensity: (0, 0, 0)),\n        Directional";
    check(&[("a", &spheres("Directional", dark))], &["a:10 idle-part"]);
}

#[test]
fn what_is_said_to_be_idle_must_be() {
    let behind = "Sphere(center: (0, 0, 9), radius: 1),\n        Group(";
    let behind = |check: &str| checked(check).replace("Group(", behind);
    check(&[("a", &behind(r#"idle: {"objects[1]": "behind"}"#))], &[]);
    check(&[("a", &checked(r#"idle: {"objects[0]": "why"}"#))], &["a:10 idle-part"]);
    check(&[("a", &checked(r#"idle: {"objects[7]": "why"}"#))], &["a:10 idle-part"]);
    let (short, found) = findings(&[("a", &checked(r#"idle: {"light[0]": "why"}"#))]);
    assert_eq!(short, ["a:10 idle-part"]);
    assert!(found[0].help.contains("did you mean lights[0]?"), "{found:?}");
    let (short, _) = findings(&[("a", &checked(r#"idle: {"objects[0]": " "}"#))]);
    assert_eq!(short, ["a:1 matches"], "a reason is needed");
}

#[test]
fn one_reason_is_enough_for_a_group() {
    let group = "Group(objects: [Sphere(center: (0, 0, 9), radius: 1)]),\n        Group(";
    let text = checked(r#"idle: {"objects[1]": "behind"}"#).replace("Group(", group);
    check(&[("a", &text)], &[]);
}

#[test]
fn what_an_expectation_would_miss_is_tested() {
    // The limit catches next to nothing, the expectation sees the left ball.
    let limits = r#"limits: (max_abs: 254, reason: "a test")"#;
    let idle = |check: &str| {
        let text = checked(check).replace("version: 1", "version: 1, show: Silhouette");
        let (short, found) = findings(&[("a", &text)]);
        assert!(found.iter().all(|f| f.rule != MATCHES), "{found:?}");
        short.into_iter().filter(|s| s.ends_with("idle-part")).collect::<Vec<_>>()
    };
    let white = "Pixel(at: (11, 12), rgb: (255, 255, 255))";
    assert_eq!(idle(limits), ["a:7 idle-part", "a:8 idle-part", "a:11 idle-part"]);
    let expected = format!("{limits}, expect: [{white}]");
    assert_eq!(idle(&expected), ["a:8 idle-part", "a:11 idle-part"]);
}

/// The same picture, the scene written otherwise.
fn twin() -> String {
    spheres("Group(objects: [", "Group(transform: [Scale(1, 1, 1)], objects: [")
}

#[test]
fn two_fixtures_with_one_picture_are_told_once() {
    check(&[("a", SPHERES), ("b", &twin())], &["a:1 discriminability"]);
    let said = checked(r#"same_as: {"b": "a scale of 1"}"#);
    check(&[("a", &said), ("b", &twin())], &[]);
    // Said by either, or by a third.
    check(&[("a", &twin()), ("b", &checked(r#"same_as: {"a": "why"}"#))], &[]);
    let third = checked(r#"same_as: {"a": "why", "b": "why"}"#);
    check(&[("a", SPHERES), ("b", &twin()), ("c", &third)], &[]);
}

#[test]
fn what_is_said_to_be_the_same_must_be() {
    let other = spheres("radius: 0.7)]", "radius: 0.6)]");
    let said = |name: &str| checked(&format!(r#"same_as: {{"{name}": "why"}}"#));
    check(&[("a", &said("b")), ("b", &other)], &["a:10 discriminability"]);
    check(&[("a", &said("a"))], &["a:10 discriminability"]);
    let (short, found) = findings(&[("long/name", &said("b/name")), ("a/name", &other)]);
    assert_eq!(short, ["long/name:10 discriminability"]);
    assert!(found[0].help.contains("did you mean a/name?"), "{found:?}");
}

#[test]
fn a_loose_limit_is_found_by_every_rule() {
    let loose = checked(r#"limits: (ssim: 0.5, reason: "a test")"#);
    let other = spheres("(0.2, 0.3, 0.5)", "(0.21, 0.3, 0.5)");
    let (short, found) = findings(&[("a", &loose), ("b", &other)]);
    let count = |rule: &str| short.iter().filter(|s| **s == format!("a:10 {rule}")).count();
    assert!(count("visible-defect") > 3, "{found:#?}");
    assert_eq!((count("discriminability"), count("loose-limit")), (1, 1), "{found:#?}");
    // With a limit that catches next to nothing no part is tested.
    let blind = checked(r#"limits: (max_abs: 254, reason: "a test")"#);
    let (short, found) = findings(&[("a", &blind)]);
    assert!(short.iter().any(|s| s.ends_with("idle-part")), "{found:#?}");
}
