//! `cli`: goldray's command line. Flags in, exit code out.
//!
//! Exit codes are part of the interface: 0 is "all match" or "done", 1 is "no"
//! (a verdict other than match, pictures that differ, something refused), 2 is
//! "could not ask" (usage, nothing selected, input that cannot be read).

use std::path::PathBuf;
use std::process::ExitCode;

use clap::{Command, CommandFactory, FromArgMatches, Parser, Subcommand};
use harness::called;

use crate::{Here, end_where_nothing_can_be_printed, exit_code, verb};

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
  cargo xtask review                  look at what does not match, and accept or reject it
  cargo xtask bless sphere/tangent    accept today's picture of one fixture";

#[derive(Debug, Subcommand)]
enum Verb {
    /// Render fixtures and judge each against its golden
    Check(verb::check::Args),
    /// Accept today's pictures as goldens, where they are not a match
    Bless(verb::bless::Args),
    /// Look at what does not match, in a browser or the terminal, and accept or reject it
    Review(verb::review::Args),
    /// Check anew whenever a fixture, a golden or the renderer is edited
    Watch(verb::watch::Args),
    /// Write a small valid fixture to start from
    New(verb::new::Args),
    /// Make a small fixture of a large one that fails
    Minimize(verb::minimize::Args),
    /// List fixtures, or the metrics and what each cannot see
    List(verb::list::Args),
    /// Render a scene file or a fixture into a picture file
    Render(verb::render::Args),
    /// Read scenes of other programs and write them as scene files
    Import(verb::import::Args),
    /// Compare two picture files by every metric
    Compare(verb::compare::Args),
    /// Render the suite by another renderer, and judge its pictures
    Conform(verb::conform::Args),
    /// Give points for what a renderer gets right, by a rubric
    Grade(verb::grade::Args),
    /// Draw all goldens on one sheet
    ContactSheet(verb::contact_sheet::Args),
    /// Make the meshes that the fixtures use
    #[command(after_help = verb::meshes::EXAMPLES)]
    Meshes,
    /// Measure on this machine
    #[command(subcommand, after_help = verb::bench::EXAMPLES)]
    Bench(verb::bench::Bench),
    /// Print or check the bits of every picture, which no target may change
    Digest(verb::digest::Args),
    /// Seed mistakes into the renderer, one by one, and say which the suite notices
    #[command(disable_help_flag = true)]
    Faults(verb::elsewhere::Passed),
    /// Find the smallest damage that each fixture would notice
    Sensitivity(verb::sensitivity::Args),
    /// Find fixtures that would match where they should not
    Lint(verb::lint::Args),
    /// Measure how far pictures are apart that should be the same
    Calibrate(verb::calibrate::Args),
    /// Hold the tracer's answers against the exact oracle
    #[command(disable_help_flag = true)]
    Stress(verb::elsewhere::Passed),
    /// Print what a shell needs to complete command lines
    Completions(verb::completions::Args),
}

/// `cargo xtask`, in goldray's repository: every verb.
pub fn in_repository() -> ExitCode {
    run(Cli::command())
}

/// What only goldray's own repository has something to ask of.
const OF_THE_REPOSITORY: [&str; 4] = ["bench", "faults", "meshes", "stress"];

/// `goldray`, installed: the same verbs for any folder with fixtures and goldens.
/// Those that are about goldray itself are not listed, and say where they work.
pub fn installed() -> ExitCode {
    called::call("goldray");
    let mut command = called_otherwise(Cli::command()).bin_name(called::command());
    for verb in OF_THE_REPOSITORY {
        command = command.mut_subcommand(verb, |verb| verb.hide(true));
    }
    let completions = |verb: Command| verb.after_help(verb::completions::INSTALLED);
    run(command.mut_subcommand("completions", completions))
}

/// The same with other examples: they name the program.
fn called_otherwise(command: Command) -> Command {
    let after = command.get_after_help().map(ToString::to_string);
    let command = match after {
        Some(after) => command.after_help(after.replace("cargo xtask", called::command())),
        None => command,
    };
    command.mut_subcommands(called_otherwise)
}

fn run(command: Command) -> ExitCode {
    end_where_nothing_can_be_printed();
    let cli = Cli::from_arg_matches(&command.clone().get_matches());
    let cli = cli.unwrap_or_else(|error| error.exit());
    let here = Here { root: cli.root };
    let answer = match cli.verb {
        Verb::Check(args) => verb::check::run(&here, &args),
        Verb::Bless(args) => verb::bless::run(&here, &args),
        Verb::Review(args) => verb::review::run(&here, &args),
        Verb::Watch(args) => verb::watch::run(&here, &args),
        Verb::New(args) => verb::new::run(&here, &args),
        Verb::Minimize(args) => verb::minimize::run(&here, &args),
        Verb::List(args) => verb::list::run(&here, &args),
        Verb::Render(args) => verb::render::run(&here, &args),
        Verb::Import(args) => verb::import::run(&here, &args),
        Verb::Compare(args) => verb::compare::run(&args),
        Verb::Conform(args) => verb::conform::run_verb(&here, &args),
        Verb::Grade(args) => verb::grade::run(&here, &args),
        Verb::ContactSheet(args) => verb::contact_sheet::run(&here, &args),
        Verb::Meshes => verb::meshes::run(&here),
        Verb::Bench(bench) => verb::bench::run(&here, &bench),
        Verb::Digest(args) => verb::digest::run(&here, &args),
        Verb::Faults(args) => verb::elsewhere::faults(&here, &args),
        Verb::Sensitivity(args) => verb::sensitivity::run(&here, &args),
        Verb::Lint(args) => verb::lint::run(&here, &args),
        Verb::Calibrate(args) => verb::calibrate::run(&here, &args),
        Verb::Stress(args) => verb::elsewhere::stress(&here, &["stress"], &args),
        Verb::Completions(args) => Ok(verb::completions::run(command, &args)),
    };
    exit_code(answer)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Asks it of every verb that is not another program's.
    fn check(command: &clap::Command, path: &str) {
        let path = format!("{path} {}", command.get_name());
        let help = command.clone().render_long_help().to_string();
        assert!(help.contains("\nExamples:\n  "), "{path} --help has no examples:\n{help}");
        let verbs = command.get_subcommands().filter(|verb| !verb.is_disable_help_flag_set());
        verbs.filter(|verb| verb.get_name() != "help").for_each(|verb| check(verb, &path));
    }

    #[test]
    fn the_help_of_every_verb_has_examples() {
        Cli::command().debug_assert();
        check(&Cli::command(), "");
    }
}
