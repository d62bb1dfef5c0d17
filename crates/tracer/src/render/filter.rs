//! `Filter`: how much a sample counts for the pixels around it.

use std::f64::consts::PI;

use crate::Refused;
use crate::math::{erf, exp};
use crate::refused::refuse_unless;

/// What a pixel is the mean of: of its own square, or of what is around its
/// middle, the nearer the more.
///
/// All but the box weigh a sample by `f(x) f(y)`, where `x` and `y` are its
/// distance from the pixel's middle in pixels, up to a radius; the integral of
/// `f` is 1. Mitchell's is below 0 in its outer half, so that a pixel beside a
/// bright edge may be darker than black.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Filter {
    kernel: Kernel,
    radius: f64,
}

/// The form of `f`, for `t` from 0 in the middle to 1 at the radius.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Kernel {
    /// 1 in the pixel, 0 elsewhere.
    Box,
    /// `1 - t`.
    Tent,
    /// `exp(-t^2 / 2 sigma^2)` less its value at 1, [`SIGMAS`] sigmas away.
    Gaussian,
    /// Cubic pieces with `B = C = 1/3`.
    Mitchell,
}

/// How many standard deviations a Gaussian's radius is: what is beyond is 1/400
/// of all.
const SIGMAS: f64 = 3.0;

impl Filter {
    /// The mean of the pixel's own samples.
    pub const BOX: Self = Self { kernel: Kernel::Box, radius: 0.5 };

    /// The smallest and largest radius, in pixels: its own samples count for
    /// every pixel, and no more than the nearest 80 others do.
    pub const RADII: std::ops::RangeInclusive<f64> = 0.5..=4.0;

    /// Falls off evenly.
    ///
    /// # Errors
    /// Refuses (as `radius`) a radius outside of [`Filter::RADII`].
    pub fn tent(radius: f64) -> Result<Self, Refused> {
        Self::new(Kernel::Tent, radius)
    }

    /// A bell of three standard deviations, lowered to 0 at the radius.
    ///
    /// # Errors
    /// Refuses (as `radius`) a radius outside of [`Filter::RADII`].
    pub fn gaussian(radius: f64) -> Result<Self, Refused> {
        Self::new(Kernel::Gaussian, radius)
    }

    /// Mitchell and Netravali's, which sharpens a little.
    ///
    /// Source: Mitchell and Netravali, "Reconstruction filters in computer
    /// graphics", 1988, with `B = C = 1/3`.
    ///
    /// # Errors
    /// Refuses (as `radius`) a radius outside of [`Filter::RADII`].
    pub fn mitchell(radius: f64) -> Result<Self, Refused> {
        Self::new(Kernel::Mitchell, radius)
    }

    fn new(kernel: Kernel, radius: f64) -> Result<Self, Refused> {
        Refused::unless([refuse_unless(
            Self::RADII.contains(&radius),
            "radius",
            format!("a number of pixels from {} to {}", Self::RADII.start(), Self::RADII.end()),
            || crate::refused::number(radius),
        )])?;
        Ok(Self { kernel, radius })
    }

    /// How many pixels to each side a pixel's samples count for.
    pub(crate) fn reach(self) -> u32 {
        match self.kernel {
            Kernel::Box => 0,
            // A sample is up to half a pixel from its own middle.
            _ => (self.radius + 0.5).ceil() as u32 - 1,
        }
    }

    /// `f(x)`: how much a sample at this distance along one axis counts.
    pub fn density(self, x: f64) -> f64 {
        let t = x.abs() / self.radius;
        if t >= 1.0 {
            return 0.0;
        }
        let density = match self.kernel {
            Kernel::Box => 0.5,
            Kernel::Tent => 1.0 - t,
            Kernel::Gaussian => (bell(t) - bell(1.0)) / (2.0 * bell_integral(1.0)),
            Kernel::Mitchell => 2.0 * mitchell(2.0 * t),
        };
        density / self.radius
    }

    /// The integral of `f` between two distances: how much of all that counts
    /// lies there.
    pub fn share(self, lo: f64, hi: f64) -> f64 {
        // Odd, so that mirrored distances give the same bits.
        let from_middle = |x: f64| {
            let t = (x.abs() / self.radius).min(1.0);
            let integral = match self.kernel {
                Kernel::Box => 0.5 * t,
                Kernel::Tent => t * (1.0 - 0.5 * t),
                Kernel::Gaussian => bell_integral(t) / (2.0 * bell_integral(1.0)),
                Kernel::Mitchell => mitchell_integral(2.0 * t),
            };
            integral.copysign(x)
        };
        from_middle(hi) - from_middle(lo)
    }

    /// Its name and radius, for people.
    pub(crate) fn words(self) -> String {
        let kernel = match self.kernel {
            Kernel::Box => return "box filter".to_owned(),
            Kernel::Tent => "tent",
            Kernel::Gaussian => "Gaussian",
            Kernel::Mitchell => "Mitchell",
        };
        format!("{kernel} filter of radius {}", self.radius)
    }
}

/// A Gaussian of [`SIGMAS`] sigmas at `t = 1`.
fn bell(t: f64) -> f64 {
    exp(-0.5 * (SIGMAS * t) * (SIGMAS * t))
}

/// The integral of [`bell`] less its value at 1, from 0 to `t`.
fn bell_integral(t: f64) -> f64 {
    let whole = (0.5 * PI).sqrt() / SIGMAS;
    whole * erf(SIGMAS * t / 2.0_f64.sqrt()) - bell(1.0) * t
}

/// The cubic pieces, for `t` from 0 to 2.
fn mitchell(t: f64) -> f64 {
    let sixfold = if t < 1.0 {
        (7.0 * t - 12.0) * t * t + 16.0 / 3.0
    } else {
        ((-7.0 / 3.0 * t + 12.0) * t - 20.0) * t + 32.0 / 3.0
    };
    sixfold / 6.0
}

/// The integral of [`mitchell`] from 0 to `t`.
fn mitchell_integral(t: f64) -> f64 {
    let sixfold = if t < 1.0 {
        ((7.0 / 4.0 * t - 4.0) * t * t + 16.0 / 3.0) * t
    } else {
        (((-7.0 / 12.0 * t + 4.0) * t - 10.0) * t + 32.0 / 3.0) * t - 1.0
    };
    sixfold / 6.0
}

#[cfg(test)]
mod tests {
    use super::*;

    fn filters() -> Vec<Filter> {
        let radii = [0.5, 0.75, 1.0, 1.5, 2.0, 3.3, 4.0];
        let kernels = [Filter::tent, Filter::gaussian, Filter::mitchell];
        let mut all = vec![Filter::BOX];
        all.extend(kernels.iter().flat_map(|filter| radii.map(|radius| filter(radius).unwrap())));
        all
    }

    /// Simpson's rule over pieces that no cubic is broken in.
    fn integral(filter: Filter, lo: f64, hi: f64) -> f64 {
        const PIECES: u32 = 4_000;
        let step = (hi - lo) / f64::from(PIECES);
        let at = |k: f64| filter.density(lo + k * step);
        let piece = |k: u32| {
            let k = f64::from(k);
            at(k) + 4.0 * at(k + 0.5) + at(k + 1.0)
        };
        (0..PIECES).map(piece).sum::<f64>() * step / 6.0
    }

    #[test]
    fn weights_add_up_to_one_and_shares_are_their_integrals() {
        for filter in filters() {
            let r = filter.radius;
            assert!((filter.share(-r, r) - 1.0).abs() < 1e-14, "{filter:?}");
            assert!((filter.share(-9.0, 9.0) - 1.0).abs() < 1e-14, "{filter:?}");
            for (lo, hi) in [(-r, r), (0.0, 0.1), (-0.3, 0.45), (0.5 * r, r), (0.2, 0.9 * r)] {
                let (share, sum) = (filter.share(lo, hi), integral(filter, lo, hi));
                // The box ends in a step.
                let within = if filter == Filter::BOX { 1e-3 } else { 1e-9 };
                assert!((share - sum).abs() < within, "{filter:?} {lo} {hi}: {share} {sum}");
            }
        }
    }

    #[test]
    fn mirrored_samples_count_the_same_to_the_bit() {
        for filter in filters() {
            for k in 0..100 {
                let x = f64::from(k) * 0.0437;
                assert_eq!(filter.density(x), filter.density(-x));
                assert_eq!(filter.share(x, 1.1 * x + 0.2), filter.share(-1.1 * x - 0.2, -x));
            }
        }
    }

    #[test]
    fn known_values() {
        let tent = Filter::tent(2.0).unwrap();
        assert_eq!([0.0, 1.0, 2.0, 3.0].map(|x| tent.density(x)), [0.5, 0.25, 0.0, 0.0]);
        let mitchell = Filter::mitchell(2.0).unwrap();
        // The paper's 8/9 in the middle and 1/18 at the next pixels.
        assert!((mitchell.density(0.0) - 8.0 / 9.0).abs() < 1e-15);
        assert!((mitchell.density(1.0) - 1.0 / 18.0).abs() < 1e-15);
        assert!(mitchell.density(1.5) < 0.0 && mitchell.density(2.0) == 0.0);
        let bell = Filter::gaussian(3.0).unwrap();
        // A standard deviation is 1: as high as the normal distribution, of which
        // it lacks the ends and a foot of 1/90.
        assert!((bell.density(0.0) - 0.3989).abs() < 0.02, "{}", bell.density(0.0));
    }

    #[test]
    fn pixels_are_reached_where_samples_count() {
        for (radius, reach) in [(0.5, 0), (0.75, 1), (1.0, 1), (1.5, 1), (1.51, 2), (4.0, 4)] {
            let filter = Filter::tent(radius).unwrap();
            assert_eq!(filter.reach(), reach, "{radius}");
            assert_eq!(filter.density(f64::from(reach) + 0.5), 0.0);
        }
    }

    #[test]
    fn radii_have_bounds() {
        for radius in [0.0, 0.49, 4.01, -1.0, f64::NAN, f64::INFINITY] {
            let refused = Filter::mitchell(radius).unwrap_err();
            assert_eq!(refused.refusals()[0].field, "radius");
        }
    }
}
