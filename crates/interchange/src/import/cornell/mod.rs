//! The XML scenes of Cornell's course CS4620/5620, "Ray 1" and "Ray 2", of all
//! years from 2011 on.
//!
//! Names of elements and types are read in any case, as they vary between the
//! years. What is not known is a [`Lost`](super::Lost) with its place, what is
//! malformed a problem, all of them at once. Which of three shading conventions
//! a file means is not in it: see [`shading`].

mod camera;
mod element;
mod light;
mod mesh;
mod msh;
mod reader;
mod shader;
mod shading;
mod specular;
mod surface;
#[cfg(test)]
mod tests;
mod xml;

use scene::Assets;

use super::{Imported, Source, Unreadable, Wishes, text::Text};
use reader::Reader;

/// Reads a scene of the course.
///
/// # Errors
/// Every reason why it is none.
pub(super) fn read(
    source: Source<'_>,
    wishes: &Wishes,
    assets: &dyn Assets,
) -> Result<Imported, Vec<Unreadable>> {
    let text = Text::of(source.bytes).map_err(|problem| vec![problem])?;
    let document = xml::parse(&text).map_err(|problem| vec![problem])?;
    Reader::new(&text, assets)?.scene(document.root_element(), wishes)
}
