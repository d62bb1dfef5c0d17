//! `check`: judge fixtures against their goldens.

use std::hash::{BuildHasher, Hasher, RandomState};
use std::path::PathBuf;
use std::time::Instant;

use harness::recheck::{Rechecked, recheck};
use harness::report::page::{self, Kind};
use harness::report::{outcome_line, run_json, summarize};
use harness::suite::Suite;
use harness::verdict::{Origin, Outcome, Verdict};
use harness::{run, store};

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
    /// Render every fixture, also those that nothing changed for since they were last a match
    #[arg(long)]
    no_cache: bool,
}

pub(crate) fn run(here: &Here, args: &Args) -> Result<Answer, CannotAsk> {
    let suite = here.suite()?;
    let started = Instant::now();
    let selection = suite.select(&args.filters)?;
    let progress = Progress::start("checking", selection.fixtures.len() + selection.orphans.len());
    let advance = |outcome: &Outcome| progress.advance(&outcome.name);
    // A build server has time, and its record would be one that nobody made.
    let Rechecked { outcomes, unkept } = if args.no_cache || std::env::var_os("CI").is_some() {
        Rechecked { outcomes: run::run(&suite, &selection, &advance)?, unkept: None }
    } else {
        recheck(&suite, &selection, random(), &advance)?
    };
    progress.finish();

    let reader = here.reader(&suite);
    for outcome in outcomes.iter().filter(|outcome| outcome.verdict != Verdict::Match) {
        println!("{}", outcome_line(outcome, &reader));
    }
    say_audited(&outcomes);
    let elapsed = started.elapsed().as_secs_f64();
    let summary = summarize(&outcomes);
    if summary.belied > 0 && unkept.is_none() {
        println!("{} was wrong: it is removed, and everything was rendered", Suite::RECORD);
    }
    println!("{summary} ({elapsed:.2} s)");
    if let Some(why) = &unkept {
        println!("the record of matches could not be kept: {why}");
    }
    let page = page::html(&suite, &outcomes, elapsed * 1e3, Kind::Report, &reader);
    store::write(&suite.root().join(Suite::REPORT), page.as_bytes())?;
    println!("report: {}{}", reader.path_prefix, Suite::REPORT);
    if let Some(path) = &args.json {
        let json = serde_json::to_string_pretty(&run_json(&outcomes, elapsed * 1e3))?;
        here.write(path, json.as_bytes())?;
    }
    Ok(if summary.is_green() { Answer::Yes } else { Answer::No })
}

/// Which fixtures were rendered although nothing had changed for them.
fn say_audited(outcomes: &[Outcome]) {
    const SHOWN: usize = 8;
    let is_audited = |o: &&Outcome| matches!(o.origin, Origin::Audited | Origin::Belied);
    let names: Vec<_> = outcomes.iter().filter(is_audited).map(|o| o.name.as_str()).collect();
    if names.is_empty() {
        return;
    }
    let more = match names.len().saturating_sub(SHOWN) {
        0 => String::new(),
        more => format!(" and {more} more, see --json"),
    };
    println!("audited: {}{more}", names[..names.len().min(SHOWN)].join(", "));
}

/// Another number each time, from the randomness of the system that the
/// standard library takes for its hash tables.
fn random() -> u64 {
    RandomState::new().build_hasher().finish()
}
