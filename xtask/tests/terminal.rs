//! `review --tty` as the real binary does it, with keys from a pipe.
#![allow(clippy::unwrap_used, clippy::disallowed_methods)]

mod browser;
mod tree;

use std::fs;
use std::io::Write;
use std::process::Stdio;

use browser::{changed, files};
use tree::{Ran, Tree};

/// Presses these keys.
fn press(tree: &Tree, keys: &str, variables: &[(&str, &str)]) -> Ran {
    let mut command = tree.command(&["review", "--tty"]);
    command.envs(variables.iter().copied()).env_remove("NO_COLOR");
    command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = command.spawn().unwrap();
    child.stdin.take().unwrap().write_all(keys.as_bytes()).unwrap();
    Ran(child.wait_with_output().unwrap())
}

#[test]
fn in_the_terminal_keys_decide() {
    let tree = Tree::failing();
    let before = files(tree.0.path());
    let now = || files(tree.0.path());
    let ran = press(&tree, "?x", &[]).expect_code(1);
    let ran = ran.expect("[1/4] add/ed: missing golden").expect("u: take the last decision back");
    ran.expect("0 accepted, 0 rejected, 4 left");
    assert_eq!(changed(&before, &now()), [""; 0]);
    // Accept, accept what cannot be, skip it, go back, reject it, and stop.
    let ran = press(&tree, "aasprq", &[]).expect_code(1);
    let ran = ran.expect("accepted add/ed").expect("broken is not accepted: ");
    let ran = ran.expect("[2/4] broken: missing golden").expect("\ncannot be accepted\n");
    ran.expect("1 accepted, 1 rejected, 2 left");
    assert_eq!(changed(&before, &now()), ["golden/add/ed.png"]);
    let ran = press(&tree, "sau\nuq", &[]).expect_code(1);
    let ran = ran.expect("accepted changed").expect("taken back: changed");
    ran.expect("nothing was decided").expect("0 accepted, 0 rejected, 3 left");
    assert_eq!(changed(&before, &now()), ["golden/add/ed.png"]);
    fs::remove_file(tree.path("fixtures/broken.ron")).unwrap();
    press(&tree, "aa", &[]).expect_code(0).expect("2 accepted, 0 rejected, 0 left");
}

#[test]
fn the_terminal_may_be_narrow_or_without_colors() {
    let tree = Tree::failing();
    let ran = press(&tree, "ssss", &[("COLUMNS", "40")]).expect_code(1);
    let said = ran.stdout();
    let pictures: Vec<_> = said.lines().filter(|line| line.contains('@')).collect();
    assert!(!pictures.is_empty() && pictures.iter().all(|line| line.len() <= 40), "{said}");
    assert!(said.lines().any(|line| line.contains('8')), "differences are digits: {said}");
    assert!(!said.contains('\u{1b}') && !said.contains('▀'), "{said}");
    let review = said.split_once("[1/4]").unwrap().1;
    let shown = review.split("0 accepted").next().unwrap().lines();
    assert!(
        shown.filter(|line| !line.starts_with("left")).all(|line| line.chars().count() <= 40),
        "{said}"
    );
    let color = press(&tree, "s", &[("CLICOLOR_FORCE", "1")]).expect_code(1).expect("▀");
    color.expect("\u{1b}[38;2;255;255;255m");
}

#[cfg(unix)]
#[test]
fn whatever_ends_it_is_told_how_it_stands() {
    use nix::sys::signal::{Signal, kill};
    for signal in [Signal::SIGINT, Signal::SIGTERM, Signal::SIGHUP] {
        let tree = Tree::failing();
        let mut command = tree.command(&["review", "--tty"]);
        command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
        let mut child = command.spawn().unwrap();
        // It stays open.
        let mut keys = child.stdin.take().unwrap();
        keys.write_all(b"a").unwrap();
        while !tree.path("golden/add/ed.png").exists() {
            std::thread::sleep(std::time::Duration::from_millis(10));
        }
        kill(nix::unistd::Pid::from_raw(child.id().try_into().unwrap()), signal).unwrap();
        let ran = Ran(child.wait_with_output().unwrap()).expect_code(1);
        ran.expect("1 accepted, 0 rejected, 3 left");
    }
}
