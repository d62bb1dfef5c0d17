//! The frame of the pages of this crate: a scorecard, a grade. It may reach nothing.

use harness::report::page::shell::{SCRIPTS, STYLE, fill};

use crate::xml;

const PAGE: &str = include_str!("page.html");

const OWN_STYLE: &str = include_str!("style.css");

/// A page of a kind: `title` is text, `data` the script elements with its JSON,
/// `scripts` what it does, beside what all pages share.
pub(crate) fn page(kind: &str, title: &str, data: &str, scripts: &[&str]) -> String {
    let scripts: Vec<&str> = SCRIPTS.iter().chain(scripts).copied().collect();
    let framed = PAGE.replace("<!--KIND-->", kind);
    fill(&framed, &xml::text(title), &[STYLE, OWN_STYLE], data, &scripts)
}
