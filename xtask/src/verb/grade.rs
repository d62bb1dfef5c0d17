//! `grade`: points for what a renderer gets right, by a rubric.

use std::collections::BTreeMap;
use std::path::PathBuf;

use conform::adapter::Adapter;
use conform::grade::{FILES, Grade, Plan, grade_lines, plan_lines, write};
use conform::objects_of;
use harness::fixture::{Build, Fixture};
use harness::suite::Suite;

use super::conform::{Asked, LeaveOut, Ran, conformed, seconds};
use crate::{Answer, CannotAsk, Here};

/// Flags of `grade`.
#[derive(Debug, clap::Args)]
#[command(after_help = AFTER_HELP)]
pub(crate) struct Args {
    /// The renderer: the name of an adapter, or a path to its file
    #[arg(long, value_name = "ADAPTER")]
    renderer: String,
    /// What points are given for: a RON file
    #[arg(long, value_name = "FILE")]
    rubric: PathBuf,
    /// Where grade.html, grade.md and grade.json are put [default: target/goldray-grade]
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Render so many scenes at a time
    #[arg(long, value_name = "COUNT", default_value = "1", value_parser = clap::value_parser!(u16).range(1..))]
    jobs: u16,
    /// Kill the renderer after so long, in place of what its adapter says
    #[arg(long, value_name = "SECONDS", value_parser = seconds)]
    timeout: Option<std::time::Duration>,
    /// Say what each part of the rubric is about and what the adapter rules out; ask nobody
    #[arg(long)]
    plan: bool,
}

const AFTER_HELP: &str = "\
docs/course.md has a rubric and an adapter to copy, and what a project of its own looks like.
Exit codes: 0 full points; 1 less; 2 could not ask, also where the rubric is wrong.

Examples:
  cargo xtask grade --renderer mine --rubric rubric.ron         the points, and a page with evidence
  cargo xtask grade --renderer mine --rubric rubric.ron --plan  what is asked for, part by part";

/// What the adapter does not ask the renderer for, by fixture, with the reasons.
fn ruled_out(
    suite: &Suite,
    wanted: &str,
    plan: &Plan,
) -> Result<BTreeMap<String, String>, CannotAsk> {
    let adapter = Adapter::find(suite, wanted).map_err(CannotAsk)?;
    let mut out = BTreeMap::new();
    for name in plan.asked() {
        let label = Suite::fixture_label(name);
        let fixture = Fixture::open(&label, &suite.fixture_path(name), Build::default());
        let fixture = fixture.map_err(CannotAsk)?;
        let features = plan.features.get(name).cloned().unwrap_or_default();
        let why = conform::run::ruled_out(&adapter, &fixture, &features);
        if !why.is_empty() {
            out.insert(name.clone(), why.join("; "));
        }
    }
    Ok(out)
}

/// Where a grade is put, in the suite, unless it is said.
const FOLDER: &str = "target/goldray-grade";

pub(crate) fn run(here: &Here, args: &Args) -> Result<Answer, CannotAsk> {
    let suite = here.suite()?;
    let out = match &args.out {
        Some(out) => {
            here.may_write(&out.join("grade.html"))?;
            out.clone()
        }
        None => suite.root().join(FOLDER),
    };
    // Before anything is rendered: a rubric that is wrong is not asked for.
    let all = Here::fixtures(&suite, &[])?;
    let plan = Plan::open(&args.rubric, &suite, &all).map_err(CannotAsk)?;
    if args.plan {
        print!("{}", plan_lines(&plan, &ruled_out(&suite, &args.renderer, &plan)?));
        return Ok(Answer::Yes);
    }
    let names: Vec<String> = plan.asked().into_iter().cloned().collect();
    let asked = Asked {
        renderers: std::slice::from_ref(&args.renderer),
        filters: &names,
        leave_out: LeaveOut::Rubric(&args.rubric),
        out: Some(&out),
        inputs: std::slice::from_ref(&args.rubric),
        outputs: &FILES.map(|name| out.join(name)),
        jobs: args.jobs.into(),
        timeout: args.timeout,
    };
    let all = match conformed(here, &asked)? {
        Ran::All(all) => all,
        Ran::Interrupted(answer) => return Ok(answer),
    };
    // One renderer was asked, so there is one run.
    let Some(conformed) = all.first() else { return Ok(Answer::No) };
    let grade = Grade::of(&plan, conformed);
    let files = write(&out, &grade, conformed, &|name| objects_of(&suite, name))?;
    print!("{}", grade_lines(&grade));
    for path in files {
        println!("wrote {}", path.display());
    }
    Ok(if grade.is_full() { Answer::Yes } else { Answer::No })
}
