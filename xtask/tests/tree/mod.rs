//! `Tree`: a suite in a temporary folder, with the real binary to run there.
// Each file of tests is a program of its own, and none uses all of this.
#![allow(dead_code, unreachable_pub)]

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

/// A white square in the middle of black, which renders in no time.
pub(crate) const SQUARE: &str = r"// A square.
(
    version: 1,
    image: (16, 12),
    camera: Parallel(view_point: (0, 0, 5), view_width: 4, view_height: 3),
    show: Silhouette,
    objects: [Box(min: (-1, -1, -1), max: (1, 1, 1))],
)";

/// The square without its upper half.
pub(crate) fn flat() -> String {
    SQUARE.replace("(1, 1, 1)", "(1, 0.5, 1)")
}

/// A folder with some fixtures, and the binary to run there.
pub(crate) struct Tree(pub(crate) tempfile::TempDir);

impl Tree {
    /// The fixtures alone.
    pub(crate) fn new(fixtures: &[(&str, &str)]) -> Self {
        let tree = Self(tempfile::tempdir().unwrap());
        for (name, text) in fixtures {
            tree.write(&format!("fixtures/{name}.ron"), text.as_bytes());
        }
        tree
    }

    /// The same, with goldens for all.
    pub(crate) fn blessed(fixtures: &[(&str, &str)]) -> Self {
        let tree = Self::new(fixtures);
        tree.run(&["bless", "--all"]).expect_code(0);
        tree
    }

    /// One of a kind: `add/ed` has no golden, `broken` breaks its word, `changed`
    /// has another scene's golden, `gone` has no fixture, `same` is a match.
    pub(crate) fn failing() -> Self {
        let tree = Self::blessed(&[("changed", SQUARE), ("gone", SQUARE), ("same", SQUARE)]);
        fs::remove_file(tree.path("fixtures/gone.ron")).unwrap();
        tree.write("fixtures/changed.ron", flat().as_bytes());
        tree.write("fixtures/add/ed.ron", SQUARE.as_bytes());
        let broken = "check: (expect: [Radiance(at: (0, 0), rgb: (9, 9, 9))]), image";
        tree.write("fixtures/broken.ron", SQUARE.replace("image", broken).as_bytes());
        tree
    }

    /// A file of it.
    pub(crate) fn path(&self, path: &str) -> std::path::PathBuf {
        self.0.path().join(path)
    }

    /// Writes a file, with its folders.
    pub(crate) fn write(&self, path: &str, bytes: &[u8]) {
        let path = self.path(path);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, bytes).unwrap();
    }

    /// Runs the binary with these arguments.
    pub(crate) fn run(&self, args: &[&str]) -> Ran {
        self.run_with(args, &[])
    }

    /// The same with these variables.
    pub(crate) fn run_with(&self, args: &[&str], variables: &[(&str, &str)]) -> Ran {
        Ran(self.command(args).envs(variables.iter().copied()).output().unwrap())
    }

    /// The binary with these arguments, to be started.
    pub(crate) fn command(&self, args: &[&str]) -> Command {
        self.command_of(Path::new(env!("CARGO_BIN_EXE_xtask")), args)
    }

    /// The same with another binary.
    pub(crate) fn command_of(&self, program: &Path, args: &[&str]) -> Command {
        let mut command = Command::new(program);
        command.args(args).current_dir(self.0.path());
        // What a build server sets, which would change what is done.
        for variable in ["CI", "GITHUB_ACTIONS", "GITHUB_STEP_SUMMARY", "GITHUB_WORKSPACE"] {
            command.env_remove(variable);
        }
        command
    }
}

/// A program that has ended.
pub(crate) struct Ran(pub(crate) Output);

impl Ran {
    pub(crate) fn stdout(&self) -> String {
        String::from_utf8(self.0.stdout.clone()).unwrap()
    }

    pub(crate) fn stderr(&self) -> String {
        String::from_utf8(self.0.stderr.clone()).unwrap()
    }

    #[track_caller]
    pub(crate) fn expect_code(self, code: i32) -> Self {
        let found = self.0.status.code();
        assert_eq!(found, Some(code), "{}\n{}", self.stdout(), self.stderr());
        self
    }

    #[track_caller]
    pub(crate) fn expect(self, text: &str) -> Self {
        let all = format!("{}{}", self.stdout(), self.stderr());
        assert!(all.contains(text), "expected {text:?} in:\n{all}");
        self
    }
}
