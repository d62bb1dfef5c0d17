//! `check`: how many fixtures a second, and where the time goes.

mod stages;
mod throughput;

use std::fmt::Write as _;
use std::path::PathBuf;
use std::process::ExitCode;

use harness::run;
use harness::suite::Suite;
use harness::verdict::Verdict;
use serde::{Deserialize, Serialize};

use crate::bars::{self, Bar, short};
use crate::machine::Machine;
use crate::measure::{Spread, wall_and_processor};
use crate::place;

/// Milliseconds of a second.
const MILLISECONDS: f64 = 1e3;

/// Times that the suite is judged.
const ROUNDS: usize = 7;

/// Flags of `bench check`.
#[derive(Debug, clap::Args)]
pub(crate) struct Args {
    /// Which fixtures; all if none is given
    #[arg(value_name = "FILTER")]
    filters: Vec<String>,
    /// Also write the numbers as JSON
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
    /// Also draw where the time goes
    #[arg(long, value_name = "FILE")]
    svg: Option<PathBuf>,
}

/// The whole path, as `cargo xtask check` goes it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct Whole {
    /// How many fixtures are judged.
    pub(crate) fixtures: usize,
    /// How many are a match.
    pub(crate) matches: usize,
    /// Milliseconds of the wall's clock, on all threads.
    pub(crate) wall_ms: Spread,
    /// Milliseconds of the processor's, of all threads together.
    pub(crate) processor_ms: Spread,
}

/// One step on the way from a fixture to its verdict.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct Stage {
    pub(crate) name: String,
    /// Milliseconds for all fixtures together, on one thread.
    pub(crate) ms: Spread,
    /// Its share of all stages' medians.
    pub(crate) share: f64,
}

/// A fixture that takes long.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct Slow {
    pub(crate) fixture: String,
    /// Milliseconds of all its stages, on one thread.
    pub(crate) ms: f64,
    /// The stage that takes most of them.
    pub(crate) stage: String,
}

/// What works on pixels.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct Throughput {
    pub(crate) name: String,
    /// Millions of pixels a second, on one thread.
    pub(crate) mpix_s: Spread,
}

/// What is written for machines.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct Report {
    /// The version of this form.
    pub(crate) schema: u32,
    pub(crate) machine: Machine,
    pub(crate) whole: Whole,
    /// In the order of the way.
    pub(crate) stages: Vec<Stage>,
    /// The slowest first.
    pub(crate) slowest: Vec<Slow>,
    pub(crate) throughput: Vec<Throughput>,
}

impl Report {
    /// The fixtures judged in a second of the wall's clock.
    pub(crate) fn fixtures_a_second(&self) -> Spread {
        self.whole.wall_ms.rate(self.whole.fixtures as f64 * MILLISECONDS)
    }

    /// What to make faster next, from the figures.
    pub(crate) fn bottleneck(&self) -> String {
        let by_share = |a: &&Stage, b: &&Stage| a.share.total_cmp(&b.share);
        let Some(most) = self.stages.iter().max_by(by_share) else {
            return "nothing was measured".to_owned();
        };
        let without = 1.0 / (1.0 - most.share);
        let slowest = self.slowest.first().map_or_else(String::new, |slow| {
            let all: f64 = self.stages.iter().map(|stage| stage.ms.median).sum();
            format!(
                "; the slowest fixture, {}, is {:.0} % of all, most of it {}",
                slow.fixture,
                slow.ms / all * 100.0,
                slow.stage
            )
        });
        format!(
            "{}: {:.0} % of the processor's time, without which the suite would be {} times as \
             fast{slowest}",
            most.name,
            most.share * 100.0,
            short(without)
        )
    }
}

pub(crate) fn run(args: &Args) -> Result<ExitCode, String> {
    let root = place::repository()?;
    let suite = Suite::open(&root).map_err(|error| error.to_string())?;
    let machine = Machine::here();
    let whole = whole(&suite, &args.filters)?;
    let (stages, slowest) = stages::measure(&suite, &args.filters, ROUNDS)?;
    let report =
        Report { schema: 1, machine, whole, stages, slowest, throughput: throughput::measure()? };
    if let Some(path) = &args.json {
        place::write_json(path, &report)?;
    }
    if let Some(path) = &args.svg {
        place::write(path, &svg(&report))?;
    }
    print!("{}", text(&report));
    if report.whole.matches < report.whole.fixtures {
        println!("not all fixtures are a match: what is measured is not a usual check");
        return Ok(ExitCode::from(1));
    }
    Ok(ExitCode::SUCCESS)
}

/// The whole path on all threads, over and over.
fn whole(suite: &Suite, filters: &[String]) -> Result<Whole, String> {
    let selection = suite.select(filters).map_err(|error| error.to_string())?;
    let (mut walls, mut processors, mut matches) = (Vec::new(), Vec::new(), 0);
    // The first round, which reads everything into memory, is not counted.
    for round in 0..=ROUNDS {
        let (outcomes, wall, processor) =
            wall_and_processor(|| run::run(suite, &selection, &|_| {}));
        let outcomes = outcomes.map_err(|error| error.to_string())?;
        matches = outcomes.iter().filter(|outcome| outcome.verdict == Verdict::Match).count();
        if round > 0 {
            walls.push(wall * MILLISECONDS);
            processors.push(processor * MILLISECONDS);
        }
    }
    Ok(Whole {
        fixtures: selection.fixtures.len(),
        matches,
        wall_ms: Spread::of(&walls),
        processor_ms: Spread::of(&processors),
    })
}

fn text(report: &Report) -> String {
    let mut text = format!("{}\n\n", report.machine.sentence());
    let Whole { fixtures, matches, wall_ms, processor_ms } = &report.whole;
    let rate = report.fixtures_a_second();
    // Writing into a string does not fail.
    let _ = writeln!(
        text,
        "{fixtures} fixtures, {matches} match: {:.0} a second [{:.0}-{:.0}] by the wall's clock; \
         {:.0} ms of it and {:.0} ms of the processor's for all\n",
        rate.median, rate.low, rate.high, wall_ms.median, processor_ms.median
    );
    let _ = writeln!(text, "{:<28} {:>9} {:>7}  on one thread", "stage", "ms", "share");
    for Stage { name, ms, share } in &report.stages {
        let _ = writeln!(text, "{name:<28} {:>9.2} {:>5.1} %", ms.median, share * 100.0);
    }
    let _ = writeln!(text, "\n{:<28} {:>9}  mostly", "slowest fixtures", "ms");
    for Slow { fixture, ms, stage } in &report.slowest {
        let _ = writeln!(text, "{fixture:<28} {ms:>9.2}  {stage}");
    }
    let _ = writeln!(text, "\n{:<28} {:>9}", "pictures", "MPix/s");
    for Throughput { name, mpix_s } in &report.throughput {
        let Spread { median, low, high } = mpix_s;
        let _ = writeln!(text, "{name:<28} {median:>9.1} [{low:.1}-{high:.1}]");
    }
    let _ = writeln!(text, "\nnext bottleneck: {}", report.bottleneck());
    text
}

/// The stages as bars.
pub(crate) fn svg(report: &Report) -> String {
    let bar =
        |stage: &Stage| Bar { group: String::new(), name: stage.name.clone(), value: stage.ms };
    let bars: Vec<_> = report.stages.iter().map(bar).collect();
    let note = format!("{} fixtures, one thread", report.whole.fixtures);
    bars::svg("where the time of a check goes", &note, "ms", &bars)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn spread(median: f64) -> Spread {
        Spread { median, low: median, high: median }
    }

    #[test]
    fn the_bottleneck_is_the_largest_share() {
        let stage =
            |name: &str, share: f64| Stage { name: name.into(), ms: spread(share * 200.0), share };
        let report = Report {
            schema: 1,
            machine: Machine::here(),
            whole: Whole {
                fixtures: 50,
                matches: 50,
                wall_ms: spread(100.0),
                processor_ms: spread(200.0),
            },
            stages: vec![stage("parse", 0.2), stage("render", 0.75), stage("compare", 0.05)],
            slowest: vec![Slow { fixture: "a/b".into(), ms: 20.0, stage: "render".into() }],
            throughput: vec![Throughput { name: "ssim".into(), mpix_s: spread(9.0) }],
        };
        let said = report.bottleneck();
        assert!(said.starts_with("render: 75 %") && said.contains("4.00 times as"), "{said}");
        assert!(said.contains("a/b, is 10 % of all"), "{said}");
        assert_eq!(report.fixtures_a_second().median, 500.0);
        let (text, svg) = (text(&report), svg(&report));
        assert!(text.contains("500 a second") && text.contains("ssim"), "{text}");
        assert!(svg.contains("render") && svg.contains("150 ms"), "{svg}");
        let empty = Report { stages: vec![], slowest: vec![], ..report };
        assert_eq!(empty.bottleneck(), "nothing was measured");
    }
}
