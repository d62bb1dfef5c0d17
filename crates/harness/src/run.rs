//! `run`: every selected fixture rendered and judged, in parallel.

use std::path::Path;
use std::time::Instant;

use rayon::prelude::*;
use tracer::accel::Build;

use crate::blame::blame;
use crate::evidence::Evidence;
use crate::expectation::Rendered;
use crate::fixture::Fixture;
use crate::golden;
use crate::hash::content_hash;
use crate::judge::{Found, Judgment, judge, keeps};
use crate::metric::Comparison;
use crate::picture::strip;
use crate::place;
use crate::record::Record;
use crate::relation;
use crate::store::{self, StoreError};
use crate::suite::{Selection, Suite};
use crate::verdict::{Outcome, Verdict};

/// The largest golden file that is read, in bytes.
const MAX_GOLDEN_BYTES: u64 = 256 << 20;

/// Judges everything selected; `on_outcome` hears of each as it is known, from
/// any thread. Failures leave a picture strip in the artifacts folder, which
/// is emptied first.
///
/// The outcomes are in the order of names, whatever the number of threads.
///
/// # Errors
/// Artifacts that cannot be written. What is wrong with a fixture or a golden
/// is its verdict, not an error.
pub fn run(
    suite: &Suite,
    selection: &Selection,
    on_outcome: &(dyn Fn(&Outcome) + Sync),
) -> Result<Vec<Outcome>, StoreError> {
    run_by(suite, selection, &judge_fixture, on_outcome)
}

/// The same with another way to judge a fixture.
pub(crate) fn run_by(
    suite: &Suite,
    selection: &Selection,
    judge: &(dyn Fn(&Suite, &str) -> Judged + Sync),
    on_outcome: &(dyn Fn(&Outcome) + Sync),
) -> Result<Vec<Outcome>, StoreError> {
    store::empty_artifacts(&suite.artifacts())?;
    let judge_one = |name: &String| {
        let outcome = outcome(suite, name, judge(suite, name))?;
        on_outcome(&outcome);
        Ok(outcome)
    };
    let mut outcomes: Vec<_> =
        selection.fixtures.par_iter().map(judge_one).collect::<Result<_, StoreError>>()?;
    outcomes.extend(orphans(selection).into_iter().inspect(on_outcome));
    outcomes.sort_by(|a, b| a.name.cmp(&b.name));
    // What was just seen to be no match is not to be taken for one by the next
    // check; a record that cannot be changed is reported by who reads it.
    let _ = Record::forget(suite, &outcomes);
    Ok(outcomes)
}

/// A fixture rendered and judged, with all that led to it.
#[derive(Debug, Clone)]
pub struct Judged {
    /// The fixture and its picture, or why there is none.
    pub rendered: Result<(Fixture, Rendered), String>,
    /// What is in the golden's place.
    pub found: Found,
    /// The hash of the golden's file; `None` where none can be read.
    pub golden_hash: Option<String>,
    /// What is said.
    pub judgment: Judgment,
    /// How long reading and rendering took, in milliseconds.
    pub render_ms: f64,
    /// How long reading the golden and comparing took, in milliseconds.
    pub compare_ms: f64,
    /// How long related scenes took, in milliseconds.
    pub relate_ms: f64,
}

/// Renders a fixture and judges it; writes nothing.
pub fn judge_fixture(suite: &Suite, name: &str) -> Judged {
    let started = Instant::now();
    let rendered = render_fixture(suite, name);
    let render_ms = milliseconds_since(started);
    let started = Instant::now();
    let file = read_golden(&suite.golden_path(name));
    let golden_hash = file.as_ref().ok().and_then(Option::as_ref).map(content_hash);
    let found = Found::in_file(file);
    let judgment = match &rendered {
        Ok((fixture, picture)) => judge(fixture, picture, &found),
        Err(why) => Judgment {
            verdict: Verdict::RenderRefused,
            findings: vec![why.clone()],
            breaks_expectations: false,
            broken_relations: Vec::new(),
            comparison: None,
        },
    };
    let compare_ms = milliseconds_since(started);
    let started = Instant::now();
    let broken = rendered.as_ref().map(|(fixture, picture)| relation::broken(fixture, picture));
    let judgment = judgment.with_relations(broken.unwrap_or_default());
    let relate_ms = milliseconds_since(started);
    Judged { rendered, found, golden_hash, judgment, render_ms, compare_ms, relate_ms }
}

/// The fixture and its picture.
///
/// # Errors
/// Why there is no picture, as text for people.
pub fn render_fixture(suite: &Suite, name: &str) -> Result<(Fixture, Rendered), String> {
    let label = Suite::fixture_label(name);
    let fixture = Fixture::open(&label, &suite.fixture_path(name), Build::default())?;
    let picture = fixture.render().map_err(|why| format!("{label}: {why}\n"))?;
    Ok((fixture, picture))
}

/// What is at the path of a golden.
pub fn find_golden(path: &Path) -> Found {
    Found::in_file(read_golden(path))
}

/// The bytes at the path of a golden; `None` where there is no file.
///
/// # Errors
/// A file that cannot be read.
pub(crate) fn read_golden(path: &Path) -> Result<Option<Vec<u8>>, StoreError> {
    store::read(path, MAX_GOLDEN_BYTES)
}

/// What is said of a fixture, after a failure has left its strip.
pub(crate) fn outcome(suite: &Suite, name: &str, judged: Judged) -> Result<Outcome, StoreError> {
    let Judged { rendered, found, judgment, render_ms, compare_ms, relate_ms, .. } = judged;
    let blamed = match (&rendered, found.picture()) {
        (Ok((fixture, picture)), Some(golden)) if judgment.verdict != Verdict::Match => {
            blame(fixture, golden, &picture.encoded)
        }
        _ => Vec::new(),
    };
    let place = match judgment.verdict {
        Verdict::Match => None,
        _ => place::of_failure(name, &rendered, &judgment, &blamed),
    };
    let is_golden = judgment.verdict == Verdict::Match
        && judgment.comparison.as_ref().is_some_and(Comparison::is_identical);
    let evidence = match &rendered {
        Ok((fixture, picture)) if !is_golden => {
            let evidence = Evidence::of(fixture, picture, found.picture());
            let path = suite.fixture_path(name);
            Some(Box::new(evidence.map_err(|what| StoreError { path, what })?))
        }
        _ => None,
    };
    let picture = rendered.ok().map(|(_, picture)| picture.encoded);
    let mut outcome = Outcome {
        findings: judgment.findings,
        breaks_expectations: judgment.breaks_expectations,
        breaks_relations: !judgment.broken_relations.is_empty(),
        keeps_golden: keeps(&found).is_some(),
        comparison: judgment.comparison,
        blamed,
        place,
        evidence,
        size: picture.as_ref().map(|p| (p.size().width, p.size().height)),
        render_ms,
        compare_ms,
        relate_ms,
        ..Outcome::unrendered(name, judgment.verdict)
    };
    if let (Some(picture), false) = (picture, outcome.verdict == Verdict::Match) {
        let png = golden::to_png(&strip(found.picture(), &picture), None);
        let relative = format!("{}/{name}.png", Suite::ARTIFACTS);
        let path = suite.root().join(&relative);
        let png = png.map_err(|what| StoreError { path: path.clone(), what })?;
        store::write(&path, &png)?;
        outcome.strip = Some(relative);
    }
    Ok(outcome)
}

/// What is said of goldens without a fixture.
pub(crate) fn orphans(selection: &Selection) -> Vec<Outcome> {
    let orphan = |name: &String| Outcome {
        findings: vec![format!("there is no {}", Suite::fixture_label(name))],
        ..Outcome::unrendered(name, Verdict::OrphanGolden)
    };
    selection.orphans.iter().map(orphan).collect()
}

fn milliseconds_since(started: Instant) -> f64 {
    started.elapsed().as_secs_f64() * 1e3
}
