//! `look`: fixtures judged, and what is said of them in the terminal, for every
//! verb that judges as `check` does.

use std::hash::{BuildHasher, Hasher, RandomState};
use std::time::Instant;

use harness::recheck::{Rechecked, recheck};
use harness::report::{Reader, outcome_line, summarize};
use harness::run;
use harness::suite::Suite;
use harness::verdict::{Origin, Outcome, Verdict};

use crate::CannotAsk;
use crate::progress::Progress;

/// What was judged.
#[derive(Debug)]
pub struct Looked {
    /// The outcomes, and whether the record of matches could be kept.
    pub rechecked: Rechecked,
    /// How long it took, in milliseconds.
    pub elapsed_ms: f64,
}

/// Judges what the filters select, without rendering again what is unchanged
/// since its last match unless `no_cache`.
///
/// # Errors
/// Filters that select nothing, and artifacts that cannot be written.
pub fn look(suite: &Suite, filters: &[String], no_cache: bool) -> Result<Looked, CannotAsk> {
    let started = Instant::now();
    let selection = suite.select(filters)?;
    let progress = Progress::start("checking", selection.fixtures.len() + selection.orphans.len());
    let advance = |outcome: &Outcome| progress.advance(&outcome.name);
    // A build server has time, and its record would be one that nobody made.
    let rechecked = if no_cache || std::env::var_os("CI").is_some() {
        Rechecked { outcomes: run::run(suite, &selection, &advance)?, unkept: None }
    } else {
        recheck(suite, &selection, random(), &advance)?
    };
    progress.finish();
    Ok(Looked { rechecked, elapsed_ms: started.elapsed().as_secs_f64() * 1e3 })
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

    /// Prints a line for each that is no match, and the summary.
    pub fn say(&self, reader: &Reader) {
        let failing = self.outcomes().iter().filter(|outcome| outcome.verdict != Verdict::Match);
        for outcome in failing {
            println!("{}", outcome_line(outcome, reader));
        }
        self.say_summary();
    }

    /// Prints how many there are of each verdict.
    pub fn say_summary(&self) {
        let Rechecked { outcomes, unkept } = &self.rechecked;
        say_audited(outcomes);
        let summary = summarize(outcomes);
        if summary.belied > 0 && unkept.is_none() {
            println!("{} was wrong: it is removed, and everything was rendered", Suite::RECORD);
        }
        println!("{summary} ({:.2} s)", self.elapsed_ms / 1e3);
        if let Some(why) = unkept {
            println!("the record of matches could not be kept: {why}");
        }
    }
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
