//! Seeded faults: what a suite notices of the mistakes that renderers are known
//! to make.
//!
//! ```text
//! Fault x fixture -> Trial -> Row -> Matrix -> text, JSON, floor
//! ```
//!
//! [`tracer::fault`] has the mistakes. Only a build with the feature `faults`
//! can make them: a [`Trial`] is held in one, and everything after that is
//! numbers.

mod floor;
mod matrix;
mod report;
mod trial;

pub use floor::{FLOOR, Fall, Floor, Kills, falls, read_floor, write_floor};
pub use matrix::{Matrix, Row, Status};
pub use report::{json, markdown, text};
pub use tracer::fault::Fault;
pub use trial::{Evidence, Fate, Trial};
#[cfg(feature = "faults")]
pub use trial::{not_matching, try_fault};
