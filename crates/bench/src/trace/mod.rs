//! `trace`: not measured yet.

/// Flags of `bench trace`.
#[derive(Debug, clap::Args)]
pub(crate) struct Args {}

pub(crate) fn run(_: &Args) -> Result<(), String> {
    Err("not measured yet".into())
}
