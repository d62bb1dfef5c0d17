//! goldray's harness: fixtures in, verdicts out.
//!
//! ```text
//! fixtures/x.ron -> Fixture -> Rendered -> judge -> Outcome -> report
//!                                            ^
//!                           golden/x.png -> Golden
//! ```
//!
//! A mismatch is a value here, never an `Err`. One file, [`store`], opens
//! files. Nothing is printed, and no flag, terminal or exit code is known:
//! that is `xtask`'s.

mod apart;
pub mod blame;
pub mod bless;
pub mod block;
pub mod calibrate;
pub mod called;
pub mod case;
pub mod check;
pub mod counts;
pub mod digest;
pub mod distance;
pub mod encode;
pub mod evidence;
pub mod expectation;
pub mod faults;
pub mod filter;
pub mod fixture;
pub mod golden;
mod hash;
pub mod judge;
pub mod last_failed;
mod lfs;
pub mod limits;
pub mod lint;
pub mod metric;
pub mod minimize;
pub mod overrides;
pub mod picture;
pub mod picture_file;
mod place;
pub mod recheck;
mod record;
pub mod relation;
pub mod repack;
pub mod report;
pub mod review;
pub mod run;
pub mod sample_mesh;
pub mod sensitivity;
pub mod slow;
pub mod stamps;
pub mod steady;
pub mod store;
pub mod suite;
pub mod template;
pub mod verdict;
