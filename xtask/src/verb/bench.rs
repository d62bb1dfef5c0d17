//! `bench`: what is measured on this machine, as nothing else of goldray is.

use std::path::PathBuf;

use crate::progress::Progress;
use crate::{Answer, CannotAsk, Here};
use harness::counts;

use super::elsewhere::{self, Passed};

/// What `bench` measures.
#[derive(Debug, clap::Subcommand)]
pub(crate) enum Bench {
    /// Time against error: every kernel and precision on the same rays, in half a minute
    #[command(disable_help_flag = true)]
    Error(Passed),
    /// Rays and tests of every fixture, counted with skipping and without
    Skipping(SkippingArgs),
    /// Millions of rays a second through meshes, beside other tracers
    #[command(disable_help_flag = true)]
    Trace(Passed),
    /// Seconds to a picture of a given error, beside other renderers
    #[command(disable_help_flag = true)]
    Image(Passed),
    /// Nanoseconds of each test that a ray is held against
    #[command(disable_help_flag = true)]
    Kernels(Passed),
    /// Fixtures a second of the whole check, and where the time goes
    #[command(disable_help_flag = true)]
    Check(Passed),
    /// Times against primitives, pixels, lights and threads, with their slopes
    #[command(disable_help_flag = true)]
    Scaling(Passed),
    /// Instructions of fixed work, held against the baseline; needs valgrind
    #[command(disable_help_flag = true)]
    Instructions(Passed),
    /// Write docs/performance.md from the JSON files of the others
    #[command(disable_help_flag = true)]
    Report(Passed),
    /// Which other tracers are here, and how to get those that are not
    #[command(disable_help_flag = true)]
    Peers(Passed),
}

/// What the help of `bench` ends with.
pub(crate) const EXAMPLES: &str = "\
Examples:
  cargo xtask bench peers               which other tracers are here
  cargo xtask bench trace --help        the flags of one
  cargo xtask bench skipping torus      what is saved by what is skipped";

const SKIPPING_EXAMPLES: &str = "\
Examples:
  cargo xtask bench skipping                        every fixture
  cargo xtask bench skipping torus --json s.json    some, also for machines";

/// Flags of `bench skipping`.
#[derive(Debug, clap::Args)]
#[command(after_help = SKIPPING_EXAMPLES)]
pub(crate) struct SkippingArgs {
    /// Which fixtures; all if none is given
    #[arg(value_name = "FILTER")]
    filters: Vec<String>,
    /// Also write the numbers as JSON
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
}

pub(crate) fn run(here: &Here, bench: &Bench) -> Result<Answer, CannotAsk> {
    match bench {
        Bench::Error(passed) => elsewhere::stress(here, &["bench", "error"], passed),
        Bench::Skipping(args) => skipping(here, args),
        Bench::Trace(passed) => elsewhere::bench("trace", passed),
        Bench::Image(passed) => elsewhere::bench("image", passed),
        Bench::Kernels(passed) => elsewhere::bench("kernels", passed),
        Bench::Check(passed) => elsewhere::bench("check", passed),
        Bench::Scaling(passed) => elsewhere::bench("scaling", passed),
        Bench::Instructions(passed) => elsewhere::bench("instructions", passed),
        Bench::Report(passed) => elsewhere::bench("report", passed),
        Bench::Peers(passed) => elsewhere::bench("peers", passed),
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
