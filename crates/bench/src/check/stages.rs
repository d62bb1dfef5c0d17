//! The stages of a check, each timed on one thread for every fixture.

use std::cell::Cell;
use std::hint::black_box;
use std::path::Path;

use harness::fixture::{Build, Fixture, Skipping};
use harness::judge::{Found, judge};
use harness::store::{self, FolderAssets};
use harness::suite::Suite;
use harness::{golden, relation, report, run};
use scene::{Assets, MAX_SCENE_BYTES};

use super::{MILLISECONDS, Slow, Stage};
use crate::measure::{Spread, thread_seconds};

/// In the order of the way.
const STAGES: [&str; 10] = [
    "read scene and meshes",
    "parse, build",
    "plan",
    "render",
    "encode",
    "read golden",
    "decode golden",
    "compare",
    "related scenes",
    "report, empty artifacts",
];

/// Which of them is the one that is done once for all fixtures.
const WRITE: usize = STAGES.len() - 1;

/// How many of the slowest fixtures are named.
const NAMED: usize = 5;

/// The most bytes of a golden that are read.
const MAX_GOLDEN_BYTES: u64 = 256 << 20;

/// Seconds by stage.
type Times = [f64; STAGES.len()];

/// Every stage for all fixtures together, and the fixtures that take longest.
pub(super) fn measure(
    suite: &Suite,
    filters: &[String],
    rounds: usize,
) -> Result<(Vec<Stage>, Vec<Slow>), String> {
    let names = suite.select(filters).map_err(|error| error.to_string())?.fixtures;
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build();
    let pool = pool.map_err(|error| error.to_string())?;
    pool.install(|| {
        let mut by_round = Vec::new();
        let mut by_fixture = vec![Vec::new(); names.len()];
        // The first round, which reads everything into memory, is not counted.
        for round in 0..=rounds {
            let mut sum = Times::default();
            for (name, turns) in names.iter().zip(&mut by_fixture) {
                let times = one(suite, name)?;
                for (sum, time) in sum.iter_mut().zip(times) {
                    *sum += time;
                }
                if round > 0 {
                    turns.push(times);
                }
            }
            sum[WRITE] = around(suite)?;
            if round > 0 {
                by_round.push(sum);
            }
        }
        Ok((stages(&by_round), slowest(&names, &by_fixture)))
    })
}

fn stages(rounds: &[Times]) -> Vec<Stage> {
    let of = |stage: usize| {
        Spread::of(&rounds.iter().map(|times| times[stage] * MILLISECONDS).collect::<Vec<_>>())
    };
    let all: f64 = (0..STAGES.len()).map(|stage| of(stage).median).sum();
    let stage = |(k, name): (usize, &&str)| Stage {
        name: (*name).to_owned(),
        ms: of(k),
        share: of(k).median / all,
    };
    STAGES.iter().enumerate().map(stage).collect()
}

fn slowest(names: &[String], by_fixture: &[Vec<Times>]) -> Vec<Slow> {
    let slow = |(name, rounds): (&String, &Vec<Times>)| {
        let median = |value: &dyn Fn(&Times) -> f64| {
            Spread::of(&rounds.iter().map(value).collect::<Vec<_>>()).median
        };
        let stages = (0..STAGES.len()).map(|k| (k, median(&|times| times[k])));
        let most = stages.max_by(|a, b| a.1.total_cmp(&b.1)).map_or(0, |(k, _)| k);
        Slow {
            fixture: name.clone(),
            ms: median(&|times| times.iter().sum()) * MILLISECONDS,
            stage: STAGES[most].to_owned(),
        }
    };
    let mut all: Vec<_> = names.iter().zip(by_fixture).map(slow).collect();
    all.sort_by(|a, b| b.ms.total_cmp(&a.ms));
    all.truncate(NAMED);
    all
}

/// Seconds that something takes.
fn timed<T>(work: impl FnOnce() -> T) -> (T, f64) {
    let begin = thread_seconds();
    let done = work();
    (done, thread_seconds() - begin)
}

/// The same steps as `harness::run` takes for one fixture.
fn one(suite: &Suite, name: &str) -> Result<Times, String> {
    let path = suite.fixture_path(name);
    let (text, read) = timed(|| text(&path));
    let assets = Timed { inner: FolderAssets::beside(&path), seconds: Cell::new(0.0) };
    let (fixture, parse) = timed(|| Fixture::read(name, &text?, &assets, Build::default()));
    let (fixture, assets) = (fixture?, assets.seconds.get());
    let (made, plan) = timed(|| fixture.plan(Skipping::On));
    black_box(made);
    let (linear, render) = timed(|| fixture.render_linear());
    let (rendered, encode) = timed(|| fixture.encoded(linear));
    let rendered = rendered.map_err(|why| format!("{name}: {why}"))?;
    let (png, read_golden) = timed(|| store::read(&suite.golden_path(name), MAX_GOLDEN_BYTES));
    let png = png.map_err(|error| error.to_string())?;
    let (found, decode) = timed(|| match png {
        None => Found::Nothing,
        Some(bytes) => match golden::from_png(&bytes) {
            Ok(golden) => Found::Golden(golden),
            Err(why) => Found::Unreadable(why),
        },
    });
    let (judgment, compare) = timed(|| judge(&fixture, &rendered, &found));
    black_box(judgment);
    let (broken, relate) = timed(|| relation::broken(&fixture, &rendered));
    black_box(broken);
    // Rendering made the plan once more.
    let render = (render - plan).max(0.0);
    let (read, parse) = (read + assets, parse - assets);
    Ok([read, parse, plan, render, encode, read_golden, decode, compare, relate, 0.0])
}

fn text(path: &Path) -> Result<String, String> {
    let bytes = store::read(path, MAX_SCENE_BYTES as u64).map_err(|error| error.to_string())?;
    let text = String::from_utf8(bytes.unwrap_or_default());
    text.map_err(|_| format!("{}: expected UTF-8 text", path.display()))
}

/// What a run does besides its fixtures: empties the folder of artifacts, and
/// says what it found.
fn around(suite: &Suite) -> Result<f64, String> {
    let nothing = harness::suite::Selection { fixtures: Vec::new(), orphans: Vec::new() };
    let (done, seconds) = timed(|| {
        run::run(suite, &nothing, &|_| {}).map(|outcomes| report::run_json(&outcomes, 0.0))
    });
    black_box(done.map_err(|error| error.to_string())?);
    Ok(seconds)
}

/// Passes files on, and knows how long reading them took.
struct Timed {
    inner: FolderAssets,
    seconds: Cell<f64>,
}

impl Assets for Timed {
    fn read(&self, path: &str) -> Result<Vec<u8>, String> {
        let (bytes, seconds) = timed(|| self.inner.read(path));
        self.seconds.set(self.seconds.get() + seconds);
        bytes
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_stage_of_a_fixture_has_a_time() {
        let folder = tempfile::tempdir().unwrap();
        let scene = crate::inputs::scene_text((24, 18), 2);
        let scene = scene.trim_end().trim_end_matches(')');
        let scene = format!("{scene}check: (relations: [Exposure(by: 2)]))");
        let path = folder.path().join("fixtures/a.ron");
        crate::place::write(&path, &scene).unwrap();
        let suite = Suite::open(folder.path()).unwrap();
        let (fixture, picture) = run::render_fixture(&suite, "a").unwrap();
        let png = golden::to_png(&picture.encoded, Some(&fixture.provenance)).unwrap();
        store::write(&suite.golden_path("a"), &png).unwrap();
        let (stages, slowest) = measure(&suite, &[], 3).unwrap();
        assert!(stages.iter().all(|stage| stage.ms.median > 0.0), "{stages:?}");
        assert!((stages.iter().map(|stage| stage.share).sum::<f64>() - 1.0).abs() < 1e-9);
        assert_eq!(slowest.len(), 1);
        // Both make one picture.
        let renders = ["render", "related scenes"].contains(&slowest[0].stage.as_str());
        assert!(slowest[0].fixture == "a" && renders, "{slowest:?}");
    }
}
