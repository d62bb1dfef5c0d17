//! Whether a picture differs as one of single precision does.
//!
//! A renderer of 32 bits rounds each step of its own by 6e-8 of the number. Most pixels
//! are off by little more; where light grazes, or a place is found as the small difference
//! of large numbers, it becomes more by orders. Roundings go both ways.

use tracer::LinearImage;

use super::Level;
use crate::scale::Scale;

/// What is proposed. Of the 22 fixtures that Mitsuba 3 in 32 bits is off in by nothing but
/// rounding (`docs/adapters.md`) all are within it, the worst pixel at half of it; the
/// next smaller power leaves five of them failing.
pub(super) const ENOUGH: f64 = 1e-3;

/// What at least half of the pixels that are off at all are within: 64 units of rounding,
/// 4e-6. Of those 22 it is 63 % to 99 %.
const USUAL: f64 = 64.0 / (1 << 24) as f64;

/// The least share of each sign among those that are off at all. A light that is a little
/// too bright has one sign only.
const EACH_SIGN: f64 = 0.05;

/// So many pixels must be off at all, or their signs say nothing.
const FEWEST: usize = 16;

/// Whether these pixels of a picture, by what its file may stand for, are off from the
/// reference as single precision is.
pub(super) fn looks_single(
    linear: &LinearImage,
    pixels: impl Iterator<Item = (usize, [Level; 3])>,
) -> bool {
    let scale = Scale::of(linear);
    let mut errors: Vec<f64> = Vec::new();
    for (at, levels) in pixels {
        let pixel = linear.pixels()[at];
        let of = scale.at(pixel);
        let signed = pixel.channels().into_iter().zip(levels).map(|(c, level)| {
            if c < level.low { (level.low - c) / of } else { (level.high - c).min(0.0) / of }
        });
        let worst =
            signed.fold(0.0, |most: f64, one| if one.abs() > most.abs() { one } else { most });
        if !(worst.abs() <= ENOUGH) {
            return false;
        }
        if worst != 0.0 {
            errors.push(worst);
        }
    }
    let count = errors.len();
    let share = |is: &dyn Fn(f64) -> bool| {
        errors.iter().filter(|&&error| is(error)).count() as f64 / count.max(1) as f64
    };
    let (more, near) = (share(&|error| error > 0.0), share(&|error| error.abs() <= USUAL));
    count >= FEWEST && (EACH_SIGN..=1.0 - EACH_SIGN).contains(&more) && near >= 0.5
}
