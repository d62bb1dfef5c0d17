//! `commit`: write what was proposed.

use rayon::prelude::*;

use super::{Change, Moved, Proposal, Proposals};
use crate::hash::content_hash;
use crate::metric::Comparison;
use crate::run::read_golden;
use crate::store::{self, StoreError};
use crate::suite::Suite;
use crate::verdict::Verdict;

/// What became of a fixture or golden.
#[derive(Debug, Clone, PartialEq)]
pub enum Blessed {
    /// It was a match; nothing was written.
    Untouched,
    /// A golden was written where there was none.
    Added,
    /// A golden was replaced.
    Replaced {
        /// What was said of the old one.
        verdict: Verdict,
        /// From the old golden to the new one; `None` if they cannot be
        /// compared.
        distance: Option<Box<Comparison>>,
    },
    /// A golden without a fixture was removed.
    Pruned,
    /// A golden without a fixture was left, as removing was not asked for.
    LeftOrphan,
    /// Not accepted, and why.
    Refused(Vec<String>),
}

/// Writes and removes what was proposed, each golden whole or not at all, and
/// removes what killed runs left half-written. What became of each name, in
/// their order.
///
/// # Errors
/// Goldens that changed since they were looked at: then nothing is written. A
/// golden that cannot be written is refused, and the others are written.
pub fn commit(suite: &Suite, proposals: Proposals) -> Result<Vec<(String, Blessed)>, Vec<Moved>> {
    let moved: Vec<_> = proposals.values().filter_map(|proposal| moved(suite, proposal)).collect();
    if !moved.is_empty() {
        return Err(moved);
    }
    store::sweep(&suite.golden_folder());
    let write = |(name, proposal): (String, Proposal)| {
        let blessed = match proposal {
            Proposal::Untouched => Blessed::Untouched,
            Proposal::LeftOrphan => Blessed::LeftOrphan,
            Proposal::Refused(why) => Blessed::Refused(why),
            Proposal::Change(change) => write(suite, *change)
                .unwrap_or_else(|error| Blessed::Refused(vec![error.to_string()])),
        };
        (name, blessed)
    };
    Ok(proposals.into_par_iter().map(write).collect())
}

fn moved(suite: &Suite, proposal: &Proposal) -> Option<Moved> {
    let Proposal::Change(change) = proposal else { return None };
    let step = &change.step;
    let now = read_golden(&suite.golden_path(&step.name)).ok().flatten().map(content_hash);
    let say = |hash: &Option<String>| hash.clone().unwrap_or_else(|| "none".to_owned());
    (now != step.before).then(|| Moved {
        name: step.name.clone(),
        what: "the golden's file",
        expected: say(&step.before),
        found: say(&now),
    })
}

fn write(
    suite: &Suite,
    Change { step, verdict, distance, png }: Change,
) -> Result<Blessed, StoreError> {
    let path = suite.golden_path(&step.name);
    let Some(png) = png else {
        store::remove(&path)?;
        return Ok(Blessed::Pruned);
    };
    store::write(&path, &png)?;
    Ok(match step.before {
        None => Blessed::Added,
        Some(_) => Blessed::Replaced { verdict, distance: distance.map(Box::new) },
    })
}
