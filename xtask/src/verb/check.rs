//! `check`: judge fixtures against their goldens.

mod outputs;
mod say;

use std::hash::{BuildHasher, Hasher, RandomState};
use std::time::Instant;

use harness::last_failed;
use harness::recheck::{Rechecked, recheck};
use harness::report::page::{self, Kind};
use harness::report::summarize;
use harness::run;
use harness::steady::run_repeatedly;
use harness::store::{self, StoreError};
use harness::suite::{Selection, Suite};
use harness::verdict::Outcome;

use outputs::Outputs;
use say::Say;
use xtask::progress::Progress;
use xtask::{Answer, CannotAsk, Here};

/// Flags of `check`.
#[derive(Debug, clap::Args)]
#[command(after_help = AFTER_HELP)]
pub(crate) struct Args {
    /// Which fixtures; all if none is given
    #[arg(value_name = "FILTER")]
    filters: Vec<String>,
    /// Of those, the ones that were no match when last checked
    #[arg(long)]
    last_failed: bool,
    /// Render each so many times: any difference in bits is the verdict unsteady
    #[arg(long, value_name = "COUNT", value_parser = clap::value_parser!(u32).range(2..))]
    repeat: Option<u32>,
    /// Render every fixture, also those that nothing changed for since they were last a match
    #[arg(long)]
    no_cache: bool,
    #[command(flatten)]
    outputs: Outputs,
    #[command(flatten)]
    say: Say,
}

const AFTER_HELP: &str = "\
Exit codes: 0 all match, 1 something does not, 2 could not ask.

Examples:
  cargo xtask check                             judge every fixture
  cargo xtask check 'box/from-*' torus          those of a pattern or with \"torus\" in their name
  cargo xtask check --last-failed               those that were no match, until all are
  cargo xtask check sphere --repeat 20          are renders the same each time?
  cargo xtask check --json a.json --junit a.xml write what docs/ci.md describes";

pub(crate) fn run(here: &Here, args: &Args) -> Result<Answer, CannotAsk> {
    let suite = here.suite()?;
    args.outputs.may_write(here)?;
    let started = Instant::now();
    let mut selection = suite.select(&args.filters)?;
    if args.last_failed {
        selection = last_failed::select(&suite, &selection)?;
    }
    let Rechecked { outcomes, unkept } = judge(&suite, &selection, args)?;
    let elapsed = started.elapsed().as_secs_f64();

    let (say, reader) = (&args.say, here.reader(&suite));
    // First of all, as a reader such as `head` ends the program.
    let is_all = args.filters.is_empty() && !args.last_failed;
    let kept = last_failed::keep(&suite, &outcomes, is_all);
    let page = page::html(&suite, &outcomes, elapsed * 1e3, Kind::Report, &reader);
    let reported = store::write(&suite.root().join(Suite::REPORT), page.as_bytes());
    let written = args.outputs.write(here, &suite, &outcomes, elapsed * 1e3);

    say.outcomes(&outcomes, &reader);
    if args.repeat.is_none() {
        say.slow(&suite, &outcomes, &reader);
    }
    say.audited(&outcomes);
    let summary = summarize(&outcomes);
    if summary.belied > 0 && unkept.is_none() {
        println!("{} was wrong: it is removed, and everything was rendered", Suite::RECORD);
    }
    say.summary(&summary, elapsed);
    if let Some(why) = &unkept {
        println!("the record of matches could not be kept: {why}");
    }
    if let Err(why) = &kept {
        println!("what failed could not be kept for --last-failed: {why}");
    }
    args.outputs.say(here, &suite, &outcomes, elapsed * 1e3)?;
    written?;
    reported?;
    if !say.quiet {
        println!("report: {}{}", reader.path_prefix, Suite::REPORT);
    }
    Ok(if summary.is_green() { Answer::Yes } else { Answer::No })
}

fn judge(suite: &Suite, selection: &Selection, args: &Args) -> Result<Rechecked, StoreError> {
    let total = selection.fixtures.len() + selection.orphans.len();
    let progress =
        if args.say.quiet { Progress::silent() } else { Progress::start("checking", total) };
    let advance = |outcome: &Outcome| progress.advance(&outcome.name);
    let every = |outcomes| Rechecked { outcomes, unkept: None };
    // A build server has time, and its record would be one that nobody made.
    let judged = if let Some(repeats) = args.repeat {
        run_repeatedly(suite, selection, repeats, &advance).map(every)
    } else if args.no_cache || std::env::var_os("CI").is_some() {
        run::run(suite, selection, &advance).map(every)
    } else {
        recheck(suite, selection, random(), &advance)
    };
    progress.finish();
    judged
}

/// Another number each time, from the randomness of the system that the
/// standard library takes for its hash tables.
fn random() -> u64 {
    RandomState::new().build_hasher().finish()
}
