//! `digest`: the bits of every picture, printed, or held against the committed
//! table that every target must reproduce.

use harness::called::command;
use harness::digest::{self, TABLE, Table};
use harness::verdict::shell_word;

use crate::progress::Progress;
use crate::{Answer, CannotAsk, Here};

/// Flags of `digest`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Args {
    /// Which fixtures; all if none is given
    #[arg(value_name = "FILTER")]
    filters: Vec<String>,
    /// Compare with golden/digests.txt
    #[arg(long, conflicts_with = "write")]
    check: bool,
    /// Write golden/digests.txt
    #[arg(long)]
    write: bool,
}

const EXAMPLES: &str = "\
Examples:
  cargo xtask digest sphere             print the bits of some
  cargo xtask digest --check            hold all against golden/digests.txt
  cargo xtask digest --write            write that table anew";

pub(crate) fn run(here: &Here, args: &Args) -> Result<Answer, CannotAsk> {
    // As with goldens: a build server has not looked at why the bits changed.
    if args.write && std::env::var_os("CI").is_some() {
        return Err(CannotAsk(
            "digest --write: expected to run by hand, found the variable CI set".to_owned(),
        ));
    }
    let suite = here.suite()?;
    let selected = suite.select(&args.filters)?.fixtures;
    let fixtures = suite.select(&[])?.fixtures;
    let flag = here.reader(&suite).root_flag;
    let write = format!("{}{flag} digest --write", command());
    // Before rendering anything: where there is no good table, nothing follows.
    let table = if args.check || args.write && !args.filters.is_empty() {
        let none = || CannotAsk(format!("{TABLE}: there is no such file: {write} makes it"));
        digest::read_table(&suite)?.ok_or_else(none)?
    } else {
        Table::new()
    };

    let progress = Progress::start("digesting", selected.len());
    let results = digest::of_fixtures(&suite, &selected, &|name| progress.advance(name));
    progress.finish();
    let mut today = Table::new();
    let mut refused = 0;
    for (name, result) in results {
        match result {
            Ok(digest) => _ = today.insert(name, digest),
            Err(why) => {
                refused += 1;
                println!("refused   {}", why.trim_end());
            }
        }
    }

    if args.check {
        let differences = digest::differences(&table, &fixtures, &today);
        for difference in &differences {
            println!("differs   {difference}");
        }
        if differences.is_empty() && refused == 0 {
            let (s, have) = if today.len() == 1 { ("", "has") } else { ("s", "have") };
            println!("{} picture{s} {have} the bits of {TABLE}", today.len());
            return Ok(Answer::Yes);
        }
        let filters = args.filters.iter().map(|filter| shell_word(filter));
        let again = std::iter::once(write).chain(filters).collect::<Vec<_>>().join(" ");
        println!("{} differences, {refused} refused | if meant: {again}", differences.len());
        return Ok(Answer::No);
    }
    if args.write {
        if refused > 0 {
            println!("{refused} refused, nothing is written");
            return Ok(Answer::No);
        }
        let mut table = table;
        table.retain(|name, _| fixtures.contains(name));
        table.extend(today);
        digest::write_table(&suite, &table)?;
        println!("wrote {TABLE}, {} lines", table.len());
        return Ok(Answer::Yes);
    }
    for (name, digest) in &today {
        println!("{}", digest::line(name, digest));
    }
    Ok(if refused == 0 { Answer::Yes } else { Answer::No })
}
