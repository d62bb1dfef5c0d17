//! goldray's own format: what is written is read back as the same.

use super::*;
use crate::import::{Source, Wishes, import};

/// Something of everything.
const ALL: &str = r#"
    camera: Perspective(view_point: (0.1, 1e-300, 5), proj_normal: Some((0, 0, 1))),
    materials: {"a b": Lambert(diffuse: (0.1, 0.2, 0.30000000000000004)), "c": Normal},
    objects: [
        Sphere(center: (0, 0, 0), radius: 1, material: Named("a b")),
        Triangle(a: (0, 0, 0), b: (1, 0, 0), c: (0, 1, 0)),
        Box(min: (0, 0, 0), max: (1, 1, 1), material: Constant(color: (1, 0, 0))),
        Plane(point: (0, -1, 0), normal: (0, 1, 0), material: Constant(color: (1, 1, 1),
            texture: Checker(a: (1, 0, 0), b: (0, 0, 1), scale: (2, 3), offset: (0.5, 0)))),
        Box(min: (0, 0, 0), max: (1, 1, 1), material: Mirror(reflectance: (0.5, 1, 1), schlick: true)),
        Box(min: (0, 0, 0), max: (1, 1, 1), material: Dielectric(ior: 1.5, tint: (0.5, 1, 1))),
        Box(min: (0, 0, 0), max: (1, 1, 1), material: Whitted(specular: (1, 1, 1), exponent: 3,
            reflect: (0.1, 0.2, 0.3), transmit: (0.5, 0.5, 0.5), ior: 1.2)),
        Box(min: (0, 0, 0), max: (1, 1, 1), material: Glazed(ior: 1.5, diffuse: (1, 0, 0))),
        Disk(center: (0, 0, 0), normal: (0, 1, 0), radius: 1),
        Torus(center: (0, 0, 0), axis: (0, 1, 0), major_radius: 2, minor_radius: 1),
        Cylinder(a: (0, 0, 0), b: (0, 1, 0), radius: 1, open: true),
        Cone(apex: (0, 1, 0), base: (0, 0, 0), radius: 1,
            material: BlinnPhong(specular: (1, 1, 1), exponent: 3)),
        Mesh(file: "a.obj", flat: true),
        Group(
            transform: [RotateDeg(0, 45, 0), Scale(1, 2, -1), Translate(3, 0, 0)],
            objects: [Mesh(file: "a.obj")],
            material: Named("c"),
        ),
    ],
    lights: [
        Point(position: (3, 4, 5), falloff: Constant),
        Directional(direction: (0, 1, 0)),
        Ambient(intensity: (0.1, 0.1, 0.1)),
    ],
    shading: Attenuated, shadows: false, bounces: 3, background: (0, 0, 1), exposure: 0.1,
    sampler: Sobol(seed: 3), samples_per_pixel: 5, filter: Gaussian(radius: 2),
    show: Depth(near: 1, far: 2), encoding: Srgb"#;

fn all() -> String {
    ALL.replace("Some((0, 0, 1))", "(0, 0, 1)")
}

#[test]
fn json_and_ron_are_the_scene_with_its_files() {
    let scene = read(&all());
    let json = written(Dialect::Json, &all());
    assert_eq!(json.files["a.obj"], SQUARE.as_bytes());
    let source = Source { name: &json.main, bytes: &json.files[&json.main] };
    let back = import(source, &Wishes::default(), &json.files).unwrap();
    assert_eq!(back.scene, scene);
    assert!(back.lost.is_empty() && back.chosen.is_empty());
    let ron = written(Dialect::Ron, &all());
    assert_eq!(scene::parse(&text(&ron, "scene.ron")), Some(scene));
    assert_eq!(ron.files["a.obj"], SQUARE.as_bytes());
}

/// Every name in a document, and every word that stands for a choice.
fn names(value: &serde_json::Value, found: &mut BTreeSet<String>) {
    match value {
        serde_json::Value::Object(members) => {
            for (name, value) in members {
                if name == "materials" {
                    // Their names are the scene's own.
                    members[name].as_object().unwrap().values().for_each(|v| names(v, found));
                } else {
                    names(value, found);
                }
                found.insert(name.clone());
            }
        }
        serde_json::Value::Array(items) => items.iter().for_each(|item| names(item, found)),
        _ => {}
    }
}

#[test]
fn the_schema_knows_every_name() {
    let schema: serde_json::Value =
        serde_json::from_str(include_str!("../../../../../docs/schemas/scene.schema.json"))
            .unwrap();
    let mut known = BTreeSet::new();
    names(&schema, &mut known);
    let json = written(Dialect::Json, &all());
    let mut used = BTreeSet::new();
    names(&serde_json::from_slice(&json.files[&json.main]).unwrap(), &mut used);
    let unknown: Vec<_> = used.difference(&known).collect();
    assert!(unknown.is_empty(), "{unknown:?}");
    assert!(used.len() > 60, "{used:?}");
}
