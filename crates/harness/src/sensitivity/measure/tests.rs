//! Scratch goldens under tight and loose limits: what is caught, and from which
//! strength on.

use tracer::{LinearImage, Rgb, Size};

use super::*;
use crate::expectation::Rendered;
use crate::fixture::{Build, Fixture};
use crate::golden::Golden;
use crate::judge::{Found, judge};
use crate::verdict::Verdict;

/// Fine stripes beside a smooth ramp, in color.
fn golden() -> EncodedImage {
    EncodedImage::from_fn(Size { width: 48, height: 32 }, |x, y| {
        if x < 24 {
            let stripe = if (x + y) % 2 == 0 { 230 } else { 20 };
            [stripe, 200, 255 - stripe]
        } else {
            [(60 + 3 * x) as u8, (40 + 4 * y) as u8, 90]
        }
    })
}

fn defect(name: &str) -> &'static Defect {
    DEFECTS.iter().find(|defect| defect.name == name).unwrap()
}

fn measured(name: &str, limits: Option<&Limits>, golden: &EncodedImage) -> Cell {
    cell(defect(name), limits, golden, &Visible::default())
}

#[track_caller]
fn check(name: &str, limits: &Limits, strength: f64) {
    let found = measured(name, Some(limits), &golden()).smallest;
    let Smallest::Caught { strength: found, .. } = found else { panic!("{found:?}") };
    assert_eq!(found, strength, "{name}");
}

#[test]
fn without_limits_one_code_of_one_pixel_is_caught() {
    for blob in ["blob-1", "blob-2", "blob-4"] {
        let found = measured(blob, None, &golden());
        assert!(matches!(found.smallest, Smallest::Caught { strength: 1.0, .. }), "{found:?}");
        assert_eq!(found.missed, None);
    }
    for Defect { name, .. } in DEFECTS {
        let found = measured(name, None, &golden()).times_visible.unwrap();
        assert!(found <= 1.0, "{name}: {found}");
    }
}

/// From below without limits, from above with the limit that means the same.
#[test]
fn both_ways_of_searching_find_the_same() {
    let none = Limits { differing_pixels: Some(0), reason: "a test".into(), ..Limits::default() };
    for Defect { name, .. } in DEFECTS {
        let (below, above) =
            (measured(name, None, &golden()), measured(name, Some(&none), &golden()));
        assert_eq!(below.smallest, above.smallest, "{name}");
    }
}

#[test]
fn a_limit_on_codes_is_found_to_the_code() {
    check("blob-1", &Limits { max_abs: Some(9), ..Limits::default() }, 10.0);
    check("blob-4", &Limits { max_abs: Some(100), ..Limits::default() }, 101.0);
}

#[test]
fn a_limit_on_pixels_is_found_to_the_pixel() {
    let limits = |pixels: u64| Limits { differing_pixels: Some(pixels), ..Limits::default() };
    check("blob-4", &limits(15), 1.0);
    let limits = Limits { reason: "a test".into(), ..limits(16) };
    let found = measured("blob-4", Some(&limits), &golden());
    assert!(matches!(found.smallest, Smallest::Never { .. }), "{found:?}");
    assert_eq!(found.times_visible, Some(f64::INFINITY));
    assert!(found.missed.is_some());
}

#[test]
fn a_loose_ssim_lets_visible_defects_pass() {
    let loose = Limits { ssim: Some(0.98), reason: "a test".into(), ..Limits::default() };
    // A spot that anyone sees on a smooth surface is missed among the stripes.
    let blob = measured("blob-2", Some(&loose), &golden());
    assert!(blob.missed.is_some_and(|miss| miss.strength >= 16.0 && miss.change >= 16), "{blob:?}");
    let Some(Miss { place: Place::At(x, _), .. }) = blob.missed else { panic!("{blob:?}") };
    assert!(x < 24, "{blob:?}");
    let gain = measured("gain", Some(&loose), &golden());
    assert!(gain.missed.is_some() && gain.times_visible.unwrap() > 1.0, "{gain:?}");
    // A mean alone sees no spot at all.
    let mean = Limits { ssim: Some(0.9), ssim_worst: Some(1e-9), ..loose };
    let found = measured("blob-1", Some(&mean), &golden()).smallest;
    assert!(matches!(found, Smallest::Never { .. }), "{found:?}");
}

#[test]
fn what_moves_few_codes_is_not_seen_unless_a_command_says_so() {
    let limits = Limits { max_abs: Some(3), reason: "a test".into(), ..Limits::default() };
    let misses = |texts: &[&str]| {
        let texts: Vec<_> = texts.iter().map(|&text| text.to_owned()).collect();
        let visible = Visible::from_texts(&texts).unwrap();
        let is_missed = |d: &&Defect| missed(d, Some(&limits), &golden(), &visible).is_some();
        DEFECTS.iter().filter(is_missed).map(|defect| defect.name).collect::<Vec<_>>()
    };
    assert_eq!(misses(&[]), [""; 0]);
    assert_eq!(misses(&["change=3", "blob-2=3"]), ["blob-2"]);
    // Half a percent of the lightest code, 255, is one code.
    assert_eq!(misses(&["gain=0.5"]), [""; 0]);
    assert_eq!(misses(&["change=1", "gain=0.5"]), ["gain"]);
}

#[test]
fn what_changes_nothing_has_no_effect() {
    let flat = EncodedImage::from_fn(Size { width: 20, height: 20 }, |_, _| [90; 3]);
    for name in ["row", "shift-right", "shift-down", "hue", "blur"] {
        assert_eq!(measured(name, None, &flat).smallest, Smallest::NoEffect, "{name}");
    }
    let black = EncodedImage::from_fn(Size { width: 20, height: 20 }, |_, _| [0; 3]);
    assert_eq!(measured("gain", None, &black).smallest, Smallest::NoEffect);
    assert!(measured("noise", None, &black).times_visible.is_some());
    let pixel = EncodedImage::from_fn(Size { width: 1, height: 1 }, |_, _| [9; 3]);
    let found = measured("blob-4", None, &pixel).smallest;
    assert_eq!(found, Smallest::Caught { strength: 1.0, place: Place::At(0, 0) });
}

/// What is damaged by the defect `bumpy` goes up, down and up again.
#[test]
fn what_is_weaker_again_when_stronger_counts_at_its_strongest() {
    let bumpy = Defect {
        inject: |picture, _, strength| {
            let by = if strength as u8 == 8 { 1 } else { strength as u8 };
            EncodedImage::from_fn(picture.size(), |_, _| [100 + by; 3])
        },
        strengths: Strengths { least: 1.0, most: 100.0, whole: true },
        ..*defect("gain")
    };
    let flat = EncodedImage::from_fn(Size { width: 4, height: 4 }, |_, _| [100; 3]);
    let limits = Limits { max_abs: Some(2), reason: "a test".into(), ..Limits::default() };
    let places = vec![Place::Whole];
    let search = Search { defect: &bumpy, limits: Some(&limits), golden: &flat, places };
    assert_eq!(search.smallest(), Smallest::Caught { strength: 9.0, place: Place::Whole });
}

#[test]
fn the_steps_lead_from_the_least_to_the_most() {
    for Defect { name, strengths, .. } in DEFECTS {
        let steps = strengths.steps();
        assert!(steps.is_sorted_by(|a, b| a < b), "{name}: {steps:?}");
        assert_eq!((steps[0], *steps.last().unwrap()), (strengths.least, strengths.most));
    }
}

/// The judge of `cargo xtask check`, for each defect at the strength that is
/// seen.
#[test]
fn what_is_caught_is_what_the_judge_calls_different() {
    let golden = golden();
    let linear = LinearImage::from_pixels(golden.size(), vec![Rgb::BLACK; 48 * 32]).unwrap();
    let mut verdicts = Vec::new();
    for limits in ["", "ssim: 0.98", "max_abs: 2", "differing_pixels: 20"] {
        let check = if limits.is_empty() {
            String::new()
        } else {
            format!("check: (limits: ({limits}, reason: \"a test\")),")
        };
        let text = format!(
            "(version: 1, image: (48, 32), {check}
                camera: LookAt(eye: (0, 0, 5), at: (0, 0, 0), fov_deg: 40))"
        );
        let fixture = Fixture::read("a", &text, &scene::NoAssets, Build::Bvh).unwrap();
        let provenance = Some(fixture.provenance.clone());
        let found = Found::Golden(Golden {
            picture: golden.clone(),
            provenance,
            accepted: None,
            file_bytes: 0,
        });
        for defect in DEFECTS {
            let place = (defect.places)(&golden)[0];
            let encoded = (defect.inject)(&golden, place, defect.visible);
            let caught = is_caught(fixture.check.limits.as_ref(), &golden, &encoded);
            let picture = Rendered { linear: linear.clone(), encoded };
            let verdict = judge(&fixture, &picture, &found).verdict;
            assert_eq!(verdict == Verdict::Differs, caught, "{limits} {}", defect.name);
            verdicts.push(caught);
        }
    }
    assert!(verdicts.contains(&true) && verdicts.contains(&false), "{verdicts:?}");
}
