//! `Names`: what the files of meshes are called, each name once.

use std::collections::BTreeSet;

/// Names given so far.
#[derive(Debug)]
pub(in crate::import) struct Names {
    stem: String,
    taken: BTreeSet<String>,
}

impl Names {
    /// Names like that of a file.
    pub(in crate::import) fn of(source: &str) -> Self {
        let file = source.rsplit(['/', '\\']).next().unwrap_or(source);
        let stem = file.rsplit_once('.').map_or(file, |(stem, _)| stem);
        Self { stem: plain(stem), taken: BTreeSet::new() }
    }

    /// A name for the mesh of a material. It is not the source's own.
    pub(in crate::import) fn file(&mut self, material: Option<&str>) -> String {
        let whole = format!("{}-{}", self.stem, plain(material.unwrap_or("mesh")));
        let mut name = whole.clone();
        let mut number = 1;
        // Some systems take letters of both cases for the same.
        while !self.taken.insert(name.to_lowercase()) {
            number += 1;
            name = format!("{whole}-{number}");
        }
        name + ".obj"
    }
}

/// Letters and digits, with dashes for everything else, and not too many.
fn plain(name: &str) -> String {
    const LONGEST: usize = 60;
    let letter = |c: char| if c.is_ascii_alphanumeric() || c == '_' { c } else { '-' };
    let plain: String = name.chars().take(LONGEST).map(letter).collect();
    if plain.is_empty() { "mesh".to_owned() } else { plain }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_plain_and_their_own() {
        let mut names = Names::of("some/where/Bun ny.old.obj");
        assert_eq!(names.file(None), "Bun-ny-old-mesh.obj");
        assert_eq!(names.file(Some("../red")), "Bun-ny-old----red.obj");
        assert_eq!(names.file(Some("..\\RED")), "Bun-ny-old----RED-2.obj");
        assert_eq!(names.file(Some("")), "Bun-ny-old-mesh-2.obj");
        assert_eq!(Names::of(".obj").file(None), "mesh-mesh.obj");
        for name in [Names::of("\u{0}").file(None), Names::of("a/").file(Some("ü\n"))] {
            assert!(scene::check_path(&name).is_ok() && scene::is_mesh(&name), "{name}");
        }
    }
}
