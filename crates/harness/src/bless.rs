//! `bless`: accept pictures as goldens, only where they are not a match.
//!
//! There is one way, in two steps: [`propose`] renders and says what would be
//! written, [`commit`] writes it. A [`Plan`] is what was proposed as a file for
//! people to review; [`propose_again`] goes on from there, if nothing moved.

mod again;
mod commit;
mod plan;
mod propose;
#[cfg(test)]
mod tests;

pub(crate) use again::propose_steps;
pub use again::{Moved, propose_again};
pub use commit::{Blessed, commit};
pub use plan::{Action, Plan, PlanError, Refusal, Step};
pub use propose::{Change, Proposal, Proposals, propose};

use crate::suite::{Selection, Suite};

/// Proposes and commits at once: accepts the pictures of all selected fixtures
/// that are not a match, and removes selected goldens without a fixture if
/// `prune`. What became of each, in the order of names.
///
/// A picture that breaks an expectation or a relation of its fixture is refused,
/// and so is a fixture with problems; the others are accepted all the same.
///
/// # Errors
/// As [`commit`].
pub fn bless(
    suite: &Suite,
    selection: &Selection,
    prune: bool,
) -> Result<Vec<(String, Blessed)>, Vec<Moved>> {
    commit(suite, propose(suite, selection, prune, &|_| ()))
}
