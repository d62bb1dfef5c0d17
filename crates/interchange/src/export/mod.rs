//! goldray's scenes in the languages of other renderers.
//!
//! To add a dialect: write its file, and add its line to [`Dialect`].

mod ron;

use std::collections::{BTreeMap, BTreeSet};

use scene::{Assets, SceneFile, Unchecked};
use serde::{Deserialize, Serialize};

use crate::Feature;

/// A language in which a scene can be written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub enum Dialect {
    /// goldray's own scene format.
    Ron,
    /// The same as JSON.
    Json,
    /// The XML of the course's assignments.
    CornellXml,
    /// The Neutral File Format of the Standard Procedural Databases.
    Nff,
    /// POV-Ray's scene description language.
    PovRay,
    /// The XML of Mitsuba 3.
    Mitsuba,
    /// pbrt-v4.
    Pbrt,
    /// Wavefront OBJ, with its materials.
    Obj,
}

/// A scene in a dialect.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Exported {
    /// The file to give the renderer.
    pub main: String,
    /// All files by name, `main` among them, to be put into one folder.
    pub files: BTreeMap<String, Vec<u8>>,
}

/// Why a scene is not written.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum NotWritten {
    /// The dialect has no words for these.
    Cannot(BTreeSet<Feature>),
    /// The scene itself makes no sense, or a file that it names.
    Bad(String),
}

/// Writes a scene that was read without problems; `assets` gives the files that
/// it names.
///
/// # Errors
/// See [`NotWritten`].
pub fn export(
    dialect: Dialect,
    scene: &SceneFile<Unchecked>,
    assets: &dyn Assets,
) -> Result<Exported, NotWritten> {
    match dialect {
        Dialect::Ron => ron::write(scene, assets),
        _ => Err(NotWritten::Cannot(crate::feature::features(scene))),
    }
}
