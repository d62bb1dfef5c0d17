//! `walk`: a review in the terminal, one failure after the other.

mod blocks;
mod keys;
mod wrap;

use harness::golden::from_png;
use harness::picture::difference;
use harness::report::{Reader, outcome_parts};
use harness::review::{Decision, Review};
use harness::run::find_golden;
use harness::suite::Suite;
use harness::verdict::{Outcome, Verdict};

use crate::CannotAsk;
use crate::interrupt::Interrupt;
use blocks::{Ink, Panel, side_by_side};
use keys::{Key, Keys};
use wrap::wrap;

const HELP: &str = "a accept, r reject, s skip, p back, u undo the last, q quit, ? help";

/// What `?` says.
const MORE_HELP: [&str; 7] = [
    "a: write this picture as the golden, or remove a golden without a fixture",
    "r: note that it is wrong; nothing is written",
    "s: decide later (also n, Enter, right)",
    "p: back to the one before (also left)",
    "u: take the last decision back",
    "q: end, and say what was decided",
    "Pictures are golden, difference and actual, as far as there are such. Without colors, digits \
     are differences: 1 for 1 of 255, 2 from 2, 3 from 4 and so on to 8 from 128.",
];

/// Shows what does not match, one by one, and does what is said about it, until
/// there is no more, `q`, or it is time to end.
///
/// # Errors
/// A terminal that cannot be read or written.
pub fn walk(
    suite: &Suite,
    review: &mut Review,
    reader: &Reader,
    interrupt: Interrupt,
) -> Result<(), CannotAsk> {
    let failing = review.outcomes().filter(|outcome| outcome.verdict != Verdict::Match);
    let all: Vec<_> = failing.cloned().collect();
    let screen = Screen::here();
    let mut keys = Keys::here(interrupt);
    let (mut at, mut decided) = (0, Vec::new());
    let mut is_shown = false;
    while let Some(outcome) = all.get(at) {
        if !is_shown {
            println!("\n{}", screen.show(suite, review, outcome, (at, all.len()), reader));
            is_shown = true;
        }
        let name = std::slice::from_ref(&outcome.name);
        let before = at;
        match keys.next()? {
            key @ (Key::Accept | Key::Reject) => {
                let is_accept = key == Key::Accept;
                let said = if is_accept { review.accept(name) } else { review.reject(name) };
                screen.say(&said);
                if said.is_empty() {
                    println!("{} {}", if is_accept { "accepted" } else { "rejected" }, name[0]);
                    decided.push(at);
                    at += 1;
                }
            }
            Key::Skip => at += 1,
            Key::Back => at = at.saturating_sub(1),
            Key::Undo => match decided.pop() {
                None => println!("nothing was decided"),
                Some(last) => {
                    let said = review.undo(std::slice::from_ref(&all[last].name));
                    screen.say(&said);
                    if said.is_empty() {
                        println!("taken back: {}", all[last].name);
                    }
                    (at, is_shown) = (last, false);
                }
            },
            Key::Help => screen.say(&MORE_HELP),
            Key::Quit => return Ok(()),
            Key::Other => {}
        }
        is_shown = is_shown && at == before;
    }
    Ok(())
}

/// What can be shown.
struct Screen {
    columns: usize,
    rows: usize,
    ink: Ink,
}

impl Screen {
    /// Rows that are kept for words.
    const WORDS: usize = 11;

    /// The terminal's, or what `COLUMNS` says where there is none.
    fn here() -> Self {
        const USUAL: (u16, u16) = (24, 80);
        let asked = std::env::var("COLUMNS").ok().and_then(|columns| columns.parse().ok());
        let (rows, columns) =
            console::Term::stdout().size_checked().unwrap_or((USUAL.0, asked.unwrap_or(USUAL.1)));
        let ink = if console::colors_enabled() { Ink::Colors } else { Ink::Letters };
        Self { columns: usize::from(columns), rows: usize::from(rows), ink }
    }

    /// Everything there is to see of an outcome.
    fn show(
        &self,
        suite: &Suite,
        review: &Review,
        outcome: &Outcome,
        (at, count): (usize, usize),
        reader: &Reader,
    ) -> String {
        let Outcome { name, verdict, .. } = outcome;
        let decision = match review.decision(name) {
            Some(Decision::Accepted) => ", accepted",
            Some(Decision::Rejected) => ", rejected",
            None => "",
        };
        let head = format!("[{}/{count}] {name}: {}{decision}", at + 1, verdict.words());
        let mut lines = wrap(&head, self.columns);
        lines.extend(self.pictures(suite, outcome));
        for part in outcome_parts(outcome, reader) {
            lines.extend(wrap(&part, self.columns));
        }
        if outcome.breaks_its_word() {
            lines.push("cannot be accepted".to_owned());
        } else if let Some(why) = review.why_not(name) {
            lines.extend(wrap(&format!("cannot be accepted: {why}"), self.columns));
        }
        lines.extend(wrap(HELP, self.columns));
        lines.join("\n")
    }

    /// Golden, difference and actual, as far as there are such.
    fn pictures(&self, suite: &Suite, outcome: &Outcome) -> Vec<String> {
        let golden = find_golden(&suite.golden_path(&outcome.name));
        let golden = golden.picture();
        let actual = outcome.evidence.as_ref().and_then(|e| from_png(&e.actual).ok());
        let actual = actual.map(|file| file.picture);
        let difference = golden.zip(actual.as_ref()).and_then(|(g, a)| difference(g, a));
        let panel = |name, is_difference| move |picture| Panel { name, picture, is_difference };
        let all = [
            golden.map(panel("golden", false)),
            difference.as_ref().map(panel("difference", true)),
            actual.as_ref().map(panel("actual", false)),
        ];
        let all: Vec<_> = all.into_iter().flatten().collect();
        let rows = self.rows.saturating_sub(Self::WORDS).max(Self::WORDS);
        side_by_side(&all, self.columns, rows, self.ink)
    }

    fn say(&self, said: &[impl AsRef<str>]) {
        for line in said.iter().flat_map(|said| wrap(said.as_ref(), self.columns)) {
            println!("{line}");
        }
    }
}
