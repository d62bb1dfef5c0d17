//! goldray's scenes in the languages of other renderers.
//!
//! To add a dialect: write its file, and add its line to [`Dialect`].

mod cornell;
mod mitsuba;
mod nff;
mod obj;
mod own;
mod pbrt;
mod plain;
mod povray;
mod text;

use std::collections::{BTreeMap, BTreeSet};
use std::fmt;

use scene::{Assets, SceneFile, Unchecked};
use serde::{Deserialize, Serialize};

use crate::Feature;
use crate::feature::features;
use plain::Plain;
use text::number;

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

impl Dialect {
    /// All of them.
    pub const ALL: &[Self] = &[
        Self::Ron,
        Self::Json,
        Self::CornellXml,
        Self::Nff,
        Self::PovRay,
        Self::Mitsuba,
        Self::Pbrt,
        Self::Obj,
    ];

    /// Its name, as in adapters.
    pub fn name(self) -> &'static str {
        match self {
            Self::Ron => "Ron",
            Self::Json => "Json",
            Self::CornellXml => "CornellXml",
            Self::Nff => "Nff",
            Self::PovRay => "PovRay",
            Self::Mitsuba => "Mitsuba",
            Self::Pbrt => "Pbrt",
            Self::Obj => "Obj",
        }
    }
}

impl fmt::Display for Dialect {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// A scene in a dialect.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Exported {
    /// The file to give the renderer.
    pub main: String,
    /// All files by name, `main` among them, to be put into one folder.
    pub files: BTreeMap<String, Vec<u8>>,
    /// Samples in each row and column of a pixel, where the files do not say so:
    /// a renderer of one sample in the middle of each pixel takes them all in a
    /// picture this many times as wide and as high, of which each square of
    /// `grid` by `grid` pixels is then one, their mean. 1 where there is nothing
    /// to do.
    pub grid: u32,
    /// What the files do not say, and whoever renders them must be told besides.
    pub beside: BTreeSet<Feature>,
}

/// Why a scene is not written.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum NotWritten {
    /// The dialect has no words for these, or not for these together.
    Cannot(BTreeSet<Feature>),
    /// The scene itself makes no sense, or a file that it names.
    Bad(String),
}

impl fmt::Display for NotWritten {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Cannot(features) => {
                let names: Vec<_> = features.iter().map(|feature| feature.name()).collect();
                write!(f, "no words for {}", names.join(", "))
            }
            Self::Bad(why) => f.write_str(why),
        }
    }
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
    let write: fn(&Plain) -> Result<Exported, BTreeSet<Feature>> = match dialect {
        Dialect::Ron => return own::ron(scene, assets).map_err(NotWritten::Bad),
        Dialect::Json => return own::json(scene, assets).map_err(NotWritten::Bad),
        Dialect::CornellXml => cornell::write,
        Dialect::Nff => nff::write,
        Dialect::PovRay => povray::write,
        Dialect::Mitsuba => mitsuba::write,
        Dialect::Pbrt => pbrt::write,
        Dialect::Obj => obj::write,
    };
    let plain = Plain::new(scene, assets).map_err(NotWritten::Bad)?;
    write(&plain).map_err(NotWritten::Cannot)
}

/// All that a scene asks of a renderer: what [`features`] reads in its file, and what is
/// known only when all is in its place and the picture is looked at
/// ([`Feature::is_seen`]). No other feature is changed by what writers say otherwise: a
/// group is a group here, also where a dialect opens it.
///
/// # Errors
/// The problems of a scene that makes no sense, or of a file that it names.
pub fn asks<C>(scene: &SceneFile<C>, assets: &dyn Assets) -> Result<BTreeSet<Feature>, String> {
    let plain = Plain::new(scene, assets)?;
    let mut asks = features(scene);
    asks.extend(plain.asks.iter().filter(|feature| feature.is_seen()));
    if plain.has_several_lights() {
        asks.insert(Feature::SeveralLights);
    }
    Ok(asks)
}

#[cfg(test)]
mod tests;
