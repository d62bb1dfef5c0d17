//! `Pattern`: the name of a picture by that of the file that it belongs to.

use std::ffi::{OsStr, OsString};
use std::fmt;
use std::path::{Path, PathBuf};
use std::str::FromStr;

/// Text with parts of a file's name in it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Pattern(Vec<Part>);

#[derive(Debug, Clone, PartialEq, Eq)]
enum Part {
    Text(String),
    /// The file's name.
    File,
    /// The file's name without its ending.
    Name,
}

impl Pattern {
    /// The path that it means for a file, from where that is.
    pub(super) fn beside(&self, file: &Path) -> PathBuf {
        let parts = self.0.iter().map(|part| match part {
            Part::Text(text) => OsStr::new(text),
            Part::File => file.file_name().unwrap_or_default(),
            Part::Name => file.file_stem().unwrap_or_default(),
        });
        file.with_file_name(parts.collect::<OsString>())
    }
}

impl FromStr for Pattern {
    type Err = String;

    /// Every brace must belong to a part that is known: a mistyped one would name
    /// a picture that is nowhere.
    fn from_str(text: &str) -> Result<Self, String> {
        let (mut parts, mut rest) = (Vec::new(), text);
        while let Some(at) = rest.find(['{', '}']) {
            let (before, after) = rest.split_at(at);
            let end = after.find('}').map_or(after.len(), |end| end + 1);
            let (word, after) = after.split_at(end);
            let part = match word {
                "{file}" => Part::File,
                "{name}" => Part::Name,
                _ => return Err(format!("expected {{file}} or {{name}}, found {word}")),
            };
            parts.extend([Part::Text(before.to_owned()), part]);
            rest = after;
        }
        parts.push(Part::Text(rest.to_owned()));
        Ok(Self(parts))
    }
}

impl fmt::Display for Pattern {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.iter().try_for_each(|part| match part {
            Part::Text(text) => f.write_str(text),
            Part::File => f.write_str("{file}"),
            Part::Name => f.write_str("{name}"),
        })
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]

    use super::*;

    #[test]
    fn parts_are_filled_in_once() {
        let check = |pattern: &str, file: &str, expected: &str| {
            let found: Pattern = pattern.parse().unwrap();
            assert_eq!(found.to_string(), pattern);
            assert_eq!(found.beside(Path::new(file)), Path::new(expected), "{pattern}");
        };
        check("{file}.png", "in/a.b.xml", "in/a.b.xml.png");
        check("{name}_ref.exr", "in/a.b.xml", "in/a.b_ref.exr");
        check("../{name}/{file}", "in/a.xml", "in/../a/a.xml");
        check("/refs/{name}.png", "in/a.xml", "/refs/a.png");
        check("a.png", "a.xml", "a.png");
        // What a file's own name has in braces is its name.
        check("{file}.png", "in/{name}.xml", "in/{name}.xml.png");
    }

    #[test]
    fn what_is_mistyped_is_told() {
        for (pattern, found) in [
            ("{nmae}.png", "{nmae}"),
            ("{name}.{x}", "{x}"),
            ("{}.png", "{}"),
            ("{File}.png", "{File}"),
            ("{name.png", "{name.png"),
            ("name}.png", "}"),
            ("{{name}}.png", "{{name}"),
        ] {
            let expected = format!("expected {{file}} or {{name}}, found {found}");
            assert_eq!(pattern.parse::<Pattern>(), Err(expected));
        }
    }

    #[cfg(unix)]
    #[test]
    fn names_that_are_no_text_are_kept() {
        use std::os::unix::ffi::OsStrExt as _;

        let pattern: Pattern = "{name}.png".parse().unwrap();
        let found = pattern.beside(Path::new(OsStr::from_bytes(b"in/\xff.xml")));
        assert_eq!(found, Path::new(OsStr::from_bytes(b"in/\xff.png")));
    }
}
