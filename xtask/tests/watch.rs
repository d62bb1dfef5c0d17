//! `watch` as the real binary does it: every kind of edit is noticed once, what
//! it writes itself is none, and it leaves nothing behind.
#![cfg(unix)]
#![allow(clippy::unwrap_used, clippy::disallowed_methods)]

mod browser;
mod tree;

use std::fs;
use std::path::Path;
use std::time::{Duration, Instant};

use browser::{Printing, Served, changed, files};
use serde_json::json;
use tree::{SQUARE, Tree, flat};

const MESH: &str = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nf 1 2 3 4\n";

fn tree() -> Tree {
    let mesh = SQUARE.replace("Box(min: (-1, -1, -1), max: (1, 1, 1))", "Mesh(file: \"b.obj\")");
    let tree = Tree::new(&[("a", SQUARE), ("b", &mesh)]);
    tree.write("fixtures/b.obj", MESH.as_bytes());
    tree.run(&["bless", "--all"]).expect_code(0);
    tree
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
    assert_eq!(fs::read(tree.path("golden/a.png")).unwrap(), golden);
    edit("fixtures/a.ron", &write(SQUARE.to_owned()), "2 match");
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
    tree.write("fixtures/c.RON", b"x");
    watch.until("c.RON: expected the ending .ron");
    assert_eq!(watch.interrupt(), Some(2), "nobody knows");
}

#[test]
fn a_storm_of_writes_is_one_edit() {
    let tree = tree();
    let watch = Printing::start(&mut tree.command(&["watch", "--no-serve"]));
    watch.until("2 judged: 2 match");
    // So long that it is looked at several times.
    let started = Instant::now();
    let (mut count, mut pauses, mut last) = (0, 0, started);
    while started.elapsed() < Duration::from_millis(1800) {
        count += 1;
        tree.write("fixtures/a.ron", format!("// {count}\n{SQUARE}").as_bytes());
        // A machine with much to do pauses the storm itself, which may be taken for its end.
        pauses += usize::from(last.elapsed() > Duration::from_millis(50));
        last = Instant::now();
        std::thread::sleep(Duration::from_millis(2));
    }
    watch.until("fixtures/a.ron changed");
    watch.until(" judged: ");
    let more = watch.lines_of(Duration::from_secs(2));
    let again = more.iter().filter(|line| line.contains("judged")).count();
    // One may be seen beginning.
    assert!(again <= 1 + pauses, "{count} writes, {pauses} pauses, were {} edits", again + 1);
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
    assert_eq!(served.tab_of(Some(&first)).expect("reload").1, second);
    served.tab_of(Some(&second)).expect("state");
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

    // That was said to be a match.
    tab.expect("state");
    tab.expect("reload");
    let state = served.post("accept", &["a"]);
    assert_eq!(
        (&state["decisions"], &state["can_accept"]),
        (&json!({"a": "accepted"}), &json!(["b"]))
    );
    // It goes on without tabs.
    drop(tab);
    std::thread::sleep(Duration::from_secs(3));
    served.post("accept", &["b"]);
    served.interrupt();
    served.line_with("2 accepted, 0 rejected, 0 left");
    assert_eq!(served.end().0, Some(0));
}

#[test]
fn a_golden_that_is_put_back_later_is_checked() {
    let tree = tree();
    tree.write("fixtures/a.ron", flat().as_bytes());
    let mut served = Served::start(&mut tree.command(&["watch"]));
    served.post("accept", &["a"]);
    let accepted = fs::read(tree.path("golden/a.png")).unwrap();
    std::thread::sleep(Duration::from_secs(1));
    tree.write("fixtures/a.ron", SQUARE.as_bytes());
    served.line_with("1 stale golden");
    tree.run(&["bless", "a"]).expect_code(0);
    served.line_with("2 judged: 2 match");
    tree.write("golden/a.png", &accepted);
    served.line_with("golden/a.png changed");
    served.line_with("1 stale golden");
    served.interrupt();
    assert_eq!(served.end().0, Some(1));
}

#[test]
fn what_is_accepted_during_a_check_does_not_hide_it() {
    let tree = tree();
    tree.write("fixtures/a.ron", flat().as_bytes());
    let mut served = Served::start(&mut tree.command(&["watch"]));
    let first = served.edition();
    // It takes a while.
    let slow = SQUARE.replace("(16, 12)", "(1600, 1200), samples_per_pixel: 16");
    tree.write("fixtures/c.ron", slow.as_bytes());
    served.line_with("fixtures/c.ron changed");
    assert_eq!(served.post_of(&first, "accept", &["a"]).status, 200);
    let mut tab = served.tab_of(Some(&first));
    while tab.event().0 != "reload" {}
    assert!(served.get("").body.contains("\"missing_golden\":1"));
    assert_eq!(served.get("api/state").json()["decisions"], json!({"a": "accepted"}));
    // Of the page before, nothing is decided any more.
    let golden = fs::read(tree.path("golden/a.png")).unwrap();
    for what in ["undo", "accept"] {
        assert_eq!(served.post_of(&first, what, &["a", "c"]).status, 409);
    }
    assert_eq!(fs::read(tree.path("golden/a.png")).unwrap(), golden);
    assert!(!tree.path("golden/c.png").exists());
}

#[test]
fn nothing_is_decided_where_nothing_can_be_judged() {
    let tree = tree();
    tree.write("fixtures/a.ron", flat().as_bytes());
    let served = Served::start(&mut tree.command(&["watch"]));
    let mut tab = served.tab();
    tab.expect("state");
    tree.write("fixtures/c.RON", b"x");
    assert!(tab.expect("trouble").2.contains("expected the ending .ron"));
    let before = files(tree.0.path());
    let refused = served.post_of(&served.edition(), "accept", &["a"]);
    assert_eq!(refused.status, 503);
    assert!(refused.body.contains("expected the ending .ron"), "{refused:?}");
    assert_eq!(changed(&before, &files(tree.0.path())), [""; 0]);
    let mut other = served.tab();
    other.expect("state");
    other.expect("trouble");
    fs::remove_file(tree.path("fixtures/c.RON")).unwrap();
    tab.expect("reload");
    served.post("accept", &["a"]);
    assert_eq!(changed(&before, &files(tree.0.path())), ["fixtures/c.RON", "golden/a.png"]);
    tree.write("fixtures/c.RON", b"x");
    tab.expect("state");
    tab.expect("trouble");
    served.interrupt();
    assert_eq!(served.end().0, Some(2));
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
