//! `review`: look at what does not match, and accept or reject it, in a browser
//! or in the terminal.

use std::io::Write as _;
use std::sync::Arc;
use std::time::Duration;

use harness::report::Reader;
use harness::report::page::{self, Kind};
use harness::review::Review;
use harness::stamps::Stamps;
use harness::suite::Suite;

use super::bless::{by_hand, say_what_follows};
use crate::browser;
use crate::interrupt::Interrupt;
use crate::look::{Ask, How, Looked, look};
use crate::say::Say;
use crate::serve::{Site, serve};
use crate::terminal;
use crate::{Answer, CannotAsk, Here};

/// Flags of `review`.
#[derive(Debug, clap::Args)]
#[command(after_help = AFTER_HELP)]
pub(crate) struct Args {
    /// Which fixtures; all if none is given
    #[arg(value_name = "FILTER")]
    filters: Vec<String>,
    /// In the terminal, one by one
    #[arg(long)]
    tty: bool,
    /// Also open the page in a browser
    #[arg(long, conflicts_with = "tty")]
    open: bool,
    /// Render every fixture, also those that nothing changed for since they were last a match
    #[arg(long)]
    no_cache: bool,
    #[command(flatten)]
    say: Say,
}

const AFTER_HELP: &str = "\
Exit codes: 0 all match or were accepted, 1 something was rejected or left, 2 could not ask.

Examples:
  cargo xtask review --open    judge every fixture and show a browser what does not match
  cargo xtask review torus     those with \"torus\" in their name, at the address that is printed
  cargo xtask review --tty     in the terminal, one after the other";

/// How often it is looked whether somebody is still there.
const LOOK_EVERY: Duration = Duration::from_millis(100);

pub(crate) fn run(here: &Here, args: &Args) -> Result<Answer, CannotAsk> {
    by_hand("review")?;
    let suite = here.suite()?;
    let reader = here.reader(&suite);
    let Shown { looked, mut review, page } = show(&suite, args, &reader)?;
    // In the terminal, each is shown in its turn.
    if args.tty {
        looked.say_summary(&args.say);
    } else {
        looked.say(&suite, &args.say, &reader);
    }
    if looked.is_green() {
        println!("there is nothing to review");
        return Ok(Answer::Yes);
    }
    if args.tty {
        terminal::walk(&suite, &mut review, &reader, Interrupt::listen()?)?;
        return Ok(say(&suite, &review, &reader));
    }
    let interrupt = Interrupt::listen()?;
    let site = Arc::new(Site::new(&page, review)?);
    let url = serve(&site, None)?.url();
    println!("review at {url} until its last tab is closed, or Ctrl-C");
    std::io::stdout().flush()?;
    let _opened = args.open.then(|| browser::open(&url)).transpose()?;
    while !interrupt.wait(LOOK_EVERY) && !site.tabs.have_left() {}
    let review = site.review();
    let answer = say(&suite, &review, &reader);
    // Held to the end, so that nothing is decided after it was said.
    std::mem::forget(review);
    Ok(answer)
}

/// What was judged, can be decided, and is shown, of the same files.
struct Shown {
    looked: Looked,
    review: Review,
    page: String,
}

/// Looks until nothing was edited meanwhile: else the page might show another
/// picture than the one that is accepted.
fn show(suite: &Suite, args: &Args, reader: &Reader) -> Result<Shown, CannotAsk> {
    const MAX_LOOKS: usize = 5;
    let how = if args.no_cache { How::Once } else { How::Recheck };
    let ask = Ask { filters: &args.filters, last_failed: false, how };
    for _ in 0..MAX_LOOKS {
        let before = Stamps::of_suite(suite);
        let looked = look(suite, &ask, &args.say)?;
        let outcomes = looked.outcomes();
        looked.write_report(suite, reader)?;
        let review = Review::new(suite, outcomes);
        let page = page::html(suite, outcomes, looked.elapsed_ms, Kind::Review, reader);
        if Stamps::of_suite(suite) == before {
            return Ok(Shown { looked, review, page });
        }
        eprintln!("something was edited meanwhile: looking again");
    }
    Err(CannotAsk("expected files that stay as they are: they are edited all the time".to_owned()))
}

/// Prints what became of everything.
pub(super) fn say(suite: &Suite, review: &Review, reader: &Reader) -> Answer {
    let tally = review.tally();
    for (what, names) in
        [("accepted", &tally.accepted), ("rejected", &tally.rejected), ("left", &tally.left)]
    {
        for name in names {
            println!("{what:<9} {name}");
        }
    }
    if !tally.accepted.is_empty() {
        say_what_follows(suite, reader);
    }
    println!("{tally}");
    if tally.is_settled() { Answer::Yes } else { Answer::No }
}
