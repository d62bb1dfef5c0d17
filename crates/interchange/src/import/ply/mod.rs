//! PLY, text or binary of either order: one mesh of its vertices and faces.
//!
//! Everything that the header declares is read by its type. What it declares is
//! believed only as far as there are bytes for it.

mod body;
mod header;
mod mesh;

#[cfg(test)]
pub(super) mod tests;

use scene::Assets;

use super::mesh::part::Part;
use super::mesh::stage::Stage;
use super::mesh::unreadable_at_all;
use super::{Imported, Source, Unreadable, Wishes};
use body::Body;
use header::{Element, Header};
use mesh::Builder;

/// Reads a PLY file.
///
/// # Errors
/// A header or a number that cannot be read, and a file that ends before all
/// that it declares.
pub(super) fn read(
    source: Source<'_>,
    wishes: &Wishes,
    _: &dyn Assets,
) -> Result<Imported, Vec<Unreadable>> {
    let mut stage = Stage::default();
    let part = part(source.bytes, &mut stage).map_err(|error| vec![error])?;
    stage.parts.push((part, None));
    stage.imported(source.name, wishes)
}

/// The mesh.
fn part(bytes: &[u8], stage: &mut Stage) -> Result<Part, Unreadable> {
    let (header, words) = Header::of(bytes)?;
    header.note(stage);
    let mut body = Body::new(header.format, words);
    let mut builder = Builder::default();
    for element in &header.elements {
        body.has_room_for(element)?;
        builder.begin(element, stage)?;
        for number in 0..element.count {
            body.read(element, number, builder.values())?;
            builder.take().map_err(|why| body.error(element, number, &why))?;
        }
    }
    body.end(stage);
    let none = || unreadable_at_all("expected elements `vertex` and `face`, found none");
    builder.finish(stage)?.ok_or_else(none)
}

impl Element {
    /// The number of a property.
    fn find(&self, names: &[&str]) -> Option<usize> {
        self.properties.iter().position(|property| names.contains(&&property.name[..]))
    }
}
