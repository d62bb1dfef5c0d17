//! `Stamp`: what tells that a file has changed without reading it.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::time::SystemTime;

use walkdir::WalkDir;

use super::is_temporary;

/// A file seen from outside. Two of one path that are the same are of the same
/// content, unless somebody sets clocks back to hide a change; two that differ
/// may be of the same content.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Stamp {
    bytes: u64,
    modified: Option<SystemTime>,
    identity: Identity,
}

/// The file's number and the time of its last change of any kind, which no
/// program can set: a file that was renamed into the place has another number.
#[cfg(unix)]
type Identity = (u64, i64, i64);

/// When the file was made.
#[cfg(not(unix))]
type Identity = Option<SystemTime>;

impl Stamp {
    /// Of a file, or what a link to one leads to.
    fn of(path: &Path) -> Option<Self> {
        let found = path.metadata().ok()?;
        if !found.is_file() {
            return None;
        }
        #[cfg(unix)]
        let identity = {
            use std::os::unix::fs::MetadataExt;
            (found.ino(), found.ctime(), found.ctime_nsec())
        };
        #[cfg(not(unix))]
        let identity = found.created().ok();
        Some(Self { bytes: found.len(), modified: found.modified().ok(), identity })
    }
}

/// The stamps of the files at `place` or below it whose paths are wanted; links
/// to files stand for what they lead to. Folders that are hidden or not wanted
/// are not entered, half-written files of this program are none, and what is
/// gone by the time that it is looked at is not there.
pub fn stamps(place: &Path, is_wanted: &dyn Fn(&Path, bool) -> bool) -> BTreeMap<PathBuf, Stamp> {
    let walk = WalkDir::new(place).into_iter().filter_entry(|entry| {
        let is_hidden = entry.file_name().as_encoded_bytes().starts_with(b".");
        let is_folder = entry.file_type().is_dir();
        entry.depth() == 0 || !is_hidden && is_wanted(entry.path(), is_folder)
    });
    let files = walk.filter_map(Result::ok).filter(|entry| !entry.file_type().is_dir());
    let files = files.map(walkdir::DirEntry::into_path).filter(|path| !is_temporary(path));
    files.filter_map(|path| Some((path.clone(), Stamp::of(&path)?))).collect()
}
