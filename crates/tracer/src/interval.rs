//! `Interval`: the open range of `t` in which a hit counts.

use crate::fault::{Fault, seeded};
/// The open range `(lo, hi)` of the ray parameter: the lecture's
/// `(tMin, tMax)`. Neither end is inside, and NaN never is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Interval {
    /// The lecture's `tMin`.
    pub lo: f64,
    /// The lecture's `tMax`; may be infinite.
    pub hi: f64,
}

impl Interval {
    /// Everything in front of the ray's origin: `(0, +inf)`.
    pub const AHEAD: Self = Self { lo: 0.0, hi: f64::INFINITY };

    /// The range `(lo, hi)`; empty unless `lo < hi`.
    pub const fn new(lo: f64, hi: f64) -> Self {
        Self { lo, hi }
    }

    /// Whether `t` is strictly between the ends. A NaN on either side makes
    /// this false, so a NaN is never a hit.
    pub fn contains(self, t: f64) -> bool {
        let lo = if seeded(Fault::TMinIgnored) { self.lo.min(0.0) } else { self.lo };
        (lo < t || seeded(Fault::HitBehindTheEye)) && t < self.hi
    }

    /// The same range, ended at `hi`.
    #[must_use]
    pub const fn until(self, hi: f64) -> Self {
        Self { lo: self.lo, hi }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ends_and_nan_are_outside() {
        let range = Interval::new(0.0, 2.0);
        assert!(range.contains(f64::MIN_POSITIVE));
        assert!(range.contains(2.0_f64.next_down()));
        for t in [0.0, -0.0, 2.0, -1.0, f64::NAN, f64::INFINITY] {
            assert!(!range.contains(t), "{t}");
        }
        assert!(!Interval::AHEAD.contains(f64::INFINITY));
        assert!(!Interval::new(f64::NAN, 1.0).contains(0.5));
        assert!(!Interval::new(0.0, f64::NAN).contains(0.5));
        assert!(!Interval::new(1.0, 1.0).contains(1.0));
    }
}
