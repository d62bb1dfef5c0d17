//! Sensitivity: the smallest damage of each kind that would be noticed, fixture
//! by fixture.
//!
//! A golden is damaged and judged in the picture's place, by the fixture's own
//! limits. Expectations are left out: they are about linear pictures, of which
//! a golden has none, and can only catch more.

mod defect;
mod measure;
mod summary;
mod text;
mod visible;

pub use defect::{DEFECTS, Defect, Place, Strengths};
pub use measure::{Cell, Row, Smallest, of_cases};
pub use summary::{OfDefect, Summary, summarize};
pub use text::{fixture_lines, json, markdown, number, summary_lines, with_unit};
pub use visible::{Miss, Visible, missed};
