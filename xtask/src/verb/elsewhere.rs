//! Verbs of programs that are built when they are first asked for, so that
//! nobody waits for them before a first verdict.

use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitStatus};

use crate::{Answer, CannotAsk, Here};
use harness::store;

/// Flags that another program reads.
#[derive(Debug, clap::Args)]
pub(crate) struct Passed {
    /// Flags of its own; --help lists them
    #[arg(trailing_var_arg = true, allow_hyphen_values = true, value_name = "ARGS")]
    args: Vec<OsString>,
}

/// A program of the repository: its manifest, profile, and what else it is built
/// with.
pub(crate) struct Program {
    manifest: &'static str,
    profile: &'static str,
    build: &'static [&'static str],
}

/// The benches, a workspace of their own.
const BENCH: Program =
    Program { manifest: "crates/bench/Cargo.toml", profile: "release", build: &[] };

/// The command line of the exact oracle.
const STRESS: Program =
    Program { manifest: "xtask/stress/Cargo.toml", profile: "release", build: &[] };

/// The command line of the renderer that can be wrong on purpose.
const FAULTS: Program =
    Program { build: &["--features", "faults", "--bin", "xtask-faults"], ..XTASK };

/// This program.
const XTASK: Program = Program { manifest: "xtask/Cargo.toml", profile: "release", build: &[] };

/// Runs a bench of `crates/bench`, whose exit code is the answer.
pub(crate) fn bench(name: &str, passed: &Passed) -> Result<Answer, CannotAsk> {
    run(&BENCH, &format!("bench {name}"), [name.into()].into(), passed)
}

/// Runs a verb of `xtask-stress`, whose exit code is the answer.
pub(crate) fn stress(here: &Here, verb: &[&str], passed: &Passed) -> Result<Answer, CannotAsk> {
    let args = root(here).chain(verb.iter().map(OsString::from)).collect();
    run(&STRESS, &verb.join(" "), args, passed)
}

/// Runs `xtask-faults`, whose exit code is the answer.
pub(crate) fn faults(here: &Here, passed: &Passed) -> Result<Answer, CannotAsk> {
    run(&FAULTS, "faults", root(here).collect(), passed)
}

/// The suite's folder as a flag, if it was named.
fn root(here: &Here) -> impl Iterator<Item = OsString> {
    here.root.iter().flat_map(|root| ["--root".into(), root.into()])
}

/// Builds a program and runs it.
fn run(
    program: &Program,
    verb: &str,
    first: Vec<OsString>,
    Passed { args }: &Passed,
) -> Result<Answer, CannotAsk> {
    let args: Vec<_> = first.into_iter().chain(args.iter().cloned()).collect();
    let status = status(&mut program.command(verb, &args)?)?;
    Ok(match status.code().and_then(|code| u8::try_from(code).ok()) {
        Some(0) => Answer::Yes,
        Some(code) => Answer::Code(code),
        None => return Err(CannotAsk::file(Path::new(verb), &format!("ended with {status}"))),
    })
}

impl Program {
    /// This program, built with another profile.
    pub(crate) const fn this_in(profile: &'static str) -> Self {
        Self { profile, ..XTASK }
    }

    /// What builds it and runs it; `verb` is what it is asked for.
    ///
    /// # Errors
    /// It is not there.
    pub(crate) fn command(&self, verb: &str, args: &[OsString]) -> Result<Command, CannotAsk> {
        let (here, manifest) = (std::env::current_dir()?, self.manifest);
        let path = found(&here, manifest).ok_or_else(|| {
            let what = format!(
                "expected a folder inside goldray's repository, found no {manifest} from here up: \
                 go there, then cargo xtask {verb}"
            );
            CannotAsk::file(&here, &what)
        })?;
        // The cargo that runs this, if one does.
        let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
        let mut command = Command::new(&cargo);
        command.args(["run", "--profile", self.profile, "--locked", "--quiet"]);
        command.arg("--manifest-path").arg(path);
        command.args(self.build).arg("--").args(args);
        Ok(command)
    }
}

/// Runs it to its end.
pub(crate) fn status(command: &mut Command) -> Result<ExitStatus, CannotAsk> {
    let program = PathBuf::from(command.get_program());
    command.status().map_err(|error| CannotAsk::file(&program, &error.to_string()))
}

/// The nearest such file, from a folder up.
fn found(here: &Path, manifest: &str) -> Option<PathBuf> {
    here.ancestors().map(|folder| folder.join(manifest)).find(|path| store::is_file(path))
}
