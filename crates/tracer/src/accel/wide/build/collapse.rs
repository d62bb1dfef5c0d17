//! The collapse of a binary tree into branches of up to eight children.

use super::bounds::Bounds;
use super::costs::Shares;
use super::grow::{Grown, Kind, Node, Part};
use super::units::Units;
use super::{Box32, Branch, Child, Tree, WIDTH};

/// Levels of branches on which children are the ones that cost least. Below,
/// they are those three binary levels down.
pub(super) const FREE_LEVELS: usize = 16;
/// A guess that is rarely too high, for the room that branches take.
const ITEMS_PER_BRANCH: usize = 16;
/// The binary logarithm of [`WIDTH`].
pub(super) const LEVELS_PER_BRANCH: usize = 3;

/// The tree of branches.
pub(super) fn collapse(grown: &Grown, units: Units) -> Tree {
    let mut walk = Walk { units, from: &grown.items, tree: Tree::default() };
    walk.tree.items.reserve(grown.items.len());
    walk.tree.branches.reserve(grown.items.len() / ITEMS_PER_BRANCH);
    walk.branch(Place::of(&grown.root), 0);
    walk.tree
}

/// A node of the binary tree.
#[derive(Clone, Copy)]
enum Place<'a> {
    Joint { shares: Shares, bounds: Bounds, sides: &'a [Part; 2] },
    In { nodes: &'a [Node], index: usize },
}

/// What a node of the binary tree is.
enum Seen<'a> {
    Leaf { first: u32, count: u32 },
    Inner { shares: Shares, sides: [Place<'a>; 2] },
}

impl<'a> Place<'a> {
    fn of(part: &'a Part) -> Self {
        match part {
            Part::Small(nodes) => Self::In { nodes, index: 0 },
            Part::Joint { shares, bounds, sides } => {
                Self::Joint { shares: *shares, bounds: *bounds, sides }
            }
        }
    }

    fn bounds(self) -> Bounds {
        match self {
            Self::Joint { bounds, .. } => bounds,
            Self::In { nodes, index } => nodes[index].bounds,
        }
    }

    fn see(self) -> Seen<'a> {
        match self {
            Self::Joint { shares, sides, .. } => {
                Seen::Inner { shares, sides: [Self::of(&sides[0]), Self::of(&sides[1])] }
            }
            Self::In { nodes, index } => match nodes[index].kind {
                Kind::Leaf { first, count } => Seen::Leaf { first, count },
                Kind::Inner { right, shares } => {
                    let side = |index| Self::In { nodes, index };
                    Seen::Inner { shares, sides: [side(index + 1), side(index + right as usize)] }
                }
            },
        }
    }
}

struct Walk<'a> {
    units: Units,
    /// The binary tree's items.
    from: &'a [u32],
    tree: Tree,
}

impl<'a> Walk<'a> {
    /// Appends the branch for this node and all below it; returns its index.
    fn branch(&mut self, place: Place<'a>, level: usize) -> u32 {
        let mut chosen = Chosen { places: [place; WIDTH], count: 0 };
        if level < FREE_LEVELS {
            chosen.cheapest(place, WIDTH, true);
        } else {
            chosen.down(place, LEVELS_PER_BRANCH);
        }
        let index = self.tree.branches.len();
        let none = Branch { bounds: [Box32::EMPTY; WIDTH], children: [Child::None; WIDTH] };
        self.tree.branches.push(none);
        for (k, &place) in chosen.places[..chosen.count].iter().enumerate() {
            let child = match place.see() {
                Seen::Leaf { first, count } => {
                    let start = self.tree.items.len() as u32;
                    let leaf = &self.from[first as usize..(first + count) as usize];
                    self.tree.items.extend_from_slice(leaf);
                    Child::Leaf { first: start, count }
                }
                Seen::Inner { .. } => Child::Branch(self.branch(place, level + 1)),
            };
            let branch = &mut self.tree.branches[index];
            branch.bounds[k] = self.units.scene_box(place.bounds());
            branch.children[k] = child;
        }
        index as u32
    }
}

/// The children of a branch.
struct Chosen<'a> {
    places: [Place<'a>; WIDTH],
    count: usize,
}

impl<'a> Chosen<'a> {
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
