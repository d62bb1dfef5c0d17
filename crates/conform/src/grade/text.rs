//! A plan and a grade in lines, for people at a terminal.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use scene::visible;

use super::{Grade, Plan};
use crate::card::counted;

/// What each part of a plan is about, and which of its fixtures the adapter rules out:
/// `ruled_out` has them by name, with the reason.
pub fn plan_lines(plan: &Plan, ruled_out: &BTreeMap<String, String>) -> String {
    let mut text = format!("{}\n", visible(&plan.rubric.title));
    // Writing to a String cannot fail.
    for (part, asked) in plan.rubric.parts.iter().zip(&plan.parts) {
        let (points, name) = (asked.points.to_string(), visible(&part.name));
        let _ = writeln!(text, "{points:>8}  {name}: {}", list(asked.fixtures.iter()));
        let out = asked.fixtures.iter().filter_map(|name| Some((name, ruled_out.get(name)?)));
        let out: Vec<_> = out.map(|(name, why)| format!("{name} ({})", visible(why))).collect();
        if !out.is_empty() {
            let are = if out.len() == 1 { "is" } else { "are" };
            let (count, all, out) = (out.len(), asked.fixtures.len(), out.join(", "));
            let _ =
                writeln!(text, "{:>8}  {count} of {all} {are} ruled out by the adapter: {out}", "");
        }
    }
    for (penalty, asked) in plan.rubric.penalties.iter().zip(&plan.penalties) {
        let (points, name) = (format!("-{}", asked.points), visible(&penalty.name));
        let of = counted(asked.fixtures.len() as u64, "fixture", "fixtures");
        let _ = writeln!(text, "{points:>8}  {name}: of {of}");
    }
    text + &notes(&plan.unasked, &plan.shared)
}

/// The points of each part, and all of them last.
pub fn grade_lines(grade: &Grade) -> String {
    let mut text = String::new();
    for mark in &grade.marks {
        let (points, of) = (mark.points.to_string(), mark.of.to_string());
        let (name, all) = (visible(&mark.name), mark.fixtures.len());
        let _ = writeln!(text, "{points:>8} of {of:<8} {name}: {} of {all} pass", mark.passed());
    }
    for one in grade.deductions.iter().filter(|one| !one.fixtures.is_empty()) {
        let (points, name) = (format!("-{}", one.points), visible(&one.name));
        let fixtures = list(one.fixtures.iter().map(|(name, _)| name));
        let _ = writeln!(text, "{points:>8} {:11} {name}: {fixtures}", "");
    }
    let (points, of) = (grade.points.to_string(), grade.of.to_string());
    let _ = writeln!(text, "{points:>8} of {of:<8} {}", visible(&grade.title));
    text + &notes(&grade.unasked, &grade.shared)
}

fn list<'a>(names: impl Iterator<Item = &'a String>) -> String {
    names.map(String::as_str).collect::<Vec<_>>().join(", ")
}

fn notes(unasked: &[String], shared: &[String]) -> String {
    let mut text = String::new();
    for (names, words) in [(unasked, "no part asks for"), (shared, "several parts ask for")] {
        if !names.is_empty() {
            let _ = writeln!(text, "{words}: {}", list(names.iter()));
        }
    }
    text
}
