//! Verbs of other programs: these are found, run, and their exit code passed on.
#![allow(clippy::unwrap_used, clippy::disallowed_methods)]

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

/// A crate in the place of another, which ends with the code that it is told
/// and says what else it was.
const STAND_IN: [(&str, &str); 3] = [
    (
        "Cargo.toml",
        "[package]\nname = \"bench\"\nversion = \"0.1.0\"\nedition = \"2024\"\n[workspace]\n
            [features]\nfaults = []\n[[bin]]\nname = \"xtask-faults\"\npath = \"src/main.rs\"\n",
    ),
    ("Cargo.lock", "version = 4\n\n[[package]]\nname = \"bench\"\nversion = \"0.1.0\"\n"),
    (
        "src/main.rs",
        "fn main() {
            let args: Vec<_> = std::env::args().skip(1).collect();
            println!(\"PLACE: {}\", args.join(\" \"));
            std::process::exit(args.last().unwrap().parse().unwrap_or(0));
        }",
    ),
];

fn ask(folder: &Path, args: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_xtask"));
    command.args(args).current_dir(folder);
    // Where the crate is built must not be where this one is.
    command.env("CARGO_TARGET_DIR", folder.join("target")).output().unwrap()
}

/// What is said in a repository with stand-ins to `cargo xtask` and these.
#[track_caller]
fn check(args: &[&str], code: i32, expected: &str) {
    let folder = tempfile::tempdir().unwrap();
    let inside = folder.path().join("docs");
    for place in ["crates/bench", "xtask/stress", "xtask"] {
        for (path, text) in STAND_IN {
            let path = folder.path().join(place).join(path);
            fs::create_dir_all(path.parent().unwrap()).unwrap();
            fs::write(path, text.replace("PLACE", place)).unwrap();
        }
    }
    fs::create_dir_all(&inside).unwrap();
    let output = ask(&inside, args);
    assert_eq!(output.status.code(), Some(code), "{output:?}");
    assert_eq!(String::from_utf8_lossy(&output.stdout).trim_end(), expected);
}

#[test]
fn flags_go_in_and_the_exit_code_comes_out() {
    check(&["bench", "trace", "--help"], 0, "crates/bench: trace --help");
    check(&["bench", "scaling", "--short", "-x", "7"], 7, "crates/bench: scaling --short -x 7");
    check(&["stress", "--help"], 0, "xtask/stress: stress --help");
    check(&["bench", "error", "--list"], 0, "xtask/stress: bench error --list");
    check(&["faults", "--list"], 0, "xtask: --list");
    check(&["--root", "/nowhere", "faults", "9"], 9, "xtask: --root /nowhere 9");
    let expected = "xtask/stress: --root /nowhere stress --full 3";
    check(&["--root", "/nowhere", "stress", "--full", "3"], 3, expected);
}

#[test]
fn outside_of_the_repository_it_says_so() {
    let folder = tempfile::tempdir().unwrap();
    let benches = [
        "trace",
        "image",
        "kernels",
        "check",
        "scaling",
        "instructions",
        "report",
        "peers",
        "error",
    ];
    for verb in
        benches.map(|name| vec!["bench", name]).into_iter().chain([vec!["stress"], vec!["faults"]])
    {
        let output = ask(folder.path(), &verb);
        let said = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{said}");
        assert!(said.contains("expected a folder inside goldray's repository"), "{said}");
        assert!(said.contains(&format!("cargo xtask {}", verb.join(" "))), "{said}");
    }
}
