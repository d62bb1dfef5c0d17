//! `Review`: what was judged, and what people decide about it.
//!
//! Accepting goes the way of a plan: what is proposed when the review begins is
//! proposed again when it is accepted, and written only if nothing moved, so
//! that what is accepted is what was shown. Nothing is lost by it: an acceptance
//! can be taken back for as long as its golden is what it wrote.

mod json;
mod later;
mod tally;
#[cfg(test)]
mod tests;
mod undo;

use std::collections::{BTreeMap, BTreeSet};

pub use tally::Tally;

use crate::bless::{
    Blessed, Moved, Plan, Proposals, Refusal, Step, commit, propose, propose_steps,
};
use crate::hash::content_hash;
use crate::run::read_golden;
use crate::suite::{Selection, Suite};
use crate::verdict::{Outcome, Verdict};

/// What is decided about a fixture or golden.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Decision {
    /// Its golden was written, or removed where it had no fixture.
    Accepted,
    /// It is not accepted. Nothing was written.
    Rejected,
}

/// Outcomes with what can be done about them.
#[derive(Debug)]
pub struct Review {
    suite: Suite,
    outcomes: BTreeMap<String, Outcome>,
    /// What would be written, as of when the review began.
    steps: BTreeMap<String, Step>,
    /// Why others cannot be accepted.
    refused: BTreeMap<String, String>,
    decided: BTreeMap<String, Decision>,
    /// What was accepted. It can be taken back even where there is something else
    /// to decide about by now.
    accepted: BTreeMap<String, Accepted>,
    /// The hash of each golden that was last written here; `None` for one that
    /// was removed.
    written: BTreeMap<String, Option<String>>,
}

/// What is needed to take an acceptance back: the golden's bytes before and its
/// hash after; `None` where there is none.
#[derive(Debug, Clone)]
struct Accepted {
    before: Option<Vec<u8>>,
    after: Option<String>,
}

impl Review {
    /// A review of what was judged of a suite. What is no match is rendered
    /// again, to be proposed; nothing is written.
    pub fn new(suite: &Suite, outcomes: &[Outcome]) -> Self {
        let names = |is_wanted: fn(&Outcome) -> bool| {
            let wanted = outcomes.iter().filter(|outcome| is_wanted(outcome));
            wanted.map(|outcome| outcome.name.clone()).collect()
        };
        let selection = Selection {
            fixtures: names(|o| !matches!(o.verdict, Verdict::Match | Verdict::OrphanGolden)),
            orphans: names(|o| o.verdict == Verdict::OrphanGolden),
        };
        let plan = Plan::of(&propose(suite, &selection, true, &|_| ()));
        let is_refused = |name: &str| {
            let is_it = |o: &Outcome| o.name == name && o.verdict == Verdict::RenderRefused;
            outcomes.iter().any(is_it)
        };
        let reasons = |name: &str, reasons: Vec<String>| {
            if is_refused(name) {
                // Its problems are its findings, many lines.
                return "there is no picture".to_owned();
            }
            reasons.join("; ").trim_end().to_owned()
        };
        Self {
            suite: suite.clone(),
            outcomes: outcomes.iter().map(|o| (o.name.clone(), o.clone())).collect(),
            steps: plan.goldens.into_iter().map(|step| (step.name.clone(), step)).collect(),
            refused: plan
                .refused
                .into_iter()
                .map(|Refusal { name, reasons: why }| (name.clone(), reasons(&name, why)))
                .collect(),
            decided: BTreeMap::new(),
            accepted: BTreeMap::new(),
            written: BTreeMap::new(),
        }
    }

    /// What was judged, in the order of names.
    pub fn outcomes(&self) -> impl Iterator<Item = &Outcome> {
        self.outcomes.values()
    }

    /// What is decided about this name.
    pub fn decision(&self, name: &str) -> Option<Decision> {
        self.decided.get(name).copied()
    }

    /// Whether accepting this name would write its golden, if nothing moved.
    pub fn can_accept(&self, name: &str) -> bool {
        self.steps.contains_key(name) && self.decision(name) != Some(Decision::Accepted)
    }

    /// Why this name cannot be accepted, where something about it is wrong that
    /// no golden settles.
    pub fn why_not(&self, name: &str) -> Option<&str> {
        self.refused.get(name).map(String::as_str)
    }

    /// How it stands.
    pub fn tally(&self) -> Tally {
        Tally::of(self)
    }

    /// Accepts each of these that can be, and is just as it was when the review
    /// began. What was not accepted and why, a sentence each.
    pub fn accept(&mut self, names: &[String]) -> Vec<String> {
        let (mut steps, mut said) = (Vec::new(), Vec::new());
        for name in names.iter().collect::<BTreeSet<_>>() {
            match self.step(name) {
                Ok(step) => steps.extend(step.cloned()),
                Err(why) => said.push(format!("{name} is not accepted: {why}")),
            }
        }
        let (mut proposals, moved) = propose_steps(&self.suite, &steps, &|_| ());
        said.extend(say_moved(&moved));
        proposals.retain(|name, _| moved.iter().all(|moved| moved.name != *name));
        for step in steps {
            if let Some((name, proposal)) = proposals.remove_entry(&step.name) {
                let one = Proposals::from([(name, proposal)]);
                if let Err(why) = self.write(step, one) {
                    said.push(why);
                }
            }
        }
        said
    }

    /// Notes that these are not accepted, after taking back what was. What
    /// could not be, a sentence each.
    pub fn reject(&mut self, names: &[String]) -> Vec<String> {
        let mut said = Vec::new();
        for name in names {
            let rejected = self.failing(name).and_then(|()| match self.decision(name) {
                Some(Decision::Accepted) => self.take_back(name),
                _ => Ok(()),
            });
            match rejected {
                Ok(()) => _ = self.decided.insert(name.clone(), Decision::Rejected),
                Err(why) => said.push(format!("{name} is not rejected: {why}")),
            }
        }
        said
    }

    /// Whether the golden of this name is as it was last written here, by nobody
    /// else, and all that follows from it is known here.
    pub fn wrote(&self, name: &str) -> bool {
        self.written.get(name).is_some_and(|hash| self.golden_hash(name).as_ref() == Ok(hash))
    }

    /// What would be written for this name; `None` where it has been.
    fn step(&self, name: &str) -> Result<Option<&Step>, String> {
        if self.decision(name) == Some(Decision::Accepted) {
            if self.is_as_accepted(name)? {
                return Ok(None);
            }
            // What was shown may be there again, and nothing else is written.
            let moved =
                || "its golden was accepted and has moved since; review it again".to_owned();
            return self.steps.get(name).map(Some).ok_or_else(moved);
        }
        self.failing(name)?;
        let why = || self.why_not(name).unwrap_or("it is a match by now").to_owned();
        self.steps.get(name).map(Some).ok_or_else(why)
    }

    /// Refuses what is nothing to decide about.
    fn failing(&self, name: &str) -> Result<(), String> {
        if self.decided.contains_key(name) {
            return Ok(());
        }
        match self.outcomes.get(name) {
            None => Err("it is none of the fixtures and goldens that are reviewed".to_owned()),
            Some(Outcome { verdict: Verdict::Match, .. }) => {
                Err("it is a match, there is nothing to decide".to_owned())
            }
            Some(_) => Ok(()),
        }
    }

    /// Writes what was proposed for one golden, after keeping what is there.
    fn write(&mut self, step: Step, proposal: Proposals) -> Result<(), String> {
        let Step { name, before, after, .. } = step;
        let old = read_golden(&self.suite.golden_path(&name))
            .map_err(|error| format!("{name} is not accepted: {error}"))?;
        if old.as_ref().map(content_hash) != before {
            return Err(format!("{name} is not accepted: its golden moved in this very moment"));
        }
        let sentence = |why: String| format!("{name} is not accepted: {why}");
        let blessed = commit(&self.suite, proposal).map_err(|moved| {
            sentence(moved.iter().map(ToString::to_string).collect::<Vec<_>>().join("; "))
        })?;
        if let Some((_, Blessed::Refused(why))) = blessed.into_iter().next() {
            return Err(sentence(why.join("; ").trim_end().to_owned()));
        }
        self.written.insert(name.clone(), after.clone());
        self.accepted.insert(name.clone(), Accepted { before: old, after });
        self.decided.insert(name, Decision::Accepted);
        Ok(())
    }

    /// Whether the golden of this name is what was accepted.
    fn is_as_accepted(&self, name: &str) -> Result<bool, String> {
        let hash = self.golden_hash(name)?;
        Ok(self.accepted.get(name).is_some_and(|accepted| accepted.after == hash))
    }

    fn golden_hash(&self, name: &str) -> Result<Option<String>, String> {
        let file = read_golden(&self.suite.golden_path(name)).map_err(|error| error.to_string())?;
        Ok(file.map(content_hash))
    }
}

/// A sentence for each name of which something moved, without hashes: nobody
/// has seen them.
fn say_moved(moved: &[Moved]) -> Vec<String> {
    let mut by_name = BTreeMap::<&str, Vec<&str>>::new();
    for Moved { name, what, .. } in moved {
        by_name.entry(name).or_default().push(what);
    }
    let sentence = |(name, what): (&str, Vec<&str>)| {
        format!(
            "{name} is not accepted: {} changed since it was shown; review it again",
            what.join(" and ")
        )
    };
    by_name.into_iter().map(sentence).collect()
}
