//! Verbs of programs that are built when they are first asked for, so that
//! nobody waits for them before a first verdict.

use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitStatus};

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

/// Runs a bench of `crates/bench`, whose exit code is the answer.
pub(crate) fn bench(name: &str, passed: &Passed) -> Result<Answer, CannotAsk> {
    run(BENCH_MANIFEST, &format!("bench {name}"), [name.into()].into(), passed)
}

/// Runs a verb of `xtask-stress`, whose exit code is the answer.
pub(crate) fn stress(here: &Here, verb: &[&str], passed: &Passed) -> Result<Answer, CannotAsk> {
    let root = here.root.iter().flat_map(|root| ["--root".into(), root.into()]);
    let args = root.chain(verb.iter().map(OsString::from)).collect();
    run(STRESS_MANIFEST, &verb.join(" "), args, passed)
}

/// Builds the program of a manifest and runs it.
fn run(
    manifest: &str,
    verb: &str,
    first: Vec<OsString>,
    Passed { args }: &Passed,
) -> Result<Answer, CannotAsk> {
    let args: Vec<_> = first.into_iter().chain(args.iter().cloned()).collect();
    let status = status(&mut cargo_run(manifest, "release", verb, &args)?)?;
    Ok(match status.code().and_then(|code| u8::try_from(code).ok()) {
        Some(0) => Answer::Yes,
        Some(code) => Answer::Code(code),
        None => return Err(CannotAsk::file(Path::new(verb), &format!("ended with {status}"))),
    })
}

/// What builds the program of a manifest of the repository in a profile and runs
/// it; `verb` is what it is asked for.
pub(crate) fn cargo_run(
    manifest: &str,
    profile: &str,
    verb: &str,
    args: &[OsString],
) -> Result<Command, CannotAsk> {
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
    let mut command = Command::new(&cargo);
    command.args(["run", "--profile", profile, "--locked", "--quiet", "--manifest-path"]);
    command.arg(path).arg("--").args(args);
    Ok(command)
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
