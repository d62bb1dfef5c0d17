//! `check`: judge fixtures against their goldens.

use std::path::PathBuf;

use harness::report::page::{self, Kind};
use harness::report::run_json;
use harness::store;
use harness::suite::Suite;

use xtask::look::look;
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
    /// Render every fixture, also those that nothing changed for since they were last a match
    #[arg(long)]
    no_cache: bool,
}

pub(crate) fn run(here: &Here, args: &Args) -> Result<Answer, CannotAsk> {
    let suite = here.suite()?;
    let looked = look(&suite, &args.filters, args.no_cache)?;
    let reader = here.reader(&suite);
    looked.say(&reader);
    let (outcomes, elapsed_ms) = (looked.outcomes(), looked.elapsed_ms);
    let page = page::html(&suite, outcomes, elapsed_ms, Kind::Report, &reader);
    store::write(&suite.root().join(Suite::REPORT), page.as_bytes())?;
    println!("report: {}{}", reader.path_prefix, Suite::REPORT);
    if let Some(path) = &args.json {
        let json = serde_json::to_string_pretty(&run_json(outcomes, elapsed_ms))?;
        here.write(path, json.as_bytes())?;
    }
    Ok(if looked.is_green() { Answer::Yes } else { Answer::No })
}
