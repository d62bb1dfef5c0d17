//! The parts of a document that commands write: whatever is between two marks.

use std::path::Path;

use crate::store;

/// The largest document that is read, in bytes: far above any that is read by
/// people.
const MAX_BYTES: u64 = 1 << 22;

/// The text of a document.
///
/// # Errors
/// A file that is not there or is no text, as the rest of a sentence.
pub fn read(path: &Path) -> Result<String, String> {
    let bytes = store::read(path, MAX_BYTES).map_err(|error| error.what)?;
    let bytes = bytes.ok_or("there is no such file")?;
    String::from_utf8(bytes).map_err(|_| "expected UTF-8 text".to_owned())
}

/// The document with another text between the marks `<!-- name -->` and
/// `<!-- /name -->`, each on a line of its own.
///
/// # Errors
/// A document without these marks, or with one of them twice.
pub fn replaced(document: &str, name: &str, text: &str) -> Result<String, String> {
    let once = |mark: &str| {
        let mut all = document.match_indices(mark).map(|(at, _)| at);
        match (all.next(), all.next()) {
            (Some(at), None) => Ok(at),
            (found, _) => {
                let count = if found.is_none() { "none" } else { "several" };
                Err(format!("expected the mark `{}` once, found {count}", mark.trim()))
            }
        }
    };
    let (open, close) = (format!("<!-- {name} -->\n"), format!("<!-- /{name} -->"));
    let start = once(&open)? + open.len();
    let end = once(&close)?;
    if end < start {
        return Err(format!("expected `{}` before `{close}`", open.trim()));
    }
    Ok([&document[..start], text, &document[end..]].concat())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(document: &str, expected: Result<&str, &str>) {
        let found = replaced(document, "x", "new\n");
        assert_eq!(found, expected.map(str::to_owned).map_err(str::to_owned), "{document:?}");
    }

    #[test]
    fn only_what_is_between_the_marks_changes() {
        check("a\n<!-- x -->\nold\n<!-- /x -->\nb", Ok("a\n<!-- x -->\nnew\n<!-- /x -->\nb"));
        check("<!-- x -->\n<!-- /x -->", Ok("<!-- x -->\nnew\n<!-- /x -->"));
        check("", Err("expected the mark `<!-- x -->` once, found none"));
        check("<!-- x -->\n", Err("expected the mark `<!-- /x -->` once, found none"));
        let twice = "<!-- x -->\n<!-- x -->\n<!-- /x -->";
        check(twice, Err("expected the mark `<!-- x -->` once, found several"));
        let swapped = "<!-- /x -->\n<!-- x -->\n";
        check(swapped, Err("expected `<!-- x -->` before `<!-- /x -->`"));
    }
}
