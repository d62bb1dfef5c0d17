//! `report`: problems as text for people.

use std::fmt::Write;

use crate::Problem;
use crate::visible::{is_invisible, visible};

/// The problems of the file `name`, one after the other, each as
/// `name:line:column: message`, the line it is in with the place marked, and
/// its help.
///
/// ```
/// let problem = scene::Problem {
///     span: scene::Span { start: 2, end: 5 },
///     message: "expected a number, found `abc`".to_owned(),
///     help: None,
/// };
/// assert_eq!(
///     scene::report("a.ron", "( abc )", &[problem]),
///     "a.ron:1:3: expected a number, found `abc`\n  1 | ( abc )\n    |   ^^^\n",
/// );
/// ```
pub fn report(name: &str, text: &str, problems: &[Problem]) -> String {
    let mut out = String::new();
    // Found once: a large file may have many problems.
    let line_ends = text.match_indices('\n').map(|(byte, _)| byte + 1);
    let line_starts: Vec<usize> = std::iter::once(0).chain(line_ends).collect();
    for Problem { span, message, help } in problems {
        let line_number = line_starts.partition_point(|&start| start <= span.start);
        let line_start = line_starts[line_number - 1];
        let column =
            text.get(line_start..span.start).map_or(0, |before| before.chars().count()) + 1;
        let line = text[line_start..].lines().next().unwrap_or("");
        let marked = text
            .get(span.start..span.end)
            .and_then(|marked| marked.lines().next())
            .map_or(1, |marked| marked.chars().take(EXCERPT).count().max(1));
        let (line, column_shown) = excerpt(line, column);
        let marks = "^".repeat(marked.min(EXCERPT + 1 - column_shown.min(EXCERPT)));
        let gutter = line_number.to_string();
        let empty = " ".repeat(gutter.len());
        let indent = " ".repeat(column_shown - 1);
        // Writing to a String cannot fail.
        let _ = writeln!(out, "{name}:{line_number}:{column}: {}", visible(message));
        let _ = writeln!(out, "  {gutter} | {line}");
        let _ = writeln!(out, "  {empty} | {indent}{marks}");
        if let Some(help) = help {
            let _ = writeln!(out, "  {empty} = help: {}", visible(help));
        }
    }
    out
}

/// The most characters of a line that are shown.
const EXCERPT: usize = 100;

/// A line that is too long cut to what surrounds `column`, with the column in
/// what is left; what is not seen itself becomes spaces so that the mark lines up.
fn excerpt(line: &str, column: usize) -> (String, usize) {
    const BEFORE: usize = 40;
    let plain = |c: char| if is_invisible(c) { ' ' } else { c };
    let is_long = line.chars().nth(EXCERPT).is_some();
    let skipped = if is_long { column.saturating_sub(BEFORE) } else { 0 };
    let shown = line.chars().skip(skipped).take(EXCERPT).map(plain).collect::<String>();
    (shown.trim_end().to_owned(), column - skipped)
}
