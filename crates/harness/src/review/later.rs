//! What a later review takes over from an earlier one.

use super::{Decision, Review};
use crate::verdict::{Outcome, Verdict};

impl Review {
    /// Takes over what was decided in an earlier review of the suite: what was
    /// accepted stays so where the golden is still what was accepted and a match,
    /// and what was rejected where it is the very same picture or refusal. What
    /// was accepted can be taken back for as long as the golden is that.
    pub fn inherit(&mut self, earlier: &Self) {
        let accepted = earlier.accepted.iter();
        let accepted = accepted
            .filter(|(name, accepted)| self.golden_hash(name).as_ref() == Ok(&accepted.after));
        self.accepted = accepted.map(|(name, one)| (name.clone(), one.clone())).collect();
        let is_settled = |name: &&String| {
            self.outcomes.get(*name).is_none_or(|outcome| outcome.verdict == Verdict::Match)
        };
        let accepted = self.accepted.keys().filter(is_settled);
        let accepted = accepted.map(|name| (name.clone(), Decision::Accepted));
        let rejected = earlier.decided.iter().filter(|(name, decision)| {
            **decision == Decision::Rejected && self.shows_the_same(earlier, name)
        });
        let rejected = rejected.map(|(name, _)| (name.clone(), Decision::Rejected));
        self.decided = accepted.chain(rejected).collect();
    }

    /// Whether there is the same to decide about as in an earlier review: the same
    /// to write, or the same reasons why nothing can be.
    fn shows_the_same(&self, earlier: &Self, name: &str) -> bool {
        match (self.steps.get(name), earlier.steps.get(name)) {
            (Some(now), Some(before)) => now == before,
            (None, None) => self.is_refused_as_in(earlier, name),
            _ => false,
        }
    }

    /// Whether nothing can be written for the same reasons, of the same picture.
    fn is_refused_as_in(&self, earlier: &Self, name: &str) -> bool {
        let (now, before) = (self.outcomes.get(name), earlier.outcomes.get(name));
        let (Some(now), Some(before)) = (now, before) else { return false };
        let why = self.why_not(name);
        why.is_some()
            && why == earlier.why_not(name)
            && now.findings == before.findings
            && picture(now) == picture(before)
    }
}

fn picture(outcome: &Outcome) -> Option<&[u8]> {
    Some(&outcome.evidence.as_ref()?.actual)
}
