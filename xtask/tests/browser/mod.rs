//! `Served` and `Printing`: a verb that goes on, and what a browser and others
//! ask of it, byte by byte.
// Each file of tests is a program of its own, and none uses all of this.
#![allow(dead_code, unreachable_pub, clippy::panic)]

use std::collections::BTreeMap;
use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::path::{Path, PathBuf};
use std::process::{Child, ChildStdout, Command, Stdio};
use std::sync::mpsc::{Receiver, channel};
use std::time::{Duration, Instant};

use serde_json::{Value, json};

/// How long anything may take before a test fails: far more than it does, as
/// other tests run beside it.
pub(crate) const PATIENCE: Duration = Duration::from_mins(1);

/// A program that serves.
pub(crate) struct Served {
    pub(crate) child: Child,
    pub(crate) stdout: BufReader<ChildStdout>,
    pub(crate) port: u16,
    pub(crate) token: String,
}

/// An answer.
#[derive(Debug)]
pub(crate) struct Answer {
    pub(crate) status: u16,
    pub(crate) head: String,
    pub(crate) body: String,
}

impl Answer {
    #[track_caller]
    pub(crate) fn json(&self) -> Value {
        serde_json::from_str(&self.body).unwrap_or_else(|why| panic!("{why}: {self:?}"))
    }
}

impl Served {
    /// Starts it and waits for the address.
    #[track_caller]
    pub(crate) fn start(command: &mut Command) -> Self {
        let mut child = command.stdout(Stdio::piped()).stderr(Stdio::null()).spawn().unwrap();
        let stdout = BufReader::new(child.stdout.take().unwrap());
        let mut served = Self { child, stdout, port: 0, token: String::new() };
        served.find_address();
        served
    }

    /// Reads on until an address is printed.
    #[track_caller]
    pub(crate) fn find_address(&mut self) {
        let line = self.line_with("http://127.0.0.1:");
        let (_, address) = line.split_once("http://127.0.0.1:").unwrap();
        let (port, token) = address.split_once('/').unwrap();
        self.port = port.parse().unwrap();
        token.split('/').next().unwrap().clone_into(&mut self.token);
    }

    /// Reads on until a line with this.
    #[track_caller]
    pub(crate) fn line_with(&mut self, text: &str) -> String {
        let mut all = String::new();
        loop {
            let mut line = String::new();
            assert!(self.stdout.read_line(&mut line).unwrap() > 0, "expected {text:?} in:\n{all}");
            if line.contains(text) {
                return line;
            }
            all += &line;
        }
    }

    pub(crate) fn host(&self) -> String {
        format!("127.0.0.1:{}", self.port)
    }

    /// What our own page sends with a decision.
    pub(crate) fn page_headers(&self) -> Vec<(&'static str, String)> {
        vec![
            ("Host", self.host()),
            ("Origin", format!("http://{}", self.host())),
            ("Sec-Fetch-Site", "same-origin".to_owned()),
            ("Content-Type", "application/json".to_owned()),
        ]
    }

    pub(crate) fn connect(&self) -> TcpStream {
        let stream = TcpStream::connect(("127.0.0.1", self.port)).unwrap();
        stream.set_read_timeout(Some(PATIENCE)).unwrap();
        stream
    }

    /// Sends these very bytes.
    pub(crate) fn send(&self, bytes: &[u8]) -> Answer {
        let mut stream = self.connect();
        // It may be refused before all of it is there.
        let _ = stream.write_all(bytes);
        let mut text = String::new();
        let _ = stream.read_to_string(&mut text);
        let (head, body) = text.split_once("\r\n\r\n").unwrap_or((&text, ""));
        let status = head.split(' ').nth(1).and_then(|status| status.parse().ok()).unwrap_or(0);
        Answer { status, head: head.to_owned(), body: body.to_owned() }
    }

    pub(crate) fn request(
        &self,
        line: &str,
        headers: &[(&'static str, String)],
        body: &str,
    ) -> Answer {
        let headers = headers.iter().map(|(name, value)| format!("{name}: {value}\r\n"));
        let headers = headers.collect::<String>();
        let length = body.len();
        let text = format!("{line} HTTP/1.1\r\n{headers}Content-Length: {length}\r\n\r\n{body}");
        self.send(text.as_bytes())
    }

    pub(crate) fn get(&self, path: &str) -> Answer {
        self.request(&format!("GET /{}/{path}", self.token), &[("Host", self.host())], "")
    }

    /// Decides as the page does.
    #[track_caller]
    pub(crate) fn post(&self, what: &str, names: &[&str]) -> Value {
        let answer = self.post_of(&self.edition(), what, names);
        assert_eq!(answer.status, 200, "{answer:?}");
        answer.json()
    }

    /// The same as a page of this edition.
    pub(crate) fn post_of(&self, edition: &str, what: &str, names: &[&str]) -> Answer {
        let body = json!({ "names": names, "edition": edition }).to_string();
        let line = format!("POST /{}/api/{what}", self.token);
        self.request(&line, &self.page_headers(), &body)
    }

    /// Which page is served.
    #[track_caller]
    pub(crate) fn edition(&self) -> String {
        let page = self.get("").body;
        let (_, edition) = page.split_once("data-edition=\"").unwrap();
        edition.split('"').next().unwrap().to_owned()
    }

    /// A tab, once it is open.
    #[track_caller]
    pub(crate) fn tab(&self) -> Tab {
        self.tab_of(None)
    }

    #[track_caller]
    pub(crate) fn tab_of(&self, edition: Option<&str>) -> Tab {
        let mut stream = self.connect();
        let query = edition.map_or(String::new(), |edition| format!("?edition={edition}"));
        let (token, host) = (&self.token, self.host());
        let text = format!("GET /{token}/events{query} HTTP/1.1\r\nHost: {host}\r\n\r\n");
        stream.write_all(text.as_bytes()).unwrap();
        let mut lines = BufReader::new(stream);
        let mut line = String::new();
        while line.trim_end() != "retry: 500" {
            line.clear();
            assert!(lines.read_line(&mut line).unwrap() > 0, "no stream");
        }
        Tab(lines)
    }

    /// Waits for its end; the exit code, and the rest that it printed.
    #[track_caller]
    pub(crate) fn end(mut self) -> (Option<i32>, String) {
        let started = Instant::now();
        let status = loop {
            if let Some(status) = self.child.try_wait().unwrap() {
                break status;
            }
            assert!(started.elapsed() < PATIENCE, "it does not end");
            std::thread::sleep(Duration::from_millis(10));
        };
        let mut rest = String::new();
        self.stdout.read_to_string(&mut rest).unwrap();
        (status.code(), rest)
    }

    /// Presses Ctrl-C.
    #[cfg(unix)]
    pub(crate) fn interrupt(&self) {
        interrupt(&self.child);
    }
}

impl Drop for Served {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

#[cfg(unix)]
fn interrupt(child: &Child) {
    use nix::sys::signal::{Signal, kill};
    let pid = nix::unistd::Pid::from_raw(child.id().try_into().unwrap());
    kill(pid, Signal::SIGINT).unwrap();
}

/// A watch that only prints, line by line.
pub(crate) struct Printing {
    child: Child,
    lines: Receiver<String>,
}

impl Printing {
    pub(crate) fn start(command: &mut Command) -> Self {
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
    pub(crate) fn until(&self, text: &str) -> String {
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
    pub(crate) fn expect_silence(&self) {
        assert_eq!(self.lines_of(Duration::from_millis(1500)), [""; 0]);
    }

    /// What it says in so much time.
    pub(crate) fn lines_of(&self, time: Duration) -> Vec<String> {
        let end = Instant::now() + time;
        let left = || end.saturating_duration_since(Instant::now());
        std::iter::from_fn(|| self.lines.recv_timeout(left()).ok()).collect()
    }

    /// Presses Ctrl-C, and waits for its end; the exit code.
    #[cfg(unix)]
    pub(crate) fn interrupt(mut self) -> Option<i32> {
        interrupt(&self.child);
        self.child.wait().unwrap().code()
    }
}

impl Drop for Printing {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// A stream of events.
pub(crate) struct Tab(BufReader<TcpStream>);

/// An event: its name, its id and its data.
pub(crate) type Event = (String, String, String);

impl Tab {
    /// The next event that is no ping.
    #[track_caller]
    pub(crate) fn event(&mut self) -> Event {
        let mut event = Event::default();
        let started = Instant::now();
        loop {
            let mut line = String::new();
            // Pings go on whatever happens.
            assert!(started.elapsed() < PATIENCE, "no event");
            assert!(self.0.read_line(&mut line).unwrap() > 0, "the stream ended");
            match line.trim_end().split_once(": ") {
                Some(("event", name)) => name.clone_into(&mut event.0),
                Some(("id", id)) => id.clone_into(&mut event.1),
                Some(("data", data)) => data.clone_into(&mut event.2),
                _ if !event.0.is_empty() => return event,
                _ => {}
            }
        }
    }

    /// The next event, which is one of this name.
    #[track_caller]
    pub(crate) fn expect(&mut self, name: &str) -> Event {
        let event = self.event();
        assert_eq!(event.0, name);
        event
    }
}

/// Every file below a folder with its bytes, but what a check leaves in
/// `target/`.
pub(crate) fn files(root: &Path) -> BTreeMap<PathBuf, Vec<u8>> {
    let mut all = BTreeMap::new();
    let mut folders = vec![root.to_owned()];
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            let relative = path.strip_prefix(root).unwrap();
            if relative == Path::new("target") {
                continue;
            }
            if path.is_dir() {
                folders.push(path);
            } else {
                all.insert(relative.to_owned(), std::fs::read(&path).unwrap());
            }
        }
    }
    all
}

/// The files that differ.
pub(crate) fn changed(
    before: &BTreeMap<PathBuf, Vec<u8>>,
    after: &BTreeMap<PathBuf, Vec<u8>>,
) -> Vec<String> {
    let all: std::collections::BTreeSet<_> = before.keys().chain(after.keys()).collect();
    let differs = all.into_iter().filter(|path| before.get(*path) != after.get(*path));
    differs.map(|path| path.display().to_string()).collect()
}
