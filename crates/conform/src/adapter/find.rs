//! Where an adapter is that was asked for by a name or a path, and where its
//! program is.

use std::ffi::OsStr;
use std::path::{Path, PathBuf};

use harness::store;
use harness::suite::Suite;

use super::builtin::{BUILTIN, Builtin};

/// An adapter's text.
#[derive(Debug, Clone)]
pub struct Located {
    /// The name of its folders: letters, digits, `-` and `_`.
    pub id: String,
    /// What it is called in messages.
    pub label: String,
    /// The adapter file.
    pub text: String,
    /// Where it is; `None` for one that comes with this program.
    pub path: Option<PathBuf>,
    /// Its folder; `None` for one that comes with this program.
    pub folder: Option<PathBuf>,
    /// The programs that it needs in a folder of its own.
    pub programs: &'static [(&'static str, &'static [u8])],
}

/// The largest adapter file that is read, in bytes.
const MAX_BYTES: u64 = 1 << 20;

/// The folder of a suite's own adapters.
const FOLDER: &str = "adapters";

/// Finds an adapter. What has a `/` or ends in `.ron` is a path: of the file, or of
/// a folder with an `adapter.ron`. A name is looked for as
/// `adapters/NAME/adapter.ron` and `adapters/NAME.ron` of the suite, then among those
/// that come with this program.
///
/// # Errors
/// There is none, or it cannot be read, as text for people.
pub fn locate(suite: &Suite, wanted: &str) -> Result<Located, String> {
    let is_path = wanted.contains(['/', std::path::MAIN_SEPARATOR])
        || Path::new(wanted).extension().is_some_and(|ending| ending == "ron");
    if is_path {
        let path = Path::new(wanted);
        let path = if store::is_folder(path) { path.join("adapter.ron") } else { path.to_owned() };
        return read(&path)?.ok_or_else(|| {
            format!("{}: expected an adapter file, found no such file", path.display())
        });
    }
    let folder = suite.root().join(FOLDER);
    for path in [folder.join(wanted).join("adapter.ron"), folder.join(format!("{wanted}.ron"))] {
        if let Some(found) = read(&path)? {
            return Ok(found);
        }
    }
    if let Some(&Builtin { name, text, programs }) =
        BUILTIN.iter().find(|builtin| builtin.name == wanted)
    {
        let (id, label) = (name.to_owned(), format!("adapter.ron of {name}, built in"));
        return Ok(Located {
            id,
            label,
            text: text.to_owned(),
            path: None,
            folder: None,
            programs,
        });
    }
    let mut known: Vec<String> = BUILTIN.iter().map(|builtin| builtin.name.to_owned()).collect();
    for name in store::names(&folder, "ron").map_err(|error| error.to_string())? {
        known.push(name.strip_suffix("/adapter").unwrap_or(&name).to_owned());
    }
    known.sort();
    known.dedup();
    let meant = scene::nearest(wanted, known.iter().map(String::as_str));
    let meant = meant.map_or(String::new(), |near| format!("did you mean \"{near}\"? "));
    Err(format!(
        "there is no adapter \"{wanted}\": {meant}expected a path, or one of {}",
        known.join(", ")
    ))
}

/// The adapter in a file, if there is one.
fn read(path: &Path) -> Result<Option<Located>, String> {
    let Some(bytes) = store::read(path, MAX_BYTES).map_err(|error| error.to_string())? else {
        return Ok(None);
    };
    let label = path.display().to_string();
    let text = String::from_utf8(bytes).map_err(|error| {
        let at = error.utf8_error().valid_up_to();
        format!("{label}: expected UTF-8 text, found another byte at offset {at}")
    })?;
    let absolute = store::real_path(path).map_err(|error| error.to_string())?;
    let folder = absolute.parent().map(Path::to_owned);
    let own_name = match path.file_name() {
        Some(name) if name == "adapter.ron" => folder.as_deref().and_then(Path::file_name),
        _ => path.file_stem(),
    };
    let id = id_of(&own_name.unwrap_or_default().to_string_lossy());
    let path = Some(absolute);
    Ok(Some(Located { id, label, text, path, folder, programs: &[] }))
}

/// A name in which every other character became `-`; never empty.
fn id_of(name: &str) -> String {
    let plain = |c: char| if c.is_ascii_alphanumeric() || c == '_' { c } else { '-' };
    let id: String = name.chars().map(plain).collect();
    if id.is_empty() { "renderer".to_owned() } else { id }
}

/// Where the program of a command is: as it is written where it is a path, else in
/// the first of these folders that has it, as in `PATH`.
pub fn find_program(word: &str, folders: &OsStr) -> Option<PathBuf> {
    let path = Path::new(word);
    if path.components().count() > 1 || path.is_absolute() {
        return store::is_program(path).then(|| path.to_owned());
    }
    let endings: &[&str] = if cfg!(windows) { &["", ".exe", ".cmd", ".bat"] } else { &[""] };
    let places = std::env::split_paths(folders).flat_map(|folder| {
        endings.iter().map(move |ending| folder.join(format!("{word}{ending}")))
    });
    places.into_iter().find(|place| store::is_program(place))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ids_are_names_of_folders() {
        for (name, expected) in [
            ("povray", "povray"),
            ("my tracer.v2", "my-tracer-v2"),
            ("../x", "---x"),
            ("", "renderer"),
        ] {
            assert_eq!(id_of(name), expected, "{name}");
        }
    }

    #[test]
    fn a_program_is_looked_for_in_folders() {
        let shell = find_program("sh", OsStr::new("/no/such:/bin:/usr/bin"));
        assert_eq!(shell, Some("/bin/sh".into()));
        assert_eq!(find_program("sh", OsStr::new("/no/such")), None);
        assert_eq!(find_program("/bin/sh", OsStr::new("")), Some("/bin/sh".into()));
        assert_eq!(find_program("/bin/no-such", OsStr::new("/bin")), None);
        // A folder and a file that nobody may run are no programs.
        assert_eq!(find_program("/bin", OsStr::new("")), None);
        assert_eq!(find_program("/etc/passwd", OsStr::new("")), None);
    }
}
