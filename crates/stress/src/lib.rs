//! goldray's stress suite: the tracer's answers held against an exact oracle.
//!
//! - [`number`]: the oracle's arithmetic, twice the digits of `f64` for volume
//!   and any number of them for the arbiter;
//! - [`truth`]: what the exact answers are, written once for both;
//! - [`subject`]: what is asked of each primitive, family by family;
//! - [`matrix`]: runs families over millions of seeded cases and adds up;
//! - [`kernel`]: the textbook's and other people's formulas, to compare with;
//! - [`mod@bench`]: time against error;
//! - [`table`]: the result as rows, for people and machines;
//! - [`kept`]: cases that once failed, replayed ever after.
//!
//! For development only: nothing that renders depends on this crate. It prints
//! nothing and opens no files.

pub mod bench;
pub mod case;
pub mod family;
pub mod kept;
pub mod kernel;
pub mod known;
pub mod matrix;
pub mod meshes;
pub mod metric;
pub mod number;
pub mod random;
pub mod subject;
pub mod table;
pub mod tally;
pub mod truth;

pub use case::Case;
pub use family::{Family, Kernel, Volume};
pub use metric::Metric;
pub use random::Random;
pub use tally::Tally;
