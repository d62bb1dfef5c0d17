//! Putting the two sides of a cut apart.

use glam::BVec4A;

use super::bins::Cut;
use super::bounds::Bounds;
use super::reference::Reference;
use crate::simd::{Simd, Work};

/// One side of a cut, or the whole.
#[derive(Debug, Clone, Copy)]
pub(super) struct Set {
    /// Around the references.
    pub bounds: Bounds,
    /// Around their centers.
    pub centers: Bounds,
}

impl Set {
    pub(super) const EMPTY: Self = Self { bounds: Bounds::EMPTY, centers: Bounds::EMPTY };

    /// What holds these references.
    pub(super) fn of(references: &[Reference]) -> Self {
        references.iter().fold(Self::EMPTY, Self::with)
    }

    /// What holds one more.
    #[inline]
    pub(super) fn with(self, reference: &Reference) -> Self {
        Self {
            bounds: self.bounds.union(reference.bounds()),
            centers: self.centers.with(reference.center()),
        }
    }

    /// What holds both sets.
    pub(super) fn union(self, other: Self) -> Self {
        Self { bounds: self.bounds.union(other.bounds), centers: self.centers.union(other.centers) }
    }
}

/// Puts the references `from` into the slice `to`, which has room for them:
/// those on the left side of the cut at its start, the others at its end.
pub(super) struct Partition<'a> {
    pub from: &'a [Reference],
    pub to: &'a mut [Reference],
    pub cut: &'a Cut,
}

impl Work for Partition<'_> {
    type Output = [Set; 2];
    #[inline(always)]
    fn run<S: Simd>(self, _: S) -> [Set; 2] {
        let Self { from, to, cut } = self;
        let (mut left, mut right) = (Bounds::EMPTY, Bounds::EMPTY);
        // Where the next one of the left and of the right side goes. It is written
        // to both, as a branch could not be foretold.
        let (mut next, mut end) = (0, to.len());
        for reference in from {
            let center = reference.center();
            let is_left = cut.is_left(center);
            to[next] = *reference;
            to[end - 1] = *reference;
            next += usize::from(is_left);
            end -= usize::from(!is_left);
            let on_left = BVec4A::from([is_left; 4]);
            left = Bounds::select(on_left, left.with(center), left);
            right = Bounds::select(on_left, right, right.with(center));
        }
        let side = |k: usize, centers| Set { bounds: cut.bounds[k], centers };
        [side(0, left), side(1, right)]
    }
}

/// Puts about half of the references first, by their centers along the axis
/// in which these lie farthest apart, in whole blocks of `block`; returns how
/// many.
pub(super) fn halve(references: &mut [Reference], set: &Set, block: usize) -> usize {
    let widths = set.centers.hi - set.centers.lo;
    let axis = (1..3).fold(0, |axis, k| if widths[k] > widths[axis] { k } else { axis });
    let blocks = references.len().div_ceil(block);
    let left = blocks.div_ceil(2) * block;
    let left = left.min(references.len() - 1);
    // All of it is compared, so that the same ones go left in whatever order
    // they come.
    references.select_nth_unstable_by(left, |a, b| {
        let key = |r: &Reference| {
            let Bounds { lo, hi } = r.bounds();
            (r.center()[axis], r.number(), lo.to_array(), hi.to_array())
        };
        let ((a_at, a_number, a_lo, a_hi), (b_at, b_number, b_lo, b_hi)) = (key(a), key(b));
        let all = |lo: [f32; 4], hi: [f32; 4]| [lo, hi].concat();
        a_at.total_cmp(&b_at).then(a_number.cmp(&b_number)).then_with(|| {
            let pairs = all(a_lo, a_hi).into_iter().zip(all(b_lo, b_hi));
            pairs.fold(std::cmp::Ordering::Equal, |so_far, (a, b)| so_far.then(a.total_cmp(&b)))
        })
    });
    left
}
