//! `Library`: the materials of all libraries that an OBJ file names.

use std::collections::{BTreeMap, BTreeSet};

use scene::{Assets, MAX_ASSET_BYTES, check_path};

use super::mtl::{self, Definition};
use crate::import::Unreadable;
use crate::import::mesh::unreadable;
use crate::import::mesh::words::{Word, Words};

/// Materials by name.
pub(super) struct Library<'a> {
    assets: &'a dyn Assets,
    read: BTreeSet<String>,
    materials: BTreeMap<String, Definition>,
}

impl<'a> Library<'a> {
    /// Without any.
    pub(super) fn new(assets: &'a dyn Assets) -> Self {
        Self { assets, read: BTreeSet::new(), materials: BTreeMap::new() }
    }

    /// Where files come from.
    pub(super) fn assets(&self) -> &'a dyn Assets {
        self.assets
    }

    /// A material, if a library has it.
    pub(super) fn find(&self, name: &str) -> Option<&Definition> {
        self.materials.get(name)
    }

    /// `mtllib` and the names of files. One name may have spaces.
    pub(super) fn open(
        &mut self,
        words: &Words<'_>,
        keyword: &Word<'_>,
        given: &[Word<'_>],
    ) -> Result<(), Vec<Unreadable>> {
        if given.is_empty() {
            let message = "expected the name of a file after `mtllib`, found none";
            return Err(vec![unreadable(keyword.place, message)]);
        }
        let whole = [(text(words.text(given)), given[0])];
        if given.len() > 1 && self.has(&whole[0].0) {
            return self.open_all(&whole);
        }
        let each: Vec<_> = given.iter().map(|word| (text(word.text), *word)).collect();
        self.open_all(&each)
    }

    fn has(&self, name: &str) -> bool {
        let path = without_dot(name);
        self.read.contains(path) || (check_path(path).is_ok() && self.assets.read(path).is_ok())
    }

    fn open_all(&mut self, files: &[(String, Word<'_>)]) -> Result<(), Vec<Unreadable>> {
        let mut problems = Vec::new();
        for (name, word) in files {
            let path = without_dot(name);
            if self.read.contains(path) {
                continue;
            }
            match self.bytes(path) {
                Ok(bytes) => {
                    self.read.insert(path.to_owned());
                    mtl::read(path, word.place, &bytes, &mut self.materials, &mut problems);
                }
                Err((message, help)) => {
                    let help = Some(help.to_owned());
                    problems.push(Unreadable { help, ..unreadable(word.place, message) });
                }
            }
        }
        if problems.is_empty() { Ok(()) } else { Err(problems) }
    }

    /// The bytes of a file, or why there are none and what to do.
    fn bytes(&self, path: &str) -> Result<Vec<u8>, (String, &'static str)> {
        check_path(path).map_err(|_| {
            let message = format!(
                "expected the name of a material library in the file's own folder, relative, with \
                 `/` between its parts and no `..`, found \"{path}\""
            );
            (message, "put the library beside the file and change its name here")
        })?;
        let help = "put the library there, or remove this line: its materials are then lost";
        let missing = |why| (format!("the material library \"{path}\" {why}"), help);
        let bytes = self.assets.read(path).map_err(missing)?;
        if bytes.len() as u64 > MAX_ASSET_BYTES {
            return Err(missing(format!("is larger than {MAX_ASSET_BYTES} bytes")));
        }
        Ok(bytes)
    }
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

/// Some programs write `./` before every name.
fn without_dot(path: &str) -> &str {
    path.strip_prefix("./").unwrap_or(path)
}
