//! Laying pieces of the tree one behind the other, in the order of a walk.

use rayon::prelude::*;

use super::collapse::{Piece, Walked};
use super::{Box32, Branch, Child, Span, WIDTH};

/// Places are made by this many at a time.
const CHUNK: usize = 1024;

/// How many branches and leaves there are, or come before.
type Counts = [usize; 2];

/// Where something goes, and what comes before that.
struct Room<'a> {
    branches: &'a mut [Branch],
    leaves: &'a mut [Span],
    before: Counts,
}

impl Piece {
    /// All branches and leaves.
    pub(super) fn lay(self) -> (Vec<Branch>, Vec<Span>) {
        if let Self::Whole(Walked { branches, leaves }) = self {
            return (branches, leaves);
        }
        let [branches, leaves] = self.counts();
        let blank =
            Branch { bounds: [Box32::EMPTY; WIDTH], children: [Child::None; WIDTH], first_leaf: 0 };
        // By all threads, as it is each page's first touch that takes time.
        let blanks = (0..branches).into_par_iter().with_min_len(CHUNK).map(|_| blank);
        let mut branches: Vec<_> = blanks.collect();
        let mut leaves = vec![Span::default(); leaves];
        let before = [0, 0];
        self.put(Room { branches: &mut branches, leaves: &mut leaves, before });
        (branches, leaves)
    }

    fn counts(&self) -> Counts {
        match self {
            Self::Whole(Walked { branches, leaves }) => [branches.len(), leaves.len()],
            Self::Joint { leaves, below, .. } => {
                let counts = below.iter().map(|(_, piece)| piece.counts());
                counts.fold([1, leaves.len()], |[a, b], [c, d]| [a + c, b + d])
            }
        }
    }

    fn put(&self, room: Room<'_>) {
        let Room { branches, leaves, before } = room;
        match self {
            Self::Whole(walked) => {
                for (to, from) in branches.iter_mut().zip(&walked.branches) {
                    *to = *from;
                    to.first_leaf += before[1] as u32;
                    for child in &mut to.children {
                        if let Child::Branch(index) = child {
                            *index += before[0] as u32;
                        }
                    }
                }
                leaves.copy_from_slice(&walked.leaves);
            }
            Self::Joint { branch, leaves: own, below } => {
                let (first, mut branches) = branches.split_at_mut(1);
                let (spans, mut leaves) = leaves.split_at_mut(own.len());
                spans.copy_from_slice(own);
                first[0] = Branch { first_leaf: before[1] as u32, ..**branch };
                let mut at = [before[0] + 1, before[1] + own.len()];
                let mut rooms = Vec::new();
                for (k, piece) in below {
                    first[0].children[*k] = Child::Branch(at[0] as u32);
                    let counts = piece.counts();
                    let (its_branches, other_branches) = branches.split_at_mut(counts[0]);
                    let (its_leaves, other_leaves) = leaves.split_at_mut(counts[1]);
                    rooms.push((
                        piece,
                        Room { branches: its_branches, leaves: its_leaves, before: at },
                    ));
                    (branches, leaves) = (other_branches, other_leaves);
                    at = [at[0] + counts[0], at[1] + counts[1]];
                }
                rooms.into_par_iter().for_each(|(piece, room)| piece.put(room));
            }
        }
    }
}
