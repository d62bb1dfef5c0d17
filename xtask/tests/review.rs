//! `review` as the real binary serves it: what is accepted is what was shown, by
//! nobody but its own page, and nothing else is written.
#![allow(clippy::unwrap_used, clippy::panic, clippy::disallowed_methods)]

mod browser;
mod tree;

use std::fs;
use std::net::{TcpStream, UdpSocket};
use std::process::Stdio;
use std::time::{Duration, Instant};

use browser::{Served, changed, files};
use serde_json::json;
use tree::{Ran, SQUARE, Tree};

/// A square whose upper half is gone.
fn flat() -> String {
    SQUARE.replace("(1, 1, 1)", "(1, 0.5, 1)")
}

/// `add/ed` has no golden, `broken` breaks its word, `changed` has another
/// scene's golden, `gone` no fixture, `same` is a match.
fn tree() -> Tree {
    let tree = Tree::blessed(&[("changed", SQUARE), ("gone", SQUARE), ("same", SQUARE)]);
    fs::remove_file(tree.path("fixtures/gone.ron")).unwrap();
    tree.write("fixtures/changed.ron", flat().as_bytes());
    tree.write("fixtures/add/ed.ron", SQUARE.as_bytes());
    let broken = "check: (expect: [Radiance(at: (0, 0), rgb: (9, 9, 9))]), image";
    tree.write("fixtures/broken.ron", SQUARE.replace("image", broken).as_bytes());
    tree
}

fn review(tree: &Tree) -> Served {
    Served::start(&mut tree.command(&["review"]))
}

#[test]
fn accepting_changes_one_golden_and_undoing_changes_it_back() {
    let tree = tree();
    let before = files(tree.0.path());
    let served = review(&tree);
    assert_eq!(changed(&before, &files(tree.0.path())), [""; 0], "looking writes nothing");
    let can_accept = json!(["add/ed", "changed", "gone"]);
    let first = json!({"schema": 1, "decisions": {}, "can_accept": can_accept, "messages": []});
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
    let tree = tree();
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
        assert!(said.contains(name) && said.contains("expected "), "{said}");
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
fn nobody_but_its_own_page_decides() {
    let tree = tree();
    let before = files(tree.0.path());
    let served = review(&tree);
    let (token, ours) = (served.token.clone(), served.page_headers());
    let body = r#"{"names":["changed"]}"#;
    let post = format!("POST /{token}/api/accept");
    let without =
        |name: &str| ours.iter().filter(|header| header.0 != name).cloned().collect::<Vec<_>>();
    let with =
        |name: &'static str, value: &str| [without(name), vec![(name, value.to_owned())]].concat();
    #[track_caller]
    fn check(answer: &browser::Answer, status: u16) {
        assert_eq!(answer.status, status, "{answer:?}");
        assert!(!answer.body.contains("changed"), "nothing is told: {answer:?}");
    }
    let refused = |line: &str, headers: &[_], body: &str, status| {
        check(&served.request(line, headers, body), status);
    };

    for path in ["", "/", "//api/state", "/favicon.ico", "/api/accept", &format!("/{token}")] {
        refused(&format!("GET {path}"), &ours, "", if path.is_empty() { 400 } else { 404 });
    }
    let wrong = token.chars().rev().collect::<String>();
    for token in [&wrong, &token[1..], &format!("{token}0"), &token.to_uppercase(), "", "..%2f"] {
        refused(&format!("POST /{token}/api/accept"), &ours, body, 404);
        refused(&format!("GET /{token}/events"), &ours, "", 404);
    }
    for path in ["api/nothing", "api/accept/", "..%2fgolden/same.png", "../same", "golden/same.png"]
    {
        refused(&format!("GET /{token}/{path}"), &ours, "", 404);
        refused(&format!("POST /{token}/{path}"), &ours, body, 404);
    }
    for (method, path) in [
        ("GET", "api/accept"),
        ("PUT", "api/undo"),
        ("POST", "api/state"),
        ("POST", ""),
        ("DELETE", "events"),
        ("HEAD", ""),
        ("OPTIONS", "api/accept"),
    ] {
        refused(&format!("{method} /{token}/{path}"), &ours, body, 405);
    }
    for host in
        ["goldray.example", "127.0.0.1", "127.0.0.1:1", "", &format!("a.127.0.0.1:{}", served.port)]
    {
        refused(&post, &with("Host", host), body, 403);
        refused(&format!("GET /{token}/"), &with("Host", host), "", 403);
    }
    refused(&post, &without("Host"), body, 403);
    refused(&post, &[with("Host", "goldray.example"), vec![ours[0].clone()]].concat(), body, 400);
    for origin in [
        "null",
        "http://goldray.example",
        "https://127.0.0.1",
        &format!("http://localhost:{}", served.port),
        &format!("http://127.0.0.1:{}.example", served.port),
    ] {
        refused(&post, &with("Origin", origin), body, 403);
    }
    refused(&post, &without("Origin"), body, 403);
    for site in ["cross-site", "same-site", "none"] {
        refused(&post, &with("Sec-Fetch-Site", site), body, 403);
    }
    for kind in ["text/plain", "application/x-www-form-urlencoded", "multipart/form-data"] {
        refused(&post, &with("Content-Type", kind), body, 415);
    }
    refused(&post, &without("Content-Type"), body, 415);
    for body in [
        "",
        "{",
        "[\"x\"]",
        "{\"names\":\"x\"}",
        "{\"names\":[1]}",
        "names=x",
        "{\"names\":[\"x\"],\"force\":true}",
    ] {
        refused(&post, &ours, body, 400);
    }
    refused(&post, &ours, &"x".repeat((1 << 20) + 1), 413);
    let head = ours.iter().map(|(name, value)| format!("{name}: {value}\r\n")).collect::<String>();
    let send = |more: &str, status| {
        check(&served.send(format!("{post} HTTP/1.1\r\n{head}{more}").as_bytes()), status);
    };
    send("Content-Length: 99999999999999999999999\r\n\r\n", 413);
    send("Content-Length: -1\r\n\r\n", 400);
    send("Content-Length: 2\r\nContent-Length: 3\r\n\r\n{}", 400);
    send("Transfer-Encoding: chunked\r\n\r\n0\r\n\r\n", 411);
    send("\r\n", 411);
    send(&format!("X: {}\r\n\r\n", "x".repeat(1 << 16)), 431);
    check(&served.send(b"\x16\x03\x01\x02\x00 hello\r\n\r\n"), 400);

    // What comes to a decision, and is none.
    for name in [
        "same",
        "nowhere",
        "../changed",
        "..%2fchanged",
        "changed.ron",
        "fixtures/changed",
        "",
        "/etc/passwd",
        "CHANGED",
    ] {
        let state = served.post("accept", &[name]);
        assert_eq!(state["decisions"], json!({}), "{name}");
        assert_eq!(state["messages"].as_array().unwrap().len(), 1, "{name}");
        assert_eq!(served.post("undo", &[name])["decisions"], json!({}));
    }
    assert_eq!(changed(&before, &files(tree.0.path())), [""; 0]);
    let local = served.request(
        &post,
        &[
            ("Host", format!("localhost:{}", served.port)),
            ("Origin", format!("http://localhost:{}", served.port)),
            ours[3].clone(),
        ],
        body,
    );
    assert_eq!(local.status, 200, "the other name of this machine");
    assert_eq!(changed(&before, &files(tree.0.path())), ["golden/changed.png"]);
}

#[test]
fn only_this_machine_is_answered() {
    let tree = tree();
    let served = review(&tree);
    // No packet is sent; it is only asked by which address one would be.
    let socket = UdpSocket::bind("0.0.0.0:0").unwrap();
    let _ = socket.connect("192.0.2.1:9");
    match socket.local_addr().map(|address| address.ip()) {
        Ok(ip) if !ip.is_loopback() && !ip.is_unspecified() => {
            assert!(TcpStream::connect((ip, served.port)).is_err(), "{ip} is answered");
        }
        found => println!("skipped: this machine has no other address ({found:?})"),
    }
}

#[test]
fn the_page_is_kept_from_others() {
    let tree = tree();
    let served = review(&tree);
    let page = served.get("");
    assert_eq!(page.status, 200);
    assert!(page.body.contains("\"kind\":\"review\""), "{}", page.body);
    assert!(page.body.contains("add/ed"));
    for header in [
        "Content-Security-Policy: default-src 'none'; ",
        "frame-ancestors 'none'",
        "connect-src 'self'",
        "X-Content-Type-Options: nosniff",
        "X-Frame-Options: DENY",
        "Referrer-Policy: no-referrer",
        "Cache-Control: no-store",
        "Cross-Origin-Resource-Policy: same-origin",
        "Cross-Origin-Opener-Policy: same-origin",
        "Content-Type: text/html; charset=utf-8",
    ] {
        for answer in [&page, &served.get("api/state"), &served.get("nothing")] {
            let is_page = !header.starts_with("Content-Type")
                || answer.status == 200 && answer.head.contains("text/html");
            assert!(!is_page || answer.head.contains(header), "{header}: {}", answer.head);
        }
        assert!(!page.head.contains("Access-Control"), "{}", page.head);
    }
    let (_, nonce) = page.head.split_once("script-src 'nonce-").unwrap();
    let nonce = nonce.split('\'').next().unwrap();
    let script = format!("<script nonce=\"{nonce}\">");
    assert_eq!(page.body.matches(&script).count(), 1, "its script runs");
    assert!(!page.body.contains("<script>") && !page.head.contains("script-src 'unsafe"));
    let (a, b) = (served.token.clone(), review(&tree).token.clone());
    assert!(a.len() == 32 && a != b, "another token each time");
}

#[test]
fn tabs_hear_of_each_other_and_the_last_one_ends_it() {
    let tree = tree();
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
    std::thread::sleep(Duration::from_millis(1000));
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
fn it_says_yes_if_all_was_accepted() {
    let tree = tree();
    let served = Served::start(&mut tree.command(&["review", "changed"]));
    let state = served.post("accept", &["changed", "add/ed"]);
    assert_eq!(state["decisions"], json!({"changed": "accepted"}), "what was not asked for");
    drop(served.tab());
    assert_eq!(served.end().0, Some(0));
}

#[test]
fn who_is_stuck_keeps_nobody_waiting() {
    use std::io::Write;
    let tree = tree();
    let served = review(&tree);
    let stuck: Vec<_> = (0..100)
        .map(|i| {
            let mut stream = served.connect();
            // Nothing, half a request, or one whose body does not come.
            let half = format!(
                "POST /{}/api/accept HTTP/1.1\r\nHost: {}\r\n",
                served.token,
                served.host()
            );
            let text = [String::new(), half.clone(), format!("{half}Content-Length: 9\r\n\r\n")];
            stream.write_all(text[i % 3].as_bytes()).unwrap();
            stream
        })
        .collect();
    let started = Instant::now();
    assert_eq!(served.get("api/state").status, 200);
    assert!(started.elapsed() < Duration::from_secs(4), "{:?}", started.elapsed());
    drop(served.tab());
    let (code, _) = served.end();
    assert_eq!(code, Some(1));
    drop(stuck);
}

#[cfg(unix)]
#[test]
fn ctrl_c_ends_it_and_leaves_nothing_half_done() {
    let tree = tree();
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

/// Presses these keys.
fn press(tree: &Tree, keys: &str, variables: &[(&str, &str)]) -> Ran {
    use std::io::Write;
    let mut command = tree.command(&["review", "--tty"]);
    command.envs(variables.iter().copied()).env_remove("NO_COLOR");
    command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = command.spawn().unwrap();
    child.stdin.take().unwrap().write_all(keys.as_bytes()).unwrap();
    Ran(child.wait_with_output().unwrap())
}

#[test]
fn in_the_terminal_keys_decide() {
    let tree = tree();
    let before = files(tree.0.path());
    let now = || files(tree.0.path());
    let ran = press(&tree, "?x", &[]).expect_code(1);
    let ran = ran.expect("[1/4] add/ed: missing golden").expect("u: take the last decision back");
    ran.expect("0 accepted, 0 rejected, 4 left");
    assert_eq!(changed(&before, &now()), [""; 0]);
    // Accept, accept what cannot be, skip it, go back, reject it, and stop.
    let ran = press(&tree, "aasprq", &[]).expect_code(1);
    let ran = ran.expect("accepted add/ed").expect("broken is not accepted: ");
    let ran = ran.expect("[2/4] broken: missing golden").expect("cannot be accepted: ");
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
    let tree = tree();
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
