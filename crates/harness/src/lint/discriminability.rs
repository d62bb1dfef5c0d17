//! `discriminability`: no other fixture's golden passes in the place of a
//! fixture's own, but where the fixture says that both show the same.

use std::collections::BTreeSet;

use super::{Around, Finding, Rule, finding, limits_path};
use crate::called::command;
use crate::case::Case;
use crate::judge::is_caught;

pub(super) const RULE: Rule = Rule {
    name: "discriminability",
    asks: "no other fixture's golden would pass, but that of one named in `same_as`",
    find,
};

fn find(case: &Case, around: &Around<'_>) -> Vec<Finding> {
    let same = same_as(case, around);
    let passing = around.all.values().filter(|other| {
        other.name != case.name && !same.contains(other.name.as_str()) && passes(case, other)
    });
    let mut found: Vec<_> = passing
        .filter(|other| !is_said_there(case, other, around))
        .map(|other| passing_finding(case, other))
        .collect();
    found.extend(case.fixture.check.same_as.keys().filter_map(|name| wrong(case, name, around)));
    found
}

/// Whether the other's golden would pass in the place of this one's.
fn passes(case: &Case, other: &Case) -> bool {
    let limits = case.fixture.check.limits.as_ref();
    // In its own size, whatever the limits.
    case.golden.picture.size() == other.golden.picture.size()
        && !is_caught(limits, &case.golden.picture, &other.golden.picture)
}

/// Whether two identical goldens are a finding of the other fixture, so that
/// they are told once.
fn is_said_there(case: &Case, other: &Case, around: &Around<'_>) -> bool {
    case.golden.picture == other.golden.picture
        && other.name < case.name
        && around.asked.contains(&other.name)
}

fn passing_finding(case: &Case, other: &Case) -> Finding {
    let name = &other.name;
    let help = format!(
        "change one of the scenes so that they differ, or say why not: check: (same_as: \
         {{\"{name}\": \"...\"}})"
    );
    if case.golden.picture == other.golden.picture {
        let message = format!("expected a picture of its own, found that of {name}");
        return finding(case, &RULE, &[], message, help);
    }
    let message = format!("expected limits that tell it from all others, found that {name} passes");
    finding(case, &RULE, &limits_path(), message, help)
}

/// What is wrong with a name in `same_as`.
fn wrong(case: &Case, name: &str, around: &Around<'_>) -> Option<Finding> {
    let path = ["check".into(), "same_as".into(), scene::Step::key(name)];
    let (message, help) = match around.all.get(name) {
        Some(other) if name == case.name => {
            (format!("expected another fixture, found {} itself", other.name), "take it out".into())
        }
        Some(other) if passes(case, other) => return None,
        Some(_) => (
            format!("expected the same picture as {name}, found another"),
            "one of the two is wrong, or it is no longer meant: then take it out".to_owned(),
        ),
        None => {
            let nearest = scene::nearest(name, around.all.keys().copied());
            let hint = nearest.map_or(String::new(), |name| format!("; did you mean {name}?"));
            let help = format!("`{} list` shows all names{hint}", command());
            (format!("expected a fixture with a golden, found \"{name}\""), help)
        }
    };
    Some(finding(case, &RULE, &path, message, help))
}

/// All fixtures that are said to show the same as this one, by it or by each
/// other, this one included.
fn same_as<'a>(case: &'a Case, around: &'a Around<'_>) -> BTreeSet<&'a str> {
    let mut same = BTreeSet::from([case.name.as_str()]);
    loop {
        let before = same.len();
        for (&name, other) in &around.all {
            let named = other.fixture.check.same_as.keys().map(String::as_str);
            let linked: Vec<_> = named.chain([name]).collect();
            if linked.iter().any(|name| same.contains(name)) {
                same.extend(linked);
            }
        }
        if same.len() == before {
            return same;
        }
    }
}
