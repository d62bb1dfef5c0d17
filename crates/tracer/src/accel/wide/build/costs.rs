//! `Costs`: what a part of the binary tree costs as up to so many children, of
//! which the collapse chooses the cheapest.
//!
//! Source: Ylitie, Karras and Laine, "Efficient Incoherent Ray Traversal on
//! GPUs Through Compressed Wide BVHs", 2017, section 3.2.

use super::WIDTH;

/// `least[n - 1]` is the least sum of branches' half areas as at most `n`
/// children, each a branch or a leaf.
#[derive(Debug, Clone, Copy)]
pub(super) struct Costs {
    least: [f32; WIDTH],
}

/// How many of `n` children of a parent come from the left side of an inner
/// node, for each `n`; 0 where the node is best one child, a branch, itself.
///
/// Four bits for each `n`, the lowest for 1; for `WIDTH` it is those of the
/// node's own branch.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Shares(u32);

const BITS: u32 = 4;

impl Shares {
    pub(super) fn left_of(self, children: usize) -> usize {
        (self.0 >> (BITS * (children as u32 - 1))) as usize & ((1 << BITS) - 1)
    }
}

impl Costs {
    /// Those of a leaf: what leaves cost is the same whichever branches there
    /// are, and left out.
    pub(super) const LEAF: Self = Self { least: [0.0; WIDTH] };

    /// Those of an inner node with these two sides.
    pub(super) fn inner(half_area: f32, left: &Self, right: &Self) -> (Self, Shares) {
        let mut least = [0.0; WIDTH];
        let mut shares = [1; WIDTH];
        for n in 2..=WIDTH {
            let mut best = f32::INFINITY;
            for from_left in 1..n {
                let cost = left.least[from_left - 1] + right.least[n - from_left - 1];
                if cost < best {
                    best = cost;
                    shares[n - 1] = from_left as u32;
                }
            }
            least[n - 1] = best;
        }
        let as_branch = half_area + least[WIDTH - 1];
        least[0] = as_branch;
        shares[0] = 0;
        for n in 2..WIDTH {
            if as_branch <= least[n - 1] {
                least[n - 1] = as_branch;
                shares[n - 1] = 0;
            }
        }
        let packed = (0..).zip(shares).fold(0, |all, (n, share)| all | share << (BITS * n));
        (Self { least }, Shares(packed))
    }
}
