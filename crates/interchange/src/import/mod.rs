//! Foreign scene files, read as goldray's.
//!
//! To add a format: write its file with a function that makes an [`Imported`] of
//! a [`Source`], and add its line to `READERS`.

mod cornell;
mod files;
mod gltf;
mod json;
mod mesh;
mod nff;
mod obj;
mod ply;
mod prove;
mod report;
mod sense;
mod stl;
#[cfg(test)]
mod tests;
mod text;
mod wish;

use scene::{Assets, SceneFile, Unchecked};

pub use scene::format::{Camera, Shading};

/// A foreign file.
#[derive(Debug, Clone, Copy)]
pub struct Source<'a> {
    /// Its name, as in messages; its ending tells the format.
    pub name: &'a str,
    /// What it holds.
    pub bytes: &'a [u8],
}

/// A scene with what it needs.
#[derive(Debug, Clone, PartialEq)]
pub struct Imported {
    /// The scene; whether it makes sense is told by reading it.
    pub scene: SceneFile<Unchecked>,
    /// Files that the scene names, by the names that it has for them.
    pub files: std::collections::BTreeMap<String, Vec<u8>>,
    /// What the file asks for and the scene does not do.
    pub lost: Vec<Lost>,
    /// What was chosen where the file does not say, a sentence each: a camera, a light.
    pub chosen: Vec<String>,
}

/// Something that a file asks for and goldray cannot do.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Lost {
    /// Where, if the format has lines: from 1.
    pub place: Option<(usize, usize)>,
    /// Which element, as the file calls it.
    pub element: String,
    /// What it asks for, and what becomes of it: one sentence without a full stop.
    pub what: String,
}

/// A file that cannot be read as a scene at all.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Unreadable {
    /// Where, if it is known: line and column, from 1.
    pub place: Option<(usize, usize)>,
    /// What was expected and what found: one sentence without a full stop.
    pub message: String,
    /// What to do about it.
    pub help: Option<String>,
}

/// What formats without them are told: a mesh file has no camera.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Wishes {
    /// The camera, in place of the file's own.
    pub camera: Option<Camera>,
    /// The picture's size, in place of the file's own.
    pub image: Option<(u32, u32)>,
    /// The shading convention, in place of a guess or of the classic one: the
    /// course's files do not say theirs.
    pub shading: Option<Shading>,
}

/// Reads a foreign scene. Files that it names are asked of `assets`, relative to
/// its own folder: a path that begins with `..` leads out of it, and whoever has
/// only that folder refuses it.
///
/// # Errors
/// Every reason why there is no scene at all.
pub fn import(
    source: Source<'_>,
    wishes: &Wishes,
    assets: &dyn Assets,
) -> Result<Imported, Vec<Unreadable>> {
    let ending = source.name.rsplit_once('.').map_or("", |(_, ending)| ending);
    let ending = ending.to_ascii_lowercase();
    let Some((_, read)) = READERS.iter().find(|(known, _)| *known == ending) else {
        let known: Vec<_> = endings().map(|ending| format!(".{ending}")).collect();
        return Err(vec![Unreadable {
            place: None,
            message: format!(
                "expected a file that ends in {}, found \"{}\"",
                known.join(", "),
                source.name
            ),
            help: None,
        }]);
    };
    read(source, wishes, assets)
}

/// The endings of files that are read, without the dot and in lower case.
pub fn endings() -> impl Iterator<Item = &'static str> {
    READERS.iter().map(|(ending, _)| *ending)
}

/// How a format is read.
type Reader = fn(Source<'_>, &Wishes, &dyn Assets) -> Result<Imported, Vec<Unreadable>>;

/// Formats by the endings of their files' names, in lower case.
const READERS: &[(&str, Reader)] = &[
    ("xml", cornell::read),
    ("nff", nff::read),
    ("json", json::read),
    ("glb", gltf::read),
    ("gltf", gltf::read),
    ("obj", obj::read),
    ("ply", ply::read),
    ("stl", stl::read),
];
