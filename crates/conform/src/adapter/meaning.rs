//! `Meaning`: what the numbers of a renderer's pictures stand for.

use serde::Deserialize;

/// What the numbers of a picture file mean.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Meaning {
    /// The curve that was applied to linear values.
    pub transfer: Transfer,
    /// How a value between two codes was put to one.
    pub rounding: Rounding,
    /// Which row the file holds first, as a viewer shows it.
    pub rows: Rows,
}

/// The curve from a linear value to what is stored, where 1 is white.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize)]
pub enum Transfer {
    /// None.
    #[default]
    Linear,
    /// `c^(1/2.2)`.
    Gamma22,
    /// That of sRGB.
    ///
    /// Source: IEC 61966-2-1:1999, section 5.2.
    Srgb,
}

impl Transfer {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Linear, Self::Gamma22, Self::Srgb];

    /// The linear value of what is stored; the curve's mirror image below 0.
    pub fn linear(self, stored: f64) -> f64 {
        let c = stored.abs();
        let linear = match self {
            Self::Linear => c,
            Self::Gamma22 => libm::pow(c, 2.2),
            Self::Srgb if c <= 0.04045 => c / 12.92,
            Self::Srgb => libm::pow((c + 0.055) / 1.055, 2.4),
        };
        linear.copysign(stored)
    }
}

/// How a value between two codes was put to one of them.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize)]
pub enum Rounding {
    /// To the nearest, `floor(max c + 0.5)`.
    #[default]
    Nearest,
    /// To the lower one, as `(int)(255 * c)` does.
    Down,
    /// To the lower one of one step more than there are, as `(int)(256 * c)` does, or
    /// `(int)(255.999 * c)`.
    DownOfMore,
}

impl Rounding {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Nearest, Self::Down, Self::DownOfMore];
}

/// Which row is held first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize)]
pub enum Rows {
    /// The picture is upright where the file is shown.
    #[default]
    TopFirst,
    /// It is upside down there.
    BottomFirst,
}

impl Rows {
    /// The other one.
    #[must_use]
    pub fn turned(self) -> Self {
        match self {
            Self::TopFirst => Self::BottomFirst,
            Self::BottomFirst => Self::TopFirst,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(transfer: Transfer, stored: f64, expected: f64) {
        let found = transfer.linear(stored);
        assert!((found - expected).abs() <= 1e-9, "{transfer:?} of {stored}: {found}");
    }

    #[test]
    fn curves_at_known_places() {
        for transfer in Transfer::ALL {
            check(transfer, 0.0, 0.0);
            check(transfer, 1.0, 1.0);
            check(transfer, -1.0, -1.0);
        }
        check(Transfer::Linear, 7.5, 7.5);
        // 0.5^2.2 and ((0.5 + 0.055) / 1.055)^2.4.
        check(Transfer::Gamma22, 0.5, 0.217_637_640_8);
        check(Transfer::Srgb, 0.5, 0.214_041_140_5);
        check(Transfer::Srgb, 0.04, 0.04 / 12.92);
    }
}
