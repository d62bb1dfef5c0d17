//! Lint: fixtures that match today, and would match where they should not.
//!
//! To add a rule: write its file, add its line to [`RULES`].

mod discriminability;
mod idle_part;
mod loose_limit;
mod part;
mod text;
mod visible_defect;

use std::collections::BTreeMap;

use rayon::prelude::*;
use scene::Step;

use crate::calibrate::Ways;
use crate::called::command;
use crate::case::Case;
use crate::judge::{Found, judge};
use crate::sensitivity::Visible;
use crate::suite::Suite;
use crate::verdict::Verdict;

pub use part::{Part, parts, without};
pub use text::{finding_line, findings_json, rule_lines};

/// What is asked of every fixture.
#[derive(Clone, Copy)]
pub struct Rule {
    /// Its name in reports.
    pub name: &'static str,
    /// What must hold.
    pub asks: &'static str,
    /// Where it does not, in one fixture.
    find: fn(&Case, &Around<'_>) -> Vec<Finding>,
}

/// Every rule, in the order of a report.
pub const RULES: &[Rule] =
    &[visible_defect::RULE, discriminability::RULE, idle_part::RULE, loose_limit::RULE];

/// The rule of a fixture that no other rule can be asked of.
const MATCHES: &str = "matches";

/// A fixture that does not keep a rule.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Finding {
    /// The fixture's name.
    pub fixture: String,
    /// The rule's name.
    pub rule: &'static str,
    /// The line of the fixture that it is about, from 1.
    pub line: usize,
    /// What was expected and what was found, in one sentence.
    pub message: String,
    /// What to do.
    pub help: String,
}

/// What a rule may know besides the fixture.
struct Around<'a> {
    suite: &'a Suite,
    /// All fixtures of the suite that have a golden, by name, asked for or not.
    all: BTreeMap<&'a str, &'a Case>,
    /// Those that are asked about.
    asked: &'a [String],
    visible: &'a Visible,
    ways: &'a Ways,
}

/// What every rule finds in these fixtures, by fixture and then by line;
/// `on_each` hears of each as it is done, from any thread.
///
/// # Errors
/// Folders that cannot be read, as text for people. A fixture that is not as it
/// should be is a finding.
pub fn lint(
    suite: &Suite,
    names: &[String],
    visible: &Visible,
    on_each: &(dyn Fn(&str) + Sync),
) -> Result<Vec<Finding>, String> {
    let everything = suite.select(&[]).map_err(|error| error.to_string())?.fixtures;
    let opened: Vec<(&String, Result<Case, String>)> =
        everything.par_iter().map(|name| (name, Case::open(suite, name))).collect();
    let (mut all, mut unread) = (BTreeMap::new(), BTreeMap::new());
    for (name, case) in &opened {
        match case {
            Ok(case) => _ = all.insert(name.as_str(), case),
            Err(why) => _ = unread.insert(name.as_str(), why),
        }
    }
    let ways = Ways::new(1)?;
    let around = Around { suite, all, asked: names, visible, ways: &ways };
    let of_one = |name: &String| {
        let found = match around.all.get(name.as_str()) {
            Some(case) => of_case(case, &around),
            None => vec![does_not_match(name, unread.get(name.as_str()).map_or("", |why| why))],
        };
        on_each(name);
        found
    };
    Ok(names.par_iter().map(of_one).collect::<Vec<_>>().concat())
}

fn of_case(case: &Case, around: &Around<'_>) -> Vec<Finding> {
    let verdict = case.fixture.render().map(|picture| {
        // Relations, which take several pictures, are `check`'s.
        judge(&case.fixture, &picture, &Found::Golden(case.golden.clone())).verdict
    });
    match verdict {
        Ok(Verdict::Match) => {}
        Ok(verdict) => return vec![does_not_match(&case.name, &verdict.words())],
        Err(why) => return vec![does_not_match(&case.name, &why)],
    }
    let mut found: Vec<_> = RULES.iter().flat_map(|rule| (rule.find)(case, around)).collect();
    // Stable: of one line in the order of the rules.
    found.sort_by_key(|finding| finding.line);
    found
}

fn does_not_match(name: &str, why: &str) -> Finding {
    let why = why.trim_end();
    let label = Suite::fixture_label(name);
    let why = why.strip_prefix(&format!("{label}: ")).unwrap_or(why);
    Finding {
        fixture: name.to_owned(),
        rule: MATCHES,
        line: 1,
        message: format!(
            "expected a fixture that matches its golden, found one that does not: {why}"
        ),
        help: format!("run `{} check` first", command()),
    }
}

/// A finding about what is at a path of the fixture's text.
fn finding(
    case: &Case,
    rule: &Rule,
    path: &[Step],
    message: String,
    help: impl Into<String>,
) -> Finding {
    Finding {
        fixture: case.name.clone(),
        rule: rule.name,
        line: case.line_of(path),
        message,
        help: help.into(),
    }
}

/// The path of a fixture's limits.
fn limits_path() -> [Step; 2] {
    ["check".into(), "limits".into()]
}

#[cfg(test)]
mod tests;
