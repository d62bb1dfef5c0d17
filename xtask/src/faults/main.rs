//! `cargo xtask faults`: which seeded faults the suite notices.
//!
//! A program of its own, because its renderer can be wrong on purpose. It starts
//! itself anew for each fault, so that one that never ends or takes the process
//! with it is known as such.

mod trials;

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::Parser;
use harness::faults::{Fall, Fault, Matrix};
use harness::faults::{
    falls, json, markdown, not_matching, read_floor, text, try_fault, write_floor,
};
use harness::filter;
use harness::store;
use harness::suite::Suite;
use xtask::{Answer, CannotAsk, Here, end_where_nothing_can_be_printed, exit_code};

/// Seed mistakes into the renderer, one by one, and say which the suite notices.
#[derive(Debug, Parser)]
#[command(name = "faults", bin_name = "cargo xtask faults", max_term_width = 100)]
#[command(after_help = AFTER_HELP)]
struct Cli {
    /// Which fixtures; all if none is given
    #[arg(value_name = "FILTER")]
    filters: Vec<String>,
    /// The suite: a folder with `fixtures/` and `golden/` [default: the nearest one from here up]
    #[arg(long, value_name = "DIR")]
    root: Option<PathBuf>,
    /// Only these faults: a name, a part of it, or a pattern
    #[arg(long = "fault", value_name = "FAULT")]
    faults: Vec<String>,
    /// Also write the matrix to this file as JSON
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
    /// Also write the matrix to this file as a page
    #[arg(long, value_name = "FILE", conflicts_with_all = ["filters", "faults", "list"])]
    markdown: Option<PathBuf>,
    /// Hold the page in this file against today's
    #[arg(long, value_name = "FILE", conflicts_with_all = ["filters", "faults", "list"])]
    check: Option<PathBuf>,
    /// List the faults and what each does, and try none
    #[arg(long)]
    list: bool,
    /// Write how many fixtures notice each fault to golden/faults.txt
    #[arg(long, conflicts_with_all = ["filters", "faults", "list"])]
    write: bool,
    /// How long one fixture may take, in seconds
    #[arg(long, value_name = "SECONDS", default_value_t = 30)]
    patience: u32,
    /// Try this fault here, and print a line of JSON for each fixture
    #[arg(long, value_name = "FAULT", hide = true)]
    trial: Option<String>,
}

const AFTER_HELP: &str = "\
A fault is noticed if a fixture fails with it; the table says reached for fixtures that need its
place, and killed for those that notice. With every fixture and every fault, at least two
fixtures must notice each, one of them by an expectation or a relation and not by its golden alone;
and no other number than golden/faults.txt says.
Exit codes: 0 all noticed, 1 one is not, or by fewer, 2 could not ask.

Examples:
  cargo xtask faults                            every fault by every fixture
  cargo xtask faults --list                     what each does
  cargo xtask faults torus --fault normal       some by some";

fn main() -> ExitCode {
    end_where_nothing_can_be_printed();
    let cli = Cli::parse();
    exit_code(run(&cli))
}

fn run(cli: &Cli) -> Result<Answer, CannotAsk> {
    let chosen = chosen(&cli.faults)?;
    if cli.list {
        for fault in chosen {
            println!("{}: {}", fault.name(), fault.words());
        }
        return Ok(Answer::Yes);
    }
    let here = Here { root: cli.root.clone() };
    let suite = here.suite()?;
    let names = Here::fixtures(&suite, &cli.filters)?;
    if let Some(name) = &cli.trial {
        return trial(&suite, &names, name);
    }
    if cli.write && std::env::var_os("CI").is_some() {
        let what = "faults --write: expected to run by hand, found the variable CI set";
        return Err(CannotAsk(what.to_owned()));
    }
    for path in cli.json.iter().chain(&cli.markdown) {
        here.may_report(path)?;
    }
    let others = not_matching(&suite, &names);
    if !others.is_empty() {
        return Err(CannotAsk(format!(
            "expected fixtures that match without a fault, found {} that do not: {}: run `cargo \
             xtask check` first",
            others.len(),
            others.join(", ")
        )));
    }
    let matrix = trials::of_all(&suite, &names, &chosen, cli.patience)?;
    print!("{}", text(&matrix));
    if let Some(path) = &cli.json {
        here.write(path, serde_json::to_string_pretty(&json(&matrix))?.as_bytes())?;
    }
    if let Some(path) = &cli.markdown {
        here.write(path, markdown(&matrix).as_bytes())?;
    }
    if cli.write {
        write_floor(&suite, &matrix.kills())?;
    }
    let is_whole = cli.filters.is_empty() && cli.faults.is_empty();
    let answer = answer(&suite, &matrix, is_whole)?;
    Ok(match &cli.check {
        Some(page) if !is_todays(page, &matrix)? => {
            let page = page.display();
            println!("{page} is not today's: cargo xtask faults --markdown {page}");
            Answer::No
        }
        _ => answer,
    })
}

/// Whether everything is noticed that should be; says what is not.
fn answer(suite: &Suite, matrix: &Matrix, is_whole: bool) -> Result<Answer, CannotAsk> {
    let kills = matrix.kills();
    if !is_whole {
        let all_are_killed = kills.values().all(|kills| kills.all > 0);
        return Ok(if all_are_killed { Answer::Yes } else { Answer::No });
    }
    // A suite without a table has no counts that could fall.
    let floor = read_floor(suite)?.unwrap_or_else(|| kills.clone());
    let falls = falls(&floor, &kills);
    for fall in &falls {
        println!("{fall}");
    }
    if falls.iter().any(|fall| !matches!(fall, Fall::TooFew { .. })) {
        println!("if meant: cargo xtask faults --write --markdown docs/faults.md");
    }
    Ok(if falls.is_empty() { Answer::Yes } else { Answer::No })
}

/// Whether this is the page of today.
fn is_todays(page: &Path, matrix: &Matrix) -> Result<bool, CannotAsk> {
    /// Far above the page of any number of faults.
    const MAX_BYTES: u64 = 1 << 24;
    let found = store::read(page, MAX_BYTES)?;
    let found = found.ok_or_else(|| CannotAsk::file(page, "there is no such file"))?;
    Ok(found == markdown(matrix).into_bytes())
}

/// The faults that are asked for; all if none is.
fn chosen(filters: &[String]) -> Result<Vec<Fault>, CannotAsk> {
    if filters.is_empty() {
        return Ok(Fault::ALL.to_vec());
    }
    let names = Fault::ALL.iter().map(|fault| fault.name()).collect();
    let filters: Vec<_> = filters.iter().map(String::as_str).collect();
    let selected = filter::select(&names, &filters, "cargo xtask faults --list")?;
    let is_selected = |fault: &&Fault| selected.contains(&fault.name());
    Ok(Fault::ALL.iter().filter(is_selected).copied().collect())
}

/// Tries one fault in this process.
fn trial(suite: &Suite, names: &[String], fault: &str) -> Result<Answer, CannotAsk> {
    let [fault] = chosen(&[fault.to_owned()])?[..] else {
        return Err(CannotAsk(format!("expected the name of one fault, found \"{fault}\"")));
    };
    let mut failed = None;
    try_fault(suite, names, fault, &mut |trial| match serde_json::to_string(&trial) {
        Ok(line) => println!("{line}"),
        Err(error) => failed = Some(error),
    });
    failed.map_or(Ok(Answer::Yes), |error| Err(error.into()))
}
