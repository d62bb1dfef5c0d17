//! `Bounds`: a box of `f32` in two vectors, as the builder reckons with it.

use glam::{BVec4A, Vec4};

/// All points `x` with `lo <= x <= hi` in the first three lanes. The fourth
/// lane means nothing, and is finite or an infinity.
#[derive(Debug, Clone, Copy)]
pub(super) struct Bounds {
    pub lo: Vec4,
    pub hi: Vec4,
}

impl Bounds {
    /// Holds no point; the neutral element of [`Bounds::union`].
    pub(super) const EMPTY: Self = Self { lo: Vec4::INFINITY, hi: Vec4::NEG_INFINITY };

    /// The smallest box that holds both.
    #[inline]
    pub(super) fn union(self, other: Self) -> Self {
        Self { lo: self.lo.min(other.lo), hi: self.hi.max(other.hi) }
    }

    /// The smallest box that holds this one and a point.
    #[inline]
    pub(super) fn with(self, point: Vec4) -> Self {
        Self { lo: self.lo.min(point), hi: self.hi.max(point) }
    }

    /// `a` where the mask is set, `b` elsewhere.
    #[inline]
    pub(super) fn select(mask: BVec4A, a: Self, b: Self) -> Self {
        Self { lo: Vec4::select(mask, a.lo, b.lo), hi: Vec4::select(mask, a.hi, b.hi) }
    }

    /// Half the surface area; infinite for an empty box.
    #[inline]
    pub(super) fn half_area(self) -> f32 {
        let [x, y, z, _] = (self.hi - self.lo).to_array();
        x * y + y * z + z * x
    }

    /// Whether it holds no point.
    pub(super) fn is_empty(self) -> bool {
        (self.hi - self.lo).truncate().min_element() < 0.0
    }

    /// What is in both.
    pub(super) fn overlap(self, other: Self) -> Self {
        Self { lo: self.lo.max(other.lo), hi: self.hi.min(other.hi) }
    }

    /// Twice the middle.
    #[inline]
    pub(super) fn center(self) -> Vec4 {
        self.lo + self.hi
    }
}
