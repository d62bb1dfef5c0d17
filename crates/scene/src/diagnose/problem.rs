//! A problem with its place in the text.

use ron::error::{Position, SpannedError};

/// A range of bytes of the text, both ends on character boundaries.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Span {
    /// The first byte.
    pub start: usize,
    /// The byte after the last one.
    pub end: usize,
}

impl Span {
    pub(super) fn new(start: usize, end: usize) -> Self {
        Self { start, end }
    }

    pub(super) fn contains(self, other: Self) -> bool {
        self.start <= other.start && other.end <= self.end
    }

    /// The bytes of `text` in this range; empty if there are none.
    pub(super) fn of(self, text: &str) -> &str {
        text.get(self.start..self.end).unwrap_or_default()
    }
}

/// Something that is wrong with a text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Problem {
    /// Where it is.
    pub span: Span,
    /// What is wrong, what was expected, what was found: one sentence without a full stop.
    pub message: String,
    /// How it might be put right.
    pub help: Option<String>,
}

impl Problem {
    pub(super) fn new(span: Span, message: impl Into<String>) -> Self {
        Self { span, message: message.into(), help: None }
    }

    pub(super) fn with_help(mut self, help: impl Into<String>) -> Self {
        self.help = Some(help.into());
        self
    }

    /// The first error that `ron` found.
    pub(super) fn from_ron(text: &str, error: &SpannedError) -> Self {
        let start = offset(text, error.span.start);
        let end = offset(text, error.span.end).max(start);
        Self::new(Span::new(start, end), error.code.to_string())
    }
}

/// Stands for the problems beyond those that are listed.
pub(super) const NOT_LISTED: &str = "further problems are not listed";

/// Nobody reads more.
const MOST_LISTED: usize = 1_000;

/// Sorts by place; drops what is said twice, and what is too much.
pub(super) fn arrange(problems: &mut Vec<Problem>) {
    problems.sort_by(|a, b| (a.span, &a.message).cmp(&(b.span, &b.message)));
    problems.dedup_by(|a, b| a.span == b.span && a.message == b.message);
    if let Some(first) = problems.get(MOST_LISTED) {
        let last = Problem::new(first.span, NOT_LISTED);
        problems.truncate(MOST_LISTED);
        problems.push(last);
    }
}

/// Line and column of a byte of `text`, both counted from 1; columns count characters.
///
/// A byte past the end has the place of the end.
pub fn line_column(text: &str, byte: usize) -> (usize, usize) {
    let before = &text[..text.floor_char_boundary(byte)];
    let line_start = before.rfind('\n').map_or(0, |newline| newline + 1);
    (before.matches('\n').count() + 1, before[line_start..].chars().count() + 1)
}

/// The byte of a line and column as `ron` counts them; the end of `text` if it has no such place.
pub(super) fn offset(text: &str, position: Position) -> usize {
    let lines = text.split_inclusive('\n').take(position.line.saturating_sub(1));
    let line_start: usize = lines.map(str::len).sum();
    let line = &text[line_start..];
    let column = line.char_indices().nth(position.col.saturating_sub(1));
    line_start + column.map_or(line.len(), |(byte, _)| byte)
}
