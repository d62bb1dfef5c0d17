//! `bench`: what is measured on this machine, as nothing else of goldray is.

use std::collections::BTreeSet;
use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::Command;

use harness::{counts, filter, store};
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

/// Flags that `crates/bench` reads, a workspace of its own that is built when
/// it is first asked for.
#[derive(Debug, clap::Args)]
pub(crate) struct Passed {
    /// Flags of its own; --help lists them
    #[arg(trailing_var_arg = true, allow_hyphen_values = true, value_name = "ARGS")]
    args: Vec<OsString>,
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
        Bench::Trace(passed) => pass_on("trace", passed),
        Bench::Image(passed) => pass_on("image", passed),
        Bench::Kernels(passed) => pass_on("kernels", passed),
        Bench::Check(passed) => pass_on("check", passed),
        Bench::Scaling(passed) => pass_on("scaling", passed),
        Bench::Instructions(passed) => pass_on("instructions", passed),
        Bench::Report(passed) => pass_on("report", passed),
        Bench::Peers(passed) => pass_on("peers", passed),
    }
}

/// The crate of the benches, in the repository.
const BENCH_MANIFEST: &str = "crates/bench/Cargo.toml";

/// Builds the crate of the benches and runs one of them, whose exit code is
/// the answer.
fn pass_on(name: &str, Passed { args }: &Passed) -> Result<Answer, CannotAsk> {
    let here = std::env::current_dir()?;
    let mut places = here.ancestors().map(|folder| folder.join(BENCH_MANIFEST));
    let manifest = places.find(|path| store::is_file(path)).ok_or_else(|| {
        let what = format!(
            "expected a folder inside goldray's repository, found no {BENCH_MANIFEST} from here \
             up: go there, then cargo xtask bench {name}"
        );
        CannotAsk::file(&here, &what)
    })?;
    // The cargo that runs this, if one does.
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let status = Command::new(&cargo)
        .args(["run", "--release", "--locked", "--quiet", "--manifest-path"])
        .arg(manifest)
        .args(["--", name])
        .args(args)
        .status()
        .map_err(|error| CannotAsk::file(Path::new(&cargo), &error.to_string()))?;
    Ok(match status.code().and_then(|code| u8::try_from(code).ok()) {
        Some(0) => Answer::Yes,
        Some(code) => Answer::Code(code),
        None => return Err(CannotAsk::file(Path::new("bench"), &format!("ended with {status}"))),
    })
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
