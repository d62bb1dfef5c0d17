//! The one file that opens files: everything the harness reads and writes.
//!
//! Reads are bounded in size. Writes are whole or not at all: to a temporary
//! file in the same folder, then renamed.
#![allow(clippy::disallowed_methods)]

mod artifacts;
mod extent;
mod folder_assets;
mod processes;
mod scratch;
mod stamp;
#[cfg(test)]
mod tests;
mod there;

use std::fs;
use std::io::{ErrorKind, Read, Write};
use std::path::{Component, Path, PathBuf};
use std::sync::{OnceLock, RwLock};

use tempfile::NamedTempFile;
use walkdir::WalkDir;

pub use artifacts::check_artifacts;
pub use extent::{folder_bytes, is_program};
pub use folder_assets::FolderAssets;
pub use processes::processes_with;
pub use scratch::Scratch;
pub use stamp::{Found, Stamp, stamps};
pub use there::is_there;

/// Something that could not be read or written.
#[derive(Debug, thiserror::Error)]
#[error("{}: {what}", scene::visible(&path.display().to_string()))]
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
    // Looked at before opening: opening a pipe would wait for its other end.
    match fs::metadata(path) {
        Ok(found) if found.is_file() => {}
        Ok(_) => return Err(StoreError::new(path, "is no file")),
        Err(error) if error.kind() == ErrorKind::NotFound => return Ok(None),
        Err(error) => return Err(StoreError::io(path, &error)),
    }
    let file = fs::File::open(path).map_err(|error| StoreError::io(path, &error))?;
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

/// A hash of the program that runs, which another build of it has not.
///
/// # Errors
/// A program that cannot be read.
pub fn program_hash() -> Result<String, StoreError> {
    static HASH: OnceLock<String> = OnceLock::new();
    if let Some(hash) = HASH.get() {
        return Ok(hash.clone());
    }
    // The file by its name may be of a later build than what runs.
    let path = if cfg!(target_os = "linux") {
        Ok(PathBuf::from("/proc/self/exe"))
    } else {
        std::env::current_exe()
    };
    let path = path.map_err(|error| StoreError::io(Path::new("."), &error))?;
    let hash = file_hash(&path)?;
    Ok(HASH.get_or_init(|| hash).clone())
}

/// The hash of a program in a file, as [`program_hash`] has it.
///
/// # Errors
/// A file that cannot be read.
pub fn file_hash(path: &Path) -> Result<String, StoreError> {
    let bytes = fs::read(path).map_err(|error| StoreError::io(path, &error))?;
    Ok(blake3::hash(&bytes).to_hex().to_string())
}

/// How the names of half-written files begin and end. They are hidden and have
/// no ending of a fixture or golden, so that none is taken for one.
const TEMPORARY: (&str, &str) = (".goldray-", ".tmp");

/// Removes the half-written files below a folder that killed programs have left
/// behind. Those that a program is writing are locked by it, and stay.
pub fn sweep(folder: &Path) {
    for entry in WalkDir::new(folder).into_iter().filter_map(Result::ok) {
        if entry.file_type().is_file() && is_temporary(entry.path()) {
            let abandoned = fs::File::options().write(true).open(entry.path());
            if abandoned.is_ok_and(|file| file.try_lock().is_ok()) {
                // Should it stay, it is as harmless as before.
                let _ = fs::remove_file(entry.path());
            }
        }
    }
}

fn is_temporary(path: &Path) -> bool {
    let name = path.file_name().unwrap_or_default().as_encoded_bytes();
    name.starts_with(TEMPORARY.0.as_bytes()) && name.ends_with(TEMPORARY.1.as_bytes())
}

/// Writes the file whole or not at all, with the folders it needs.
///
/// # Errors
/// Whatever kept it from being written; the old file is then as it was.
pub fn write(path: &Path, bytes: &[u8]) -> Result<(), StoreError> {
    write_then(path, bytes, |file| file.persist(path).map(drop).map_err(|error| error.error))
}

/// Held by whoever writes a file, for as long as it is half-written.
static WRITING: RwLock<()> = RwLock::new(());

/// Waits until no file of this program is half-written, and lets none be begun
/// for as long as the answer is held: for a program that is to end at once.
pub fn nothing_half_written() -> impl Sized {
    WRITING.write()
}

/// Whether a file may be written at this path.
///
/// # Errors
/// What is there is no file.
pub fn check_place(path: &Path) -> Result<(), StoreError> {
    if fs::metadata(path).is_ok_and(|found| !found.is_file()) {
        return Err(StoreError::new(path, "is there already, and is no file: name a file"));
    }
    Ok(())
}

/// How often a file is written again whose folder has gone meanwhile: each time
/// takes another check that begins in this very moment.
const MAX_TRIES: usize = 9;

/// Writes to a temporary file beside `path`, then gives it its place.
fn write_then(
    path: &Path,
    bytes: &[u8],
    persist: impl Fn(NamedTempFile) -> std::io::Result<()>,
) -> Result<(), StoreError> {
    check_place(path)?;
    let _writing = WRITING.read();
    let write = || {
        let folder = path.parent().unwrap_or(Path::new("."));
        fs::create_dir_all(folder)?;
        let mut temporary = tempfile::Builder::new();
        temporary.prefix(TEMPORARY.0).suffix(TEMPORARY.1);
        // Temporary files are private by default; a golden is for everyone.
        #[cfg(unix)]
        temporary.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o644));
        let mut file = temporary.tempfile_in(folder)?;
        // Held until the file has its place, so that `sweep` leaves it alone.
        // Where there are no locks, `sweep` removes nothing.
        let _ = file.as_file().try_lock();
        file.write_all(bytes)?;
        file.as_file().sync_all()?;
        persist(file)
    };
    // Another check may be emptying the folder it is in: the folder has gone, or
    // was there when it was to be made and has gone since.
    let has_gone = |error: &std::io::Error| match error.kind() {
        ErrorKind::NotFound => true,
        ErrorKind::AlreadyExists => !path.exists(),
        _ => false,
    };
    let mut written = write();
    for _ in 0..MAX_TRIES {
        match &written {
            Err(error) if has_gone(error) => written = write(),
            _ => break,
        }
    }
    written.map_err(|error| StoreError::io(path, &error))
}

/// Writes a file that must not be there yet.
///
/// # Errors
/// A file that is there, and whatever else kept it from being written.
pub fn write_new(path: &Path, bytes: &[u8]) -> Result<(), StoreError> {
    write_then(path, bytes, |file| file.persist_noclobber(path).map(drop).map_err(|e| e.error))
        .map_err(
            |error| {
                if path.exists() { StoreError::new(path, "is there already") } else { error }
            },
        )
}

/// Removes a file.
///
/// # Errors
/// A file that cannot be removed or is not there.
pub fn remove(path: &Path) -> Result<(), StoreError> {
    fs::remove_file(path).map_err(|error| StoreError::io(path, &error))
}

/// The mark of a folder that may be emptied, by the convention of
/// <https://bford.info/cachedir/>.
const ARTIFACTS_MARK: (&str, &[u8]) = (
    "CACHEDIR.TAG",
    b"Signature: 8a477f597d28d172789f06886806bc55\n# Made by goldray; emptied at each check.\n",
);

/// Whether this is no link, through which another folder would be changed.
///
/// # Errors
/// It is one, even to nothing.
pub fn check_no_link(path: &Path) -> Result<(), StoreError> {
    if fs::symlink_metadata(path).is_ok_and(|found| found.is_symlink()) {
        let what = "is a link: remove it, or put a folder in its place";
        return Err(StoreError::new(path, what));
    }
    Ok(())
}

/// An empty folder for artifacts, marked as such.
///
/// # Errors
/// A link, a folder with something in it but without the very mark that this
/// function makes, and whatever keeps it from being emptied.
pub fn empty_artifacts(path: &Path) -> Result<(), StoreError> {
    let failed = |path: &Path, error: &std::io::Error| match error.kind() {
        // Another check was faster, or is writing what it found.
        ErrorKind::NotFound | ErrorKind::DirectoryNotEmpty => Ok(()),
        _ => Err(StoreError::io(path, error)),
    };
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

/// Whether a file written at `path` would be `folder` or lie in it, by what
/// both really are. Neither need be there.
pub fn is_inside(path: &Path, folder: &Path) -> bool {
    let Some(folder) = really(folder) else { return false };
    let place = match (path.parent(), path.file_name()) {
        // A link in the file's own place is written over, not followed.
        (Some(parent), Some(name)) => {
            really(&Path::new(".").join(parent)).map(|parent| parent.join(name))
        }
        _ => really(path),
    };
    place.is_some_and(|place| place.starts_with(folder))
}

/// The path without links or relative parts, whose end need not be there. Each
/// link is followed before what stands behind it is looked at, as `link/..` is
/// beside what the link leads to.
fn really(path: &Path) -> Option<PathBuf> {
    let path = std::path::absolute(path).ok()?;
    Some(path.components().fold(PathBuf::new(), |mut really, part| {
        match part {
            Component::ParentDir => _ = really.pop(),
            Component::Normal(name) => {
                really.push(name);
                // What is not there has no links to go through.
                really = really.canonicalize().unwrap_or(really);
            }
            other => really.push(other),
        }
        really
    }))
}

/// The path without links or relative parts.
///
/// # Errors
/// A path where nothing is.
pub fn real_path(path: &Path) -> Result<PathBuf, StoreError> {
    path.canonicalize().map_err(|error| StoreError::io(path, &error))
}

/// Whether this is a file.
pub fn is_file(path: &Path) -> bool {
    path.is_file()
}

/// Whether this is a folder.
pub fn is_folder(path: &Path) -> bool {
    path.is_dir()
}

/// The names of all files below `folder` that end in `.ending`, relative, with
/// `/` between parts and without the ending, sorted. A folder that is not
/// there has none. Links to files count. Folders whose names begin with a dot
/// are passed over.
///
/// # Errors
/// A folder that cannot be walked; what would otherwise be passed over in
/// silence: a link to a folder, the ending in other letters, a hidden file or
/// no file with it, and a name that is not UTF-8 or holds characters that are not seen ([`scene::is_invisible`]);
/// and a folder whose name ends as a fixture's or a golden's does, which would
/// be in the way of one.
pub fn names(folder: &Path, ending: &str) -> Result<Vec<String>, StoreError> {
    if !folder.exists() {
        return Ok(Vec::new());
    }
    let is_hidden = |name: &std::ffi::OsStr| name.as_encoded_bytes().starts_with(b".");
    let walk = WalkDir::new(folder).into_iter().filter_entry(|entry| {
        entry.depth() == 0 || entry.file_type().is_file() || !is_hidden(entry.file_name())
    });
    let dot_ending = format!(".{ending}");
    let mut names = Vec::new();
    for entry in walk {
        let entry = entry
            .map_err(|error| StoreError::new(error.path().unwrap_or(folder), error.to_string()))?;
        let path = entry.path();
        let name = entry.file_name().as_encoded_bytes();
        let found = &name[name.len().saturating_sub(dot_ending.len())..];
        // What looks like one and is none would be passed over in silence.
        let why = if entry.path_is_symlink() && path.is_dir() {
            "is a link to a folder, which is not entered".to_owned()
        } else if entry.file_type().is_dir() && has_an_ending(path) {
            "would be in the way of a picture or a fixture: give the folder a name without that \
             ending"
                .to_owned()
        } else if !found.eq_ignore_ascii_case(dot_ending.as_bytes()) {
            continue;
        } else if found != dot_ending.as_bytes() {
            format!("expected the ending {dot_ending}")
        } else if is_hidden(entry.file_name()) {
            "has a hidden name".to_owned()
        } else if !path.is_file() {
            "is no file".to_owned()
        } else {
            String::new()
        };
        if !why.is_empty() {
            return Err(StoreError::new(path, why));
        }
        let relative = path.strip_prefix(folder).unwrap_or(path).with_extension("");
        let parts = relative.components().map(|part| part.as_os_str().to_str());
        let parts = parts
            .collect::<Option<Vec<_>>>()
            .ok_or_else(|| StoreError::new(path, "has a name that is not UTF-8"))?;
        let name = parts.join("/");
        if name.chars().any(scene::is_invisible) {
            let what = "has a character in its name that is not seen, but changes what is";
            return Err(StoreError::new(path, what));
        }
        names.push(name);
    }
    names.sort();
    Ok(names)
}

/// Whether the name ends as a fixture's or a golden's does, in any letters.
fn has_an_ending(path: &Path) -> bool {
    const ENDINGS: [&str; 2] = ["ron", "png"];
    let found = path.extension().unwrap_or_default();
    ENDINGS.iter().any(|ending| found.eq_ignore_ascii_case(ending))
}
