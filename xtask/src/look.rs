//! `look`: fixtures judged, and what is said of them in the terminal, for every
//! verb that judges as `check` does.

use std::hash::{BuildHasher, Hasher, RandomState};
use std::time::Instant;

use harness::last_failed;
use harness::recheck::{Rechecked, recheck};
use harness::report::page::{self, Kind};
use harness::report::{Reader, summarize};
use harness::run;
use harness::steady::run_repeatedly;
use harness::store::{self, StoreError};
use harness::suite::{Selection, Suite};
use harness::verdict::Outcome;

use crate::CannotAsk;
use crate::progress::Progress;
use crate::say::Say;

/// Which fixtures are judged, and how.
#[derive(Debug, Clone, Copy)]
pub struct Ask<'a> {
    /// Which fixtures; all if none is given.
    pub filters: &'a [String],
    /// Of those, only what was no match when it was last judged.
    pub last_failed: bool,
    /// Whether renders are left out or repeated.
    pub how: How,
}

/// How often a fixture is rendered.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum How {
    /// Not again if nothing changed since its last match; once where `CI` is set.
    Recheck,
    /// Once.
    Once,
    /// So often, and it must be the same picture each time.
    Repeatedly(u32),
}

/// What was judged.
#[derive(Debug)]
pub struct Looked {
    rechecked: Rechecked,
    /// How long it took, in milliseconds.
    pub elapsed_ms: f64,
    how: How,
    /// Why it could not be kept what failed. No outcome follows from that.
    unkept_failures: Option<StoreError>,
}

/// Judges what is asked for.
///
/// # Errors
/// Filters that select nothing, and artifacts that cannot be written.
pub fn look(suite: &Suite, ask: &Ask<'_>, say: &Say) -> Result<Looked, CannotAsk> {
    let started = Instant::now();
    let mut selection = suite.select(ask.filters)?;
    if ask.last_failed {
        selection = last_failed::select(suite, &selection)?;
    }
    let rechecked = judge(suite, &selection, ask.how, say)?;
    let elapsed_ms = started.elapsed().as_secs_f64() * 1e3;
    let is_all = ask.filters.is_empty() && !ask.last_failed;
    let unkept_failures = last_failed::keep(suite, &rechecked.outcomes, is_all).err();
    Ok(Looked { rechecked, elapsed_ms, how: ask.how, unkept_failures })
}

fn judge(
    suite: &Suite,
    selection: &Selection,
    how: How,
    say: &Say,
) -> Result<Rechecked, StoreError> {
    let total = selection.fixtures.len() + selection.orphans.len();
    let progress = if say.quiet { Progress::silent() } else { Progress::start("checking", total) };
    let advance = |outcome: &Outcome| progress.advance(&outcome.name);
    let every = |outcomes| Rechecked { outcomes, unkept: None };
    // A build server has time, and its record would be one that nobody made.
    let is_server = std::env::var_os("CI").is_some();
    let judged = match how {
        How::Repeatedly(times) => run_repeatedly(suite, selection, times, &advance).map(every),
        How::Recheck if !is_server => recheck(suite, selection, random(), &advance),
        How::Recheck | How::Once => run::run(suite, selection, &advance).map(every),
    };
    progress.finish();
    judged
}

impl Looked {
    /// What is said of each.
    pub fn outcomes(&self) -> &[Outcome] {
        &self.rechecked.outcomes
    }

    /// Whether everything matches.
    pub fn is_green(&self) -> bool {
        summarize(self.outcomes()).is_green()
    }

    /// Writes the page of it to where a check does.
    ///
    /// # Errors
    /// It cannot be written.
    pub fn write_report(&self, suite: &Suite, reader: &Reader) -> Result<(), StoreError> {
        let page = page::html(suite, self.outcomes(), self.elapsed_ms, Kind::Report, reader);
        store::write(&suite.root().join(Suite::REPORT), page.as_bytes())
    }

    /// Prints a line for each that is to be seen, and the summary.
    pub fn say(&self, suite: &Suite, say: &Say, reader: &Reader) {
        say.outcomes(self.outcomes(), reader);
        // What is rendered often is not slow by one picture.
        if !matches!(self.how, How::Repeatedly(_)) {
            say.slow(suite, self.outcomes(), reader);
        }
        self.say_summary(say);
    }

    /// Prints how many there are of each verdict.
    pub fn say_summary(&self, say: &Say) {
        let Rechecked { outcomes, unkept } = &self.rechecked;
        say.audited(outcomes);
        let summary = summarize(outcomes);
        if summary.belied > 0 && unkept.is_none() {
            println!("{} was wrong: it is removed, and everything was rendered", Suite::RECORD);
        }
        say.summary(&summary, self.elapsed_ms / 1e3);
        if let Some(why) = unkept {
            println!("the record of matches could not be kept: {why}");
        }
        if let Some(why) = &self.unkept_failures {
            println!("what failed could not be kept for --last-failed: {why}");
        }
    }
}

/// Another number each time, from the randomness of the system that the
/// standard library takes for its hash tables.
fn random() -> u64 {
    RandomState::new().build_hasher().finish()
}
