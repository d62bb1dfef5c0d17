//! `Stamps`: whether anything that verdicts follow from was edited, told without
//! reading the files.
//!
//! Time and size decide nothing but when to look: what is judged then is
//! content.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use crate::store::{self, Found, Stamp};
use crate::suite::Suite;

/// How files looked at one moment.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Stamps(BTreeMap<PathBuf, Stamp>);

impl Stamps {
    /// What a renderer is built from, relative to goldray's repository: files,
    /// and folders in which everything but tests counts.
    pub const SOURCES: [&str; 11] = [
        "Cargo.toml",
        "Cargo.lock",
        "rust-toolchain.toml",
        ".cargo",
        "crates/tracer",
        "crates/scene",
        "crates/interchange",
        "crates/harness",
        "crates/conform",
        // Those that are built in.
        "adapters",
        "xtask",
    ];

    /// The suite's fixtures, the meshes and textures that they may name, its goldens, and what
    /// is in the way of one.
    pub fn of_suite(suite: &Suite) -> Self {
        let is_asset = |path: &str| scene::is_mesh(path) || scene::is_texture(path);
        // A mesh or texture may be hidden, but a hidden fixture or golden is an error.
        let is_read = |path: &Path, found| match found {
            Found::Folder => true,
            Found::FolderLink => !is_hidden(path),
            Found::File if is_asset(&path.to_string_lossy()) => true,
            Found::File => ends_in(path, "ron") && !path.parent().is_some_and(is_hidden),
        };
        let is_golden = |path: &Path, found| match found {
            Found::Folder | Found::FolderLink => !is_hidden(path),
            Found::File => ends_in(path, "png"),
        };
        let mut all = store::stamps(&suite.root().join("fixtures"), &is_read);
        all.extend(store::stamps(&suite.golden_folder(), &is_golden));
        Self(all)
    }

    /// What the program is built from in the repository at `root`.
    pub fn of_sources(root: &Path) -> Self {
        const NOT_BUILT: [&str; 3] = ["target", "tests", "stress"];
        let is_built = |path: &Path, found| {
            let name = path.file_name().unwrap_or_default().to_str().unwrap_or_default();
            !is_hidden(path) && (found != Found::Folder || !NOT_BUILT.contains(&name))
        };
        let all =
            Self::SOURCES.iter().flat_map(|place| store::stamps(&root.join(place), &is_built));
        Self(all.collect())
    }

    /// The paths that are in one only, or differ, in their order.
    pub fn changed_since(&self, before: &Self) -> Vec<PathBuf> {
        let edited = self.0.iter().filter(|(path, stamp)| before.0.get(*path) != Some(*stamp));
        let gone = before.0.keys().filter(|path| !self.0.contains_key(*path));
        let mut all: Vec<_> = edited.map(|(path, _)| path).chain(gone).cloned().collect();
        all.sort();
        all
    }

    /// How many files there are.
    pub fn len(&self) -> usize {
        self.0.len()
    }

    /// Whether there is no file.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }
}

fn ends_in(path: &Path, ending: &str) -> bool {
    path.extension().is_some_and(|found| found.eq_ignore_ascii_case(ending))
}

/// Whether this path, or a folder in it, has a hidden name.
fn is_hidden(path: &Path) -> bool {
    path.iter().any(|name| name.as_encoded_bytes().starts_with(b"."))
}

#[cfg(test)]
mod tests {
    use super::*;

    const FILES: [&str; 8] = [
        "fixtures/a.ron",
        "fixtures/deep/m.OBJ",
        "fixtures/notes.txt",
        "fixtures/.a.ron.swp",
        "golden/a.png",
        "golden/.goldray-x.tmp",
        "golden/a.png~",
        "target/goldray/a.png",
    ];

    fn suite() -> (tempfile::TempDir, Suite) {
        let folder = tempfile::tempdir().unwrap();
        for file in FILES {
            store::write(&folder.path().join(file), b"x").unwrap();
        }
        let suite = Suite::open(folder.path()).unwrap();
        (folder, suite)
    }

    /// What is seen to change by this, relative to the suite.
    #[track_caller]
    fn check(change: impl Fn(&Path), expected: &[&str]) {
        let (folder, suite) = suite();
        let before = Stamps::of_suite(&suite);
        assert_eq!(before.len(), 3);
        change(folder.path());
        let changed = Stamps::of_suite(&suite).changed_since(&before);
        let expected: Vec<_> = expected.iter().map(|path| folder.path().join(path)).collect();
        assert_eq!(changed, expected);
    }

    fn write(file: &str) -> impl Fn(&Path) + '_ {
        move |root| store::write(&root.join(file), b"y").unwrap()
    }

    #[test]
    fn only_what_a_verdict_follows_from_is_looked_at() {
        check(|_| (), &[]);
        for file in ["fixtures/notes.txt", "golden/a.png~", "target/goldray/a.png", "x.ron"] {
            check(write(file), &[]);
        }
        for file in ["fixtures/.git/b.ron", "golden/.git/b.png", "golden/.goldray-y.tmp"] {
            check(write(file), &[]);
        }
        // The same count of bytes in the same moment, renamed into the place.
        for file in ["fixtures/a.ron", "fixtures/deep/m.OBJ", "golden/a.png"] {
            check(write(file), &[file]);
        }
        for file in
            ["fixtures/a/new.ply", "fixtures/a/new.PNG", "fixtures/b.ron", "golden/other/b.png"]
        {
            check(write(file), &[file]);
        }
        check(|root| store::remove(&root.join("golden/a.png")).unwrap(), &["golden/a.png"]);
    }

    #[test]
    fn what_is_hidden_or_in_the_way_is_looked_at_where_check_does() {
        for file in [
            "fixtures/.m.obj",
            "fixtures/.t.png",
            "fixtures/.h/m.ply",
            "fixtures/.b.ron",
            "golden/.b.png",
        ] {
            check(write(file), &[file]);
        }
        for folder in ["fixtures/x.RON", "golden/z.png", "golden/deep/y.ron"] {
            check(write(&format!("{folder}/notes")), &[folder]);
        }
        check(write("fixtures/more/notes"), &[]);
    }

    #[cfg(unix)]
    #[test]
    fn links_to_folders_are_seen_and_not_entered() {
        let link = |to: &'static str, at: &'static str| {
            move |root: &Path| std::os::unix::fs::symlink(to, root.join(at)).unwrap()
        };
        check(link(".", "fixtures/loop"), &["fixtures/loop"]);
        check(link("/", "golden/loop"), &["golden/loop"]);
        check(link("nowhere", "fixtures/x.ron"), &["fixtures/x.ron"]);
        check(link(".", "fixtures/.loop"), &[]);
    }

    #[test]
    fn sources_are_what_is_built() {
        let folder = tempfile::tempdir().unwrap();
        let root = folder.path();
        let built =
            ["Cargo.toml", "crates/tracer/src/lib.rs", "xtask/src/a.rs", ".cargo/config.toml"];
        let not =
            ["crates/bench/src/a.rs", "xtask/stress/a.rs", "crates/tracer/tests/a.rs", "b.rs"];
        for file in built.iter().chain(&not) {
            store::write(&root.join(file), b"").unwrap();
        }
        let mut expected: Vec<_> = built.iter().map(|file| root.join(file)).collect();
        expected.sort();
        assert_eq!(Stamps::of_sources(root).changed_since(&Stamps::default()), expected);
    }
}
