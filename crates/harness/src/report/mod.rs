//! What a run says: to people, a line each or a page; to machines, JSON.

mod json;
pub mod page;
mod text;

pub(crate) use json::{blamed, distances};
pub use json::{comparison_json, metrics_json, run_json};
pub use text::{
    Reader, Summary, comparison_lines, numbers, outcome_line, outcome_parts, summarize,
};
