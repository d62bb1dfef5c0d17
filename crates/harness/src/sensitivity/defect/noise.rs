//! `noise`: every code off by a random amount.

use super::{Defect, Place, Strengths, code, everywhere};
use crate::encode::EncodedImage;

pub(super) const NOISE: Defect = Defect {
    name: "noise",
    does: "adds noise; standard deviation",
    unit: "codes",
    strengths: Strengths { least: 0.1, most: 64.0, whole: false },
    // A grain of 2 codes is seen on flat areas; one code of rounding is not.
    visible: 2.0,
    places: everywhere,
    inject,
};

/// The same noise at every strength, only higher, so that more is more.
fn inject(picture: &EncodedImage, _: Place, sigma: f64) -> EncodedImage {
    let noisy = (0_u64..).zip(picture.bytes());
    let bytes = noisy.map(|(i, &c)| code(f64::from(c) + sigma * normal(i))).collect();
    EncodedImage::from_bytes(picture.size(), bytes).unwrap_or_else(|| picture.clone())
}

/// A number of mean 0 and variance 1 for each index, nearly normal: the sum of
/// twelve uniform ones, each of variance 1/12, without a transcendental.
fn normal(index: u64) -> f64 {
    const UNIFORM: usize = 12;
    let bits = [2 * index, 2 * index + 1].map(mixed).map(u64::to_le_bytes);
    let bytes = bits.as_flattened();
    // The middle of each of 256 steps from 0 to 1.
    let sum: f64 = bytes[..UNIFORM].iter().map(|&b| (f64::from(b) + 0.5) / 256.0).sum();
    sum - UNIFORM as f64 / 2.0
}

/// A random number for each index: the output function of `SplitMix64`, whose
/// constants these are.
///
/// Source: G. L. Steele, D. Lea, C. H. Flood, "Fast Splittable Pseudorandom
/// Number Generators", OOPSLA 2014, figure 16.
fn mixed(index: u64) -> u64 {
    let mut z = index.wrapping_add(1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

#[cfg(test)]
mod tests {
    use tracer::Size;

    use super::*;

    #[test]
    fn its_standard_deviation_is_the_strength() {
        let size = Size { width: 200, height: 100 };
        let gray = EncodedImage::from_fn(size, |_, _| [128; 3]);
        let noisy = inject(&gray, Place::Whole, 10.0);
        let off = || noisy.bytes().iter().map(|&c| f64::from(c) - 128.0);
        let count = noisy.bytes().len() as f64;
        let mean = off().sum::<f64>() / count;
        let deviation = (off().map(|d| d * d).sum::<f64>() / count).sqrt();
        // Three standard errors of 60,000 samples.
        assert!(mean.abs() < 0.13, "{mean}");
        assert!((deviation - 10.0).abs() < 0.1, "{deviation}");
    }

    #[test]
    fn the_generator_is_the_source_s() {
        // The first numbers of SplitMix64 from seed 0.
        assert_eq!(mixed(0), 0xe220_a839_7b1d_cdaf);
        assert_eq!(mixed(1), 0x6e78_9e6a_a1b9_65f4);
    }
}
