//! The metrics together: sizes, identity, and damage that each must see.

use std::collections::BTreeSet;

use tracer::Size;

use super::*;

fn picture(width: u32, height: u32, seed: u64) -> EncodedImage {
    let mut rng = fastrand::Rng::with_seed(seed);
    let bytes = (0..width * height * 3).map(|_| rng.u8(..)).collect();
    EncodedImage::from_bytes(Size { width, height }, bytes).unwrap()
}

#[test]
fn other_sizes_and_empty_pictures_are_not_compared() {
    #[track_caller]
    fn check(golden: (u32, u32), actual: (u32, u32)) {
        let (golden, actual) = (picture(golden.0, golden.1, 1), picture(actual.0, actual.1, 1));
        assert_eq!(compare(&golden, &actual), None);
    }
    check((0, 0), (0, 0));
    check((0, 5), (0, 5));
    check((5, 0), (0, 5));
    check((1, 1), (0, 0));
    check((4, 3), (3, 4));
    check((12, 1), (6, 2));
    check((8, 8), (8, 9));
}

#[test]
fn identical_pictures_take_no_other_value() {
    for (width, height) in [(1, 1), (1, 40), (2, 7), (8, 8), (9, 17), (64, 33)] {
        for seed in 0..4 {
            let golden = picture(width, height, seed);
            let pair = Pair::new(&golden, &golden).unwrap();
            assert!(pair.is_identical());
            assert_eq!(of_identical(), of_any(&pair), "{width}x{height}");
            assert!(compare(&golden, &golden).unwrap().is_identical());
        }
        for code in [0, 1, 128, 255] {
            let bytes = vec![code; (width * height * 3) as usize];
            let flat = EncodedImage::from_bytes(Size { width, height }, bytes).unwrap();
            let pair = Pair::new(&flat, &flat).unwrap();
            assert_eq!(of_identical(), of_any(&pair), "{width}x{height} of {code}");
        }
    }
}

/// A copy of `golden` with one byte one code away.
fn nudged(golden: &EncodedImage, index: usize) -> EncodedImage {
    let mut bytes = golden.bytes().to_vec();
    bytes[index] ^= 1;
    EncodedImage::from_bytes(golden.size(), bytes).unwrap()
}

#[test]
fn one_code_of_one_byte_is_seen_wherever_it_is() {
    let golden = picture(13, 12, 2);
    for index in 0..golden.bytes().len() {
        let found = compare(&golden, &nudged(&golden, index)).unwrap();
        let pixel = index as u32 / 3;
        assert!(!found.is_identical());
        assert_eq!((found.max_abs, found.differing_pixels), (1, 1));
        assert_eq!(found.first_differing, Some((pixel % 13, pixel / 13)));
        assert_eq!(found.pixels_over, [0; 8]);
        assert!(0.0 < found.rmse && found.psnr_db.is_some_and(f64::is_finite));
        assert!(found.ssim_min < 1.0 && found.ssim_mean < 1.0, "{index}: {found:?}");
        assert!(found.ssim_uniform_min < 1.0, "{index}: {found:?}");
        assert!(0.0 < found.flip_mean && found.flip_mean <= found.flip_max, "{index}: {found:?}");
    }
}

#[test]
fn swapping_golden_and_actual_changes_nothing() {
    let (golden, actual) = (picture(30, 21, 3), picture(30, 21, 4));
    assert_eq!(compare(&golden, &actual), compare(&actual, &golden));
}

/// The reason why a mean alone never decides: a ruined block hides in it.
#[test]
fn the_minimum_sees_what_the_mean_passes() {
    let golden = picture(256, 256, 5);
    let mut bytes = golden.bytes().to_vec();
    for y in 100..108 {
        for x in 100..108 {
            let at = (y * 256 + x) * 3;
            bytes[at..at + 3].fill(0);
        }
    }
    let actual = EncodedImage::from_bytes(golden.size(), bytes).unwrap();
    let found = compare(&golden, &actual).unwrap();
    assert!(0.99 < found.ssim_mean && found.ssim_min < 0.1, "{found:?}");
}

#[test]
fn every_metric_is_described_and_reads_its_own_field() {
    let names: BTreeSet<_> = METRICS.iter().map(|metric| metric.name).collect();
    assert_eq!(names.len(), METRICS.len());
    for metric in METRICS {
        for text in [metric.name, metric.measures, metric.range, metric.unit, metric.blind_spot] {
            assert!(!text.is_empty() && text.is_ascii(), "{}", metric.name);
        }
    }
    let found = compare(&picture(30, 21, 6), &picture(30, 21, 7)).unwrap();
    let values: Vec<_> = METRICS.iter().map(|metric| (metric.value)(&found)).collect();
    let expected = [
        Some(f64::from(found.max_abs)),
        Some(found.differing_pixels as f64),
        Some(found.ssim_min),
        Some(found.ssim_mean),
        Some(found.ssim_uniform_min),
        Some(found.ssim_uniform_mean),
        Some(found.flip_max),
        Some(found.flip_mean),
        Some(found.rmse),
        found.psnr_db,
        found.image_compare_mssim,
        found.image_compare_hybrid,
    ];
    assert_eq!(values, expected);
}

/// Identical pictures have the best value of every metric, others none better.
#[test]
fn directions_point_at_the_golden() {
    let golden = picture(30, 21, 8);
    let best = compare(&golden, &golden).unwrap();
    let other = compare(&golden, &picture(30, 21, 9)).unwrap();
    for metric in METRICS {
        let (Some(best), Some(other)) = ((metric.value)(&best), (metric.value)(&other)) else {
            assert_eq!(metric.name, "psnr_db");
            continue;
        };
        match metric.direction {
            Direction::HigherIsBetter => assert!(other < best, "{}", metric.name),
            Direction::LowerIsBetter => assert!(best < other, "{}", metric.name),
        }
    }
}
