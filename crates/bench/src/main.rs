//! `bench`: goldray measured on this machine, alone and beside its peers; run
//! as `cargo xtask bench`.

mod bars;
mod check;
mod files;
mod image;
mod inputs;
mod instructions;
mod kernels;
mod machine;
mod measure;
mod meshes;
mod peers;
mod place;
mod plot;
mod random;
mod report;
mod scaling;
mod slope;
mod svg;
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
    /// Nanoseconds of each test that a ray is held against
    Kernels(kernels::Args),
    /// Times against primitives, pixels, lights and threads, with their slopes
    Scaling(scaling::Args),
    /// Fixtures a second of the whole check, and where the time goes
    Check(check::Args),
    /// Instructions of fixed work, counted and held against the baseline
    Instructions(instructions::Args),
    /// Write docs/performance.md from the JSON files of the others
    Report(report::Args),
    /// Do one of the fixed pieces of work
    #[command(hide = true)]
    Work(instructions::WorkArgs),
}

fn main() -> ExitCode {
    let done = match Cli::parse().what {
        What::Trace(args) => trace::run(&args).map(|()| ExitCode::SUCCESS),
        What::Image(args) => image::run(&args).map(|()| ExitCode::SUCCESS),
        What::Peers(args) => peers::run(&args).map(|()| ExitCode::SUCCESS),
        What::Kernels(args) => kernels::run(&args),
        What::Scaling(args) => scaling::run(&args),
        What::Check(args) => check::run(&args),
        What::Instructions(args) => instructions::run(&args),
        What::Report(args) => report::run(&args),
        What::Work(args) => instructions::run_work(&args),
    };
    done.unwrap_or_else(|why| {
        eprintln!("error: {}", why.trim_end());
        ExitCode::from(2)
    })
}
