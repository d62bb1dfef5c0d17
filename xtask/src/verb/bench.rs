//! `bench`: what is measured on this machine, as nothing else of goldray is.

use std::collections::BTreeSet;
use std::path::PathBuf;

use harness::{counts, filter};
use stress::bench::{self, Effort};

use crate::progress::Progress;
use crate::{Answer, CannotAsk, Here};

/// What `bench` measures.
#[derive(Debug, clap::Subcommand)]
pub(crate) enum Bench {
    /// Time against error: every kernel and precision on the same rays, in half a minute
    Error(ErrorArgs),
    /// Rays and tests of every fixture, counted with skipping and without
    Skipping(SkippingArgs),
}

/// Flags of `bench skipping`.
#[derive(Debug, clap::Args)]
pub(crate) struct SkippingArgs {
    /// Which fixtures; all if none is given
    #[arg(value_name = "FILTER")]
    filters: Vec<String>,
    /// Also write the numbers as JSON
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
}

/// Flags of `bench error`.
#[derive(Debug, clap::Args)]
pub(crate) struct ErrorArgs {
    /// Which families, by PRIMITIVE/FAMILY; all if none is given
    #[arg(value_name = "FILTER")]
    filters: Vec<String>,
    /// Only list the families
    #[arg(long)]
    list: bool,
    /// Also write the numbers as JSON
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
    /// Also draw time against error, a panel for each family
    #[arg(long, value_name = "FILE")]
    svg: Option<PathBuf>,
}

pub(crate) fn run(here: &Here, bench: &Bench) -> Result<Answer, CannotAsk> {
    match bench {
        Bench::Error(args) => error(here, args),
        Bench::Skipping(args) => skipping(here, args),
    }
}

fn skipping(
    here: &Here,
    SkippingArgs { filters, json }: &SkippingArgs,
) -> Result<Answer, CannotAsk> {
    if let Some(path) = json {
        here.may_write(path)?;
    }
    let suite = here.suite()?;
    let names = suite.select(filters)?.fixtures;
    let progress = Progress::start("rendering", names.len());
    let rows = counts::with_and_without(&suite, &names, &|name| progress.advance(name));
    progress.finish();
    let rows = rows.map_err(CannotAsk)?;
    let table = counts::Table { schema: 1, rows };
    if let Some(path) = json {
        let text = serde_json::to_string_pretty(&table)?;
        here.write(path, format!("{text}\n").as_bytes())?;
    }
    print!("{}", counts::text(&table.rows));
    let differing: Vec<_> = table.rows.iter().filter(|row| !row.same_bits).collect();
    for row in &differing {
        println!("other bits without skipping: {}", row.scene);
    }
    Ok(if differing.is_empty() { Answer::Yes } else { Answer::No })
}

fn error(
    here: &Here,
    ErrorArgs { filters, list, json, svg }: &ErrorArgs,
) -> Result<Answer, CannotAsk> {
    let labels: BTreeSet<_> = bench::labels().into_iter().collect();
    let filters: Vec<_> = filters.iter().map(String::as_str).collect();
    let chosen = match filter::select(&labels, &filters, "cargo xtask bench error --list")? {
        none if none.is_empty() => labels,
        some => some,
    };
    if *list {
        for label in &chosen {
            println!("{label}");
        }
        return Ok(Answer::Yes);
    }
    for path in [json, svg].into_iter().flatten() {
        here.may_write(path)?;
    }
    let mut begun = 0;
    let report = bench::run(
        |label| chosen.contains(label),
        &Effort::USUAL,
        |label| {
            begun += 1;
            eprintln!("measuring {label} ({begun} of {})", chosen.len());
        },
    );
    if let Some(path) = json {
        let text = serde_json::to_string_pretty(&report)?;
        here.write(path, format!("{text}\n").as_bytes())?;
    }
    if let Some(path) = svg {
        here.write(path, bench::svg(&report).as_bytes())?;
    }
    print!("{}", bench::text(&report));
    Ok(Answer::Yes)
}
