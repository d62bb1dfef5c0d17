//! Programs that may hang, print without end or leave others running, run so that
//! nothing of them is left.
//!
//! A program runs in a process group of its own, so that Ctrl-C is this program's
//! to hear, and so that it can be ended together with what it has started. The
//! group is killed after every run, also after one that ended well. On Linux,
//! what has left the group is found by a mark in its environment and killed as
//! well; a process that leaves its group and drops its environment is not found.
//! Elsewhere than on Unix only the program itself is ended.

mod group;
mod kept;

pub use group::Group;
pub use kept::{Heard, Listener};

use std::path::Path;
use std::process::{Command, ExitStatus, Stdio};
use std::time::{Duration, Instant};

/// Waits so long, or until it is time to end; whether it is.
pub type Stop<'a> = &'a (dyn Fn(Duration) -> bool + Sync);

/// Waits, and never says that it is time to end.
pub fn never(time: Duration) -> bool {
    std::thread::sleep(time);
    false
}

/// How much a program may take.
#[derive(Clone, Copy)]
pub struct Bounds<'a> {
    /// How long it may run.
    pub time: Duration,
    /// How many bytes may come to be in a folder, if it is looked at.
    pub growth: Option<(&'a Path, u64)>,
    /// Whether it is time to end.
    pub stop: Stop<'a>,
}

/// How a program ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ended {
    /// By itself, or by a signal that was not ours.
    Alone(ExitStatus),
    /// It was killed as its time was over.
    OutOfTime,
    /// It was killed as it wrote too much.
    TooMuch,
    /// It was killed as it was time to end.
    Stopped,
}

/// A program that was run.
#[derive(Debug, Clone)]
pub struct Ran {
    /// How it ended.
    pub ended: Ended,
    /// What it printed.
    pub stdout: Heard,
    /// What it printed as errors.
    pub stderr: Heard,
    /// How long it took.
    pub elapsed: Duration,
}

/// Runs a program to its end, with nothing on its standard input. It is heard to
/// the end, however much it prints, and little of that is kept.
///
/// # Errors
/// It cannot be started, or the system does not tell of it.
pub fn run(command: &mut Command, bounds: &Bounds<'_>) -> std::io::Result<Ran> {
    command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let started = Instant::now();
    let mut group = Group::marked(command)?;
    let stdout = Listener::to(group.child().stdout.take());
    let stderr = Listener::to(group.child().stderr.take());
    let ended = end_of(&mut group, bounds);
    let elapsed = started.elapsed();
    group.kill();
    Ok(Ran { ended: ended?, stdout: stdout.heard(), stderr: stderr.heard(), elapsed })
}

/// Waits for the end of a program, or asks it to end where it must.
///
/// # Errors
/// The system does not tell of it.
pub fn end_of(group: &mut Group, bounds: &Bounds<'_>) -> std::io::Result<Ended> {
    /// How soon and how late it is looked again whether it has ended.
    const LOOK_AFTER: std::ops::Range<Duration> =
        Duration::from_millis(1)..Duration::from_millis(20);
    /// How often it is looked how much it has written.
    const WEIGH_EVERY: Duration = Duration::from_millis(100);
    /// What is a long time to those who wait for a short one.
    const PART: u32 = 10;
    let started = Instant::now();
    let mut weighed = started;
    loop {
        if group.has_ended()? {
            return Ok(Ended::Alone(group.wait()?));
        }
        if weighed.elapsed() > WEIGH_EVERY {
            let is_heavy = |(folder, most)| harness::store::folder_bytes(folder) > most;
            if bounds.growth.is_some_and(is_heavy) {
                return Ok(Ended::TooMuch);
            }
            weighed = Instant::now();
        }
        let left = bounds.time.saturating_sub(started.elapsed());
        if left.is_zero() {
            group.ask_to_end();
            return Ok(Ended::OutOfTime);
        }
        let pause = (started.elapsed() / PART).clamp(LOOK_AFTER.start, LOOK_AFTER.end).min(left);
        if (bounds.stop)(pause) {
            return Ok(Ended::Stopped);
        }
    }
}

#[cfg(test)]
#[cfg(unix)]
mod tests;
