//! `Transfer`: the curve from a linear value to its 8-bit code.
//!
//! A code is looked up among 255 thresholds, so no power function is ever
//! evaluated and none can round differently on another machine.

use super::thresholds::{GAMMA22, SRGB};

/// The curve f of `floor(255 * clamp(f(c), 0, 1) + 0.5)`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Transfer {
    /// `f(c) = c^(1/2.2)`, a plain power.
    ///
    /// Source: Cornell CS4620, programming assignment 1 (2011), its image output.
    #[default]
    Gamma22,
    /// `f(c) = 12.92 c` for `c <= 0.0031308`, else `1.055 c^(1/2.4) - 0.055`.
    ///
    /// Source: IEC 61966-2-1:1999, section 5.2.
    Srgb,
}

impl Transfer {
    /// The code of the linear value `c`: `floor(255 * clamp(f(c), 0, 1) + 0.5)`
    /// as exact real arithmetic has it, for every `f64`.
    ///
    /// Negative values and minus infinity give 0, values from 1 up and plus
    /// infinity 255. NaN gives 0; `encode` refuses it before it comes here.
    pub fn code(self, c: f64) -> u8 {
        let thresholds = match self {
            Self::Gamma22 => &GAMMA22,
            Self::Srgb => &SRGB,
        };
        // Between 0 and plus infinity the bits are ordered as the values are.
        let bits = if c > 0.0 { c.to_bits() } else { 0 };
        // How many thresholds are at most that, a bit of the count after the
        // other, without a branch that depends on the value.
        let mut code = 0_u8;
        for bit in (0..8).rev() {
            let more = code | 1 << bit;
            code = if thresholds[usize::from(more) - 1] <= bits { more } else { code };
        }
        code
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(transfer: Transfer, c: f64, expected: u8) {
        assert_eq!(transfer.code(c), expected, "{transfer:?} of {c}");
    }

    #[test]
    fn ends_of_the_range() {
        for transfer in [Transfer::Gamma22, Transfer::Srgb] {
            check(transfer, f64::NEG_INFINITY, 0);
            check(transfer, -f64::MIN_POSITIVE, 0);
            check(transfer, -0.0, 0);
            check(transfer, 0.0, 0);
            check(transfer, 5e-324, 0);
            check(transfer, 1.0_f64.next_down(), 255);
            check(transfer, 1.0, 255);
            check(transfer, f64::INFINITY, 255);
        }
    }

    #[test]
    fn known_codes() {
        // 255 * 0.18^(1/2.2) = 116.97; 255 * sRGB(0.18) = 117.65.
        check(Transfer::Gamma22, 0.18, 117);
        check(Transfer::Srgb, 0.18, 118);
        // 255 * 12.92 * 0.001 = 3.29 on the straight part; 255 * 0.001^(1/2.2) = 11.04.
        check(Transfer::Srgb, 0.001, 3);
        check(Transfer::Gamma22, 0.001, 11);
    }
}
