//! STL, text or binary: one mesh of all its facets.
//!
//! Corners with the same coordinates are one, so that a closed surface is closed.
//! A facet's normal is that of its corners' order; what the file says of it is
//! only held against that.

mod binary;
mod facets;
mod text;

#[cfg(test)]
pub(super) mod tests;

use scene::Assets;

use super::mesh::stage::Stage;
use super::{Imported, Source, Unreadable, Wishes};
use facets::Facets;

/// Reads an STL file.
///
/// # Errors
/// What is neither form of it, and numbers that are none.
pub(super) fn read(
    source: Source<'_>,
    wishes: &Wishes,
    _: &dyn Assets,
) -> Result<Imported, Vec<Unreadable>> {
    let mut stage = Stage::default();
    let mut facets = Facets::default();
    // A binary file may start with the word that text starts with. Its size
    // tells.
    if binary::has_its_size(source.bytes) || !text::starts(source.bytes) {
        binary::read(source.bytes, &mut facets, &mut stage).map_err(|error| vec![error])?;
    } else {
        text::read(source.bytes, &mut facets, &mut stage).map_err(|mut error| {
            if source.bytes.contains(&0) {
                error.help = binary::sizes(source.bytes).map(|sizes| {
                    format!("if it is a binary file that starts with \"solid\": {sizes}")
                });
            }
            vec![error]
        })?;
    }
    if facets.against > 0 {
        stage.lost.add(
            None,
            "facet normals",
            format!(
                "{} of them point to the other side than the order of corners, which counts",
                facets.against
            ),
        );
    }
    let part = facets.welded();
    stage.parts.push((part, None));
    stage.imported(source.name, wishes)
}
