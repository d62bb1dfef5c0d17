//! `Compare`: an imported scene's picture beside the one that came with it.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use harness::distance::{Allowed, Distance};
use harness::fixture::{Build, Fixture};
use harness::picture_file::PictureFile;
use harness::store;

use super::pattern::Pattern;

/// Flags of the comparison.
#[derive(Debug, clap::Args)]
pub(super) struct Compare {
    /// Compare each scene's picture with the one of this name beside FILE, where {file} is FILE's
    /// name and {name} that without its ending; of several, the first that is there
    #[arg(long = "compare-to", id = "compare_to", value_name = "PATTERN")]
    patterns: Vec<Pattern>,
    /// The largest difference of 8-bit values that agrees
    #[arg(long, value_name = "CODES", default_value_t = 0, requires = "compare_to")]
    max_abs: u8,
    /// In how many pixels 8-bit values may differ
    #[arg(long, value_name = "PIXELS", default_value_t = 0, requires = "compare_to")]
    most: usize,
    /// The largest absolute difference of linear values (EXR) that agrees, from 0 to 1
    #[arg(
        long,
        value_name = "VALUE",
        default_value = "0",
        value_parser = within,
        requires = "compare_to"
    )]
    within: f64,
    /// Render a scene that none of these pictures is beside, and go on; one FILE or more must have
    /// a picture
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

    /// What is said where scenes were rendered and not one of their files had a
    /// picture: that nothing was compared is no agreement.
    pub(super) fn none_found(&self, rendered: usize) -> String {
        let patterns: Vec<_> = self.patterns.iter().map(ToString::to_string).collect();
        let files = if rendered == 1 { "FILE" } else { "FILEs" };
        format!(
            "--compare-to {}: expected a picture beside one FILE or more, found none beside \
             {rendered} {files}: name the pictures that there are",
            patterns.join(", ")
        )
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
            let path = self.reference(file)?;
            let reference = path.as_deref().map(read).transpose()?;
            let picture = Fixture::read(label, text, files, Build::default())?.render()?;
            Ok(match reference {
                Some(reference) => Compared::Apart(Distance::of(&picture, &reference)?),
                None => Compared::Alone,
            })
        })
    }

    /// The first of the patterns that is a file; `None` where none is and none need
    /// be. What cannot be told is not taken for a picture that is not there, as a
    /// mistyped folder would compare nothing.
    fn reference(&self, file: &Path) -> Result<Option<PathBuf>, String> {
        let paths: Vec<PathBuf> = self.patterns.iter().map(|one| one.beside(file)).collect();
        for path in &paths {
            if store::is_there(path).map_err(|error| format!("expected a picture, {error}"))? {
                return Ok(Some(path.clone()));
            }
        }
        if self.if_there {
            return Ok(None);
        }
        let shown: Vec<_> = paths.iter().map(|path| path.display().to_string()).collect();
        Err(format!(
            "expected the picture {}, found none: --if-there goes on without",
            shown.join(" or ")
        ))
    }
}

/// How far linear values may be apart: as far as black and white at most, as any
/// two pictures agree within more.
fn within(text: &str) -> Result<f64, String> {
    let found = text.parse().ok().filter(|found| (0.0..=1.0).contains(found));
    found.ok_or_else(|| "expected a finite number from 0 to 1".to_owned())
}

fn read(path: &Path) -> Result<PictureFile, String> {
    let said = |why: String| format!("{}: {why}", path.display());
    let bytes = store::read(path, MAX_BYTES).map_err(|error| error.to_string())?;
    let bytes = bytes.ok_or_else(|| said("has gone".to_owned()))?;
    PictureFile::read(&bytes).map_err(said)
}
