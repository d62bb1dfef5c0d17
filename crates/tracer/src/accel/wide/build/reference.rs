//! `Reference`: a candidate's number with a box around it, or around the part
//! of it that one place of the tree is concerned with.

use glam::Vec4;
use rayon::prelude::*;

use super::bounds::Bounds;

/// Places are made by this many at a time.
const CHUNK: usize = 1 << 14;
/// Bits of a candidate's number that each of the two fourth lanes carries.
const HALF: u32 = 16;
/// Makes them the last bits of a number between 1 and 2, which no arithmetic
/// is slow with, as it may be with subnormal numbers.
const ONE: u32 = 0x3f80_0000;

/// A box, with a candidate's number in its fourth lanes.
#[derive(Debug, Clone, Copy)]
pub(super) struct Reference(Bounds);

impl Reference {
    /// Stands where there is none yet.
    const NONE: Self = Self(Bounds { lo: Vec4::ONE, hi: Vec4::ONE });

    /// So many places for references.
    pub(super) fn blanks(count: usize) -> Vec<Self> {
        // By all threads, as it is each page's first touch that takes time.
        let blanks = (0..count).into_par_iter().with_min_len(CHUNK);
        blanks.map(|_| Self::NONE).collect()
    }

    pub(super) fn new(min: [f32; 3], max: [f32; 3], number: u32) -> Self {
        let [low, high] = [number & ((1 << HALF) - 1), number >> HALF];
        let lane = |half: u32| f32::from_bits(ONE | half);
        Self(Bounds {
            lo: Vec4::new(min[0], min[1], min[2], lane(low)),
            hi: Vec4::new(max[0], max[1], max[2], lane(high)),
        })
    }

    #[inline]
    pub(super) fn bounds(&self) -> Bounds {
        self.0
    }

    #[inline]
    pub(super) fn center(&self) -> Vec4 {
        self.0.center()
    }

    #[inline]
    pub(super) fn number(&self) -> u32 {
        let half = |lane: f32| lane.to_bits() & ((1 << HALF) - 1);
        half(self.0.lo.w) | half(self.0.hi.w) << HALF
    }
}
