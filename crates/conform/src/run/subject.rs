//! `Subject`: a fixture that others may be judged by, as goldray is right about it.

use std::collections::BTreeSet;
use std::time::Duration;

use harness::expectation::Rendered;
use harness::fixture::Fixture;
use harness::judge::judge;
use harness::run::{find_golden, render_fixture};
use harness::suite::Suite;
use harness::verdict::Verdict;
use interchange::Feature;
use rayon::prelude::*;

use crate::asks;
use crate::process::Stop;

/// A fixture with goldray's picture of it, which is its golden.
#[derive(Debug)]
pub struct Subject {
    /// Its name.
    pub name: String,
    /// What the picture is held to.
    pub fixture: Fixture,
    /// goldray's picture.
    pub rendered: Rendered,
    /// What its scene asks for.
    pub features: BTreeSet<Feature>,
}

/// A fixture that goldray itself does not match, so that nobody is judged by it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct NotItself {
    /// Its name.
    pub name: String,
    /// What is said of goldray's own picture, and why.
    pub why: String,
    /// Whether accepting goldray's picture would settle it.
    pub can_be_blessed: bool,
}

/// Renders fixtures by goldray, and holds its pictures against their goldens and
/// what they expect; `on_subject` hears of each, from any thread. `None` where it was
/// time to end before all were rendered: it is asked before each.
///
/// # Errors
/// Those that are no match.
pub fn subjects(
    suite: &Suite,
    names: &[String],
    on_subject: &(dyn Fn(&str) + Sync),
    stop: Stop<'_>,
) -> Result<Option<Vec<Subject>>, Vec<NotItself>> {
    let all: Option<Vec<_>> = names
        .par_iter()
        .map(|name| {
            if stop(Duration::ZERO) {
                return None;
            }
            let made = subject(suite, name);
            on_subject(name);
            Some(made)
        })
        .collect();
    let Some(all) = all else { return Ok(None) };
    let mut good = Vec::new();
    let mut bad = Vec::new();
    for made in all {
        match made {
            Ok(subject) => good.push(subject),
            Err(why) => bad.push(why),
        }
    }
    if bad.is_empty() { Ok(Some(good)) } else { Err(bad) }
}

fn subject(suite: &Suite, name: &str) -> Result<Subject, NotItself> {
    let refused = |why, can_be_blessed| NotItself { name: name.to_owned(), why, can_be_blessed };
    let (fixture, rendered) = render_fixture(suite, name).map_err(|why| refused(why, false))?;
    let judgment = judge(&fixture, &rendered, &find_golden(&suite.golden_path(name)));
    // How large a golden's file is says nothing of its picture.
    if !matches!(judgment.verdict, Verdict::Match | Verdict::GoldenFileSize) {
        let why = format!("{}: {}", judgment.verdict.words(), judgment.findings.join("; "));
        let is_settled = judgment.verdict.can_be_blessed() && !judgment.breaks_expectations;
        return Err(refused(why, is_settled));
    }
    let features = asks(&fixture, &rendered.linear);
    Ok(Subject { name: name.to_owned(), fixture, rendered, features })
}
