//! How much there is in a folder, and whether a file is a program.

use std::path::Path;

use walkdir::WalkDir;

/// The length of all files below a folder, in bytes. What cannot be looked at, as
/// it has just gone, counts for nothing; links are not followed.
pub fn folder_bytes(folder: &Path) -> u64 {
    let files = WalkDir::new(folder).into_iter().filter_map(Result::ok);
    files
        .filter_map(|file| file.metadata().ok())
        .map(|found| if found.is_file() { found.len() } else { 0 })
        .fold(0, u64::saturating_add)
}

/// Whether this is a file that may be run.
pub fn is_program(path: &Path) -> bool {
    let Ok(found) = path.metadata() else { return false };
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        const ANYBODY: u32 = 0o111;
        found.is_file() && found.permissions().mode() & ANYBODY != 0
    }
    #[cfg(not(unix))]
    found.is_file()
}
