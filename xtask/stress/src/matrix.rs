//! `stress`: hold the tracer's answers against the exact oracle.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use harness::{filter, store};
use stress::kept::{self, Kept};
use stress::matrix::{Matrix, Plan};
use stress::{Family, table};
use xtask::progress::CaseProgress;
use xtask::{Answer, CannotAsk, Here};

/// Flags of `stress`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Args {
    /// Which families, by PRIMITIVE/FAMILY; all if none is given
    #[arg(value_name = "FILTER")]
    filters: Vec<String>,
    /// Run many more cases of each, up to 1e9, which takes hours; a run that was stopped is taken up
    /// again by the same program
    #[arg(long)]
    full: bool,
    /// What the random numbers start from
    #[arg(long, value_name = "N", default_value_t = SEED)]
    seed: u64,
    /// Only list the families, with how many cases each has
    #[arg(long)]
    list: bool,
    /// With --full: run nothing, only show the numbers of what has been run
    #[arg(long, requires = "full")]
    so_far: bool,
    /// Also write every number to this file as JSON
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
}

const EXAMPLES: &str = "\
Examples:
  cargo xtask stress                    every family, in under a minute
  cargo xtask stress torus              those with \"torus\" in their name";

/// The year of the lecture.
const SEED: u64 = 2011;

/// Where cases that once failed are kept, in the suite's folder.
const KEPT: &str = "tests/kept-cases.txt";

/// The largest file of kept cases or of a stopped run that is read.
const MAX_BYTES: u64 = 1 << 26;

/// How much of a full run may be lost when it is stopped.
const STORE_EVERY: Duration = Duration::from_secs(20);

pub(crate) fn run(here: &Here, args: &Args) -> Result<Answer, CannotAsk> {
    let all = stress::subject::all();
    let labels: BTreeSet<_> = all.iter().map(Family::label).collect();
    let filters: Vec<_> = args.filters.iter().map(String::as_str).collect();
    let chosen = filter::select(&labels, &filters, "cargo xtask stress --list")?;
    let is_chosen = |family: &Family| chosen.is_empty() || chosen.contains(&family.label());
    let families: Vec<_> = all.into_iter().filter(is_chosen).collect();
    if args.list {
        println!("{:<44} {:>10} {:>14}", "family", "cases", "with --full");
        for family in &families {
            let cases = family.volume;
            println!("{:<44} {:>10} {:>14}", family.label(), cases.quick, cases.full);
        }
        return Ok(Answer::Yes);
    }

    // Before hours of work.
    if let Some(path) = &args.json {
        here.may_write(path)?;
    }
    let suite = here.suite()?;
    let started = Instant::now();
    let kept_path = suite.root().join(KEPT);
    let kept = read_kept(&kept_path, &labels)?;
    let (replayed, broken) = replay(&kept, &families);
    for kept in &broken {
        println!("FAIL once more, a kept case: {}", shown(kept, &families));
    }
    let plan = Plan { full: args.full, seed: args.seed, program: store::program_hash()? };
    let mut matrix = Matrix::new(&families, plan);
    let state = suite.root().join(format!("target/stress/full-{}.json", args.seed));
    if args.so_far {
        resume(&mut matrix, &state)?;
    } else {
        advance(&mut matrix, args.full.then_some(&*state))?;
    }

    let rows: Vec<_> = matrix.results().flat_map(|(f, tallies)| table::rows(f, tallies)).collect();
    let is_held = |row: &&table::Row| row.contract && row.target.is_some();
    let held = rows.iter().filter(is_held).count();
    let missed = rows.iter().filter(is_held).filter(|row| !row.pass).count();
    // What must not be lost is written before anything is printed.
    let text = table::text(&rows);
    let unseen = keep(&kept_path, &kept, &matrix.offenders())?;
    if let Some(path) = &args.json {
        let table = table::Table { schema: 1, seed: args.seed, full: args.full, rows };
        here.write(path, serde_json::to_string_pretty(&table)?.as_bytes())?;
    }
    print!("{text}");
    for case in &unseen.cases {
        println!("failing case: {}", shown(case, &families));
    }
    if unseen.is_written {
        println!(
            "kept in {}, and judged again by every run: commit them with the fix, or take them \
             out if the code was broken on purpose",
            kept_path.display()
        );
    }
    println!(
        "{} cases of {} families from seed {}, {replayed} kept ones: {missed} of {held} targets missed \
         ({:.1} s); docs/accuracy.md says what the numbers are",
        matrix.done(),
        families.len(),
        args.seed,
        started.elapsed().as_secs_f64()
    );
    Ok(if missed == 0 && broken.is_empty() { Answer::Yes } else { Answer::No })
}

/// Runs all that is left to run. With a path, the run is taken up from there
/// and stored there as it goes on.
fn advance(matrix: &mut Matrix<'_>, state: Option<&Path>) -> Result<(), CannotAsk> {
    if let Some(path) = state {
        resume(matrix, path)?;
    }
    let mut progress = CaseProgress::start(matrix.done(), matrix.total());
    let mut stored = Instant::now();
    while let Some(family) = matrix.advance() {
        progress.reach(matrix.done(), &family);
        if let Some(path) = state
            && stored.elapsed() > STORE_EVERY
        {
            store::write(path, &serde_json::to_vec(&matrix.to_stored())?)?;
            stored = Instant::now();
        }
    }
    progress.finish();
    if let Some(path) = state {
        store::write(path, &serde_json::to_vec(&matrix.to_stored())?)?;
    }
    Ok(())
}

/// Takes up a stored run, if it is of this program.
fn resume(matrix: &mut Matrix<'_>, path: &Path) -> Result<(), CannotAsk> {
    let Some(bytes) = store::read(path, MAX_BYTES)? else { return Ok(()) };
    // A file of another program or form is of no use, and will be replaced.
    if serde_json::from_slice(&bytes).is_ok_and(|stored| matrix.resume(&stored)) {
        eprintln!("{} of {} cases were done before", matrix.done(), matrix.total());
    } else {
        eprintln!("{}: of another program, starting over", path.display());
    }
    Ok(())
}

fn read_kept(path: &Path, labels: &BTreeSet<String>) -> Result<Vec<Kept>, CannotAsk> {
    let bytes = store::read(path, MAX_BYTES)?.unwrap_or_default();
    let text = String::from_utf8_lossy(&bytes);
    let kept = kept::read(&text).map_err(|why| CannotAsk::file(path, &why))?;
    match kept.iter().find(|kept| !labels.contains(&kept.family)) {
        None => Ok(kept),
        Some(Kept { family, .. }) => {
            let what = format!(
                "expected families that `cargo xtask stress --list` shows, found \"{family}\""
            );
            Err(CannotAsk::file(path, &what))
        }
    }
}

/// Judges the kept cases of these families: how many there are, and which fail.
fn replay<'a>(kept: &'a [Kept], families: &[Family]) -> (usize, Vec<&'a Kept>) {
    let mut count = 0;
    let mut broken = Vec::new();
    for kept in kept {
        if let Some(family) = families.iter().find(|family| family.label() == kept.family) {
            count += 1;
            if family.offends(&kept.case) {
                broken.push(kept);
            }
        }
    }
    (count, broken)
}

/// Failing cases that were not kept before.
struct Unseen {
    cases: Vec<Kept>,
    /// Whether they are kept now.
    is_written: bool,
}

/// Adds the first failing case of each family to those that are kept, unless
/// nothing is to be written.
fn keep(path: &Path, kept: &[Kept], offenders: &[Kept]) -> Result<Unseen, CannotAsk> {
    // Compared as text: a NaN is not equal to itself.
    let mut seen: BTreeSet<_> = kept.iter().map(Kept::line).collect();
    let mut families = BTreeSet::new();
    let first = |case: &&Kept| families.insert(case.family.clone());
    let unseen = offenders.iter().filter(first).filter(|case| seen.insert(case.line()));
    let cases: Vec<_> = unseen.cloned().collect();
    let is_written = !cases.is_empty() && std::env::var_os("CI").is_none();
    if is_written {
        let mut bytes = store::read(path, MAX_BYTES)?.unwrap_or_default();
        for case in &cases {
            bytes.extend(case.line().bytes().chain([b'\n']));
        }
        store::write(path, &bytes)?;
    }
    Ok(Unseen { cases, is_written })
}

/// A case with what it was found to be.
fn shown(kept: &Kept, families: &[Family]) -> String {
    let family = families.iter().find(|family| family.label() == kept.family);
    let misses = family.map(|family| table::misses(family, &kept.case)).unwrap_or_default();
    format!("{}: {misses}\n    {}", kept.family, kept.line())
}
