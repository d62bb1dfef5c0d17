//! `write`: everything that is made of a grade, into a folder.

use std::path::{Path, PathBuf};

use harness::store;

use super::{Grade, html, json, markdown};
use crate::Conformed;
use crate::card::{Look, WriteError};

/// What the files of a grade are called.
pub const FILES: [&str; 3] = ["grade.json", "grade.md", "grade.html"];

/// Writes `grade.json`, `grade.md` and `grade.html` into `folder`; what is there already
/// is written over. The files that were written.
///
/// # Errors
/// A renderer with an id that is none, before anything is written; and the first file
/// that cannot be written.
pub fn write(
    folder: &Path,
    grade: &Grade,
    conformed: &Conformed,
    look: &Look<'_>,
) -> Result<Vec<PathBuf>, WriteError> {
    let page = html(grade, conformed, look).map_err(WriteError::NoCard)?;
    let texts = [format!("{:#}\n", json(grade)), markdown(grade, conformed), page];
    let mut written = Vec::new();
    for (name, text) in FILES.into_iter().zip(texts) {
        let path = folder.join(name);
        store::write(&path, text.as_bytes()).map_err(WriteError::Store)?;
        written.push(path);
    }
    Ok(written)
}
