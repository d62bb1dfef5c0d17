//! `check`: judge fixtures against their goldens.

use std::path::PathBuf;
use std::time::Instant;

use harness::report::{outcome_line, run_json, summarize};
use harness::run;
use harness::verdict::Verdict;

use xtask::progress::Progress;
use xtask::{Answer, CannotAsk, Here};

/// Flags of `check`.
#[derive(Debug, clap::Args)]
pub(crate) struct Args {
    /// Which fixtures; all if none is given
    #[arg(value_name = "FILTER")]
    filters: Vec<String>,
    /// Also write everything to this file as JSON
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
}

pub(crate) fn run(here: &Here, args: &Args) -> Result<Answer, CannotAsk> {
    let suite = here.suite()?;
    let started = Instant::now();
    let selection = suite.select(&args.filters)?;
    let progress = Progress::start("checking", selection.fixtures.len() + selection.orphans.len());
    let outcomes = run::run(&suite, &selection, &|outcome| {
        progress.advance(&outcome.name);
    })?;
    progress.finish();

    let reader = here.reader(&suite);
    for outcome in outcomes.iter().filter(|outcome| outcome.verdict != Verdict::Match) {
        println!("{}", outcome_line(outcome, &reader));
    }
    let elapsed = started.elapsed().as_secs_f64();
    let summary = summarize(&outcomes);
    println!("{summary} ({elapsed:.2} s)");
    if let Some(path) = &args.json {
        let json = serde_json::to_string_pretty(&run_json(&outcomes, elapsed * 1e3))?;
        here.write(path, json.as_bytes())?;
    }
    Ok(if summary.is_green() { Answer::Yes } else { Answer::No })
}
