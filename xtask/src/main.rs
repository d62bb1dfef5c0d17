//! `cargo xtask`: goldray's command line. Flags in, exit code out.
//!
//! Exit codes are part of the interface: 0 is "all match" or "done", 1 is "no"
//! (a verdict other than match, pictures that differ, something refused), 2 is
//! "could not ask" (usage, nothing selected, input that cannot be read).

mod verb;

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::{Parser, Subcommand};
use harness::suite::{Suite, SuiteError};

/// Render fixture scenes and judge them against their golden images.
#[derive(Debug, Parser)]
#[command(name = "cargo xtask", bin_name = "cargo xtask", max_term_width = 100, after_help = AFTER_HELP)]
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
}

/// How a verb ended.
pub(crate) enum Answer {
    /// Exit code 0.
    Yes,
    /// Exit code 1.
    No,
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

fn main() -> ExitCode {
    let cli = Cli::parse();
    let root = cli.root.as_deref();
    let answer = match cli.verb {
        Verb::Check(args) => suite(root).and_then(|suite| verb::check::run(&suite, &args)),
        Verb::Bless(args) => suite(root).and_then(|suite| verb::bless::run(&suite, &args)),
        Verb::New(args) => suite(root).and_then(|suite| verb::new::run(&suite, &args)),
        Verb::List(args) => verb::list::run(|| suite(root), &args),
        Verb::Render(args) => verb::render::run(|| suite(root), &args),
        Verb::Compare(args) => verb::compare::run(&args),
        Verb::ContactSheet(args) => {
            suite(root).and_then(|suite| verb::contact_sheet::run(&suite, &args))
        }
        Verb::Meshes => suite(root).and_then(|suite| verb::meshes::run(&suite)),
    };
    match answer {
        Ok(Answer::Yes) => ExitCode::SUCCESS,
        Ok(Answer::No) => ExitCode::from(1),
        Err(CannotAsk(why)) => {
            eprintln!("error: {}", why.trim_end());
            ExitCode::from(2)
        }
    }
}

/// The suite at `root`, or the nearest one from the current folder up.
fn suite(root: Option<&Path>) -> Result<Suite, CannotAsk> {
    if let Some(root) = root {
        return Ok(Suite::open(root)?);
    }
    let here = std::env::current_dir()?;
    let nearest = here.ancestors().find_map(|folder| Suite::open(folder).ok());
    nearest.ok_or_else(|| SuiteError::NoSuite(here).into())
}
