//! `FolderAssets`: the meshes beside a scene file.

use std::path::{Path, PathBuf};

use scene::{Assets, MAX_ASSET_BYTES};

use super::{read, real_path};
use crate::lfs::pointer_problem;

/// The meshes of a scene: files in its own folder or below, links included
/// only where they stay there.
#[derive(Debug, Clone)]
pub struct FolderAssets {
    folder: PathBuf,
    /// What must not be left.
    home: PathBuf,
}

impl FolderAssets {
    /// The assets beside the scene file at `scene`.
    pub fn beside(scene: &Path) -> Self {
        let folder = scene.parent().filter(|folder| !folder.as_os_str().is_empty());
        let folder = folder.unwrap_or(Path::new(".")).to_owned();
        Self { home: folder.clone(), folder }
    }

    /// The assets of the foreign scene file at `scene`: paths are relative to its
    /// folder, and may lead out of that as long as they stay in `home`.
    pub fn within(scene: &Path, home: &Path) -> Self {
        Self { home: home.to_owned(), ..Self::beside(scene) }
    }
}

impl Assets for FolderAssets {
    fn read(&self, path: &str) -> Result<Vec<u8>, String> {
        let missing = || "does not exist beside the scene".to_owned();
        let full = self.folder.join(path);
        let really = real_path(&full).map_err(|_| missing())?;
        let home = real_path(&self.home).map_err(|_| missing())?;
        if !really.starts_with(home) {
            // Of what may be named, only an import has a path that leads out itself.
            let what = if path.split('/').any(|part| part == "..") {
                "leads out of the scene's folder"
            } else {
                "is a link that leaves the scene's folder"
            };
            return Err(what.to_owned());
        }
        let bytes = match read(&really, MAX_ASSET_BYTES) {
            Ok(bytes) => bytes.ok_or_else(missing)?,
            Err(error) => return Err(format!("cannot be read: {}", error.what)),
        };
        match pointer_problem(&bytes, "mesh") {
            None => Ok(bytes),
            Some(problem) => Err(problem),
        }
    }
}
