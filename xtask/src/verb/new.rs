//! `new`: a small valid fixture to start from.

use harness::suite::Suite;
use harness::template::new_fixture;

use crate::{Answer, CannotAsk};

/// Flags of `new`.
#[derive(Debug, clap::Args)]
pub(crate) struct Args {
    /// The fixture's name, such as `sphere/tangent`
    name: String,
}

pub(crate) fn run(suite: &Suite, Args { name }: &Args) -> Result<Answer, CannotAsk> {
    let path = new_fixture(suite, name)?;
    println!("wrote {path}");
    println!("look:    cargo xtask render {name} --out target/{name}.png");
    println!("accept:  cargo xtask bless {name}");
    Ok(Answer::Yes)
}
