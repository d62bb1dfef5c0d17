//! The bench's files beside its own build: what it is given, keeps and asks of
//! other programs.

use std::path::{Path, PathBuf};

use harness::store;

/// The most bytes that are read of any of them: a picture of the largest size.
const MAX_BYTES: u64 = 2 << 30;

/// The folder of this crate's build, which holds everything that the bench
/// installs, keeps and throws away.
pub(crate) fn target() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("target")
}

/// Where other people's renderers are installed.
pub(crate) fn peers() -> PathBuf {
    target().join("peers")
}

/// The bytes of a file, or why they cannot be had.
pub(crate) fn read(path: &Path) -> Result<Vec<u8>, String> {
    let bytes = store::read(path, MAX_BYTES).map_err(|why| why.to_string())?;
    bytes.ok_or_else(|| format!("{}: expected a file, found none", path.display()))
}

/// The bytes of a file that need not be there.
pub(crate) fn read_kept(path: &Path) -> Option<Vec<u8>> {
    store::read(path, MAX_BYTES).ok().flatten()
}

/// Writes a file, and the folders that it lies in.
pub(crate) fn write(path: &Path, bytes: &[u8]) -> Result<(), String> {
    store::write(path, bytes).map_err(|why| why.to_string())
}
