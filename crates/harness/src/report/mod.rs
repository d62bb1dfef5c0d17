//! What a run says: to people, a line each; to machines, JSON.

mod json;
mod text;

pub(crate) use json::{blamed, distances};
pub use json::{comparison_json, run_json};
pub use text::{Reader, Summary, comparison_lines, numbers, outcome_line, summarize};
