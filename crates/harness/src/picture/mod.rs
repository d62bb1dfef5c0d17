//! Pictures for people: what a failure looks like, and all goldens at a
//! glance.

mod canvas;
mod contact_sheet;
mod strip;

pub use contact_sheet::contact_sheet;
pub use strip::strip;
