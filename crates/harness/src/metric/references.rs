//! The metrics against scikit-image, whose answers are recorded.
//!
//! `references/record.py` asks it; `references/references.txt` is its output.

mod pictures;

use super::{Pair, rmse, ssim};
use crate::encode::EncodedImage;
use pictures::{NamedPair, pairs};

/// How far SSIM may be from scikit-image's.
const TOLERANCE: f64 = 1e-11;

/// A line of `references.txt`.
struct Record<'a> {
    fields: Vec<&'a str>,
}

impl Record<'_> {
    fn number(&self, field: usize) -> f64 {
        self.fields[field].parse().unwrap()
    }
}

fn records() -> Vec<Record<'static>> {
    include_str!("references/references.txt")
        .lines()
        .filter(|line| !line.starts_with('#'))
        .map(|line| Record { fields: line.split(' ').collect() })
        .collect()
}

/// FNV-1a in 64 bits, which two languages write alike in a few lines.
fn fnv1a(image: &EncodedImage) -> String {
    let hash = image.bytes().iter().fold(0xcbf2_9ce4_8422_2325_u64, |hash, &byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
    });
    format!("{hash:016x}")
}

/// Asserts that the pair is the recorded one.
fn check_pictures(pair: &NamedPair, record: &Record<'_>) {
    let size = pair.golden.size();
    let drawn = [
        pair.name.to_owned(),
        size.width.to_string(),
        size.height.to_string(),
        fnv1a(&pair.golden),
        fnv1a(&pair.actual),
    ];
    assert_eq!(drawn, record.fields[..5]);
}

/// The largest deviation of any SSIM score of the pair from the recorded ones.
fn deviation(pair: &NamedPair, record: &Record<'_>) -> f64 {
    let found = ssim(&Pair::new(&pair.golden, &pair.actual).unwrap());
    let [red, green, blue] = found.channel_means;
    if record.fields[9] != "-" {
        let at = (record.fields[9].parse().unwrap(), record.fields[10].parse().unwrap());
        assert_eq!(found.min_at, at, "{}", pair.name);
    }
    (5..)
        .zip([red, green, blue, found.min])
        .map(|(field, score)| (score - record.number(field)).abs())
        .fold(0.0, f64::max)
}

#[test]
fn agrees_with_scikit_image() {
    let (pairs, records) = (pairs(), records());
    assert_eq!(pairs.len(), records.len());
    let mut largest = 0.0_f64;
    for (pair, record) in pairs.iter().zip(&records) {
        check_pictures(pair, record);
        let deviation = deviation(pair, record);
        assert!(deviation < TOLERANCE, "{} deviates by {deviation:e}", pair.name);
        largest = largest.max(deviation);
    }
    #[allow(clippy::disallowed_macros)] // A figure that people ask for.
    {
        println!("largest deviation from scikit-image: {largest:e}");
    }
}

#[test]
fn rmse_is_that_of_numpy() {
    for (pair, record) in pairs().iter().zip(&records()) {
        let found = rmse(&Pair::new(&pair.golden, &pair.actual).unwrap()).rmse;
        assert!((found - record.number(11)).abs() < 1e-12, "{}", pair.name);
    }
}
