//! `Samples`: how many samples a pixel has, spread by which pattern.

use crate::Refused;
use crate::refused::refuse_unless;

/// How samples are spread in their pixel.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Sampler {
    /// In the middles of square cells, the same in every pixel.
    #[default]
    Grid,
    /// Anywhere in square cells: one each, in every pixel elsewhere.
    Stratified {
        /// Another one moves every sample.
        seed: u32,
    },
    /// The first points of Sobol's sequence, scrambled by Owen's method in
    /// every pixel in another way: of `2^m` points, every rectangle of `2^-a` by
    /// `2^(a - m)` of the pixel that halving it gives holds one.
    Sobol {
        /// Another one moves every sample.
        seed: u32,
    },
}

/// How many samples a pixel has, and where. One on a grid is the lecture's
/// pixel center.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Samples {
    sampler: Sampler,
    per_pixel: u32,
}

impl Samples {
    /// One sample, in the middle of the pixel.
    pub const ONE: Self = Self { sampler: Sampler::Grid, per_pixel: 1 };

    /// The most samples in a pixel.
    pub const MAX: u32 = 4_096;

    /// This many samples a pixel. Cells are square, and so is their number; of
    /// Sobol's points there may be any, and powers of two are spread best.
    ///
    /// # Errors
    /// Refuses (as `samples_per_pixel`) 0, absurdly many, and numbers that are
    /// not square where cells are.
    pub fn new(sampler: Sampler, samples_per_pixel: u32) -> Result<Self, Refused> {
        let side = samples_per_pixel.isqrt();
        let (fits, numbers, such_as) = match sampler {
            Sampler::Sobol { .. } => (true, "whole number", "1, 2, 4, 8 or 16"),
            _ => (side * side == samples_per_pixel, "square number", "1, 4, 9 or 16"),
        };
        Refused::unless([refuse_unless(
            fits && (1..=Self::MAX).contains(&samples_per_pixel),
            "samples_per_pixel",
            format!("a {numbers} from 1 to {}, such as {such_as}", Self::MAX),
            || samples_per_pixel.to_string(),
        )])?;
        Ok(Self { sampler, per_pixel: samples_per_pixel })
    }

    /// A regular grid of this many samples.
    ///
    /// # Errors
    /// As [`Samples::new`].
    pub fn grid(samples_per_pixel: u32) -> Result<Self, Refused> {
        Self::new(Sampler::Grid, samples_per_pixel)
    }

    /// How they are spread.
    pub fn sampler(self) -> Sampler {
        self.sampler
    }

    /// How many samples a pixel has.
    pub fn samples_per_pixel(self) -> u32 {
        self.per_pixel
    }

    /// How many and which, for people.
    pub(crate) fn words(self) -> String {
        let which = match self.sampler {
            Sampler::Grid => "on a grid",
            Sampler::Stratified { .. } => "stratified",
            Sampler::Sobol { .. } => "of Sobol's points",
        };
        let s = if self.per_pixel == 1 { "" } else { "s" };
        format!("{} sample{s} {which}", self.per_pixel)
    }

    /// How many cells are side by side, where there are cells.
    pub(super) fn side(self) -> u32 {
        self.per_pixel.isqrt()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cells_are_square_and_points_are_as_many_as_one_likes() {
        let sobol = Sampler::Sobol { seed: 7 };
        for (n, square, any) in [
            (0, false, false),
            (1, true, true),
            (2, false, true),
            (4, true, true),
            (4_096, true, true),
            (4_097, false, false),
            (u32::MAX, false, false),
        ] {
            for sampler in [Sampler::Grid, Sampler::Stratified { seed: 0 }] {
                assert_eq!(Samples::new(sampler, n).is_ok(), square, "{sampler:?} {n}");
            }
            assert_eq!(Samples::new(sobol, n).is_ok(), any, "{n}");
        }
        assert_eq!(Samples::grid(9).unwrap().samples_per_pixel(), 9);
    }
}
