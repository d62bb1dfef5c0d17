//! Growing a binary tree: sets are cut in two until they are leaves.

use super::Options;
use super::bins::{BINS, Bins, Cut, Grid};
use super::bounds::Bounds;
use super::costs::{Costs, Shares};
use super::partition::{Set, halve, partition};
use super::reference::Reference;

/// Below this many levels sets are halved by count.
const FREE_LEVELS: usize = 38;
/// Halvings that bring 2^32 references down to one.
const HALVINGS: usize = 32;
/// Inner nodes on the longest way through a tree.
pub(super) const MAX_BINARY_LEVELS: usize = FREE_LEVELS + HALVINGS;
/// Sets of this size and larger are grown side by side.
const TASK: usize = 4096;
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
    /// `items[first..first + count]`.
    Leaf { first: u32, count: u32 },
    /// The left child comes next, the right one so many nodes on.
    Inner { right: u32, shares: Shares },
}

/// A binary tree: small ones as the nodes in the order of a walk.
#[derive(Debug)]
pub(super) enum Part {
    Small(Vec<Node>),
    Joint { shares: Shares, bounds: Bounds, sides: Box<[Part; 2]> },
}

/// A binary tree with the candidates of its leaves.
#[derive(Debug)]
pub(super) struct Grown {
    pub root: Part,
    pub items: Vec<u32>,
}

/// The binary tree over some references, of which there is at least one.
pub(super) fn grow(mut references: Vec<Reference>, options: Options) -> Grown {
    let mut spare = vec![Reference::NONE; references.len()];
    let mut items = vec![0; references.len()];
    let set = Set::of(&references);
    let grower = Grower { block_shift: options.leaf_size.max(1).ilog2() };
    let space =
        Space { here: &mut references, there: &mut spare, items: &mut items, first: 0, level: 0 };
    let (root, _) = grower.part(space, &set);
    Grown { root, items }
}

/// Where a set is, and where its sides may go.
struct Space<'a> {
    /// The set's references.
    here: &'a mut [Reference],
    /// Room for as many.
    there: &'a mut [Reference],
    /// Theirs among the tree's items, and where these start.
    items: &'a mut [u32],
    first: u32,
    level: usize,
}

impl<'a> Space<'a> {
    /// That of both sides, after the set was put from `here` to `there`.
    fn split(self, left: usize) -> [Space<'a>; 2] {
        let (here, spare) = self.there.split_at_mut(left);
        let (there, spare_there) = self.here.split_at_mut(left);
        let (items, spare_items) = self.items.split_at_mut(left);
        let (first, level) = (self.first, self.level + 1);
        [
            Space { here, there, items, first, level },
            Space {
                here: spare,
                there: spare_there,
                items: spare_items,
                first: first + left as u32,
                level,
            },
        ]
    }
}

struct Grower {
    /// The binary logarithm of a leaf's size.
    block_shift: u32,
}

impl Grower {
    /// The tree over a set, the sides of large ones at the same time.
    fn part(&self, space: Space<'_>, set: &Set) -> (Part, Costs) {
        if space.here.len() < TASK {
            let mut nodes = Vec::new();
            let costs = self.node(space, set, &mut nodes);
            return (Part::Small(nodes), costs);
        }
        let (sides, [left_space, right_space]) = self.cut(space, set);
        let ((left, left_costs), (right, right_costs)) =
            rayon::join(|| self.part(left_space, &sides[0]), || self.part(right_space, &sides[1]));
        let (costs, shares) = Costs::inner(set.bounds.half_area(), &left_costs, &right_costs);
        (Part::Joint { shares, bounds: set.bounds, sides: Box::new([left, right]) }, costs)
    }

    /// Appends the tree over a set.
    fn node(&self, space: Space<'_>, set: &Set, nodes: &mut Vec<Node>) -> Costs {
        let bounds = set.bounds;
        let count = space.here.len();
        if count <= 1 << self.block_shift {
            for (item, reference) in space.items.iter_mut().zip(&*space.here) {
                *item = reference.number();
            }
            space.items.sort_unstable();
            let kind = Kind::Leaf { first: space.first, count: count as u32 };
            nodes.push(Node { bounds, kind });
            return Costs::leaf(bounds.half_area());
        }
        let index = nodes.len();
        nodes.push(Node { bounds, kind: Kind::Leaf { first: 0, count: 0 } });
        let (sides, [left_space, right_space]) = self.cut(space, set);
        let left = self.node(left_space, &sides[0], nodes);
        let right_index = nodes.len();
        let right = self.node(right_space, &sides[1], nodes);
        let (costs, shares) = Costs::inner(bounds.half_area(), &left, &right);
        nodes[index].kind = Kind::Inner { right: (right_index - index) as u32, shares };
        costs
    }

    /// Cuts a set of at least two.
    fn cut<'a>(&self, space: Space<'a>, set: &Set) -> ([Set; 2], [Space<'a>; 2]) {
        let best = if space.level < FREE_LEVELS { self.best_cut(space.here, set) } else { None };
        if let Some(cut) = best {
            let sides = partition(space.here, space.there, &cut);
            return (sides, space.split(cut.left));
        }
        let left = halve(space.here, set, 1 << self.block_shift);
        space.there.copy_from_slice(space.here);
        let (left_ones, right_ones) = space.here.split_at(left);
        let sides = [Set::of(left_ones), Set::of(right_ones)];
        (sides, space.split(left))
    }

    fn best_cut(&self, references: &[Reference], set: &Set) -> Option<Cut> {
        let count = (MIN_BINS + references.len() / PER_BIN).min(BINS);
        Bins::of(Grid::new(set.centers, count), references).best_cut(self.block_shift)
    }
}
