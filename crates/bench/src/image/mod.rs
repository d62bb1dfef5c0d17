//! `image`: not measured yet.

/// Flags of `bench image`.
#[derive(Debug, clap::Args)]
pub(crate) struct Args {}

pub(crate) fn run(_: &Args) -> Result<(), String> {
    Err("not measured yet".into())
}
