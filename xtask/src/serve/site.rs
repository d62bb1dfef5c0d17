//! `Site`: what is served, and what becomes of each request.

use std::io::Write;
use std::net::TcpStream;
use std::sync::mpsc::RecvTimeoutError;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

use harness::review::Review;
use serde_json::Value;

use super::guard::{Guard, Token};
use super::reply::{Reply, head};
use super::request::{Head, Incoming, Refusal};
use super::tabs::Tabs;

/// How often a stream is looked at, so that a closed tab is known as one.
const LOOK_EVERY: Duration = Duration::from_millis(250);

/// How often a stream without news says that it is one.
const PING_EVERY: Duration = Duration::from_secs(5);

/// A page with the review that it shows. Two decisions never come together: each
/// waits for the one before.
#[derive(Debug)]
pub struct Site {
    page: Mutex<Page>,
    review: Mutex<Review>,
    /// Who looks at it.
    pub tabs: Tabs,
}

#[derive(Debug)]
struct Page {
    html: Arc<[u8]>,
    /// What its script is known by, among all that fixtures may have put there.
    nonce: String,
    /// Tells this page from any other, of another process too.
    edition: String,
    /// The edition that was sent last.
    sent: String,
}

impl Page {
    fn new(html: &str) -> std::io::Result<Self> {
        let (nonce, edition) = (Token::random()?.to_string(), Token::random()?.to_string());
        // The first one of this form: before it there is only data, in which every
        // `<` is written otherwise.
        let html = html.replacen("<script>", &format!("<script nonce=\"{nonce}\">"), 1);
        Ok(Self { html: html.into_bytes().into(), nonce, edition, sent: String::new() })
    }
}

impl Site {
    /// A page with the review that it shows.
    ///
    /// # Errors
    /// The system has no randomness.
    pub fn new(page: &str, review: Review) -> std::io::Result<Self> {
        let page = Mutex::new(Page::new(page)?);
        Ok(Self { page, review: Mutex::new(review), tabs: Tabs::default() })
    }

    /// Shows another page with another review, which takes over what was decided,
    /// and tells the tabs to load it.
    ///
    /// # Errors
    /// The system has no randomness.
    pub fn replace(&self, page: &str, mut review: Review) -> std::io::Result<()> {
        let page = Page::new(page)?;
        let reload = event("reload", &page.edition, "");
        let mut shown = self.review();
        review.inherit(&shown);
        *shown = review;
        let mut before = lock(&self.page);
        *before = Page { sent: before.sent.clone(), ..page };
        self.tabs.tell(&reload);
        Ok(())
    }

    /// The review. As long as this is held, nothing is decided.
    pub fn review(&self) -> MutexGuard<'_, Review> {
        lock(&self.review)
    }

    /// What is answered, after reading what more is needed of the request.
    pub(super) fn reply(&self, head: &Head, incoming: &mut Incoming, guard: &Guard) -> Reply {
        self.try_reply(head, incoming, guard).unwrap_or_else(Reply::from)
    }

    fn try_reply(
        &self,
        head: &Head,
        incoming: &mut Incoming,
        guard: &Guard,
    ) -> Result<Reply, Refusal> {
        let path = guard.admit(head)?;
        let allowed = match path {
            "" | "events" | "api/state" => "GET",
            "api/accept" | "api/reject" | "api/undo" => "POST",
            _ => return Err(Refusal::NOT_FOUND),
        };
        if head.method != allowed {
            return Ok(Reply::not_allowed(allowed));
        }
        Ok(match path {
            "" => self.page(),
            "events" => Reply::Events { seen: head.one("last-event-id")?.map(str::to_owned) },
            "api/state" => Reply::json(200, &self.review().to_json(&[])),
            _ => {
                guard.may_change(head)?;
                let names = names(&incoming.body(head)?)?;
                Reply::json(200, &self.decide(path, &names))
            }
        })
    }

    fn page(&self) -> Reply {
        let mut page = lock(&self.page);
        let edition = page.edition.clone();
        page.sent = edition;
        self.tabs.expect();
        Reply::html(Arc::clone(&page.html), &page.nonce)
    }

    fn decide(&self, path: &str, names: &[String]) -> Value {
        let mut review = self.review();
        let before = review.to_json(&[]);
        let said = match path {
            "api/accept" => review.accept(names),
            "api/reject" => review.reject(names),
            _ => review.undo(names),
        };
        let after = review.to_json(&[]);
        if after != before {
            let edition = lock(&self.page).edition.clone();
            self.tabs.tell(&event("state", &edition, &after.to_string()));
        }
        review.to_json(&said)
    }

    /// Sends events for as long as the tab is open.
    pub(super) fn stream_events(
        &self,
        stream: &mut TcpStream,
        seen: Option<&str>,
    ) -> std::io::Result<()> {
        // Opened first, so that nothing that happens from here on is missed.
        let tab = self.tabs.open();
        let (edition, is_old) = {
            let page = lock(&self.page);
            let shown = seen.unwrap_or(&page.sent);
            (page.edition.clone(), !shown.is_empty() && shown != page.edition)
        };
        // A stream that breaks off is opened again by the browser, so soon that
        // its tab is not taken for closed.
        stream.write_all(
            format!("{}\r\nretry: 500\n\n", head(200, "text/event-stream")).as_bytes(),
        )?;
        if is_old {
            stream.write_all(event("reload", &edition, "").as_bytes())?;
        }
        let state = self.review().to_json(&[]).to_string();
        stream.write_all(event("state", &edition, &state).as_bytes())?;
        let mut pinged = Instant::now();
        loop {
            match tab.events.recv_timeout(LOOK_EVERY) {
                Ok(event) => stream.write_all(event.as_bytes())?,
                Err(RecvTimeoutError::Disconnected) => return Ok(()),
                Err(RecvTimeoutError::Timeout) if is_closed(stream)? => return Ok(()),
                Err(RecvTimeoutError::Timeout) if pinged.elapsed() >= PING_EVERY => {
                    stream.write_all(b": ping\n\n")?;
                    pinged = Instant::now();
                }
                Err(RecvTimeoutError::Timeout) => {}
            }
        }
    }
}

/// An event for an `EventSource`; `data` is one line.
fn event(name: &str, edition: &str, data: &str) -> String {
    format!("id: {edition}\nevent: {name}\ndata: {data}\n\n")
}

/// Whether the other side has closed its end.
fn is_closed(stream: &TcpStream) -> std::io::Result<bool> {
    stream.set_read_timeout(Some(Duration::from_millis(1)))?;
    Ok(match stream.peek(&mut [0]) {
        Ok(bytes) => bytes == 0,
        Err(error) => {
            use std::io::ErrorKind::{Interrupted, TimedOut, WouldBlock};
            !matches!(error.kind(), Interrupted | TimedOut | WouldBlock)
        }
    })
}

/// `{"names":["a/b",...]}`.
fn names(body: &[u8]) -> Result<Vec<String>, Refusal> {
    let refusal = Refusal(400, "expected {\"names\": [...]} with names of fixtures");
    let value: Value = serde_json::from_slice(body).map_err(|_| refusal)?;
    let names = value.as_object().filter(|object| object.len() == 1);
    let names = names.and_then(|object| object.get("names")?.as_array()).ok_or(refusal)?;
    let names = names.iter().map(|name| name.as_str().map(str::to_owned));
    names.collect::<Option<_>>().ok_or(refusal)
}

/// What was locked by a thread that panicked is whole: a decision is noted after
/// it was carried out.
fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_body_is_names_and_nothing_else() {
        #[track_caller]
        fn check(body: &str, expected: Option<&[&str]>) {
            let found = names(body.as_bytes()).ok();
            assert_eq!(
                found.as_deref(),
                expected.map(|e| e.iter().map(|s| (*s).to_owned()).collect::<Vec<_>>()).as_deref(),
                "{body}"
            );
        }
        check(r#"{"names":["a/b","c"]}"#, Some(&["a/b", "c"]));
        check(r#"{"names":[]}"#, Some(&[]));
        for body in
            ["", "a", "[]", "{}", r#"{"names":"a"}"#, r#"{"names":[1]}"#, r#"{"names":[],"x":1}"#]
        {
            check(body, None);
        }
        assert!(names(b"\xff").is_err());
        assert!(names("[".repeat(1 << 20).as_bytes()).is_err(), "nor does it take the stack");
    }
}
