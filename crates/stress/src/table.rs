//! The stress suite's result as rows, one for each metric of each kernel of
//! each family, and as text to read.

use std::fmt::Write as _;

use serde::Serialize;

use crate::metric::Sum;
use crate::{Case, Family, Metric, Tally};

/// One number of the table.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Row {
    /// The primitive's name.
    pub primitive: &'static str,
    /// The family's name.
    pub family: String,
    /// The kernel's name.
    pub kernel: &'static str,
    /// Whether the kernel is held to the target.
    pub contract: bool,
    /// How many cases.
    pub n: u64,
    /// How many of them were too close to call, and so right either way.
    pub ties: u64,
    /// The metric's name.
    pub metric: &'static str,
    /// Its value; null where it is infinite.
    pub value: Option<f64>,
    /// The largest value that passes; null where it is only shown.
    pub target: Option<f64>,
    /// Whether the value is at most the target.
    pub pass: bool,
}

/// What is written for machines.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Table {
    /// The version of this form.
    pub schema: u32,
    /// What the random numbers started from.
    pub seed: u64,
    /// Whether the large number of cases was run.
    pub full: bool,
    /// All numbers.
    pub rows: Vec<Row>,
}

/// The rows of one family.
pub fn rows(family: &Family, tallies: &[Tally]) -> Vec<Row> {
    let mut rows = Vec::new();
    for (kernel, tally) in family.kernels.iter().zip(tallies) {
        for (metric, target) in family.all_targets() {
            let value = tally.value(metric);
            rows.push(Row {
                primitive: family.primitive,
                family: family.name.clone(),
                kernel: kernel.name,
                contract: kernel.contract,
                n: tally.cases(),
                ties: tally.ties(),
                metric: metric.name(),
                value: value.is_finite().then_some(value),
                target,
                // A kernel that was asked nothing has shown nothing.
                pass: tally.cases() > 0 && target.is_none_or(|target| value <= target),
            });
        }
    }
    rows
}

/// A line for each kernel of each family; those not under contract apart.
pub fn text(rows: &[Row]) -> String {
    let mut text = String::new();
    for contract in [true, false] {
        let chosen: Vec<_> = rows.iter().filter(|row| row.contract == contract).collect();
        if chosen.is_empty() {
            continue;
        }
        let title = if contract { "What renders" } else { "Textbook kernels, held to nothing" };
        let _ = writeln!(text, "{title}");
        for of_kernel in chosen.chunk_by(|a, b| {
            (a.primitive, &a.family, a.kernel) == (b.primitive, &b.family, b.kernel)
        }) {
            let first = of_kernel[0];
            let verdict = match (contract, of_kernel.iter().all(|row| row.pass)) {
                (true, true) => "ok  ",
                (true, false) => "FAIL",
                (false, _) => "    ",
            };
            let name = format!("{}/{}", first.primitive, first.family);
            let kernel = if contract { "" } else { first.kernel };
            let _ = write!(text, "{verdict} {name:<34} {kernel:<22} {:>8}", cases(first.n));
            let ties = if first.ties > 0 { format!("{} ties", first.ties) } else { String::new() };
            let _ = write!(text, " {ties:>12}");
            for row in
                of_kernel.iter().filter(|row| !(row.pass && row.metric == Metric::Ties.name()))
            {
                let _ = write!(text, "  {}", number(row));
            }
            text.push('\n');
        }
    }
    text
}

/// What a case alone was found to be beyond its family's targets, such as
/// `leaks 1 (target 0)`.
pub fn misses(family: &Family, case: &Case) -> String {
    let rows = rows(family, &family.judge_alone(case));
    let missed: Vec<_> = rows.iter().filter(|row| row.contract && !row.pass).map(number).collect();
    missed.join(", ")
}

/// `name value`, and the target where it is missed.
fn number(row: &Row) -> String {
    let is_count = Metric::of_name(row.metric).is_some_and(|m| m.sum() == Sum::Count);
    let value = match row.value {
        None => "inf".to_owned(),
        Some(x) if is_count => format!("{x}"),
        Some(x) => short(x),
    };
    let beyond = match row.target {
        Some(target) if !row.pass && row.contract => format!(" (target {})", short(target)),
        _ => String::new(),
    };
    format!("{} {value}{beyond}", row.metric.replace('_', " "))
}

/// Three digits.
fn short(x: f64) -> String {
    if x == 0.0 || (1e-2..1e4).contains(&x) {
        format!("{}", (x * 1e3).round() / 1e3)
    } else {
        format!("{x:.2e}")
    }
}

/// A number of cases, shortly.
fn cases(n: u64) -> String {
    if n >= 1_000_000 { format!("{:.3}e6", n as f64 * 1e-6) } else { n.to_string() }
}
