//! `propose_again`: a plan held against what there is today.

use std::fmt;

use super::{Action, Plan, PlanError, Proposal, Proposals, Step, propose};
use crate::hash::content_hash;
use crate::run::read_golden;
use crate::store;
use crate::suite::{Selection, Suite};
use crate::verdict::Verdict;

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
    check_names(plan, suite)?;
    let (proposals, moved) = propose_steps(suite, &plan.goldens, on_done);
    if moved.is_empty() { Ok(proposals) } else { Err(PlanError::Moved(moved)) }
}

/// What steps of a plan come to by today's fixtures and goldens, and whatever is
/// not as they say.
pub(crate) fn propose_steps(
    suite: &Suite,
    steps: &[Step],
    on_done: &(dyn Fn(&str) + Sync),
) -> (Proposals, Vec<Moved>) {
    let mut selection = Selection { fixtures: Vec::new(), orphans: Vec::new() };
    for Step { name, action, .. } in steps {
        let names = match action {
            Action::Add | Action::Replace => &mut selection.fixtures,
            Action::Prune => &mut selection.orphans,
        };
        names.push(name.clone());
    }
    let proposals = propose(suite, &selection, true, on_done);
    let moved = steps
        .iter()
        .flat_map(|step| match proposals.get(&step.name) {
            Some(proposal) => moved_since(suite, step, proposal),
            None => Vec::new(),
        })
        .collect();
    (proposals, moved)
}

/// Refuses names that are not of this suite.
fn check_names(plan: &Plan, suite: &Suite) -> Result<(), PlanError> {
    let all = suite.select(&[])?;
    // Both are sorted.
    let is_known =
        |name| [&all.fixtures, &all.orphans].iter().any(|a| a.binary_search(name).is_ok());
    match plan.goldens.iter().find(|step| !is_known(&step.name)) {
        None => Ok(()),
        Some(Step { name, .. }) => Err(PlanError::NotOne(format!(
            "\"{name}\" is no fixture and no golden of this suite: make a plan anew"
        ))),
    }
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
    let golden = match today {
        Proposal::Change(change) => change.step.before.clone(),
        _ => read_golden(&suite.golden_path(&step.name)).ok().flatten().map(content_hash),
    };
    facts.push(("the golden's file", hash(&step.before), hash(&golden)));
    if step.action == Action::Prune && store::is_file(&suite.fixture_path(&step.name)) {
        facts.push(("its fixture", "none".to_owned(), Suite::fixture_label(&step.name)));
    }
    let moved = facts.into_iter().filter(|(_, expected, found)| expected != found);
    moved
        .map(|(what, expected, found)| Moved { name: step.name.clone(), what, expected, found })
        .collect()
}
