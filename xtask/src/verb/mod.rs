//! The verbs, one file each.

pub(crate) mod bench;
pub(crate) mod bless;
pub(crate) mod calibrate;
pub(crate) mod check;
pub(crate) mod compare;
pub(crate) mod completions;
pub(crate) mod conform;
pub(crate) mod contact_sheet;
pub(crate) mod digest;
pub(crate) mod elsewhere;
pub(crate) mod grade;
pub(crate) mod import;
pub(crate) mod lint;
pub(crate) mod list;
pub(crate) mod meshes;
pub(crate) mod minimize;
pub(crate) mod new;
pub(crate) mod reference;
pub(crate) mod render;
pub(crate) mod review;
pub(crate) mod sensitivity;
pub(crate) mod watch;
