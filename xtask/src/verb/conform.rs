//! `conform`: the suite rendered by other renderers, and judged.

mod lines;
mod places;
mod wrong;

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use conform::card;
use conform::run::{Plan, RESULTS, Renderer, Subject, Told, run, subjects};
use conform::{Conformed, Outcome, objects_of, outcome};
use harness::suite::Suite;

use crate::interrupt::Interrupt;
use crate::progress::Progress;
use crate::{Answer, CannotAsk, Here};
use lines::Lines;
pub(crate) use wrong::LeaveOut;

/// Flags of `conform`.
#[derive(Debug, clap::Args)]
#[command(after_help = AFTER_HELP)]
pub(crate) struct Args {
    /// Which fixtures; all if none is given
    #[arg(value_name = "FILTER")]
    filters: Vec<String>,
    /// A renderer: the name of an adapter, or a path to its file; give it again for more
    #[arg(long = "renderer", value_name = "ADAPTER", required = true)]
    renderers: Vec<String>,
    /// Where results and what failures leave behind are put [default: target/goldray-conform]
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Write the results of all renderers as JSON
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
    /// Render so many scenes at a time
    #[arg(long, value_name = "COUNT", default_value = "1", value_parser = clap::value_parser!(u16).range(1..))]
    jobs: u16,
    /// Kill a renderer after so long, in place of what its adapter says
    #[arg(long, value_name = "SECONDS", value_parser = seconds)]
    timeout: Option<Duration>,
}

const AFTER_HELP: &str = "\
An ADAPTER says how a renderer is asked; docs/conform.md has its fields. It runs the program that it
names, as you.
Exit codes: 0 all pass, or are not supported; 1 something does not pass; 2 could not ask.

Examples:
  cargo xtask conform --renderer povray                     all fixtures by POV-Ray
  cargo xtask conform --renderer goldray 'sphere/*'         some, by goldray in another process
  cargo xtask conform --renderer povray --renderer mitsuba  two renderers, one after the other
  cargo xtask conform --renderer mine/adapter.ron --timeout 5 --json results.json";

/// A number of seconds as the flag has it.
pub(crate) fn seconds(text: &str) -> Result<Duration, String> {
    let most = conform::adapter::MAX_TIMEOUT_S;
    let found = text.parse().ok().filter(|found| (0.1..=most).contains(found));
    found
        .map(Duration::from_secs_f64)
        .ok_or_else(|| format!("expected a number from 0.1 to {most}"))
}

pub(crate) fn run_verb(here: &Here, args: &Args) -> Result<Answer, CannotAsk> {
    if let Some(json) = &args.json {
        here.may_report(json)?;
    }
    let outputs: Vec<_> = args.json.iter().cloned().collect();
    let asked = Asked {
        renderers: &args.renderers,
        filters: &args.filters,
        leave_out: LeaveOut::Filters { renderers: &args.renderers, filters: &args.filters },
        out: args.out.as_deref(),
        inputs: &[],
        outputs: &outputs,
        jobs: args.jobs.into(),
        timeout: args.timeout,
    };
    let all = match conformed(here, &asked)? {
        Ran::All(all) => all,
        Ran::Interrupted(answer) => return Ok(answer),
    };
    report(here, args, &all)?;
    let outcomes = all.iter().flat_map(|conformed| conformed.run.fixtures.values());
    let mut outcomes = outcomes.map(|result| result.outcome);
    let asked_nothing = |conformed: &&Conformed| {
        conformed.run.fixtures.values().all(|result| result.outcome == Outcome::Unsupported)
    };
    if let Some(nothing) = all.iter().find(asked_nothing) {
        // Of what was not asked nothing is known, which is no success.
        let name = &nothing.run.renderer.name;
        println!("{name}: nothing was rendered, as all of it is called unsupported");
        return Ok(Answer::No);
    }
    let is_fine = outcomes.all(|outcome| matches!(outcome, Outcome::Pass | Outcome::Unsupported));
    Ok(if is_fine { Answer::Yes } else { Answer::No })
}

/// What is made of all runs together.
fn report(here: &Here, args: &Args, all: &[Conformed]) -> Result<(), CannotAsk> {
    let suite = here.suite()?;
    let out = args.out.clone().unwrap_or_else(|| suite.root().join(Suite::CONFORM));
    let selection = if args.filters.is_empty() {
        None
    } else {
        let asked = Here::fixtures(&suite, &args.filters)?.len();
        card::Selection::of(&args.filters, asked, Here::fixtures(&suite, &[])?.len())
    };
    let runs = (all, selection);
    let (_, files) = card::write(&out, runs, &|name| objects_of(&suite, name))?;
    for path in files {
        println!("wrote {}", path.display());
    }
    if let Some(json) = &args.json {
        let runs: Vec<_> = all.iter().map(|conformed| &conformed.run).collect();
        here.write(json, format!("{}\n", serde_json::to_string_pretty(&runs)?).as_bytes())?;
        println!("wrote {}", json.display());
    }
    Ok(())
}

/// Which renderers are asked for which pictures, and how.
pub(crate) struct Asked<'a> {
    /// Names of adapters, or paths.
    pub(crate) renderers: &'a [String],
    /// Which fixtures; all if there is none.
    pub(crate) filters: &'a [String],
    /// How fixtures are left out.
    pub(crate) leave_out: LeaveOut<'a>,
    /// Where results are put; the suite's own place if it is not said.
    pub(crate) out: Option<&'a Path>,
    /// What is read beside adapters and the suite, and must not be written over.
    pub(crate) inputs: &'a [PathBuf],
    /// Files that are written by whoever asks.
    pub(crate) outputs: &'a [PathBuf],
    /// How many scenes are rendered at a time.
    pub(crate) jobs: usize,
    /// How long a picture may take, in place of what the adapters say.
    pub(crate) timeout: Option<Duration>,
}

/// What came of asking renderers.
pub(crate) enum Ran {
    /// A run of each, in the order that they were named in.
    All(Vec<Conformed>),
    /// Somebody wanted it to end, which was said.
    Interrupted(Answer),
}

/// Renders and judges, and prints what is not a pass; Ctrl-C is listened to from here
/// on.
///
/// # Errors
/// Nothing selected, no such adapter or program, fixtures that goldray does not match
/// itself, files that cannot be written.
pub(crate) fn conformed(here: &Here, asked: &Asked<'_>) -> Result<Ran, CannotAsk> {
    let suite = here.suite()?;
    let interrupt = Interrupt::listen()?;
    let stop = |time| interrupt.wait(time);
    let out = match asked.out {
        Some(out) => {
            here.may_write(&out.join(RESULTS))?;
            out.to_owned()
        }
        None => suite.root().join(Suite::CONFORM),
    };
    let names = Here::fixtures(&suite, asked.filters)?;
    // Before anything is rendered: a program that is not there is not asked.
    let renderers = match find(&suite, asked.renderers, &out, &stop) {
        Err(_) if interrupt.is_set() => return Ok(Ran::Interrupted(interrupted(NOBODY))),
        found => found?,
    };
    let written = [asked.outputs, &files_of(&out, &renderers)].concat();
    places::keep_apart(&renderers, asked.inputs, (&out, &written))?;
    let Some(subjects) = right_ones(here, &suite, (&names, asked.leave_out), &stop)? else {
        return Ok(Ran::Interrupted(interrupted(NOBODY)));
    };
    for renderer in &renderers {
        Renderer::check_folder(&out.join(&renderer.info.id))?;
    }
    // What earlier runs have left goes away only when nothing is in the way of this one.
    for renderer in &renderers {
        renderer.prepare(&out.join(&renderer.info.id))?;
    }
    let prefix = here.reader(&suite).path_prefix;
    let mut all = Vec::new();
    for renderer in &renderers {
        let folder = out.join(&renderer.info.id);
        let plan = Plan { jobs: asked.jobs, timeout: asked.timeout, folder: &folder, stop: &stop };
        let Some(conformed) = one(renderer, (&subjects, &prefix), &plan)? else {
            let who = format!("{} has not rendered everything", renderer.info.name);
            return Ok(Ran::Interrupted(interrupted(&who)));
        };
        println!("results: {}", folder.join(RESULTS).display());
        all.push(conformed);
    }
    Ok(Ran::All(all))
}

/// Who has rendered where nobody was asked yet.
const NOBODY: &str = "no renderer was asked for a picture";

/// What a shell calls ended by Ctrl-C.
fn interrupted(what: &str) -> Answer {
    const CODE: u8 = 130;
    eprintln!("interrupted: {what}, and nothing is left running");
    Answer::Code(CODE)
}

/// The files that are made of all runs together, in their folder.
fn files_of(out: &Path, renderers: &[Renderer]) -> Vec<PathBuf> {
    let ids = renderers.iter().map(|renderer| renderer.info.id.as_str());
    card::file_names(ids).into_iter().map(|name| out.join(name)).collect()
}

/// The renderers that were named, each of which is there.
fn find(
    suite: &Suite,
    wanted: &[String],
    out: &Path,
    stop: conform::process::Stop<'_>,
) -> Result<Vec<Renderer>, CannotAsk> {
    let program = std::env::current_exe()?;
    let path = std::env::var_os("PATH").unwrap_or_default();
    let mut renderers: Vec<Renderer> = Vec::new();
    for wanted in wanted {
        let found = Renderer::find(suite, wanted, (out, &program, &path), stop);
        let found = found.map_err(|conform::run::CannotAsk(why)| CannotAsk(why))?;
        if renderers.iter().any(|other| other.info.id == found.info.id) {
            return Err(CannotAsk(format!(
                "--renderer {wanted}: expected another renderer, found the id \"{}\" twice",
                found.info.id
            )));
        }
        renderers.push(found);
    }
    Ok(renderers)
}

/// The fixtures with goldray's own pictures, all of which are right; `None` where it was
/// time to end before they were rendered.
fn right_ones(
    here: &Here,
    suite: &Suite,
    (names, leave_out): (&[String], LeaveOut<'_>),
    stop: conform::process::Stop<'_>,
) -> Result<Option<Vec<Subject>>, CannotAsk> {
    let progress = Progress::start("rendering", names.len());
    let made = subjects(suite, names, &|name| progress.advance(name), stop);
    progress.finish();
    made.map_err(|wrong| {
        let flag = here.reader(suite).root_flag;
        CannotAsk(wrong::words(&wrong, names, &flag, leave_out))
    })
}

/// All fixtures by one renderer.
fn one(
    renderer: &Renderer,
    (subjects, prefix): (&[Subject], &str),
    plan: &Plan<'_>,
) -> Result<Option<Conformed>, CannotAsk> {
    let version = match renderer.info.version.as_str() {
        "" => String::new(),
        version => format!(" ({version})"),
    };
    println!("{}{version}", renderer.info.name);
    let started = Instant::now();
    let progress = Progress::start("conforming", subjects.len());
    let lines = Lines::new(subjects.iter().map(|subject| subject.name.as_str()), &progress);
    let told = |told: &Told<'_>| {
        lines.tell(told.name, (told.result.outcome != Outcome::Pass).then(|| line(told, prefix)));
        progress.advance(told.name);
    };
    let stop = |time| (plan.stop)(time) || lines.is_unread();
    let conformed = run(renderer, subjects, &Plan { stop: &stop, ..*plan }, &told);
    progress.finish();
    lines.finish();
    let Some(conformed) = conformed? else { return Ok(None) };
    let counts = summary(&conformed);
    println!("{}: {counts} ({:.1} s)", renderer.info.name, started.elapsed().as_secs_f64());
    Ok(Some(conformed))
}

/// What is said of a fixture that does not pass; `prefix` leads to the suite.
fn line(told: &Told<'_>, prefix: &str) -> String {
    let Told { name, result, by_hand, strip, worst_on } = told;
    let file = format!("{prefix}{}", Suite::fixture_label(name));
    let on = worst_on.iter().map(|seen| format!("the worst is on {}", seen.words(&file)));
    let see = strip.iter().map(|strip| format!("see {}", strip.display()));
    let parts: Vec<_> = result.findings.iter().cloned().chain(on).chain(see).collect();
    let by_hand = by_hand.iter().map(|by_hand| format!("\n            by hand: {by_hand}"));
    let by_hand: String = by_hand.collect();
    format!("{:<11} {name}: {}{by_hand}", outcome::words(result.outcome), parts.join(" | "))
}

/// How many of each outcome, and how far the interior of those that pass is off.
fn summary(conformed: &Conformed) -> String {
    let results = conformed.run.fixtures.values();
    let outcomes: BTreeSet<_> = results.clone().map(|result| result.outcome).collect();
    let count = |outcome| results.clone().filter(|result| result.outcome == outcome).count();
    let counts =
        outcomes.iter().map(|&outcome| format!("{} {}", count(outcome), outcome::words(outcome)));
    let counts: Vec<_> = counts.collect();
    let numbers = results.clone().filter_map(|result| result.numbers);
    let (mut worst, mut off, mut edges) = (0.0_f64, 0, 0);
    for numbers in numbers {
        worst = worst.max(numbers.worst_interior);
        off += numbers.edge_off;
        edges += numbers.edge_pixels;
    }
    if edges + off == 0 && results.clone().all(|result| result.numbers.is_none()) {
        return counts.join(", ");
    }
    let pictures = format!("worst interior error {worst:.2e}, {off} of {edges} edge pixels differ");
    format!("{}; {pictures}", counts.join(", "))
}
