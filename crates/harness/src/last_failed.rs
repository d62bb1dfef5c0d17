//! `last_failed`: the names of what was no match when it was last checked.

use std::collections::BTreeSet;
use std::path::PathBuf;

use serde::{Deserialize, Serialize};

use crate::called::command;
use crate::store::{self, StoreError};
use crate::suite::{Selection, Suite};
use crate::verdict::{Outcome, Verdict};

/// The largest document that is read, in bytes: far above 10,000 names.
const MAX_BYTES: u64 = 1 << 26;

/// The version that is written, and the only one that is read.
const SCHEMA: u32 = 1;

/// The document.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Failed {
    schema: u32,
    failed: BTreeSet<String>,
}

/// Why there is nothing to check again.
#[derive(Debug, thiserror::Error)]
pub enum LastFailedError {
    /// Nobody knows what failed.
    #[error(
        "expected the names of what failed in the last check, found none in {}: run `{} \
         check` once",
        Suite::FAILED,
        command()
    )]
    Unknown,
    /// Nothing failed.
    #[error("no fixture failed in the last check")]
    Nothing,
    /// What failed is not among what was selected.
    #[error("none of the {0} that failed in the last check is selected")]
    NotSelected(usize),
    /// What failed is not among what there is.
    #[error("none of the {0} that failed in the last check is in the suite any more")]
    Gone(usize),
}

/// Of what is selected, what was no match when it was last checked.
///
/// # Errors
/// Nothing is left: that would be a check that asks nothing.
pub fn select(suite: &Suite, selection: &Selection) -> Result<Selection, LastFailedError> {
    let failed = read(suite).ok_or(LastFailedError::Unknown)?;
    let of =
        |names: &[String]| names.iter().filter(|name| failed.contains(*name)).cloned().collect();
    let left = Selection { fixtures: of(&selection.fixtures), orphans: of(&selection.orphans) };
    let is_there = |name: &String| {
        store::is_file(&suite.fixture_path(name)) || store::is_file(&suite.golden_path(name))
    };
    match (left.fixtures.len() + left.orphans.len(), failed.len()) {
        (0, 0) => Err(LastFailedError::Nothing),
        (0, n) if failed.iter().any(is_there) => Err(LastFailedError::NotSelected(n)),
        (0, n) => Err(LastFailedError::Gone(n)),
        _ => Ok(left),
    }
}

/// Keeps which of these are no match. What was not judged stays as it was,
/// unless this `is_all` of the suite.
///
/// # Errors
/// A file that cannot be written, or a link in its folder's place.
pub fn keep(suite: &Suite, outcomes: &[Outcome], is_all: bool) -> Result<(), StoreError> {
    let known = read(suite);
    let mut failed = known.clone().filter(|_| !is_all).unwrap_or_default();
    for outcome in outcomes {
        match outcome.verdict {
            Verdict::Match => _ = failed.remove(&outcome.name),
            _ => _ = failed.insert(outcome.name.clone()),
        }
    }
    if known.as_ref() == Some(&failed) {
        return Ok(());
    }
    let path = path(suite)?;
    let json = serde_json::to_vec_pretty(&Failed { schema: SCHEMA, failed });
    let json = json.map_err(|error| StoreError { path: path.clone(), what: error.to_string() })?;
    store::write(&path, &json)
}

fn path(suite: &Suite) -> Result<PathBuf, StoreError> {
    let path = suite.root().join(Suite::FAILED);
    path.parent().map_or(Ok(()), store::check_no_link)?;
    Ok(path)
}

/// What is written; `None` where that cannot be read.
fn read(suite: &Suite) -> Option<BTreeSet<String>> {
    let bytes = store::read(&path(suite).ok()?, MAX_BYTES).ok().flatten()?;
    let found: Failed = serde_json::from_slice(&bytes).ok()?;
    (found.schema == SCHEMA).then_some(found.failed)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn outcome(name: &str, verdict: Verdict) -> Outcome {
        Outcome::unrendered(name, verdict)
    }

    /// A suite with three fixtures, `a`, `b` and `c`.
    fn suite() -> (tempfile::TempDir, Suite) {
        let folder = tempfile::tempdir().unwrap();
        for name in ["a", "b", "c"] {
            store::write(&folder.path().join(format!("fixtures/{name}.ron")), b"()").unwrap();
        }
        let suite = Suite::open(folder.path()).unwrap();
        (folder, suite)
    }

    #[track_caller]
    fn check(suite: &Suite, filters: &[&str], expected: Result<&[&str], &str>) {
        let filters: Vec<_> = filters.iter().map(|&filter| filter.to_owned()).collect();
        let selection = suite.select(&filters).unwrap();
        match (select(suite, &selection), expected) {
            (Ok(found), Ok(expected)) => assert_eq!(found.fixtures, expected),
            (Err(why), Err(expected)) => {
                assert!(why.to_string().contains(expected), "{why}");
            }
            (found, expected) => panic!("expected {expected:?}, found {found:?}"),
        }
    }

    #[test]
    fn what_failed_is_what_was_last_seen_to_fail() {
        let (_folder, suite) = suite();
        check(&suite, &[], Err("run `cargo xtask check` once"));
        let failing = |name| outcome(name, Verdict::Differs);
        keep(&suite, &[failing("a"), failing("b"), outcome("c", Verdict::Match)], true).unwrap();
        check(&suite, &[], Ok(&["a", "b"]));
        check(&suite, &["b", "c"], Ok(&["b"]));
        check(&suite, &["c"], Err("none of the 2 that failed in the last check is selected"));

        // A part says nothing of the others.
        keep(&suite, &[outcome("a", Verdict::Match), failing("c")], false).unwrap();
        check(&suite, &[], Ok(&["b", "c"]));
        keep(&suite, &[failing("c")], true).unwrap();
        check(&suite, &[], Ok(&["c"]));

        store::remove(&suite.fixture_path("c")).unwrap();
        check(&suite, &[], Err("is in the suite any more"));
        keep(&suite, &[outcome("a", Verdict::Match)], true).unwrap();
        check(&suite, &[], Err("no fixture failed in the last check"));
    }

    #[test]
    fn a_damaged_or_later_document_is_none() {
        let (_folder, suite) = suite();
        for text in ["", "[]", r#"{"schema":2,"failed":["a"]}"#, r#"{"schema":1}"#] {
            store::write(&path(&suite).unwrap(), text.as_bytes()).unwrap();
            check(&suite, &[], Err("found none in target/goldray-cache/failed.json"));
        }
        keep(&suite, &[outcome("a", Verdict::Differs)], false).unwrap();
        check(&suite, &[], Ok(&["a"]));
    }
}
