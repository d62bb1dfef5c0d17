//! `recheck`: every selected fixture judged, of which those are not rendered
//! again that nothing changed for since they were last a match.
//!
//! The record of matches is not believed blindly: of what could be skipped, a
//! few fixtures, others each time, are rendered all the same. If one of them is
//! no match, the record is worth nothing: it is removed, and everything is
//! rendered.

use std::collections::{BTreeMap, BTreeSet};

use rayon::prelude::*;

use crate::record::{Inputs, Record};
use crate::run::{self, Judged, judge_fixture};
use crate::store::{self, StoreError};
use crate::suite::{Selection, Suite};
use crate::verdict::{Origin, Outcome, Verdict};

/// Of so many fixtures that could be skipped one is rendered all the same, and
/// one at least: 3 % of the time, and a wrong entry outlives a hundred checks
/// in one case of twenty.
pub const AUDIT_ONE_IN: usize = 33;

/// What was judged, and whether it is remembered.
#[derive(Debug)]
pub struct Rechecked {
    /// What is said of each fixture, in the order of names.
    pub outcomes: Vec<Outcome>,
    /// Why the record of matches could not be written, or removed where it was
    /// wrong. No outcome follows from that.
    pub unkept: Option<StoreError>,
}

/// Judges everything selected as [`run::run`] does, without rendering again
/// what is unchanged since it was last a match. `seed` decides which of those
/// are rendered as an audit, and nothing else. A record that cannot be kept
/// costs the time of another check, never a verdict.
///
/// # Errors
/// Artifacts that cannot be written, and a program that cannot be read.
pub fn recheck(
    suite: &Suite,
    selection: &Selection,
    seed: u64,
    on_outcome: &(dyn Fn(&Outcome) + Sync),
) -> Result<Rechecked, StoreError> {
    store::empty_artifacts(&suite.artifacts())?;
    let record = Record::read(suite)?;
    let is_unchanged = |name: &&String| record.holds(suite, name);
    let (unchanged, changed): (Vec<_>, Vec<_>) =
        selection.fixtures.par_iter().partition(is_unchanged);
    let audited = chosen(seed, &unchanged);

    let audit = |name: &&String| audit(suite, &record, name).inspect(|(o, _)| on_outcome(o));
    let mut judged: Vec<_> = audited.par_iter().map(audit).collect::<Result<_, _>>()?;
    let is_belied = judged.iter().any(|(outcome, _)| outcome.origin == Origin::Belied);
    let mut rest = changed;
    let mut skipped = Vec::new();
    for name in unchanged.into_iter().filter(|name| !audited.contains(name)) {
        if is_belied { rest.push(name) } else { skipped.push(name) }
    }
    let render = |name: &&String| render(suite, name).inspect(|(o, _)| on_outcome(o));
    judged.par_extend(rest.par_iter().map(render).collect::<Result<Vec<_>, _>>()?);

    let (mut outcomes, mut rendered) = (run::orphans(selection), BTreeMap::new());
    outcomes.extend(skipped.into_iter().map(|name| Outcome {
        origin: Origin::Unchanged,
        ..Outcome::unrendered(name, Verdict::Match)
    }));
    outcomes.iter().for_each(on_outcome);
    for (outcome, inputs) in judged {
        rendered.insert(outcome.name.clone(), inputs);
        outcomes.push(outcome);
    }
    let kept = if is_belied { Record::remove(suite) } else { record.store(suite, rendered) };
    outcomes.sort_by(|a, b| a.name.cmp(&b.name));
    Ok(Rechecked { outcomes, unkept: kept.err() })
}

/// What is rendered although it could be skipped.
fn chosen<'a>(seed: u64, unchanged: &[&'a String]) -> BTreeSet<&'a String> {
    let rank = |name: &str| {
        let mut hasher = blake3::Hasher::new();
        hasher.update(&seed.to_le_bytes()).update(name.as_bytes());
        *hasher.finalize().as_bytes()
    };
    let mut ranked: Vec<_> = unchanged.iter().map(|name| (rank(name), *name)).collect();
    ranked.sort_unstable();
    ranked.truncate(unchanged.len().div_ceil(AUDIT_ONE_IN));
    ranked.into_iter().map(|(_, name)| name).collect()
}

/// An outcome, and what it followed from if it is a match.
type Rendered = (Outcome, Option<Inputs>);

/// The hashes are of the very bytes that were judged, whatever has become of
/// the files by then.
fn render(suite: &Suite, name: &str) -> Result<Rendered, StoreError> {
    let judged = judge_fixture(suite, name);
    let inputs = inputs(&judged);
    let outcome = run::outcome(suite, name, judged)?;
    let inputs = inputs.filter(|_| outcome.verdict == Verdict::Match);
    Ok((outcome, inputs))
}

fn inputs(judged: &Judged) -> Option<Inputs> {
    let (fixture, _) = judged.rendered.as_ref().ok()?;
    Some(Inputs { sources: fixture.sources.clone(), golden: judged.golden_hash.clone()? })
}

fn audit(suite: &Suite, record: &Record, name: &str) -> Result<Rendered, StoreError> {
    let (mut outcome, inputs) = render(suite, name)?;
    // Where a file has changed since it was looked at, the record is not wrong.
    let is_belied = outcome.verdict != Verdict::Match && record.holds(suite, name);
    outcome.origin = if is_belied { Origin::Belied } else { Origin::Audited };
    if is_belied {
        let what = "the record of matches has these very files as a match of this very program";
        outcome.findings.push(what.to_owned());
    }
    Ok((outcome, inputs))
}
