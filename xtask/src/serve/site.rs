//! `Site`: what is served, and what becomes of each request.

use std::io::Write;
use std::net::TcpStream;
use std::sync::mpsc::RecvTimeoutError;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

use harness::review::Review;
use serde_json::json;

use super::asked::{Asked, asked};
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
    /// Tells this page from any other, of another process too. The page says it with
    /// all that it asks.
    edition: String,
    /// Why what it shows may no longer be so, and nothing can be decided.
    trouble: Option<String>,
}

impl Page {
    fn new(html: &str) -> std::io::Result<Self> {
        let (nonce, edition) = (Token::random()?.to_string(), Token::random()?.to_string());
        // The first one of this form: before it there is only data, in which every
        // `<` is written otherwise.
        let script = format!("<script nonce=\"{nonce}\" data-edition=\"{edition}\">");
        let html = html.replacen("<script>", &script, 1);
        Ok(Self { html: html.into_bytes().into(), nonce, edition, trouble: None })
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
        *lock(&self.page) = page;
        self.tabs.tell(&reload);
        Ok(())
    }

    /// Says that the files cannot be judged as they are, until another page is
    /// shown: nothing is decided of what may no longer be so.
    pub fn trouble(&self, why: &str) {
        let _review = self.review();
        let mut page = lock(&self.page);
        page.trouble = Some(why.to_owned());
        self.tabs.tell(&trouble(&page.edition, why));
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
        let edition = match &head.query {
            None => None,
            Some(query) if path == "events" => query.strip_prefix("edition=").map(str::to_owned),
            Some(_) => return Err(Refusal::NOT_FOUND),
        };
        Ok(match path {
            "" => Reply::Page,
            "events" => Reply::Events { edition },
            "api/state" => Reply::json(200, &self.review().to_json(&[])),
            _ => {
                guard.may_change(head)?;
                self.decide(path, &asked(&incoming.body(head)?)?)?
            }
        })
    }

    /// Sends the page, whose tab is expected as soon as all of it is sent.
    pub(super) fn send_page(&self, stream: &mut TcpStream) -> std::io::Result<()> {
        let _sending = self.tabs.send();
        let reply = {
            let page = lock(&self.page);
            Reply::html(Arc::clone(&page.html), &page.nonce)
        };
        reply.write(stream)
    }

    /// Decides what was asked for by who sees the page as it is.
    fn decide(&self, path: &str, asked: &Asked) -> Result<Reply, Refusal> {
        let mut review = self.review();
        let names = &asked.names;
        let edition = {
            let page = lock(&self.page);
            if asked.edition != page.edition {
                return Err(Refusal(409, "the page is out of date: it is loaded again"));
            }
            if let Some(why) = &page.trouble {
                let why = format!("nothing can be decided: {why}");
                return Ok(Reply::json(503, &json!({ "schema": 1, "error": why })));
            }
            page.edition.clone()
        };
        let before = review.to_json(&[]);
        let said = match path {
            "api/accept" => review.accept(names),
            "api/reject" => review.reject(names),
            _ => review.undo(names),
        };
        let after = review.to_json(&[]);
        if after != before {
            self.tabs.tell(&event("state", &edition, &after.to_string()));
        }
        Ok(Reply::json(200, &review.to_json(&said)))
    }

    /// Sends events for as long as the tab is open.
    pub(super) fn stream_events(
        &self,
        stream: &mut TcpStream,
        shown: Option<&str>,
    ) -> std::io::Result<()> {
        // Opened first, so that nothing that happens from here on is missed.
        let tab = self.tabs.open();
        let (edition, why) = {
            let page = lock(&self.page);
            (page.edition.clone(), page.trouble.clone())
        };
        // A stream that breaks off is opened again by the browser, so soon that
        // its tab is not taken for closed.
        stream.write_all(
            format!("{}\r\nretry: 500\n\n", head(200, "text/event-stream")).as_bytes(),
        )?;
        if shown.is_some_and(|shown| shown != edition) {
            stream.write_all(event("reload", &edition, "").as_bytes())?;
        }
        let state = self.review().to_json(&[]).to_string();
        stream.write_all(event("state", &edition, &state).as_bytes())?;
        if let Some(why) = why {
            stream.write_all(trouble(&edition, &why).as_bytes())?;
        }
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

/// The event that says that the files cannot be judged as they are.
fn trouble(edition: &str, why: &str) -> String {
    // A sentence as JSON is one line, whatever it holds.
    event("trouble", edition, &json!(why).to_string())
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

/// What was locked by a thread that panicked is whole: a decision is noted after
/// it was carried out.
fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}
