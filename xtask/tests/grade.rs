//! `grade` by the real binary: a rubric is judged before anybody renders.
#![allow(clippy::unwrap_used, clippy::disallowed_methods)]

mod tree;

use tree::{SQUARE, Tree};

const RUBRIC: &str = "(
    version: 1,
    title: \"One\",
    parts: [
        (name: \"Squares\", points: 10, fixtures: [\"square\"]),
        (name: \"Boxes\", points: 2.5, features: [Box], per: All),
    ],
    penalties: [(name: \"Crashes\", points: 1, outcomes: [Crashed])],
)";

fn tree(rubric: &str) -> Tree {
    let tree = Tree::new(&[("square/a", SQUARE), ("square/b", SQUARE), ("other", SQUARE)]);
    tree.write("rubric.ron", rubric.as_bytes());
    tree
}

const PLAN: [&str; 6] = ["grade", "--renderer", "none", "--rubric", "rubric.ron", "--plan"];

#[test]
fn a_plan_says_what_each_part_is_about() {
    let ran = tree(RUBRIC).run(&PLAN).expect_code(0);
    let expected = "One\n      10  Squares: square/a, square/b\n     2.5  Boxes: other, square/a, square/b\n      \
                    -1  Crashes: of 3 fixtures\nseveral parts ask for: square/a, square/b\n";
    assert_eq!(ran.stdout(), expected);
}

#[track_caller]
fn refused(old: &str, new: &str, expected: &str) {
    let ran = tree(&RUBRIC.replace(old, new)).run(&PLAN).expect_code(2);
    ran.expect(expected);
}

#[test]
fn a_wrong_rubric_is_told_by_its_place() {
    refused(
        "[\"square\"]",
        "[\"sqare/a\"]",
        "rubric.ron:5:50: the filter \"sqare/a\" selects nothing; did you mean \"square/a\"?",
    );
    refused("[Box]", "[Bax]", "rubric.ron:6:49: ");
    refused("points: 10", "pionts: 10", "did you mean `points`?");
    refused(
        "2.5",
        "2.555",
        "rubric.ron:6:33: expected points from 0 to 1000000 with two decimals at most",
    );
    refused(RUBRIC, "", "rubric.ron:1:1: ");
    refused(RUBRIC, "(", "rubric.ron:1:");
}

#[test]
fn what_cannot_be_asked_is_said() {
    let tree = tree(RUBRIC);
    let ran = tree.run(&["grade", "--renderer", "none", "--rubric", "no.ron", "--plan"]);
    ran.expect_code(2).expect("no.ron: expected a rubric, found no such file");
    tree.run(&["grade", "--rubric", "rubric.ron"]).expect_code(2).expect("--renderer");
    let inside = ["grade", "--renderer", "none", "--rubric", "rubric.ron", "--out", "golden"];
    tree.run(&inside).expect_code(2).expect("expected a place outside of the suite's golden/");
    tree.run(&PLAN[..5]).expect_code(2).expect("none");
}
