//! `watch`: check anew whenever something is edited that verdicts follow from.

mod seen;

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::thread;
use std::time::{Duration, Instant};

use harness::report::Reader;
use harness::report::page::{self, Kind};
use harness::review::Review;
use harness::stamps::Stamps;
use harness::store;
use harness::suite::Suite;

use super::bless::by_hand;
use super::review;
use crate::interrupt::{Interrupt, end_at_once};
use crate::look::{Ask, How, Looked, look};
use crate::rebuild::{self, Built, become_program, build, repository};
use crate::say::Say;
use crate::serve::{Address, Site, Token, serve};
use crate::{Answer, CannotAsk, Here};
use seen::{Seen, say_paths};

/// Flags of `watch`.
#[derive(Debug, clap::Args)]
#[command(after_help = AFTER_HELP)]
pub(crate) struct Args {
    /// Which fixtures; all if none is given
    #[arg(value_name = "FILTER")]
    filters: Vec<String>,
    /// Print only, and serve no page
    #[arg(long)]
    no_serve: bool,
    #[command(flatten)]
    say: Say,
}

const AFTER_HELP: &str = "\
Exit codes, after Ctrl-C: 0 all match or were accepted, 1 something does not, 2 could not ask.

Examples:
  cargo xtask watch                   check what is edited, and show it at the address that is printed
  cargo xtask watch torus             those with \"torus\" in their name
  cargo xtask watch --no-serve -q     print only, and little";

/// How often files are looked at, at most.
const LOOK_EVERY: Duration = Duration::from_millis(300);

/// Of so much time one part is spent on looking, at most: under 2 % of a core,
/// however many files there are.
const LOOK_ONE_IN: u32 = 60;

pub(crate) fn run(here: &Here, args: &Args) -> Result<Answer, CannotAsk> {
    if !args.no_serve {
        by_hand("watch")?;
    }
    let suite = here.suite()?;
    // Nothing to select is said at once, not waited for.
    suite.select(&args.filters)?;
    let mut watch = Watch {
        reader: here.reader(&suite),
        sources: repository(&suite),
        // Before anything is looked at, so that a start that fails says so.
        program: store::program_hash()?,
        interrupt: Interrupt::listen()?,
        served: None,
        said: Said::Unknown,
        is_unshown: false,
        suite,
        args,
    };
    watch.until_interrupted()
}

/// What is watched, and what was said of it last.
struct Watch<'a> {
    suite: Suite,
    args: &'a Args,
    reader: Reader,
    sources: Option<PathBuf>,
    /// The hash of the program that runs.
    program: String,
    interrupt: Interrupt,
    served: Option<(Arc<Site>, Address)>,
    /// What was said last.
    said: Said,
    /// Whether the last check was not shown, as something changed meanwhile,
    /// whoever changed it.
    is_unshown: bool,
}

/// What was said of a suite.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Said {
    AllMatch,
    /// Unless it is accepted where it is served.
    NotAll,
    /// That it could not be judged, or nothing yet of how it is now.
    Unknown,
}

impl Watch<'_> {
    fn until_interrupted(&mut self) -> Result<Answer, CannotAsk> {
        let mut seen = self.see();
        self.check()?;
        loop {
            let started = Instant::now();
            let found = self.see();
            let pause = LOOK_EVERY.max(started.elapsed() * LOOK_ONE_IN);
            if found != seen || self.is_unshown {
                let found = found.at_rest(&self.interrupt, || self.see());
                self.act_on(&found, &seen)?;
                seen = found;
            }
            if self.interrupt.wait(pause) {
                return self.answer();
            }
        }
    }

    fn see(&self) -> Seen {
        Seen::now(&self.suite, self.sources.as_deref())
    }

    fn act_on(&mut self, found: &Seen, seen: &Seen) -> Result<(), CannotAsk> {
        let edited = found.sources.changed_since(&seen.sources);
        if let (Some(root), false) = (self.sources.clone(), edited.is_empty()) {
            println!("\n{}: building", say_paths(self.suite.root(), &edited));
            match build(&root, &self.interrupt) {
                // The cargo that is found next may be another one.
                Err(CannotAsk(why)) => println!("not built: {}", why.trim_end()),
                Ok(built) => self.go_on(built, &root, found)?,
            }
        }
        let changed = found.suite.changed_since(&seen.suite);
        let others: Vec<_> = changed.into_iter().filter(|path| !self.is_ours(path)).collect();
        if others.is_empty() && !self.is_unshown || self.interrupt.is_set() {
            return Ok(());
        }
        if others.is_empty() {
            println!("\nsomething was decided meanwhile:");
        } else {
            println!("\n{}:", say_paths(self.suite.root(), &others));
        }
        self.check()
    }

    /// Goes on with what was built, if it is another program than this one.
    fn go_on(&self, built: Built, root: &Path, found: &Seen) -> Result<(), CannotAsk> {
        match built {
            // Built of something in between, and to be built again at once.
            Built::Program(_) if Stamps::of_sources(root) != found.sources => {}
            Built::Program(program) if store::file_hash(&program)? != self.program => {
                return Err(become_program(&program, &self.resumed()));
            }
            Built::Program(_) => println!("the program is the same"),
            Built::Failed => println!("not built: the verdicts above are of the program before"),
            Built::Interrupted => {}
        }
        Ok(())
    }

    /// Whether this is a golden just as it was accepted here, so that all that
    /// follows from it is known.
    fn is_ours(&self, path: &Path) -> bool {
        let relative = path.strip_prefix(self.suite.golden_folder()).ok();
        let name =
            relative.and_then(|relative| relative.with_extension("").to_str().map(str::to_owned));
        // A name has `/` between its parts on every system.
        let name = name.map(|name| name.replace(std::path::MAIN_SEPARATOR, "/"));
        let Some((site, _)) = &self.served else { return false };
        name.is_some_and(|name| site.review().wrote(&name))
    }

    /// Judges everything that is selected, says what is said of it and shows it.
    /// A suite that cannot be judged as it is, is said to be so.
    fn check(&mut self) -> Result<(), CannotAsk> {
        let before = Stamps::of_suite(&self.suite);
        let judged = thread::scope(|scope| {
            let judging = scope.spawn(|| self.judge());
            while !judging.is_finished() {
                const LOOK_EVERY: Duration = Duration::from_millis(20);
                if self.interrupt.wait(LOOK_EVERY) {
                    end_at_once(1);
                }
            }
            judging.join()
        });
        self.said = Said::Unknown;
        self.is_unshown = Stamps::of_suite(&self.suite) != before;
        match judged {
            Ok(Ok((looked, page, review))) => {
                looked.say(&self.suite, &self.args.say, &self.reader);
                // What changed meanwhile is checked in a moment; until then, nothing
                // is accepted that is not shown.
                if !self.is_unshown {
                    self.said = if looked.is_green() { Said::AllMatch } else { Said::NotAll };
                    self.show(&page, review)?;
                }
            }
            Ok(Err(CannotAsk(why))) => self.trouble(why.trim_end()),
            // Its message was printed.
            Err(_) => self.trouble("the renderer panicked; edit it, or the fixture"),
        }
        Ok(())
    }

    /// Says why the suite cannot be judged as it is, also where it is shown.
    fn trouble(&self, why: &str) {
        println!("error: {why}");
        if let Some((site, _)) = &self.served {
            site.trouble(why);
        }
    }

    fn judge(&self) -> Result<(Looked, String, Review), CannotAsk> {
        let ask = Ask { filters: &self.args.filters, last_failed: false, how: How::Recheck };
        let looked = look(&self.suite, &ask, &self.args.say)?;
        let outcomes = looked.outcomes();
        looked.write_report(&self.suite, &self.reader)?;
        let review = Review::new(&self.suite, outcomes);
        let page = page::html(&self.suite, outcomes, looked.elapsed_ms, Kind::Watch, &self.reader);
        Ok((looked, page, review))
    }

    fn show(&mut self, page: &str, review: Review) -> Result<(), CannotAsk> {
        if self.args.no_serve {
            return Ok(());
        }
        if let Some((site, _)) = &self.served {
            return Ok(site.replace(page, review)?);
        }
        let site = Arc::new(Site::new(page, review)?);
        let address = serve(&site, resumed())?;
        println!("watching at {} until Ctrl-C", address.url());
        self.served = Some((site, address));
        Ok(())
    }

    /// Where the program that follows is to serve, as [`resumed`] reads it.
    fn resumed(&self) -> String {
        let address = self.served.as_ref().map(|(_, address)| address);
        address.map_or(String::new(), |address| format!("{} {}", address.port, address.token))
    }

    fn answer(&self) -> Result<Answer, CannotAsk> {
        let mut is_settled = self.said == Said::AllMatch;
        if let Some((site, _)) = &self.served {
            let review = site.review();
            let tally = review.tally();
            is_settled = tally.is_settled();
            if !tally.accepted.is_empty() || !tally.rejected.is_empty() {
                println!();
                review::say(&self.suite, &review, &self.reader);
            }
            // Held to the end, so that nothing is decided after it was said.
            std::mem::forget(review);
        }
        match self.said {
            Said::Unknown => {
                Err(CannotAsk("expected a suite that was judged before it ended".to_owned()))
            }
            Said::AllMatch | Said::NotAll if is_settled => Ok(Answer::Yes),
            Said::AllMatch | Said::NotAll => Ok(Answer::No),
        }
    }
}

/// Where the program before this one served.
fn resumed() -> Option<Address> {
    let text = std::env::var(rebuild::RESUMED).ok()?;
    let (port, token) = text.split_once(' ')?;
    Some(Address { port: port.parse().ok()?, token: Token::parse(token)? })
}
