//! `conform` and what is there already: results of earlier runs, adapters, other
//! people's files, somebody who reads along or wants it to end.
#![cfg(unix)]
#![allow(clippy::unwrap_used, clippy::panic, clippy::disallowed_methods)]

mod tree;

use std::fs;
use std::io::{BufRead as _, BufReader};
use std::process::{Child, Stdio};
use std::time::Duration;

use tree::{Ran, SQUARE, Tree};

const RIGHT: &str = "\"$1\" render \"$2\" --out \"$3\"";

/// A suite of `a`, `b` and `c`, with an adapter in `adapters/NAME.ron` for each script,
/// which lies in `adapters/NAME.sh`: `$1` is goldray, `$2` the scene, `$3` the picture.
fn suite(renderers: &[(&str, &str, &str)]) -> Tree {
    let tree = Tree::blessed(&[("a", SQUARE), ("b", &tree::flat()), ("c", SQUARE)]);
    for (name, script, more) in renderers {
        renderer(&tree, &format!("adapters/{name}"), script, more);
    }
    tree
}

fn renderer(tree: &Tree, path: &str, script: &str, more: &str) {
    let (_, name) = path.rsplit_once('/').unwrap_or(("", path));
    tree.write(&format!("{path}.sh"), script.as_bytes());
    let adapter = format!(
        "(name: \"{name}\", command: [\"sh\", \"{{folder}}/{name}.sh\", \"{{self}}\", \"{{scene}}\", \
         \"{{output}}\"], scene: Ron, {more})"
    );
    tree.write(&format!("{path}.ron"), adapter.as_bytes());
}

#[test]
fn nothing_goes_away_before_all_renderers_are_found() {
    let tree = suite(&[
        ("right", RIGHT, ""),
        ("crooked", RIGHT, "tolerance: 9"),
        ("mute", RIGHT, "version: [\"false\"]"),
    ]);
    tree.run(&["conform", "--renderer", "right"]).expect_code(0);
    let results = tree.path("target/goldray-conform/right/results.json");
    let before = fs::read(&results).unwrap();
    for other in ["crooked", "mute", "nobody", "adapters/right.ron"] {
        tree.run(&["conform", "--renderer", "right", "--renderer", other]).expect_code(2);
        assert!(fs::read(&results).is_ok_and(|found| found == before), "{other}");
    }
    // Neither where the folder of another one is somebody's own.
    tree.write("target/goldray-conform/crooked/thesis.txt", b"mine");
    renderer(&tree, "adapters/crooked", RIGHT, "");
    tree.run(&["conform", "--renderer", "right", "--renderer", "crooked"])
        .expect_code(2)
        .expect("crooked: is in the way of the artifacts and was not made by goldray");
    assert!(fs::read(&results).is_ok_and(|found| found == before));
    // Neither where goldray itself is wrong.
    fs::remove_file(tree.path("golden/b.png")).unwrap();
    tree.run(&["conform", "--renderer", "right"]).expect_code(2);
    assert!(fs::read(&results).is_ok_and(|found| found == before));
}

#[test]
fn a_version_is_asked_for_in_a_folder_that_goes_away() {
    let version = "version: [\"sh\", \"-c\", \"echo 1.0 in $PWD for $TMPDIR; touch left\"]";
    let tree = suite(&[("loud", RIGHT, version)]);
    let ran = tree.run(&["conform", "--renderer", "loud", "a"]).expect_code(0);
    let stdout = ran.stdout();
    let said = stdout.lines().next().unwrap().strip_prefix("loud (1.0 in ").unwrap();
    let (there, temporary) = said.trim_end_matches(')').split_once(" for ").unwrap();
    assert!(!there.starts_with(&tree.path("").display().to_string()), "{there}");
    assert_eq!(there, temporary);
    assert!(!fs::exists(there).unwrap(), "{there}");
    assert!(!tree.path("target/goldray-conform/loud/left").exists());
}

#[test]
fn what_is_read_is_not_written_over() {
    let tree = suite(&[("right", RIGHT, "")]);
    renderer(&tree, "mine", RIGHT, "");
    // An adapter among results, as somebody might keep it who looked at an example.
    renderer(&tree, "card/inside/inside", RIGHT, "");
    tree.write("card/inside/CACHEDIR.TAG", b"Signature");
    let rubric = "(version: 1, title: \"R\", parts: [(name: \"p\", points: 1, fixtures: [\"a\"])])";
    tree.write("grades/grade.json", rubric.as_bytes());
    std::os::unix::fs::symlink("mine.ron", tree.path("link.json")).unwrap();
    let files = ["mine.ron", "mine.sh", "adapters/right.ron", "grades/grade.json", "golden/a.png"];
    let files = files.into_iter().chain(["fixtures/a.ron", "card/inside/inside.ron"]);
    let bytes: Vec<_> = files.map(|file| (file, fs::read(tree.path(file)).unwrap())).collect();
    let refused = |args: &[&str], expected: &str| {
        tree.run(args).expect_code(2).expect(expected);
        for (file, bytes) in &bytes {
            assert!(
                fs::read(tree.path(file)).is_ok_and(|found| found == *bytes),
                "{file} {args:?}"
            );
        }
    };
    let mine = ["conform", "--renderer", "./mine.ron", "--json"];
    let json = |file: &'static str| [&mine[..], &[file]].concat();
    refused(&json("mine.ron"), "mine.ron: is there, and may be a scene, an adapter or a rubric");
    refused(&json("mine.sh"), "mine.sh: is read by this run, and would be written over");
    refused(&json("link.json"), "link.json: is read by this run, and would be written over");
    refused(&json("adapters/new.json"), "expected a place outside of the suite's adapters/");
    refused(&json("fixtures/a.ron"), "fixtures/a.ron: ");
    refused(&json("golden/a.png"), "expected a place outside of the suite's golden/");
    refused(&["conform", "--renderer", "right", "--out", "adapters"], "the suite's adapters/");
    refused(&["sensitivity", "--markdown", "mine.ron"], "mine.ron: is there, and may be a scene");
    refused(&["check", "--json", "adapters/right.ron"], "adapters/right.ron: ");
    let grade =
        ["grade", "--renderer", "right", "--rubric", "grades/grade.json", "--out", "grades"];
    refused(&grade, "grades/grade.json: is read by this run, and would be written over");
    let inside = ["conform", "--renderer", "card/inside/inside.ron", "--out", "card"];
    refused(&inside, "is emptied for results, and ");
    // What is no input may be written over.
    tree.write("a.json", b"an earlier file");
    tree.run(&json("a.json")).expect_code(0);
    assert!(fs::read(tree.path("a.json")).unwrap().starts_with(b"["));
}

fn start(tree: &Tree, args: &[&str]) -> Child {
    tree.command(args).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap()
}

/// Waits for a file.
#[track_caller]
fn wait_for(child: &mut Child, path: &std::path::Path) {
    while !path.exists() {
        assert!(child.try_wait().unwrap().is_none(), "it has ended without {}", path.display());
        std::thread::sleep(Duration::from_millis(5));
    }
}

#[test]
fn a_failure_is_printed_while_others_are_rendered() {
    // The first fails, the second waits until that was read.
    let tree = suite(&[("slow", "", "timeout_s: 100")]);
    let read = tree.path("read").display().to_string();
    let once = tree.path("once").display().to_string();
    let script =
        format!("mkdir {once} && exit 7\nwhile [ ! -e {read} ]; do sleep 0.02; done\n{RIGHT}");
    tree.write("adapters/slow.sh", script.as_bytes());
    let mut child = start(&tree, &["conform", "--renderer", "slow"]);
    let mut lines = BufReader::new(child.stdout.take().unwrap()).lines();
    let line = lines.find(|line| line.as_ref().is_ok_and(|line| line.starts_with("crashed")));
    assert_eq!(line.unwrap().unwrap(), "crashed     a: it ended by exit status: 7");
    fs::write(read, "").unwrap();
    let rest: Vec<_> = lines.map(Result::unwrap).collect();
    assert!(rest.iter().any(|line| line.starts_with("slow: 2 pass, 1 crashed")), "{rest:?}");
    assert_eq!(child.wait().unwrap().code(), Some(1));
}

#[test]
fn lines_come_in_the_order_of_names_whoever_is_first() {
    let tree = suite(&[("late", "", "timeout_s: 100")]);
    // The first to begin is the last to end.
    let (once, done) = (tree.path("once").display().to_string(), tree.path("done"));
    let done = done.display();
    let script = format!(
        "if mkdir {once}; then while [ ! -e {done}2 ]; do sleep 0.02; done; exit 1; fi\n\
         mkdir {done}1 || mkdir {done}2; exit 2"
    );
    tree.write("adapters/late.sh", script.as_bytes());
    let ran = tree.run(&["conform", "--renderer", "late", "--jobs", "3"]).expect_code(1);
    let stdout = ran.stdout();
    let crashed = stdout.lines().filter_map(|line| line.strip_prefix("crashed     "));
    let names: Vec<_> = crashed.map(|line| line.split(':').next().unwrap()).collect();
    assert_eq!(names, ["a", "b", "c"], "{stdout}");
}

#[test]
fn who_reads_no_further_leaves_no_renderer_running() {
    let tree = suite(&[("slow", "", "timeout_s: 100")]);
    let (pid, gone) = (tree.path("pid"), tree.path("gone"));
    // The first fails once the flat one runs, whose end nobody waits for, and nobody reads.
    let script = format!(
        "if ! grep -q '0\\.5' \"$2\"; then while [ ! -e {0} -o ! -e {1} ]; do sleep 0.02; done; exit 7; fi\n\
         echo $$ > $$.new; mv $$.new {0}; sleep 1000",
        pid.display(),
        gone.display()
    );
    tree.write("adapters/slow.sh", script.as_bytes());
    let mut child = start(&tree, &["conform", "--renderer", "slow", "a", "b", "--jobs", "2"]);
    let mut stdout = BufReader::new(child.stdout.take().unwrap());
    stdout.read_line(&mut String::new()).unwrap();
    drop(stdout);
    fs::write(gone, "").unwrap();
    Ran(child.wait_with_output().unwrap()).expect_code(2);
    let pid = fs::read_to_string(pid).unwrap();
    let stat = fs::read_to_string(format!("/proc/{}/stat", pid.trim()));
    assert!(stat.is_err() || stat.unwrap().contains(") Z "), "{pid} still runs");
}

#[test]
fn ctrl_c_is_heard_while_references_are_rendered() {
    let tree = Tree::new(&[]);
    // Without goldens, so that a run that does not hear it ends by code 2.
    let large =
        SQUARE.replace("(16, 12)", "(640, 480)").replace("image", "samples_per_pixel: 64, image");
    for number in 0..300 {
        tree.write(&format!("fixtures/f{number:03}.ron"), large.as_bytes());
    }
    let started = tree.path("started");
    let version = format!("version: [\"sh\", \"-c\", \"echo 1; touch {}\"]", started.display());
    renderer(&tree, "adapters/right", RIGHT, &version);
    let mut child = start(&tree, &["conform", "--renderer", "right"]);
    wait_for(&mut child, &started);
    std::thread::sleep(Duration::from_millis(200));
    let own = nix::unistd::Pid::from_raw(child.id().cast_signed());
    nix::sys::signal::kill(own, nix::sys::signal::Signal::SIGINT).unwrap();
    let ran = Ran(child.wait_with_output().unwrap()).expect_code(130);
    ran.expect("rendering 300 fixtures").expect("interrupted: no renderer was asked for a picture");
}
