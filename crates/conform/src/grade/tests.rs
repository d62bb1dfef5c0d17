//! What points are given for, and what is said of them.

use super::*;
use crate::card::tests::{fixtures, four};

/// The grade of the run of the third of [`four`], that paints boxes wrong: `ball` and
/// `outline` pass, `block` fails.
fn grade(parts: &str, penalties: &str) -> (Grade, Conformed) {
    let conformed = four().swap_remove(2);
    (Grade::of(&plan(parts, penalties), &conformed), conformed)
}

fn plan(parts: &str, penalties: &str) -> Plan {
    let text =
        format!("(version: 1, title: \"One & <two>\", parts: [{parts}], penalties: [{penalties}])");
    let suite = fixtures()
        .iter()
        .map(|(name, fixture)| {
            let file = scene::parse::<harness::check::Check>(&fixture.text).unwrap();
            (name.clone(), interchange::feature::features(&file))
        })
        .collect();
    Plan::read(&text, &suite).unwrap()
}

#[track_caller]
fn check(parts: &str, penalties: &str, expected: &str) {
    let (grade, _) = grade(parts, penalties);
    assert_eq!(format!("{} of {}", grade.points, grade.of), expected, "{parts} {penalties}");
}

const ALL: &str = "(name: \"all\", points: 10, fixtures: [\"*\"])";

#[test]
fn points_are_given_for_what_passes() {
    check(ALL, "", "6.67 of 10");
    check("(name: \"a\", points: 10, fixtures: [\"*\"], per: All)", "", "0 of 10");
    check("(name: \"a\", points: 10, fixtures: [\"ball\"], per: All)", "", "10 of 10");
    check("(name: \"a\", points: 3, features: [Sphere])", "", "3 of 3");
    check("(name: \"a\", points: 3, features: [Box])", "", "0 of 3");
    check(&format!("{ALL}, (name: \"b\", points: 0.5, fixtures: [\"ball\"])"), "", "7.17 of 10.5");
}

#[test]
fn points_are_taken_for_how_it_ends() {
    let penalty = |rest: &str| format!("(name: \"p\", points: 2, {rest})");
    check(ALL, &penalty("outcomes: [Fail]"), "4.67 of 10");
    check(ALL, &penalty("outcomes: [Crashed]"), "6.67 of 10");
    check(ALL, &penalty("outcomes: [Crashed, Fail], at_most: 0.5"), "6.17 of 10");
    check(ALL, &penalty("outcomes: [Fail], fixtures: [\"ball\"]"), "6.67 of 10");
    let (_, mut conformed) = grade(ALL, "");
    for result in conformed.run.fixtures.values_mut() {
        result.outcome = Outcome::TimedOut;
    }
    let of = |rest: &str| {
        let penalty = penalty(&format!("outcomes: [TimedOut], {rest}"));
        Grade::of(&plan(ALL, &penalty), &conformed)
    };
    assert_eq!(of("per: Each").deductions[0].points.value(), 6.0);
    assert_eq!(of("per: Once").deductions[0].points.value(), 2.0);
    assert_eq!(of("").points.value(), 0.0, "not less than nothing");
}

#[test]
fn what_was_not_run_or_is_unsupported_has_not_passed() {
    let (_, mut conformed) = grade(ALL, "");
    conformed.run.fixtures.remove("ball");
    let grade = Grade::of(&plan(ALL, ""), &conformed);
    assert_eq!((grade.points.value(), grade.is_full()), (3.33, false));
    assert!(grade.marks[0].fixtures.contains(&("ball".to_owned(), None)));
    assert!(markdown(&grade, &conformed).contains("- <code>ball</code>: was not run\n"));
    let few = four().swap_remove(3);
    assert_eq!(Grade::of(&plan(ALL, ""), &few).points.value(), 3.33);
}

#[test]
fn a_grade_is_told_in_three_ways() {
    let penalty = "(name: \"wrong\", points: 1, outcomes: [Fail])";
    let (graded, conformed) = grade("(name: \"boxes|\", points: 5, features: [Box])", penalty);
    let page = markdown(&graded, &conformed);
    for line in [
        "# One &#38; &#60;two&#62;: 0 of 5 points\n",
        "| boxes&#124; | 0 | 5 | 0 of 1 | as many as pass |\n",
        "| wrong | −1 |",
        "\n## boxes&#124;: 0 of 5 points\n\n- <code>block</code>: fail\n  - expected interior pixels within 1e-5, \
         found 100 beyond it\n  - reference, difference and picture: <code>wrong/block.png</code>\n",
        "\n## wrong: −1 points\n\n- <code>block</code>: fail\n  - expected interior",
        "No part asks for: <code>ball</code>, <code>outline</code>.\n",
    ] {
        assert!(page.contains(line), "{line}\n{page}");
    }
    let html = html(&graded, &conformed, &|_| None).unwrap();
    assert!(html.contains("<title>One &amp; &lt;two&gt;: &lt;wrong&gt;: 0 of 5 points</title>"));
    assert!(html.contains("id=\"grade\"") && html.contains("id=\"card\""));
    let folder = tempfile::tempdir().unwrap();
    let files = write(folder.path(), &graded, &conformed, &|_| None).unwrap();
    let read = harness::store::read(&files[0], 1 << 20).unwrap().unwrap();
    let document: serde_json::Value = serde_json::from_slice(&read).unwrap();
    assert_eq!((&document["points"], &document["of"]), (&0.0.into(), &5.0.into()));
    assert_eq!(document["parts"][0]["fixtures"][0]["outcome"], "fail");
    assert_eq!(document["penalties"][0]["fixtures"][0]["name"], "block");
    assert_eq!(files.len(), 3);
}

#[test]
fn full_points_are_full() {
    let (grade, _) = grade("(name: \"a\", points: 3, fixtures: [\"ball\", \"outline\"])", "");
    assert!(grade.is_full());
    assert_eq!(grade.unasked, ["block"]);
}
