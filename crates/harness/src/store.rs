//! The one file that opens files: everything the harness reads and writes.
//!
//! Reads are bounded in size. Writes are whole or not at all: to a temporary
//! file in the same folder, then renamed.
#![allow(clippy::disallowed_methods)]

use std::fs;
use std::io::{Read, Write};
use std::path::{Path, PathBuf};

use scene::{Assets, MAX_ASSET_BYTES};
use walkdir::WalkDir;

/// Something that could not be read or written.
#[derive(Debug, thiserror::Error)]
#[error("{}: {what}", path.display())]
pub struct StoreError {
    /// Which file or folder.
    pub path: PathBuf,
    /// What happened, as the rest of a sentence.
    pub what: String,
}

impl StoreError {
    fn new(path: &Path, what: impl Into<String>) -> Self {
        Self { path: path.to_owned(), what: what.into() }
    }

    fn io(path: &Path, error: &std::io::Error) -> Self {
        Self::new(path, error.to_string())
    }
}

/// The bytes of a file; `None` where there is no such file.
///
/// # Errors
/// A file that cannot be read, and one of more than `max_bytes`.
pub fn read(path: &Path, max_bytes: u64) -> Result<Option<Vec<u8>>, StoreError> {
    let file = match fs::File::open(path) {
        Ok(file) => file,
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => return Ok(None),
        Err(error) => return Err(StoreError::io(path, &error)),
    };
    let mut bytes = Vec::new();
    // One more than allowed, so that a larger file is seen to be larger,
    // whatever its size was said to be.
    file.take(max_bytes + 1)
        .read_to_end(&mut bytes)
        .map_err(|error| StoreError::io(path, &error))?;
    if bytes.len() as u64 > max_bytes {
        return Err(StoreError::new(path, format!("is larger than {max_bytes} bytes")));
    }
    Ok(Some(bytes))
}

/// Writes the file whole or not at all, with the folders it needs.
///
/// # Errors
/// Whatever kept it from being written; the old file is then as it was.
pub fn write(path: &Path, bytes: &[u8]) -> Result<(), StoreError> {
    let failed = |error: std::io::Error| StoreError::io(path, &error);
    let folder = path.parent().unwrap_or(Path::new("."));
    fs::create_dir_all(folder).map_err(failed)?;
    let mut temporary = tempfile::Builder::new();
    temporary.prefix(".goldray-").suffix(".tmp");
    // Temporary files are private by default; a golden is for everyone.
    #[cfg(unix)]
    temporary.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o644));
    let mut file = temporary.tempfile_in(folder).map_err(failed)?;
    file.write_all(bytes).and_then(|()| file.as_file().sync_all()).map_err(failed)?;
    file.persist(path).map_err(|error| failed(error.error))?;
    Ok(())
}

/// Writes a file that must not be there yet.
///
/// # Errors
/// A file that is there, and whatever else kept it from being written.
pub fn write_new(path: &Path, bytes: &[u8]) -> Result<(), StoreError> {
    if path.exists() {
        return Err(StoreError::new(path, "is there already"));
    }
    write(path, bytes)
}

/// Removes a file.
///
/// # Errors
/// A file that cannot be removed or is not there.
pub fn remove(path: &Path) -> Result<(), StoreError> {
    fs::remove_file(path).map_err(|error| StoreError::io(path, &error))
}

/// Empties a folder of artifacts by removing it, if it is there.
///
/// # Errors
/// A folder that cannot be removed.
pub fn remove_folder(path: &Path) -> Result<(), StoreError> {
    match fs::remove_dir_all(path) {
        Err(error) if error.kind() != std::io::ErrorKind::NotFound => {
            Err(StoreError::io(path, &error))
        }
        _ => Ok(()),
    }
}

/// Whether this is a folder.
pub fn is_folder(path: &Path) -> bool {
    path.is_dir()
}

/// The names of all files below `folder` that end in `.ending`, relative, with
/// `/` between parts and without the ending, sorted. A folder that is not
/// there has none. Links are not followed and names that begin with a dot are
/// passed over.
///
/// # Errors
/// A folder that cannot be walked, and a name that is not UTF-8.
pub fn names(folder: &Path, ending: &str) -> Result<Vec<String>, StoreError> {
    if !folder.exists() {
        return Ok(Vec::new());
    }
    let is_hidden = |name: &std::ffi::OsStr| name.as_encoded_bytes().starts_with(b".");
    let walk = WalkDir::new(folder)
        .into_iter()
        .filter_entry(|entry| entry.depth() == 0 || !is_hidden(entry.file_name()));
    let mut names = Vec::new();
    for entry in walk {
        let entry = entry
            .map_err(|error| StoreError::new(error.path().unwrap_or(folder), error.to_string()))?;
        let path = entry.path();
        if !entry.file_type().is_file() || path.extension().is_none_or(|e| e != ending) {
            continue;
        }
        let relative = path.strip_prefix(folder).unwrap_or(path).with_extension("");
        let parts = relative.components().map(|part| part.as_os_str().to_str());
        let parts = parts
            .collect::<Option<Vec<_>>>()
            .ok_or_else(|| StoreError::new(path, "has a name that is not UTF-8"))?;
        names.push(parts.join("/"));
    }
    names.sort();
    Ok(names)
}

/// The meshes of a scene: files in its own folder or below, links included
/// only where they stay there.
#[derive(Debug, Clone)]
pub struct FolderAssets {
    folder: PathBuf,
}

impl FolderAssets {
    /// The assets beside the scene file at `scene`.
    pub fn beside(scene: &Path) -> Self {
        let folder = scene.parent().filter(|folder| !folder.as_os_str().is_empty());
        Self { folder: folder.unwrap_or(Path::new(".")).to_owned() }
    }
}

impl Assets for FolderAssets {
    fn read(&self, path: &str) -> Result<Vec<u8>, String> {
        let missing = || "does not exist beside the scene".to_owned();
        let full = self.folder.join(path);
        let really = full.canonicalize().map_err(|_| missing())?;
        let home = self.folder.canonicalize().map_err(|_| missing())?;
        if !really.starts_with(home) {
            return Err("is a link that leaves the scene's folder".to_owned());
        }
        match read(&really, MAX_ASSET_BYTES) {
            Ok(bytes) => bytes.ok_or_else(missing),
            Err(error) => Err(format!("cannot be read: {}", error.what)),
        }
    }
}
