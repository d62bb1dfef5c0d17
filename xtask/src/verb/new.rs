//! `new`: a small valid fixture to start from.

use harness::called::command;
use harness::template::new_fixture;
use harness::verdict::shell_word;

use crate::{Answer, CannotAsk, Here};

/// Flags of `new`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Args {
    /// The fixture's name, such as `sphere/tangent`
    name: String,
}

const EXAMPLES: &str = "\
Examples:
  cargo xtask new torus/from-inside     writes fixtures/torus/from-inside.ron";

pub(crate) fn run(here: &Here, Args { name }: &Args) -> Result<Answer, CannotAsk> {
    let suite = here.suite()?;
    let path = new_fixture(&suite, name)?;
    let (reader, called) = (here.reader(&suite), command());
    let (prefix, flag, name) = (reader.path_prefix, reader.root_flag, shell_word(name));
    println!("wrote {prefix}{path}");
    println!("look:    {called}{flag} render {name} --out {prefix}target/new.png");
    println!("accept:  {called}{flag} bless {name}");
    Ok(Answer::Yes)
}
