//! `markdown`: a grade as a page of Markdown.

use std::fmt::Write as _;

use harness::report::{markdown_code as code, markdown_text as prose};

use super::{Deduction, Grade, Mark, Per};
use crate::{Conformed, Outcome, outcome};

/// The grade in words, with why points are lost in this run. What a rubric, a fixture or
/// a renderer says is shown as it is written.
pub fn markdown(grade: &Grade, conformed: &Conformed) -> String {
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
        page += &lost(mark, conformed);
    }
    for deduction in grade.deductions.iter().filter(|one| !one.fixtures.is_empty()) {
        page += &taken(deduction, conformed);
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
fn lost(mark: &Mark, conformed: &Conformed) -> String {
    let mut rest = mark.fixtures.iter().filter(|(_, o)| *o != Some(Outcome::Pass)).peekable();
    if rest.peek().is_none() {
        return String::new();
    }
    let name = prose(&mark.name);
    let mut text = format!("\n## {name}: {} of {} points\n\n", mark.points, mark.of);
    for (name, outcome) in rest {
        let words = outcome.map_or("was not run", outcome::words);
        // Writing to a String cannot fail.
        let _ = writeln!(text, "- {}: {words}{}", code(name), why(name, conformed));
    }
    text
}

/// What a penalty takes points for.
fn taken(deduction: &Deduction, conformed: &Conformed) -> String {
    let Deduction { name, points, fixtures } = deduction;
    let mut text = format!("\n## {}: −{points} points\n\n", prose(name));
    for (name, outcome) in fixtures {
        let words = outcome::words(*outcome);
        let _ = writeln!(text, "- {}: {words}{}", code(name), why(name, conformed));
    }
    text
}

/// The reasons of a result, each in its line, and the name of its picture beside this
/// page; nothing for a fixture that was not run.
fn why(name: &str, conformed: &Conformed) -> String {
    let run = &conformed.run;
    let findings = run.fixtures.get(name).map_or(&[][..], |result| &result.findings);
    let mut lines: Vec<_> = findings.iter().map(|finding| prose(finding)).collect();
    // Where there is a picture, it is kept beside goldray's.
    if conformed.evidence.contains_key(name) {
        let strip = format!("{}/{name}.png", run.renderer.id);
        lines.push(format!("reference, difference and picture: {}", code(&strip)));
    }
    let list = |text: String, line: &String| text + "\n  - " + line;
    lines.iter().fold(String::new(), list)
}
