//! No text makes the reader panic, and none is refused without a reason.
#![allow(clippy::unwrap_used)]

use scene::{NoAssets, Unchecked, line_column, load};
use tracer::accel::Build;

/// Short, with something of everything in it.
const SCENE: &str = r#"// A comment.
(
    version: 1, image: (8, 6),
    camera: Perspective(view_point: (5, 4, 3), view_dir: (-5, -4, -3), proj_normal: (5, 4, 3)),
    shading: Radiometric, exposure: 1e1, shadows: false, show: Depth(near: 0.5, far: 9),
    samples_per_pixel: 4, sampler: Sobol(seed: 3), filter: Mitchell(radius: 1.5), encoding: Srgb, background: (0.1, 0.2, 0.3),
    materials: { "red": BlinnPhong(specular: (1, 0, 0), exponent: 20), "b": Named("red") },
    objects: [
        Sphere(center: (0, 0, 0), radius: 1, material: Named("b")),
        Group(transform: [Scale(1, 2, -3), RotateDeg(0, 45, 0), Translate(1, 2, 3)], objects: [
            Box(min: (-1, -1, -1), max: (1, 1, 1), material: Normal),
            Triangle(a: (0, 0, 0), b: (1, 0, 0), c: (0, 1, 0)),
        ]),
        Disk(center: (0, 0, 0), normal: (0, 1, 0), radius: 2),
        Cylinder(a: (0, 0, 0), b: (0, 1, 2), radius: 2, open: true),
        Cone(apex: (0, 2, 0), base: (0, 1, 0), radius: 2),
        Torus(center: (0, 0, 0), axis: (0, 1, 0), major_radius: 2, minor_radius: 0.5),
        /* and */ Plane(point: (0, -1, 0), normal: (0, 1, 0), material: Constant(color: (1, 1, 1))),
    ],
    lights: [Point(position: (3, 4, 5), falloff: Constant), Ambient(intensity: (0.1, 0.1, 0.1)),
        Directional(direction: (0, -1, 0))],
)"#;

/// Pieces that mean something to the reader.
const PIECES: &[&str] = &[
    "(",
    ")",
    "[",
    "]",
    "{",
    "}",
    ",",
    ":",
    "\"",
    "//",
    "/*",
    "*/",
    "-",
    "1e400",
    "NaN",
    "inf",
    "-inf",
    "0",
    "1e-400",
    "Some(",
    "None",
    "r#\"",
    "'",
    "\\",
    "é",
    "\u{feff}",
    "\0",
    "\n",
    "#![enable(implicit_some)]",
    "0x1F",
    "true",
    "Sphere",
    "material",
    "Named(\"red\")",
    "18446744073709551616",
    ".5",
    "5.",
    "1_000",
    "99999999999999999999999999",
];

fn mutated(rng: &mut fastrand::Rng) -> String {
    let mut text = SCENE.to_owned();
    let place = |rng: &mut fastrand::Rng, text: &str| {
        let mut at = rng.usize(0..=text.len());
        while !text.is_char_boundary(at) {
            at -= 1;
        }
        at
    };
    for _ in 0..rng.usize(1..4) {
        let (a, b) = (place(rng, &text), place(rng, &text));
        let (a, b) = (a.min(b), a.max(b).min(a.min(b) + rng.usize(0..20)));
        let b = (b..=text.len()).find(|&i| text.is_char_boundary(i)).unwrap();
        match rng.u8(0..6) {
            0 => text.replace_range(a..b, ""),
            1 => text.insert_str(a, PIECES[rng.usize(0..PIECES.len())]),
            2 => text.replace_range(a..b, PIECES[rng.usize(0..PIECES.len())]),
            3 => {
                let piece = text[a..b].to_owned();
                text.insert_str(a, &piece);
            }
            4 => text.truncate(a),
            _ => {
                let piece = text[a..b].to_owned();
                text.replace_range(a..b, "");
                let at = place(rng, &text);
                text.insert_str(at, &piece);
            }
        }
    }
    text
}

#[test]
fn the_scene_itself_is_good() {
    let loaded = load::<Unchecked>(SCENE, &NoAssets, Build::Bvh);
    assert!(loaded.is_ok(), "{:?}", loaded.err());
}

#[test]
fn a_hundred_thousand_mutated_files() {
    const PARTS: u64 = 4;
    let accepted: Vec<u32> = std::thread::scope(|scope| {
        let parts: Vec<_> = (0..PARTS)
            .map(|seed| {
                scope.spawn(move || {
                    let mut rng = fastrand::Rng::with_seed(seed);
                    let texts = (0..100_000 / PARTS).map(|_| mutated(&mut rng));
                    texts.map(|text| u32::from(is_accepted(&text))).sum()
                })
            })
            .collect();
        parts.into_iter().map(|part| part.join().unwrap()).collect()
    });
    let accepted: u32 = accepted.iter().sum();
    assert!((1_000..50_000).contains(&accepted), "{accepted} of 100,000 were accepted");
}

/// Whether the text is a good scene; if not, that it is said where and why.
fn is_accepted(text: &str) -> bool {
    match load::<Unchecked>(text, &NoAssets, Build::Bvh) {
        Ok(_) => true,
        Err(problems) => {
            assert!(!problems.is_empty(), "refused without a reason:\n{text}");
            for problem in &problems {
                let (line, column) = line_column(text, problem.span.start);
                assert!(line >= 1 && column >= 1 && !problem.message.is_empty());
                assert!(text.get(problem.span.start..problem.span.end).is_some(), "{problem:?}");
            }
            let report = scene::report("mutated.ron", text, &problems);
            assert!(report.lines().count() >= 3 * problems.len());
            false
        }
    }
}
