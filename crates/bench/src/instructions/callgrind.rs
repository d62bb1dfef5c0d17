//! Counts the instructions of each work under valgrind's callgrind.

use std::process::Command;

use super::baseline::Counts;
use super::work::{self, COUNTED};

/// The counts of every work, and the levels of the processor that the program
/// saw there.
pub(super) fn count_all() -> Result<(Counts, Vec<String>), String> {
    let mut counts = Counts::new();
    let mut levels = None;
    for work in work::ALL {
        eprintln!("counting {}", work.name);
        let (count, seen) = count(work.name)?;
        counts.insert(work.name.to_owned(), count);
        levels = Some(seen);
    }
    Ok((counts, levels.unwrap_or_default()))
}

/// Runs this very program on one work.
fn count(name: &str) -> Result<(u64, Vec<String>), String> {
    let program = std::env::current_exe().map_err(|error| error.to_string())?;
    let output = Command::new("valgrind")
        .args(["--tool=callgrind", "--callgrind-out-file=/dev/null"])
        // Off and on again at each entry and exit, so that what readies the
        // work is not counted. The name is part of any mangled one.
        .arg(format!("--toggle-collect=*{COUNTED}*"))
        .arg(program)
        .args(["work", name])
        .output()
        .map_err(|error| {
            format!("valgrind: {error}; as root on Debian: apt-get install valgrind")
        })?;
    let said = String::from_utf8_lossy(&output.stderr);
    if !output.status.success() {
        return Err(format!("valgrind on `work {name}` ended with {}:\n{said}", output.status));
    }
    let levels = String::from_utf8_lossy(&output.stdout);
    let levels = levels.split_whitespace().map(str::to_owned).collect();
    match collected(&said) {
        Some(count) if count > 0 => Ok((count, levels)),
        _ => Err(format!("valgrind on `work {name}`: expected a count above 0, found:\n{said}")),
    }
}

/// The number in valgrind's line `==1== Collected : 2`.
fn collected(said: &str) -> Option<u64> {
    let line = said.lines().find(|line| line.contains("Collected :"))?;
    line.rsplit(':').next()?.trim().parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_count_is_found_among_what_valgrind_says() {
        let said = "==9== Events    : Ir\n==9== Collected : 123456\n==9== \n";
        assert_eq!(collected(said), Some(123_456));
        assert_eq!(collected("==9== Events    : Ir\n"), None);
        assert_eq!(collected("==9== Collected :\n"), None);
    }
}
