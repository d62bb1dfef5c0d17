//! `rebuild`: this program built again from its edited sources, and begun anew.

use std::ffi::OsString;
use std::io::{Read, Write};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::thread;
use std::time::Duration;

use conform::process::{Bounds, Ended, Group, end_of};
use harness::store::{self, Scratch};
use harness::suite::Suite;
use serde_json::Value;

use crate::CannotAsk;
use crate::interrupt::Interrupt;

/// How a build ended.
#[derive(Debug, PartialEq, Eq)]
pub enum Built {
    /// The program is in this file.
    Program(PathBuf),
    /// The compiler has said why not.
    Failed,
    /// It was time to end, and nothing of it is left running.
    Interrupted,
}

/// The repository whose program this suite is judged by, if it is there to be
/// edited. Elsewhere than on Unix a program that runs cannot be built again.
pub fn repository(suite: &Suite) -> Option<PathBuf> {
    let is_repository = ["Cargo.toml", "xtask/Cargo.toml", "crates/tracer/Cargo.toml"]
        .iter()
        .all(|file| store::is_file(&suite.root().join(file)));
    (cfg!(unix) && is_repository).then(|| suite.root().to_owned())
}

/// Builds this program from the repository at `root`, as its alias does.
///
/// # Errors
/// There is no cargo, or it says nothing of what it built.
pub fn build(root: &Path, interrupt: &Interrupt) -> Result<Built, CannotAsk> {
    // A compiler that is stopped leaves files behind: here, they go away.
    let scratch = Scratch::new()?;
    // The cargo that runs this, if one does.
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let mut command = Command::new(&cargo);
    command.args(["build", "--release", "--package", "xtask", "--bin", "xtask"]);
    command.args(["--message-format", "json-render-diagnostics"]);
    command.current_dir(root).env("TMPDIR", scratch.path("")).env_remove(RESUMED);
    command.stdin(Stdio::null()).stdout(Stdio::piped());
    let failed = |error: std::io::Error| CannotAsk::file(Path::new(&cargo), &error.to_string());
    // With the compilers that it starts, so that all of them can be stopped.
    let mut group = Group::start(&mut command).map_err(failed)?;
    let stdout = group.child().stdout.take();
    let messages = thread::spawn(move || {
        let mut text = String::new();
        // What cannot be read has no program in it.
        let _ = stdout.map(|mut stdout| stdout.read_to_string(&mut text));
        text
    });
    let bounds = Bounds { time: Duration::MAX, growth: None, stop: &|time| interrupt.wait(time) };
    let Ended::Alone(status) = end_of(&mut group, &bounds).map_err(failed)? else {
        return Ok(Built::Interrupted);
    };
    if !status.success() {
        return Ok(Built::Failed);
    }
    let messages = messages.join().unwrap_or_default();
    let program = messages.lines().rev().find_map(executable).map(Built::Program);
    program.ok_or_else(|| CannotAsk::file(Path::new(&cargo), "does not say what it has built"))
}

/// The program in a message of cargo.
fn executable(message: &str) -> Option<PathBuf> {
    let message: Value = serde_json::from_str(message).ok()?;
    let is_ours = message["reason"] == "compiler-artifact" && message["target"]["name"] == "xtask";
    message["executable"].as_str().filter(|_| is_ours).map(PathBuf::from)
}

/// The variable that tells a program that is begun anew where it served.
pub const RESUMED: &str = "GOLDRAY_WATCH";

/// Becomes the program in this file, with the same arguments, and with `resumed`
/// in [`RESUMED`]. It comes back only if that was not possible.
#[cfg(unix)]
pub fn become_program(program: &Path, resumed: &str) -> CannotAsk {
    use std::os::unix::process::CommandExt;
    // What was printed so far is not to be printed by the other one.
    let _ = std::io::stdout().flush();
    let args: Vec<OsString> = std::env::args_os().skip(1).collect();
    let error = Command::new(program).args(args).env(RESUMED, resumed).exec();
    CannotAsk::file(program, &error.to_string())
}

/// Runs the program in this file, with the same arguments, and with `resumed` in
/// [`RESUMED`], and ends as it does. It comes back only if that was not possible.
#[cfg(not(unix))]
pub fn become_program(program: &Path, resumed: &str) -> CannotAsk {
    let _ = std::io::stdout().flush();
    let args: Vec<OsString> = std::env::args_os().skip(1).collect();
    match Command::new(program).args(args).env(RESUMED, resumed).status() {
        Ok(status) => std::process::exit(status.code().unwrap_or(2)),
        Err(error) => CannotAsk::file(program, &error.to_string()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_program_is_found_among_messages() {
        let artifact = |name: &str, executable: &str| {
            format!(
                r#"{{"reason":"compiler-artifact","target":{{"name":"{name}"}},"executable":{executable}}}"#
            )
        };
        assert_eq!(executable(&artifact("xtask", "\"/a/xtask\"")), Some("/a/xtask".into()));
        for other in [
            artifact("xtask", "null"),
            artifact("tracer", "\"/a/x\""),
            r#"{"reason":"build-finished","success":true}"#.to_owned(),
            "no JSON".to_owned(),
        ] {
            assert_eq!(executable(&other), None, "{other}");
        }
    }
}
