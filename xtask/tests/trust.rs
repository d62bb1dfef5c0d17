//! The verbs that say whether a match can be trusted, in a temporary tree.
#![allow(clippy::unwrap_used, clippy::disallowed_methods)]

mod tree;

use std::fs;

use serde_json::Value;
use tree::{SQUARE, Tree};

fn json(tree: &Tree, path: &str) -> Value {
    serde_json::from_str(&fs::read_to_string(tree.path(path)).unwrap()).unwrap()
}

/// The square with a limit that lets half of it go.
fn loose() -> String {
    let image = "image: (16, 12)";
    assert!(SQUARE.contains(image));
    let check = "check: (limits: (differing_pixels: 40, reason: \"a test\"))";
    SQUARE.replace(image, &format!("{image},\n    {check}"))
}

#[test]
fn sensitivity_names_the_weakest() {
    let tree = Tree::blessed(&[("loose", &loose()), ("tight", SQUARE)]);
    let flags = ["sensitivity", "--json", "s.json", "--picture", "s.png"];
    let ran = tree.run(&flags).expect_code(0);
    let ran = ran.expect("loose                                blob-1                  never");
    ran.expect("The weakest fixture is loose: blob-1 at (0, 0) is never caught.");
    let found = json(&tree, "s.json");
    assert_eq!((&found["schema"], &found["weakest"]["fixture"]), (&1.into(), &"loose".into()));
    let cells = found["fixtures"].as_array().unwrap();
    let cell = |fixture: &str, defect: &str| {
        let is_it = |cell: &&Value| cell["fixture"] == fixture && cell["defect"] == defect;
        cells.iter().find(is_it).unwrap()
    };
    assert_eq!(cell("tight", "blob-1")["strength"], 1.0);
    assert_eq!(cell("tight", "hue")["answer"], "no_effect");
    assert_eq!(cell("loose", "blob-4")["answer"], "never");
    assert!(cell("loose", "blob-4")["missed"]["change"].as_u64() >= Some(4));
    assert!(fs::read(tree.path("s.png")).unwrap().starts_with(b"\x89PNG"));
    tree.run(&["sensitivity", "tight"]).expect_code(0).expect("The weakest fixture is tight");
    tree.run(&["sensitivity", "--visible", "gian=1"]).expect_code(2).expect("--visible: expected");
    tree.run(&["sensitivity", "--json", "golden/s.json"]).expect_code(2).expect("outside of");
    tree.run(&["sensitivity", "nobody"]).expect_code(2);
    fs::remove_file(tree.path("golden/tight.png")).unwrap();
    tree.run(&["sensitivity"]).expect_code(2).expect("fixtures/tight.ron: there is no golden");
}

#[test]
fn a_document_is_kept_true() {
    let tree = Tree::blessed(&[("tight", SQUARE)]);
    let document = "# A\n<!-- sensitivity -->\n<!-- /sensitivity -->\nB\n";
    tree.write("docs/a.md", document.as_bytes());
    let check = ["sensitivity", "--check", "docs/a.md"];
    tree.run(&check).expect_code(1).expect("cargo xtask sensitivity --markdown docs/a.md");
    assert_eq!(fs::read_to_string(tree.path("docs/a.md")).unwrap(), document, "not by a check");
    tree.run(&["sensitivity", "--markdown", "docs/a.md"]).expect_code(0);
    tree.run(&check).expect_code(0);
    let files = ["--json", "s.json", "--picture", "s.png"];
    tree.run(&[&check[..], &files].concat()).expect_code(0).expect("docs/a.md says what is");
    assert_eq!(json(&tree, "s.json")["schema"], 1);
    assert!(fs::read(tree.path("s.png")).unwrap().starts_with(b"\x89PNG"));
    let written = fs::read_to_string(tree.path("docs/a.md")).unwrap();
    assert!(written.starts_with("# A\n<!--") && written.ends_with("-->\nB\n"), "{written}");
    assert!(written.contains("| `blob-1` |"), "{written}");
    tree.write("docs/a.md", b"# A\n");
    tree.run(&check).expect_code(2).expect("expected the mark `<!-- sensitivity -->` once");
    tree.run(&["sensitivity", "--check", "none.md"]).expect_code(2).expect("no such file");
}

#[test]
fn lint_answers_yes_no_and_cannot_ask() {
    let tree = Tree::blessed(&[("a", SQUARE)]);
    tree.run(&["lint"]).expect_code(0).expect("1 linted: 0 findings");
    tree.write("fixtures/b.ron", loose().as_bytes());
    tree.run(&["lint", "a"]).expect_code(0);
    tree.run(&["lint"]).expect_code(1).expect("fixtures/b.ron:1: matches: expected a fixture");
    tree.run(&["lint", "b"]).expect_code(1).expect("1 linted: 1 finding\n");
    tree.run(&["bless", "b"]).expect_code(0);
    let ran = tree.run(&["lint", "--json", "l.json"]).expect_code(1);
    let ran = ran.expect("fixtures/a.ron:2: discriminability: expected a picture of its own");
    ran.expect("fixtures/b.ron:5: visible-defect: expected limits that catch `blob-1`");
    let found = json(&tree, "l.json");
    let rules: Vec<_> = found["rules"].as_array().unwrap().iter().map(|r| &r["name"]).collect();
    assert_eq!(rules.len(), 5, "{rules:?}");
    let first = &found["findings"][0];
    assert_eq!((&first["file"], &first["line"]), (&"fixtures/a.ron".into(), &2.into()));
    tree.write("golden/gone.png", b"");
    for verb in ["lint", "sensitivity", "calibrate"] {
        let ran = tree.run(&[verb, "gone"]).expect_code(2);
        ran.expect("expected a fixture, found only goldens without one");
    }
    tree.run(&["lint", "c"]).expect_code(2).expect("selects nothing");
    tree.run(&["lint", "--visible", "gain=0"]).expect_code(2).expect("above 0");
}

#[test]
fn calibrate_finds_no_spread_and_says_what_that_justifies() {
    let tree = Tree::blessed(&[("a", SQUARE), ("loose", &loose())]);
    let ran = tree.run(&["calibrate", "--this-build", "--json", "c.json"]).expect_code(0);
    ran.expect("none: identical").expect("2 calibrated: 0 with other bits");
    let found = json(&tree, "c.json");
    assert_eq!((&found["schema"], &found["builds"][0]["build"]), (&1.into(), &"dev".into()));
    // Four numbers of threads, at least plain arrays, twice.
    assert!(found["builds"][0]["ways"].as_u64() >= Some(8));
    assert_eq!(found["fixtures"][1]["justified"], Value::Null);
    tree.run(&["calibrate", "--repeats", "0"]).expect_code(2);
    // The other build is that of a checkout, in which this is not.
    tree.run(&["calibrate", "a"]).expect_code(2).expect("found no xtask/Cargo.toml");
    tree.run(&["lint", "loose"]).expect_code(1).expect("fixtures/loose.ron:5: loose-limit");
}
