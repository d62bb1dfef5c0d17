//! `bless`: accept today's pictures as goldens, at once or by a plan that is
//! reviewed in between.

use std::path::{Path, PathBuf};

use harness::bless::{Blessed, Moved, Plan, PlanError, commit, propose, propose_again};
use harness::called::command;
use harness::digest;
use harness::repack::{Repacked, repack};
use harness::report::{Reader, numbers};
use harness::store;
use harness::suite::{Selection, Suite};

use crate::progress::Progress;
use crate::{Answer, CannotAsk, Here};

/// Flags of `bless`.
#[derive(Debug, clap::Args)]
#[command(arg_required_else_help = true, after_help = EXAMPLES)]
pub(crate) struct Args {
    /// Which fixtures
    #[arg(
        value_name = "FILTER",
        required_unless_present_any = ["all", "apply"],
        conflicts_with_all = ["all", "apply"]
    )]
    filters: Vec<String>,
    /// Every fixture that is not a match
    #[arg(long, conflicts_with = "apply")]
    all: bool,
    /// Also remove selected goldens that have no fixture
    #[arg(long, conflicts_with = "apply")]
    prune: bool,
    /// Change nothing, and write what would change to this file for review
    #[arg(long, value_name = "FILE", conflicts_with = "apply")]
    plan: Option<PathBuf>,
    /// Do what this plan says, if nothing has moved since; else nothing at all
    #[arg(long, value_name = "FILE")]
    apply: Option<PathBuf>,
    /// Accept nothing; write goldens that match again where that makes their files smaller
    #[arg(long, conflicts_with_all = ["prune", "plan", "apply"])]
    repack: bool,
}

const EXAMPLES: &str = "\
Examples:
  cargo xtask bless sphere/tangent         accept today's picture of one fixture
  cargo xtask bless 'box/*' --plan p.json  write down what would be accepted, for review
  cargo xtask bless --apply p.json         accept that, or nothing if anything moved since
  cargo xtask bless --all --prune          accept all, and remove goldens without a fixture";

pub(crate) fn run(here: &Here, args: &Args) -> Result<Answer, CannotAsk> {
    by_hand("bless")?;
    let suite = here.suite()?;
    if let Some(file) = &args.apply {
        return apply(here, &suite, file);
    }
    let selection = suite.select(&args.filters)?;
    if args.repack {
        return Ok(write_again(&suite, &selection));
    }
    if let Some(file) = &args.plan {
        here.may_report(file)?;
    }
    let progress = Progress::start("blessing", selection.fixtures.len() + selection.orphans.len());
    let proposals = propose(&suite, &selection, args.prune, &|name| progress.advance(name));
    progress.finish();
    if let Some(file) = &args.plan {
        return write_plan(here, file, &Plan::of(&proposals));
    }
    Ok(say(here, &suite, commit(&suite, proposals)))
}

/// Accepting is for people who have looked; a build server has not.
pub(crate) fn by_hand(verb: &str) -> Result<(), CannotAsk> {
    if std::env::var_os("CI").is_none() {
        return Ok(());
    }
    Err(CannotAsk(format!(
        "{verb}: expected to run by hand, found the variable CI set: run it on your own machine, \
         look at the pictures, and commit the goldens"
    )))
}

fn write_plan(here: &Here, file: &Path, plan: &Plan) -> Result<Answer, CannotAsk> {
    here.write(file, (serde_json::to_string_pretty(plan)? + "\n").as_bytes())?;
    let (changed, refused) = (plan.goldens.len(), plan.refused.len());
    for refusal in &plan.refused {
        println!("refused   {}: {}", refusal.name, refusal.reasons.join("; ").trim_end());
    }
    println!("{changed} to be written or removed, {refused} refused: see {}", file.display());
    Ok(if refused == 0 { Answer::Yes } else { Answer::No })
}

fn apply(here: &Here, suite: &Suite, file: &Path) -> Result<Answer, CannotAsk> {
    let bytes = store::read(file, Plan::MAX_BYTES)?
        .ok_or_else(|| CannotAsk::file(file, "there is no such file"))?;
    let in_file = |error: PlanError| CannotAsk::file(file, &error.to_string());
    let plan = Plan::parse(&bytes).map_err(in_file)?;
    let progress = Progress::start("blessing", plan.goldens.len());
    let proposals = propose_again(suite, &plan, &|name| progress.advance(name));
    progress.finish();
    match proposals {
        Ok(proposals) => {
            let answer = say(here, suite, commit(suite, proposals));
            let refused: Vec<_> = plan.refused.iter().map(|refusal| &*refusal.name).collect();
            if !refused.is_empty() {
                println!("not written, as the plan refuses them: {}", refused.join(", "));
            }
            Ok(answer)
        }
        Err(PlanError::Moved(moved)) => Ok(say(here, suite, Err(moved))),
        Err(error) => Err(in_file(error)),
    }
}

fn say(here: &Here, suite: &Suite, all: Result<Vec<(String, Blessed)>, Vec<Moved>>) -> Answer {
    let all = match all {
        Ok(all) => all,
        Err(moved) => {
            for moved in &moved {
                println!("moved     {moved}");
            }
            println!(
                "nothing is written: what was looked at is not what there is; look again: cargo \
                 xtask bless --plan FILE"
            );
            return Answer::No;
        }
    };
    let (mut written, mut untouched, mut refused) = (0, 0, 0);
    for (name, blessed) in &all {
        match blessed {
            Blessed::Untouched => untouched += 1,
            Blessed::LeftOrphan => {
                untouched += 1;
                println!("left      {name}: a golden without a fixture (--prune removes it)");
            }
            Blessed::Refused(why) => {
                refused += 1;
                println!("refused   {name}: {}", why.join("; ").trim_end());
            }
            Blessed::Added => {
                written += 1;
                println!("added     {name}");
            }
            Blessed::Pruned => {
                written += 1;
                println!("pruned    {name}");
            }
            Blessed::Replaced { verdict, distance } => {
                written += 1;
                let distance = distance
                    .as_ref()
                    .map_or("not comparable".to_owned(), |distance| numbers(distance));
                println!("replaced  {name}: was {}, old to new: {distance}", verdict.words());
            }
        }
    }
    if written > 0 {
        say_what_follows(suite, &here.reader(suite));
    }
    println!("{written} written, {untouched} left as they were, {refused} refused");
    if refused == 0 { Answer::Yes } else { Answer::No }
}

/// What is drawn of goldens, and so is out of date.
pub(crate) fn say_what_follows(suite: &Suite, reader: &Reader) {
    let flag = &reader.root_flag;
    if store::is_file(&suite.root().join(Suite::CONTACT_SHEET)) {
        println!("then redraw {}: {}{flag} contact-sheet", Suite::CONTACT_SHEET, command());
    }
    if store::is_file(&suite.root().join(digest::TABLE)) {
        println!(
            "then, where linear pictures changed, rewrite {}: {}{flag} digest --write",
            digest::TABLE,
            command()
        );
    }
}

fn write_again(suite: &Suite, selection: &Selection) -> Answer {
    let progress = Progress::start("repacking", selection.fixtures.len());
    let all = repack(suite, &selection.fixtures, &|name| progress.advance(name));
    progress.finish();
    let (mut total_before, mut total_after, mut written, mut refused) = (0, 0, 0, 0);
    for (name, repacked) in &all {
        match repacked {
            Repacked::Untouched { bytes } => {
                total_before += bytes;
                total_after += bytes;
            }
            Repacked::Written { before, after } => {
                written += 1;
                total_before += before;
                total_after += after;
                println!("repacked  {name}: {before} to {after} bytes");
            }
            Repacked::Refused(why) => {
                refused += 1;
                println!("refused   {name}: {}", why.trim_end());
            }
        }
    }
    println!(
        "{written} written, {refused} refused: {total_before} bytes before, {total_after} after"
    );
    if refused == 0 { Answer::Yes } else { Answer::No }
}
