//! `list`: what there is to check, and to measure by.

use std::fmt::Write;

use harness::metric::{METRICS, corpus};
use harness::report::metrics_json;
use harness::suite::Suite;
use serde_json::{Value, json};

use crate::{Answer, CannotAsk, Here};

/// Flags of `list`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Args {
    /// Which fixtures; all if none is given
    #[arg(value_name = "FILTER", conflicts_with = "metrics")]
    filters: Vec<String>,
    /// List the metrics instead, each with its range and what it cannot see
    #[arg(long)]
    metrics: bool,
    /// As the page docs/metrics.md, with how each rates a corpus of damaged pictures
    #[arg(long, requires = "metrics", conflicts_with = "json")]
    markdown: bool,
    /// As JSON
    #[arg(long)]
    json: bool,
}

const EXAMPLES: &str = "\
Examples:
  cargo xtask list torus                fixtures with \"torus\" in their name
  cargo xtask list --json               all, for machines
  cargo xtask list --metrics            what is measured, and what each measure cannot see";

pub(crate) fn run(here: &Here, args: &Args) -> Result<Answer, CannotAsk> {
    if args.markdown {
        print!("{}", corpus::document());
        return Ok(Answer::Yes);
    }
    let (text, json) =
        if args.metrics { metrics() } else { fixtures(&here.suite()?, &args.filters)? };
    if args.json {
        println!("{}", serde_json::to_string_pretty(&json)?);
    } else {
        print!("{text}");
    }
    Ok(Answer::Yes)
}

fn fixtures(suite: &Suite, filters: &[String]) -> Result<(String, Value), CannotAsk> {
    let selection = suite.select(filters)?;
    let mut text = String::new();
    for name in &selection.fixtures {
        let _ = writeln!(text, "{name}");
    }
    for name in &selection.orphans {
        let _ = writeln!(text, "{name} (a golden without a fixture)");
    }
    let fixture = |name: &String| json!({ "name": name, "file": Suite::fixture_label(name) });
    let fixtures: Vec<_> = selection.fixtures.iter().map(fixture).collect();
    let json = json!({ "schema": 1, "fixtures": fixtures, "orphans": selection.orphans });
    Ok((text, json))
}

fn metrics() -> (String, Value) {
    let mut text = String::new();
    for m in METRICS {
        let (name, range, unit) = (m.name, m.range, m.unit);
        let way = m.direction.words();
        let limit = m.limit.map_or("reported only".to_owned(), |limit| format!("limits: {limit}"));
        let _ =
            write!(text, "{name}: {}\n  range {range}, unit {unit}, {way}, {limit}\n", m.measures);
        let _ = writeln!(text, "  cannot see: {}", m.blind_spot);
    }
    (text, json!({ "schema": 1, "metrics": metrics_json() }))
}
