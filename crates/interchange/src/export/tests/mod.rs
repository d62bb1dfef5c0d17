//! What is written, word for word, and what is refused.

mod course;
mod mitsuba;
mod others;
mod own;
mod plain;
mod povray;

use std::collections::BTreeMap;

use super::*;

/// A small scene of these fields beside a camera.
fn read(fields: &str) -> SceneFile {
    let camera = "camera: LookAt(eye: (0, 0, 5), at: (0, 0, 0), fov_deg: 90)";
    let camera = if fields.contains("camera:") { "" } else { camera };
    let text = format!("(version: 1, image: (80, 60), {camera}, {fields})").replace(", ,", ",");
    scene::parse(&text).unwrap_or_else(|| panic!("no scene: {text}"))
}

/// A square of two triangles, of which the first has normals at its corners and
/// the second lacks one.
const SQUARE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvn 0 0 2\nvn 0 0 0\n\
                      f 1//1 2//1 3//1\nf 1//1 3//1 4//2\n";

fn assets() -> BTreeMap<String, Vec<u8>> {
    BTreeMap::from([("a.obj".to_owned(), SQUARE.into())])
}

#[track_caller]
fn written(dialect: Dialect, fields: &str) -> Exported {
    export(dialect, &read(fields), &assets()).unwrap_or_else(|why| panic!("{fields}: {why}"))
}

fn text(exported: &Exported, name: &str) -> String {
    String::from_utf8(exported.files[name].clone()).unwrap()
}

/// The main file.
#[track_caller]
fn main_of(dialect: Dialect, fields: &str) -> String {
    let exported = written(dialect, fields);
    text(&exported, &exported.main)
}

#[track_caller]
fn refused(dialect: Dialect, fields: &str, expected: &[Feature]) {
    let expected = expected.iter().copied().collect();
    let why = export(dialect, &read(fields), &assets()).unwrap_err();
    assert_eq!(why, NotWritten::Cannot(expected), "{dialect}: {fields}");
}

const LIT: &str = "objects: [Sphere(center: (0, 0, 0), radius: 1)], \
                   lights: [Point(position: (3, 4, 5))]";

#[test]
fn what_no_renderer_samples_alike_is_refused_by_all_of_them() {
    for &dialect in &Dialect::ALL[2..] {
        if dialect == Dialect::Obj {
            continue;
        }
        for (fields, expected) in [
            ("filter: Tent()", Feature::PixelFilter),
            ("error: 0.01", Feature::AdaptiveSamples),
            ("sampler: Sobol(), samples_per_pixel: 3", Feature::ScatteredSamples),
        ] {
            refused(dialect, fields, &[expected]);
        }
        refused(
            dialect,
            "filter: Tent(), error: 0.01, objects: [Torus(center: (0, 0, 0), axis: (0, 1, 0), \
             major_radius: 2, minor_radius: 1, material: Constant(color: (1, 0, 0)))]",
            &match dialect {
                Dialect::PovRay => vec![Feature::PixelFilter, Feature::AdaptiveSamples],
                // Of what NFF cannot say, it is all.
                Dialect::Nff => vec![
                    Feature::Torus,
                    Feature::Constant,
                    Feature::PixelFilter,
                    Feature::AdaptiveSamples,
                ],
                _ => vec![Feature::Torus, Feature::PixelFilter, Feature::AdaptiveSamples],
            },
        );
    }
}

#[test]
fn a_scene_that_makes_no_sense_is_bad_in_every_dialect() {
    for &dialect in Dialect::ALL {
        for (fields, expected) in [
            ("objects: [Sphere(center: (0, 0, 0), radius: -1)]", "radius"),
            ("objects: [Mesh(file: \"none.obj\")]", "mesh \"none.obj\" does not exist"),
            ("objects: [Mesh(file: \"../a.obj\")]", "no `..`"),
            ("materials: {\"a\": Named(\"a\")}", "circle"),
        ] {
            let why = export(dialect, &read(fields), &assets()).unwrap_err();
            assert!(matches!(&why, NotWritten::Bad(why) if why.contains(expected)), "{why:?}");
        }
    }
}

#[test]
fn every_dialect_has_a_name_and_writes_its_main_file() {
    let names: BTreeSet<_> = Dialect::ALL.iter().map(|dialect| dialect.name()).collect();
    assert_eq!(names.len(), Dialect::ALL.len());
    for &dialect in Dialect::ALL {
        let exported = written(dialect, "objects: []");
        assert!(exported.files.contains_key(&exported.main), "{dialect}");
    }
}
