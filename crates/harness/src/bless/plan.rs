//! `Plan`: what was proposed, as a JSON file that people review before it is
//! applied; `docs/schemas/plan.schema.json` is its schema.

use std::collections::BTreeSet;

use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};

use super::{Moved, Proposal, Proposals};
use crate::called::command;
use crate::suite::SuiteError;

/// What was proposed.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Plan {
    /// The version of this document.
    pub schema: u32,
    /// The goldens that change, in the order of names.
    pub goldens: Vec<Step>,
    /// What is not accepted, in the order of names.
    pub refused: Vec<Refusal>,
}

/// A golden that changes. Hashes are the first 128 bits of BLAKE3.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Step {
    /// The name of the fixture, or of the golden without one.
    pub name: String,
    /// What happens to the golden.
    pub action: Action,
    /// What is said of the golden that there is.
    pub verdict: String,
    /// Hash of the golden's file before; null where there is none.
    pub before: Option<String>,
    /// Hash of the golden's file after; null where it is removed.
    pub after: Option<String>,
    /// Hash of the scene, as in the golden's note.
    pub scene: Option<String>,
    /// Hash of the files that the scene names, as in the golden's note.
    pub assets: Option<String>,
    /// Every metric from the golden before to the one after; null where they
    /// cannot be compared.
    pub distances: Option<Map<String, Value>>,
    /// The objects that the difference is blamed on, for the reviewer.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub blamed: Option<Value>,
}

/// What happens to a golden.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Action {
    /// There is none, and it is written.
    Add,
    /// It is written over.
    Replace,
    /// It has no fixture, and is removed.
    Prune,
}

/// A picture that is not accepted.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Refusal {
    /// The fixture's name.
    pub name: String,
    /// Why.
    pub reasons: Vec<String>,
}

/// Why a plan cannot be applied.
#[derive(Debug, thiserror::Error)]
pub enum PlanError {
    /// It is none, or not of this suite.
    #[error("{0}")]
    NotOne(String),
    /// The suite cannot be listed.
    #[error(transparent)]
    Suite(#[from] SuiteError),
    /// Something moved since.
    #[error("{} moved since the plan was made", .0.len())]
    Moved(Vec<Moved>),
}

impl Plan {
    /// The version that is written, and the only one that is read.
    pub const SCHEMA: u32 = 1;

    /// The largest file that is read as a plan, in bytes: far above 10,000
    /// fixtures.
    pub const MAX_BYTES: u64 = 1 << 26;

    /// What is proposed, without the pictures.
    pub fn of(proposals: &Proposals) -> Self {
        let mut plan = Self { schema: Self::SCHEMA, goldens: Vec::new(), refused: Vec::new() };
        for (name, proposal) in proposals {
            match proposal {
                Proposal::Change(change) => plan.goldens.push(change.step.clone()),
                Proposal::Refused(reasons) => {
                    plan.refused.push(Refusal { name: name.clone(), reasons: reasons.clone() });
                }
                Proposal::Untouched | Proposal::LeftOrphan => {}
            }
        }
        plan
    }

    /// The plan in a file.
    ///
    /// # Errors
    /// Text that is none, a plan of another version, one that names a golden
    /// twice, and hashes that do not go with their action.
    pub fn parse(bytes: &[u8]) -> Result<Self, PlanError> {
        #[derive(Deserialize)]
        struct Version {
            schema: u32,
        }
        let not_one = |error: serde_json::Error| {
            let made = format!("as `{} bless --plan` writes it", command());
            let what = format!("expected a plan {made}: {error}");
            PlanError::NotOne(what)
        };
        let Version { schema } = serde_json::from_slice(bytes).map_err(not_one)?;
        if schema != Self::SCHEMA {
            let what = format!("expected a plan with \"schema\": {}, found {schema}", Self::SCHEMA);
            return Err(PlanError::NotOne(what));
        }
        let plan: Self = serde_json::from_slice(bytes).map_err(not_one)?;
        let mut names = BTreeSet::new();
        for step in &plan.goldens {
            if !names.insert(&step.name) {
                let what = format!("expected each golden once, found \"{}\" again", step.name);
                return Err(PlanError::NotOne(what));
            }
            let Step { before, after, scene, assets, .. } = step;
            let is_written = [after, scene, assets].map(Option::is_some);
            let expected = match step.action {
                Action::Add => (false, [true; 3]),
                Action::Replace => (true, [true; 3]),
                Action::Prune => (true, [false; 3]),
            };
            if (before.is_some(), is_written) != expected {
                let what = format!(
                    "\"{}\": expected the hashes that go with its action: `before` unless it is \
                     added, `after`, `scene` and `assets` unless it is pruned",
                    step.name
                );
                return Err(PlanError::NotOne(what));
            }
        }
        Ok(plan)
    }
}
