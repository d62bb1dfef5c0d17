//! What the conformance tests share: the suite of this repository, and small
//! suites to break.
//!
//! `fixtures.rs` is the suite seen through `cargo test`, one named test for
//! each fixture; `verdicts.rs` proves that the harness can fail;
//! `determinism.rs` that nothing but the scene decides a picture; `read_back.rs`
//! and `pbrt.rs` that what is written in other languages is the scene; and
//! `house.rs` that the invariants of `ARCHITECTURE.md` hold.

use std::path::{Path, PathBuf};

use harness::suite::Suite;
use harness::{bless, run, store};

/// The folder of this repository.
pub fn repository() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// The suite of this repository.
///
/// # Panics
/// Where there is none.
#[allow(clippy::expect_used)]
pub fn repository_suite() -> Suite {
    Suite::open(&repository()).expect("the repository has fixtures")
}

/// A suite in a temporary folder, which goes away with it.
#[derive(Debug)]
pub struct Scratch {
    folder: tempfile::TempDir,
    suite: Suite,
}

/// A fixture that renders in no time: a white square in the middle of black.
pub const SQUARE: &str = r"(
    version: 1,
    image: (16, 12),
    camera: Parallel(view_point: (0, 0, 5), view_width: 4, view_height: 3),
    show: Silhouette,
    objects: [Box(min: (-1, -1, -1), max: (1, 1, 1))],
    check: (expect: [Count(rgb: (255, 255, 255), pixels: 64)]),
)";

#[allow(clippy::expect_used)]
impl Scratch {
    /// A suite of these fixtures, all blessed.
    ///
    /// # Panics
    /// Where it cannot be made.
    pub fn blessed(fixtures: &[(&str, &str)]) -> Self {
        let folder = tempfile::tempdir().expect("a temporary folder");
        for (name, text) in fixtures {
            let path = folder.path().join("fixtures").join(format!("{name}.ron"));
            store::write(&path, text.as_bytes()).expect("a fixture");
        }
        let suite = Suite::open(folder.path()).expect("a suite");
        let selection = suite.select(&[]).expect("some fixtures");
        bless::bless(&suite, &selection, false).expect("goldens that nobody else writes");
        Self { folder, suite }
    }

    /// The suite.
    pub fn suite(&self) -> &Suite {
        &self.suite
    }

    /// Its folder.
    pub fn folder(&self) -> &Path {
        self.folder.path()
    }

    /// Its golden's bytes.
    ///
    /// # Panics
    /// Where there is none.
    pub fn golden(&self, name: &str) -> Vec<u8> {
        let bytes = store::read(&self.suite.golden_path(name), 1 << 20).expect("readable");
        bytes.expect("a golden")
    }

    /// Puts other bytes in the golden's place.
    ///
    /// # Panics
    /// Where they cannot be written.
    pub fn set_golden(&self, name: &str, bytes: &[u8]) {
        store::write(&self.suite.golden_path(name), bytes).expect("a golden");
    }

    /// Puts another text in the fixture's place.
    ///
    /// # Panics
    /// Where it cannot be written.
    pub fn set_fixture(&self, name: &str, text: &str) {
        store::write(&self.suite.fixture_path(name), text.as_bytes()).expect("a fixture");
    }

    /// The verdicts of a run by name.
    ///
    /// # Panics
    /// Where the suite cannot be run.
    pub fn verdicts(&self) -> Vec<(String, &'static str)> {
        let selection = self.suite.select(&[]).expect("some fixtures");
        let outcomes = run::run(&self.suite, &selection, &|_| ()).expect("artifacts");
        outcomes.into_iter().map(|o| (o.name, o.verdict.id())).collect()
    }
}
