//! `bless --plan`, `--apply` and `--repack` as the real binary does them.
#![allow(clippy::unwrap_used, clippy::disallowed_methods)]

mod tree;

use std::collections::BTreeMap;
use std::fs;

use harness::golden::{from_png, to_png};
use serde_json::Value;
use tree::{SQUARE, Tree};

/// A square whose upper half is gone.
fn flat() -> String {
    SQUARE.replace("(1, 1, 1)", "(1, 0.5, 1)")
}

/// One golden to add, one to replace, one to remove, and one that matches; `b`
/// has a mesh.
fn tree() -> Tree {
    let mesh = SQUARE.replace("Box(min: (-1, -1, -1), max: (1, 1, 1))", "Mesh(file: \"b.obj\")");
    let tree = Tree::new(&[("b", &mesh), ("c", SQUARE), ("gone", SQUARE)]);
    tree.write("fixtures/b.obj", MESH);
    tree.run(&["bless", "--all"]).expect_code(0);
    fs::remove_file(tree.path("fixtures/gone.ron")).unwrap();
    tree.write("fixtures/b.obj", &[MESH, b"# moved\n"].concat());
    tree.write("fixtures/a.ron", flat().as_bytes());
    tree
}

const MESH: &[u8] = b"v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nf 1 2 3 4\n";

/// Every golden's bytes by its file's name.
fn goldens(tree: &Tree) -> BTreeMap<String, Vec<u8>> {
    let entries = fs::read_dir(tree.path("golden")).unwrap().map(|entry| entry.unwrap());
    let file = |entry: fs::DirEntry| {
        (entry.file_name().into_string().unwrap(), fs::read(entry.path()).unwrap())
    };
    entries.map(file).collect()
}

fn plan(tree: &Tree) -> Value {
    serde_json::from_slice(&fs::read(tree.path("plan.json")).unwrap()).unwrap()
}

#[test]
fn a_plan_that_cannot_be_written_is_refused_before_anything_is_rendered() {
    let tree = tree();
    let ran = tree.run(&["bless", "--all", "--plan", "."]).expect_code(2);
    let ran = ran.expect(".: is there already, and is no file: name a file");
    assert!(!ran.stderr().contains("blessing"), "{}", ran.stderr());
}

#[test]
fn a_plan_changes_nothing_and_applied_does_what_bless_does() {
    let (tree, other) = (tree(), tree());
    let before = goldens(&tree);
    let ran = tree.run(&["bless", "--all", "--prune", "--plan", "plan.json"]).expect_code(0);
    ran.expect("3 to be written or removed, 0 refused: see plan.json");
    assert_eq!(goldens(&tree), before);
    let steps = &plan(&tree)["goldens"];
    let said = |i: usize| ["name", "action", "verdict"].map(|key| steps[i][key].as_str().unwrap());
    assert_eq!(said(0), ["a", "add", "missing_golden"]);
    assert_eq!(said(1), ["b", "replace", "stale_golden"]);
    assert_eq!(said(2), ["gone", "prune", "orphan_golden"]);
    assert_eq!(steps[1]["distances"]["differing_pixels"], 0);
    assert!(steps[0]["before"].is_null() && steps[2]["after"].is_null());

    let ran = tree.run(&["bless", "--apply", "plan.json"]).expect_code(0);
    ran.expect("added     a").expect("replaced  b: was stale").expect("3 written");
    other.run(&["bless", "--all", "--prune"]).expect_code(0);
    assert_eq!(goldens(&tree), goldens(&other), "the very bytes");
    tree.run(&["check"]).expect_code(0);
    // Done is done: the goldens are not as they were when it was made.
    let ran = tree.run(&["bless", "--apply", "plan.json"]).expect_code(2);
    ran.expect("\"gone\" is no fixture and no golden of this suite");
    tree.write("golden/gone.png", &before["gone.png"]);
    tree.run(&["bless", "--apply", "plan.json"]).expect_code(1).expect("moved     a: ");
}

/// After a change, the plan is refused as a whole, with these words.
#[track_caller]
fn refused(change: impl Fn(&Tree), said: &[&str]) {
    let tree = tree();
    tree.run(&["bless", "--all", "--prune", "--plan", "plan.json"]).expect_code(0);
    change(&tree);
    let before = goldens(&tree);
    let mut ran = tree.run(&["bless", "--apply", "plan.json"]).expect_code(1);
    for said in said {
        ran = ran.expect(said);
    }
    ran.expect("nothing is written");
    assert_eq!(goldens(&tree), before);
}

#[test]
fn a_plan_is_refused_as_a_whole_if_anything_moved() {
    let other = tree();
    other.run(&["bless", "c"]).expect_code(0);
    let png = goldens(&other)["c.png"].clone();
    refused(|t| t.write("golden/a.png", &png), &["a: the golden's file: expected none, found "]);
    refused(|t| t.write("golden/b.png", &png), &["b: the golden's file: expected "]);
    refused(|t| t.write("golden/gone.png", b"x"), &["gone: the golden's file: expected "]);
    refused(
        |t| t.write("fixtures/a.ron", SQUARE.as_bytes()),
        &["a: the scene: expected ", "a: the picture's file: expected "],
    );
    refused(
        |t| t.write("fixtures/b.obj", MESH),
        &["b: the verdict: expected stale_golden, found match"],
    );
    let other_mesh = [MESH, b"# again\n"].concat();
    refused(
        |t| t.write("fixtures/b.obj", &other_mesh),
        &["b: the files it names: expected ", "b: the picture's file: expected "],
    );
    refused(
        |t| t.write("fixtures/a.ron", b"()"),
        &["a: the verdict: expected missing_golden, found refused"],
    );
    refused(
        |t| t.write("fixtures/gone.ron", SQUARE.as_bytes()),
        &["gone: its fixture: expected none, found fixtures/gone.ron"],
    );
    refused(
        |t| {
            let plan = fs::read_to_string(t.path("plan.json")).unwrap();
            let after = plan.split("\"after\": \"").nth(1).unwrap()[..32].to_owned();
            t.write("plan.json", plan.replace(&after, &"0".repeat(32)).as_bytes());
        },
        &["a: the picture's file: expected 00000000"],
    );
}

#[test]
fn what_is_no_plan_of_this_suite_cannot_be_applied() {
    let tree = tree();
    tree.run(&["bless", "--all", "--plan", "plan.json"]).expect_code(0);
    let good = fs::read_to_string(tree.path("plan.json")).unwrap();
    let refused = |from: &str, to: &str, said: &str| {
        assert!(good.contains(from), "{from}");
        tree.write("bad.json", good.replacen(from, to, 1).as_bytes());
        tree.run(&["bless", "--apply", "bad.json"]).expect_code(2).expect(said).expect("bad.json");
    };
    refused("\"schema\": 1", "\"schema\": 2", "expected a plan with \"schema\": 1, found 2");
    refused("\"schema\": 1,", "", "missing field `schema`");
    refused("\n}", "", "expected a plan as");
    refused("\"a\"", "\"../a\"", "\"../a\" is no fixture and no golden of this suite");
    refused("\"a\"", "\"/etc/a\"", "is no fixture and no golden of this suite");
    refused("\"a\"", "\"b\"", "expected each golden once, found \"b\" again");
    refused("\"action\": \"add\"", "\"action\": \"replace\"", "expected the hashes that go with");
    refused("\"action\": \"add\"", "\"action\": \"remove\"", "unknown variant `remove`");
    refused("\"refused\"", "\"also\": 1, \"refused\"", "unknown field `also`");
    tree.run(&["bless", "--apply", "no.json"]).expect_code(2).expect("there is no such file");
    tree.write("bad.json", b"\x89PNG");
    tree.run(&["bless", "--apply", "bad.json"]).expect_code(2).expect("expected a plan as");
    for more in ["a", "--all", "--prune", "--repack"] {
        tree.run(&["bless", "--apply", "plan.json", more]).expect_code(2);
    }
    assert!(!tree.path("golden/a.png").exists());
    for file in ["golden/plan.json", "fixtures/plan.json"] {
        tree.run(&["bless", "--all", "--plan", file]).expect_code(2).expect("outside of");
    }
    for args in [["--all", "--plan", "p.json"].as_slice(), &["--apply", "plan.json"]] {
        let args = [&["bless"], args].concat();
        tree.run_with(&args, &[("CI", "1")]).expect_code(2).expect("found the variable CI set");
    }
    // What is refused is in the plan, and no reason not to make it.
    tree.write("fixtures/c.ron", b"()");
    let ran = tree.run(&["bless", "--all", "--plan", "plan.json"]).expect_code(1);
    ran.expect("refused   c: fixtures/c.ron");
    assert_eq!(plan(&tree)["refused"][0]["name"], "c");
    tree.run(&["bless", "--apply", "plan.json"]).expect_code(0).expect("2 written");
}

#[test]
fn repacking_keeps_picture_and_note_and_accepts_nothing() {
    let tree = Tree::blessed(&[("a", SQUARE), ("b", SQUARE), ("c", SQUARE)]);
    let small = goldens(&tree);
    let golden = from_png(&small["a.png"]).unwrap();
    let large = to_png(&golden.picture, golden.provenance.as_ref()).unwrap();
    assert!(large.len() > small["a.png"].len());
    tree.write("golden/a.png", &large);
    tree.write("fixtures/b.ron", flat().as_bytes());
    fs::remove_file(tree.path("golden/c.png")).unwrap();
    let ran = tree.run(&["bless", "--all", "--repack"]).expect_code(1);
    let sizes = format!("repacked  a: {} to {} bytes", large.len(), small["a.png"].len());
    let ran = ran.expect(&sizes).expect("refused   b: stale golden: ");
    ran.expect("refused   c: there is no golden").expect("1 written, 2 refused");
    assert_eq!(goldens(&tree)["a.png"], small["a.png"]);
    assert_eq!(goldens(&tree)["b.png"], small["b.png"]);
    assert!(!tree.path("golden/c.png").exists());
    let ran = tree.run(&["bless", "--repack", "a"]).expect_code(0);
    ran.expect("0 written, 0 refused: ");
    tree.run_with(&["bless", "--repack", "a"], &[("CI", "1")]).expect_code(2);
}
