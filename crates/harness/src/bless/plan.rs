//! `Plan`: what was proposed, as a JSON file that people review before it is
//! applied.

use std::collections::BTreeSet;
use std::fmt;

use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};

use super::{Proposal, Proposals, propose};
use crate::hash::content_hash;
use crate::run::read_golden;
use crate::store;
use crate::suite::{Selection, Suite, SuiteError};
use crate::verdict::Verdict;

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

/// What is not as it was when the plan was made.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Moved {
    /// Whose it is.
    pub name: String,
    /// What moved.
    pub what: &'static str,
    /// What the plan says.
    pub expected: String,
    /// What there is.
    pub found: String,
}

impl fmt::Display for Moved {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { name, what, expected, found } = self;
        write!(f, "{name}: {what}: expected {expected}, found {found}")
    }
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
            let what = format!("expected a plan as `cargo xtask bless --plan` writes it: {error}");
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

    /// What is to be rendered, and removed.
    fn selection(&self, suite: &Suite) -> Result<Selection, PlanError> {
        let all = suite.select(&[])?;
        let is_known = |name: &String| all.fixtures.contains(name) || all.orphans.contains(name);
        let mut selection = Selection { fixtures: Vec::new(), orphans: Vec::new() };
        for Step { name, action, .. } in &self.goldens {
            if !is_known(name) {
                let what = format!(
                    "\"{name}\" is no fixture and no golden of this suite: make a plan anew"
                );
                return Err(PlanError::NotOne(what));
            }
            let names = match action {
                Action::Add | Action::Replace => &mut selection.fixtures,
                Action::Prune => &mut selection.orphans,
            };
            names.push(name.clone());
        }
        Ok(selection)
    }
}

/// Proposes what a plan lists, by today's fixtures and goldens.
///
/// # Errors
/// Names that are not of this suite; and whatever is not as the plan says, be
/// it a golden, a fixture, a file that it names or the picture: all of it.
pub fn propose_again(
    suite: &Suite,
    plan: &Plan,
    on_done: &(dyn Fn(&str) + Sync),
) -> Result<Proposals, PlanError> {
    let proposals = propose(suite, &plan.selection(suite)?, true, on_done);
    let moved: Vec<_> = plan
        .goldens
        .iter()
        .flat_map(|step| match proposals.get(&step.name) {
            Some(proposal) => moved_since(suite, step, proposal),
            None => Vec::new(),
        })
        .collect();
    if moved.is_empty() { Ok(proposals) } else { Err(PlanError::Moved(moved)) }
}

/// What differs between a step of a plan and what is proposed today.
fn moved_since(suite: &Suite, step: &Step, today: &Proposal) -> Vec<Moved> {
    let hash = |hash: &Option<String>| hash.clone().unwrap_or_else(|| "none".to_owned());
    let mut facts = Vec::new();
    let now = match today {
        Proposal::Change(change) => {
            let now = &change.step;
            facts.push(("the scene", hash(&step.scene), hash(&now.scene)));
            facts.push(("the files it names", hash(&step.assets), hash(&now.assets)));
            facts.push(("the picture's file", hash(&step.after), hash(&now.after)));
            now.verdict.clone()
        }
        Proposal::Refused(why) => format!("refused: {}", why.join("; ").trim_end()),
        Proposal::Untouched | Proposal::LeftOrphan => Verdict::Match.id().to_owned(),
    };
    facts.push(("the verdict", step.verdict.clone(), now));
    let golden = read_golden(&suite.golden_path(&step.name)).ok().flatten().map(content_hash);
    facts.push(("the golden's file", hash(&step.before), hash(&golden)));
    if step.action == Action::Prune && store::is_file(&suite.fixture_path(&step.name)) {
        facts.push(("its fixture", "none".to_owned(), Suite::fixture_label(&step.name)));
    }
    let moved = facts.into_iter().filter(|(_, expected, found)| expected != found);
    moved
        .map(|(what, expected, found)| Moved { name: step.name.clone(), what, expected, found })
        .collect()
}
