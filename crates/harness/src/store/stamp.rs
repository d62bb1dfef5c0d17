//! `Stamp`: what tells that a file has changed without reading it.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::time::SystemTime;

use walkdir::WalkDir;

use super::{has_an_ending, is_temporary};

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
    /// Of a file, or what a link to one leads to. Of anything else it is only told
    /// that it is there.
    fn of(path: &Path) -> Option<Self> {
        let found = match path.metadata() {
            Ok(found) if found.is_file() => found,
            _ => {
                path.symlink_metadata().ok()?;
                return Some(Self { bytes: 0, modified: None, identity: Identity::default() });
            }
        };
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

/// What there may be in a folder.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Found {
    /// A file, a link to one, or anything else that is no folder.
    File,
    /// A folder.
    Folder,
    /// A link to a folder, which is not entered.
    FolderLink,
}

impl Found {
    fn of(entry: &walkdir::DirEntry) -> Self {
        match entry.file_type().is_dir() {
            true => Self::Folder,
            false if entry.path_is_symlink() && entry.path().is_dir() => Self::FolderLink,
            false => Self::File,
        }
    }
}

/// The stamps of what is at `place` or below it, by the path in it, and wanted;
/// links to files stand for what they lead to. Folders that are not wanted are
/// not entered, and of the others only those are told that are in the way of a
/// fixture or a golden; half-written files of this program are none, and what is
/// gone by the time that it is looked at is not there.
pub fn stamps(place: &Path, is_wanted: &dyn Fn(&Path, Found) -> bool) -> BTreeMap<PathBuf, Stamp> {
    let walk = WalkDir::new(place).into_iter().filter_entry(|entry| {
        let relative = entry.path().strip_prefix(place).unwrap_or(entry.path());
        entry.depth() == 0 || is_wanted(relative, Found::of(entry))
    });
    let told = walk.filter_map(Result::ok).filter(|entry| {
        !entry.file_type().is_dir() || entry.depth() > 0 && has_an_ending(entry.path())
    });
    let told = told.map(walkdir::DirEntry::into_path).filter(|path| !is_temporary(path));
    told.filter_map(|path| Some((path.clone(), Stamp::of(&path)?))).collect()
}
