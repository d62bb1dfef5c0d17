//! `Files`: the files that an imported scene names, and the names it has for
//! them.
//!
//! Names stay inside the scene's folder, and no two files share one.

use std::collections::BTreeMap;

use scene::{Assets, check_path};

/// Files gathered so far.
#[derive(Debug, Default)]
pub(super) struct Files {
    by_name: BTreeMap<String, Vec<u8>>,
}

impl Files {
    /// All of them.
    pub(super) fn into_map(self) -> BTreeMap<String, Vec<u8>> {
        self.by_name
    }

    /// Puts a file under this name, or one like it if another file has that;
    /// gives the name.
    pub(super) fn add(&mut self, wanted: &str, bytes: Vec<u8>) -> String {
        let (stem, ending) = wanted.rsplit_once('.').unwrap_or((wanted, ""));
        let mut name = wanted.to_owned();
        let mut number = 1;
        while self.by_name.get(&name).is_some_and(|taken| *taken != bytes) {
            number += 1;
            name = format!("{stem}-{number}.{ending}");
        }
        self.by_name.insert(name.clone(), bytes);
        name
    }
}

/// The bytes of a file that a foreign file names, and a name for them inside
/// the scene's folder: its own without leading `..`.
///
/// # Errors
/// What is wrong with the path, or why the file cannot be had, as the end of a
/// sentence that begins with its name.
pub(super) fn fetch(written: &str, assets: &dyn Assets) -> Result<(String, Vec<u8>), String> {
    let mut parts: Vec<&str> = Vec::new();
    for part in written.split('/') {
        match part {
            "." => {}
            ".." if parts.last().is_some_and(|last| *last != "..") => _ = parts.pop(),
            part => parts.push(part),
        }
    }
    let above = parts.iter().take_while(|part| **part == "..").count();
    let name = parts[above..].join("/");
    check_path(&name).map_err(|expected| format!("is not {expected}"))?;
    let bytes = assets.read(&parts.join("/"))?;
    Ok((name, bytes))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_stay_inside() {
        let file = |name: &str| (name.to_owned(), name.as_bytes().to_vec());
        let at_hand = BTreeMap::from(
            ["a.obj", "m/a.obj", "../a.obj", "../../m/a.obj", "/etc/x.obj"].map(file),
        );
        for (written, name) in [
            ("a.obj", "a.obj"),
            ("./a.obj", "a.obj"),
            ("m/./a.obj", "m/a.obj"),
            ("m/../a.obj", "a.obj"),
            ("../a.obj", "a.obj"),
            ("m/../../a.obj", "a.obj"),
            ("../../m/a.obj", "m/a.obj"),
        ] {
            assert_eq!(fetch(written, &at_hand).unwrap().0, name, "{written}");
        }
        for written in ["/etc/x.obj", "", "..", "m\\a.obj", "c:/a.obj", "m//a.obj", "m/"] {
            assert!(fetch(written, &at_hand).unwrap_err().contains("is not a path"), "{written}");
        }
        assert_eq!(fetch("b.obj", &at_hand).unwrap_err(), "does not exist");
    }

    #[test]
    fn two_files_never_share_a_name() {
        let mut files = Files::default();
        let names = [b"1", b"2", b"1", b"3"].map(|bytes| files.add("m/a.obj", bytes.to_vec()));
        assert_eq!(names, ["m/a.obj", "m/a-2.obj", "m/a.obj", "m/a-3.obj"]);
        assert_eq!(files.into_map().len(), 3);
    }
}
