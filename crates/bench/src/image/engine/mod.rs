//! Whoever renders: goldray in its ways, and its peers.

mod goldray;
mod mitsuba;
mod povray;

use std::collections::BTreeMap;
use std::fmt;
use std::path::PathBuf;

use tracer::{LinearImage, Size};

use super::export::{self, Model};
use super::scenes::{Read, Source};
use crate::files;

/// What a picture is made with: the knob that trades time for error.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Setting {
    /// goldray: this many samples on a grid in each pixel.
    Grid(u32),
    /// goldray: samples where the error is, until it is estimated to be this.
    Error(f64),
    /// POV-Ray: its antialiasing.
    Povray(povray::Antialiasing),
    /// Mitsuba: a sampler, and samples a pixel.
    Mitsuba(&'static str, u32),
}

impl fmt::Display for Setting {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Grid(samples) => write!(f, "grid {samples}"),
            Self::Error(error) => write!(f, "error {error:e}"),
            Self::Povray(antialiasing) => write!(f, "{antialiasing}"),
            Self::Mitsuba(sampler, samples) => write!(f, "{sampler} {samples}"),
        }
    }
}

/// A scene, ready for everybody.
pub(crate) struct Stage {
    pub(crate) source: Source,
    pub(crate) read: Read,
    /// Where its files are.
    pub(crate) folder: PathBuf,
}

impl Stage {
    /// Writes the scene in everybody's language.
    pub(crate) fn new(source: Source, size: Option<(u32, u32)>) -> Result<Self, String> {
        let read = source.read(size)?;
        let name = format!("{}-{}", source.name, source.hash(read.file.image));
        let folder = files::target().join("image").join(name);
        Ok(Self { source, read, folder })
    }

    /// Writes the scene for all that do not read goldray's own format.
    pub(crate) fn export(&self) -> Result<(), String> {
        let model = Model::new(&self.read, &self.source.meshes)
            .map_err(|why| format!("scene {}: {why}", self.source.name))?;
        files::write(&self.folder.join(povray::SCENE), export::povray(&model).as_bytes())?;
        for (name, bytes) in export::mitsuba(&model) {
            files::write(&self.folder.join(name), &bytes)?;
        }
        Ok(())
    }

    pub(crate) fn size(&self) -> Size {
        self.read.accurate.size()
    }
}

/// A picture, and the CPU seconds that rendering it took: without reading the
/// scene, building what speeds it up, and writing the picture.
pub(crate) struct Shot {
    pub(crate) seconds: f64,
    pub(crate) picture: LinearImage,
}

/// One that renders, on one thread.
pub(crate) trait Engine {
    /// What it is called.
    fn name(&self) -> &'static str;

    /// Its version, or how it was built.
    fn version(&self) -> String;

    /// Its settings in lists, each from fast to exact.
    fn ladders(&self) -> Vec<Vec<Setting>>;

    /// Whether it is no other than the engine before on this scene.
    fn is_redundant(&self, stage: &Stage) -> bool {
        let _ = stage;
        false
    }

    /// Renders the scene.
    ///
    /// # Errors
    /// What went wrong in another program.
    fn shoot(&mut self, stage: &Stage, setting: Setting) -> Result<Shot, String>;
}

/// goldray's own, by name; the first is what others are compared with.
pub(crate) const OURS: [&str; 4] =
    ["goldray-adaptive", "goldray-grid", "goldray-adaptive-fast", "goldray-grid-fast"];
/// The others.
pub(crate) const PEERS: [&str; 3] = ["povray", "mitsuba-scalar", "mitsuba-llvm"];

/// Who of them is there; and why who is not.
pub(crate) fn find(names: &[&str]) -> (Vec<Box<dyn Engine>>, BTreeMap<String, String>) {
    let (mut found, mut missing) = (Vec::new(), BTreeMap::new());
    for &name in names {
        let engine: Result<Box<dyn Engine>, String> = match name {
            "povray" => povray::Povray::find().map(|engine| Box::new(engine) as _),
            "mitsuba-scalar" => mitsuba::Mitsuba::find("mitsuba-scalar", "scalar_rgb")
                .map(|engine| Box::new(engine) as _),
            "mitsuba-llvm" => mitsuba::Mitsuba::find("mitsuba-llvm", "llvm_ad_rgb")
                .map(|engine| Box::new(engine) as _),
            ours => goldray::Goldray::find(ours).map(|engine| Box::new(engine) as _),
        };
        match engine {
            Ok(engine) => found.push(engine),
            Err(why) => {
                missing.insert(name.to_owned(), why);
            }
        }
    }
    (found, missing)
}
