//! The page's text, style and script, as they are in their files.

/// The page, with a place for the title, the style, the data and the script.
pub(super) const PAGE: &str = include_str!("page.html");

/// How it looks.
pub(super) const STYLE: &str = include_str!("style.css");

/// What it does: parts of one function, in this order.
pub(super) const SCRIPTS: &[&str] = &[];
