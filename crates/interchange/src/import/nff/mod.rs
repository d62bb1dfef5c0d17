//! NFF, the Neutral File Format of the Standard Procedural Databases.
//!
//! Source: E. Haines, "A Proposal for Standard Graphics Environments", 1987, and
//! the description of the format that comes with its programs. Where it leaves
//! something open, `docs/import.md` says what is done, and the import says so
//! again.

mod fill;
mod polygons;
mod reader;
mod shapes;
#[cfg(test)]
mod tests;
mod view;
mod words;

use scene::Assets;

use super::{Imported, Source, Unreadable, Wishes, text::Text};
use reader::Reader;

/// Reads an NFF file.
///
/// # Errors
/// Every reason why it is none.
pub(super) fn read(
    source: Source<'_>,
    wishes: &Wishes,
    _: &dyn Assets,
) -> Result<Imported, Vec<Unreadable>> {
    let text = Text::of(source.bytes).map_err(|problem| vec![problem])?;
    Reader::new(&text, source.name)?.scene(wishes)
}
