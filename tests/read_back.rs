//! What a writer writes, the reader of its language reads as the same picture.
//!
//! A corner out of place, a light that is lost or an axis that is turned would be
//! seen in it, whether the writer or the reader is wrong.
#![allow(clippy::unwrap_used, clippy::panic)]

use std::collections::BTreeMap;
use std::fs;

use conformance::{repository, repository_suite};
use harness::fixture::{Build, Fixture};
use harness::suite::Suite;
use interchange::Feature;
use interchange::export::{Dialect, Exported, NotWritten, export};
use interchange::import::{Imported, Source, Wishes, import};
use scene::SceneFile;
use scene::format::{Light, Show};
use tracer::LinearImage;

/// How far a number may be off, as a share of the larger one.
const NEAR: f64 = 1e-9;

/// Languages that are read as well as written.
const DIALECTS: [Dialect; 3] = [Dialect::CornellXml, Dialect::Nff, Dialect::Obj];

/// Pictures that are not the same: how many pixels differ, and why.
const DIFFER: &[(Dialect, &str, usize, &str)] = &[
    (Dialect::Obj, "sampling/adaptive", 4, MORE_SAMPLES),
    (Dialect::Obj, "sampling/adaptive-tent", 30, MORE_SAMPLES),
    (Dialect::Obj, "triangle/fan", 66, TIES),
    (Dialect::Obj, "triangle/shared-edge", 32, TIES),
];
const MORE_SAMPLES: &str = "samples go where surfaces of two objects are beside each other, and \
                            here objects of one material are one mesh";
const TIES: &str = "edges go through centers of pixels: a triangle alone has its edges, and one of \
                    a mesh has those of one side";

fn fixtures() -> Vec<(String, Fixture)> {
    let suite = repository_suite();
    let names = suite.select(&[]).unwrap().fixtures;
    let open = |name: String| {
        let label = Suite::fixture_label(&name);
        let fixture = Fixture::open(&label, &suite.fixture_path(&name), Build::Bvh).unwrap();
        (name, fixture)
    };
    names.into_iter().map(open).collect()
}

/// The scene of the files; what they do not say, and nothing else, is said by
/// the one that they were written of.
fn read_back(dialect: Dialect, written: &SceneFile, exported: &Exported) -> Imported {
    let mut wishes = Wishes::default();
    let is_beside = |family| exported.beside.iter().any(|feature| feature.family() == family);
    if is_beside("shading") {
        wishes.shading = Some(written.shading);
    }
    if dialect == Dialect::Obj {
        (wishes.camera, wishes.image) = (Some(written.camera), Some(written.image));
    }
    let source = Source { name: &exported.main, bytes: &exported.files[&exported.main] };
    let mut back = import(source, &wishes, &exported.files).unwrap();
    assert_eq!(back.lost, [], "{}", exported.main);
    if dialect == Dialect::Obj {
        say_beside(written, &mut back.scene);
    }
    back
}

/// The lights, the background and the samples of a file of shapes alone.
fn say_beside(written: &SceneFile, scene: &mut SceneFile) {
    let is_shaded = written.show == Show::Shaded;
    // The exposure is in the colors that were written.
    let exposed =
        |color: [f64; 3]| color.map(|x| x * if is_shaded { written.exposure } else { 1.0 });
    scene.lights = if is_shaded { written.lights.clone() } else { Vec::new() };
    for light in &mut scene.lights {
        let (Light::Point { intensity, .. }
        | Light::Directional { intensity, .. }
        | Light::Ambient { intensity }) = light;
        *intensity = exposed(*intensity);
    }
    scene.background = exposed(written.background);
    scene.shadows = written.shadows;
    scene.samples_per_pixel = written.samples_per_pixel;
    scene.sampler = written.sampler;
    scene.filter = written.filter;
    scene.error = written.error;
}

type Pixels = Vec<[f64; 3]>;

/// A picture's numbers, of which each square of `grid` by `grid` is one.
fn pixels(picture: &LinearImage, grid: u32) -> Pixels {
    let size = picture.size();
    let (width, height) = (size.width / grid, size.height / grid);
    let mean = |k: u32| {
        let mut sum = [0.0; 3];
        for i in 0..grid * grid {
            let (x, y) = (k % width * grid + i % grid, k / width * grid + i / grid);
            let pixel = picture.get(x, y).unwrap().channels();
            sum = [0, 1, 2].map(|c| sum[c] + pixel[c]);
        }
        sum.map(|x| x / f64::from(grid * grid))
    };
    (0..width * height).map(mean).collect()
}

/// How many pixels differ.
fn differing(one: &Pixels, other: &Pixels) -> usize {
    assert_eq!(one.len(), other.len());
    let is_near = |a: f64, b: f64| (a - b).abs() <= NEAR * a.abs().max(b.abs());
    let differs = |(a, b): &(&[f64; 3], &[f64; 3])| (0..3).any(|c| !is_near(a[c], b[c]));
    one.iter().zip(other).filter(differs).count()
}

/// How many pixels of a scene differ after it was written and read; `None` where
/// it is not written.
fn moved(
    dialect: Dialect,
    file: &SceneFile,
    assets: &BTreeMap<String, Vec<u8>>,
    picture: &LinearImage,
) -> Option<usize> {
    let exported = match export(dialect, file, assets) {
        Ok(exported) => exported,
        Err(NotWritten::Cannot(_)) => return None,
        Err(NotWritten::Bad(why)) => panic!("{dialect}: {why}"),
    };
    let back = read_back(dialect, file, &exported);
    let scene = scene::recompile(&back.scene, &back.files, Build::Bvh).unwrap();
    Some(differing(&pixels(picture, 1), &pixels(&tracer::render(&scene), exported.grid)))
}

#[test]
fn fixtures_are_read_back_as_the_same_pictures() {
    let fixtures = fixtures();
    let mut written = BTreeMap::new();
    let mut found = Vec::new();
    for (name, fixture) in &fixtures {
        let (file, picture) = (fixture.scene_file(), fixture.render_linear());
        for dialect in DIALECTS {
            let Some(pixels) = moved(dialect, &file, fixture.assets(), &picture) else { continue };
            *written.entry(dialect.name()).or_insert(0) += 1;
            if pixels > 0 {
                found.push((dialect, name.as_str(), pixels));
            }
        }
    }
    let known = |&(dialect, name, pixels, _): &(_, _, _, _)| (dialect, name, pixels);
    found.sort_unstable();
    assert_eq!(found, DIFFER.iter().map(known).collect::<Vec<_>>());
    // What the document says of them is what they are.
    let document = fs::read_to_string(repository().join("docs/adapters.md")).unwrap();
    assert!(document.contains(&format!("| written of {} fixtures |", fixtures.len())));
    for (dialect, n) in written {
        let mut rows = document.lines().filter(|row| row.starts_with(&format!("| `{dialect}` |")));
        assert!(rows.any(|row| row.contains(&format!(" | {n} | "))), "{dialect}: {n}");
    }
}

/// Everything that NFF has a word for, several colors and an eye that looks
/// nowhere along an axis.
const OF_NFF: &str = r#"(
    version: 1,
    image: (90, 70),
    camera: LookAt(eye: (3, 4, 9), at: (0.5, 0.3, 0), up: (0.2, 1, 0), fov_deg: 41),
    background: (0.1, 0.2, 0.4),
    lights: [
        Point(position: (6, 9, 7), intensity: (0.5, 0.6, 0.4)),
        Point(position: (-8, 5, 9), intensity: (0.3, 0.1, 0.5)),
    ],
    materials: {
        "red": Lambert(diffuse: (0.8, 0.1, 0.2)),
        "sand": Lambert(diffuse: (0.7, 0.6, 0.3)),
    },
    samples_per_pixel: 4,
    objects: [
        Plane(point: (0, -1, 0), normal: (0, 1, 0), material: Named("sand")),
        Sphere(center: (-1.5, 0, 0), radius: 0.8, material: Named("red")),
        Cone(apex: (0.2, 1.5, 0.3), base: (0.4, -1, -0.4), radius: 0.7, open: true),
        Cylinder(a: (1.5, -1, 0), b: (2.3, 6, -1.6), radius: 0.5, open: true),
        Group(
            transform: [RotateDeg(20, 30, 40), Scale(1, 1.2, 0.7), Translate(-0.3, 0, 2)],
            objects: [Box(min: (-0.4, -0.5, -0.4), max: (0.4, 0.1, 0.4), material: Named("red"))],
        ),
        Triangle(a: (0, 1, -2), b: (2.5, 1.2, -2), c: (1, 3, -2), material: Named("sand")),
        Mesh(file: "roof.obj", material: Named("red")),
    ],
)"#;

const ROOF: &str = "v -2 1.2 -1\nv -0.5 1.2 -1\nv -0.5 2.4 -1.3\nv -2 2.2 -1.2\n\
                    vn -0.3 0 1\nvn 0.3 0.1 1\nvn 0 0.4 1\nf 1//1 2//2 3//3\nf 1//1 3//3 4//3\n";

#[test]
fn a_scene_of_all_that_nff_can_say_is_read_back() {
    let assets = BTreeMap::from([("roof.obj".to_owned(), ROOF.into())]);
    let file = scene::parse::<scene::Unchecked>(OF_NFF).unwrap();
    let picture = tracer::render(&scene::recompile(&file, &assets, Build::Bvh).unwrap());
    assert_eq!(moved(Dialect::Nff, &file, &assets, &picture), Some(0));
    // Were there no pixels to move, none would have.
    let shown: std::collections::BTreeSet<_> =
        pixels(&picture, 1).iter().map(|pixel| pixel.map(f64::to_bits)).collect();
    assert!(shown.len() > 3_000, "{}", shown.len());
    let features = interchange::feature::features(&file);
    for feature in [Feature::OpenCone, Feature::OpenCylinder, Feature::Mesh, Feature::Plane] {
        assert!(features.contains(&feature));
    }
}
