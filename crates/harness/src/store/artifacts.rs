//! `check_artifacts`: whether a folder is goldray's own to empty.

use std::path::Path;

use walkdir::WalkDir;

use super::{ARTIFACTS_MARK, StoreError, check_no_link, is_temporary, read};

/// Whether [`super::empty_artifacts`] may empty a folder, if there is one. Nothing is
/// changed.
///
/// # Errors
/// A link, and a folder with something in it but without the very mark that goldray
/// makes.
pub fn check_artifacts(path: &Path) -> Result<(), StoreError> {
    check_no_link(path)?;
    let entries = WalkDir::new(path).min_depth(1).max_depth(1).into_iter();
    // What has just gone, or cannot be listed, is told where the folder is emptied.
    let mut entries = entries.filter_map(Result::ok).filter(|entry| !is_temporary(entry.path()));
    // Other programs mark folders by a file of this name too.
    let is_marked = || {
        let most = ARTIFACTS_MARK.1.len() as u64;
        let found = read(&path.join(ARTIFACTS_MARK.0), most).ok().flatten();
        found.is_some_and(|found| found == ARTIFACTS_MARK.1)
    };
    if entries.next().is_some() && !is_marked() {
        let what = "is in the way of the artifacts and was not made by goldray: move it";
        return Err(StoreError::new(path, what));
    }
    Ok(())
}
