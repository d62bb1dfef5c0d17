//! `run`: a suite rendered by another renderer, and judged.
//!
//! Renderers run one at a time unless told otherwise, each scene in a fresh folder.
//! Whatever a renderer does is a result; an error is only what goldray itself could
//! not do.

mod artifacts;
mod ask;
mod one;
mod subject;

pub use ask::{CannotAsk, Renderer};
pub use one::ruled_out;
pub use subject::{NotItself, Subject, subjects};

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Duration;

use harness::store::{self, StoreError};

use crate::process::Stop;
use crate::{Conformed, Evidence, FixtureResult, Run, Seen};

/// How a renderer is asked for the pictures of a suite.
#[derive(Clone, Copy)]
pub struct Plan<'a> {
    /// How many scenes are rendered at a time.
    pub jobs: usize,
    /// How long a picture may take, in place of what the adapter says.
    pub timeout: Option<Duration>,
    /// Where the results and what failures leave behind are put: a folder that is
    /// this run's alone, and is emptied first.
    pub folder: &'a Path,
    /// Whether it is time to end.
    pub stop: Stop<'a>,
}

/// What came of a fixture, as it is told while others are still rendered.
#[derive(Debug, Clone)]
pub struct Told<'a> {
    /// Its name.
    pub name: &'a str,
    /// What came of it.
    pub result: &'a FixtureResult,
    /// How the renderer is asked again by hand; `None` where nothing was kept.
    pub by_hand: Option<String>,
    /// Where the strip of a picture that fails is: reference, difference, actual.
    pub strip: Option<PathBuf>,
    /// What the worst interior pixel shows, where one is off.
    pub worst_on: Option<Seen>,
}

/// The name of the record in the folder of a run.
pub const RESULTS: &str = "results.json";

/// Asks a renderer for the pictures of these fixtures, and judges them; `None` where
/// it was time to end before it was done. `told` hears of each fixture as it is
/// known, from any thread.
///
/// # Errors
/// Files that cannot be written, and a program that cannot be started.
pub fn run(
    renderer: &Renderer,
    subjects: &[Subject],
    plan: &Plan<'_>,
    told: &(dyn Fn(&Told<'_>) + Sync),
) -> Result<Option<Conformed>, StoreError> {
    let next = AtomicUsize::new(0);
    let done: Mutex<Vec<_>> = Mutex::default();
    let is_over = || (plan.stop)(Duration::ZERO);
    let work = || {
        while !is_over() {
            let Some(subject) = subjects.get(next.fetch_add(1, Ordering::Relaxed)) else { return };
            let one = one::render_and_judge(renderer, subject, plan);
            let has_failed = one.is_err();
            if let Ok(Some(one::Outcome { result, left, .. })) = &one {
                let one::Left { by_hand, strip, worst_on } = left.clone();
                told(&Told { name: &subject.name, result, by_hand, strip, worst_on });
            }
            let mut done = done.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
            done.push((subject.name.clone(), one));
            if has_failed {
                // Nobody begins another one.
                next.store(subjects.len(), Ordering::Relaxed);
            }
        }
    };
    std::thread::scope(|scope| {
        for _ in 1..plan.jobs.clamp(1, subjects.len().max(1)) {
            scope.spawn(work);
        }
        work();
    });
    let done = done.into_inner().unwrap_or_else(std::sync::PoisonError::into_inner);
    let mut fixtures = BTreeMap::new();
    let mut evidence: BTreeMap<String, Evidence> = BTreeMap::new();
    for (name, one) in done {
        let Some(one) = one? else { return Ok(None) };
        evidence.extend(one.evidence.map(|found| (name.clone(), found)));
        fixtures.insert(name, one.result);
    }
    if fixtures.len() < subjects.len() {
        return Ok(None);
    }
    let adapter = &renderer.adapter;
    let run = Run {
        schema: Run::SCHEMA,
        renderer: renderer.info.clone(),
        tolerance: adapter.tolerance,
        edge_reach: adapter.edge_reach,
        fixtures,
    };
    let path = plan.folder.join(RESULTS);
    let text = serde_json::to_string_pretty(&run)
        .map_err(|error| StoreError { path: path.clone(), what: error.to_string() })?;
    store::write(&path, format!("{text}\n").as_bytes())?;
    Ok(Some(Conformed { run, evidence }))
}
