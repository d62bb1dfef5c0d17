//! `UnitVec`: a vector whose length is 1, as a promise of its type.

use std::ops::{Deref, Neg};

use glam::DVec3;

/// A vector of length 1, to within 2 units in the last place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct UnitVec(DVec3);

impl UnitVec {
    /// The x axis.
    pub const X: Self = Self(DVec3::X);
    /// The y axis.
    pub const Y: Self = Self(DVec3::Y);
    /// The z axis.
    pub const Z: Self = Self(DVec3::Z);

    /// `v / |v|`; `None` where `v` is zero or not finite.
    ///
    /// Lengths from the smallest to the largest `f64` work: the vector is
    /// scaled first where its square would overflow or lose bits.
    pub fn new(v: DVec3) -> Option<Self> {
        // Within these lengths the sum of squares keeps all its bits.
        const SQUARES_ARE_SAFE: std::ops::Range<f64> = 1e-140..1e140;
        let largest = v.abs().max_element();
        if !(v.is_finite() && largest > 0.0) {
            return None;
        }
        let v = if SQUARES_ARE_SAFE.contains(&largest) { v } else { v / largest };
        Some(Self(v / v.length()))
    }

    /// A vector of any length, taken for one of length 1: for seeded faults.
    pub(crate) const fn wrongly(v: DVec3) -> Self {
        Self(v)
    }

    /// The axis of this index: 0 is x, 1 is y, all else z.
    pub const fn axis(index: usize) -> Self {
        match index {
            0 => Self::X,
            1 => Self::Y,
            _ => Self::Z,
        }
    }
}

impl Deref for UnitVec {
    type Target = DVec3;
    fn deref(&self) -> &DVec3 {
        &self.0
    }
}

impl Neg for UnitVec {
    type Output = Self;
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(v: [f64; 3], expected: Option<[f64; 3]>) {
        let unit = UnitVec::new(DVec3::from_array(v)).map(|n| n.to_array());
        assert_eq!(unit, expected);
    }

    #[test]
    fn values() {
        check([0.0, 0.0, 0.0], None);
        check([f64::NAN, 1.0, 0.0], None);
        check([f64::INFINITY, 1.0, 0.0], None);
        check([0.0, -3.0, 4.0], Some([0.0, -0.6, 0.8]));
        check([0.0, -3e300, 4e300], Some([0.0, -0.6, 0.8]));
        check([5e-324, 0.0, 0.0], Some([1.0, 0.0, 0.0]));
        check([f64::MAX, 0.0, 0.0], Some([1.0, 0.0, 0.0]));
    }
}
