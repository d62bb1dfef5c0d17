//! Who may ask the server of `review`, and whose word it takes: each refusal by
//! the real binary, with every file as it was.
#![allow(clippy::unwrap_used, clippy::disallowed_methods)]

mod browser;
mod tree;

use std::collections::BTreeMap;
use std::io::{Read, Write};
use std::net::{TcpStream, UdpSocket};
use std::path::PathBuf;
use std::time::{Duration, Instant};

use browser::{Answer, Served, changed, files};
use serde_json::json;
use tree::Tree;

/// A review, and every file as it was.
struct Asked {
    tree: Tree,
    served: Served,
    before: BTreeMap<PathBuf, Vec<u8>>,
}

/// What would accept `changed`.
const BODY: &str = r#"{"names":["changed"]}"#;

type Headers = Vec<(&'static str, String)>;

impl Asked {
    fn new() -> Self {
        let tree = Tree::failing();
        let before = files(tree.0.path());
        let served = review(&tree);
        Self { tree, served, before }
    }

    /// What our own page sends, without these.
    fn without(&self, name: &str) -> Headers {
        self.served.page_headers().into_iter().filter(|header| header.0 != name).collect()
    }

    /// The same with another value.
    fn with(&self, name: &'static str, value: &str) -> Headers {
        [self.without(name), vec![(name, value.to_owned())]].concat()
    }

    /// That a request is refused so, and nothing is told.
    #[track_caller]
    fn refused(&self, line: &str, headers: &Headers, body: &str, status: u16) {
        Self::check(&self.served.request(line, headers, body), status);
    }

    #[track_caller]
    fn check(answer: &Answer, status: u16) {
        assert_eq!(answer.status, status, "{answer:?}");
        assert!(!answer.body.contains("changed"), "{answer:?}");
    }

    /// That an acceptance with these headers is refused so.
    #[track_caller]
    fn acceptance_refused(&self, headers: &Headers, body: &str, status: u16) {
        self.refused(&self.accept(), headers, body, status);
    }

    fn accept(&self) -> String {
        format!("POST /{}/api/accept", self.served.token)
    }

    /// That nothing was written, and our own page can still accept.
    #[track_caller]
    fn is_as_before(&self) {
        let now = || files(self.tree.0.path());
        assert_eq!(changed(&self.before, &now()), [""; 0]);
        self.served.post("accept", &["changed"]);
        assert_eq!(changed(&self.before, &now()), ["golden/changed.png"]);
    }
}

fn review(tree: &Tree) -> Served {
    Served::start(&mut tree.command(&["review"]))
}

#[test]
fn who_does_not_know_the_token_finds_nothing() {
    let asked = Asked::new();
    let (ours, token) = (asked.served.page_headers(), asked.served.token.clone());
    asked.refused("GET ", &ours, "", 400);
    for path in ["/", "//api/state", "/favicon.ico", "/api/accept", &format!("/{token}")] {
        asked.refused(&format!("GET {path}"), &ours, "", 404);
    }
    let wrong = token.chars().rev().collect::<String>();
    let long = format!("{token}0");
    for token in [&wrong, &token[1..], &long, &token.to_uppercase(), "", "..%2f", "x"] {
        asked.refused(&format!("POST /{token}/api/accept"), &ours, BODY, 404);
        asked.refused(&format!("GET /{token}/events"), &ours, "", 404);
    }
    asked.is_as_before();
}

#[test]
fn no_path_leads_elsewhere() {
    let asked = Asked::new();
    let (ours, token) = (asked.served.page_headers(), asked.served.token.clone());
    for path in
        ["api/nothing", "api/accept/", "..%2fgolden/same.png", "../same", "golden/same.png", "//"]
    {
        asked.refused(&format!("GET /{token}/{path}"), &ours, "", 404);
        asked.refused(&format!("POST /{token}/{path}"), &ours, BODY, 404);
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
        asked.refused(&format!("{method} /{token}/{path}"), &ours, BODY, 405);
    }
    asked.is_as_before();
}

#[test]
fn no_other_page_decides() {
    let asked = Asked::new();
    let (port, token) = (asked.served.port, &asked.served.token);
    let (sub, end) = (format!("a.127.0.0.1:{port}"), format!("127.0.0.1:{port}.example"));
    for host in ["goldray.example", "127.0.0.1", "127.0.0.1:1", "", &sub, &end] {
        asked.acceptance_refused(&asked.with("Host", host), BODY, 403);
        asked.refused(&format!("GET /{token}/"), &asked.with("Host", host), "", 403);
    }
    asked.acceptance_refused(&asked.without("Host"), BODY, 403);
    let twice = [asked.with("Host", "goldray.example"), asked.served.page_headers()].concat();
    asked.acceptance_refused(&twice, BODY, 400);
    let (other, end) = (format!("http://localhost:{port}"), format!("http://{end}"));
    for origin in ["null", "", "http://goldray.example", "https://127.0.0.1", &other, &end] {
        asked.acceptance_refused(&asked.with("Origin", origin), BODY, 403);
    }
    asked.acceptance_refused(&asked.without("Origin"), BODY, 403);
    for site in ["cross-site", "same-site", "none"] {
        asked.acceptance_refused(&asked.with("Sec-Fetch-Site", site), BODY, 403);
    }
    // What a form of any page can send.
    for kind in ["text/plain", "application/x-www-form-urlencoded", "multipart/form-data"] {
        asked.acceptance_refused(&asked.with("Content-Type", kind), BODY, 415);
    }
    asked.acceptance_refused(&asked.without("Content-Type"), BODY, 415);
    asked.is_as_before();
}

#[test]
fn the_other_name_of_this_machine_is_ours_too() {
    let asked = Asked::new();
    let host = format!("localhost:{}", asked.served.port);
    let mut headers = asked.with("Host", &host);
    headers.retain(|header| header.0 != "Origin");
    headers.push(("Origin", format!("http://{host}")));
    let body = json!({ "names": ["changed"], "edition": asked.served.edition() }).to_string();
    assert_eq!(asked.served.request(&asked.accept(), &headers, &body).status, 200);
    assert_eq!(changed(&asked.before, &files(asked.tree.0.path())), ["golden/changed.png"]);
}

#[test]
fn what_is_no_request_is_refused() {
    let asked = Asked::new();
    let ours = asked.served.page_headers();
    for body in [
        "",
        "{",
        "[\"changed\"]",
        "{\"names\":\"changed\"}",
        "{\"names\":[1]}",
        "names=changed",
        "{\"names\":[\"changed\"],\"force\":true}",
        BODY,
        "{\"names\":[\"changed\"],\"edition\":\"\",\"force\":true}",
    ] {
        asked.acceptance_refused(&ours, body, 400);
    }
    asked.acceptance_refused(&ours, &"x".repeat((1 << 20) + 1), 413);
    let mut head = asked.accept() + " HTTP/1.1\r\n";
    for (name, value) in &ours {
        head.extend([name, ": ", value.as_str(), "\r\n"]);
    }
    let send = |more: &str, status| {
        Asked::check(&asked.served.send(format!("{head}{more}").as_bytes()), status);
    };
    send("Content-Length: 99999999999999999999999\r\n\r\n", 413);
    send("Content-Length: -1\r\n\r\n", 400);
    send("Content-Length: 2\r\nContent-Length: 3\r\n\r\n{}", 400);
    send("Transfer-Encoding: chunked\r\n\r\n0\r\n\r\n", 411);
    send("\r\n", 411);
    send(&format!("X: {}\r\n\r\n", "x".repeat(1 << 16)), 431);
    Asked::check(&asked.served.send(b"\x16\x03\x01\x02\x00 hello\r\n\r\n"), 400);
    asked.is_as_before();
}

#[test]
fn no_page_of_another_edition_decides() {
    let asked = Asked::new();
    let other = asked.served.edition().chars().rev().collect::<String>();
    for edition in ["", "undefined", &other] {
        for what in ["accept", "reject", "undo"] {
            let answer = asked.served.post_of(edition, what, &["changed"]);
            Asked::check(&answer, 409);
            assert!(answer.body.contains("the page is out of date"), "{answer:?}");
        }
        asked.served.tab_of(Some(edition)).expect("reload");
    }
    let ours = asked.served.page_headers();
    let token = &asked.served.token;
    for path in ["?x", "api/state?edition=x"] {
        asked.refused(&format!("GET /{token}/{path}"), &ours, "", 404);
    }
    asked.is_as_before();
}

#[test]
fn names_are_those_of_what_can_be_accepted() {
    let asked = Asked::new();
    let names = [
        "same",
        "nowhere",
        "../changed",
        "..%2fchanged",
        "changed.ron",
        "fixtures/changed",
        "",
        "/etc/passwd",
        "CHANGED",
        "changed\0",
    ];
    for name in names {
        let state = asked.served.post("accept", &[name]);
        assert_eq!(state["decisions"], json!({}), "{name}");
        assert_eq!(state["messages"].as_array().unwrap().len(), 1, "{name}");
        assert_eq!(asked.served.post("undo", &[name])["decisions"], json!({}));
    }
    asked.is_as_before();
}

#[test]
fn only_this_machine_is_answered() {
    let tree = Tree::failing();
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
    let tree = Tree::failing();
    let served = review(&tree);
    let page = served.get("");
    assert_eq!(page.status, 200);
    assert!(page.body.contains("\"kind\":\"review\""), "{}", page.body);
    assert!(page.body.contains("add/ed"));
    assert!(page.head.contains("Content-Type: text/html; charset=utf-8"), "{}", page.head);
    for header in [
        "Content-Security-Policy: ",
        "default-src 'none'; ",
        "frame-ancestors 'none'",
        "connect-src 'self'",
        "X-Content-Type-Options: nosniff",
        "X-Frame-Options: DENY",
        "Referrer-Policy: no-referrer",
        "Cache-Control: no-store",
        "Cross-Origin-Resource-Policy: same-origin",
        "Cross-Origin-Opener-Policy: same-origin",
    ] {
        for answer in [&page, &served.get("api/state"), &served.get("nothing")] {
            assert!(answer.head.contains(header), "{header}: {}", answer.head);
            assert!(!answer.head.contains("Access-Control"), "{}", answer.head);
        }
    }
    let (_, nonce) = page.head.split_once("script-src 'nonce-").unwrap();
    let nonce = nonce.split('\'').next().unwrap();
    let script = format!("<script nonce=\"{nonce}\" data-edition=\"");
    assert_eq!(page.body.matches(&script).count(), 1, "its script runs");
    assert!(!page.body.contains("<script>") && !page.head.contains("script-src 'unsafe"));
    let (a, b) = (served.token.clone(), review(&tree).token.clone());
    assert!(a.len() == 32 && a != b, "another token each time");
}

#[test]
fn who_is_stuck_keeps_nobody_waiting() {
    let tree = Tree::failing();
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
    // Those that have begun are told, in time.
    let mut told = String::new();
    let _ = (&stuck[1]).read_to_string(&mut told);
    assert!(told.starts_with("HTTP/1.1 408 "), "{told}");
    assert!(started.elapsed() < Duration::from_secs(20), "{:?}", started.elapsed());
    let again = served.connect();
    drop(served.tab());
    assert_eq!(served.end().0, Some(1));
    drop(again);
}
