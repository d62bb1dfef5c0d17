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
    tree.write("adapters/none.ron", NONE.as_bytes());
    tree
}

/// An adapter of a program that there is not.
const NONE: &str = "(name: \"None\", command: [\"no-such-program\", \"{scene}\"], scene: Ron)";

const PLAN: [&str; 6] = ["grade", "--renderer", "none", "--rubric", "rubric.ron", "--plan"];

#[test]
fn a_plan_says_what_each_part_is_about() {
    let ran = tree(RUBRIC).run(&PLAN).expect_code(0);
    let expected = "One\n      10  Squares: square/a, square/b\n     2.5  Boxes: other, square/a, square/b\n      \
                    -1  Crashes: of 3 fixtures\nseveral parts ask for: square/a, square/b\n";
    assert_eq!(ran.stdout(), expected);
}

#[test]
fn a_plan_says_what_the_adapter_rules_out() {
    let tree = tree(RUBRIC);
    let floor = "objects: [Plane(point: (0, 0, 0), normal: (0, 0, 1)), ";
    tree.write("fixtures/square/b.ron", SQUARE.replace("objects: [", floor).as_bytes());
    let plan = |adapter: &str| {
        tree.write("adapters/none.ron", adapter.as_bytes());
        tree.run(&PLAN)
    };
    let without = NONE.replace("Ron)", "Ron, unsupported: {Plane: \"next week\"})");
    let why = "square/b (its adapter says that it has no Plane: next week)";
    plan(&without)
        .expect_code(0)
        .expect(&format!(
            "  Squares: square/a, square/b\n          1 of 2 is ruled out by the adapter: {why}\n"
        ))
        .expect(&format!("          1 of 3 is ruled out by the adapter: {why}\n"));
    // What the language has no words for.
    plan(&NONE.replace("Ron)", "Nff)")).expect_code(0).expect("Nff has no words for ");
    plan(&NONE.replace("Ron)", "Ron, tolerance: 7)")).expect_code(2).expect("adapters/none.ron:1:");
    let other = ["grade", "--renderer", "nobody", "--rubric", "rubric.ron", "--plan"];
    tree.run(&other).expect_code(2).expect("there is no adapter \"nobody\"");
}

/// The blocks of RON in docs/course.md, each with the path that its first line names.
fn course() -> Vec<(&'static str, &'static str)> {
    let blocks = include_str!("../../docs/course.md").split("```ron\n// ").skip(1);
    let blocks = blocks.map(|rest| rest.split("```").next().unwrap());
    blocks.map(|block| block.split_once('\n').unwrap()).collect()
}

/// What docs/course.md shows, as files, with goldray as the renderer; `last` is done to
/// each picture.
fn project(last: &str) -> Tree {
    let tree = Tree::new(&[]);
    for (path, text) in course() {
        tree.write(path, text.as_bytes());
    }
    let goldray = env!("CARGO_BIN_EXE_xtask");
    let script = format!(
        "#!/bin/sh\nset -e\n{goldray} import \"$1\" --out s.ron --shading classic\n\
         {goldray} render s.ron --out \"$2\"\n{last}\n"
    );
    tree.write("build/tracer", script.as_bytes());
    #[cfg(unix)]
    {
        let mode = std::os::unix::fs::PermissionsExt::from_mode(0o755);
        std::fs::set_permissions(tree.path("build/tracer"), mode).unwrap();
    }
    tree.run(&["bless", "--all"]).expect_code(0);
    tree
}

const COURSE: [&str; 7] =
    ["grade", "--renderer", "mine", "--rubric", "rubric.ron", "--out", "grade"];

#[test]
#[cfg(unix)]
fn the_project_of_the_document_is_graded_as_it_says() {
    let tree = project("");
    tree.run(&["check"]).expect_code(0);
    tree.run(&[&COURSE[..5], &["--plan"]].concat()).expect_code(0);
    tree.run(&["conform", "--renderer", "mine"]).expect_code(0).expect("My tracer: 2 pass");
    let full = "      25 of 25       Assignment 1: rays, spheres and shadows\n";
    tree.run(&COURSE).expect_code(0).expect(full);
}

#[test]
#[cfg(unix)]
fn lost_points_have_their_reasons_and_pictures() {
    // The second scene is the one with a box.
    let wrong = "grep -q Box \"$1\" || exit 0\nsed 's/diffuse: (0.8/diffuse: (0.4/' s.ron > t.ron\n\
                 GOLDRAY render t.ron --out \"$2\"";
    let tree = project(&wrong.replace("GOLDRAY", env!("CARGO_BIN_EXE_xtask")));
    tree.run(&COURSE).expect_code(1).expect("      10 of 25       Assignment 1");
    let page = std::fs::read_to_string(tree.path("grade/grade.md")).unwrap();
    for line in [
        "# Assignment 1: rays, spheres and shadows: 10 of 25 points\n",
        "\n## Shadows: 0 of 5 points\n\n- <code>shadow/on-a-box</code>: fail\n  - ",
        "interior pixels differ by more than 5e-3, the worst (",
        "\n  - reference, difference and picture: <code>mine/shadow/on-a-box.png</code>\n",
    ] {
        assert!(page.contains(line), "{line}\n{page}");
    }
    assert!(!page.contains("## Basics"), "{page}");
    assert!(tree.path("grade/mine/shadow/on-a-box.png").exists());
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
    tree.run(&PLAN[..5]).expect_code(2).expect("None cannot be asked: there is no program");
}
