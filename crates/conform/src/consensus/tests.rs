//! Who is told to be the odd one out, and where.

use std::collections::BTreeMap;

use harness::encode::EncodedImage;
use harness::fixture::Fixture;
use scene::NoAssets;
use tracer::accel::Build;

use super::*;
use crate::trial::{self, Damage, Trial, judged};

/// A gray picture of one row of pixels for each text: its digits, in tenths.
fn gray(rows: &[&str]) -> LinearImage {
    let size = Size { width: rows[0].len() as u32, height: rows.len() as u32 };
    let pixel = |c: char| {
        let value = c.to_digit(10).map_or(f64::NAN, |digit| f64::from(digit) / 10.0);
        Rgb::new(value, value, value)
    };
    let pixels = rows.concat().chars().map(pixel).collect();
    LinearImage::from_pixels(size, pixels).unwrap()
}

/// Runs of one fixture `f`: goldray's picture, then those of `a`, `b` and so on.
/// Pixels that are `x` in `edges` are edges.
fn runs(reference: &[&str], edges: &[&str], pictures: &[&[&str]]) -> Vec<Conformed> {
    let edges: Vec<_> = edges.concat().chars().map(|c| c == 'x').collect();
    let one = |(id, rows): (char, &&[&str])| {
        let mut run = trial::run(&id.to_string());
        run.fixtures.insert("f".to_owned(), trial::result(crate::Outcome::Pass, 0.0));
        let evidence = judged(gray(reference), gray(rows), edges.clone());
        Conformed { run, evidence: BTreeMap::from([("f".to_owned(), evidence)]) }
    };
    ('a'..).zip(pictures).map(one).collect()
}

fn tell(runs: &[Conformed]) -> Option<Told> {
    of_fixture("f", runs, &|| None)
}

#[track_caller]
fn check(reference: &str, pictures: &[&str], expected: &[&str]) {
    let rows: Vec<_> = pictures.iter().map(|row| vec![*row]).collect();
    let rows: Vec<&[&str]> = rows.iter().map(Vec::as_slice).collect();
    let told = tell(&runs(&[reference], &[&".".repeat(reference.len())], &rows)).unwrap();
    let said = told.regions.iter().map(|region| {
        let words = region.opinion.words(&told.voters);
        format!("{} px {:?}..{:?}: {words}", region.pixels, region.from, region.to)
    });
    assert_eq!(said.collect::<Vec<_>>(), expected, "{reference} {pictures:?}");
}

#[test]
fn the_odd_one_is_told_by_region() {
    check("?", &["?", "?"], &["1 px (0, 0)..(0, 0): all differ"]);
    check("12", &["12", "12"], &[]);
    check("1234", &["1235", "1234"], &["1 px (3, 0)..(3, 0): a stands alone"]);
    check("1234", &["9934", "1234"], &["2 px (0, 0)..(1, 0): a stands alone"]);
    check("1234", &["1834", "1834"], &["1 px (1, 0)..(1, 0): goldray stands alone"]);
    check(
        "11111",
        &["31113", "11141"],
        &[
            "1 px (0, 0)..(0, 0): a stands alone",
            "1 px (3, 0)..(3, 0): b stands alone",
            "1 px (4, 0)..(4, 0): a stands alone",
        ],
    );
    check("1111", &["1222", "1333"], &["3 px (1, 0)..(3, 0): all differ"]);
    check(
        "11",
        &["22", "11", "22"],
        &["2 px (0, 0)..(1, 0): two against two: goldray and b against a and c"],
    );
    check("1", &["2", "2", "1", "1"], &["1 px (0, 0)..(0, 0): a and b are against the majority"]);
}

#[test]
fn regions_are_told_by_size_and_boxes_hold_them() {
    let wrong: &[&str] = &["11111", "19111", "11919", "11199"];
    let right: &[&str] = &["11111"; 4];
    let told = tell(&runs(right, &["....."; 4], &[wrong, right])).unwrap();
    let found: Vec<_> = told.regions.iter().map(|r| (r.pixels, r.from, r.to)).collect();
    assert_eq!(found, [(5, (1, 1), (4, 3))], "over corners too");
    assert_eq!(told.untold, (0, 0));
}

#[test]
fn edges_are_counted_apart() {
    let told = tell(&runs(&["1111"], &["xx.."], &[&["2121"], &["1111"]])).unwrap();
    let alone = Opinion::Against(Voters::NONE.with(1));
    assert_eq!(told.opinions[&alone], Pixels { interior: 1, edge: 1 });
    assert_eq!(told.opinions[&Opinion::Agree], Pixels { interior: 1, edge: 1 });
    assert_eq!(told.regions.len(), 1);
    // Only edges: no region, and it is still seen.
    let told = tell(&runs(&["1111"], &["xx.."], &[&["2111"], &["1111"]])).unwrap();
    assert!(told.regions.is_empty() && told.map.len() == 4);
}

#[test]
fn fewer_than_three_are_not_told() {
    let two = runs(&["1"], &["."], &[&["1"]]);
    assert_eq!(tell(&two), None);
    // goldray's own adapter is no second vote.
    let mut three = runs(&["1"], &["."], &[&["1"], &["2"]]);
    three[0].run.renderer.id = GOLDRAY.to_owned();
    assert_eq!(tell(&three), None);
    // One without a picture is said to be unheard.
    let mut four = runs(&["1"], &["."], &[&["1"], &["2"], &["1"]]);
    four[1].evidence.clear();
    let told = tell(&four).unwrap();
    assert_eq!((told.voters, told.unheard), (words("goldray a c"), words("b")));
    // One that was not asked for the fixture is not.
    four[1].run.fixtures.clear();
    assert_eq!(tell(&four).unwrap().unheard, [""; 0]);
    assert_eq!(of_fixture("g", &four, &|| None), None);
}

fn words(text: &str) -> Vec<String> {
    text.split(' ').map(str::to_owned).collect()
}

#[test]
fn pictures_that_do_not_fit_are_unheard() {
    let mut all = runs(&["11"], &[".."], &[&["11"], &["11"], &["11"], &["11"]]);
    all[0].evidence.get_mut("f").unwrap().actual = gray(&["1", "1"]);
    all[1].evidence.get_mut("f").unwrap().reference = gray(&["12"]);
    all[2].evidence.get_mut("f").unwrap().off.pop();
    assert_eq!(tell(&all), None, "of the four, one is left, and goldray");
    all[0].evidence.get_mut("f").unwrap().actual = gray(&["11"]);
    assert!(tell(&all).is_some());
    all[0].evidence.get_mut("f").unwrap().high = gray(&["1"]);
    assert_eq!(tell(&all), None);
}

#[test]
fn no_more_are_heard_than_can_be() {
    let pictures = vec![&["1"][..]; 12];
    let told = tell(&runs(&["1"], &["."], &pictures)).unwrap();
    assert_eq!((told.voters.len(), told.unheard.len()), (MOST_VOTERS, 13 - MOST_VOTERS));
}

#[test]
fn values_that_files_cannot_tell_apart_agree() {
    /// Whether two agree whose numbers stand for these, where neither agrees with goldray.
    #[track_caller]
    fn check(a: [f64; 3], b: [f64; 3], expected: bool) {
        let mut all = runs(&["9"], &["."], &[&["1"], &["1"]]);
        for (one, values) in all.iter_mut().zip([a, b]) {
            let evidence = one.evidence.get_mut("f").unwrap();
            let [low, nominal, high] = values.map(|value| {
                LinearImage::from_fn(Size { width: 1, height: 1 }, |_, _| Rgb::new(0.0, value, 0.0))
            });
            (evidence.low, evidence.actual, evidence.high) = (low, nominal, high);
        }
        let opinion = *tell(&all).unwrap().opinions.keys().next().unwrap();
        let alone = Opinion::Against(Voters::NONE.with(0));
        assert_eq!(opinion == alone, expected, "{a:?} {b:?}: {opinion:?}");
    }
    let exact = |value| [value; 3];
    let (least, most) = (f64::NEG_INFINITY, f64::INFINITY);
    check(exact(0.5), exact(0.5), true);
    check(exact(0.5), exact(0.5 + 4e-6), true);
    check(exact(0.5), exact(0.5 + 6e-6), false);
    check([0.499, 0.5, 0.501], exact(0.501), true);
    check([0.499, 0.5, 0.501], exact(0.502), false);
    check(exact(0.498), [0.499, 0.5, 0.501], false);
    // Codes beside each other say that it is another value, also of finer steps.
    check([0.499, 0.5, 0.501], [0.501, 0.502, 0.503], false);
    check([0.499, 0.5, 0.501], [0.5005, 0.502, 0.5035], true);
    // Clamped to white, it may be anything brighter; to black, anything darker.
    check([0.99, 1.0, most], exact(7.0), true);
    check([0.99, 1.0, most], exact(0.9), false);
    check([least, 0.0, 0.001], exact(-3.0), true);
    // In the dark, relative to a hundredth of the picture's brightest.
    check(exact(0.0), exact(0.8e-7), true);
    check(exact(0.0), exact(1.1e-7), false);
    check(exact(most), exact(most), false);
    check(exact(most), exact(1.0), false);
    check(exact(f64::NAN), exact(f64::NAN), false);
}

#[test]
fn two_that_agree_with_goldray_agree_with_each_other() {
    let mut all = runs(&["5"], &["."], &[&["5"], &["5"]]);
    for (one, value) in all.iter_mut().zip([0.5 - 4e-6, 0.5 + 4e-6]) {
        let evidence = one.evidence.get_mut("f").unwrap();
        let actual = LinearImage::from_fn(evidence.actual.size(), |_, _| Rgb::new(value, 0.0, 0.0));
        evidence.low = actual.clone();
        evidence.high = actual.clone();
        evidence.actual = actual;
    }
    let opinions: Vec<_> = tell(&all).unwrap().opinions.into_keys().collect();
    assert_eq!(opinions, [Opinion::Agree]);
}

const BALL: &str = "(version: 1, image: (24, 24), show: SurfaceColor,
    camera: Parallel(view_point: (0, 0, 5), view_width: 4, view_height: 4),
    objects: [
        Box(min: (-1, -1, 0), max: (1, 1, 0), material: Lambert(diffuse: (0.2, 0.5, 0.1))),
    ])";

#[test]
fn a_wrong_object_is_named_by_its_place() {
    let fixture = Fixture::read("f", BALL, &NoAssets, Build::Bvh).unwrap();
    let all = BTreeMap::from([("f".to_owned(), fixture)]);
    let wrong = Trial::right("w").with(Damage::Recolor(0)).run(&all);
    let runs = [Trial::right("r").run(&all), wrong];
    let told = of_fixture("f", &runs, &|| Some(Objects::of(&all["f"]))).unwrap();
    let [region] = &told.regions[..] else { panic!("{:?}", told.regions) };
    assert_eq!(region.opinion.words(&told.voters), "w stands alone");
    // Twelve by twelve pixels, without those beside the background.
    assert_eq!((region.pixels, region.from, region.to), (100, (7, 7), (16, 16)));
    let (seen, count) = region.on.clone().unwrap();
    assert_eq!((seen.words("x.ron").as_str(), count), ("the Box of x.ron:4:9", 100));

    let base = EncodedImage::from_fn(told.size, |_, _| [90; 3]);
    let edges = &runs[0].evidence["f"].edges;
    let picture = disagreement(&told, &base, edges).unwrap();
    assert_eq!(picture.get(12, 12), Some(COLORS[2]));
    assert_eq!(picture.get(6, 6), Some(COLORS[2].map(|code| code / 2)), "an edge");
    assert_eq!(picture.get(0, 0), Some([30; 3]));

    let sum = overall([("f", &told)].into_iter());
    assert_eq!((sum.fixtures, sum.agreed, sum.undecided), (1, 0, 0));
    let share = &sum.voters["w"];
    assert_eq!(share.alone, Pixels { interior: 100, edge: 44 });
    assert_eq!(share.alone_in, [("f".to_owned(), 100)]);
    assert_eq!(sum.voters["r"].alone, Pixels::default());
}

#[test]
fn all_in_agreement_have_no_picture() {
    let told = tell(&runs(&["12"], &["x."], &[&["12"], &["12"]])).unwrap();
    let base = EncodedImage::from_fn(told.size, |_, _| [9; 3]);
    assert_eq!(disagreement(&told, &base, &[]), None);
    let sum = overall([("f", &told), ("g", &told)].into_iter());
    assert_eq!((sum.fixtures, sum.agreed), (2, 2));
}

/// What `a`'s picture stands for where each number is within half a step to both sides.
fn in_steps(runs: &mut [Conformed], step: f64) {
    let evidence = runs[0].evidence.get_mut("f").unwrap();
    let moved = |by: f64| {
        let size = evidence.actual.size();
        let pixel = |x, y| evidence.actual.get(x, y).unwrap() + Rgb::new(by, by, by);
        LinearImage::from_fn(size, pixel)
    };
    let [low, high] = [-step / 2.0, step / 2.0].map(moved);
    (evidence.low, evidence.high) = (low, high);
}

#[test]
fn who_says_nothing_has_no_vote() {
    #[track_caller]
    fn check(reference: &[&str], a: &[&str], step: f64, is_heard: bool) {
        let edges = vec!["...."; reference.len()];
        let mut runs = runs(reference, &edges, &[a, reference, reference]);
        in_steps(&mut runs, step);
        let told = tell(&runs).unwrap();
        let unheard: &[&str] = if is_heard { &[] } else { &["a"] };
        assert_eq!(told.unheard, unheard, "{reference:?} {a:?} {step}");
    }
    // Nothing was drawn; a single pixel is something.
    check(&["1234"], &["1111"], 0.0, false);
    check(&["1234"], &["1112"], 0.0, true);
    // The scene is of one color itself, and this is the right one, or another.
    check(&["1111"], &["1111"], 0.0, true);
    check(&["1111"], &["2222"], 0.0, true);
    // Codes that are coarser than all that is seen.
    check(&["1121"], &["1121"], 0.09, true);
    check(&["1121"], &["1121"], 0.11, false);
    check(&["1131"], &["1131"], 0.11, true);
    // What is no number is nothing that could be of one color.
    check(&["1234"], &["1?11"], 0.0, true);
    // Clamped as a whole: anything above.
    let mut clamped = runs(&["1234"], &["...."], &[&["9999"], &["1234"], &["1234"]]);
    let evidence = clamped[0].evidence.get_mut("f").unwrap();
    evidence.high = LinearImage::from_fn(evidence.high.size(), |_, _| {
        Rgb::new(f64::INFINITY, f64::INFINITY, f64::INFINITY)
    });
    assert_eq!(tell(&clamped).unwrap().unheard, ["a"]);
    // Then two are too few.
    assert_eq!(tell(&clamped[..2]), None);
}
