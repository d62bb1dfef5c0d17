//! One scene given to a renderer, and what came of it.

use std::collections::BTreeSet;
use std::path::PathBuf;
use std::time::Duration;

use harness::fixture::Fixture;
use harness::picture_file::Stored;
use harness::store::{self, Scratch, StoreError};
use interchange::Feature;
use interchange::export::{Dialect, Exported, NotWritten, export};
use scene::format::Shading;
use tracer::{Size, edges};

use super::artifacts::{Kept, keep, write_strip};
use super::{Plan, Renderer, Subject};
use crate::adapter::Adapter;
use crate::judge::{Allowance, Judged, Levels, Reference, hint, judge};
use crate::process::{Bounds, Ended, Ran, run};
use crate::{Evidence, FixtureResult, Numbers, Objects, Outcome as Said, Seen};

/// The most that a renderer may write into its folder, in bytes.
pub(super) const MAX_WRITTEN: u64 = 2 << 30;

/// The largest picture file that is read, in bytes.
const MAX_PICTURE: u64 = 1 << 30;

/// The most of a picture that is kept for somebody to look at, in bytes.
const MAX_KEPT: usize = 64 << 20;

/// What came of a scene.
pub(super) struct Outcome {
    pub(super) result: FixtureResult,
    pub(super) evidence: Option<Evidence>,
    pub(super) left: Left,
}

/// What a failure has left, and shows.
#[derive(Debug, Clone, Default)]
pub(super) struct Left {
    pub(super) by_hand: Option<String>,
    pub(super) strip: Option<PathBuf>,
    pub(super) worst_on: Option<Seen>,
}

/// What is said of a run: an outcome, why, and the comparison if there is one.
struct Verdict {
    outcome: Said,
    findings: Vec<String>,
    judged: Option<(Judged, Evidence)>,
}

impl Verdict {
    fn because(outcome: Said, why: impl Into<String>) -> Self {
        Self { outcome, findings: vec![why.into()], judged: None }
    }
}

/// Gives a scene to a renderer and judges its picture; `None` where it was time to
/// end.
///
/// # Errors
/// Files that cannot be written, and a program that cannot be started.
pub(super) fn render_and_judge(
    renderer: &Renderer,
    subject: &Subject,
    plan: &Plan<'_>,
) -> Result<Option<Outcome>, StoreError> {
    let result = |verdict: &Verdict, elapsed: Duration| FixtureResult {
        features: subject.features.clone(),
        outcome: verdict.outcome,
        findings: verdict.findings.clone(),
        numbers: verdict.judged.as_ref().map(|(judged, _)| judged.numbers),
        elapsed_ms: elapsed.as_secs_f64() * 1e3,
    };
    let exported = match exported(&renderer.adapter, &subject.fixture, &subject.features) {
        Ok(exported) => exported,
        Err(findings) => {
            let verdict = Verdict { outcome: Said::Unsupported, findings, judged: None };
            let result = result(&verdict, Duration::ZERO);
            return Ok(Some(Outcome { result, evidence: None, left: Left::default() }));
        }
    };
    let scratch = Scratch::new()?;
    for (name, bytes) in &exported.files {
        store::write(&scratch.path(name), bytes)?;
    }
    let words = words(renderer, subject, &exported);
    let mut command = renderer.command(&words, scratch.folder());
    let time = plan.timeout.unwrap_or(renderer.adapter.timeout);
    let growth = Some((scratch.folder(), MAX_WRITTEN));
    let ran = run(&mut command, &Bounds { time, growth, stop: plan.stop });
    let ran = ran.map_err(|error| StoreError {
        path: words.first().map(Into::into).unwrap_or_default(),
        what: format!("cannot be run: {error}"),
    })?;
    if ran.ended == Ended::Stopped {
        return Ok(None);
    }
    let output = &renderer.adapter.output;
    let picture = match store::read(&scratch.path(output), MAX_PICTURE) {
        // Files of the scene are none of the renderer's.
        Ok(_) if exported.files.contains_key(output) => Ok(None),
        Ok(bytes) => Ok(bytes),
        Err(error) => Err(error.what),
    };
    let verdict = verdict(renderer, (subject, exported.grid), (&ran, time), picture.as_ref());
    let result = result(&verdict, ran.elapsed);
    let mut left = Left::default();
    if verdict.outcome != Said::Pass {
        let output = picture.as_ref().ok().and_then(Option::as_deref);
        let output = output.filter(|bytes| bytes.len() <= MAX_KEPT);
        let output = output.map(|bytes| (renderer.adapter.output.as_str(), bytes));
        let said = printed(&ran);
        let env = &renderer.adapter.env;
        let kept = Kept { files: &exported.files, output, said: &said, words: &words, env };
        left.by_hand = Some(keep(plan.folder, &subject.name, &kept)?);
        if let Some((judged, evidence)) = &verdict.judged {
            left.strip = Some(write_strip(plan.folder, subject, evidence)?);
            left.worst_on = worst_on(&judged.numbers, subject);
        }
    }
    let evidence = verdict.judged.map(|(_, evidence)| evidence);
    Ok(Some(Outcome { result, evidence, left }))
}

/// What the worst of the interior pixels shows that are off, if any is.
fn worst_on(numbers: &Numbers, subject: &Subject) -> Option<Seen> {
    let (x, y) = numbers.worst_at.filter(|_| numbers.interior_off > 0)?;
    let width = subject.fixture.scene.size().width;
    Objects::of(&subject.fixture).at(y as usize * width as usize + x as usize)
}

/// Why a renderer by this adapter would not be asked for a fixture's picture, as it asks
/// for these features; empty if it would be.
pub fn ruled_out(
    adapter: &Adapter,
    fixture: &Fixture,
    features: &BTreeSet<Feature>,
) -> Vec<String> {
    exported(adapter, fixture, features).err().unwrap_or_default()
}

/// The scene in the renderer's language.
///
/// # Errors
/// Why it is not asked.
fn exported(
    adapter: &Adapter,
    fixture: &Fixture,
    features: &BTreeSet<Feature>,
) -> Result<Exported, Vec<String>> {
    const SAMPLES: [Feature; 4] = [
        Feature::GridSamples,
        Feature::ScatteredSamples,
        Feature::PixelFilter,
        Feature::AdaptiveSamples,
    ];
    let declared = features.iter().filter_map(|feature| {
        let reason = adapter.unsupported.get(feature)?;
        let reason = if reason.is_empty() { String::new() } else { format!(": {reason}") };
        Some(format!("its adapter says that it has no {feature}{reason}"))
    });
    let mut findings: Vec<String> = declared.collect();
    let is_own = matches!(adapter.scene, Dialect::Ron | Dialect::Json);
    if is_own && !adapter.same_samples {
        let samples = features.iter().filter(|feature| SAMPLES.contains(feature));
        findings.extend(samples.map(|feature| {
            format!("{feature}: its adapter does not say that it takes the same samples")
        }));
    }
    if !findings.is_empty() {
        return Err(findings);
    }
    let dialect = adapter.scene;
    match export(dialect, &fixture.scene_file(), fixture.assets()) {
        Ok(exported) => Ok(exported),
        Err(NotWritten::Cannot(features)) => {
            let names: Vec<_> = features.iter().map(|feature| feature.name()).collect();
            Err(vec![format!("{dialect:?} has no words for {}", names.join(", "))])
        }
        Err(NotWritten::Bad(why)) => Err(vec![format!("not written as {dialect:?}: {why}")]),
    }
}

/// The program and its arguments for a scene.
fn words(renderer: &Renderer, subject: &Subject, exported: &Exported) -> Vec<String> {
    let size = subject.fixture.scene.size();
    let filling = crate::adapter::Filling {
        scene: exported.main.clone(),
        output: renderer.adapter.output.clone(),
        width: size.width * exported.grid,
        height: size.height * exported.grid,
        samples: subject.fixture.scene.samples().samples_per_pixel(),
        shading: match subject.fixture.scene_file().shading {
            Shading::Classic => "classic",
            Shading::Attenuated => "attenuated",
            Shading::Radiometric => "radiometric",
        },
        ..renderer.filling.clone()
    };
    renderer.placed(renderer.adapter.command.iter().map(|word| word.filled(&filling)).collect())
}

/// What is said of a run.
fn verdict(
    renderer: &Renderer,
    (subject, grid): (&Subject, u32),
    (ran, time): (&Ran, Duration),
    picture: Result<&Option<Vec<u8>>, &String>,
) -> Verdict {
    let status = match ran.ended {
        Ended::Alone(status) if status.success() => None,
        Ended::Alone(status) => Some((Said::Crashed, format!("it ended by {status}"))),
        Ended::OutOfTime => {
            let why = format!("it was killed after {} s", time.as_secs_f64());
            Some((Said::TimedOut, why))
        }
        Ended::TooMuch | Ended::Stopped => {
            let why = format!("it was killed as it wrote more than {MAX_WRITTEN} bytes");
            Some((Said::BadPicture, why))
        }
    };
    if let Some((outcome, why)) = status {
        return Verdict::because(outcome, format!("{why}{}", last_words(ran)));
    }
    let output = &renderer.adapter.output;
    let stored = match picture {
        Ok(None) => {
            let why = format!("it ended well, but there is no {output}{}", last_words(ran));
            return Verdict::because(Said::NoPicture, why);
        }
        Ok(Some(bytes)) => Stored::read(bytes),
        Err(why) => Err(why.clone()),
    };
    let meaning = renderer.adapter.meaning;
    let bad = |why: String| Verdict::because(Said::BadPicture, format!("{output}: {why}"));
    let stored = match stored {
        Ok(stored) => stored,
        Err(why) => return bad(why),
    };
    let Size { width, height } = subject.fixture.scene.size();
    let expected = Size { width: width * grid, height: height * grid };
    let found = stored.size();
    if expected != found {
        let why = format!(
            "expected {} x {} pixels, found {} x {}",
            expected.width, expected.height, found.width, found.height
        );
        return Verdict::because(Said::WrongSize, why);
    }
    let levels = match Levels::of(&stored, meaning) {
        Ok(levels) => levels.gathered(grid),
        Err(why) => return bad(why),
    };
    let around = edges(&subject.fixture.scene, renderer.adapter.edge_reach);
    let (fixture, rendered) = (&subject.fixture, &subject.rendered);
    let reference = Reference { fixture, rendered, around: &around };
    let allowance = Allowance::of(&renderer.adapter);
    let judged = judge(&reference, &levels, allowance);
    let mut findings = judged.findings.clone();
    if !findings.is_empty() {
        findings.extend(hint(&reference, (&stored, grid), meaning, (allowance, &judged)));
    }
    let [low, high] = levels.bounds();
    let evidence = Evidence {
        reference: rendered.linear.clone(),
        actual: levels.nominal().clone(),
        low,
        high,
        edges: around.iter().map(Option::is_some).collect(),
        off: judged.off.clone(),
    };
    let outcome = if findings.is_empty() { Said::Pass } else { Said::Fail };
    Verdict { outcome, findings, judged: Some((judged, evidence)) }
}

/// The last line that it printed as an error, else the last one, as the end of a
/// sentence.
fn last_words(ran: &Ran) -> String {
    const MOST: usize = 200;
    let last = |text: String| {
        let line = text.lines().rev().map(str::trim).find(|line| !line.is_empty())?;
        Some(scene::visible(line).chars().take(MOST).collect::<String>())
    };
    let said = last(ran.stderr.text()).or_else(|| last(ran.stdout.text()));
    said.map_or(String::new(), |said| format!("; it said: {said}"))
}

/// All that was kept of what it printed.
fn printed(ran: &Ran) -> String {
    let parts = [("standard output", &ran.stdout), ("standard error", &ran.stderr)];
    let parts = parts.into_iter().filter(|(_, heard)| heard.bytes() > 0);
    let parts = parts.map(|(name, heard)| format!("== {name}\n{}\n", heard.text()));
    parts.collect::<Vec<_>>().concat()
}
