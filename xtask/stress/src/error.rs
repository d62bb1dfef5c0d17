//! `bench error`: time against error, every kernel and precision on the same rays.

use std::collections::BTreeSet;
use std::path::PathBuf;

use harness::filter;
use stress::bench::{self, Effort};
use xtask::{Answer, CannotAsk, Here};

/// Flags of `bench error`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Args {
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

const EXAMPLES: &str = "\
Examples:
  cargo xtask bench error               every kernel, in half a minute
  cargo xtask bench error triangle      those of one primitive";

pub(crate) fn run(
    here: &Here,
    Args { filters, list, json, svg }: &Args,
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
