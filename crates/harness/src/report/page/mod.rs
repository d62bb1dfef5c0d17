//! The page that shows a run: one HTML file that needs nothing else, and reaches
//! nothing.
//!
//! Its data is JSON in script elements. `id="report"` has the run as
//! [`run_json`](super::run_json) tells it, with more of each fixture (see
//! `fixture.rs`); one element for each fixture, `id="fixture-N"`, has its pictures
//! and is read only when they are looked at, so that thousands open at once.

mod assets;
mod fixture;
pub mod shell;

use std::collections::BTreeMap;

use rayon::prelude::*;
use serde_json::json;

use super::json::{metrics_json, summary_json};
use super::summary::summarize;
use super::text::Reader;
use super::worst::failures;
use crate::called;
use crate::suite::Suite;
use crate::verdict::{Outcome, Verdict};
use assets::{PAGE, SCRIPTS, STYLES};
use fixture::{Shown, shown};
use shell::{fill, put};

/// How the page is looked at.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// A file.
    Report,
    /// From a server that takes decisions.
    Review,
    /// The same, and it checks again what is edited.
    Watch,
}

impl Kind {
    fn id(self) -> &'static str {
        match self {
            Self::Report => "report",
            Self::Review => "review",
            Self::Watch => "watch",
        }
    }
}

/// The most bytes of compressed linear values in a page, 32 MiB: what is beyond
/// is left out, and the page then tells linear values from codes.
const MAX_LINEAR_BYTES: usize = 32 << 20;

/// The page of a run. Goldens and sources that the run has not kept are read
/// from the suite; what cannot be read is left out.
pub fn html(
    suite: &Suite,
    outcomes: &[Outcome],
    elapsed_ms: f64,
    kind: Kind,
    reader: &Reader,
) -> String {
    let mut left = MAX_LINEAR_BYTES;
    let has_linear: Vec<_> = outcomes
        .iter()
        .map(|outcome| {
            let linear = outcome.evidence.as_ref().and_then(|evidence| evidence.linear.as_ref());
            let bytes = linear.map_or(0, Vec::len);
            let fits = bytes <= left;
            left -= if fits { bytes } else { 0 };
            fits
        })
        .collect();
    let show = |(outcome, has_linear)| shown(suite, outcome, has_linear, reader);
    let mut all: Vec<Shown> = outcomes.par_iter().zip(has_linear).map(show).collect();
    rank(&mut all, outcomes);
    let verdict = |verdict: Verdict| json!({ "id": verdict.id(), "words": verdict.words() });
    let report = json!({
        "schema": 1,
        "kind": kind.id(),
        "called": called::command(),
        "root_flag": reader.root_flag,
        "summary": summary_json(outcomes, elapsed_ms),
        "metrics": metrics_json(),
        "verdicts": Verdict::ALL.map(verdict),
        "fixtures": all.iter().map(|shown| &shown.entry).collect::<Vec<_>>(),
    });
    let mut data = String::new();
    put(&mut data, "report", &report);
    for (number, shown) in all.iter().enumerate() {
        put(&mut data, &format!("fixture-{number}"), &shown.pictures);
    }
    fill(PAGE, &title(outcomes), STYLES, &data, SCRIPTS)
}

/// Says of each failure how many are worse.
fn rank(all: &mut [Shown], outcomes: &[Outcome]) {
    let ranks = failures(outcomes).into_iter().zip(0..);
    let ranks: BTreeMap<_, u32> = ranks.map(|(outcome, rank)| (&outcome.name, rank)).collect();
    for (shown, outcome) in all.iter_mut().zip(outcomes) {
        shown.entry["rank"] = json!(ranks.get(&outcome.name));
    }
}

fn title(outcomes: &[Outcome]) -> String {
    let summary = summarize(outcomes);
    let matches = summary.counts.get(&Verdict::Match).copied().unwrap_or(0);
    match summary.total - matches {
        0 => format!("goldray: {matches} match"),
        failures => format!("goldray: {failures} of {} do not match", summary.total),
    }
}

#[cfg(test)]
mod tests;
