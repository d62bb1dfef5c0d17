//! A grade: points for what a renderer gets right, by a rubric, with the pictures that
//! it gets wrong as evidence.
//!
//! ```text
//! rubric.ron -> Plan -> (its fixtures are rendered) -> Conformed -> Grade -> grade.html, .md, .json
//! ```
//!
//! Only a pass counts. What the adapter does not support is not wrong, but gives no
//! points either.

#[cfg(test)]
mod document;
mod json;
mod markdown;
mod open;
mod page;
mod plan;
mod points;
mod rubric;
#[cfg(test)]
mod tests;
mod text;
mod write;

pub use json::json;
pub use markdown::markdown;
pub use page::html;
pub use plan::{Asked, MAX_BYTES, Plan};
pub use points::Points;
pub use rubric::{Ending, Often, Part, Penalty, Per, Rubric, VERSION};
pub use text::{grade_lines, plan_lines};
pub use write::{FILES, write};

use crate::result::held_to;
use crate::{Conformed, FixtureResult, Outcome, RendererInfo};

/// Points for what a renderer gets right.
#[derive(Debug, Clone, PartialEq)]
pub struct Grade {
    /// What is graded.
    pub title: String,
    /// Who rendered.
    pub renderer: RendererInfo,
    /// How far its pictures may be off; see [`held_to`].
    pub held_to: String,
    /// One for each part of the rubric.
    pub marks: Vec<Mark>,
    /// One for each penalty of the rubric.
    pub deductions: Vec<Deduction>,
    /// Points of all parts without what is taken; not less than nothing.
    pub points: Points,
    /// What all parts are worth.
    pub of: Points,
    /// Fixtures of the suite that no part asks for.
    pub unasked: Vec<String>,
    /// Fixtures that several parts ask for.
    pub shared: Vec<String>,
}

/// Points for a part.
#[derive(Debug, Clone, PartialEq)]
pub struct Mark {
    /// The part's name.
    pub name: String,
    /// How points are given.
    pub per: Per,
    /// What is given.
    pub points: Points,
    /// What it is worth.
    pub of: Points,
    /// Names of its fixtures, those that pass first, each with what came of it.
    pub fixtures: Vec<(String, Option<Outcome>)>,
}

impl Mark {
    /// How many of its fixtures pass.
    pub fn passed(&self) -> u64 {
        self.fixtures.iter().filter(|(_, outcome)| *outcome == Some(Outcome::Pass)).count() as u64
    }
}

/// What is taken.
#[derive(Debug, Clone, PartialEq)]
pub struct Deduction {
    /// The penalty's name.
    pub name: String,
    /// What is taken.
    pub points: Points,
    /// For which fixtures, each with what came of it.
    pub fixtures: Vec<(String, Outcome)>,
}

impl Grade {
    /// The grade of a run by a plan. A fixture that the run is without has not passed.
    pub fn of(plan: &Plan, conformed: &Conformed) -> Self {
        let run = &conformed.run;
        let outcome =
            |name: &str| run.fixtures.get(name).map(|result: &FixtureResult| result.outcome);
        let marks: Vec<_> = plan
            .rubric
            .parts
            .iter()
            .zip(&plan.parts)
            .map(|(part, asked)| mark(part, asked, &outcome))
            .collect();
        let deductions: Vec<_> = plan
            .rubric
            .penalties
            .iter()
            .zip(&plan.penalties)
            .map(|(penalty, asked)| deduction(penalty, asked, &outcome))
            .collect();
        let taken: Points = deductions.iter().map(|one| one.points).sum();
        Self {
            title: plan.rubric.title.clone(),
            renderer: run.renderer.clone(),
            held_to: held_to(run.tolerance, run.edge_reach),
            points: marks.iter().map(|mark| mark.points).sum::<Points>().less(taken),
            of: marks.iter().map(|mark| mark.of).sum(),
            marks,
            deductions,
            unasked: plan.unasked.clone(),
            shared: plan.shared.clone(),
        }
    }

    /// Whether all points are given.
    pub fn is_full(&self) -> bool {
        self.points == self.of
    }
}

fn mark(part: &Part, asked: &Asked, outcome: &dyn Fn(&str) -> Option<Outcome>) -> Mark {
    let mut fixtures: Vec<_> =
        asked.fixtures.iter().map(|name| (name.clone(), outcome(name))).collect();
    // Stable: of each kind in the order of names.
    fixtures.sort_by_key(|(_, outcome)| *outcome != Some(Outcome::Pass));
    let mut mark = Mark {
        name: part.name.clone(),
        per: part.per,
        points: Points::default(),
        of: asked.points,
        fixtures,
    };
    let (passed, all) = (mark.passed(), mark.fixtures.len() as u64);
    mark.points = match part.per {
        Per::Share => asked.points.share(passed, all),
        Per::All => asked.points.share(u64::from(passed == all && all > 0), 1),
    };
    mark
}

fn deduction(
    penalty: &Penalty,
    asked: &Asked,
    outcome: &dyn Fn(&str) -> Option<Outcome>,
) -> Deduction {
    let is_meant =
        |outcome: &Outcome| penalty.outcomes.iter().any(|ending| ending.outcome() == *outcome);
    let ended = |name: &String| Some((name.clone(), outcome(name).filter(is_meant)?));
    let fixtures: Vec<_> = asked.fixtures.iter().filter_map(ended).collect();
    let times = match penalty.per {
        Often::Each => fixtures.len() as u64,
        Often::Once => u64::from(!fixtures.is_empty()),
    };
    let points = asked.points.times(times);
    let points = asked.at_most.map_or(points, |most| points.min(most));
    Deduction { name: penalty.name.clone(), points, fixtures }
}
