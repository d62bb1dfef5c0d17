//! `review` as the real binary serves it: what is accepted is what was shown, and
//! nothing else is written.
#![allow(clippy::unwrap_used, clippy::disallowed_methods)]

mod browser;
mod tree;

use std::fs;
use std::io::{Read, Write};
use std::time::{Duration, Instant};

use browser::{Served, changed, files};
use serde_json::json;
use tree::{SQUARE, Tree};

fn review(tree: &Tree) -> Served {
    Served::start(&mut tree.command(&["review"]))
}

#[test]
fn accepting_changes_one_golden_and_undoing_changes_it_back() {
    let tree = Tree::failing();
    let before = files(tree.0.path());
    let served = review(&tree);
    assert_eq!(changed(&before, &files(tree.0.path())), [""; 0], "looking writes nothing");
    let can_accept = json!(["add/ed", "changed", "gone"]);
    let first = json!({
        "schema": 1, "decisions": {}, "can_accept": can_accept, "can_undo": [], "messages": []
    });
    assert_eq!(served.get("api/state").json(), first);
    for (name, file) in [
        ("add/ed", "golden/add/ed.png"),
        ("changed", "golden/changed.png"),
        ("gone", "golden/gone.png"),
    ] {
        let state = served.post("accept", &[name]);
        assert_eq!(state["decisions"], json!({name: "accepted"}), "{state}");
        assert_eq!(state["messages"], json!([]));
        assert_eq!(changed(&before, &files(tree.0.path())), [file]);
        assert_eq!(served.post("undo", &[name]), first);
        assert_eq!(changed(&before, &files(tree.0.path())), [""; 0]);
    }
    let state = served.post("accept", &["same", "broken", "add/ed", "nowhere"]);
    assert_eq!(state["decisions"], json!({"add/ed": "accepted"}));
    let said: Vec<_> = state["messages"].as_array().unwrap().iter().collect();
    assert_eq!(said.len(), 3, "{state}");
    assert_eq!(changed(&before, &files(tree.0.path())), ["golden/add/ed.png"]);
    let state = served.post("reject", &["changed", "add/ed"]);
    assert_eq!(state["decisions"], json!({"add/ed": "rejected", "changed": "rejected"}));
    assert_eq!(changed(&before, &files(tree.0.path())), [""; 0]);
}

#[test]
fn what_moved_since_it_was_shown_is_not_accepted() {
    let tree = Tree::failing();
    let served = review(&tree);
    let other = fs::read(tree.path("golden/same.png")).unwrap();
    tree.write("golden/changed.png", b"mine");
    tree.write("golden/add/ed.png", &other);
    tree.write("fixtures/gone.ron", SQUARE.as_bytes());
    let before = files(tree.0.path());
    for name in ["changed", "add/ed", "gone"] {
        let state = served.post("accept", &[name]);
        assert_eq!(state["decisions"], json!({}));
        let said = state["messages"][0].as_str().unwrap();
        assert!(said.contains(name) && said.contains("changed since it was shown"), "{said}");
    }
    assert_eq!(changed(&before, &files(tree.0.path())), [""; 0]);
    // Nor is a golden lost that somebody wrote over what was accepted.
    fs::remove_file(tree.path("golden/add/ed.png")).unwrap();
    served.post("accept", &["add/ed"]);
    tree.write("golden/add/ed.png", b"mine");
    let state = served.post("undo", &["add/ed"]);
    assert_eq!(state["decisions"], json!({"add/ed": "accepted"}));
    assert!(state["messages"][0].as_str().unwrap().contains("no longer what was accepted"));
    assert_eq!(fs::read(tree.path("golden/add/ed.png")).unwrap(), b"mine");
}

#[test]
fn tabs_hear_of_each_other_and_the_last_one_ends_it() {
    let tree = Tree::failing();
    let served = review(&tree);
    let (mut a, mut b) = (served.tab(), served.tab());
    for tab in [&mut a, &mut b] {
        assert!(tab.expect("state").2.contains("\"decisions\":{}"));
    }
    served.post("reject", &["broken"]);
    served.post("accept", &["nowhere"]);
    served.post("accept", &["changed"]);
    for tab in [&mut a, &mut b] {
        assert!(tab.expect("state").2.contains(r#""decisions":{"broken":"rejected"}"#));
        let state = tab.expect("state").2;
        assert!(state.contains(r#"{"broken":"rejected","changed":"accepted"}"#), "{state}");
    }
    // Two at once: both hold.
    std::thread::scope(|scope| {
        for name in ["add/ed", "gone"] {
            let served = &served;
            scope.spawn(move || served.post("accept", &[name]));
        }
    });
    let state = served.get("api/state").json();
    assert_eq!(state["decisions"].as_object().unwrap().len(), 4, "{state}");
    drop(a);
    // Loaded anew: the stream closes, the page is asked for and its stream opens.
    drop(b);
    std::thread::sleep(Duration::from_secs(1));
    assert_eq!(served.get("").status, 200);
    std::thread::sleep(Duration::from_millis(2500));
    let mut again = served.tab();
    assert!(again.expect("state").2.contains("accepted"), "decisions are not the page's");
    std::thread::sleep(Duration::from_millis(2500));
    assert_eq!(served.get("api/state").status, 200, "somebody is there");
    drop(again);
    let closed = Instant::now();
    let (code, said) = served.end();
    assert!(closed.elapsed() > Duration::from_secs(1));
    assert_eq!(code, Some(1), "one is rejected\n{said}");
    for line in [
        "accepted  add/ed",
        "accepted  changed",
        "accepted  gone",
        "rejected  broken",
        "3 accepted, 1 rejected, 0 left",
    ] {
        assert!(said.contains(line), "{said}");
    }
    assert!(!said.contains("left  "), "{said}");
    fs::remove_file(tree.path("fixtures/broken.ron")).unwrap();
    tree.run(&["check"]).expect_code(0);
}

#[test]
fn a_page_that_is_still_sent_has_somebody_before_it() {
    let tree = Tree::failing();
    let served = review(&tree);
    // Who only fetches it keeps it waiting.
    assert_eq!(served.get("").status, 200);
    std::thread::sleep(Duration::from_secs(11));
    let mut slow = served.connect();
    let head = format!("GET /{}/ HTTP/1.1\r\nHost: {}\r\n\r\n", served.token, served.host());
    slow.write_all(head.as_bytes()).unwrap();
    slow.read_exact(&mut [0; 100]).unwrap();
    drop(served.tab());
    std::thread::sleep(Duration::from_secs(4));
    assert_eq!(served.get("api/state").status, 200, "it is on its way");
    drop(slow);
    assert_eq!(served.end().0, Some(1));
}

#[test]
fn what_moved_since_it_was_accepted_is_left() {
    let tree = Tree::failing();
    let golden = fs::read(tree.path("golden/changed.png")).unwrap();
    let served = Served::start(&mut tree.command(&["review", "changed"]));
    served.post("accept", &["changed"]);
    tree.write("golden/changed.png", &golden);
    drop(served.tab());
    let (code, said) = served.end();
    assert_eq!(code, Some(1), "{said}");
    assert!(said.contains("left      changed\n0 accepted, 0 rejected, 1 left"), "{said}");
}

#[test]
fn it_says_yes_if_all_was_accepted() {
    let tree = Tree::failing();
    let served = Served::start(&mut tree.command(&["review", "changed"]));
    let state = served.post("accept", &["changed", "add/ed"]);
    assert_eq!(state["decisions"], json!({"changed": "accepted"}), "what was not asked for");
    drop(served.tab());
    assert_eq!(served.end().0, Some(0));
}

#[cfg(unix)]
#[test]
fn ctrl_c_ends_it_and_leaves_nothing_half_done() {
    let tree = Tree::failing();
    let before = files(tree.0.path());
    let served = review(&tree);
    let _tab = served.tab();
    served.post("accept", &["changed"]);
    served.interrupt();
    let (code, said) = served.end();
    assert_eq!(code, Some(1), "{said}");
    assert!(said.contains("1 accepted, 0 rejected, 3 left"), "{said}");
    assert_eq!(changed(&before, &files(tree.0.path())), ["golden/changed.png"]);
}

#[cfg(target_os = "linux")]
#[test]
fn what_is_opened_keeps_the_token_from_others() {
    use std::os::unix::fs::PermissionsExt;
    let tree = Tree::failing();
    let program = b"#!/bin/sh\necho \"$*\" > asked.new\nmv asked.new asked\n";
    tree.write("bin/xdg-open", program);
    fs::set_permissions(tree.path("bin/xdg-open"), PermissionsExt::from_mode(0o755)).unwrap();
    let path = format!("{}:{}", tree.path("bin").display(), std::env::var("PATH").unwrap());
    let served = Served::start(tree.command(&["review", "--open"]).env("PATH", path));
    while !tree.path("asked").exists() {
        std::thread::sleep(Duration::from_millis(10));
    }
    let asked = fs::read_to_string(tree.path("asked")).unwrap();
    assert!(!asked.contains(&served.token), "{asked}");
    let file = std::path::PathBuf::from(asked.trim_end());
    let url = format!("http://{}/{}/", served.host(), served.token);
    assert!(fs::read_to_string(&file).unwrap().contains(&url));
    let mode = |path: &std::path::Path| fs::metadata(path).unwrap().permissions().mode() & 0o777;
    assert_eq!(mode(file.parent().unwrap()), 0o700, "nobody else gets at the file");
    drop(served.tab());
    assert_eq!(served.end().0, Some(1));
    assert!(!file.parent().unwrap().exists(), "it is left");
}

#[test]
fn there_is_not_always_something_to_review() {
    let tree = Tree::blessed(&[("a", SQUARE)]);
    tree.run(&["review"]).expect_code(0).expect("1 match").expect("there is nothing to review");
    tree.run(&["review", "nowhere"]).expect_code(2).expect("selects nothing");
    for verb in ["review", "watch"] {
        let ran = tree.run_with(&[verb], &[("CI", "true")]).expect_code(2);
        ran.expect(&format!("{verb}: expected to run by hand, found the variable CI set"));
    }
}
