//! Every problem of a scene file at once, each with its place.
//!
//! `ron` alone decides whether a file is good, and it stops at the first error. For a file that it
//! refuses, [`diagnose`] reads the text again into a [`Tree`] that tolerates mistakes, then runs
//! the type's own `Deserialize` over that tree, records each error, and goes on with a stand-in for
//! the value that was wrong.
//!
//! ```text
//! text -> lexer -> brackets -> parser -> Tree -> recover -> problems
//! ```
//!
//! One mistake should give one problem: what a reported mistake makes unreadable stays silent.

mod brackets;
mod lexer;
mod literal;
mod locate;
mod parser;
mod problem;
mod recover;
mod tree;
mod words;

#[cfg(test)]
mod tests;

use serde::de::DeserializeOwned;

pub use locate::Step;
pub use problem::{Problem, Span, line_column};
pub(crate) use tree::Tree;
pub use words::nearest;

use locate::Reach;
use recover::Recovered;

/// What could be learned about a text that should be a `T`.
#[derive(Debug)]
pub(crate) struct Diagnosis<T> {
    /// The value, with stand-ins where the text was wrong; `None` where no stand-in would do.
    pub value: Option<T>,
    /// The text as it was understood.
    pub tree: Tree,
    /// The problems by place; empty exactly where `ron` accepts the text.
    pub problems: Vec<Problem>,
    doubts: recover::Doubts,
}

impl<T> Diagnosis<T> {
    /// Whether what `value` holds at `path` may be a stand-in, or has a problem at or inside it.
    ///
    /// A check on the meaning of such a value would only repeat a problem that is listed already.
    pub(crate) fn is_doubtful(&self, path: &[Step]) -> bool {
        if self.value.is_none() {
            return true;
        }
        let (trail, reach) = self.tree.follow(path);
        if trail.iter().any(|node| self.doubts.is_stand_in(node)) {
            return true;
        }
        let Some(last) = trail.last() else {
            return true;
        };
        match reach {
            Reach::Value => self.problems.iter().any(|problem| last.span.contains(problem.span)),
            Reach::LeftOut(name) => last.lossy || self.doubts.is_injected(last, name),
        }
    }
}

/// The way this project reads RON: `ron` with the extensions that save parentheses.
pub(crate) fn ron_options() -> ron::Options {
    use ron::extensions::Extensions;
    ron::Options::default()
        .with_default_extension(Extensions::IMPLICIT_SOME)
        .with_default_extension(Extensions::UNWRAP_NEWTYPES)
        .with_default_extension(Extensions::UNWRAP_VARIANT_NEWTYPES)
}

/// Reads `text` as a `T`, and lists everything that is wrong with it.
///
/// A text that `ron` accepts has no problems; any other has at least one.
pub(crate) fn diagnose<T: DeserializeOwned>(text: &str) -> Diagnosis<T> {
    let mut diagnosis = examine(text);
    if diagnosis.problems.is_empty() {
        // `ron` has the last word, should the tolerant reader ever be too tolerant.
        match ron_options().from_str::<T>(text) {
            Ok(value) => diagnosis.value = Some(value),
            Err(error) => diagnosis.problems.push(Problem::from_ron(text, &error)),
        }
    }
    diagnosis
}

/// [`diagnose`] without asking `ron`, so that tests can compare the two.
fn examine<T: DeserializeOwned>(text: &str) -> Diagnosis<T> {
    let (mut tree, mut problems) = Tree::read(text);
    let Recovered { value, problems: found, doubts, excused } = recover::recover(text, &mut tree);
    problems.retain(|problem| !excused.contains(&problem.span));
    problems.extend(found);
    problem::arrange(&mut problems);
    Diagnosis { value, tree, problems, doubts }
}
