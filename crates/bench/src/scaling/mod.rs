//! `scaling`: how times grow with primitives, pixels, lights and threads.

mod sweeps;

use std::fmt::Write as _;
use std::path::PathBuf;
use std::process::ExitCode;

use serde::{Deserialize, Serialize};

use crate::machine::Machine;
use crate::measure::Spread;
use crate::place;
use crate::plot::{self, Line, Panel, Plot};
use crate::slope::slope;

/// Flags of `bench scaling`.
#[derive(Debug, clap::Args)]
pub(crate) struct Args {
    /// Also write the numbers as JSON
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
    /// Also draw them
    #[arg(long, value_name = "FILE")]
    svg: Option<PathBuf>,
    /// Leave out the largest two sizes of each sweep
    #[arg(long)]
    short: bool,
    /// Only the smallest two sizes of each: seconds, enough to see that all of it works
    #[arg(long, conflicts_with = "short")]
    quick: bool,
}

/// Times of one thing at several sizes.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct Sweep {
    /// What grows, such as `triangles`.
    pub(crate) over: String,
    /// What is timed, such as `closest hit`.
    pub(crate) name: String,
    /// The unit of the times.
    pub(crate) unit: String,
    /// In rising order.
    pub(crate) points: Vec<Point>,
    /// The exponent of the growth, by least squares over all points.
    pub(crate) slope: Option<f64>,
}

/// The time at one size.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub(crate) struct Point {
    /// How many there were.
    pub(crate) size: f64,
    /// In the sweep's unit.
    pub(crate) time: Spread,
}

/// One picture with one thread and with several.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct Threads {
    /// How many there are.
    pub(crate) count: usize,
    /// Seconds of the wall's clock of one picture.
    pub(crate) wall: Spread,
    /// Seconds of the processor's, of all threads together.
    pub(crate) processor: Spread,
    /// How many times sooner than with one thread: the wall's clocks of one
    /// round, divided. Other programs take from it what they use.
    pub(crate) speedup: Spread,
    /// How many times the processor's time of one thread the same round took:
    /// what sharing the work costs, which other programs hardly change.
    pub(crate) overhead: Spread,
}

/// What is written for machines.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct Report {
    /// The version of this form.
    pub(crate) schema: u32,
    pub(crate) machine: Machine,
    /// By what grows.
    pub(crate) sweeps: Vec<Sweep>,
    /// By their number.
    pub(crate) threads: Vec<Threads>,
}

impl Sweep {
    fn new(over: &str, name: &str, unit: &str, points: Vec<Point>) -> Self {
        let logs: Vec<_> = points.iter().map(|p| (p.size, p.time.median)).collect();
        let [over, name, unit] = [over, name, unit].map(str::to_owned);
        Self { over, name, unit, points, slope: slope(&logs) }
    }

    /// Its slope for people.
    pub(crate) fn slope_text(&self) -> String {
        self.slope.map_or("-".to_owned(), |slope| format!("{slope:.2}"))
    }
}

pub(crate) fn run(args: &Args) -> Result<ExitCode, String> {
    let machine = Machine::here();
    let keep = |sizes: &[usize]| {
        let all = sizes.len();
        let count = if args.quick { 2 } else { all - if args.short { 2 } else { 0 } };
        sizes[..count.min(all)].to_vec()
    };
    let (sweeps, threads) = (sweeps::all(&keep)?, sweeps::threads()?);
    let report = Report { schema: 1, machine, sweeps, threads };
    if let Some(path) = &args.json {
        place::write_json(path, &report)?;
    }
    if let Some(path) = &args.svg {
        place::write(path, &svg(&report))?;
    }
    print!("{}", text(&report));
    Ok(ExitCode::SUCCESS)
}

fn text(report: &Report) -> String {
    let mut text = format!("{}\n", report.machine.sentence());
    for sweep in &report.sweeps {
        let Sweep { over, name, unit, points, .. } = sweep;
        // Writing into a string does not fail.
        let _ = writeln!(text, "\n{over}: {name}, {unit}; slope {}", sweep.slope_text());
        for Point { size, time } in points {
            let Spread { median, low, high } = time;
            let _ = writeln!(text, "{size:>12} {median:>12.4} [{low:.4}-{high:.4}]");
        }
    }
    let _ = writeln!(text, "\nthreads: one picture, seconds");
    for Threads { count, wall, processor, speedup, overhead } in &report.threads {
        let _ = writeln!(
            text,
            "{count:>12} wall {:.4} [{:.4}-{:.4}], processor {:.4}, {:.2} [{:.2}-{:.2}] times \
             as fast as one for {:.3} times the work",
            wall.median,
            wall.low,
            wall.high,
            processor.median,
            speedup.median,
            speedup.low,
            speedup.high,
            overhead.median
        );
    }
    text
}

/// The sweeps as lines, a panel for each thing that grows and each unit.
pub(crate) fn svg(report: &Report) -> String {
    let mut panels: Vec<Panel> = Vec::new();
    for sweep in &report.sweeps {
        let name = format!("{}, slope {}", sweep.name, sweep.slope_text());
        let points = sweep.points.iter().map(|p| (p.size, p.time.median)).collect();
        let line = Line { name, points };
        let same = |panel: &&mut Panel| panel.x == sweep.over && panel.y == sweep.unit;
        match panels.iter_mut().find(same) {
            Some(panel) => panel.lines.push(line),
            None => panels.push(Panel {
                title: format!("{}: {}", sweep.over, sweep.unit),
                x: sweep.over.clone(),
                y: sweep.unit.clone(),
                lines: vec![line],
            }),
        }
    }
    plot::svg(&Plot {
        title: "how times grow".to_owned(),
        note: "one thread, its processor time; slope 1: twice as many take twice as long"
            .to_owned(),
        panels,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sweeps_have_slopes_and_panels() {
        let time = |median| Spread { median, low: median, high: median };
        let points = [10.0, 100.0].map(|size| Point { size, time: time(size * 2.0) }).to_vec();
        let sweeps = vec![
            Sweep::new("pixels", "one light", "seconds", points.clone()),
            Sweep::new("triangles", "closest hit", "ns a ray", points.clone()),
            Sweep::new("triangles", "any hit", "ns a ray", points[..1].to_vec()),
        ];
        let found: Vec<_> = sweeps.iter().map(Sweep::slope_text).collect();
        assert_eq!(found, ["1.00", "1.00", "-"]);
        let ratio = time(1.0);
        let one =
            Threads { count: 1, wall: ratio, processor: ratio, speedup: ratio, overhead: ratio };
        let report = Report { schema: 1, machine: Machine::here(), sweeps, threads: vec![one] };
        let svg = svg(&report);
        assert_eq!(svg.matches("<g ").count(), 2, "a panel for each thing that grows");
        assert!(svg.contains("closest hit, slope 1.00") && text(&report).contains("slope 1.00"));
        let json = serde_json::to_string(&report).unwrap();
        let back: Report = serde_json::from_str(&json).unwrap();
        assert_eq!((back.sweeps.len(), &back.threads), (3, &report.threads));
    }
}
