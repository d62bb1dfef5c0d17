//! What a failure leaves behind: its pictures, and all that is needed to run the
//! renderer by hand.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use harness::encode::encode;
use harness::picture::strip_of;
use harness::store::{self, StoreError};
use harness::verdict::shell_word;
use harness::{golden, picture_file};

use super::Subject;
use crate::Evidence;

/// Where the strip of a fixture is in the folder of a run.
pub(super) fn strip_path(folder: &Path, name: &str) -> PathBuf {
    folder.join(format!("{name}.png"))
}

/// Where the files are that the renderer was given. No fixture's name ends so, as
/// it would be a fixture's file then.
fn files_path(folder: &Path, name: &str) -> PathBuf {
    folder.join(format!("{name}.files"))
}

/// What was given to a renderer, and what it gave back.
pub(super) struct Kept<'a> {
    /// The scene's files by name.
    pub(super) files: &'a BTreeMap<String, Vec<u8>>,
    /// The picture's name and bytes, if there is one.
    pub(super) output: Option<(&'a str, &'a [u8])>,
    /// What it printed.
    pub(super) said: &'a str,
    /// The program and its arguments.
    pub(super) words: &'a [String],
    /// What its environment has beside that of this program.
    pub(super) env: &'a BTreeMap<String, String>,
}

/// Writes what is needed to run a renderer by hand; how that is done.
///
/// # Errors
/// Files that cannot be written.
pub(super) fn keep(folder: &Path, name: &str, kept: &Kept<'_>) -> Result<String, StoreError> {
    let place = files_path(folder, name);
    for (file, bytes) in kept.files {
        store::write(&place.join(file), bytes)?;
    }
    if let Some((output, bytes)) = kept.output {
        store::write(&place.join(output), bytes)?;
    }
    if !kept.said.is_empty() {
        store::write(&place.join("printed.txt"), kept.said.as_bytes())?;
    }
    let variables = kept.env.iter().map(|(name, value)| quoted(&format!("{name}={value}")));
    let env = (!kept.env.is_empty()).then(|| "env".to_owned());
    let words = kept.words.iter().map(|word| quoted(word));
    let words: Vec<_> = env.into_iter().chain(variables).chain(words).collect();
    Ok(format!("cd {} && {}", quoted(&place.display().to_string()), words.join(" ")))
}

/// A word as a shell reads it, whatever it begins with.
fn quoted(word: &str) -> String {
    match word.strip_prefix('-') {
        Some(_) => {
            let rest = shell_word(&format!("x{word}"));
            // Only the quotes are of interest.
            rest.replacen('x', "", 1)
        }
        None if word.is_empty() => "''".to_owned(),
        None => shell_word(word),
    }
}

/// Writes the strip of reference, difference and actual picture, as the fixture
/// encodes its own, and the actual one linear; where the strip is.
///
/// # Errors
/// Files that cannot be written.
pub(super) fn write_strip(
    folder: &Path,
    subject: &Subject,
    evidence: &Evidence,
) -> Result<PathBuf, StoreError> {
    let path = strip_path(folder, &subject.name);
    let failed = |what: String| StoreError { path: path.clone(), what };
    let actual = encode(&evidence.actual, subject.fixture.transfer);
    let actual = actual.map_err(|error| failed(error.to_string()))?;
    let strip = strip_of(("reference", Some(&subject.rendered.encoded)), &actual);
    store::write(&path, &golden::to_png(&strip, None).map_err(failed)?)?;
    let exr = picture_file::to_exr(&evidence.actual).map_err(failed)?;
    store::write(&path.with_extension("exr"), &exr)?;
    Ok(path)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_are_quoted_where_a_shell_would_read_more() {
        for (word, expected) in [
            ("povray", "povray"),
            ("+Iscene.pov", "'+Iscene.pov'"),
            ("-A", "-A"),
            ("-a b", "'-a b'"),
            ("--", "--"),
            ("", "''"),
            ("it's", r"'it'\''s'"),
            ("$HOME", "'$HOME'"),
        ] {
            assert_eq!(quoted(word), expected);
        }
    }
}
