//! `watch` as the real binary does it: every kind of edit is noticed once, what
//! it writes itself is none, and it leaves nothing behind.
#![cfg(unix)]
#![allow(clippy::unwrap_used, clippy::panic, clippy::disallowed_methods)]

mod browser;
mod tree;

use std::fs;
use std::io::{BufRead, BufReader};
use std::path::Path;
use std::process::{Command, Stdio};
use std::sync::mpsc::{Receiver, channel};
use std::time::Duration;

use browser::{PATIENCE, Served, changed, files};
use serde_json::json;
use tree::{SQUARE, Tree};

/// A square whose upper half is gone.
fn flat() -> String {
    SQUARE.replace("(1, 1, 1)", "(1, 0.5, 1)")
}

const MESH: &str = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nf 1 2 3 4\n";

fn tree() -> Tree {
    let mesh = SQUARE.replace("Box(min: (-1, -1, -1), max: (1, 1, 1))", "Mesh(file: \"b.obj\")");
    let tree = Tree::new(&[("a", SQUARE), ("b", &mesh)]);
    tree.write("fixtures/b.obj", MESH.as_bytes());
    tree.run(&["bless", "--all"]).expect_code(0);
    tree
}

/// A watch that only prints, line by line.
struct Printing {
    child: std::process::Child,
    lines: Receiver<String>,
}

impl Printing {
    fn start(command: &mut Command) -> Self {
        let mut child = command.stdout(Stdio::piped()).stderr(Stdio::null()).spawn().unwrap();
        let stdout = BufReader::new(child.stdout.take().unwrap());
        let (sender, lines) = channel();
        std::thread::spawn(move || {
            stdout.lines().map_while(Result::ok).try_for_each(|line| sender.send(line))
        });
        Self { child, lines }
    }

    /// Reads on until a line with this; what was read before it.
    #[track_caller]
    fn until(&self, text: &str) -> String {
        let mut all = String::new();
        loop {
            let Ok(line) = self.lines.recv_timeout(PATIENCE) else {
                panic!("expected {text:?} in:\n{all}");
            };
            all += &line;
            all.push('\n');
            if line.contains(text) {
                return all;
            }
        }
    }

    /// That it has nothing to say for a while in which it looks several times.
    #[track_caller]
    fn expect_silence(&self) {
        let said = self.lines.recv_timeout(Duration::from_millis(1500));
        assert!(said.is_err(), "{said:?}");
    }

    fn signal(&self, signal: nix::sys::signal::Signal) {
        let pid = nix::unistd::Pid::from_raw(self.child.id().try_into().unwrap());
        nix::sys::signal::kill(pid, signal).unwrap();
    }

    fn interrupt(mut self) -> Option<i32> {
        self.signal(nix::sys::signal::Signal::SIGINT);
        self.child.wait().unwrap().code()
    }
}

impl Drop for Printing {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

#[test]
fn every_edit_is_noticed_once() {
    let tree = tree();
    let watch = Printing::start(&mut tree.command(&["watch", "--no-serve"]));
    watch.until("2 judged: 2 match");
    watch.expect_silence();
    let edit = |file: &str, what: &dyn Fn(&Path), expected: &str| {
        what(&tree.path(file));
        let said = watch.until(" judged: ");
        assert!(said.contains(&format!("{file} changed")), "{file}: {said}");
        assert!(said.contains(expected), "{file}: {said}");
    };
    let write = |text: String| move |path: &Path| fs::write(path, &text).unwrap();
    edit("fixtures/a.ron", &write(flat()), "1 match, 1 stale golden");
    edit("fixtures/a.ron", &write("(".to_owned()), "1 match, 1 render refused");
    edit("fixtures/a.ron", &write(SQUARE.to_owned()), "2 match");
    edit("fixtures/b.obj", &write(MESH.replace("1 1 0", "1 0 0")), "1 stale golden");
    edit("fixtures/b.obj", &write(MESH.to_owned()), "2 match");
    let golden = fs::read(tree.path("golden/a.png")).unwrap();
    edit("golden/a.png", &|path| fs::remove_file(path).unwrap(), "1 missing golden");
    edit("golden/a.png", &|path| fs::write(path, &golden).unwrap(), "2 match");
    // As editors do: written beside it, then renamed into the place.
    let rename = |path: &Path| {
        let beside = path.with_extension("ron.swp");
        fs::write(&beside, flat()).unwrap();
        fs::rename(beside, path).unwrap();
    };
    edit("fixtures/a.ron", &rename, "1 stale golden");
    // A storm of writes is one edit.
    let storm = |path: &Path| {
        for i in 0..20 {
            fs::write(path, format!("// {i}\n{SQUARE}")).unwrap();
            std::thread::sleep(Duration::from_millis(10));
        }
    };
    edit("fixtures/a.ron", &storm, "2 match");
    watch.expect_silence();
    let create = |path: &Path| {
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, SQUARE).unwrap();
    };
    edit("fixtures/deep/er/c.ron", &create, "3 judged: 2 match, 1 missing golden");
    edit("fixtures/deep/er/c.ron", &|path| fs::remove_file(path).unwrap(), "2 judged: 2 match");
    // Of no concern, its own files among them.
    tree.write("fixtures/notes.txt", b"x");
    tree.write("fixtures/.a.ron.swp", b"x");
    tree.write("golden/.goldray-x.tmp", b"x");
    tree.write("target/goldray/a.png", b"x");
    tree.write("target/goldray-cache/matches.json", b"x");
    watch.expect_silence();
    // A suite that cannot be judged is waited for.
    tree.write("fixtures/c.RON", b"x");
    watch.until("c.RON: expected the ending .ron");
    fs::remove_file(tree.path("fixtures/c.RON")).unwrap();
    watch.until("2 judged: 2 match");
    assert_eq!(watch.interrupt(), Some(0));
}

#[test]
fn a_filter_and_its_end_are_those_of_check() {
    let tree = tree();
    tree.run(&["watch", "nowhere"]).expect_code(2).expect("selects nothing");
    fs::remove_file(tree.path("golden/a.png")).unwrap();
    let watch = Printing::start(&mut tree.command(&["watch", "--no-serve", "a"]));
    watch.until("1 judged: 1 missing golden");
    assert_eq!(watch.interrupt(), Some(1));
}

#[test]
fn the_page_is_loaded_anew_and_decides() {
    let tree = tree();
    let mut served = Served::start(&mut tree.command(&["watch"]));
    let page = served.get("").body;
    assert!(page.contains("\"kind\":\"watch\"") && page.contains("\"green\":true"));
    let mut tab = served.tab();
    let (_, first, _) = tab.expect("state");
    tree.write("fixtures/a.ron", flat().as_bytes());
    let (_, second, _) = tab.expect("reload");
    assert_ne!(first, second);
    // One that was loading when it was replaced hears of it as well.
    assert_eq!(served.tab_that_has_seen(Some(&first)).expect("reload").1, second);
    served.tab_that_has_seen(Some(&second)).expect("state");
    assert!(served.get("").body.contains("\"green\":false"));
    served.tab().expect("state");

    // An acceptance is no edit: nothing is checked, the tab keeps its place.
    let before = files(tree.0.path());
    served.post("accept", &["a"]);
    assert_eq!(changed(&before, &files(tree.0.path())), ["golden/a.png"]);
    assert!(tab.expect("state").2.contains("accepted"));
    std::thread::sleep(Duration::from_millis(1500));
    // What is edited next is, and the acceptance can still be taken back.
    tree.write("fixtures/b.ron", flat().as_bytes());
    tab.expect("reload");
    let page = served.get("").body;
    assert!(page.contains("\"match\":1") && page.contains("\"stale_golden\":1"), "{page}");
    let state = served.get("api/state").json();
    assert_eq!(state["decisions"], json!({"a": "accepted"}));
    assert_eq!(state["can_accept"], json!(["b"]));
    served.post("undo", &["a"]);
    assert_eq!(changed(&before, &files(tree.0.path())), ["fixtures/b.ron"]);

    // It goes on without tabs.
    drop(tab);
    std::thread::sleep(Duration::from_millis(3000));
    served.post("accept", &["b"]);
    served.interrupt();
    served.line_with("1 accepted, 0 rejected, 0 left");
    assert_eq!(served.end().0, Some(0));
}

/// A tree that looks like goldray's own, with a stand-in for cargo that does
/// what `build.sh` in it says.
fn repository(build: &str) -> Tree {
    let tree = tree();
    for file in ["Cargo.toml", "xtask/Cargo.toml", "crates/tracer/Cargo.toml"] {
        tree.write(file, b"");
    }
    tree.write("crates/tracer/src/lib.rs", b"");
    tree.write("cargo", b"#!/bin/sh\necho \"$$ $TMPDIR\" > pid\n. ./build.sh\n");
    tree.write("build.sh", build.as_bytes());
    let mode = std::os::unix::fs::PermissionsExt::from_mode(0o755);
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
        let mode = std::os::unix::fs::PermissionsExt::from_mode(0o755);
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
    assert_eq!(served.tab_that_has_seen(Some(&second)).expect("reload").1.len(), 32);
    let link = fs::read_link(format!("/proc/{}/exe", served.child.id()));
    if let Ok(link) = link {
        assert_eq!(link, tree.path("another").canonicalize().unwrap(), "the same process");
    }
    served.post("accept", &["a"]);
    served.interrupt();
    assert_eq!(served.end().0, Some(0));
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
        // A process that has ended may wait to be noticed by who started it.
        let state = fs::read_to_string(format!("/proc/{pid}/stat")).unwrap_or_default();
        let is_gone = nix::sys::signal::kill(pid, None).is_err() || state.contains(") Z ");
        assert!(is_gone, "{pid} runs on: {state}");
    }
    assert!(!Path::new(&scratch).exists(), "{scratch} is left");
    assert_eq!(changed(&before, &files(tree.0.path())), ["crates/tracer/src/lib.rs", "pid"]);
}

#[test]
fn ctrl_c_in_the_middle_of_a_check_leaves_nothing_half_written() {
    let fixtures: Vec<_> = (0..300).map(|i| format!("f{i:03}")).collect();
    let fixtures: Vec<_> = fixtures.iter().map(|name| (name.as_str(), SQUARE)).collect();
    let tree = Tree::new(&fixtures);
    for pause in [0, 100, 300, 600] {
        let _ = fs::remove_dir_all(tree.path("target"));
        let watch = Printing::start(&mut tree.command(&["watch", "--no-serve"]));
        let artifacts = tree.path("target/goldray");
        while !artifacts.is_dir() {
            std::thread::sleep(Duration::from_millis(1));
        }
        std::thread::sleep(Duration::from_millis(pause));
        assert_eq!(watch.interrupt(), Some(1));
        let names = fs::read_dir(&artifacts).unwrap().map(|entry| entry.unwrap().file_name());
        let half: Vec<_> = names.filter(|name| name.to_string_lossy().ends_with(".tmp")).collect();
        assert!(half.is_empty(), "after {pause} ms: {half:?}");
    }
}

#[test]
fn every_crate_that_the_program_is_built_from_is_watched() {
    use std::collections::{BTreeMap, BTreeSet};
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
