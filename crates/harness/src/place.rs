//! `place`: where in its fixture's file a failure is to be looked for.

use scene::Step;

use crate::blame::Blamed;
use crate::expectation::Rendered;
use crate::fixture::Fixture;
use crate::judge::Judgment;
use crate::suite::Suite;

/// Line and column, from 1, of the first of these that there is: the object
/// that most of the difference lies on, a broken expectation, a broken
/// relation, a problem of the text.
pub(crate) fn of_failure(
    name: &str,
    rendered: &Result<(Fixture, Rendered), String>,
    judgment: &Judgment,
    blamed: &[Blamed],
) -> Option<(usize, usize)> {
    let (fixture, picture) = match rendered {
        Ok(both) => both,
        Err(why) => return in_report(why, &Suite::fixture_label(name)),
    };
    if let Some((_, place)) = blamed.iter().find_map(|blamed| blamed.object.as_ref()) {
        return Some((place.line, place.column));
    }
    let check = &fixture.check;
    let said = |i: usize, list: &'static str| {
        let path: [Step; 3] = ["check".into(), list.into(), i.into()];
        scene::line_column(&fixture.text, scene::span_of(&fixture.text, &path).start)
    };
    let broken = check.expect.iter().position(|expectation| expectation.check(picture).is_err());
    let broken = broken.map(|i| said(i, "expect"));
    broken.or_else(|| {
        let words = judgment.broken_relations.first()?;
        let is_it = |relation: &crate::relation::Relation| words.starts_with(&relation.said());
        check.relations.iter().position(is_it).map(|i| said(i, "relations"))
    })
}

/// The first place in a report of problems, as [`scene::report`] makes it.
fn in_report(report: &str, label: &str) -> Option<(usize, usize)> {
    report.lines().find_map(|line| {
        let mut numbers = line.strip_prefix(label)?.strip_prefix(':')?.splitn(3, ':');
        let mut number = || numbers.next()?.parse().ok();
        Some((number()?, number()?))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(report: &str, expected: Option<(usize, usize)>) {
        assert_eq!(in_report(report, "fixtures/a:1:2.ron"), expected, "{report}");
    }

    #[test]
    fn the_first_place_of_a_report() {
        check("", None);
        check("fixtures/a:1:2.ron: there is no such file\n", None);
        check("fixtures/other.ron:3:4: wrong\n", None);
        check("fixtures/a:1:2.ron:3:4: wrong\n  3 | x\nfixtures/a:1:2.ron:9:9: y", Some((3, 4)));
        check("fixtures/a:1:2.ron:3", None);
        check("fixtures/a:1:2.ron:3:x: y", None);
    }
}
