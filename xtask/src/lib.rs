//! goldray's command line, and what it shares with that of `xtask-stress`: how a
//! verb ends, where it was given, how far it is.

pub mod browser;
pub mod cli;
pub mod interrupt;
pub mod look;
pub mod progress;
pub mod rebuild;
pub mod say;
pub mod serve;
pub mod terminal;
mod verb;

use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use harness::report::Reader;
use harness::store;
use harness::suite::{Suite, SuiteError};
use harness::verdict::shell_word;

/// How a verb ended.
pub enum Answer {
    /// Exit code 0.
    Yes,
    /// Exit code 1.
    No,
    /// The exit code of a program that was asked in turn, which has said why.
    Code(u8),
}

/// Why a verb could not do its work; exit code 2.
pub struct CannotAsk(pub String);

impl<E: std::error::Error> From<E> for CannotAsk {
    fn from(error: E) -> Self {
        Self(error.to_string())
    }
}

impl CannotAsk {
    /// For a file that is not what it should be.
    pub fn file(path: &Path, what: &str) -> Self {
        Self(format!("{}: {what}", path.display()))
    }
}

/// A place to print to that is gone or full ends the program, with an error and
/// no panic's message; without any if it was a reader that has seen enough, such
/// as `head`. Never as a success: nobody knows what the rest would have said.
pub fn end_where_nothing_can_be_printed() {
    let usual = std::panic::take_hook();
    std::panic::set_hook(Box::new(move |panic| {
        // What `println!` and `eprintln!` say; there is no other way to tell.
        match panic.payload_as_str().and_then(|said| said.strip_prefix("failed printing to ")) {
            Some(why) => {
                if !why.contains("Broken pipe") {
                    // If nobody hears that either, the exit code is left.
                    let _ = writeln!(std::io::stderr(), "error: cannot print to {why}");
                }
                std::process::exit(2);
            }
            None => usual(panic),
        }
    }));
}

/// The exit code of an answer; says why where there is none.
pub fn exit_code(answer: Result<Answer, CannotAsk>) -> ExitCode {
    match answer {
        Ok(Answer::Yes) => ExitCode::SUCCESS,
        Ok(Answer::No) => ExitCode::from(1),
        Ok(Answer::Code(code)) => ExitCode::from(code),
        Err(CannotAsk(why)) => {
            eprintln!("error: {}", why.trim_end());
            ExitCode::from(2)
        }
    }
}

/// Where the command was given.
pub struct Here {
    /// The suite's folder, if it was named.
    pub root: Option<PathBuf>,
}

impl Here {
    /// The suite that was named, or the nearest one from the current folder up.
    ///
    /// # Errors
    /// There is none.
    pub fn suite(&self) -> Result<Suite, CannotAsk> {
        if let Some(root) = &self.root {
            return Ok(Suite::open(root)?);
        }
        let here = std::env::current_dir()?;
        let nearest = here.ancestors().find_map(|folder| Suite::open(folder).ok());
        nearest.ok_or_else(|| SuiteError::NoSuite(here).into())
    }

    /// The fixtures that the filters select, at least one: of none there is
    /// nothing to say.
    ///
    /// # Errors
    /// Filters that select nothing or only goldens without a fixture, and folders
    /// that cannot be read.
    pub fn fixtures(suite: &Suite, filters: &[String]) -> Result<Vec<String>, CannotAsk> {
        let names = suite.select(filters)?.fixtures;
        if names.is_empty() {
            return Err(CannotAsk("expected a fixture, found only goldens without one".to_owned()));
        }
        Ok(names)
    }

    /// Writes a file that the user named, but none of the suite's own.
    ///
    /// # Errors
    /// It lies among fixtures, goldens or artifacts, or cannot be written.
    pub fn write(&self, path: &Path, bytes: &[u8]) -> Result<(), CannotAsk> {
        self.may_write(path)?;
        Ok(store::write(path, bytes)?)
    }

    /// Refuses a file that [`Here::write`] would refuse.
    ///
    /// # Errors
    /// It lies among fixtures, goldens, adapters or artifacts, or what is there is no file.
    pub fn may_write(&self, path: &Path) -> Result<(), CannotAsk> {
        if let Ok(suite) = self.suite() {
            // What is in the artifacts' folder is gone with the next check.
            for folder in
                ["fixtures", "golden", "adapters", Suite::ARTIFACTS, Suite::CONFORM, Suite::CACHE]
            {
                if store::is_inside(path, &suite.root().join(folder)) {
                    let what = format!("expected a place outside of the suite's {folder}/");
                    return Err(CannotAsk::file(path, &what));
                }
            }
        }
        Ok(store::check_place(path)?)
    }

    /// Refuses a file for what a machine reads that [`Here::write`] would refuse, or that
    /// is there already and was written by hand: a scene, an adapter or a rubric.
    ///
    /// # Errors
    /// See [`Here::may_write`]; a file that is there and ends in `.ron`.
    pub fn may_report(&self, path: &Path) -> Result<(), CannotAsk> {
        self.may_write(path)?;
        let is_ron = path.extension().is_some_and(|end| end.eq_ignore_ascii_case("ron"));
        if is_ron && store::is_file(path) {
            let what = "is there, and may be a scene, an adapter or a rubric: name another file";
            return Err(CannotAsk::file(path, what));
        }
        Ok(())
    }

    /// How paths and commands are to be written so that they work here.
    pub fn reader(&self, suite: &Suite) -> Reader {
        let in_suite = std::env::current_dir().is_ok_and(|here| here == suite.root());
        let root_flag = self
            .root
            .as_ref()
            .map(|root| format!(" --root {}", shell_word(&root.display().to_string())));
        Reader {
            // Joining nothing ends the path in one slash.
            path_prefix: if in_suite {
                String::new()
            } else {
                suite.root().join("").display().to_string()
            },
            root_flag: root_flag.unwrap_or_default(),
        }
    }
}
