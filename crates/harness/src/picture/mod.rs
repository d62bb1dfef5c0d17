//! Pictures for people: what a failure looks like, and all goldens at a
//! glance.

mod canvas;
mod contact_sheet;
mod heat_map;
mod strip;

pub use contact_sheet::contact_sheet;
pub use heat_map::{Heat, heat_map};
pub use strip::{HEAT, difference, strip, strip_of};
