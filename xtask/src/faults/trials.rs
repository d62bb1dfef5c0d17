//! The trials of all faults, each in a process of its own that may die.

use std::io::{BufRead, BufReader};
use std::process::{Child, Command, Stdio};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::sync::{Mutex, PoisonError};
use std::time::Duration;

use harness::faults::{Fate, Fault, Matrix, Row, Trial};
use harness::suite::Suite;
use xtask::CannotAsk;
use xtask::progress::Progress;

/// After so many fixtures that take the process with them, the others are not
/// tried: they would all cost as much.
const MOST_LOST: usize = 3;

/// Tries every fault on every fixture, as many faults at a time as there are
/// processors.
pub(super) fn of_all(
    suite: &Suite,
    names: &[String],
    faults: &[Fault],
    patience_s: u32,
) -> Result<Matrix, CannotAsk> {
    let patience = Duration::from_secs(patience_s.into());
    let at_a_time = std::thread::available_parallelism().map_or(1, usize::from);
    let (next, rows) = (AtomicUsize::new(0), Mutex::new(Vec::new()));
    let progress = Progress::of("seeding", "fault", faults.len());
    let work = || {
        while let Some(&fault) = faults.get(next.fetch_add(1, Ordering::Relaxed)) {
            let row = of_one(suite, names, fault, patience).map(|trials| Row { fault, trials });
            progress.advance(&fault.name());
            rows.lock().unwrap_or_else(PoisonError::into_inner).push(row);
        }
    };
    std::thread::scope(|scope| {
        for _ in 0..at_a_time {
            scope.spawn(work);
        }
    });
    progress.finish();
    let rows = rows.into_inner().unwrap_or_else(PoisonError::into_inner);
    let mut rows = rows.into_iter().collect::<Result<Vec<_>, CannotAsk>>()?;
    rows.sort_by_key(|row| row.fault);
    Ok(Matrix { rows })
}

/// The trials of one fault, in the order of the names.
fn of_one(
    suite: &Suite,
    names: &[String],
    fault: Fault,
    patience: Duration,
) -> Result<Vec<Trial>, CannotAsk> {
    let mut trials: Vec<Trial> = Vec::new();
    let mut lost = 0;
    while trials.len() < names.len() {
        let todo = &names[trials.len()..];
        let end = if lost < MOST_LOST {
            let child = start(suite, todo, fault)?;
            listen(child, todo, patience, &mut trials)
        } else {
            "not tried, as too many others crashed".to_owned()
        };
        // Whoever has not said anything is the one it ended in.
        if let Some(name) = names.get(trials.len()) {
            lost += 1;
            let fate = Fate::Crashed(end);
            trials.push(Trial { fixture: name.clone(), reached: true, fate });
        }
    }
    Ok(trials)
}

fn start(suite: &Suite, names: &[String], fault: Fault) -> Result<Child, CannotAsk> {
    let child = Command::new(std::env::current_exe()?)
        .arg("--root")
        .arg(suite.root())
        .args(["--trial", &fault.name(), "--"])
        .args(names)
        // Faults are tried side by side; each has a processor.
        .env("RAYON_NUM_THREADS", "1")
        .stdin(Stdio::null())
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .spawn()?;
    Ok(child)
}

/// Takes down what a child says of these fixtures, until it ends or says nothing
/// for too long. Returns how it ended.
fn listen(
    mut child: Child,
    names: &[String],
    patience: Duration,
    trials: &mut Vec<Trial>,
) -> String {
    let (say, hear) = channel();
    let output = child.stdout.take();
    let listener = std::thread::spawn(move || {
        for line in output.into_iter().flat_map(|output| BufReader::new(output).lines()) {
            let trial = line.ok().and_then(|line| serde_json::from_str::<Trial>(&line).ok());
            if say.send(trial).is_err() {
                return;
            }
        }
    });
    let mut expected = names.iter();
    let end = loop {
        match hear.recv_timeout(patience) {
            Ok(Some(trial)) if expected.next() == Some(&trial.fixture) => trials.push(trial),
            Ok(_) => break Some("said something else than its trial".to_owned()),
            Err(RecvTimeoutError::Timeout) => {
                break Some(format!("had not come to an end in {} s", patience.as_secs()));
            }
            Err(RecvTimeoutError::Disconnected) => break None,
        }
    };
    if end.is_some() {
        // It may have ended by itself in the meantime.
        let _ = child.kill();
    }
    let status = child.wait().map_or_else(|error| error.to_string(), |status| status.to_string());
    // Its output has ended with it.
    let _ = listener.join();
    end.unwrap_or(status)
}
