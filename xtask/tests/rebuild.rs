//! `watch` of a renderer that is edited: it is built, by a stand-in for cargo, and
//! run in the place of the one before.
#![cfg(unix)]
#![allow(clippy::unwrap_used, clippy::disallowed_methods)]

mod browser;
mod tree;

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::os::unix::fs::PermissionsExt;
use std::path::Path;
use std::process::Command;
use std::time::{Duration, Instant};

use browser::{Printing, Served, changed, files};
use tree::{SQUARE, Tree, flat};

/// A tree that looks like goldray's own, with a stand-in for cargo that does
/// what `build.sh` in it says.
fn repository(build: &str) -> Tree {
    let tree = Tree::blessed(&[("a", SQUARE), ("b", SQUARE)]);
    for file in ["Cargo.toml", "xtask/Cargo.toml", "crates/tracer/Cargo.toml"] {
        tree.write(file, b"");
    }
    tree.write("crates/tracer/src/lib.rs", b"");
    tree.write("cargo", b"#!/bin/sh\necho \"$$ $TMPDIR\" > pid\n. ./build.sh\n");
    tree.write("build.sh", build.as_bytes());
    let mode = PermissionsExt::from_mode(0o755);
    fs::set_permissions(tree.path("cargo"), mode).unwrap();
    tree
}

fn watch_repository(tree: &Tree, args: &[&str]) -> Command {
    let mut command = tree.command(&[&["watch"], args].concat());
    command.env("CARGO", tree.path("cargo"));
    command
}

/// What cargo says of a program that it has built.
fn built(program: &str) -> String {
    format!(
        "echo '{{\"reason\":\"compiler-artifact\",\"target\":{{\"name\":\"xtask\"}},\"executable\":\"'$PWD/{program}'\"}}'\n"
    )
}

#[test]
fn an_edited_renderer_is_built_and_run_in_its_place() {
    let tree = repository("echo 'error: expected `;`' >&2\nexit 101\n");
    // The same program in other bytes.
    let mut program = fs::read(env!("CARGO_BIN_EXE_xtask")).unwrap();
    fs::write(tree.path("same"), &program).unwrap();
    program.extend(b"another");
    fs::write(tree.path("another"), &program).unwrap();
    for file in ["same", "another"] {
        let mode = PermissionsExt::from_mode(0o755);
        fs::set_permissions(tree.path(file), mode).unwrap();
    }
    let mut served = Served::start(&mut watch_repository(&tree, &[]));
    let (port, token) = (served.port, served.token.clone());
    let mut tab = served.tab();
    let (_, first, _) = tab.expect("state");
    let edit = |text: &str| tree.write("crates/tracer/src/lib.rs", text.as_bytes());
    edit("let");
    served.line_with("crates/tracer/src/lib.rs changed: building");
    served.line_with("not built: the verdicts above are of the program before");
    // It goes on watching.
    tree.write("fixtures/a.ron", flat().as_bytes());
    served.line_with("1 match, 1 stale golden");
    let (_, second, _) = tab.expect("reload");
    assert_ne!(first, second);
    tree.write("build.sh", built("same").as_bytes());
    edit("// a comment");
    served.line_with("the program is the same");
    tree.write("build.sh", built("another").as_bytes());
    edit("fn f() {}");
    served.line_with("changed: building");
    served.find_address();
    assert_eq!((served.port, &served.token), (port, &token), "tabs find it again");
    assert_eq!(served.tab_of(Some(&second)).expect("reload").1.len(), 32);
    let link = fs::read_link(format!("/proc/{}/exe", served.child.id()));
    if let Ok(link) = link {
        assert_eq!(link, tree.path("another").canonicalize().unwrap(), "the same process");
    }
    served.post("accept", &["a"]);
    served.interrupt();
    assert_eq!(served.end().0, Some(0));
}

#[test]
fn without_cargo_it_goes_on() {
    let tree = repository("");
    fs::remove_file(tree.path("cargo")).unwrap();
    let watch = Printing::start(&mut watch_repository(&tree, &["--no-serve"]));
    watch.until("2 judged: 2 match");
    tree.write("crates/tracer/src/lib.rs", b"fn f() {}");
    watch.until("not built: ");
    tree.write("fixtures/a.ron", flat().as_bytes());
    watch.until("1 match, 1 stale golden");
    assert_eq!(watch.interrupt(), Some(1));
}

#[test]
fn ctrl_c_stops_a_build_with_all_that_it_started() {
    let tree = repository("touch $TMPDIR/left-behind\nsleep 600 &\necho $! >> pid\nwait\n");
    let watch = Printing::start(&mut watch_repository(&tree, &["--no-serve"]));
    watch.until("2 judged: 2 match");
    let before = files(tree.0.path());
    tree.write("crates/tracer/src/lib.rs", b"fn f() {}");
    watch.until("building");
    let pids = loop {
        let pids = fs::read_to_string(tree.path("pid")).unwrap_or_default();
        if pids.lines().count() == 2 {
            break pids;
        }
        std::thread::sleep(Duration::from_millis(10));
    };
    let scratch = pids.lines().next().unwrap().split_once(' ').unwrap().1.to_owned();
    assert!(Path::new(&scratch).is_dir());
    assert_eq!(watch.interrupt(), Some(0), "as it stood");
    for pid in pids.lines() {
        let pid = nix::unistd::Pid::from_raw(pid.split(' ').next().unwrap().parse().unwrap());
        // It ends when it is its turn, and then waits to be noticed by who
        // started it.
        let started = Instant::now();
        while nix::sys::signal::kill(pid, None).is_ok() {
            let state = fs::read_to_string(format!("/proc/{pid}/stat")).unwrap_or_default();
            if state.contains(") Z ") {
                break;
            }
            assert!(started.elapsed() < Duration::from_secs(9), "{pid} runs on: {state}");
            std::thread::sleep(Duration::from_millis(10));
        }
    }
    assert!(!Path::new(&scratch).exists(), "{scratch} is left");
    assert_eq!(changed(&before, &files(tree.0.path())), ["crates/tracer/src/lib.rs", "pid"]);
}

#[test]
fn every_crate_that_the_program_is_built_from_is_watched() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap();
    let lock = fs::read_to_string(root.join("Cargo.lock")).unwrap();
    // Of the crates here, as those from elsewhere have a source.
    let ours: BTreeMap<_, Vec<_>> = lock
        .split("[[package]]")
        .filter(|package| !package.contains("\nsource = "))
        .filter_map(|package| {
            let mut words = package.split('"').skip(1).step_by(2);
            Some((words.next()?, words.skip(1).collect()))
        })
        .collect();
    let (mut built, mut left) = (BTreeSet::new(), vec!["xtask"]);
    while let Some(name) = left.pop() {
        if let (Some(needs), true) = (ours.get(name), built.insert(name)) {
            left.extend(needs);
        }
    }
    built.retain(|name| ours.contains_key(name));
    let folders = harness::stamps::Stamps::SOURCES.map(|place| root.join(place));
    let folders = folders.iter().filter(|place| place.join("Cargo.toml").is_file());
    let watched: BTreeSet<_> =
        folders.map(|place| place.file_name().unwrap().to_str().unwrap()).collect();
    assert_eq!(watched, built);
    assert!(built.contains("tracer"));
}
