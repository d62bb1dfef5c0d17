//! `json`: a grade for machines, by `docs/schemas/grade.schema.json`.

use serde_json::{Value, json};

use super::{Deduction, Grade, Mark, Per};
use crate::outcome;

/// The grade as a document: what `grade.json` holds.
pub fn json(grade: &Grade) -> Value {
    json!({
        "schema": 1,
        "title": grade.title,
        "renderer": {
            "id": grade.renderer.id,
            "name": grade.renderer.name,
            "version": grade.renderer.version,
        },
        "held_to": grade.held_to,
        "points": grade.points.value(),
        "of": grade.of.value(),
        "parts": grade.marks.iter().map(mark).collect::<Vec<_>>(),
        "penalties": grade.deductions.iter().map(deduction).collect::<Vec<_>>(),
        "unasked": grade.unasked,
        "shared": grade.shared,
    })
}

/// A fixture that was not run has no outcome.
fn mark(mark: &Mark) -> Value {
    let fixture = |(name, outcome): &(String, Option<crate::Outcome>)| json!({ "name": name, "outcome": outcome.map(outcome::id) });
    json!({
        "name": mark.name,
        "per": match mark.per { Per::Share => "share", Per::All => "all" },
        "points": mark.points.value(),
        "of": mark.of.value(),
        "passed": mark.passed(),
        "fixtures": mark.fixtures.iter().map(fixture).collect::<Vec<_>>(),
    })
}

fn deduction(deduction: &Deduction) -> Value {
    let fixture = |(name, outcome): &(String, crate::Outcome)| json!({ "name": name, "outcome": outcome::id(*outcome) });
    json!({
        "name": deduction.name,
        "points": deduction.points.value(),
        "fixtures": deduction.fixtures.iter().map(fixture).collect::<Vec<_>>(),
    })
}
