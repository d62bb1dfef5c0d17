//! Broken scene files, and what is said of them.

mod agreement;
mod layout;
mod messages;
mod paths;
#[expect(dead_code, reason = "most fields are only there to be read into")]
mod schema;
mod syntax;

use super::{Problem, diagnose, line_column};
use schema::Scene;
use serde::de::DeserializeOwned;

/// A file without mistakes that has something of everything.
const GOOD: &str = r#"#![enable(implicit_some)]
// A comment, with "quotes" and (brackets.
Scene(
    version: 1,
    image: (64, 48),
    camera: Perspective(
        look_from: (0, 1.5, -3e0),
        look_at: (0, 0, 0),
        fov_deg: Some(40.0),
    ),
    materials: {
        "red": Lambert(albedo: (0.8, 0.1, 0.1)),
        "glass": Dielectric(1.5), /* nested /* comment */ */
        r"mirror": Metal(albedo: (1, 1, 1), fuzz: 0.1),
        "dark": Black,
        "by name": Named("red"),
        "mix": Mix("red", "glass", 0.5),
        "paint": Paint(name: "oil \u{41}\n", layers: [1, 2, 0x10, 1_0]),
    },
    objects: [
        Sphere(center: (0, 0, 0), radius: 1.0, material: "red"),
        Group(name: "pair", objects: [
            Box(min: (-1, -1, -1), max: (1, 1, 1), material: "glass"),
            Group(objects: []),
            Moved(Sphere(center: (0., .5, 0), radius: 2, material: "red"), (1, 2, 3)),
        ]),
    ],
    lights: [(position: (0, 5, 0), power: 12.0, kind: 'p', on: true)],
    sky: (0.5, 0.7, 1.0),
    gain: 2.0,
)
"#;

/// A file without mistakes, written as few would write it.
const ODD: &str = r##"#![enable(unwrap_newtypes)] #![type = "a]b"]
(version: 1u32, image: (+1, 0b1_1), camera: Thin (radius: 1e-1, focus: Some(1, 2, 3,),), materials
: {"a": Tint(0.5, inf, -inf), "b": Tint(1, NaN, 2f64), r#"c"c"#: r#Black, "d\x41": Dielectric(.5,)},
objects: [Group(name: Some "x", objects: [Group(r#name: None, objects: [Moved(Group(objects: []),
(0,0,0))])])], lights: [Light(power: 1., on: true, position: (1,2,3), kind: Some('\'')),
(kind: ''', position: (-0, +0, 0), power: -.5e+3)], gain: Some 2.5) // end"##;

/// A scene with these objects, which begin at line 1, column 42.
fn objects(objects: &str) -> String {
    format!("(version: 1, image: (4, 4), camera: Flat, {objects}, lights: [])")
}

/// The problems of a text, one per line: place, message, and help after `|`.
fn problems<T: DeserializeOwned>(text: &str) -> Vec<String> {
    let shown = |problem: &Problem| {
        let (line, column) = line_column(text, problem.span.start);
        let help = problem.help.as_ref().map_or(String::new(), |help| format!(" | {help}"));
        format!("{line}:{column} {}{help}", problem.message)
    };
    diagnose::<T>(text).problems.iter().map(shown).collect()
}

/// Reads `text` as a `T`; each of the problems must begin as the one expected.
#[track_caller]
fn check<T: DeserializeOwned>(text: &str, expected: &[&str]) {
    let found = problems::<T>(text);
    let same = found.len() == expected.len()
        && found.iter().zip(expected).all(|(found, expected)| {
            found == expected
                || !expected.contains('|') && found.starts_with(&format!("{expected} |"))
        });
    assert!(same, "of {text}\nexpected {expected:#?}\nfound {found:#?}");
}

#[test]
fn nothing_is_wrong_with_a_good_file() {
    check::<Scene>(GOOD, &[]);
    check::<Scene>(ODD, &[]);
}
