//! `empty_artifacts`: folders that are goldray's own to empty.

use std::fs;
use std::io::ErrorKind;
use std::path::Path;

use walkdir::WalkDir;

use super::{StoreError, check_no_link, is_file, is_temporary, read, sweep, write};

/// The mark of a folder that may be emptied, by the convention of
/// <https://bford.info/cachedir/>.
pub(super) const ARTIFACTS_MARK: (&str, &[u8]) = (
    "CACHEDIR.TAG",
    b"Signature: 8a477f597d28d172789f06886806bc55\n# Made by goldray; emptied at each check.\n",
);

/// Whether [`empty_artifacts`] may empty a folder, if there is one. Nothing is changed.
///
/// # Errors
/// A link, a folder with something in it but without the very mark that goldray
/// makes, and one that cannot be read.
pub fn check_artifacts(path: &Path) -> Result<(), StoreError> {
    check_no_link(path)?;
    let entries: Vec<_> = match fs::read_dir(path) {
        Ok(entries) => entries.filter_map(Result::ok).map(|entry| entry.path()).collect(),
        Err(error) => failed(path, &error).map(|()| Vec::new())?,
    };
    let entries: Vec<_> = entries.into_iter().filter(|entry| !is_temporary(entry)).collect();
    // Other programs mark folders by a file of this name too.
    let is_marked = || {
        let most = ARTIFACTS_MARK.1.len() as u64;
        let found = read(&path.join(ARTIFACTS_MARK.0), most).ok().flatten();
        found.is_some_and(|found| found == ARTIFACTS_MARK.1)
    };
    if !entries.is_empty() && !is_marked() {
        let what = "is in the way of the artifacts and was not made by goldray: move it";
        return Err(StoreError::new(path, what));
    }
    Ok(())
}

fn failed(path: &Path, error: &std::io::Error) -> Result<(), StoreError> {
    match error.kind() {
        // Another check was faster, or is writing what it found.
        ErrorKind::NotFound | ErrorKind::DirectoryNotEmpty => Ok(()),
        _ => Err(StoreError::io(path, error)),
    }
}

/// An empty folder for artifacts, marked as such.
///
/// # Errors
/// A link, a folder with something in it but without the very mark that this
/// function makes, and whatever keeps it from being emptied.
pub fn empty_artifacts(path: &Path) -> Result<(), StoreError> {
    check_artifacts(path)?;
    let mark = path.join(ARTIFACTS_MARK.0);
    // What another check is writing at this moment stays.
    sweep(path);
    // The mark comes first and stays, so that a run cut short leaves a folder
    // that the next one knows.
    if !is_file(&mark) {
        // Another check that begins may be emptying the folder by then.
        write(&mark, ARTIFACTS_MARK.1).or_else(|e| if is_file(&mark) { Ok(()) } else { Err(e) })?;
    }
    for entry in WalkDir::new(path).min_depth(1).contents_first(true) {
        let entry = match entry {
            Ok(entry) => entry,
            Err(error) => {
                let at = error.path().unwrap_or(path).to_owned();
                failed(&at, &error.into())?;
                continue;
            }
        };
        let entry_path = entry.path();
        if entry_path == mark || is_temporary(entry_path) {
            continue;
        }
        let is_folder = entry.file_type().is_dir();
        let remove =
            if is_folder { fs::remove_dir(entry_path) } else { fs::remove_file(entry_path) };
        remove.or_else(|error| failed(entry_path, &error))?;
    }
    Ok(())
}
