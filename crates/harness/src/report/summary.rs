//! `Summary`: how many of each verdict a run has.

use std::collections::BTreeMap;
use std::fmt;

use crate::verdict::{Origin, Outcome, Verdict};

/// How many of each verdict.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Summary {
    /// How many fixtures and orphan goldens were judged.
    pub total: usize,
    /// How many of each verdict there is one of.
    pub counts: BTreeMap<Verdict, usize>,
    /// How many of them were unchanged since their last match.
    pub unchanged: usize,
    /// How many of the unchanged were rendered again as an audit.
    pub audited: usize,
    /// How many of the audited were no match, against what was recorded.
    pub belied: usize,
}

impl Summary {
    /// Whether everything matches and there was something to match.
    pub fn is_green(&self) -> bool {
        self.total > 0 && self.counts.get(&Verdict::Match) == Some(&self.total)
    }
}

impl fmt::Display for Summary {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} judged:", self.total)?;
        for (i, (verdict, count)) in self.counts.iter().enumerate() {
            let comma = if i == 0 { "" } else { "," };
            write!(f, "{comma} {count} {}", verdict.words())?;
        }
        if self.unchanged > 0 {
            let Self { unchanged, audited, .. } = self;
            write!(f, " ({unchanged} unchanged since their last match, {audited} of them ")?;
            write!(f, "rendered again as an audit)")?;
        }
        Ok(())
    }
}

/// Counts the verdicts.
pub fn summarize(outcomes: &[Outcome]) -> Summary {
    let mut counts = BTreeMap::new();
    for outcome in outcomes {
        *counts.entry(outcome.verdict).or_default() += 1;
    }
    let count = |of: &[Origin]| outcomes.iter().filter(|o| of.contains(&o.origin)).count();
    Summary {
        total: outcomes.len(),
        counts,
        unchanged: count(&[Origin::Unchanged, Origin::Audited, Origin::Belied]),
        audited: count(&[Origin::Audited, Origin::Belied]),
        belied: count(&[Origin::Belied]),
    }
}
