//! `Scratch`: a folder for a while.

use std::path::{Path, PathBuf};

use super::{StoreError, write_new};

/// A folder for what is needed for a while; it goes away with this.
#[derive(Debug)]
pub struct Scratch(tempfile::TempDir);

impl Scratch {
    /// An empty one, where the system keeps such, that nobody else may look into.
    ///
    /// # Errors
    /// Whatever kept it from being made.
    pub fn new() -> Result<Self, StoreError> {
        let mut folder = tempfile::Builder::new();
        #[cfg(unix)]
        folder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o700));
        folder.tempdir().map(Self).map_err(|error| StoreError::io(Path::new("."), &error))
    }

    /// Where it is.
    pub fn folder(&self) -> &Path {
        self.0.path()
    }

    /// Where a file of this name is in it.
    pub fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    /// Writes a file of this name, which nobody else can get at in this folder;
    /// where it is.
    ///
    /// # Errors
    /// Whatever kept it from being written.
    pub fn write(&self, name: &str, bytes: &[u8]) -> Result<PathBuf, StoreError> {
        let path = self.path(name);
        write_new(&path, bytes)?;
        Ok(path)
    }
}
