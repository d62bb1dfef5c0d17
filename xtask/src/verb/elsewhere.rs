//! Verbs of programs that are built when they are first asked for, so that
//! nobody waits for them before a first verdict.

use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::Command;

use harness::store;
use xtask::{Answer, CannotAsk, Here};

/// Flags that another program reads.
#[derive(Debug, clap::Args)]
pub(crate) struct Passed {
    /// Flags of its own; --help lists them
    #[arg(trailing_var_arg = true, allow_hyphen_values = true, value_name = "ARGS")]
    args: Vec<OsString>,
}

/// The crate of the benches, in the repository; a workspace of its own.
const BENCH_MANIFEST: &str = "crates/bench/Cargo.toml";

/// The command line of the exact oracle, in the repository.
const STRESS_MANIFEST: &str = "xtask/stress/Cargo.toml";

/// The command line of the renderer that can be wrong on purpose, in the
/// repository, and how it is built.
const FAULTS_MANIFEST: &str = "xtask/Cargo.toml";
const FAULTS_BUILD: &[&str] = &["--features", "faults", "--bin", "xtask-faults"];

/// Runs a bench of `crates/bench`, whose exit code is the answer.
pub(crate) fn bench(name: &str, passed: &Passed) -> Result<Answer, CannotAsk> {
    run(BENCH_MANIFEST, &[], &format!("bench {name}"), [name.into()].into(), passed)
}

/// Runs a verb of `xtask-stress`, whose exit code is the answer.
pub(crate) fn stress(here: &Here, verb: &[&str], passed: &Passed) -> Result<Answer, CannotAsk> {
    let args = root(here).chain(verb.iter().map(OsString::from)).collect();
    run(STRESS_MANIFEST, &[], &verb.join(" "), args, passed)
}

/// Runs `xtask-faults`, whose exit code is the answer.
pub(crate) fn faults(here: &Here, passed: &Passed) -> Result<Answer, CannotAsk> {
    run(FAULTS_MANIFEST, FAULTS_BUILD, "faults", root(here).collect(), passed)
}

/// The suite's folder as a flag, if it was named.
fn root(here: &Here) -> impl Iterator<Item = OsString> {
    here.root.iter().flat_map(|root| ["--root".into(), root.into()])
}

/// Builds the program of a manifest and runs it.
fn run(
    manifest: &str,
    build: &[&str],
    verb: &str,
    first: Vec<OsString>,
    Passed { args }: &Passed,
) -> Result<Answer, CannotAsk> {
    let here = std::env::current_dir()?;
    let path = found(&here, manifest).ok_or_else(|| {
        let what = format!(
            "expected a folder inside goldray's repository, found no {manifest} from here up: go \
             there, then cargo xtask {verb}"
        );
        CannotAsk::file(&here, &what)
    })?;
    // The cargo that runs this, if one does.
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let status = Command::new(&cargo)
        .args(["run", "--release", "--locked", "--quiet", "--manifest-path"])
        .arg(path)
        .args(build)
        .arg("--")
        .args(first)
        .args(args)
        .status()
        .map_err(|error| CannotAsk::file(Path::new(&cargo), &error.to_string()))?;
    Ok(match status.code().and_then(|code| u8::try_from(code).ok()) {
        Some(0) => Answer::Yes,
        Some(code) => Answer::Code(code),
        None => return Err(CannotAsk::file(Path::new(verb), &format!("ended with {status}"))),
    })
}

/// The nearest such file, from a folder up.
fn found(here: &Path, manifest: &str) -> Option<PathBuf> {
    here.ancestors().map(|folder| folder.join(manifest)).find(|path| store::is_file(path))
}
