//! The metrics against other people's programs, whose answers are recorded.
//!
//! `references/record_*.py` ask them; `references/*.txt` are what they print.

mod pictures;

use tracer::Size;

use super::*;
use pictures::{NamedPair, pairs, seen_pairs, small_pairs};

/// How far SSIM may be from scikit-image's.
const TOLERANCE: f64 = 1e-11;
/// How far FLIP may be from the evaluator's at any pixel. That program has single
/// precision and takes a square root of features: what rounds by 1e-8 there is an
/// error of 1e-4.
const FLIP_TOLERANCE: f64 = 1e-4;
/// How far the mean may be.
const FLIP_MEAN_TOLERANCE: f64 = 1e-5;
/// The pairs whose two pictures have the same features, or none, so that the
/// evaluator's rounding is all that it sees of them at every pixel: their mean may
/// be as far off as any of their pixels.
const FEATURES_CANCEL: [&str; 4] =
    ["checker_negative", "flat_brighter", "flat_black_white", "hue_board_inverted"];

/// A line of a record.
struct Record {
    fields: Vec<&'static str>,
}

impl Record {
    fn number(&self, field: usize) -> f64 {
        self.fields[field].parse().unwrap()
    }

    /// Asserts that the pair is the recorded one.
    #[track_caller]
    fn check_pictures(&self, pair: &NamedPair) {
        let size = pair.golden.size();
        let drawn = [
            pair.name.to_owned(),
            size.width.to_string(),
            size.height.to_string(),
            fnv1a(&pair.golden),
            fnv1a(&pair.actual),
        ];
        assert_eq!(drawn, self.fields[..5]);
    }
}

/// Each pair with its line of a record.
fn recorded(pairs: Vec<NamedPair>, text: &'static str) -> Vec<(NamedPair, Record)> {
    let lines = text.lines().filter(|line| !line.starts_with('#'));
    let records: Vec<_> = lines.map(|line| Record { fields: line.split(' ').collect() }).collect();
    assert_eq!(pairs.len(), records.len());
    let recorded: Vec<_> = pairs.into_iter().zip(records).collect();
    for (pair, record) in &recorded {
        record.check_pictures(pair);
    }
    recorded
}

fn scikit_image() -> Vec<(NamedPair, Record)> {
    recorded(pairs(), include_str!("references/ssim.txt"))
}

/// FNV-1a in 64 bits, which two languages write alike in a few lines.
fn fnv1a(image: &EncodedImage) -> String {
    let hash = image.bytes().iter().fold(0xcbf2_9ce4_8422_2325_u64, |hash, &byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
    });
    format!("{hash:016x}")
}

#[allow(clippy::disallowed_macros)] // A figure that people ask for.
fn tell(what: &str, deviation: f64) {
    println!("largest deviation from {what}: {deviation:e}");
}

/// The largest deviation of any score of the pair from those recorded from
/// field `first` on.
fn deviation(found: Ssim, pair: &NamedPair, record: &Record, first: usize) -> f64 {
    let [red, green, blue] = found.channel_means;
    if record.fields[first + 4] != "-" {
        let at = (record.number(first + 4) as u32, record.number(first + 5) as u32);
        assert_eq!(found.min_at, at, "{}", pair.name);
    }
    (first..)
        .zip([red, green, blue, found.min])
        .map(|(field, score)| (score - record.number(field)).abs())
        .fold(0.0, f64::max)
}

#[test]
fn agrees_with_scikit_image() {
    const GAUSSIAN_FIELDS: usize = 6;
    const UNIFORM_FIELDS: usize = 12;
    let mut largest = [0.0_f64; 2];
    for (named, record) in scikit_image() {
        let pair = Pair::new(&named.golden, &named.actual).unwrap();
        let deviations = [
            deviation(ssim(&pair), &named, &record, GAUSSIAN_FIELDS),
            deviation(ssim_uniform(&pair), &named, &record, UNIFORM_FIELDS),
        ];
        let name = named.name;
        assert!(deviations[0] < TOLERANCE, "{name} deviates by {deviations:?}");
        assert!(deviations[1] < TOLERANCE, "{name} deviates by {deviations:?}");
        largest = [0, 1].map(|window| largest[window].max(deviations[window]));
    }
    tell("scikit-image, Gaussian window", largest[0]);
    tell("scikit-image, uniform window", largest[1]);
}

#[test]
fn rmse_is_that_of_numpy() {
    for (pair, record) in scikit_image() {
        let found = rmse(&Pair::new(&pair.golden, &pair.actual).unwrap()).rmse;
        assert!((found - record.number(5)).abs() < 1e-12, "{}", pair.name);
    }
}

/// The positions on a line of pixels at which `record_flip.py` records.
fn spread(pixels: u32) -> Vec<u32> {
    const SPREAD: u32 = 8;
    if pixels <= SPREAD {
        return (0..pixels).collect();
    }
    (0..SPREAD).map(|i| i * (pixels - 1) / (SPREAD - 1)).collect()
}

#[test]
fn agrees_with_the_flip_evaluator() {
    const FIRST_ERROR: usize = 7;
    let pairs = [pairs(), small_pairs(), seen_pairs()].into_iter().flatten().collect();
    let (mut of_mean, mut of_error) = (0.0_f64, 0.0_f64);
    for (named, record) in recorded(pairs, include_str!("references/flip.txt")) {
        let pair = Pair::new(&named.golden, &named.actual).unwrap();
        let (found, map) = (flip(&pair), flip_map(&pair));
        let at = |x: u32, y: u32| map.errors[(y * map.size.width + x) as usize];
        let Size { width, height } = map.size;
        let probes =
            spread(height).into_iter().flat_map(|y| spread(width).into_iter().map(move |x| (x, y)));
        let errors: Vec<_> = probes.map(|(x, y)| at(x, y)).collect();
        assert_eq!(errors.len(), record.fields.len() - FIRST_ERROR, "{}", named.name);
        let mean = (found.mean - record.number(5)).abs();
        let error = (FIRST_ERROR..)
            .zip(errors)
            .chain([(6, found.max)])
            .map(|(field, error)| (error - record.number(field)).abs())
            .fold(0.0, f64::max);
        let cancel = FEATURES_CANCEL.contains(&named.name);
        let tolerance = if cancel { FLIP_TOLERANCE } else { FLIP_MEAN_TOLERANCE };
        assert!(mean < tolerance, "{} deviates by {mean:e} in the mean", named.name);
        assert!(error < FLIP_TOLERANCE, "{} deviates by {error:e}", named.name);
        (of_mean, of_error) = (of_mean.max(mean), of_error.max(error));
    }
    tell("flip-evaluator, mean", of_mean);
    tell("flip-evaluator, any pixel", of_error);
}
