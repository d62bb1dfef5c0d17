//! Limits: which hold, and which say nothing.

use tracer::Size;

use super::*;
use crate::encode::EncodedImage;
use crate::metric::compare;

fn limits() -> Limits {
    Limits { reason: "a test".into(), ..Limits::default() }
}

/// A gray 32 x 32 picture, and one with `count` pixels lighter by `by`.
fn comparison(count: usize, by: u8) -> Comparison {
    let size = Size { width: 32, height: 32 };
    let picture = |count: usize| {
        let bytes = (0..32 * 32).flat_map(|i| [if i < count { 100 + by } else { 100 }; 3]);
        EncodedImage::from_bytes(size, bytes.collect()).unwrap()
    };
    compare(&picture(0), &picture(count)).unwrap()
}

#[test]
fn without_limits_only_identical_pictures_match() {
    assert_eq!(Limits::broken_by(None, &comparison(0, 9)), [""; 0]);
    assert_eq!(Limits::broken_by(None, &comparison(1, 1)).len(), 1);
}

#[test]
fn each_stated_limit_holds_and_no_other() {
    let two_by_three = comparison(2, 3);
    let broken = |limits: Limits| Limits::broken_by(Some(&limits), &two_by_three).len();
    assert_eq!(broken(Limits { max_abs: Some(3), ..limits() }), 0);
    assert_eq!(broken(Limits { max_abs: Some(2), ..limits() }), 1);
    assert_eq!(broken(Limits { differing_pixels: Some(2), ..limits() }), 0);
    assert_eq!(broken(Limits { differing_pixels: Some(1), max_abs: Some(2), ..limits() }), 2);
}

#[test]
fn a_good_mean_does_not_hide_a_bad_window() {
    let blot = comparison(1, 155);
    assert!(blot.ssim_mean > 0.9 && blot.ssim_min < 0.5, "{blot:?}");
    let broken = |limits| Limits::broken_by(Some(&limits), &blot);
    let mean_only = Limits { ssim: Some(0.9), ssim_worst: Some(1e-9), ..limits() };
    assert_eq!(broken(mean_only), [""; 0]);
    let both = broken(Limits { ssim: Some(0.9), ..limits() });
    assert!(both[0].starts_with("worst window's SSIM"), "{both:?}");
}

#[test]
fn a_good_mean_does_not_hide_a_bad_pixel() {
    let blot = comparison(1, 155);
    assert!(blot.flip_mean < 0.01 && 0.3 < blot.flip_max, "{blot:?}");
    let broken = |limits| Limits::broken_by(Some(&limits), &blot);
    let mean_only = Limits { flip: Some(0.01), flip_worst: Some(0.99), ..limits() };
    assert_eq!(broken(mean_only), [""; 0]);
    let both = broken(Limits { flip: Some(0.01), ..limits() });
    assert!(both.len() == 1 && both[0].starts_with("worst pixel's FLIP"), "{both:?}");
    assert_eq!(broken(Limits { flip: Some(1e-6), ..limits() }).len(), 2);
}

#[test]
fn a_nan_keeps_no_limit() {
    let n = f64::NAN;
    let scores = Comparison { ssim_mean: n, ssim_min: n, ..comparison(1, 1) };
    let nan = Comparison { flip_mean: n, flip_max: n, ..scores };
    let limits = Limits { ssim: Some(0.5), flip: Some(0.5), ..limits() };
    assert_eq!(Limits::broken_by(Some(&limits), &nan).len(), 4);
}

#[test]
fn limits_that_say_nothing_are_problems() {
    let fields = |limits: Limits| limits.problems(1024).iter().map(|p| p.0).collect::<Vec<_>>();
    assert_eq!(fields(Limits { ssim: Some(0.99), ..limits() }), [""; 0]);
    let equal = Limits { ssim: Some(0.9), ssim_worst: Some(0.9), ..limits() };
    assert_eq!(fields(equal), [""; 0]);
    for never in [-1.0, 0.0, 1.0, 1.5, f64::NAN] {
        assert_eq!(fields(Limits { ssim: Some(never), ..limits() }), ["ssim"], "{never}");
        assert_eq!(fields(Limits { flip: Some(never), ..limits() }), ["flip"], "{never}");
    }
    for never in [0, 255] {
        assert_eq!(fields(Limits { max_abs: Some(never), ..limits() }), ["max_abs"]);
    }
    for never in [0, 1024, 9999] {
        let limits = Limits { differing_pixels: Some(never), ..limits() };
        assert_eq!(fields(limits), ["differing_pixels"]);
    }
    assert_eq!(fields(limits()), ["reason"]);
    assert_eq!(fields(Limits { max_abs: Some(1), reason: " ".into(), ..limits() }), ["reason"]);
    let worst_alone = Limits { ssim_worst: Some(0.5), max_abs: Some(1), ..limits() };
    assert_eq!(fields(worst_alone), ["ssim_worst"]);
    let upside_down = Limits { ssim: Some(0.5), ssim_worst: Some(0.9), ..limits() };
    assert_eq!(fields(upside_down), ["ssim_worst"]);
    let loose = Limits { flip: Some(0.01), flip_worst: Some(0.2), ..limits() };
    assert_eq!(fields(loose), [""; 0]);
    let upside_down = Limits { flip: Some(0.2), flip_worst: Some(0.1), ..limits() };
    assert_eq!(fields(upside_down), ["flip_worst"]);
    let worst_alone = Limits { flip_worst: Some(0.5), max_abs: Some(1), ..limits() };
    assert_eq!(fields(worst_alone), ["flip_worst"]);
}
