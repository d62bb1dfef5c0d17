//! `grade`: points for what a renderer gets right, by a rubric.

use std::path::{Path, PathBuf};

use conform::grade::{Grade, Plan, grade_lines, plan_lines, write};
use conform::{Conformed, objects_of};
use harness::suite::Suite;

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
    /// Say what each part of the rubric is about, and render nothing
    #[arg(long)]
    plan: bool,
}

const AFTER_HELP: &str = "\
docs/course.md has a rubric and an adapter to copy, and what a project of its own looks like.
Exit codes: 0 full points; 1 less; 2 could not ask, also where the rubric is wrong.

Examples:
  cargo xtask grade --renderer mine --rubric rubric.ron         the points, and a page with evidence
  cargo xtask grade --renderer mine --rubric rubric.ron --plan  what is asked for, part by part";

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
        print!("{}", plan_lines(&plan));
        return Ok(Answer::Yes);
    }
    let names: Vec<String> = plan.asked().into_iter().cloned().collect();
    let Some(conformed) = conformed(here, &suite, &args.renderer, &names, &out)? else {
        return Ok(Answer::Code(INTERRUPTED));
    };
    let grade = Grade::of(&plan, &conformed);
    let files = write(&out, &grade, &conformed, &|name| objects_of(&suite, name))?;
    print!("{}", grade_lines(&grade));
    for path in files {
        println!("wrote {}", path.display());
    }
    Ok(if grade.is_full() { Answer::Yes } else { Answer::No })
}

/// What a shell calls ended by Ctrl-C.
const INTERRUPTED: u8 = 130;

/// The run of the renderer over these fixtures; `None` where it was interrupted.
///
/// The one place where a grade and the running of renderers meet.
fn conformed(
    _here: &Here,
    _suite: &Suite,
    renderer: &str,
    names: &[String],
    _out: &Path,
) -> Result<Option<Conformed>, CannotAsk> {
    let count = names.len();
    Err(CannotAsk(format!(
        "--renderer {renderer}: this build runs no renderers, so {count} fixtures are not asked"
    )))
}
