//! `html`: the page of a grade, one file that needs nothing else.
//!
//! `id="grade"` has what [`json`](super::json()) tells; the rest is that of a scorecard
//! of the one run, from which results with their pictures are shown.

use harness::report::page::shell::put;

use super::{Grade, json};
use crate::Conformed;
use crate::card::{Card, Look, NoCard, grade_html};

/// The page of a grade of this run.
///
/// # Errors
/// A renderer with an id that is none.
pub fn html(grade: &Grade, conformed: &Conformed, look: &Look<'_>) -> Result<String, NoCard> {
    let runs = std::slice::from_ref(conformed);
    let card = Card::of(runs, look)?;
    let mut more = String::new();
    put(&mut more, "grade", &json(grade));
    let title = format!(
        "{}: {}: {} of {} points",
        grade.title, grade.renderer.name, grade.points, grade.of
    );
    Ok(grade_html(&card, runs, &title, &more, include_str!("overview.js")))
}
