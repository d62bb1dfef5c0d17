//! `calibrate`: how far pictures are apart that should be the same.

use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::Stdio;

use harness::calibrate::{self, Record, Report, Spread, this_build};
use harness::run::render_fixture;
use harness::store;
use harness::suite::Suite;
use harness::{golden, metric};

use crate::progress::Progress;
use crate::{Answer, CannotAsk, Here};

use super::elsewhere::{Program, status};

/// Flags of `calibrate`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Args {
    /// Which fixtures; all if none is given
    #[arg(value_name = "FILTER")]
    filters: Vec<String>,
    /// How often each picture is made in each way
    #[arg(long, value_name = "COUNT", default_value = "2", value_parser = clap::value_parser!(u32).range(1..=100))]
    repeats: u32,
    /// Also write everything to this file as JSON
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
    /// Leave out the build of the other profile, dev or release
    #[arg(long)]
    this_build: bool,
}

const EXAMPLES: &str = "\
Examples:
  cargo xtask calibrate                 every way on this machine, both builds
  cargo xtask calibrate torus --this-build --json c.json";

/// What the other build writes, relative to the suite; not among what `check`
/// leaves behind, as that is still of use.
const ARTIFACTS: &str = "target/goldray-calibrate";

/// The largest report or picture of the other build that is read, in bytes.
const MAX_BYTES: u64 = 256 << 20;

pub(crate) fn run(here: &Here, args: &Args) -> Result<Answer, CannotAsk> {
    if let Some(path) = &args.json {
        here.may_report(path)?;
    }
    let suite = here.suite()?;
    let names = Here::fixtures(&suite, &args.filters)?;
    let progress = Progress::start("calibrating", names.len());
    let mine = calibrate::calibrate(&suite, &names, args.repeats, &|name| progress.advance(name));
    progress.finish();
    let mut builds = vec![mine.map_err(CannotAsk)?];
    let other =
        Other { suite: &suite, profile: if this_build() == "dev" { "release" } else { "dev" } };
    if !args.this_build {
        builds.push(other.record(&names, args.repeats)?);
    }
    let between = |name: &str| other.spread_from_mine(name).map_err(|CannotAsk(why)| why);
    let report = Report::new(builds, &between).map_err(CannotAsk)?;

    print!("{}", report.text());
    if let Some(path) = &args.json {
        let json = serde_json::to_string_pretty(&report)?;
        here.write(path, format!("{json}\n").as_bytes())?;
    }
    Ok(if report.surprises().next().is_none() { Answer::Yes } else { Answer::No })
}

/// The build of the other profile, which is asked as a program of its own.
struct Other<'a> {
    suite: &'a Suite,
    profile: &'static str,
}

impl Other<'_> {
    /// What it finds of these fixtures.
    fn record(&self, names: &[String], repeats: u32) -> Result<Record, CannotAsk> {
        store::empty_artifacts(&self.suite.root().join(ARTIFACTS))?;
        let file = self.artifact("report.json");
        let repeats = repeats.to_string();
        let flags = ["calibrate", "--this-build", "--repeats", &repeats, "--json"];
        let args = flags.map(OsString::from).into_iter().chain([file.clone().into()]);
        let bytes = self.run(args.chain(names.iter().map(OsString::from)).collect(), &file)?;
        let report: Report = serde_json::from_slice(&bytes)?;
        let record = report.builds.into_iter().next();
        record.ok_or_else(|| CannotAsk::file(&file, "expected what one build found"))
    }

    /// How far its picture is from this build's.
    fn spread_from_mine(&self, name: &str) -> Result<Spread, CannotAsk> {
        let file = self.artifact(&format!("{name}.png"));
        let args = ["render".into(), name.into(), "--out".into(), file.clone().into()];
        let bytes = self.run(args.into(), &file)?;
        let theirs = golden::from_png(&bytes).map_err(|why| CannotAsk::file(&file, &why))?;
        let (_, mine) = render_fixture(self.suite, name).map_err(CannotAsk)?;
        let mut spread = Spread { other_bits: 1, ..Spread::default() };
        let comparison = metric::compare(&mine.encoded, &theirs.picture);
        spread.join(&Spread::of(comparison.as_ref()));
        Ok(spread)
    }

    /// Runs it, and reads the file that it writes.
    fn run(&self, args: Vec<OsString>, file: &Path) -> Result<Vec<u8>, CannotAsk> {
        let root = ["--root".into(), self.suite.root().canonicalize()?.into()];
        let args: Vec<OsString> = root.into_iter().chain(args).collect();
        if store::is_file(file) {
            store::remove(file)?;
        }
        eprintln!("asking the {} build", self.profile);
        let mut command = Program::this_in(self.profile).command("calibrate", &args)?;
        // Its answer is in what it writes, and is told with this build's.
        let status = status(command.stdout(Stdio::null()))?;
        let bytes = store::read(file, MAX_BYTES)?;
        bytes.ok_or_else(|| CannotAsk(format!("the {} build ended with {status}", self.profile)))
    }

    fn artifact(&self, name: &str) -> PathBuf {
        self.suite.root().join(ARTIFACTS).join(name)
    }
}
