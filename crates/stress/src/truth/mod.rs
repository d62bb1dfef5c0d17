//! `Truth`: what the exact answers are.
//!
//! Each formula is written once, for any [`Number`], in
//! the plainest form there is: with enough digits nothing need be stable. The
//! inputs are taken as the exact numbers that they are.

mod axis_box;
pub mod camera;
pub mod cone;
pub mod coverage;
pub mod cylinder;
mod disk;
mod frame;
pub mod frustum;
mod plane;
pub mod polynomial;
mod sphere;
pub mod torus;
mod triangle;

pub use axis_box::axis_box;
pub use disk::disk;
pub use plane::plane;
pub use sphere::{sphere, sphere_point};
pub use triangle::{triangle, triangle_on_lattice};

use std::cmp::Ordering;

use crate::number::Number;

/// The exact answer to "where is the ray's first hit?".
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Truth {
    /// The ray parameter as a sum of two `f64`s, the larger first; `None` is
    /// a miss.
    pub t: Option<(f64, f64)>,
    /// Whether rounding the inputs once could turn a hit into a miss or into
    /// another hit, or the other way round: then either answer is right.
    pub tie: bool,
    /// How far `t` moves at most when every input vector is off by its own
    /// length: the condition number of `t` times `|t|`. Times 2^-53 it is what
    /// one rounding of each input may do.
    pub condition: f64,
}

impl Truth {
    /// A miss without doubt.
    pub const MISS: Self = Self { t: None, tie: false, condition: 0.0 };

    /// Too close to call.
    pub const TIE: Self = Self { t: None, tie: true, condition: 0.0 };

    /// A hit without doubt.
    pub fn hit((hi, lo): (f64, f64), condition: f64) -> Self {
        Self { t: Some((hi, lo)), tie: false, condition }
    }
}

/// The largest relative error of one rounding of an `f64`, 2^-53.
pub const UNIT_ROUNDOFF: f64 = f64::EPSILON / 2.0;

/// `|x - (hi + lo)|`.
pub(crate) fn distance(x: f64, (hi, lo): (f64, f64)) -> f64 {
    ((x - hi) - lo).abs()
}

/// How many times the effect of one rounding of each input still is a tie: the
/// effects of several inputs add up, and are taken to first order only.
pub(crate) const TIE_FACTOR: f64 = 4.0;

/// Relative margins below this are decided again with more digits: 2^-90, far
/// above the errors of a double-double and far below those of an `f64`.
pub(crate) const UNDECIDED: f64 = UNIT_ROUNDOFF * UNIT_ROUNDOFF * (1_u64 << (2 * 53 - 90)) as f64;

/// Whether a rounding of the inputs could change the sign of `margin`, of
/// which `moves` is how far inputs that are off by their own size move it.
pub(crate) fn is_tie(margin: f64, moves: f64) -> bool {
    margin.abs() <= TIE_FACTOR * UNIT_ROUNDOFF * moves
}

/// The first of these roots that is ahead of the ray's origin. A root is its
/// `t`, in rising order, with its condition.
pub(crate) fn first_ahead<N: Number>(roots: impl IntoIterator<Item = (N, f64)>) -> Truth {
    for (t, condition) in roots {
        if is_tie(t.to_f64(), condition) {
            return Truth::TIE;
        }
        if t.sign() == Ordering::Greater {
            return Truth::hit(parts(&t), condition);
        }
    }
    Truth::MISS
}

/// The nearest `f64`, and the nearest one to what that leaves out.
pub(crate) fn parts<N: Number>(x: &N) -> (f64, f64) {
    let hi = x.to_f64();
    (hi, (x.clone() - N::of(hi)).to_f64())
}

#[cfg(test)]
mod tests;
