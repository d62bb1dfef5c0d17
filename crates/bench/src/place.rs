//! Where things are: the repository around the current folder.

use std::path::{Path, PathBuf};

use harness::store;

/// The most bytes that are read of any file of the benches.
const MAX_BYTES: u64 = 64 << 20;

/// The nearest folder from the current one up that holds this bench.
///
/// # Errors
/// No such folder.
pub(crate) fn repository() -> Result<PathBuf, String> {
    let here = std::env::current_dir().map_err(|error| error.to_string())?;
    let is_it = |folder: &&Path| store::is_file(&folder.join("crates/bench/Cargo.toml"));
    here.ancestors()
        .find(is_it)
        .map(Path::to_owned)
        .ok_or_else(|| format!("{}: expected a folder inside goldray's repository", here.display()))
}

/// The text of a file; `None` where there is none.
///
/// # Errors
/// A file that cannot be read, or is no UTF-8.
pub(crate) fn text(path: &Path) -> Result<Option<String>, String> {
    let bytes = store::read(path, MAX_BYTES).map_err(|error| error.to_string())?;
    let text = bytes.map(String::from_utf8).transpose();
    text.map_err(|_| format!("{}: expected UTF-8 text", path.display()))
}

/// Writes a file.
///
/// # Errors
/// Whatever kept it from being written.
pub(crate) fn write(path: &Path, text: &str) -> Result<(), String> {
    store::write(path, text.as_bytes()).map_err(|error| error.to_string())
}

/// Writes a value as JSON for people to read as well.
///
/// # Errors
/// Whatever kept it from being written.
pub(crate) fn write_json(path: &Path, value: &impl serde::Serialize) -> Result<(), String> {
    let text = serde_json::to_string_pretty(value).map_err(|error| error.to_string())?;
    write(path, &format!("{text}\n"))
}
