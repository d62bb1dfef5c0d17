//! Programs that hang, print, write and leave children behind.

use std::time::Duration;

use harness::store::{self, Scratch};

use super::*;

const LONG: Duration = Duration::from_mins(2);

fn shell(script: &str) -> Command {
    let mut command = Command::new("sh");
    command.args(["-c", script]);
    command
}

fn run_for(script: &str, time: Duration) -> Ran {
    run(&mut shell(script), &Bounds { time, growth: None, stop: &never }).unwrap()
}

#[track_caller]
fn check(script: &str, code: Option<i32>, stdout: &str, stderr: &str) {
    let ran = run_for(script, LONG);
    let Ended::Alone(status) = ran.ended else { panic!("{:?}", ran.ended) };
    assert_eq!(
        (status.code(), ran.stdout.text(), ran.stderr.text()),
        (code, stdout.into(), stderr.into())
    );
}

#[test]
fn a_program_is_heard_to_its_end() {
    check("echo a; echo b >&2; exit 3", Some(3), "a\n", "b\n");
    check("cat", Some(0), "", "");
    check("kill -SEGV $$", None, "", "");
}

#[test]
fn what_is_printed_without_end_is_read_and_not_kept() {
    let ran = run_for("head -c 50000000 /dev/zero; echo end", LONG);
    assert_eq!(ran.stdout.bytes(), 50_000_004);
    assert!(ran.stdout.text().ends_with("end\n") && ran.stdout.text().len() < 10_000);
}

/// Waits until a process is gone: it takes a moment until the system has done so.
#[track_caller]
fn is_gone(pid: &str) {
    let pid = nix::unistd::Pid::from_raw(pid.trim().parse().unwrap());
    for _ in 0..2_000 {
        // One that nobody has waited for yet is a zombie, which runs no more.
        let state = store::read(Path::new(&format!("/proc/{pid}/stat")), 4_096).ok().flatten();
        let state = state.map(|stat| String::from_utf8_lossy(&stat).into_owned());
        let is_zombie = state.is_some_and(|stat| stat.contains(") Z "));
        if nix::sys::signal::kill(pid, None).is_err() || is_zombie {
            return;
        }
        std::thread::sleep(Duration::from_millis(5));
    }
    panic!("{pid} still runs");
}

#[test]
fn a_program_that_hangs_is_killed_with_its_children() {
    // Neither it nor its child listens to a polite word.
    let script = "trap '' TERM; sh -c 'trap \"\" TERM; sleep 1000' & echo $!; echo $$; wait";
    let ran = run_for(script, Duration::from_secs(3));
    assert_eq!(ran.ended, Ended::OutOfTime);
    assert!(ran.elapsed < Duration::from_mins(1));
    let said = ran.stdout.text();
    assert_eq!(said.lines().count(), 2, "{said}");
    said.lines().for_each(is_gone);
}

#[test]
fn a_program_may_end_by_a_polite_word() {
    let script = "trap 'echo bye; exit 0' TERM; echo there; while :; do sleep 0.01; done";
    let ran = run_for(script, Duration::from_secs(3));
    assert_eq!((ran.ended, ran.stdout.text().as_str()), (Ended::OutOfTime, "there\nbye\n"));
}

#[test]
fn children_do_not_outlive_a_program_that_ends_well() {
    let ran = run_for("sleep 1000 & echo $!", LONG);
    assert!(matches!(ran.ended, Ended::Alone(status) if status.success()));
    is_gone(&ran.stdout.text());
}

#[cfg(target_os = "linux")]
#[test]
fn neither_do_those_that_leave_its_group() {
    // The leader goes on when the other one is there.
    let start = "p=$(mktemp); setsid sh -c 'echo $$ > $0; exec sleep 1000' $p & \
                 while [ ! -s $p ]; do sleep 0.01; done; cat $p; rm $p;";
    let ran = run_for(start, LONG);
    assert!(matches!(ran.ended, Ended::Alone(_)));
    is_gone(&ran.stdout.text());
    let ran = run_for(&format!("{start} sleep 1000"), Duration::from_secs(3));
    assert_eq!(ran.ended, Ended::OutOfTime);
    is_gone(&ran.stdout.text());
}

#[test]
fn who_fills_the_disk_is_killed() {
    let scratch = Scratch::new().unwrap();
    let mut command = shell("cat /dev/zero > large");
    command.current_dir(scratch.folder());
    let growth = Some((scratch.folder(), 10_000_000));
    let ran = run(&mut command, &Bounds { time: LONG, growth, stop: &never }).unwrap();
    assert_eq!(ran.ended, Ended::TooMuch);
}

#[test]
fn all_ends_when_it_is_time() {
    let bounds = Bounds { time: LONG, growth: None, stop: &|_| true };
    let ran = run(&mut shell("sleep 1000"), &bounds).unwrap();
    assert_eq!(ran.ended, Ended::Stopped);
    assert!(ran.elapsed < Duration::from_mins(1));
}

#[test]
fn a_program_that_is_not_there_is_an_error() {
    let bounds = Bounds { time: LONG, growth: None, stop: &never };
    assert!(run(&mut Command::new("/no/such/program"), &bounds).is_err());
}
