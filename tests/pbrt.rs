//! What is written for pbrt, taken apart by somebody else's reader of its
//! language, put together by what pbrt's description says, is the same picture.
//!
//! pbrt itself is not run. This tells a word that is none, a number in the wrong
//! place, an axis that is turned; not whether pbrt does what it says.
#![allow(clippy::unwrap_used, clippy::panic)]

use std::collections::BTreeMap;
use std::fs;

use conformance::{repository, repository_suite};
use harness::fixture::{Build, Fixture};
use harness::suite::Suite;
use interchange::export::{Dialect, Exported, NotWritten, export};
use pbrt4::param::ParamList;
use pbrt4::{Element, Error, Parser};
use scene::SceneFile;
use scene::format::{Camera, Light, Material, Object, Shading, Triple};
use tracer::LinearImage;
use tracer::glam::{DAffine3, DMat3, DVec3};

/// The reader knows no parameters of filters, which pbrt has.
const FILTER: &str = "PixelFilter \"box\" \"float xradius\" 0.5 \"float yradius\" 0.5\n";

fn elements(text: &str) -> Vec<Element<'_>> {
    let mut parser = Parser::new(text);
    let mut all = Vec::new();
    loop {
        match parser.parse_next() {
            Ok(element) => all.push(element),
            Err(Error::EndOfFile) => return all,
            Err(error) => panic!("{error} after {:?}", all.last()),
        }
    }
}

fn numbers<const N: usize>(params: &ParamList<'_>, name: &str) -> [f64; N] {
    let param = params.get(name).unwrap_or_else(|| panic!("no {name}"));
    param.vec::<f64>().unwrap().try_into().unwrap()
}

fn number(params: &ParamList<'_>, name: &str) -> f64 {
    let [number] = numbers(params, name);
    number
}

fn vector(v: &[f32]) -> DVec3 {
    DVec3::new(v[0].into(), v[1].into(), v[2].into())
}

/// The state that a shape is made in.
#[derive(Debug, Clone, Copy)]
struct State {
    place: DAffine3,
    reflectance: Triple,
    glow: Option<Triple>,
}

/// A scene of the elements, as far as the writer uses them.
struct Reading {
    file: SceneFile,
    view: Option<[DVec3; 3]>,
    states: Vec<State>,
}

impl Reading {
    fn of(exported: &Exported) -> SceneFile {
        let text = std::str::from_utf8(&exported.files[&exported.main]).unwrap();
        assert_eq!(text.matches(FILTER).count(), 1);
        let blank = "(version: 1, image: (1, 1), camera: Parallel(view_point: (0, 0, 0)))";
        let state = State { place: DAffine3::IDENTITY, reflectance: [0.5; 3], glow: None };
        let mut file = scene::parse::<scene::Unchecked>(blank).unwrap();
        file.shading = Shading::Radiometric;
        let mut reading = Self { file, view: None, states: vec![state] };
        for element in elements(&text.replace(FILTER, "")) {
            reading.element(&element);
        }
        assert_eq!(reading.states.len(), 1);
        reading.file
    }

    fn element(&mut self, element: &Element<'_>) {
        let state = self.states.last_mut().unwrap();
        match element {
            // Its own space is left-handed.
            Element::Scale { v } => assert_eq!(*v, [-1.0, 1.0, 1.0]),
            Element::LookAt { eye, look_at, up } => {
                self.view = Some([eye, look_at, up].map(|v| vector(v)));
            }
            Element::Camera { ty, params } => self.camera(ty, params),
            Element::Film { params, .. } => {
                let side = |name: &str| params.integer(name, 0).unwrap().try_into().unwrap();
                self.file.image = (side("xresolution"), side("yresolution"));
            }
            Element::Sampler { ty: "stratified", params } => {
                assert!(!params.boolean("jitter", true).unwrap());
                let side =
                    |name: &str| -> u32 { params.integer(name, 0).unwrap().try_into().unwrap() };
                self.file.samples_per_pixel = side("xsamples") * side("ysamples");
            }
            Element::Integrator { ty, .. } => assert_eq!(*ty, "path"),
            Element::WorldBegin => {}
            Element::AttributeBegin => {
                let state = *state;
                self.states.push(state);
            }
            Element::AttributeEnd => _ = self.states.pop().unwrap(),
            Element::Translate { v } => state.place *= DAffine3::from_translation(vector(v)),
            Element::ConcatTransform { m } => {
                let [x, y, z, at] = [0, 4, 8, 12].map(|k| vector(&m[k..]));
                let matrix = DMat3::from_cols(x, y, z);
                state.place *= DAffine3::from_mat3_translation(matrix, at);
            }
            Element::Material { ty: "diffuse", params } => {
                state.reflectance = numbers(params, "reflectance");
            }
            Element::AreaLightSource { ty: "diffuse", params } => {
                assert!(params.boolean("twosided", false).unwrap());
                state.glow = Some(numbers(params, "L"));
            }
            Element::LightSource { ty, params } => self.light(ty, params),
            Element::Shape { name, params } => {
                let object = shape(*state, name, params);
                self.file.objects.push(object);
            }
            other => panic!("{other:?}"),
        }
    }

    /// Of a field of view of 90 degrees the screen is at the distance 1; x goes
    /// to the right as the mirror before it turns it.
    fn camera(&mut self, ty: &str, params: &ParamList<'_>) {
        let [eye, at, up] = self.view.unwrap();
        let ahead = (at - eye).normalize();
        let right = ahead.cross(up).normalize();
        let up = right.cross(ahead);
        let [x0, x1, y0, y1] = numbers(params, "screenwindow");
        let beside = right * (0.5 * (x0 + x1)) + up * (0.5 * (y0 + y1));
        let (view_up, normal) = (up.to_array(), Some((-ahead).to_array()));
        let (view_width, view_height) = (x1 - x0, y1 - y0);
        self.file.camera = if ty == "perspective" {
            assert_eq!(number(params, "fov"), 90.0);
            Camera::Perspective {
                view_point: eye.to_array(),
                view_dir: (ahead + beside).to_array(),
                view_up,
                proj_normal: normal,
                view_width,
                view_height,
                proj_distance: (ahead + beside).length(),
            }
        } else {
            assert_eq!(ty, "orthographic");
            Camera::Parallel {
                view_point: (eye + beside).to_array(),
                view_dir: ahead.to_array(),
                view_up,
                proj_normal: normal,
                view_width,
                view_height,
            }
        };
    }

    fn light(&mut self, ty: &str, params: &ParamList<'_>) {
        match ty {
            "point" => self.file.lights.push(Light::Point {
                position: numbers(params, "from"),
                intensity: numbers(params, "I"),
                falloff: None,
            }),
            "distant" => {
                let [from, to] = ["from", "to"].map(|name| DVec3::from(numbers::<3>(params, name)));
                let (direction, intensity) = ((to - from).to_array(), numbers(params, "L"));
                self.file.lights.push(Light::Directional { direction, intensity });
            }
            _ => {
                assert_eq!(ty, "infinite");
                self.file.background = numbers(params, "L");
            }
        }
    }
}

fn shape(state: State, name: &str, params: &ParamList<'_>) -> Object {
    let State { place, reflectance, glow } = state;
    let material = Some(match glow {
        Some(color) => Material::Constant { color, texture: None },
        None => Material::Lambert { diffuse: Some(reflectance), texture: None },
    });
    let along = |z: f64| place.transform_point3(DVec3::new(0.0, 0.0, z)).to_array();
    let radius = || number(params, "radius");
    match name {
        "sphere" => Object::Sphere { center: along(0.0), radius: radius(), material },
        "disk" => {
            let height = params.float("height", 0.0).unwrap();
            let normal = place.transform_vector3(DVec3::Z).to_array();
            Object::Disk { center: along(height.into()), normal, radius: radius(), material }
        }
        "cylinder" => {
            let [a, b] = ["zmin", "zmax"].map(|name| along(number(params, name)));
            Object::Cylinder { a, b, radius: radius(), open: true, material }
        }
        _ => {
            assert_eq!((name, place), ("plymesh", DAffine3::IDENTITY));
            let file = params.string("filename").unwrap().trim_matches('"').to_owned();
            Object::Mesh { file, flat: false, material }
        }
    }
}

/// How many pixels differ by more than what numbers of 32 bits move them.
fn differing(one: &LinearImage, other: &LinearImage) -> usize {
    const NEAR: f64 = 1e-5;
    assert_eq!(one.size(), other.size());
    let channels = |picture: &LinearImage| -> Vec<_> {
        picture.pixels().iter().map(|pixel| pixel.channels()).collect()
    };
    let (one, other) = (channels(one), channels(other));
    let brightest = one.iter().flatten().copied().fold(0.0, f64::max);
    let is_near = |a: f64, b: f64| (a - b).abs() <= NEAR * brightest;
    one.iter().zip(&other).filter(|(a, b)| (0..3).any(|c| !is_near(a[c], b[c]))).count()
}

/// How many pixels are others than those of the scene; `None` where it is not
/// written.
fn moved(file: &SceneFile, assets: &BTreeMap<String, Vec<u8>>) -> Option<usize> {
    let exported = match export(Dialect::Pbrt, file, assets) {
        Ok(exported) => exported,
        Err(NotWritten::Cannot(_)) => return None,
        Err(NotWritten::Bad(why)) => panic!("{why}"),
    };
    let read = Reading::of(&exported);
    let [own, other] = [(file, assets), (&read, &exported.files)]
        .map(|(file, assets)| tracer::render(&scene::recompile(file, assets, Build::Bvh).unwrap()));
    Some(differing(&own, &other))
}

#[test]
fn what_pbrt_is_given_of_fixtures_is_the_same_picture() {
    // Edges that go through centers of pixels, as in OBJ: a triangle alone has its
    // edges, and one of a mesh has those of one side.
    let expected = [("triangle/fan", 66), ("triangle/shared-edge", 32)];
    let suite = repository_suite();
    let (mut written, mut found) = (0, Vec::new());
    for name in suite.select(&[]).unwrap().fixtures {
        let label = Suite::fixture_label(&name);
        let fixture = Fixture::open(&label, &suite.fixture_path(&name), Build::Bvh).unwrap();
        let Some(pixels) = moved(&fixture.scene_file(), fixture.assets()) else { continue };
        written += 1;
        if pixels > 0 {
            found.push((name, pixels));
        }
    }
    let found: Vec<_> = found.iter().map(|(name, pixels)| (name.as_str(), *pixels)).collect();
    assert_eq!(found, expected);
    let document = fs::read_to_string(repository().join("docs/adapters.md")).unwrap();
    let mut rows = document.lines().filter(|row| row.starts_with("| `Pbrt` |"));
    assert!(rows.any(|row| row.contains(&format!(" | {written} | "))), "{written}");
}

/// Every shape that pbrt has words for, lit, as fixtures are not that it can say.
const LIT: &str = r#"
    version: 1,
    image: (90, 70),
    camera: Perspective(
        view_point: (3, 4, 9), view_dir: (-2.5, -3.7, -9), view_up: (0.2, 1, 0),
        proj_normal: (0.3, 0.2, 1), view_width: 0.9, view_height: 0.7,
    ),
    materials: {
        "red": Lambert(diffuse: (0.8, 0.1, 0.2)),
        "sand": Lambert(diffuse: (0.7, 0.6, 0.3)),
    },
    samples_per_pixel: 4,
    exposure: 1.5,
    objects: [
        Plane(point: (0, -1, 0), normal: (0, 1, 0), material: Named("sand")),
        Sphere(center: (-1.5, 0, 0), radius: 0.8, material: Named("red")),
        Disk(center: (0.2, 1.5, 0.3), normal: (0.5, 0.6, 1), radius: 0.7),
        Group(
            transform: [RotateDeg(20, 30, 40), Scale(0.8, 0.8, 0.8), Translate(1.3, 0, 0.5)],
            objects: [
                Cylinder(a: (0, -1, 0), b: (0.3, 1, 0), radius: 0.5, material: Named("red")),
                Box(min: (-2.4, -0.5, 0.9), max: (-1.6, 0.1, 1.7)),
            ],
        ),
        Triangle(a: (0, 1, -2), b: (2.5, 1.2, -2), c: (1, 3, -2), material: Named("sand")),
    ],
"#;

#[test]
fn what_pbrt_is_given_of_lit_shapes_is_the_same_picture() {
    /// Of 6300 pixels: at edges, that move with the 24th bit of a place.
    const EDGES: usize = 10;
    for light in [
        "shading: Attenuated, lights: [Point(position: (6, 9, 7), intensity: (50, 60, 40))]",
        "shading: Radiometric, lights: [Directional(direction: (-2, -3, -2.5))]",
    ] {
        let text = format!("({LIT}{light})");
        let file = scene::parse::<scene::Unchecked>(&text).unwrap();
        let pixels = moved(&file, &BTreeMap::new()).unwrap();
        assert!(pixels <= EDGES, "{light}: {pixels}");
    }
}
