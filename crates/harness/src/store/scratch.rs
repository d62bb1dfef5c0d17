//! `Scratch`: a folder for a while.

use std::path::{Path, PathBuf};

use super::StoreError;

/// A folder for what is needed for a while; it goes away with this.
#[derive(Debug)]
pub struct Scratch(tempfile::TempDir);

impl Scratch {
    /// An empty one, where the system keeps such.
    ///
    /// # Errors
    /// Whatever kept it from being made.
    pub fn new() -> Result<Self, StoreError> {
        tempfile::tempdir().map(Self).map_err(|error| StoreError::io(Path::new("."), &error))
    }

    /// Where a file of this name is in it.
    pub fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }
}
