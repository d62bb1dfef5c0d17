//! `write`: everything that is made of a scorecard, into a folder.

use std::path::{Path, PathBuf};

use harness::store::{self, StoreError};

use super::{Card, Look, NoCard, Selection, badge, html, json, markdown};
use crate::Conformed;

/// Why there are no files.
#[derive(Debug)]
pub enum WriteError {
    /// The runs make no card.
    NoCard(NoCard),
    /// A file cannot be written.
    Store(StoreError),
}

impl std::fmt::Display for WriteError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::NoCard(why) => why.fmt(f),
            Self::Store(why) => why.fmt(f),
        }
    }
}

impl std::error::Error for WriteError {}

/// Writes `scorecard.json`, `scorecard.md`, `scorecard.html` and a `badge-ID.svg` for
/// each renderer into `folder`; `selection` is the part of the suite that was asked
/// for, if it was not all. What is there already is written over. The card, and
/// the files that were written.
///
/// # Errors
/// Runs that make no card, before anything is written; and the first file that cannot
/// be written.
pub fn write(
    folder: &Path,
    (runs, selection): (&[Conformed], Option<Selection>),
    look: &Look<'_>,
) -> Result<(Card, Vec<PathBuf>), WriteError> {
    let card = Card::of(runs, look).map_err(WriteError::NoCard)?.of_part(selection);
    let mut files = vec![
        ("scorecard.json".to_owned(), format!("{:#}\n", json(&card))),
        ("scorecard.md".to_owned(), markdown(&card)),
        ("scorecard.html".to_owned(), html(&card, runs)),
    ];
    files.extend(card.renderers.iter().map(|column| {
        (format!("badge-{}.svg", column.info.id), badge(column, card.selection.as_ref()))
    }));
    let mut written = Vec::new();
    for (name, text) in files {
        let path = folder.join(name);
        store::write(&path, text.as_bytes()).map_err(WriteError::Store)?;
        written.push(path);
    }
    Ok((card, written))
}
