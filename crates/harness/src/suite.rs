//! `Suite`: the fixtures and goldens of a folder, and which of them are asked
//! for.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use crate::called::command;
use crate::filter::{self, FilterError};
use crate::store::{self, StoreError};

/// A folder with `fixtures/` and `golden/` in it.
#[derive(Debug, Clone)]
pub struct Suite {
    root: PathBuf,
}

/// Names of a suite, sorted.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Selection {
    /// Fixtures.
    pub fixtures: Vec<String>,
    /// Goldens without a fixture.
    pub orphans: Vec<String>,
}

/// Why nothing can be asked of a suite.
#[derive(Debug, thiserror::Error)]
pub enum SuiteError {
    /// There is no suite here.
    #[error(
        "{}: expected a folder with `fixtures/` in it, found none from here up; to begin one here, \
         make that folder, then: {} new area/name",
        .0.display(), command()
    )]
    NoSuite(PathBuf),
    /// There is nothing in it.
    #[error(
        "{}: expected at least one fixture (*.ron), found none; to write one: {} new area/name",
        .0.display(), command()
    )]
    Empty(PathBuf),
    /// A folder that would be in the way of what a check writes.
    #[error("{}: expected another name for the outermost folder: a check writes a file of this name beside its pictures", .0.display())]
    Reserved(PathBuf),
    /// A filter that selects nothing.
    #[error(transparent)]
    Filter(#[from] FilterError),
    /// A folder that cannot be read.
    #[error(transparent)]
    Store(#[from] StoreError),
}

impl Suite {
    /// The suite at `root`.
    ///
    /// # Errors
    /// A folder without `fixtures/`.
    pub fn open(root: &Path) -> Result<Self, SuiteError> {
        if store::is_folder(&root.join("fixtures")) {
            Ok(Self { root: root.to_owned() })
        } else {
            Err(SuiteError::NoSuite(root.to_owned()))
        }
    }

    /// The suite's folder.
    pub fn root(&self) -> &Path {
        &self.root
    }

    /// The file of a fixture.
    pub fn fixture_path(&self, name: &str) -> PathBuf {
        self.root.join("fixtures").join(format!("{name}.ron"))
    }

    /// A fixture's file relative to the suite, as messages show it.
    pub fn fixture_label(name: &str) -> String {
        format!("fixtures/{name}.ron")
    }

    /// A golden's file relative to the suite.
    pub fn golden_label(name: &str) -> String {
        format!("golden/{name}.png")
    }

    /// The folder of the goldens.
    pub fn golden_folder(&self) -> PathBuf {
        self.root.join("golden")
    }

    /// The file of a golden.
    pub fn golden_path(&self, name: &str) -> PathBuf {
        self.golden_folder().join(format!("{name}.png"))
    }

    /// The sheet of all goldens, relative to the suite.
    pub const CONTACT_SHEET: &str = "docs/contact-sheet.png";

    /// The folder for what a run leaves behind, relative to the suite.
    pub const ARTIFACTS: &str = "target/goldray";

    /// The page that a check writes, relative to the suite.
    pub const REPORT: &str = "target/goldray/report.html";

    /// The folder for what other renderers leave behind, relative to the suite. It
    /// is no part of [`Suite::ARTIFACTS`], which every check empties.
    pub const CONFORM: &str = "target/goldray-conform";

    /// The folder for what one run tells the next, relative to the suite.
    pub const CACHE: &str = "target/goldray-cache";

    /// The record of matches, relative to the suite.
    pub const RECORD: &str = "target/goldray-cache/matches.json";

    /// The names of what was no match, relative to the suite.
    pub const FAILED: &str = "target/goldray-cache/failed.json";

    /// The record of matches.
    pub fn record_path(&self) -> PathBuf {
        self.root.join(Self::RECORD)
    }

    /// The folder for what a run leaves behind.
    pub fn artifacts(&self) -> PathBuf {
        self.root.join(Self::ARTIFACTS)
    }

    /// What the filters select, or everything if there are none.
    ///
    /// A filter selects the fixture of exactly its name (or path) if there is
    /// one; with `*` or `?` in it, the names it matches as a whole; else all
    /// names that contain it. Goldens without a fixture are selected in the same way.
    ///
    /// # Errors
    /// A suite without fixtures, a filter that selects nothing, and folders
    /// that cannot be read.
    pub fn select(&self, filters: &[String]) -> Result<Selection, SuiteError> {
        let fixtures = store::names(&self.root.join("fixtures"), "ron")?;
        let goldens = store::names(&self.root.join("golden"), "png")?;
        if fixtures.is_empty() && goldens.is_empty() {
            return Err(SuiteError::Empty(self.root.join("fixtures")));
        }
        let known: BTreeSet<_> = fixtures.iter().chain(&goldens).cloned().collect();
        if let Some(name) = known.iter().find(|name| is_of_artifacts(name)) {
            return Err(SuiteError::Reserved(self.fixture_path(name)));
        }
        let written: Vec<_> = filters.iter().map(|filter| name_among(&known, filter)).collect();
        let selected = filter::select(&known, &written, &format!("{} list", command()))?;
        let is_selected = |name: &String| filters.is_empty() || selected.contains(name);
        let has_fixture: BTreeSet<_> = fixtures.iter().collect();
        Ok(Selection {
            orphans: goldens
                .iter()
                .filter(|name| !has_fixture.contains(name) && is_selected(name))
                .cloned()
                .collect(),
            fixtures: fixtures.iter().filter(|name| is_selected(name)).cloned().collect(),
        })
    }
}

/// Whether the pictures of this name would be in a folder where a check writes a
/// file.
fn is_of_artifacts(name: &str) -> bool {
    const FILES: [&str; 2] = ["report.html", "CACHEDIR.TAG"];
    let folder = name.split_once('/').map(|(folder, _)| folder);
    // Some systems do not tell upper from lower case.
    folder.is_some_and(|folder| FILES.iter().any(|file| folder.eq_ignore_ascii_case(file)))
}

/// The name in what may be a fixture's path, as completed by a shell.
pub fn name_of(path: &str) -> &str {
    let path = path.strip_prefix("./").unwrap_or(path);
    let path = path.strip_prefix("fixtures/").unwrap_or(path);
    path.strip_suffix(".ron").unwrap_or(path)
}

/// The known name that a filter says as a name or as a path; what [`name_of`]
/// makes of it where there is none. `fixtures/` may belong to the name itself.
fn name_among<'a>(known: &BTreeSet<String>, filter: &'a str) -> &'a str {
    let inner = name_of(filter);
    let whole = filter.strip_suffix(".ron").unwrap_or(filter);
    // Only a path has the ending.
    let order = if whole == filter { [whole, inner] } else { [inner, whole] };
    order.into_iter().find(|name| known.contains(*name)).unwrap_or(inner)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn suite(files: &[&str]) -> (tempfile::TempDir, Suite) {
        let folder = tempfile::tempdir().unwrap();
        for file in files {
            store::write(&folder.path().join(file), b"").unwrap();
        }
        let suite = Suite::open(folder.path()).unwrap();
        (folder, suite)
    }

    const FILES: &[&str] = &[
        "fixtures/sphere/far.ron",
        "fixtures/sphere/far-away.ron",
        "fixtures/box/flat.ron",
        "fixtures/box/notes.txt",
        "fixtures/.hidden/x.ron",
        "golden/sphere/far.png",
        "golden/sphere/gone.png",
    ];

    #[track_caller]
    fn check(filters: &[&str], fixtures: &[&str], orphans: &[&str]) {
        let (_folder, suite) = suite(FILES);
        let filters: Vec<_> = filters.iter().map(|&f| f.to_owned()).collect();
        let selection = suite.select(&filters).unwrap();
        assert_eq!(selection.fixtures, fixtures);
        assert_eq!(selection.orphans, orphans);
    }

    #[test]
    fn filters_select_by_name_part_or_pattern() {
        let all = ["box/flat", "sphere/far", "sphere/far-away"];
        check(&[], &all, &["sphere/gone"]);
        check(&["sphere/far"], &["sphere/far"], &[]);
        check(&["sphere/"], &["sphere/far", "sphere/far-away"], &["sphere/gone"]);
        check(&["fa"], &["sphere/far", "sphere/far-away"], &[]);
        check(&["*/f*t"], &["box/flat"], &[]);
        check(&["sphere/???"], &["sphere/far"], &[]);
        check(&["flat", "gone"], &["box/flat"], &["sphere/gone"]);
        check(&["fixtures/sphere/far.ron"], &["sphere/far"], &[]);
    }

    #[test]
    fn a_folder_of_fixtures_may_have_their_name() {
        #[track_caller]
        fn check(names: &[&str], filter: &str, expected: &[&str]) {
            let files: Vec<_> = names.iter().map(|name| format!("fixtures/{name}.ron")).collect();
            let files: Vec<_> = files.iter().map(String::as_str).collect();
            let (_folder, suite) = suite(&files);
            assert_eq!(suite.select(&[filter.to_owned()]).unwrap().fixtures, expected, "{filter}");
        }
        let inner = ["fixtures/x", "fixtures/xy"];
        check(&inner, "fixtures/x", &["fixtures/x"]);
        check(&inner, "fixtures/fixtures/x", &["fixtures/x"]);
        check(&inner, "./fixtures/fixtures/x.ron", &["fixtures/x"]);
        check(&inner, "x", &inner);
        let both = ["fixtures/x", "x", "xy"];
        check(&both, "fixtures/x", &["fixtures/x"]);
        check(&both, "fixtures/x.ron", &["x"]);
        check(&both, "./fixtures/x.ron", &["x"]);
        check(&both, "fixtures/xy", &["xy"]);
        check(&both, "x", &["x"]);
    }

    #[test]
    fn nothing_selected_is_an_error() {
        let (_folder, suite) = suite(FILES);
        let error = |filter: &str| suite.select(&[filter.to_owned()]).unwrap_err().to_string();
        let hint = "the filter \"sphere/fra\" selects nothing; did you mean \"sphere/far\"?";
        assert_eq!(error("sphere/fra"), hint);
        assert!(error("").contains("an empty filter"));
        assert!(error("zzzzzzzzzz").ends_with("`cargo xtask list` shows all names"));
    }

    #[test]
    fn no_folder_is_in_the_way_of_a_checks_files() {
        for name in ["fixtures/report.html/a.ron", "fixtures/CacheDir.Tag/b/a.ron"] {
            let (_folder, suite) = suite(&[name]);
            assert!(matches!(suite.select(&[]), Err(SuiteError::Reserved(_))), "{name}");
        }
        let fine = "fixtures/report.html.ron";
        let (_folder, suite) = suite(&[fine, "fixtures/a/report.html/b.ron"]);
        assert_eq!(suite.select(&[]).unwrap().fixtures.len(), 2);
    }

    #[test]
    fn a_folder_without_fixtures_is_no_suite() {
        let folder = tempfile::tempdir().unwrap();
        assert!(matches!(Suite::open(folder.path()), Err(SuiteError::NoSuite(_))));
        let (_folder, suite) = suite(&["fixtures/readme.txt"]);
        assert!(matches!(suite.select(&[]), Err(SuiteError::Empty(_))));
    }
}
