//! The linear value of each code of a picture file.

use crate::format::TexelEncoding;

/// The linear values, from 0 to 1, of the codes from 0 to `white`.
///
/// - `Srgb`: with `c = code / white`, `c / 12.92` up to 0.04045, else
///   `((c + 0.055) / 1.055)^2.4`;
/// - `Gamma22`: `c^2.2`;
/// - `Linear`: `c`.
///
/// Source: IEC 61966-2-1:1999, section 5.2, for the first.
pub(super) fn levels(encoding: TexelEncoding, white: u16) -> Vec<f64> {
    let level = |code: u16| {
        let c = f64::from(code) / f64::from(white);
        match encoding {
            TexelEncoding::Srgb if c <= 0.04045 => c / 12.92,
            TexelEncoding::Srgb => libm::pow((c + 0.055) / 1.055, 2.4),
            TexelEncoding::Gamma22 => libm::pow(c, 2.2),
            TexelEncoding::Linear => c,
        }
    };
    (0..=white).map(level).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(encoding: TexelEncoding, white: u16, code: usize, expected: f64) {
        let found = levels(encoding, white)[code];
        assert!((found - expected).abs() <= 1e-14 * expected, "{found}");
    }

    #[test]
    fn ends_and_known_values() {
        for encoding in [TexelEncoding::Srgb, TexelEncoding::Gamma22, TexelEncoding::Linear] {
            for white in [255, 65_535] {
                check(encoding, white, 0, 0.0);
                check(encoding, white, white.into(), 1.0);
                assert!(levels(encoding, white).is_sorted(), "{encoding:?}");
                assert_eq!(levels(encoding, white).len(), usize::from(white) + 1);
            }
        }
        check(TexelEncoding::Linear, 255, 51, 0.2);
        check(TexelEncoding::Linear, 65_535, 13_107, 0.2);
        // 10 / 255 is on the straight part, 11 / 255 is not.
        check(TexelEncoding::Srgb, 255, 10, 0.003_035_269_835_488_375);
        check(TexelEncoding::Srgb, 255, 11, 0.003_346_535_763_899_161);
        check(TexelEncoding::Srgb, 255, 128, 0.215_860_500_113_898_67);
        check(TexelEncoding::Gamma22, 255, 128, 0.219_519_718_074_867_9);
    }
}
