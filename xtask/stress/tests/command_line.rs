//! The real binary in a temporary tree: exit codes and text.
#![allow(clippy::unwrap_used, clippy::disallowed_methods)]

use std::fs;
use std::path::Path;
use std::process::Command;

/// A suite without a fixture.
fn tree() -> tempfile::TempDir {
    let tree = tempfile::tempdir().unwrap();
    fs::create_dir_all(tree.path().join("fixtures")).unwrap();
    tree
}

/// All that is said, where the exit code is as expected.
#[track_caller]
fn run(tree: &Path, args: &[&str], code: i32) -> String {
    let mut command = Command::new(env!("CARGO_BIN_EXE_xtask-stress"));
    let output = command.args(args).current_dir(tree).env_remove("CI").output().unwrap();
    let said = [output.stdout, output.stderr].map(|said| String::from_utf8(said).unwrap()).concat();
    assert_eq!(output.status.code(), Some(code), "{said}");
    said
}

#[track_caller]
fn check(tree: &Path, args: &[&str], code: i32, expected: &str) {
    let said = run(tree, args, code);
    assert!(said.contains(expected), "expected {expected:?} in:\n{said}");
}

#[test]
fn help_of_every_verb() {
    let tree = tree();
    let help = |verb: &[&str]| {
        let said = run(tree.path(), &[verb, &["--help"]].concat(), 0);
        format!("==== {} ====\n{said}", verb.join(" "))
    };
    insta::assert_snapshot!([help(&["stress"]), help(&["bench", "error"])].join("\n"));
}

#[test]
fn families_are_asked_by_name() {
    let tree = tree();
    for verb in [&["stress"][..], &["bench", "error"]] {
        let nothing = "the filter \"no-such-family\" selects nothing";
        check(tree.path(), &[verb, &["no-such-family"]].concat(), 2, nothing);
        let listed = run(tree.path(), &[verb, &["sphere/*", "--list"]].concat(), 0);
        assert!(listed.contains("sphere/") && !listed.contains("triangle/"), "{listed}");
    }
}

#[test]
fn kept_cases_are_replayed_and_a_full_run_is_taken_up() {
    let tree = tree();
    let scenes = ["stress", "image/fixed-scenes"];
    let full = ["stress", "image/fixed-scenes", "--full"];
    let done = "1 cases of 1 families from seed 2011, 0 kept ones";
    check(tree.path(), &full, 0, done);
    check(tree.path(), &full, 0, "1 of 1 cases were done before");
    let keep = |text: &str| {
        fs::create_dir_all(tree.path().join("tests")).unwrap();
        fs::write(tree.path().join("tests/kept-cases.txt"), text).unwrap();
    };
    keep("image/fixed-scenes 0x0p+0 # once wrong\n");
    check(tree.path(), &scenes, 0, "1 kept ones");
    keep("image/fixed-scenes 0.5x\n");
    check(tree.path(), &scenes, 2, "kept-cases.txt");
}
