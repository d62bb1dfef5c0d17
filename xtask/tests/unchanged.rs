//! What `check` says of fixtures that it does not render again.
#![allow(clippy::unwrap_used, clippy::disallowed_methods)]

mod tree;

use std::fs;
use std::process::Stdio;

use serde_json::Value;
use tree::{Ran, SQUARE, Tree};

const RECORD: &str = "target/goldray-cache/matches.json";

/// How many were unchanged, audited and belied.
fn summary(json: &Value) -> [u64; 3] {
    ["unchanged", "audited", "belied"].map(|key| json["summary"][key].as_u64().unwrap())
}

#[test]
fn unchanged_fixtures_are_judged_without_rendering_unless_asked() {
    let tree = Tree::blessed(&[("a", SQUARE), ("b", SQUARE), ("c", SQUARE)]);
    let json =
        || -> Value { serde_json::from_slice(&fs::read(tree.path("out.json")).unwrap()).unwrap() };
    for (args, variables) in [(["--no-cache"].as_slice(), [].as_slice()), (&[], &[("CI", "1")])] {
        let args = [&["check", "--json", "out.json"], args].concat();
        let ran = tree.run_with(&args, variables).expect_code(0).expect("3 judged: 3 match (");
        assert!(!ran.stdout().contains("unchanged"), "{}", ran.stdout());
        assert!(!tree.path(RECORD).exists(), "neither read nor written");
        assert_eq!(summary(&json()), [0; 3]);
    }
    tree.run(&["check"]).expect_code(0).expect("3 judged: 3 match (");
    let ran = tree.run(&["check", "--json", "out.json"]).expect_code(0).expect("audited: ");
    ran.expect("3 judged: 3 match (3 unchanged since their last match, 1 of them rendered again");
    assert_eq!(summary(&json()), [3, 1, 0]);
    let fixtures = json()["fixtures"].as_array().unwrap().clone();
    assert_eq!(
        fixtures.iter().filter(|f| f["cached"] == true && f["max_abs"].is_null()).count(),
        2
    );
    assert_eq!(fixtures.iter().filter(|f| f["audited"] == true && f["max_abs"] == 0).count(), 1);
    for (args, variables) in [(["--no-cache"].as_slice(), [].as_slice()), (&[], &[("CI", "1")])] {
        let args = [&["check", "--json", "out.json"], args].concat();
        let ran = tree.run_with(&args, variables).expect_code(0).expect("3 judged: 3 match (");
        assert!(!ran.stdout().contains("unchanged"), "{}", ran.stdout());
        assert_eq!(summary(&json()), [0; 3]);
    }

    // A golden that no fixture matches, and a record that says they all do.
    let record = fs::read_to_string(tree.path(RECORD)).unwrap();
    let hash = record.split("\"golden\": ").nth(1).unwrap()[..34].to_owned();
    tree.write("fixtures/a.ron", SQUARE.replace("(1, 1, 1)", "(1, 0.5, 1)").as_bytes());
    tree.run(&["bless", "a"]).expect_code(0);
    tree.run(&["check"]).expect_code(0).expect("(2 unchanged");
    let golden = fs::read(tree.path("golden/a.png")).unwrap();
    let other = fs::read_to_string(tree.path(RECORD)).unwrap();
    let other = other.split("\"golden\": ").nth(1).unwrap()[..34].to_owned();
    fs::remove_file(tree.path("fixtures/a.ron")).unwrap();
    for name in ["b", "c"] {
        tree.write(&format!("golden/{name}.png"), &golden);
    }
    tree.write(RECORD, record.replace(&hash, &other).as_bytes());
    let ran = tree.run(&["check", "--json", "out.json"]).expect_code(1);
    let ran = ran.expect("target/goldray-cache/matches.json was wrong: it is removed");
    ran.expect("3 judged: 1 orphan golden, 2 stale golden (1 unchanged");
    assert!(!tree.path(RECORD).exists());
    assert_eq!(summary(&json()), [1, 1, 1]);
}

#[test]
fn checks_beside_each_other_keep_the_record_whole() {
    let failing = (0..5).map(|i| format!("wrong/f{i}"));
    let names: Vec<_> = (0..40).map(|i| format!("f{i}")).chain(failing).collect();
    let fixtures: Vec<_> = names.iter().map(|name| (name.as_str(), SQUARE)).collect();
    let tree = Tree::blessed(&fixtures);
    fs::remove_dir_all(tree.path("golden/wrong")).unwrap();
    for round in 0..3 {
        // Something to render and to record in each round, and a failure.
        tree.write("fixtures/f0.ron", format!("// {round}\n{SQUARE}").as_bytes());
        let start = || tree.command(&["check"]).stdout(Stdio::piped()).spawn().unwrap();
        let running: Vec<_> = std::iter::repeat_with(start).take(4).collect();
        for child in running {
            let ran = Ran(child.wait_with_output().unwrap()).expect_code(1);
            ran.expect("45 judged: 40 match, 5 missing golden");
        }
        tree.run(&["check"]).expect_code(1).expect("(40 unchanged since their last match, 2 of");
    }
}

#[test]
fn a_record_that_cannot_be_kept_leaves_the_verdicts_as_they_are() {
    let tree = Tree::blessed(&[("a", SQUARE), ("b", SQUARE)]);
    let json = || -> Value {
        serde_json::from_slice(&fs::read(tree.path("target/out.json")).unwrap()).unwrap()
    };
    tree.write("target/goldray-cache", b"");
    tree.run(&["check", "--json", "target/out.json"])
        .expect_code(0)
        .expect("2 judged: 2 match (")
        .expect("the record of matches could not be kept: ");
    assert_eq!(summary(&json()), [0; 3]);
    fs::remove_file(tree.path("golden/b.png")).unwrap();
    fs::remove_file(tree.path("target/goldray-cache")).unwrap();
    tree.write(&format!("{RECORD}/x"), b"");
    let ran = tree.run(&["check"]).expect_code(1).expect("1 match, 1 missing golden");
    ran.expect("missing golden      b: ");
    assert!(tree.path("target/goldray/b.png").is_file());
}
