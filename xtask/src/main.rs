//! `cargo xtask`: goldray's command line in its repository.

use std::process::ExitCode;

fn main() -> ExitCode {
    xtask::cli::in_repository()
}
