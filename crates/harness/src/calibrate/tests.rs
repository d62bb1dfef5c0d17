//! A spread that is there is seen, and nothing else is.

use tracer::{LinearImage, Rgb, Size};

use super::*;
use crate::encode::{Transfer, encode};
use crate::limits::Limits;

/// A gray picture with one pixel that is brighter by so much.
fn picture(by: f64) -> Rendered {
    let size = Size { width: 16, height: 16 };
    let pixels = (0..256).map(|i| Rgb::from([if i == 77 { 0.5 + by } else { 0.5 }; 3]));
    let linear = LinearImage::from_pixels(size, pixels.collect()).unwrap();
    let encoded = encode(&linear, Transfer::Gamma22).unwrap();
    Rendered { linear, encoded }
}

/// The spread of a renderer that is off by so much where its way says so.
fn spread(by: f64, is_off: impl Fn(&Way) -> bool + Sync) -> Spread {
    let ways = Ways::new(2).unwrap();
    spread_of(&ways, &|way| Ok(picture(if is_off(way) { by } else { 0.0 }))).unwrap().1
}

#[test]
fn a_good_renderer_has_no_spread_and_no_limits() {
    let found = spread(0.1, |_| false);
    assert_eq!(found, Spread::default());
    assert!(found.is_none() && found.justified().is_none());
}

#[test]
fn each_way_can_have_a_spread_of_its_own() {
    let levels = tracer::Instructions::all();
    let last = *levels.last().unwrap();
    let ways = 2 * levels.len() as u64;
    let threads = spread(0.1, |way| way.threads == 7);
    assert_eq!(threads.other_bits, ways);
    // With a single level all are off together. On x86-64 there are two and more.
    let others = if levels.len() > 1 { 8 } else { 0 };
    assert!(others > 0 || cfg!(not(target_arch = "x86_64")));
    assert_eq!(spread(0.1, |way| way.instructions == last).other_bits, others);
    assert_eq!(spread(0.1, |way| way.repeat == 1).other_bits, ways / 2 * 4);
    // 0.5 is code 186, 0.6 is 202.
    assert_eq!((threads.max_abs, threads.differing_pixels), (16, 1));
    assert!(threads.ssim_worst < threads.ssim && threads.ssim < 1.0, "{threads:?}");
}

#[test]
fn the_number_of_threads_is_the_one_that_is_asked_for() {
    let ways = Ways::new(1).unwrap();
    let asked = |way: &Way| ways.install(way, rayon::current_num_threads) == way.threads;
    assert!(ways.all().iter().all(asked));
}

#[test]
fn bits_that_no_code_shows_are_seen_and_justify_nothing() {
    let found = spread(1e-15, |way| way.threads == 2);
    assert!(found.other_bits > 0 && found.is_none(), "{found:?}");
    assert_eq!(found.justified(), None);
}

#[test]
fn limits_may_be_twice_the_spread() {
    let found = spread(0.1, |way| way.threads == 7);
    let fields = |limits: Limits| found.looser(&limits).iter().map(|l| l.0).collect::<Vec<_>>();
    let none = Limits::default();
    assert_eq!(fields(Limits { max_abs: Some(32), ..none.clone() }), [""; 0]);
    assert_eq!(fields(Limits { max_abs: Some(33), ..none.clone() }), ["max_abs"]);
    assert_eq!(fields(Limits { differing_pixels: Some(2), ..none.clone() }), [""; 0]);
    assert_eq!(fields(Limits { differing_pixels: Some(3), ..none.clone() }), ["differing_pixels"]);
    let worst = 1.0 - 2.0 * (1.0 - found.ssim_worst);
    assert_eq!(fields(Limits { ssim: Some(worst), ..none.clone() }), [""; 0]);
    assert_eq!(fields(Limits { ssim: Some(worst - 1e-5), ..none.clone() }), ["ssim"]);
    // Where nothing differs, any limit is too loose.
    let tight = Limits { max_abs: Some(1), ssim: Some(0.999_999), ..none };
    assert_eq!(Spread::default().looser(&tight).len(), 2);
}

#[test]
fn pictures_that_have_nothing_in_common_justify_no_such_limit() {
    let apart = Spread::of(None).justified().unwrap();
    assert_eq!((apart.ssim, apart.ssim_worst, apart.max_abs), (None, None, None));
    let loose = Limits { ssim: Some(0.1), max_abs: Some(254), ..Limits::default() };
    assert_eq!(Spread::of(None).looser(&loose).len(), 2);
}

/// What a build found of one fixture.
fn record(linear: &str, spread: Spread) -> Record {
    let fixture = Calibrated {
        fixture: "a".into(),
        linear: linear.into(),
        encoded: "e".into(),
        spread,
        has_limits: false,
    };
    Record { schema: 1, build: "dev".into(), ways: 1, margin: MARGIN, fixtures: vec![fixture] }
}

#[test]
fn builds_are_held_against_each_other() {
    let none = Spread::default();
    let some = Spread { other_bits: 1, max_abs: 3, differing_pixels: 5, ..none };
    let together = |builds: [Record; 2]| {
        let report = Report::new(builds.into(), &|_| Ok(some)).unwrap();
        (report.fixtures[0].spread, report.surprises().count())
    };
    assert_eq!(together([record("l", none), record("l", none)]), (none, 0));
    assert_eq!(together([record("l", none), record("l", some)]), (some, 1));
    assert_eq!(together([record("l", none), record("m", none)]), (some, 1), "other bits");
    let missing = Record { fixtures: Vec::new(), ..record("l", none) };
    let lacks = Report::new(vec![record("l", none), missing], &|_| Ok(none)).unwrap_err();
    assert!(lacks.contains("left it out"), "{lacks}");
}
