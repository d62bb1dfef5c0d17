//! Whether there is a file, told apart from all that keeps it from being known.

use std::io::ErrorKind;
use std::path::Path;

use super::StoreError;

/// Whether this is a file or a link to one; no, where its folder is there and has
/// nothing of that name.
///
/// # Errors
/// Anything else of that name, such as a link to nothing; a folder that is
/// missing, or that is none; and what cannot be looked at.
pub fn is_there(path: &Path) -> Result<bool, StoreError> {
    match path.metadata() {
        Ok(found) if found.is_file() => return Ok(true),
        Ok(_) => return Err(StoreError::new(path, "is no file")),
        Err(error) if error.kind() == ErrorKind::NotFound => {}
        // Said of the folder below.
        Err(error) if error.kind() == ErrorKind::NotADirectory => {}
        Err(error) => return Err(StoreError::io(path, &error)),
    }
    if path.symlink_metadata().is_ok() {
        return Err(StoreError::new(path, "is a link to nothing"));
    }
    let folder = match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    };
    match folder.metadata() {
        Ok(found) if found.is_dir() => Ok(false),
        Ok(_) => Err(StoreError::new(folder, "is no folder")),
        Err(error) if error.kind() == ErrorKind::NotFound => {
            Err(StoreError::new(folder, "there is no such folder"))
        }
        Err(error) => Err(StoreError::io(folder, &error)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::store::write;

    #[test]
    fn only_a_name_that_is_free_is_not_there() {
        let home = tempfile::tempdir().unwrap();
        let path = |name: &str| home.path().join(name);
        write(&path("folder/a"), b"1").unwrap();
        let there = |name: &str| is_there(&path(name)).map_err(|error| error.what);
        assert_eq!(there("folder/a"), Ok(true));
        assert_eq!(there("folder/b"), Ok(false));
        assert_eq!(there("folder"), Err("is no file".to_owned()));
        assert_eq!(there("none/a"), Err("there is no such folder".to_owned()));
        assert_eq!(there("folder/a/b"), Err("is no folder".to_owned()));
        assert!(!is_there(Path::new("there-is-no-file-of-this-name")).unwrap());
        let long = "a".repeat(10_000);
        assert!(there(&long).is_err());
    }

    #[cfg(unix)]
    #[test]
    fn links_are_what_they_lead_to_or_a_problem() {
        use std::os::unix::fs::symlink;

        let home = tempfile::tempdir().unwrap();
        let path = |name: &str| home.path().join(name);
        write(&path("a"), b"1").unwrap();
        for (to, name) in [("a", "to-a"), ("b", "to-b"), ("self", "self")] {
            symlink(path(to), path(name)).unwrap();
        }
        let there = |name: &str| is_there(&path(name)).map_err(|error| error.what);
        assert_eq!(there("to-a"), Ok(true));
        assert_eq!(there("to-b"), Err("is a link to nothing".to_owned()));
        assert!(there("self").unwrap_err().contains("symbolic links"));
        assert_eq!(there("to-b/c"), Err("there is no such folder".to_owned()));
    }
}
