//! `open`: a page in the browser that the system prefers.

use std::process::{Command, Stdio};

use harness::store::{Scratch, StoreError};

/// Asks the system to show this address, for as long as the answer is held;
/// whether it can is its own affair.
///
/// Everybody on this machine sees what a program is started with, and the address
/// is a secret: what is opened is a file that only its owner can read, and that
/// leads there.
///
/// # Errors
/// The file cannot be written.
pub fn open(url: &str) -> Result<Scratch, StoreError> {
    let page = format!(
        "<!doctype html>\n<meta charset=\"utf-8\">\n<title>goldray</title>\n\
         <meta http-equiv=\"refresh\" content=\"0; url={url}\">\n<a href=\"{url}\">goldray</a>\n"
    );
    let scratch = Scratch::new()?;
    let file = scratch.write("goldray.html", page.as_bytes())?;
    let (program, args): (&str, &[&str]) = if cfg!(target_os = "macos") {
        ("open", &[])
    } else if cfg!(windows) {
        // The empty word is the window's title.
        ("cmd", &["/C", "start", ""])
    } else {
        ("xdg-open", &[])
    };
    let mut command = Command::new(program);
    command.args(args).arg(file).stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
    // The address was printed; who has no browser opens it elsewhere.
    let _ = command.spawn();
    Ok(scratch)
}
