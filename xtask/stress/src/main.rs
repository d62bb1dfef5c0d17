//! `cargo xtask stress` and `cargo xtask bench error`: the command line of the
//! exact oracle, with the exit codes of `xtask`.

mod error;
mod matrix;

use std::path::PathBuf;
use std::process::ExitCode;

use clap::{Parser, Subcommand};
use xtask::{Here, end_where_nothing_can_be_printed, exit_code};

/// Hold the tracer's answers against the exact oracle.
#[derive(Debug, Parser)]
#[command(name = "goldray", bin_name = "cargo xtask", version, max_term_width = 100)]
struct Cli {
    /// The suite: a folder with `fixtures/` and `golden/` [default: the nearest one from here up]
    #[arg(long, global = true, value_name = "DIR")]
    root: Option<PathBuf>,
    #[command(subcommand)]
    verb: Verb,
}

#[derive(Debug, Subcommand)]
enum Verb {
    /// Hold the tracer's answers against the exact oracle
    Stress(matrix::Args),
    /// Measure on this machine
    #[command(subcommand)]
    Bench(Bench),
}

/// What is measured with the oracle.
#[derive(Debug, Subcommand)]
enum Bench {
    /// Time against error: every kernel and precision on the same rays, in half a minute
    Error(error::Args),
}

fn main() -> ExitCode {
    end_where_nothing_can_be_printed();
    let cli = Cli::parse();
    let here = Here { root: cli.root };
    exit_code(match cli.verb {
        Verb::Stress(args) => matrix::run(&here, &args),
        Verb::Bench(Bench::Error(args)) => error::run(&here, &args),
    })
}
