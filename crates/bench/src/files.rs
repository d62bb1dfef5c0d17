//! The bench's files: what it writes and reads beside its own build.

use std::fs;
use std::path::{Path, PathBuf};

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
    fs::read(path).map_err(|why| format!("{}: cannot be read: {why}", path.display()))
}

/// The bytes of a file that need not be there.
pub(crate) fn read_kept(path: &Path) -> Option<Vec<u8>> {
    fs::read(path).ok()
}

/// Writes a file, and the folders that it lies in.
pub(crate) fn write(path: &Path, bytes: &[u8]) -> Result<(), String> {
    let write = || {
        if let Some(folder) = path.parent() {
            fs::create_dir_all(folder)?;
        }
        fs::write(path, bytes)
    };
    write().map_err(|why| format!("{}: cannot be written: {why}", path.display()))
}

/// What lies in a folder, in the order of names; nothing where there is none.
pub(crate) fn entries(folder: &Path) -> Vec<PathBuf> {
    let found = fs::read_dir(folder).into_iter().flatten().flatten();
    let mut paths: Vec<_> = found.map(|entry| entry.path()).collect();
    paths.sort();
    paths
}

/// Makes a folder, and those that it lies in.
pub(crate) fn make_folder(path: &Path) -> Result<(), String> {
    fs::create_dir_all(path).map_err(|why| format!("{}: cannot be made: {why}", path.display()))
}
