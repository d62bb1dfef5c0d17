//! `kernels`: nanoseconds of the tests that a ray is held against, one by one.
//!
//! Each is called through its public function, from a loop of its own, with its
//! cases in the cache. Cases do not wait for each other: this is throughput on
//! one thread, not latency.

mod groups;
mod rest;
mod shapes;

use std::fmt::Write as _;
use std::path::PathBuf;
use std::process::ExitCode;

use serde::{Deserialize, Serialize};

use crate::bars::{self, Bar};
use crate::machine::Machine;
use crate::measure::{Effort, Pass, Spread, in_turns};
use crate::place;

/// Nanoseconds of a second.
const NANOSECONDS: f64 = 1e9;

/// Cases of a kernel: so many that no branch predictor learns them by heart,
/// and so few that they stay in a second-level cache.
const CASES: usize = 1 << 12;

/// About half a minute in all.
const EFFORT: Effort = Effort { rounds: 15, turn: 4e-3 };

/// Flags of `bench kernels`.
#[derive(Debug, clap::Args)]
pub(crate) struct Args {
    /// Only those with one of these in their name, such as `torus` or `hit`
    #[arg(value_name = "FILTER")]
    filters: Vec<String>,
    /// Also write the numbers as JSON
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
    /// Also draw them
    #[arg(long, value_name = "FILE")]
    svg: Option<PathBuf>,
}

/// Something to be timed.
struct Kernel {
    /// What is asked.
    group: &'static str,
    /// In which case.
    name: &'static str,
    /// How many tests a pass is.
    tests: usize,
    pass: Pass<'static>,
}

/// What a kernel took.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct Row {
    /// What is asked.
    pub(crate) group: String,
    /// In which case.
    pub(crate) name: String,
    /// Nanoseconds of one test.
    pub(crate) ns: Spread,
}

/// What is written for machines.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct Report {
    /// The version of this form.
    pub(crate) schema: u32,
    pub(crate) machine: Machine,
    /// Group by group.
    pub(crate) rows: Vec<Row>,
}

pub(crate) fn run(args: &Args) -> Result<ExitCode, String> {
    let mut kernels = shapes::all()?;
    kernels.extend(rest::all()?);
    kernels.extend(groups::all()?);
    let label = |kernel: &Kernel| format!("{} {}", kernel.group, kernel.name);
    let chosen = |kernel: &Kernel| {
        let label = label(kernel);
        args.filters.is_empty() || args.filters.iter().any(|filter| label.contains(filter))
    };
    kernels.retain(chosen);
    if kernels.is_empty() {
        return Err(format!(
            "expected a part of a kernel's name, found {}",
            args.filters.join(", ")
        ));
    }
    let report = measure(kernels, EFFORT);
    if let Some(path) = &args.json {
        place::write_json(path, &report)?;
    }
    if let Some(path) = &args.svg {
        place::write(path, &svg(&report))?;
    }
    print!("{}", text(&report));
    Ok(ExitCode::SUCCESS)
}

fn measure(kernels: Vec<Kernel>, effort: Effort) -> Report {
    let machine = Machine::here();
    let (mut names, mut passes) = (Vec::new(), Vec::new());
    for Kernel { group, name, tests, pass } in kernels {
        names.push((group, name, tests));
        passes.push(pass);
    }
    let times = in_turns(&mut passes, effort);
    let row = |((group, name, tests), time): ((&str, &str, usize), Spread)| Row {
        group: group.to_owned(),
        name: name.to_owned(),
        ns: time.times(NANOSECONDS / tests as f64),
    };
    Report { schema: 1, machine, rows: names.into_iter().zip(times).map(row).collect() }
}

fn text(report: &Report) -> String {
    let mut text = format!("{}\n\n", report.machine.sentence());
    let _ =
        writeln!(text, "{:<30} {:>9} {:>9} {:>9}", "ns per test", "median", "lowest", "highest");
    for Row { group, name, ns } in &report.rows {
        let label = format!("{group} {name}");
        // Writing into a string does not fail.
        let _ = writeln!(text, "{label:<30} {:>9.1} {:>9.1} {:>9.1}", ns.median, ns.low, ns.high);
    }
    text
}

/// The rows as bars.
pub(crate) fn svg(report: &Report) -> String {
    let bar = |row: &Row| Bar { group: row.group.clone(), name: row.name.clone(), value: row.ns };
    let bars: Vec<_> = report.rows.iter().map(bar).collect();
    let note = "one thread; the median of the turns, and from the lowest to the highest";
    bars::svg("nanoseconds per test", note, "ns", &bars)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_kernel_is_timed_and_shown() {
        let mut kernels = shapes::all().unwrap();
        kernels.extend(rest::all().unwrap());
        kernels.extend(groups::all().unwrap());
        let count = kernels.len();
        assert!(count > 30, "{count}");
        let report = measure(kernels, Effort { rounds: 1, turn: 0.0 });
        assert_eq!(report.rows.len(), count);
        let (text, svg) = (text(&report), svg(&report));
        for row in &report.rows {
            assert!(row.ns.median > 0.0 && row.ns.median.is_finite(), "{row:?}");
            let label = format!("{} {}", row.group, row.name);
            assert!(text.contains(&label) && svg.contains(&label), "{label}");
        }
        let json = serde_json::to_string(&report).unwrap();
        assert_eq!(serde_json::from_str::<Report>(&json).unwrap().rows.len(), count);
    }
}
