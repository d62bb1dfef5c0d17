//! `Node`: eight boxes and what is in each.

use super::build::{Branch, Child, Span};

/// An inner node of the hierarchy: four lines of the cache, one for each axis and
/// one for the children.
#[derive(Debug, Clone, PartialEq)]
#[repr(align(256))]
pub(super) struct Node {
    /// For each axis the lower and the upper side of each box; the wrong way round
    /// and infinite for a child that is not there, which no ray enters.
    pub(super) planes: [[[f32; 8]; 2]; 3],
    /// What is in each box.
    pub(super) children: [u32; 8],
}

/// A child's bit that says that it is a leaf.
const LEAF: u32 = 1 << 31;
/// Of a leaf: how many candidates but one it has, above its place.
const COUNT: u32 = 28;
const PLACE: u32 = (1 << COUNT) - 1;

/// The most places of leaves, and nodes.
pub(crate) const MOST_PLACES: usize = 1 << COUNT;

/// A leaf: where its candidates are, and how many.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Leaf(pub(super) u32);

impl Leaf {
    /// A leaf of `count` candidates, 1 to 8, at a place below [`MOST_PLACES`].
    pub(crate) fn new(place: u32, count: u32) -> Self {
        Self(LEAF | (count - 1) << COUNT | place)
    }

    /// The leaf that a child is, if it is one.
    #[inline(always)]
    pub(super) fn of_child(child: u32) -> Option<Self> {
        (child & LEAF != 0).then_some(Self(child))
    }

    /// Where it is.
    #[inline(always)]
    pub(crate) fn place(self) -> usize {
        (self.0 & PLACE) as usize
    }

    /// How many candidates it has.
    #[inline(always)]
    pub(crate) fn count(self) -> usize {
        ((self.0 & !LEAF) >> COUNT) as usize + 1
    }
}

impl Node {
    /// The node of a branch as built, its leaves put where `leaf` says, which is
    /// told their numbers.
    pub(super) fn new(branch: &Branch, leaf: impl Fn(u32, Span) -> Leaf) -> Self {
        let nowhere = [[f32::INFINITY; 8], [f32::NEG_INFINITY; 8]];
        let mut node = Self { planes: [nowhere; 3], children: [0; 8] };
        let mut number = branch.first_leaf;
        for (k, (bounds, child)) in branch.bounds.iter().zip(&branch.children).enumerate() {
            node.children[k] = match *child {
                Child::None => continue,
                Child::Branch(branch) => branch,
                Child::Leaf(span) => {
                    number += 1;
                    leaf(number - 1, span).0
                }
            };
            for axis in 0..3 {
                node.planes[axis][0][k] = bounds.min[axis];
                node.planes[axis][1][k] = bounds.max[axis];
            }
        }
        node
    }

    /// Whether there is a child of this number.
    pub(super) fn has(&self, child: usize) -> bool {
        self.planes[0][0][child] <= self.planes[0][1][child]
    }
}
