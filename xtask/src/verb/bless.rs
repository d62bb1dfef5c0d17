//! `bless`: accept today's pictures as goldens.

use harness::bless::{Blessed, bless};
use harness::digest;
use harness::report::numbers;
use harness::store;
use harness::suite::Suite;

use xtask::progress::Progress;
use xtask::{Answer, CannotAsk, Here};

/// Flags of `bless`.
#[derive(Debug, clap::Args)]
#[command(arg_required_else_help = true)]
pub(crate) struct Args {
    /// Which fixtures
    #[arg(value_name = "FILTER", required_unless_present = "all", conflicts_with = "all")]
    filters: Vec<String>,
    /// Every fixture that is not a match
    #[arg(long)]
    all: bool,
    /// Also remove selected goldens that have no fixture
    #[arg(long)]
    prune: bool,
}

pub(crate) fn run(here: &Here, args: &Args) -> Result<Answer, CannotAsk> {
    // Accepting is for people who have looked; a build server has not.
    if std::env::var_os("CI").is_some() {
        return Err(CannotAsk(
            "bless: expected to run by hand, found the variable CI set: run it on your own \
             machine, look at the pictures, and commit the goldens"
                .to_owned(),
        ));
    }
    let suite = here.suite()?;
    let selection = suite.select(&args.filters)?;
    let progress = Progress::start("blessing", selection.fixtures.len() + selection.orphans.len());
    let all = bless(&suite, &selection, args.prune, &|name, _| {
        progress.advance(name);
    });
    progress.finish();

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
    if written > 0 && store::is_file(&suite.root().join(Suite::CONTACT_SHEET)) {
        let flag = here.reader(&suite).root_flag;
        println!("then redraw {}: cargo xtask{flag} contact-sheet", Suite::CONTACT_SHEET);
    }
    if written > 0 && store::is_file(&suite.root().join(digest::TABLE)) {
        let flag = here.reader(&suite).root_flag;
        println!("then rewrite {}: cargo xtask{flag} digest --write", digest::TABLE);
    }
    println!("{written} written, {untouched} left as they were, {refused} refused");
    Ok(if refused == 0 { Answer::Yes } else { Answer::No })
}
