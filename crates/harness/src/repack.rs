//! `repack`: goldens written again in fewer bytes, or with a note of today's
//! version: the same picture, accepted for the same scene.

use rayon::prelude::*;

use crate::golden::{self, Golden, Provenance};
use crate::judge::{Found, judge};
use crate::run::{Judged, judge_fixture};
use crate::store;
use crate::suite::Suite;
use crate::verdict::Verdict;

/// What became of a golden.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Repacked {
    /// It was as small as it gets.
    Untouched {
        /// The size of the file, in bytes.
        bytes: usize,
    },
    /// It was written again.
    Written {
        /// The size of the file before, in bytes.
        before: usize,
        /// The size of the file after, in bytes.
        after: usize,
    },
    /// It was left as it was, and why.
    Refused(String),
}

/// Writes the goldens of these fixtures again where that makes them smaller or
/// their note is of an earlier version. A golden that is no match of its
/// fixture is refused: repacking accepts nothing. `on_done` hears of each, from
/// any thread; the answers are in the order of the names.
pub fn repack(
    suite: &Suite,
    fixtures: &[String],
    on_done: &(dyn Fn(&str) + Sync),
) -> Vec<(String, Repacked)> {
    let one = |name: &String| {
        let repacked = repack_one(suite, name).unwrap_or_else(Repacked::Refused);
        on_done(name);
        (name.clone(), repacked)
    };
    fixtures.par_iter().map(one).collect()
}

fn repack_one(suite: &Suite, name: &str) -> Result<Repacked, String> {
    let Judged { rendered, found, .. } = judge_fixture(suite, name);
    let (fixture, picture) = rendered?;
    let golden = match found {
        Found::Golden(golden) => golden,
        Found::Nothing => return Err("there is no golden".to_owned()),
        Found::Unreadable(why) => return Err(format!("the golden {why}")),
    };
    let before = golden.file_bytes;
    let repacked = repacked(&golden)?;
    let judgment = judge(&fixture, &picture, &Found::Golden(golden::from_png(&repacked)?));
    if judgment.verdict != Verdict::Match {
        let findings = judgment.findings.join("; ");
        return Err(format!("{}: {findings}", judgment.verdict.words()));
    }
    let is_old = golden.provenance.is_some_and(|note| note.schema < Provenance::SCHEMA);
    if repacked.len() >= before && !is_old {
        return Ok(Repacked::Untouched { bytes: before });
    }
    store::write(&suite.golden_path(name), &repacked).map_err(|error| error.to_string())?;
    Ok(Repacked::Written { before, after: repacked.len() })
}

/// The file of the same picture and note, in today's version.
fn repacked(golden: &Golden) -> Result<Vec<u8>, String> {
    if golden.is_tampered() {
        let what = "the golden's picture is not the one that its note was written for";
        return Err(what.to_owned());
    }
    let Some(note) = &golden.provenance else {
        return Err("the golden does not say for which scene it was accepted".to_owned());
    };
    let note = if note.schema < Provenance::SCHEMA {
        Provenance { schema: Provenance::SCHEMA, ..note.clone() }
    } else {
        note.clone()
    };
    golden::smallest_png(&golden.picture, &note)
}
