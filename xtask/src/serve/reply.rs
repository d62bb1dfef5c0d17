//! `Reply`: an HTTP answer, with the headers that keep others out.

use std::io::{Read, Write};
use std::net::{Shutdown, TcpStream};
use std::sync::Arc;
use std::time::Duration;

use serde_json::{Value, json};

use super::request::Refusal;

/// An answer.
#[derive(Debug)]
pub(super) enum Reply {
    /// All at once.
    Full { status: u16, kind: &'static str, body: Arc<[u8]>, more: String },
    /// The page as it is when it is sent.
    Page,
    /// Events as they come, to a page of this edition.
    Events { edition: Option<String> },
}

/// The page may run its own script and ask the server that it came from: nothing
/// else of this machine or of the web, and no other page may show it. What
/// fixtures say in it is data, even if it looks like a script.
const POLICY: &str = "default-src 'none'; style-src 'unsafe-inline'; img-src data: blob:; \
                      connect-src 'self' data:; base-uri 'none'; form-action 'none'; \
                      frame-ancestors 'none'";

impl Reply {
    /// A page, of whose scripts that with this nonce is run.
    pub(super) fn html(body: Arc<[u8]>, nonce: &str) -> Self {
        let more = policy(&format!("script-src 'nonce-{nonce}'; {POLICY}"));
        Self::Full { status: 200, kind: "text/html; charset=utf-8", body, more }
    }

    /// A document.
    pub(super) fn json(status: u16, value: &Value) -> Self {
        let body = value.to_string().into_bytes().into();
        Self::Full { status, kind: "application/json", body, more: policy(POLICY) }
    }

    /// Another method than the one that is allowed.
    pub(super) fn not_allowed(allow: &'static str) -> Self {
        let body = json!({ "schema": 1, "error": format!("expected the method {allow}") });
        let body = body.to_string().into_bytes().into();
        let more = format!("{}Allow: {allow}\r\n", policy(POLICY));
        Self::Full { status: 405, kind: "application/json", body, more }
    }

    /// Sends it; nothing of a page or events.
    pub(super) fn write(&self, stream: &mut TcpStream) -> std::io::Result<()> {
        let Self::Full { status, kind, body, more } = self else { return Ok(()) };
        let (head, length) = (head(*status, kind), body.len());
        let head = format!("{head}{more}Content-Length: {length}\r\n\r\n");
        stream.write_all(head.as_bytes())?;
        stream.write_all(body)
    }
}

impl From<Refusal> for Reply {
    fn from(Refusal(status, why): Refusal) -> Self {
        Self::json(status, &json!({ "schema": 1, "error": why }))
    }
}

fn policy(policy: &str) -> String {
    format!("Content-Security-Policy: {policy}\r\n")
}

/// The beginning of an answer, without the empty line at its end.
pub(super) fn head(status: u16, kind: &str) -> String {
    let words = match status {
        200 => "OK",
        403 => "Forbidden",
        404 => "Not Found",
        405 => "Method Not Allowed",
        _ => "Refused",
    };
    format!(
        "HTTP/1.1 {status} {words}\r\n\
         Content-Type: {kind}\r\n\
         X-Content-Type-Options: nosniff\r\n\
         X-Frame-Options: DENY\r\n\
         Referrer-Policy: no-referrer\r\n\
         Cache-Control: no-store\r\n\
         Cross-Origin-Resource-Policy: same-origin\r\n\
         Cross-Origin-Opener-Policy: same-origin\r\n\
         Connection: close\r\n"
    )
}

/// Closes a connection so that the answer arrives: what the client still sends
/// of a request that was refused is read for a while, as closing before would
/// take the answer back.
pub(super) fn close(mut stream: &TcpStream) {
    const PATIENCE: Duration = Duration::from_millis(200);
    const MOST_READS: usize = 64;
    let mut ignored = [0; 8 << 10];
    if stream.shutdown(Shutdown::Write).is_err() || stream.set_read_timeout(Some(PATIENCE)).is_err()
    {
        return;
    }
    for _ in 0..MOST_READS {
        if !matches!(stream.read(&mut ignored), Ok(1..)) {
            return;
        }
    }
}
