//! `Lines`: what is said of fixtures, as soon as it is known and in their order.

use std::collections::BTreeMap;
use std::io::Write as _;
use std::sync::{Mutex, PoisonError};

use crate::progress::Progress;

/// Lines that come from several threads and are printed in one order, whoever is
/// first: each when all before it are known.
pub(super) struct Lines<'a> {
    /// The number of each fixture.
    numbers: BTreeMap<&'a str, usize>,
    progress: &'a Progress,
    state: Mutex<State>,
}

#[derive(Default)]
struct State {
    /// The number of the first that is not known.
    next: usize,
    /// What is known and has its turn later; fixtures without a line too.
    waiting: BTreeMap<usize, Option<String>>,
    /// The line that could not be printed, as nobody reads.
    unread: Option<String>,
}

impl<'a> Lines<'a> {
    /// Nothing is known yet of fixtures of these names.
    pub(super) fn new(names: impl Iterator<Item = &'a str>, progress: &'a Progress) -> Self {
        let numbers = names.enumerate().map(|(number, name)| (name, number)).collect();
        Self { numbers, progress, state: Mutex::default() }
    }

    /// This is known of a fixture: a line, or that there is none.
    pub(super) fn tell(&self, name: &str, line: Option<String>) {
        let mut state = self.state.lock().unwrap_or_else(PoisonError::into_inner);
        let Some(&number) = self.numbers.get(name) else { return };
        state.waiting.insert(number, line);
        while let Some(line) = {
            let next = state.next;
            state.waiting.remove(&next)
        } {
            state.next += 1;
            self.print(&mut state, line);
        }
    }

    /// Whether lines could not be printed. Other threads have renderers that run, so
    /// that the program must not end here and now.
    pub(super) fn is_unread(&self) -> bool {
        self.state.lock().unwrap_or_else(PoisonError::into_inner).unread.is_some()
    }

    /// Prints what waits for fixtures of which nothing will be known.
    pub(super) fn finish(self) {
        let mut state = self.state.lock().unwrap_or_else(PoisonError::into_inner);
        for line in std::mem::take(&mut state.waiting).into_values() {
            self.print(&mut state, line);
        }
        if let Some(line) = &state.unread {
            // It fails again, which ends the program as any other line that cannot be printed.
            println!("{line}");
        }
    }

    fn print(&self, state: &mut State, line: Option<String>) {
        let Some(line) = line.filter(|_| state.unread.is_none()) else { return };
        // A bar on the terminal makes room for it.
        if self.progress.beside(|| writeln!(std::io::stdout(), "{line}")).is_err() {
            state.unread = Some(line);
        }
    }
}
