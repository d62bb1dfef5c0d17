//! `propose`: what blessing would write, of which nothing is written.

use std::collections::BTreeMap;

use rayon::prelude::*;

use super::{Action, Step};
use crate::blame::blame;
use crate::golden;
use crate::hash::content_hash;
use crate::judge::{Found, broken_expectations, keeps};
use crate::metric::Comparison;
use crate::report;
use crate::run::{Judged, judge_fixture, read_golden};
use crate::steady;
use crate::suite::{Selection, Suite};
use crate::verdict::Verdict;

/// What is proposed, by the name of the fixture or golden.
pub type Proposals = BTreeMap<String, Proposal>;

/// What is proposed for a fixture or golden.
#[derive(Debug, Clone, PartialEq)]
pub enum Proposal {
    /// It is a match: nothing.
    Untouched,
    /// A golden without a fixture stays, as removing was not asked for.
    LeftOrphan,
    /// Not accepted, and why.
    Refused(Vec<String>),
    /// Its golden is written or removed.
    Change(Box<Change>),
}

/// A golden to be written or removed.
#[derive(Debug, Clone, PartialEq)]
pub struct Change {
    /// What a plan says of it.
    pub step: Step,
    /// What is said of the golden that there is.
    pub verdict: Verdict,
    /// From that golden to today's picture; `None` if they cannot be compared.
    pub distance: Option<Comparison>,
    /// The file to write; `None` to remove the one there is.
    pub png: Option<Vec<u8>>,
}

/// Renders the selected fixtures and proposes the pictures that are not a
/// match, and to remove selected goldens without a fixture if `prune`. A
/// picture is refused that breaks an expectation of its fixture, that is another
/// when it is rendered again, whose file would be larger than a golden may be or
/// whose golden nobody here has looked at ([`keeps`]), and so is a fixture with
/// problems.
/// `on_done` hears of each name, from any thread.
pub fn propose(
    suite: &Suite,
    selection: &Selection,
    prune: bool,
    on_done: &(dyn Fn(&str) + Sync),
) -> Proposals {
    let of_fixture = |name: &String| {
        let proposal = propose_fixture(suite, name).unwrap_or_else(Proposal::Refused);
        on_done(name);
        (name.clone(), proposal)
    };
    let mut proposals: Proposals = selection.fixtures.par_iter().map(of_fixture).collect();
    for name in &selection.orphans {
        let proposal = if prune { propose_removal(suite, name) } else { Proposal::LeftOrphan };
        on_done(name);
        proposals.insert(name.clone(), proposal);
    }
    proposals
}

fn propose_fixture(suite: &Suite, name: &str) -> Result<Proposal, Vec<String>> {
    let Judged { rendered, found, golden_hash, judgment, .. } = judge_fixture(suite, name);
    let (fixture, picture) = rendered.map_err(|why| vec![why])?;
    if judgment.breaks_expectations || !judgment.broken_relations.is_empty() {
        let mut broken = broken_expectations(&fixture, &picture);
        broken.extend(judgment.broken_relations);
        return Err(broken);
    }
    if judgment.verdict == Verdict::Match {
        return Ok(Proposal::Untouched);
    }
    if let Some(why) = keeps(&found) {
        return Err(vec![why]);
    }
    if let (Found::Unreadable(why), None) = (&found, &golden_hash) {
        return Err(vec![format!("what is in the golden's place {why}: remove it")]);
    }
    if let Some(why) = steady::difference(&picture, [fixture.render_again()]) {
        return Err(vec![why]);
    }
    let png = golden::smallest_png(&picture.encoded, &fixture.provenance).map_err(|e| vec![e])?;
    if let Some(problem) = fixture.check.file_size_problem(png.len()) {
        return Err(vec![problem]);
    }
    let distance = judgment.comparison;
    let blamed = found.picture().map(|golden| blame(&fixture, golden, &picture.encoded));
    let blamed = blamed.filter(|blamed| !blamed.is_empty());
    let step = Step {
        name: name.to_owned(),
        action: if golden_hash.is_some() { Action::Replace } else { Action::Add },
        verdict: judgment.verdict.id().to_owned(),
        before: golden_hash,
        after: Some(content_hash(&png)),
        scene: Some(fixture.provenance.scene),
        assets: Some(fixture.provenance.assets),
        distances: distance.as_ref().map(report::distances),
        blamed: blamed.as_deref().map(report::blamed),
    };
    let verdict = judgment.verdict;
    Ok(Proposal::Change(Box::new(Change { step, verdict, distance, png: Some(png) })))
}

fn propose_removal(suite: &Suite, name: &str) -> Proposal {
    let before = match read_golden(&suite.golden_path(name)) {
        Ok(Some(bytes)) => content_hash(bytes),
        Ok(None) => return Proposal::Refused(vec!["there is no such golden".to_owned()]),
        Err(error) => return Proposal::Refused(vec![error.to_string()]),
    };
    let verdict = Verdict::OrphanGolden;
    let step = Step {
        name: name.to_owned(),
        action: Action::Prune,
        verdict: verdict.id().to_owned(),
        before: Some(before),
        after: None,
        scene: None,
        assets: None,
        distances: None,
        blamed: None,
    };
    Proposal::Change(Box::new(Change { step, verdict, distance: None, png: None }))
}
