//! `Seen`: how the files that are watched look at one moment.

use std::path::{Path, PathBuf};
use std::time::Duration;

use crate::interrupt::Interrupt;
use harness::stamps::Stamps;
use harness::suite::Suite;

/// How the files looked at one moment.
#[derive(PartialEq)]
pub(super) struct Seen {
    pub(super) suite: Stamps,
    pub(super) sources: Stamps,
}

impl Seen {
    /// A suite, and what its program is built from in a repository.
    pub(super) fn now(suite: &Suite, sources: Option<&Path>) -> Self {
        let sources = sources.map(Stamps::of_sources).unwrap_or_default();
        Self { suite: Stamps::of_suite(suite), sources }
    }

    /// How the files look when they are at rest: an editor writes in several
    /// steps, and a branch that is checked out many files.
    pub(super) fn at_rest(mut self, interrupt: &Interrupt, see: impl Fn() -> Self) -> Self {
        const REST: Duration = Duration::from_millis(60);
        const MAX_LOOKS: usize = 50;
        for _ in 0..MAX_LOOKS {
            if interrupt.wait(REST) {
                break;
            }
            let again = see();
            if again == self {
                break;
            }
            self = again;
        }
        self
    }
}

/// That these have changed, in words that are short however many there are.
pub(super) fn say_paths(root: &Path, paths: &[PathBuf]) -> String {
    const SHOWN: usize = 3;
    let label = |path: &PathBuf| path.strip_prefix(root).unwrap_or(path).display().to_string();
    let shown: Vec<_> = paths.iter().take(SHOWN).map(label).collect();
    match paths.len().saturating_sub(SHOWN) {
        0 => format!("{} changed", shown.join(", ")),
        more => format!("{} and {more} more changed", shown.join(", ")),
    }
}
