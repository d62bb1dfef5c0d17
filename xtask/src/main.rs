//! `cargo xtask`: goldray's command line. Flags in, exit code out.
//!
//! Exit codes are part of the interface: 0 is "all match" or "done", 1 is "no"
//! (a verdict other than match, pictures that differ, something refused), 2 is
//! "could not ask" (usage, nothing selected, input that cannot be read).

mod progress;
mod verb;

use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::{Parser, Subcommand};
use harness::report::Reader;
use harness::store;
use harness::suite::{Suite, SuiteError};
use harness::verdict::shell_word;

/// Render fixture scenes and judge them against their golden images.
#[derive(Debug, Parser)]
#[command(name = "goldray", bin_name = "cargo xtask", version)]
#[command(max_term_width = 100, after_help = AFTER_HELP)]
struct Cli {
    /// The suite: a folder with `fixtures/` and `golden/` [default: the nearest one from here up]
    #[arg(long, global = true, value_name = "DIR")]
    root: Option<PathBuf>,
    #[command(subcommand)]
    verb: Verb,
}

const AFTER_HELP: &str = "\
A FILTER is a fixture's whole name, a part of it, or a pattern with * and ?.
Exit codes: 0 all match, 1 something does not, 2 could not ask.

Examples:
  cargo xtask check                   judge every fixture
  cargo xtask check sphere            those with \"sphere\" in their name
  cargo xtask check 'box/from-*'      those that match the pattern
  cargo xtask bless sphere/tangent    accept today's picture of one fixture";

#[derive(Debug, Subcommand)]
enum Verb {
    /// Render fixtures and judge each against its golden
    Check(verb::check::Args),
    /// Accept today's pictures as goldens, where they are not a match
    Bless(verb::bless::Args),
    /// Write a small valid fixture to start from
    New(verb::new::Args),
    /// List fixtures, or the metrics and what each cannot see
    List(verb::list::Args),
    /// Render a scene file or a fixture into a picture file
    Render(verb::render::Args),
    /// Compare two picture files by every metric
    Compare(verb::compare::Args),
    /// Draw all goldens on one sheet
    ContactSheet(verb::contact_sheet::Args),
    /// Make the meshes that the fixtures use
    Meshes,
    /// Measure on this machine
    #[command(subcommand)]
    Bench(verb::bench::Bench),
    /// Print or check the bits of every picture, which no target may change
    Digest(verb::digest::Args),
    /// Hold the tracer's answers against the exact oracle
    Stress(verb::stress::Args),
}

/// How a verb ended.
pub(crate) enum Answer {
    /// Exit code 0.
    Yes,
    /// Exit code 1.
    No,
    /// The exit code of a program that was asked in turn, which has said why.
    Code(u8),
}

/// Why a verb could not do its work; exit code 2.
pub(crate) struct CannotAsk(String);

impl<E: std::error::Error> From<E> for CannotAsk {
    fn from(error: E) -> Self {
        Self(error.to_string())
    }
}

impl CannotAsk {
    /// For a file that is not what it should be.
    pub(crate) fn file(path: &Path, what: &str) -> Self {
        Self(format!("{}: {what}", path.display()))
    }
}

/// A place to print to that is gone or full ends the program, with an error and
/// no panic's message; without any if it was a reader that has seen enough, such
/// as `head`. Never as a success: nobody knows what the rest would have said.
fn end_where_nothing_can_be_printed() {
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

fn main() -> ExitCode {
    end_where_nothing_can_be_printed();
    let cli = Cli::parse();
    let here = Here { root: cli.root };
    let answer = match cli.verb {
        Verb::Check(args) => verb::check::run(&here, &args),
        Verb::Bless(args) => verb::bless::run(&here, &args),
        Verb::New(args) => verb::new::run(&here, &args),
        Verb::List(args) => verb::list::run(&here, &args),
        Verb::Render(args) => verb::render::run(&here, &args),
        Verb::Compare(args) => verb::compare::run(&args),
        Verb::ContactSheet(args) => verb::contact_sheet::run(&here, &args),
        Verb::Meshes => verb::meshes::run(&here),
        Verb::Bench(bench) => verb::bench::run(&here, &bench),
        Verb::Digest(args) => verb::digest::run(&here, &args),
        Verb::Stress(args) => verb::stress::run(&here, &args),
    };
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
pub(crate) struct Here {
    root: Option<PathBuf>,
}

impl Here {
    /// The suite that was named, or the nearest one from the current folder up.
    pub(crate) fn suite(&self) -> Result<Suite, CannotAsk> {
        if let Some(root) = &self.root {
            return Ok(Suite::open(root)?);
        }
        let here = std::env::current_dir()?;
        let nearest = here.ancestors().find_map(|folder| Suite::open(folder).ok());
        nearest.ok_or_else(|| SuiteError::NoSuite(here).into())
    }

    /// Writes a file that the user named, but none of the suite's own.
    pub(crate) fn write(&self, path: &Path, bytes: &[u8]) -> Result<(), CannotAsk> {
        self.may_write(path)?;
        Ok(store::write(path, bytes)?)
    }

    /// Refuses a file that [`Here::write`] would refuse.
    pub(crate) fn may_write(&self, path: &Path) -> Result<(), CannotAsk> {
        if let Ok(suite) = self.suite() {
            for folder in ["fixtures", "golden"] {
                if store::is_inside(path, &suite.root().join(folder)) {
                    let what = format!("expected a place outside of the suite's {folder}/");
                    return Err(CannotAsk::file(path, &what));
                }
            }
        }
        Ok(())
    }

    /// How paths and commands are to be written so that they work here.
    pub(crate) fn reader(&self, suite: &Suite) -> Reader {
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
