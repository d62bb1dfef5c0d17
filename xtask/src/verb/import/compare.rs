//! `Compare`: an imported scene's picture beside the one that came with it.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use harness::distance::{Allowed, Distance};
use harness::fixture::{Build, Fixture};
use harness::picture_file::PictureFile;
use harness::store;

/// Flags of the comparison.
#[derive(Debug, clap::Args)]
pub(super) struct Compare {
    /// Compare each scene's picture with the one of this name beside FILE, where {file} is FILE's
    /// name and {name} that without its ending; of several, the first that is there
    #[arg(long = "compare-to", id = "compare_to", value_name = "PATTERN")]
    patterns: Vec<String>,
    /// The largest difference of 8-bit values that agrees
    #[arg(long, value_name = "CODES", default_value_t = 0, requires = "compare_to")]
    max_abs: u8,
    /// In how many pixels 8-bit values may differ
    #[arg(long, value_name = "PIXELS", default_value_t = 0, requires = "compare_to")]
    most: usize,
    /// The largest absolute difference of linear values (EXR) that agrees
    #[arg(long, value_name = "VALUE", default_value_t = 0.0, requires = "compare_to")]
    within: f64,
    /// Render a scene that none of these pictures is beside, and go on
    #[arg(long, requires = "compare_to")]
    if_there: bool,
}

/// What came of a comparison.
pub(super) enum Compared {
    /// How far the pictures are apart.
    Apart(Distance),
    /// The scene is rendered, and there is nothing to compare it with.
    Alone,
}

/// The largest picture file that is read, in bytes.
const MAX_BYTES: u64 = 1 << 30;

impl Compare {
    /// What may differ.
    pub(super) fn allowed(&self) -> Allowed {
        Allowed { codes: self.max_abs, pixels: self.most, linear: self.within }
    }

    /// How far a scene's picture is from the reference beside its file, or why
    /// that cannot be said; `None` if it is not asked.
    pub(super) fn with_reference(
        &self,
        file: &Path,
        label: &str,
        text: &str,
        files: &BTreeMap<String, Vec<u8>>,
    ) -> Option<Result<Compared, String>> {
        (!self.patterns.is_empty()).then(|| {
            let path = match self.reference(file) {
                Ok(path) => Some(path),
                Err(_) if self.if_there => None,
                Err(why) => return Err(why),
            };
            let reference = path.as_deref().map(read).transpose()?;
            let picture = Fixture::read(label, text, files, Build::default())?.render()?;
            Ok(match reference {
                Some(reference) => Compared::Apart(Distance::of(&picture, &reference)?),
                None => Compared::Alone,
            })
        })
    }

    /// The first of the patterns that is a file.
    fn reference(&self, file: &Path) -> Result<PathBuf, String> {
        let part = |part: Option<&std::ffi::OsStr>| {
            part.unwrap_or_default().to_string_lossy().into_owned()
        };
        let (whole, stem) = (part(file.file_name()), part(file.file_stem()));
        let path = |pattern: &String| {
            file.with_file_name(pattern.replace("{file}", &whole).replace("{name}", &stem))
        };
        let paths: Vec<PathBuf> = self.patterns.iter().map(path).collect();
        let found = paths.iter().find(|path| store::is_file(path)).cloned();
        found.ok_or_else(|| {
            let shown: Vec<_> = paths.iter().map(|path| path.display().to_string()).collect();
            format!("expected the picture {}, found none", shown.join(" or "))
        })
    }
}

fn read(path: &Path) -> Result<PictureFile, String> {
    let said = |why: String| format!("{}: {why}", path.display());
    let bytes = store::read(path, MAX_BYTES).map_err(|error| error.to_string())?;
    let bytes = bytes.ok_or_else(|| said("has gone".to_owned()))?;
    PictureFile::read(&bytes).map_err(said)
}
