//! `check`: judge fixtures against their goldens.

mod outputs;

use harness::suite::Suite;

use crate::look::{Ask, How, look};
use crate::say::Say;
use crate::{Answer, CannotAsk, Here};
use outputs::Outputs;

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
    let how = match args.repeat {
        Some(times) => How::Repeatedly(times),
        None if args.no_cache => How::Once,
        None => How::Recheck,
    };
    let ask = Ask { filters: &args.filters, last_failed: args.last_failed, how };
    let looked = look(&suite, &ask, &args.say)?;
    let reader = here.reader(&suite);
    let (outcomes, elapsed_ms) = (looked.outcomes(), looked.elapsed_ms);
    // Before a line is printed, as a reader such as `head` ends the program.
    let reported = looked.write_report(&suite, &reader);
    let written = args.outputs.write(here, &suite, outcomes, elapsed_ms);
    args.outputs.to_people(|| looked.say(&suite, &args.say, &reader));
    args.outputs.say(here, &suite, outcomes, elapsed_ms);
    written?;
    reported?;
    if !args.say.quiet {
        println!("report: {}{}", reader.path_prefix, Suite::REPORT);
    }
    Ok(if looked.is_green() { Answer::Yes } else { Answer::No })
}
