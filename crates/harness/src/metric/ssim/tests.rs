//! SSIM against its definition, written out window by window.

use tracer::Size;

use super::{C1, C2, Pair, Ssim, SsimMap, Window, scan, ssim, ssim_map, ssim_uniform};
use crate::encode::EncodedImage;

fn image(width: u32, height: u32, mut byte: impl FnMut(usize) -> u8) -> EncodedImage {
    let bytes = (0..(width * height * 3) as usize).map(&mut byte).collect();
    EncodedImage::from_bytes(Size { width, height }, bytes).unwrap()
}

fn noise(width: u32, height: u32, seed: u64) -> EncodedImage {
    let mut rng = fastrand::Rng::with_seed(seed);
    image(width, height, |_| rng.u8(..))
}

/// A copy of `golden`, each byte moved by up to `reach` codes.
fn shaken(golden: &EncodedImage, reach: u8, seed: u64) -> EncodedImage {
    let mut rng = fastrand::Rng::with_seed(seed);
    let bytes = golden.bytes();
    image(golden.size().width, golden.size().height, |i| {
        bytes[i].saturating_add(rng.u8(0..=reach)).saturating_sub(reach / 2)
    })
}

fn ssim_of(golden: &EncodedImage, actual: &EncodedImage) -> Ssim {
    ssim(&Pair::new(golden, actual).unwrap())
}

/// The pixel of a line of `pixels` seen at position `i`, which may lie beyond
/// either end: folded back at an end, in front of its outermost pixel, until it
/// lies inside.
fn reflect(i: i64, pixels: i64) -> i64 {
    if i < 0 {
        reflect(-1 - i, pixels)
    } else if pixels <= i {
        reflect(2 * pixels - 1 - i, pixels)
    } else {
        i
    }
}

/// A window as it is defined.
struct Definition {
    reach: i64,
    /// The weight of a pixel at a squared distance from the center.
    weight: fn(f64) -> f64,
    /// What covariances are multiplied by.
    factor: f64,
    computed: fn(&Pair<'_>) -> (Ssim, SsimMap),
}

const GAUSSIAN: Definition = Definition {
    reach: 5,
    weight: |squared| libm::exp(-squared / 4.5),
    factor: 1.0,
    computed: |pair| (ssim(pair), ssim_map(pair)),
};

const UNIFORM: Definition = Definition {
    reach: 3,
    weight: |_| 1.0,
    factor: 49.0 / 48.0,
    computed: |pair| (ssim_uniform(pair), scan(pair, &Window::uniform()).0),
};

/// The score of the window around pixel `(x, y)`: weighted means first, then
/// variances about them, with nothing separated or expanded.
fn score_by_definition(
    definition: &Definition,
    (golden, actual): (&EncodedImage, &EncodedImage),
    (x, y): (u32, u32),
    channel: usize,
) -> f64 {
    let Size { width, height } = golden.size();
    let mut window = Vec::new();
    let reach = definition.reach;
    for dy in -reach..=reach {
        for dx in -reach..=reach {
            let column = reflect(i64::from(x) + dx, width.into()) as u32;
            let row = reflect(i64::from(y) + dy, height.into()) as u32;
            let value = |image: &EncodedImage| f64::from(image.get(column, row).unwrap()[channel]);
            let weight = (definition.weight)((dx * dx + dy * dy) as f64);
            window.push((weight, value(golden), value(actual)));
        }
    }
    let total: f64 = window.iter().map(|w| w.0).sum();
    let mean = |f: &dyn Fn(f64, f64) -> f64| {
        window.iter().map(|&(weight, a, b)| weight * f(a, b)).sum::<f64>() / total
    };
    let (mu_a, mu_b) = (mean(&|a, _| a), mean(&|_, b| b));
    let var_a = definition.factor * mean(&|a, _| (a - mu_a).powi(2));
    let var_b = definition.factor * mean(&|_, b| (b - mu_b).powi(2));
    let cov = definition.factor * mean(&|a, b| (a - mu_a) * (b - mu_b));
    (2.0 * mu_a * mu_b + C1) * (2.0 * cov + C2)
        / ((mu_a * mu_a + mu_b * mu_b + C1) * (var_a + var_b + C2))
}

/// Every number of both windows against their definitions.
#[track_caller]
fn check(golden: &EncodedImage, actual: &EncodedImage) {
    for definition in [GAUSSIAN, UNIFORM] {
        check_window(&definition, golden, actual);
    }
}

#[track_caller]
fn check_window(definition: &Definition, golden: &EncodedImage, actual: &EncodedImage) {
    let size = golden.size();
    let reach = definition.reach as u32;
    let inside = |i: u32, pixels: u32| pixels < 1 + 2 * reach || (reach <= i && i + reach < pixels);
    let (mut sums, mut count) = ([0.0; 3], 0.0);
    let mut lowest = Vec::new();
    for y in 0..size.height {
        for x in 0..size.width {
            let scores =
                [0, 1, 2].map(|c| score_by_definition(definition, (golden, actual), (x, y), c));
            lowest.push(scores.into_iter().fold(1.0, f64::min));
            if inside(x, size.width) && inside(y, size.height) {
                count += 1.0;
                sums.iter_mut().zip(scores).for_each(|(sum, score)| *sum += score);
            }
        }
    }
    let (found, map) = (definition.computed)(&Pair::new(golden, actual).unwrap());
    assert_eq!((map.size, map.scores.len()), (size, lowest.len()));
    let close = |a: f64, b: f64| assert!((a - b).abs() < 1e-11, "{a} {b} {size:?}");
    for (sum, mean) in sums.into_iter().zip(found.channel_means) {
        close(sum / count, mean);
    }
    for (&expected, &score) in lowest.iter().zip(&map.scores) {
        close(expected, score);
    }
    close(lowest[(found.min_at.1 * size.width + found.min_at.0) as usize], found.min);
    close(lowest.iter().copied().fold(1.0, f64::min), found.min);
    close(found.channel_means.into_iter().fold(1.0, f64::min), found.mean);
}

#[test]
fn agrees_with_the_definition_at_every_small_size() {
    for width in 1..=13 {
        for height in [1, 2, 3, 4, 5, 6, 7, 10, 11, 12, 14] {
            let golden = noise(width, height, u64::from(width * 100 + height));
            check(&golden, &shaken(&golden, 40, 5));
            check(&golden, &noise(width, height, 6));
        }
    }
    check(&noise(40, 23, 7), &noise(40, 23, 8));
}

#[test]
fn identical_pictures_give_exactly_1() {
    for (width, height) in [(1, 1), (1, 30), (2, 2), (10, 11), (33, 47)] {
        for picture in [noise(width, height, 9), image(width, height, |_| 255)] {
            let found = ssim_of(&picture, &picture.clone());
            assert_eq!(found.channel_means, [1.0; 3]);
            assert_eq!((found.mean, found.min), (1.0, 1.0));
        }
    }
}

#[test]
fn flat_pictures_are_compared_by_brightness() {
    for (a, b) in [(0, 255), (0, 1), (200, 210), (254, 255), (128, 0)] {
        for (width, height) in [(1, 1), (5, 2), (11, 11), (20, 15)] {
            let found = ssim_of(&image(width, height, |_| a), &image(width, height, |_| b));
            let (a, b) = (f64::from(a), f64::from(b));
            let expected = (2.0 * a * b + C1) / (a * a + b * b + C1);
            for score in [found.mean, found.min] {
                assert!((score - expected).abs() < 1e-12, "{a} {b}: {score} {expected}");
            }
        }
    }
}

#[test]
fn a_negative_scores_below_zero() {
    let golden = noise(16, 16, 10);
    let negative = image(16, 16, |i| 255 - golden.bytes()[i]);
    assert!(ssim_of(&golden, &negative).mean < -0.5);
}

#[test]
fn one_channel_is_enough_to_lower_the_score() {
    let golden = noise(20, 20, 11);
    for channel in 0..3 {
        let byte = |i: usize| golden.bytes()[i] ^ if i % 3 == channel { 0x40 } else { 0 };
        let found = ssim_of(&golden, &image(20, 20, byte));
        for other in 0..3 {
            assert_eq!(found.channel_means[other] == 1.0, other != channel);
        }
        assert!(found.mean == found.channel_means[channel] && found.min < found.mean);
    }
}

#[test]
fn one_code_in_one_corner_lowers_the_minimum() {
    for seed in 0..20 {
        let golden = noise(24, 18, seed);
        let (corner, at) = [(0, (0, 0)), (24 * 18 - 1, (23, 17))][seed as usize % 2];
        let byte = |i: usize| golden.bytes()[i] ^ u8::from(i == corner * 3 + 1);
        let found = ssim_of(&golden, &image(24, 18, byte));
        assert!(found.min < 1.0, "{found:?}");
        check_near(found.min_at, at);
    }
}

/// Asserts that two pixels are the same or touch.
#[track_caller]
fn check_near(a: (u32, u32), b: (u32, u32)) {
    assert!(a.0.abs_diff(b.0) <= 1 && a.1.abs_diff(b.1) <= 1, "{a:?} {b:?}");
}

/// No pixel is on a blind border.
#[test]
fn one_inverted_pixel_is_found_wherever_it_is() {
    for (width, height) in [(1, 1), (3, 20), (17, 13)] {
        let golden = image(width, height, |i| 40 + (i / 3 % width as usize) as u8);
        for y in 0..height {
            for x in 0..width {
                let at = (y * width + x) as usize * 3 + 2;
                let byte = |i: usize| golden.bytes()[i] ^ if i == at { 0xff } else { 0 };
                let found = ssim_of(&golden, &image(width, height, byte));
                assert!(found.min < 0.5, "{x} {y}: {found:?}");
                check_near(found.min_at, (x, y));
            }
        }
    }
}

/// The blind spots that the metrics name.
#[test]
fn contrast_hides_a_small_change_and_the_mean_hides_the_outermost_pixels() {
    let golden = noise(64, 64, 14);
    let nudged = |i: usize| golden.bytes()[i] ^ if i == 64 * 32 * 3 { 8 } else { 0 };
    assert!(0.999 < ssim_of(&golden, &image(64, 64, nudged)).min);

    let inverted_row = |i: usize| golden.bytes()[i] ^ if i < 64 * 3 { 0xff } else { 0 };
    let found = ssim_of(&golden, &image(64, 64, inverted_row));
    assert!(0.99 < found.mean && found.min < 0.0, "{found:?}");
}

#[test]
fn swapping_or_mirroring_both_changes_no_bit_of_a_score() {
    let golden = noise(25, 17, 12);
    let actual = shaken(&golden, 60, 13);
    let map = |a: &EncodedImage, b: &EncodedImage| ssim_map(&Pair::new(a, b).unwrap());
    assert_eq!(map(&golden, &actual), map(&actual, &golden));
    let mirror = |picture: &EncodedImage| {
        let bytes: Vec<u8> = picture.pixels().iter().rev().flatten().copied().collect();
        EncodedImage::from_bytes(picture.size(), bytes).unwrap()
    };
    let mut mirrored = map(&mirror(&golden), &mirror(&actual));
    mirrored.scores.reverse();
    assert_eq!(map(&golden, &actual), mirrored);
}
