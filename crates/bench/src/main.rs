//! `bench`: goldray measured on this machine, alone and beside its peers; run
//! as `cargo xtask bench`.

mod clock;
mod files;
mod image;
mod meshes;
mod peers;
mod stats;
mod trace;

use std::process::ExitCode;

use clap::{Parser, Subcommand};

/// Counts what is allocated, so that a mesh can be said to take so many bytes.
#[global_allocator]
static ALLOCATOR: cap::Cap<std::alloc::System> = cap::Cap::new(std::alloc::System, usize::MAX);

/// Measure goldray on this machine, alone and beside its peers.
#[derive(Debug, Parser)]
#[command(name = "bench", bin_name = "cargo xtask bench")]
struct Cli {
    #[command(subcommand)]
    what: What,
}

#[derive(Debug, Subcommand)]
enum What {
    /// Millions of rays a second through meshes, beside other tracers
    Trace(trace::Args),
    /// Seconds to a picture of a given error, beside other renderers
    Image(image::Args),
    /// Other people's tracers and meshes: what is there; `--install` fetches them
    Peers(peers::Args),
}

fn main() -> ExitCode {
    let done = match Cli::parse().what {
        What::Trace(args) => trace::run(&args),
        What::Image(args) => image::run(&args),
        What::Peers(args) => peers::run(&args),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(why) => {
            eprintln!("error: {why}");
            ExitCode::from(2)
        }
    }
}
