//! `write`: everything that is made of a scorecard, into a folder.

use std::path::{Path, PathBuf};

use harness::store::{self, StoreError};

use super::badge::is_badge;
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

/// What the file for machines is called.
const DOCUMENT: &str = "scorecard.json";

/// The largest of an earlier card that is read, in bytes.
const MAX_BYTES: u64 = 256 << 20;

/// What the files of a card of renderers with these ids are called.
pub fn file_names<'a>(ids: impl Iterator<Item = &'a str>) -> Vec<String> {
    let whole = [DOCUMENT, "scorecard.md", "scorecard.html"].map(str::to_owned);
    whole.into_iter().chain(ids.map(badge_name)).collect()
}

fn badge_name(id: &str) -> String {
    format!("badge-{id}.svg")
}

/// Writes `scorecard.json`, `scorecard.md`, `scorecard.html` and a `badge-ID.svg` for
/// each renderer into `folder`; `selection` is the part of the suite that was asked
/// for, if it was not all. What is there already is written over, and badges that an
/// earlier card made of renderers that are not in this one are removed. The card, and
/// the files that were written.
///
/// # Errors
/// Runs that make no card, before anything is written; and the first file that cannot
/// be written or removed.
pub fn write(
    folder: &Path,
    (runs, selection): (&[Conformed], Option<Selection>),
    look: &Look<'_>,
) -> Result<(Card, Vec<PathBuf>), WriteError> {
    let card = Card::of(runs, look).map_err(WriteError::NoCard)?.of_part(selection);
    let mut texts = vec![format!("{:#}\n", json(&card)), markdown(&card), html(&card, runs)];
    texts.extend(card.renderers.iter().map(|column| badge(column, card.selection.as_ref())));
    // Before the earlier card is written over, which says what they are.
    remove_badges(folder, &card).map_err(WriteError::Store)?;
    let mut written = Vec::new();
    for (name, text) in file_names(card.ids()).into_iter().zip(texts) {
        let path = folder.join(name);
        store::write(&path, text.as_bytes()).map_err(WriteError::Store)?;
        written.push(path);
    }
    Ok((card, written))
}

/// Removes the badges of renderers that the card in this folder has and this one has
/// not. A file is only taken for one if that card names its renderer, and it begins as
/// badges do: others of such names are a stranger's.
///
/// # Errors
/// A badge that cannot be removed.
fn remove_badges(folder: &Path, card: &Card) -> Result<(), StoreError> {
    let Ok(Some(bytes)) = store::read(&folder.join(DOCUMENT), MAX_BYTES) else { return Ok(()) };
    // What is no card has made no badges.
    let earlier: serde_json::Value = serde_json::from_slice(&bytes).unwrap_or_default();
    let renderers = earlier["renderers"].as_array().map_or(&[][..], Vec::as_slice);
    for id in renderers.iter().filter_map(|renderer| renderer["id"].as_str()) {
        // Some systems do not tell upper from lower case in names of files.
        let is_here = card.ids().any(|here| here.eq_ignore_ascii_case(id));
        if is_here || !super::is_id(id) {
            continue;
        }
        let path = folder.join(badge_name(id));
        let found = store::read(&path, MAX_BYTES).ok().flatten();
        if found.is_some_and(|found| is_badge(&found)) {
            store::remove(&path)?;
        }
    }
    Ok(())
}
