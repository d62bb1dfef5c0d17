//! Pictures that are right, and pictures that are wrong in one way each.

use std::collections::BTreeMap;
use std::fmt::Write;

use harness::fixture::Build;
use harness::picture_file::to_exr;

use super::*;
use crate::adapter::{Rows, Transfer};

/// A ball on a floor, lit from the left; known on paper are a pixel of the
/// background, its count and the symmetry of the upper half.
const SCENE: &str = r"(
    version: 1, image: (24, 16),
    camera: Parallel(view_point: (0, 0, 9), view_width: 6, view_height: 4),
    background: (0.25, 0.5, 0.125),
    objects: [Sphere(center: (0.01, 0.4, 0), radius: 1.3, material: Constant(color: (1, 0, 0.5)))],
    check: (expect: [CHECK]),
)";

/// A ball of every shade, to the side and lit from there: nothing is the same the other
/// way around, and no pixel is that of its neighbor.
const TILTED: &str = r"(
    version: 1, image: (24, 16),
    camera: Parallel(view_point: (0, 0, 9), view_width: 6, view_height: 4),
    background: (0.25, 0.5, 0.125),
    objects: [Sphere(center: (0.31, 0.4, 0), radius: 1.3, material: Lambert(diffuse: (0.8, 0.7, 0.5)))],
    lights: [Directional(direction: (-1, -2, -3))],
)";

struct Held {
    fixture: Fixture,
    rendered: Rendered,
    around: Vec<Option<Around>>,
}

fn held(expect: &str) -> Held {
    held_of(&SCENE.replace("CHECK", expect))
}

fn held_of(text: &str) -> Held {
    let files: BTreeMap<String, Vec<u8>> = BTreeMap::new();
    let fixture = Fixture::read("a", text, &files, Build::Bvh).unwrap();
    let rendered = fixture.render().unwrap();
    // Samples are moved far, so that a few pixels are edges.
    let around = tracer::edges(&fixture.scene, 0.25);
    Held { fixture, rendered, around }
}

const STRICT: Allowance = Allowance { tolerance: 1e-5, edges: 1.0 };

impl Held {
    fn reference(&self) -> Reference<'_> {
        let Self { fixture, rendered, around } = self;
        Reference { fixture, rendered, around }
    }

    /// A picture in 32-bit floats that is changed by this.
    fn floats(&self, change: impl Fn(u32, u32, Rgb) -> Rgb) -> Stored {
        let linear = &self.rendered.linear;
        let changed =
            LinearImage::from_fn(linear.size(), |x, y| change(x, y, linear.get(x, y).unwrap()));
        Stored::read(&to_exr(&changed).unwrap()).unwrap()
    }

    /// The same in codes up to `max`, by a curve.
    fn codes(&self, max: u16, curve: fn(f64) -> f64) -> Stored {
        let linear = &self.rendered.linear;
        let Size { width, height } = linear.size();
        let mut file = format!("P3 {width} {height} {max}\n");
        for channel in linear.pixels().iter().flat_map(|pixel| pixel.channels()) {
            let code = (curve(channel).clamp(0.0, 1.0) * f64::from(max)).round();
            write!(file, "{code} ").unwrap();
        }
        Stored::read(file.as_bytes()).unwrap()
    }

    fn judged(&self, stored: &Stored, meaning: Meaning) -> Judged {
        judge(&self.reference(), &Levels::of(stored, meaning).unwrap(), STRICT)
    }

    fn hinted(&self, stored: &Stored) -> Option<String> {
        let judged = self.judged(stored, plain());
        hint(&self.reference(), (stored, 1), plain(), (STRICT, &judged))
    }

    /// Any pixel that is an edge, and any that is none.
    fn edge_and_interior(&self) -> [(u32, u32); 2] {
        let width = self.rendered.linear.size().width;
        let place = |at: usize| (at as u32 % width, at as u32 / width);
        let first = |is_edge: bool| self.around.iter().position(|a| a.is_some() == is_edge);
        [true, false].map(|is_edge| place(first(is_edge).unwrap()))
    }
}

fn plain() -> Meaning {
    Meaning::default()
}

#[track_caller]
fn fails(judged: &Judged, expected: &str) {
    let found = judged.findings.join("\n");
    assert!(!found.is_empty(), "expected a finding");
    assert!(found.contains(expected), "expected {expected:?} in:\n{found}");
}

#[test]
fn the_very_picture_passes_in_any_encoding() {
    let held = held("Pixel(at: (0, 0), rgb: (136, 186, 99)), Mirror(LeftRight)");
    let held = Held { around: held.around, ..held };
    let exact = Allowance { tolerance: 0.0, edges: 0.0 };
    let levels = Levels::of(&held.floats(|_, _, c| c), plain()).unwrap();
    let judged = judge(&held.reference(), &levels, exact);
    assert_eq!((judged.numbers.interior_off, judged.numbers.edge_off), (0, 0));
    assert_eq!(judged.numbers.worst_at, None);
    assert!(judged.numbers.edge_pixels > 10);
    for max in [255, 65_535] {
        let linear = held.judged(&held.codes(max, |c| c), plain());
        assert_eq!(linear.numbers.interior_off + linear.numbers.edge_off, 0, "{max}");
        let gamma = held.codes(max, |c| libm::pow(c, 1.0 / 2.2));
        let judged = held.judged(&gamma, Meaning { transfer: Transfer::Gamma22, ..plain() });
        assert_eq!(judged.numbers.interior_off, 0);
    }
}

#[test]
fn one_interior_pixel_off_is_a_failure() {
    let held = held("");
    let [_, at] = held.edge_and_interior();
    let by = |factor: f64| {
        held.judged(&held.floats(|x, y, c| if (x, y) == at { c * factor } else { c }), plain())
    };
    assert_eq!(by(1.0 + 0.9e-5).findings, [""; 0]);
    let judged = by(1.0 + 1.1e-5);
    fails(&judged, "1 of ");
    assert_eq!((judged.numbers.interior_off, judged.numbers.worst_at), (1, Some(at)));
    assert!((judged.numbers.worst_interior - 1.1e-5).abs() < 1e-6);
    assert_eq!(judged.off.iter().filter(|&&off| off).count(), 1);
}

#[test]
fn an_edge_may_show_either_side_and_nothing_else() {
    let held = held("");
    let [at, _] = held.edge_and_interior();
    let with = |color: [f64; 3]| {
        let color = Rgb::from(color);
        held.judged(&held.floats(|x, y, c| if (x, y) == at { color } else { c }), plain())
    };
    for side in [[0.25, 0.5, 0.125], [1.0, 0.0, 0.5], [0.5, 0.25, 0.25]] {
        assert_eq!(with(side).findings, [""; 0]);
    }
    let judged = with([0.25, 0.5, 9.0]);
    fails(&judged, "1 edge pixel shows neither of what is on both sides");
    assert_eq!((judged.numbers.edge_off, judged.numbers.interior_off), (1, 0));
    // All edges at once, where only half of them may be.
    let all = held.floats(|x, y, c| {
        let around = held.around[(y * 24 + x) as usize];
        around.map_or(c, |around| if c == around.low { around.high } else { around.low })
    });
    assert_eq!(held.judged(&all, plain()).findings, [""; 0]);
    let levels = Levels::of(&all, plain()).unwrap();
    let judged = judge(&held.reference(), &levels, Allowance { edges: 0.5, ..STRICT });
    fails(&judged, "edge pixels differ: expected at most");
}

#[test]
fn of_many_samples_only_those_at_an_edge_may_show_either_side() {
    let many = "samples_per_pixel: 16, background";
    let scene = |more: &str| SCENE.replace("CHECK", "").replace("background", more);
    let foreign = |text: &str| held_of(text).floats(|_, _, c| c);
    for more in [many, &format!("filter: Gaussian(radius: 1.5), {many}"), "error: 0.01, background"]
    {
        let around =
            |held: Held| Held { around: tracer::edges(&held.fixture.scene, 1.0 / 64.0), ..held };
        let held = around(held_of(&scene(more)));
        assert!(held.around.iter().flatten().all(|around| around.weight < 0.7), "{more}");
        assert_eq!(held.judged(&held.floats(|_, _, c| c), plain()).findings, [""; 0]);
        // One sample, no filter; a ball that is a tenth of a pixel larger.
        fails(&held.judged(&foreign(&scene("background")), plain()), "show neither");
        let larger = scene(more).replace("1.3", "1.325");
        fails(&held.judged(&foreign(&larger), plain()), "");
    }
}

#[test]
fn between_both_sides_is_not_enough_everywhere() {
    let fine = "(version: 1, image: (24, 16), camera: Parallel(view_point: (0, 0, 5), view_width: 24, \
                view_height: 16), objects: [Plane(point: (0.5, 0.5, 0), normal: (0, 0, 1), material: \
                Constant(color: (1, 1, 1), texture: Checker(a: (1, 1, 1), b: (0, 0, 0))))])";
    let held = held_of(fine);
    assert!(held.around.iter().all(Option::is_some));
    assert_eq!(held.judged(&held.floats(|_, _, c| c), plain()).findings, [""; 0]);
    let gray = held.floats(|_, _, _| Rgb::new(0.45, 0.45, 0.45));
    fails(&held.judged(&gray, plain()), "expected at least half of the picture to agree");
}

#[test]
fn what_would_make_it_right_is_said() {
    let held = held("");
    let hinted = |stored: &Stored| held.hinted(stored);
    let size = held.rendered.linear.size();
    let flipped = held.floats(|x, y, _| held.rendered.linear.get(x, size.height - 1 - y).unwrap());
    assert!(hinted(&flipped).unwrap().contains("rows: BottomFirst"));
    let gamma = held.codes(65_535, |c| libm::pow(c, 1.0 / 2.2));
    assert!(hinted(&gamma).unwrap().contains("transfer: Gamma22"));
    // Half a code less is rounded up where it would have been cut off.
    let cut = |c: f64| (c - 0.5 / 255.0).max(0.0);
    assert!(hinted(&held.codes(255, cut)).unwrap().contains("rounding: Down"));
    let both = held.floats(|x, y, _| {
        let pixel = held.rendered.linear.get(x, size.height - 1 - y).unwrap();
        Rgb::from(pixel.channels().map(|c| libm::pow(c, 1.0 / 2.2)))
    });
    let said = hinted(&both).unwrap();
    assert!(said.contains("rows: BottomFirst") && said.contains("transfer: Gamma22"), "{said}");
    assert_eq!(hinted(&held.floats(|_, _, c| c * 0.5)), None);
    let turned = Meaning { rows: Rows::BottomFirst, ..plain() };
    assert_eq!(held.judged(&flipped, turned).findings, [""; 0]);
}

#[test]
fn exchanged_sides_are_told() {
    let held = held_of(TILTED);
    let Size { width, height } = held.rendered.linear.size();
    let at = |x, y| held.rendered.linear.get(x, y).unwrap();
    let mirrored = held.floats(|x, y, _| at(width - 1 - x, y));
    assert_eq!(
        held.hinted(&mirrored).unwrap(),
        "its interior would be right mirrored left to right"
    );
    let both = held.floats(|x, y, _| at(width - 1 - x, height - 1 - y));
    assert_eq!(
        held.hinted(&both).unwrap(),
        "its interior would be right mirrored left to right and upside down \
         (`rows: BottomFirst` in its adapter)"
    );
    // As the squares of a larger file are the pixels of a smaller one.
    let grid = Held { fixture: held.fixture.clone(), ..held_of(TILTED) };
    let large = |x: u32, y: u32| {
        let share = if (x + y).is_multiple_of(2) { 0.5 } else { 1.5 };
        grid.rendered.linear.get(x / 2, y / 2).unwrap() * share
    };
    let size = Size { width: 2 * width, height: 2 * height };
    let file = LinearImage::from_fn(size, |x, y| large(2 * width - 1 - x, y));
    let file = Stored::read(&to_exr(&file).unwrap()).unwrap();
    let levels = Levels::of(&file, plain()).unwrap().gathered(2);
    let judged = judge(&grid.reference(), &levels, STRICT);
    let hinted = hint(&grid.reference(), (&file, 2), plain(), (STRICT, &judged));
    assert!(hinted.unwrap().ends_with("mirrored left to right"));
}

#[test]
fn codes_that_were_cut_off_are_told() {
    let held = held_of(TILTED);
    // Codes are rounded to the nearest in the file: these are at one already.
    let hinted = |cut: fn(f64) -> f64| held.hinted(&held.codes(255, cut)).unwrap();
    let down = hinted(|c| (255.0 * c).floor() / 255.0);
    assert!(down.contains("(`rounding: Down` in its adapter)"), "{down}");
    let down = hinted(|c| (256.0 * c).floor().min(255.0) / 255.0);
    assert!(down.contains("(`rounding: DownOfMore` in its adapter)"), "{down}");
}

#[test]
fn single_precision_is_told_from_what_is_a_little_wrong() {
    /// With pixels off by these shares: of most, and of every seventh.
    #[track_caller]
    fn check(most: [f64; 2], some: [f64; 2], is_single: bool) {
        let held = held_of(TILTED);
        let picture = held.floats(|x, y, c| {
            let shares = if (x + 3 * y).is_multiple_of(7) { some } else { most };
            c * (1.0 + shares[((x + y) % 2) as usize])
        });
        assert_ne!(held.judged(&picture, plain()).numbers.interior_off, 0);
        let said = held.hinted(&picture).unwrap_or_default();
        let is_told = said.ends_with("(`tolerance: 1e-3` in its adapter)");
        assert_eq!(is_told, is_single, "{most:?} {some:?} {said}");
    }
    check([-3e-7, 3e-7], [-9e-4, 9e-4], true);
    check([-2e-6, 2e-6], [-2e-5, 2e-5], true);
    // Beyond what is proposed in any pixel.
    check([-3e-7, 3e-7], [-1.1e-3, 9e-4], false);
    // A light that is 0.05 % too bright, and one that is so only here and there.
    check([5e-4, 5e-4], [5e-4, 5e-4], false);
    check([3e-7, 3e-7], [5e-4, 5e-4], false);
    // One at another place: more here, less there, and everywhere by much.
    check([-5e-4, 5e-4], [-5e-4, 5e-4], false);
    // Every seventh pixel, where all others are exact.
    check([0.0, 0.0], [-5e-4, 5e-4], false);
    // Twelve of all pixels say nothing.
    let held = held_of(TILTED);
    let share = |x: u32| [-3e-7, 3e-7, 5e-4][if x == 12 { 2 } else { (x % 2) as usize }];
    let few = held.floats(
        |x, y, c| {
            if y == 6 && (7..19).contains(&x) { c * (1.0 + share(x)) } else { c }
        },
    );
    assert_ne!(held.judged(&few, plain()).numbers.interior_off, 0);
    assert_eq!(held.hinted(&few), None);
}

#[test]
fn samples_in_corners_are_told() {
    /// With samples so far from the middles of pixels, to the right and up, in pixels.
    #[track_caller]
    fn check(right: f64, up: f64, expected: Option<&str>) {
        let held = held_of(TILTED);
        let scene = &held.fixture.scene;
        let picture = held.floats(|x, y, _| {
            let [a, b] = [f64::from(x) + 0.5 + right, 15.5 - f64::from(y) + up];
            let ray = scene.camera().ray(a / 4.0 - 3.0, b / 4.0 - 2.0);
            scene.trace(&ray, tracer::Interval::AHEAD)
        });
        assert_ne!(held.judged(&picture, plain()).numbers.interior_off, 0);
        let said = held.hinted(&picture);
        let said = said.map(|said| said.split(" in the ").last().unwrap().to_owned());
        let expected = expected.map(|corner| format!("{corner} corners, half a pixel off"));
        assert_eq!(said, expected, "({right}, {up})");
    }
    check(-0.5, 0.5, Some("top left"));
    check(-0.5, -0.5, Some("bottom left"));
    check(0.5, 0.5, Some("top right"));
    check(0.5, -0.5, Some("bottom right"));
    check(-0.25, 0.5, None);
    check(0.5, 0.0, None);
}

#[test]
fn where_only_edges_are_off_nothing_is_guessed() {
    let held = held("");
    let [at, _] = held.edge_and_interior();
    let wrong = Rgb::new(0.0, 0.0, 9.0);
    let picture = held.floats(|x, y, c| if (x, y) == at { wrong } else { c });
    assert_ne!(held.judged(&picture, plain()).findings, [""; 0]);
    assert_eq!(held.hinted(&picture), None);
}

#[test]
fn what_is_known_on_paper_is_asked() {
    /// With every pixel of the picture times `factor`, the tolerance being wide.
    #[track_caller]
    fn check(expect: &str, factor: f64, expected: Option<&str>) {
        let held = held(expect);
        let levels = Levels::of(&held.floats(|_, _, c| c * factor), plain()).unwrap();
        let scale = Scale::of(&held.rendered.linear);
        let found = expect::broken(&held.reference(), &levels, scale, 1e-5);
        match expected {
            None => assert_eq!(found, [""; 0]),
            Some(expected) => assert!(found[0].contains(expected), "{found:?}"),
        }
    }
    let pixel = "Pixel(at: (0, 0), rgb: (136, 186, 99))";
    check(pixel, 1.0, None);
    check(pixel, 1.1, Some("pixel (0, 0): expected the 8-bit color (136, 186, 99)"));
    let radiance = "Radiance(at: (12, 8), rgb: (1, 0, 0.5), within: 1e-3)";
    check(radiance, 1.0009, None);
    check(radiance, 1.002, Some("radiance of pixel (12, 8)"));
    let ratio = "Ratio(of: (0, 0), to: (23, 0), is: 1)";
    check(ratio, 3.0, None);
    check("Ratio(of: (0, 0), to: (23, 0), is: 1.5)", 1.0, Some("ratio of pixels"));
    let count = "Count(rgb: (136, 186, 99), pixels: 300)";
    check(count, 1.0, None);
    check(count, 0.5, Some("pixels of color (136, 186, 99): expected 300, found 0 to"));
    check("Mirror(LeftRight)", 1.0, None);
}

#[test]
fn a_mirror_that_is_broken_is_said() {
    let held = held("Mirror(LeftRight)");
    let [_, at] = held.edge_and_interior();
    let one = held.floats(|x, y, c| if (x, y) == at { c * 2.0 } else { c });
    fails(&held.judged(&one, plain()), "LeftRight mirror: pixels (0, 0) and (23, 0)");
}
