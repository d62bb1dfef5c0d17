//! What a run says: to people, a line each or a page; to machines, JSON; to
//! build servers what they show of it.

mod github;
mod json;
mod junit;
mod markdown;
pub mod page;
mod summary;
mod text;
mod worst;

pub use github::annotations;
pub(crate) use json::{blamed, distances};
pub use json::{comparison_json, metrics_json, run_json};
pub use junit::junit;
pub use markdown::{code as markdown_code, markdown, prose as markdown_text};
pub use summary::{Summary, summarize};
pub use text::{
    Reader, brief_line, comparison_lines, full_line, numbers, outcome_line, outcome_parts,
};
