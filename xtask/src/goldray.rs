//! `goldray`: the command line where it is installed, for any folder with fixtures
//! and goldens.

use std::process::ExitCode;

fn main() -> ExitCode {
    xtask::cli::installed()
}
