//! Other people's renderers under test.
//!
//! ```text
//! fixture -> interchange::export -> scratch folder -> the renderer -> picture
//!                                                                       |
//! goldray's own picture, its edges, golden, expectations -> judge -> FixtureResult
//!                                                                       |
//!                                    scorecard, badge, consensus, grade <+
//! ```
//!
//! A renderer that crashes, hangs or writes garbage is an [`Outcome`], never an
//! `Err`. Files are opened by the store of the harness; nothing is printed.

pub mod adapter;
mod asks;
pub mod card;
pub mod consensus;
pub mod grade;
pub mod judge;
mod objects;
pub mod outcome;
mod page;
mod pictures;
pub mod process;
pub mod result;
pub mod run;
mod scale;
pub mod trial;
mod xml;

pub use asks::asks;
pub use objects::{Objects, Seen, objects_of};
pub use result::{Conformed, Evidence, FixtureResult, Numbers, Outcome, RendererInfo, Run};
