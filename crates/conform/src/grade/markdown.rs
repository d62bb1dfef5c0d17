//! `markdown`: a grade as a page of Markdown.

use std::fmt::Write as _;

use harness::report::{markdown_code as code, markdown_text as prose};

use super::{Grade, Mark, Per};
use crate::{Outcome, outcome};

/// The grade in words. What a rubric, a fixture or a renderer says is shown as it is
/// written.
pub fn markdown(grade: &Grade) -> String {
    let version = grade.renderer.version.lines().next().unwrap_or_default();
    let version = if version.is_empty() { String::new() } else { format!(" ({version})") };
    let mut page = format!(
        "# {}: {} of {} points\n\n{}\n\n| part | points | of | pass | how |\n|---|---|---|---|---|\n",
        prose(&grade.title),
        grade.points,
        grade.of,
        prose(&format!("{}{version}, held to {}", grade.renderer.name, grade.held_to)),
    );
    for mark in &grade.marks {
        let how = match mark.per {
            Per::Share => "as many as pass",
            Per::All => "all or nothing",
        };
        // Writing to a String cannot fail.
        let _ = writeln!(
            page,
            "| {} | {} | {} | {} of {} | {how} |",
            prose(&mark.name),
            mark.points,
            mark.of,
            mark.passed(),
            mark.fixtures.len()
        );
    }
    for deduction in &grade.deductions {
        let count = deduction.fixtures.len();
        let minus = if deduction.fixtures.is_empty() {
            "0".to_owned()
        } else {
            format!("−{}", deduction.points)
        };
        let _ =
            writeln!(page, "| {} | {minus} | | {count} found | penalty |", prose(&deduction.name));
    }
    for mark in &grade.marks {
        page += &lost(mark);
    }
    for (names, words) in
        [(&grade.unasked, "No part asks for"), (&grade.shared, "Several parts ask for")]
    {
        if !names.is_empty() {
            let names: Vec<_> = names.iter().map(|name| code(name)).collect();
            let _ = writeln!(page, "\n{words}: {}.", names.join(", "));
        }
    }
    page
}

/// What a part lost points for.
fn lost(mark: &Mark) -> String {
    let mut rest = mark.fixtures.iter().filter(|(_, o)| *o != Some(Outcome::Pass)).peekable();
    if rest.peek().is_none() {
        return String::new();
    }
    let mut text = format!("\n## {}\n\n", prose(&mark.name));
    for (name, outcome) in rest {
        let words = outcome.map_or("was not run", outcome::words);
        let _ = writeln!(text, "- {}: {words}", code(name));
    }
    text
}
