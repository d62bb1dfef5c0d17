//! The benches that are a crate of their own: found, run, and their exit code
//! passed on.
#![allow(clippy::unwrap_used, clippy::disallowed_methods)]

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

/// A crate in the place of the benches, which ends with the code that it is
/// told and says what else it was.
const STAND_IN: [(&str, &str); 3] = [
    (
        "Cargo.toml",
        "[package]\nname = \"bench\"\nversion = \"0.1.0\"\nedition = \"2024\"\n[workspace]\n",
    ),
    ("Cargo.lock", "version = 4\n\n[[package]]\nname = \"bench\"\nversion = \"0.1.0\"\n"),
    (
        "src/main.rs",
        "fn main() {
            let args: Vec<_> = std::env::args().skip(1).collect();
            println!(\"asked: {}\", args.join(\" \"));
            std::process::exit(args.last().unwrap().parse().unwrap_or(0));
        }",
    ),
];

fn bench(folder: &Path, args: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_xtask"));
    command.arg("bench").args(args).current_dir(folder);
    // Where the crate is built must not be where this one is.
    command.env("CARGO_TARGET_DIR", folder.join("target")).output().unwrap()
}

#[test]
fn flags_go_in_and_the_exit_code_comes_out() {
    let folder = tempfile::tempdir().unwrap();
    let inside = folder.path().join("docs");
    for (path, text) in STAND_IN {
        let path = folder.path().join("crates/bench").join(path);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, text).unwrap();
    }
    fs::create_dir_all(&inside).unwrap();
    for (args, code) in [(&["trace", "--help"][..], 0), (&["scaling", "--short", "-x", "7"], 7)] {
        let output = bench(&inside, args);
        let said = String::from_utf8_lossy(&output.stdout);
        assert_eq!(output.status.code(), Some(code), "{output:?}");
        assert_eq!(said.trim_end(), format!("asked: {}", args.join(" ")));
    }
}

#[test]
fn outside_of_the_repository_it_says_so() {
    let folder = tempfile::tempdir().unwrap();
    for name in ["trace", "image", "kernels", "check", "scaling", "instructions", "report", "peers"]
    {
        let output = bench(folder.path(), &[name]);
        let said = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{said}");
        assert!(said.contains("expected a folder inside goldray's repository"), "{said}");
        assert!(said.contains(&format!("cargo xtask bench {name}")), "{said}");
    }
}
