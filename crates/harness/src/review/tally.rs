//! `Tally`: how a review stands, in one line.

use std::fmt;

use super::{Decision, Review};
use crate::verdict::Verdict;

/// The names of a review by what became of them, each in the order of names.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Tally {
    /// What was accepted.
    pub accepted: Vec<String>,
    /// What was rejected.
    pub rejected: Vec<String>,
    /// What is no match and nothing was decided about, or whose golden is no longer
    /// what was accepted.
    pub left: Vec<String>,
}

impl Tally {
    pub(super) fn of(review: &Review) -> Self {
        let mut tally = Self::default();
        // An accepted golden may have been judged again since, or be gone.
        for (name, decision) in &review.decided {
            match decision {
                // Somebody has changed it since, or it cannot be read.
                Decision::Accepted if review.is_as_accepted(name) != Ok(true) => {
                    tally.left.push(name.clone());
                }
                Decision::Accepted => tally.accepted.push(name.clone()),
                Decision::Rejected => tally.rejected.push(name.clone()),
            }
        }
        let failing = review.outcomes().filter(|outcome| outcome.verdict != Verdict::Match);
        let left = failing.filter(|outcome| review.decision(&outcome.name).is_none());
        tally.left.extend(left.map(|outcome| outcome.name.clone()));
        tally.left.sort();
        tally
    }

    /// Whether everything that is no match was accepted.
    pub fn is_settled(&self) -> bool {
        self.rejected.is_empty() && self.left.is_empty()
    }
}

impl fmt::Display for Tally {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { accepted, rejected, left } = self;
        let (accepted, rejected, left) = (accepted.len(), rejected.len(), left.len());
        write!(f, "{accepted} accepted, {rejected} rejected, {left} left")
    }
}
