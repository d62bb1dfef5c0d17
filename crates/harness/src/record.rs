//! `Record`: the matches of earlier checks, each by the content that it
//! followed from.
//!
//! A match is recorded as hashes of every file that was read for it: the
//! fixture (its `check` and so its limits included), the files that the scene
//! names, and the golden. The whole record holds for one program and one
//! suite's folder only. It is a convenience: one that is damaged, of another
//! program or another folder is taken for an empty one.

use std::collections::BTreeMap;
use std::path::PathBuf;

use scene::{Assets, MAX_SCENE_BYTES};
use serde::{Deserialize, Serialize};

use crate::fixture::Sources;
use crate::hash::content_hash;
use crate::run::read_golden;
use crate::store::{self, FolderAssets, StoreError};
use crate::suite::Suite;
use crate::verdict::{Outcome, Verdict};

/// The largest record that is read, in bytes: far above 10,000 fixtures.
const MAX_RECORD_BYTES: u64 = 1 << 26;

/// The matches of earlier checks.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Record {
    /// The version of this document.
    schema: u32,
    /// Hash of the program that rendered.
    program: String,
    /// The suite's folder.
    root: PathBuf,
    /// By the fixture's name.
    pub(crate) matches: BTreeMap<String, Inputs>,
}

/// Hashes of the files that a verdict followed from.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Inputs {
    /// What was rendered.
    pub(crate) sources: Sources,
    /// What it was compared with.
    pub(crate) golden: String,
}

impl Record {
    /// The version that is written, and the only one that is read.
    const SCHEMA: u32 = 1;

    /// The suite's record for the program that runs.
    ///
    /// # Errors
    /// A program that cannot be read.
    pub(crate) fn read(suite: &Suite) -> Result<Self, StoreError> {
        let empty = Self {
            schema: Self::SCHEMA,
            program: store::program_hash()?,
            root: store::real_path(suite.root())?,
            matches: BTreeMap::new(),
        };
        Ok(empty.stored(suite).unwrap_or(empty))
    }

    /// Where the suite's record is.
    ///
    /// # Errors
    /// Its folder is a link.
    fn path(suite: &Suite) -> Result<PathBuf, StoreError> {
        let path = suite.record_path();
        path.parent().map_or(Ok(()), store::check_no_link)?;
        Ok(path)
    }

    /// What is stored by this program for this folder.
    fn stored(&self, suite: &Suite) -> Option<Self> {
        let path = Self::path(suite).ok()?;
        let bytes = store::read(&path, MAX_RECORD_BYTES).ok().flatten()?;
        let stored: Self = serde_json::from_slice(&bytes).ok()?;
        let is_ours = (stored.schema, &stored.program, &stored.root)
            == (self.schema, &self.program, &self.root);
        is_ours.then_some(stored)
    }

    /// Stores which fixtures were a match with what, and which were none
    /// (`None`). Others keep what is stored of them by then: what another check
    /// has thrown away stays away.
    ///
    /// # Errors
    /// A record that cannot be written.
    pub(crate) fn store(
        mut self,
        suite: &Suite,
        rendered: BTreeMap<String, Option<Inputs>>,
    ) -> Result<(), StoreError> {
        let stored = self.stored(suite).map(|stored| stored.matches);
        self.matches = stored.clone().unwrap_or_default();
        for (name, inputs) in rendered {
            match inputs {
                Some(inputs) => _ = self.matches.insert(name, inputs),
                None => _ = self.matches.remove(&name),
            }
        }
        if stored.as_ref() == Some(&self.matches) {
            return Ok(());
        }
        let path = Self::path(suite)?;
        let failed =
            |error: serde_json::Error| StoreError { path: path.clone(), what: error.to_string() };
        store::write(&path, &serde_json::to_vec_pretty(&self).map_err(failed)?)
    }

    /// Forgets the matches of those that are none.
    ///
    /// # Errors
    /// A record that cannot be read or written.
    pub(crate) fn forget(suite: &Suite, outcomes: &[Outcome]) -> Result<(), StoreError> {
        let is_other = |outcome: &&Outcome| outcome.verdict != Verdict::Match;
        let others = outcomes.iter().filter(is_other).map(|outcome| (outcome.name.clone(), None));
        let others: BTreeMap<_, _> = others.collect();
        if others.is_empty() || !store::is_file(&suite.record_path()) {
            return Ok(());
        }
        Self::read(suite)?.store(suite, others)
    }

    /// Throws the stored record away.
    ///
    /// # Errors
    /// A record that cannot be removed.
    pub(crate) fn remove(suite: &Suite) -> Result<(), StoreError> {
        let path = Self::path(suite)?;
        if store::is_file(&path) { store::remove(&path) } else { Ok(()) }
    }

    /// Whether this fixture was a match, and every file that this followed
    /// from still has the same content.
    pub(crate) fn holds(&self, suite: &Suite, name: &str) -> bool {
        let Some(Inputs { sources, golden }) = self.matches.get(name) else { return false };
        let path = suite.fixture_path(name);
        let assets = FolderAssets::beside(&path);
        let has = |bytes: Option<Vec<u8>>, hash: &String| {
            bytes.is_some_and(|bytes| content_hash(bytes) == *hash)
        };
        has(store::read(&path, MAX_SCENE_BYTES as u64).ok().flatten(), &sources.fixture)
            && has(read_golden(&suite.golden_path(name)).ok().flatten(), golden)
            && sources.assets.iter().all(|(name, hash)| has(assets.read(name).ok(), hash))
    }
}
