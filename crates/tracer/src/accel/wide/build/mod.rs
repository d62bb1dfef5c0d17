//! The builder of the wide hierarchy: from candidates' boxes to a tree whose
//! nodes have up to eight children.
//!
//! The way there, one file each: `gather` looks at every candidate and `units`
//! makes `f32` boxes that hold the `f64` ones, `bins` finds where to cut a set in two by its members' centers and
//! `partition` does it, `spatial` cuts along a plane instead where that pays,
//! and the members on it with `clip`; `grow` goes on until sets are leaves,
//! which gives a binary tree, and reckons with `costs` which of its nodes to
//! leave out; `collapse` leaves them out, piece by piece, which `lay` puts together.
//!
//! Every box is conservative, rounded outwards. The tree is a function of the
//! candidates alone: whatever is chosen depends on sets, through counts,
//! minima and maxima, and never on an order or a thread.

mod bins;
mod bounds;
mod clip;
mod collapse;
mod costs;
mod gather;
mod grow;
mod lay;
mod partition;
mod reference;
mod space;
mod spatial;
mod units;

#[cfg(test)]
mod tests;

use glam::DVec3;

pub(crate) use self::gather::Gathered;
use self::spatial::Knife;
use crate::Aabb;
use crate::simd::Level;

/// Children of a node.
pub(crate) const WIDTH: usize = 8;

/// Levels of branches that no tree exceeds, whatever it is built of: a ray's
/// stack needs room for `(WIDTH - 1) * MAX_DEPTH + 1` children.
///
/// Proof. No way through the binary tree has more than
/// [`grow::MAX_BINARY_LEVELS`] inner nodes. On the first
/// [`collapse::FREE_LEVELS`] levels of branches each takes in at least one of
/// them; below, each takes in three levels of them.
pub(crate) const MAX_DEPTH: usize =
    collapse::FREE_LEVELS + grow::MAX_BINARY_LEVELS.div_ceil(collapse::LEVELS_PER_BRANCH);

/// A box of `f32`, rounded outwards: all points `x` with `min <= x <= max` in
/// each axis. Sides beyond the range of `f32` are infinite.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Box32 {
    /// The lowest corner.
    pub min: [f32; 3],
    /// The highest corner.
    pub max: [f32; 3],
}

impl Box32 {
    /// Holds no point.
    pub(crate) const EMPTY: Self = Self { min: [f32::INFINITY; 3], max: [f32::NEG_INFINITY; 3] };
}

/// What stands at one of a branch's eight places.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Child {
    /// Nothing: an unused place, behind the used ones.
    None,
    /// The branch of this index, which is higher than its parent's.
    Branch(u32),
    /// A leaf of 1 to `leaf_size` candidates.
    Leaf(Span),
}

/// An inner node.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Branch {
    /// What each child is inside of; empty for an unused place.
    pub bounds: [Box32; WIDTH],
    /// The children, of which there is at least one.
    pub children: [Child; WIDTH],
    /// The number of its first child that is a leaf; its others have the next
    /// ones.
    pub first_leaf: u32,
}

/// Where a leaf's candidates are: `items[first..first + count]`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) struct Span {
    /// The first.
    pub first: u32,
    /// How many.
    pub count: u32,
}

impl Span {
    /// Those of them, among all items.
    pub(crate) fn of(self, items: &[u32]) -> &[u32] {
        &items[self.first as usize..(self.first + self.count) as usize]
    }
}

/// A tree of branches and leaves.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Tree {
    /// The root first, then in the order of a walk that goes down before it
    /// goes on; none where there are no candidates.
    pub branches: Vec<Branch>,
    /// The leaves, branch after branch.
    pub leaves: Vec<Span>,
    /// Candidates' numbers, leaf after leaf in the order of that walk, and
    /// between leaves what means nothing. One that was split is in several
    /// leaves, but in each once; of the boxes of these leaves each holds a part
    /// of it, and all together the whole.
    pub items: Vec<u32>,
}

/// How to build.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Options {
    /// At most how many candidates are tested together, as a block: the size
    /// of a leaf, and the unit in which the surface area heuristic counts them.
    /// Taken down to a power of two.
    pub leaf_size: usize,
    /// How many items there may be above the number of candidates, in shares
    /// of that: with any, candidates that reach far go to several leaves, each
    /// of which has a part of them in its box, where that pays. 0 for none.
    pub extra: f64,
    /// The instructions to build with.
    pub level: Level,
}

/// What a tree is built of.
pub(crate) trait Candidates: Sync {
    /// How many there may be; they are numbered from 0.
    fn count(&self) -> u32;
    /// The box of one, which is finite; `None` if there is none of this number.
    fn bounds(&self, number: u32) -> Option<Aabb>;
    /// The corners of one that is a triangle.
    fn corners(&self, _: u32) -> Option<[DVec3; 3]> {
        None
    }
    /// The largest coordinate of any box, or close to it.
    fn largest(&self) -> f64 {
        let boxes = (0..self.count()).filter_map(|number| self.bounds(number));
        boxes.map(|bounds| bounds.max_abs()).fold(0.0, f64::max)
    }
}

/// The tree over the candidates that were gathered.
pub(crate) fn build(gathered: Gathered, candidates: &impl Candidates, options: Options) -> Tree {
    let Gathered { scale, units, references, count, set, .. } = gathered;
    if count == 0 {
        return Tree::default();
    }
    let corners = |number| {
        let [a, b, c] = candidates.corners(number)?;
        Some([a * scale, b * scale, c * scale])
    };
    let knife = Knife { units, corners: &corners };
    let grown = grow::grow(references, count, &set, options, knife);
    collapse::collapse(grown, units)
}
