//! Growing a binary tree: sets are cut in two until they are leaves.

use glam::Vec3;

use super::bins::{BINS, BestCut, Bins, Cut, Grid, SHARED};
use super::bounds::Bounds;
use super::costs::{Costs, Shares};
use super::partition::{Partition, Set, halve};
use super::reference::Reference;
use super::space::Space;
use super::spatial::{Knife, cut_along, first_plane};
use super::{Options, Span};
use crate::simd::Level;

/// Below this many levels sets are halved by count.
const FREE_LEVELS: usize = 38;
/// Halvings that bring 2^32 references down to one.
const HALVINGS: usize = 32;
/// Inner nodes on the longest way through a tree.
pub(super) const MAX_BINARY_LEVELS: usize = FREE_LEVELS + HALVINGS;
/// Sets of this size and larger are grown side by side.
const TASK: usize = 4096;
/// Planes are looked for where the boxes of the best cut's sides have in common
/// this share of the set's width in each axis: along one in which they part
/// more clearly, a plane would part them no better,
const THICK: f32 = 0.2;
/// and this share of the whole tree's area: less is not met by enough rays.
const LEAST_OVERLAP: f32 = 1e-2;
/// A plane is taken if it costs less than this share of the best cut.
const GAIN: f32 = 0.95;
/// After so many sets in vain, one in another, there is none worth looking for.
const PATIENCE: u32 = 2;
/// Planes are looked for in sets from this size on: in smaller ones they
/// promise next to nothing.
const FEWEST: usize = 64;
/// The fewest bins, and the references for each one more.
const MIN_BINS: usize = 8;
const PER_BIN: usize = 8;

/// A node of the binary tree.
#[derive(Debug, Clone, Copy)]
pub(super) struct Node {
    pub bounds: Bounds,
    pub kind: Kind,
}

#[derive(Debug, Clone, Copy)]
pub(super) enum Kind {
    Leaf(Span),
    /// The left child comes next, the right one so many nodes on.
    Inner {
        right: u32,
        shares: Shares,
    },
}

/// A binary tree: small ones as the nodes in the order of a walk.
#[derive(Debug)]
pub(super) enum Part {
    Small(Vec<Node>),
    Joint(Box<Joint>),
}

/// An inner node, and what is on its sides.
#[derive(Debug)]
pub(super) struct Joint {
    pub shares: Shares,
    pub bounds: Bounds,
    pub sides: [Part; 2],
}

/// A binary tree with the candidates of its leaves.
#[derive(Debug)]
pub(super) struct Grown {
    pub root: Part,
    pub items: Vec<u32>,
}

/// The binary tree over a set of at least one reference, which are first in the
/// vector; what else is in it is room for more.
pub(super) fn grow(
    mut references: Vec<Reference>,
    count: u32,
    set: &Set,
    options: Options,
    knife: Knife<'_>,
) -> Grown {
    let mut there = Reference::blanks(references.len());
    let mut items = vec![0; references.len()];
    let least_overlap = LEAST_OVERLAP * set.bounds.half_area();
    let block_shift = options.leaf_size.max(1).ilog2();
    let grower = Grower { level: options.level, block_shift, knife, least_overlap };
    let space = Space {
        here: &mut references,
        there: &mut there,
        items: &mut items,
        first: 0,
        start: 0,
        count: count as usize,
        level: 0,
        misses: 0,
    };
    let (root, _) = grower.part(space, set);
    Grown { root, items }
}

/// What a task keeps at hand.
struct Work {
    nodes: Vec<Node>,
    bins: Bins,
}

struct Grower<'a> {
    /// With which instructions.
    level: Level,
    /// The binary logarithm of a leaf's size.
    block_shift: u32,
    knife: Knife<'a>,
    /// The least area in common for which planes are looked for.
    least_overlap: f32,
}

impl Grower<'_> {
    /// The tree over a set, the sides of large ones at the same time.
    fn part(&self, space: Space<'_>, set: &Set) -> (Part, Costs) {
        if space.count < TASK {
            let nodes = Vec::with_capacity(space.count);
            let mut work = Work { nodes, bins: Bins::empty() };
            let costs = self.node(space, set, &mut work);
            return (Part::Small(work.nodes), costs);
        }
        let (sides, [left_space, right_space]) = self.cut(space, set, &mut Bins::empty());
        let ((left, left_costs), (right, right_costs)) =
            rayon::join(|| self.part(left_space, &sides[0]), || self.part(right_space, &sides[1]));
        let (costs, shares) = Costs::inner(set.bounds.half_area(), &left_costs, &right_costs);
        let joint = Joint { shares, bounds: set.bounds, sides: [left, right] };
        (Part::Joint(Box::new(joint)), costs)
    }

    /// Appends the tree over a set.
    fn node(&self, space: Space<'_>, set: &Set, work: &mut Work) -> Costs {
        let bounds = set.bounds;
        if space.count <= 1 << self.block_shift {
            work.nodes.push(Node { bounds, kind: leaf(space) });
            return Costs::LEAF;
        }
        let index = work.nodes.len();
        work.nodes.push(Node { bounds, kind: Kind::Leaf(Span::default()) });
        let (sides, [left_space, right_space]) = self.cut(space, set, &mut work.bins);
        let left = self.node(left_space, &sides[0], work);
        let right_index = work.nodes.len();
        let right = self.node(right_space, &sides[1], work);
        let (costs, shares) = Costs::inner(bounds.half_area(), &left, &right);
        work.nodes[index].kind = Kind::Inner { right: (right_index - index) as u32, shares };
        costs
    }

    /// Cuts a set of at least two.
    fn cut<'a>(
        &self,
        mut space: Space<'a>,
        set: &Set,
        bins: &mut Bins,
    ) -> ([Set; 2], [Space<'a>; 2]) {
        let best =
            if space.level < FREE_LEVELS { self.best_cut(space.set(), set, bins) } else { None };
        if let Some(cut) = best {
            if let Some((sides, [left, right])) = self.cut_along(&mut space, set, &cut) {
                return (sides, space.split(left, right));
            }
            let (left, right) = (cut.left, space.count - cut.left);
            let (from, to) = space.set_and_room();
            let sides = self.level.run(Partition { from, to, cut: &cut });
            return (sides, space.split(left, right));
        }
        let (from, to) = space.set_and_room();
        let left = halve(from, set, 1 << self.block_shift);
        let right = from.len() - left;
        let start = to.len() - right;
        to[..left].copy_from_slice(&from[..left]);
        to[start..].copy_from_slice(&from[left..]);
        let sides = [Set::of(&from[..left]), Set::of(&from[left..])];
        (sides, space.split(left, right))
    }

    fn best_cut(&self, references: &[Reference], set: &Set, bins: &mut Bins) -> Option<Cut> {
        let count = (MIN_BINS + references.len() / PER_BIN).min(BINS);
        let grid = Grid::new(set.centers, count);
        let block_shift = self.block_shift;
        if references.len() < SHARED {
            self.level.run(BestCut { bins, grid, references, block_shift })
        } else {
            bins.refill_side_by_side(self.level, grid, references);
            bins.best_cut(block_shift)
        }
    }

    /// Cuts along a plane, if that is so much better than `cut` that it is
    /// worth the room that it takes.
    fn cut_along(
        &self,
        space: &mut Space<'_>,
        set: &Set,
        cut: &Cut,
    ) -> Option<([Set; 2], [usize; 2])> {
        if space.count < FEWEST || space.spare() == 0 || space.misses == PATIENCE {
            return None;
        }
        let [left, right] = cut.bounds;
        let overlap = left.overlap(right);
        let thickness = (overlap.hi - overlap.lo) / (set.bounds.hi - set.bounds.lo);
        // NaN, and so not thick, where the set is flat.
        let is_thick = thickness.truncate().cmpge(Vec3::splat(THICK)).all();
        if !is_thick || overlap.half_area() < self.least_overlap {
            return None;
        }
        space.misses += 1;
        let limit = GAIN * cut.cost;
        let plane = first_plane(self.level, set, space.set(), self.block_shift, limit)?;
        let (from, to) = space.set_and_room();
        let cut = cut_along(plane, from, to, &self.knife)?;
        space.misses = 0;
        Some(cut)
    }
}

/// A leaf of the set's candidates, of whose parts one stands for all.
pub(super) fn leaf(space: Space<'_>) -> Kind {
    let Space { here, start, items, first, mut count, .. } = space;
    let items = &mut items[..count];
    for (item, reference) in items.iter_mut().zip(&here[start..]) {
        *item = reference.number();
    }
    items.sort_unstable();
    for k in (1..count).rev() {
        if items[k] == items[k - 1] {
            items.copy_within(k..count, k - 1);
            count -= 1;
        }
    }
    Kind::Leaf(Span { first, count: count as u32 })
}
