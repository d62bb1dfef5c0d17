//! `instructions`: how many instructions fixed work takes, held against a
//! committed baseline.
//!
//! A clock on a shared machine moves by tens of percent; a count of
//! instructions does not. It says nothing of caches and branches: it is there
//! to see that a path does more than it did, not how fast it is.

mod baseline;
mod callgrind;
pub(crate) mod work;

use std::path::PathBuf;
use std::process::ExitCode;

use baseline::{Baseline, judge, table};

use crate::{machine, place};

/// The committed counts, in the repository.
const BASELINE: &str = "crates/bench/baseline.json";

/// The exit code where this machine cannot be asked: it says nothing of the code.
const NOT_ASKED: u8 = 3;

/// Flags of `bench instructions`.
#[derive(Debug, clap::Args)]
pub(crate) struct Args {
    /// Rewrite the baseline with the counts of this run
    #[arg(long)]
    write: bool,
    /// The baseline [default: crates/bench/baseline.json of this repository]
    #[arg(long, value_name = "FILE")]
    baseline: Option<PathBuf>,
}

/// Flags of `bench work`.
#[derive(Debug, clap::Args)]
pub(crate) struct WorkArgs {
    /// Which work; lists all if none is given
    #[arg(value_name = "NAME")]
    name: Option<String>,
}

pub(crate) fn run(args: &Args) -> Result<ExitCode, String> {
    let path = match &args.baseline {
        Some(path) => path.clone(),
        None => place::repository()?.join(BASELINE),
    };
    let old = place::text(&path)?.map(|text| Baseline::read(&path, &text)).transpose()?;
    if old.is_none() && !args.write {
        return Err(format!(
            "{}: expected a baseline, found no file; write one with --write",
            path.display()
        ));
    }
    let (counts, levels) = callgrind::count_all()?;
    if args.write {
        let tolerance = old.map_or(baseline::TOLERANCE, |old| old.tolerance);
        let rustc = machine::rustc();
        let written = Baseline { schema: 1, tolerance, levels, rustc, instructions: counts };
        place::write_json(&path, &written)?;
        println!("wrote {}: {} counts", path.display(), written.instructions.len());
        return Ok(ExitCode::SUCCESS);
    }
    let Some(old) = old else { return Ok(ExitCode::SUCCESS) };
    if old.levels != levels {
        eprintln!(
            "{}: expected a processor with {}, found one with {}: it runs other code, so the \
             counts cannot be compared",
            path.display(),
            old.levels.join(", "),
            levels.join(", ")
        );
        return Ok(ExitCode::from(NOT_ASKED));
    }
    let rows = judge(&old, &counts);
    print!("{}", table(&rows, old.tolerance));
    if old.rustc != machine::rustc() {
        println!("the baseline was written by {}, this is {}", old.rustc, machine::rustc());
    }
    if rows.iter().any(|row| row.verdict.is_bad()) {
        println!("if that is meant: cargo xtask bench instructions --write");
        return Ok(ExitCode::from(1));
    }
    Ok(ExitCode::SUCCESS)
}

/// Does one work, so that whoever watches can count.
pub(crate) fn run_work(args: &WorkArgs) -> Result<ExitCode, String> {
    let Some(name) = &args.name else {
        for work in work::ALL {
            println!("{:<16} {}", work.name, work.what);
        }
        return Ok(ExitCode::SUCCESS);
    };
    work::do_once(name)?;
    // Asked here, as valgrind gives the program another processor than there is.
    println!("{}", machine::levels().join(" "));
    Ok(ExitCode::SUCCESS)
}
