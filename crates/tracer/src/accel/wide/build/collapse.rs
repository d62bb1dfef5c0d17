//! The collapse of a binary tree into branches of up to eight children.

use rayon::prelude::*;

use super::bounds::Bounds;
use super::costs::Shares;
use super::grow::{Grown, Joint, Kind, Node, Part};
use super::units::Units;
use super::{Box32, Branch, Child, Span, Tree, WIDTH};

/// Levels of branches on which children are the ones that cost least. Below,
/// they are those three binary levels down.
pub(super) const FREE_LEVELS: usize = 16;
/// A guess that is rarely too low, for the room that branches take.
const NODES_PER_BRANCH: usize = 6;
/// The binary logarithm of [`WIDTH`].
pub(super) const LEVELS_PER_BRANCH: usize = 3;

/// The tree of branches.
pub(super) fn collapse(grown: Grown, units: Units) -> Tree {
    let piece = Piece::new(Place::of(&grown.root), 0, units);
    let (branches, leaves) = piece.lay();
    Tree { branches, leaves, items: grown.items }
}

/// A node of the binary tree.
#[derive(Clone, Copy)]
enum Place<'a> {
    Joint(&'a Joint),
    In { nodes: &'a [Node], index: usize },
}

/// What a node of the binary tree is.
enum Seen<'a> {
    Leaf(Span),
    Inner { shares: Shares, sides: [Place<'a>; 2] },
}

impl<'a> Place<'a> {
    fn of(part: &'a Part) -> Self {
        match part {
            Part::Small(nodes) => Self::In { nodes, index: 0 },
            Part::Joint(joint) => Self::Joint(joint),
        }
    }

    fn bounds(self) -> Bounds {
        match self {
            Self::Joint(joint) => joint.bounds,
            Self::In { nodes, index } => nodes[index].bounds,
        }
    }

    fn see(self) -> Seen<'a> {
        match self {
            Self::Joint(Joint { shares, sides, .. }) => {
                Seen::Inner { shares: *shares, sides: [Self::of(&sides[0]), Self::of(&sides[1])] }
            }
            Self::In { nodes, index } => match nodes[index].kind {
                Kind::Leaf(span) => Seen::Leaf(span),
                Kind::Inner { right, shares } => {
                    let side = |index| Self::In { nodes, index };
                    Seen::Inner { shares, sides: [side(index + 1), side(index + right as usize)] }
                }
            },
        }
    }
}

/// What a walk over a part of the binary tree has found.
#[derive(Default)]
pub(super) struct Walked {
    pub branches: Vec<Branch>,
    pub leaves: Vec<Span>,
}

impl Walked {
    /// Appends the branch for this node and all below it; returns its index.
    fn branch(&mut self, place: Place<'_>, level: usize, units: Units) -> u32 {
        let chosen = Chosen::of(place, level);
        let index = self.branches.len();
        self.branches.push(chosen.branch(units, &mut self.leaves));
        for (k, &place) in chosen.all().iter().enumerate() {
            if let Seen::Inner { .. } = place.see() {
                let child = self.branch(place, level + 1, units);
                self.branches[index].children[k] = Child::Branch(child);
            }
        }
        index as u32
    }
}

/// A branch and all below it.
pub(super) enum Piece {
    /// All of it in one.
    Whole(Walked),
    /// A branch, its leaves, and what is below it: by the number of the child.
    Joint { branch: Box<Branch>, leaves: Vec<Span>, below: Vec<(usize, Piece)> },
}

impl Piece {
    /// The branch for a node and all below it, those of large parts side by
    /// side.
    fn new(place: Place<'_>, level: usize, units: Units) -> Self {
        if let Place::In { nodes, .. } = place {
            let mut walked = Walked::default();
            walked.branches.reserve(nodes.len() / NODES_PER_BRANCH + 1);
            walked.leaves.reserve(nodes.len() / 2 + 1);
            walked.branch(place, level, units);
            return Self::Whole(walked);
        }
        let chosen = Chosen::of(place, level);
        let mut leaves = Vec::new();
        let branch = chosen.branch(units, &mut leaves);
        let children = chosen.all().par_iter().enumerate();
        let inner = children.filter(|(_, place)| matches!(place.see(), Seen::Inner { .. }));
        let below = inner.map(|(k, &place)| (k, Self::new(place, level + 1, units)));
        Self::Joint { branch: Box::new(branch), leaves, below: below.collect() }
    }
}

/// The children of a branch.
struct Chosen<'a> {
    places: [Place<'a>; WIDTH],
    count: usize,
}

impl<'a> Chosen<'a> {
    /// Those of the branch for this node, so many levels below the root.
    fn of(place: Place<'a>, level: usize) -> Self {
        let mut chosen = Self { places: [place; WIDTH], count: 0 };
        if level < FREE_LEVELS {
            chosen.cheapest(place, WIDTH, true);
        } else {
            chosen.down(place, LEVELS_PER_BRANCH);
        }
        chosen
    }

    fn all(&self) -> &[Place<'a>] {
        &self.places[..self.count]
    }

    /// The branch of these children, of which those that are branches are left
    /// out. Appends the leaves.
    fn branch(&self, units: Units, leaves: &mut Vec<Span>) -> Branch {
        let mut branch = Branch {
            bounds: [Box32::EMPTY; WIDTH],
            children: [Child::None; WIDTH],
            first_leaf: leaves.len() as u32,
        };
        for (k, place) in self.all().iter().enumerate() {
            branch.bounds[k] = units.scene_box(place.bounds());
            if let Seen::Leaf(span) = place.see() {
                branch.children[k] = Child::Leaf(span);
                leaves.push(span);
            }
        }
        branch
    }

    fn push(&mut self, place: Place<'a>) {
        self.places[self.count] = place;
        self.count += 1;
    }

    /// Takes this node as at most `room` children; the root of the branch is
    /// not one itself.
    fn cheapest(&mut self, place: Place<'a>, room: usize, is_root: bool) {
        match place.see() {
            Seen::Inner { shares, sides } if is_root || shares.left_of(room) > 0 => {
                let left = shares.left_of(room);
                self.cheapest(sides[0], left, false);
                self.cheapest(sides[1], room - left, false);
            }
            _ => self.push(place),
        }
    }

    /// Takes this node as its descendants so many levels down.
    fn down(&mut self, place: Place<'a>, levels: usize) {
        match place.see() {
            Seen::Inner { sides, .. } if levels > 0 => {
                for side in sides {
                    self.down(side, levels - 1);
                }
            }
            _ => self.push(place),
        }
    }
}
