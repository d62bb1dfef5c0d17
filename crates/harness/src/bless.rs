//! `bless`: accept pictures as goldens, only where they are not a match.

use rayon::prelude::*;

use crate::golden;
use crate::judge::{Found, broken_expectations};
use crate::metric::Comparison;
use crate::run::{Judged, judge_fixture};
use crate::store;
use crate::suite::{Selection, Suite};
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

/// Accepts the pictures of all selected fixtures that are not a match, and
/// removes selected goldens without a fixture if `prune`. Each golden is
/// written whole or not at all. `on_done` hears of each, from any thread.
///
/// A picture that breaks an expectation or a relation of its fixture is refused,
/// and so is a fixture with problems; the others are accepted all the same.
pub fn bless(
    suite: &Suite,
    selection: &Selection,
    prune: bool,
    on_done: &(dyn Fn(&str, &Blessed) + Sync),
) -> Vec<(String, Blessed)> {
    let fixtures = selection.fixtures.par_iter().map(|name| {
        let blessed = bless_fixture(suite, name);
        on_done(name, &blessed);
        (name.clone(), blessed)
    });
    let mut all: Vec<_> = fixtures.collect();
    for name in &selection.orphans {
        let blessed = match prune.then(|| store::remove(&suite.golden_path(name))) {
            None => Blessed::LeftOrphan,
            Some(Ok(())) => Blessed::Pruned,
            Some(Err(error)) => Blessed::Refused(vec![error.to_string()]),
        };
        on_done(name, &blessed);
        all.push((name.clone(), blessed));
    }
    all.sort_by(|a, b| a.0.cmp(&b.0));
    all
}

fn bless_fixture(suite: &Suite, name: &str) -> Blessed {
    let Judged { rendered, found, judgment, .. } = judge_fixture(suite, name);
    let (fixture, picture) = match rendered {
        Ok(rendered) => rendered,
        Err(why) => return Blessed::Refused(vec![why]),
    };
    if judgment.breaks_expectations || !judgment.broken_relations.is_empty() {
        let mut broken = broken_expectations(&fixture, &picture);
        broken.extend(judgment.broken_relations);
        return Blessed::Refused(broken);
    }
    if judgment.verdict == Verdict::Match {
        return Blessed::Untouched;
    }
    let written = golden::to_png(&picture.encoded, Some(&fixture.provenance)).and_then(|png| {
        store::write(&suite.golden_path(name), &png).map_err(|error| error.to_string())
    });
    match written {
        Err(why) => Blessed::Refused(vec![why]),
        Ok(()) if found == Found::Nothing => Blessed::Added,
        Ok(()) => Blessed::Replaced {
            verdict: judgment.verdict,
            distance: judgment.comparison.map(Box::new),
        },
    }
}
