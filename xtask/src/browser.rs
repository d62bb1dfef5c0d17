//! `open`: a page in the browser that the system prefers.

use std::process::{Command, Stdio};

/// Asks the system to show this address; whether it can is its own affair.
pub fn open(url: &str) {
    let (program, args): (&str, &[&str]) = if cfg!(target_os = "macos") {
        ("open", &[])
    } else if cfg!(windows) {
        // The empty word is the window's title.
        ("cmd", &["/C", "start", ""])
    } else {
        ("xdg-open", &[])
    };
    let mut command = Command::new(program);
    command.args(args).arg(url).stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
    // The address was printed; who has no browser opens it elsewhere.
    let _ = command.spawn();
}
