//! `Incoming`: one HTTP request, read within bounds of size and time.

use std::io::Read;
use std::net::TcpStream;
use std::time::{Duration, Instant};

/// The largest head of a request, in bytes: browsers send less than 2 KiB.
const MAX_HEAD_BYTES: usize = 16 << 10;

/// The most headers of a request: browsers send about 20.
const MAX_HEADERS: usize = 64;

/// The largest body of a request, in bytes: the names of 10,000 fixtures.
const MAX_BODY_BYTES: usize = 1 << 20;

/// How long a request may take to come in.
const PATIENCE: Duration = Duration::from_secs(5);

/// How long the client may read none of an answer.
const WRITE_PATIENCE: Duration = Duration::from_secs(10);

/// Why a request is not answered: a status code, and a sentence for people that
/// tells nothing that the client has not sent.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Refusal(pub(super) u16, pub(super) &'static str);

impl Refusal {
    /// There was no request, as of browsers that open connections in advance.
    pub(super) const SILENT: Self = Self(0, "");
    /// The same whether a page is not there or only not for this client.
    pub(super) const NOT_FOUND: Self = Self(404, "there is no such page");
    const MALFORMED: Self = Self(400, "expected an HTTP/1.1 request");
    const SLOW: Self = Self(408, "expected the whole request within five seconds");
}

/// What a request says before its body.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Head {
    /// Such as `GET`.
    pub(super) method: String,
    /// The path as it was sent, without a query. Nothing is decoded.
    pub(super) path: String,
    /// What follows it after a `?`, likewise.
    pub(super) query: Option<String>,
    /// Names and values.
    pub(super) headers: Vec<(String, String)>,
}

impl Head {
    /// The value of a header; `None` where there is none.
    ///
    /// # Errors
    /// There are several, which two readers may take for different ones.
    pub(super) fn one(&self, name: &str) -> Result<Option<&str>, Refusal> {
        let mut all = self.headers.iter().filter(|header| header.0.eq_ignore_ascii_case(name));
        let first = all.next().map(|header| header.1.as_str());
        if all.next().is_some() {
            return Err(Refusal(400, "expected each of these headers once"));
        }
        Ok(first)
    }
}

/// A connection that a request comes in by.
pub(super) struct Incoming {
    stream: TcpStream,
    /// What was read and is not used yet.
    read: Vec<u8>,
    deadline: Instant,
}

impl Incoming {
    /// # Errors
    /// A connection that is gone.
    pub(super) fn new(stream: TcpStream) -> std::io::Result<Self> {
        stream.set_write_timeout(Some(WRITE_PATIENCE))?;
        stream.set_nodelay(true)?;
        Ok(Self { stream, read: Vec::new(), deadline: Instant::now() + PATIENCE })
    }

    /// The connection, to answer by.
    pub(super) fn into_stream(self) -> TcpStream {
        self.stream
    }

    /// The request up to its body.
    ///
    /// # Errors
    /// One that is malformed, too long or slow, or none at all.
    pub(super) fn head(&mut self) -> Result<Head, Refusal> {
        loop {
            if let Some((head, bytes)) = parse(&self.read)? {
                self.read.drain(..bytes);
                return Ok(head);
            }
            if self.read.len() > MAX_HEAD_BYTES {
                return Err(Refusal(431, "expected fewer or shorter headers"));
            }
            self.read_more()
                .map_err(|why| if self.read.is_empty() { Refusal::SILENT } else { why })?;
        }
    }

    /// The body.
    ///
    /// # Errors
    /// One that is too large, slow, cut short, or of unknown length.
    pub(super) fn body(&mut self, head: &Head) -> Result<Vec<u8>, Refusal> {
        if head.one("transfer-encoding")?.is_some() {
            return Err(Refusal(411, "expected a body of a stated length"));
        }
        let length = head.one("content-length")?;
        let length = length.ok_or(Refusal(411, "expected a body of a stated length"))?;
        let is_number = !length.is_empty() && length.bytes().all(|c| c.is_ascii_digit());
        if !is_number {
            return Err(Refusal::MALFORMED);
        }
        // A number that is too long for the type is too large as well.
        let length = length.parse().ok().filter(|length| *length <= MAX_BODY_BYTES);
        let length = length.ok_or(Refusal(413, "expected a body of at most 1 MiB"))?;
        while self.read.len() < length {
            self.read_more()?;
        }
        self.read.truncate(length);
        Ok(std::mem::take(&mut self.read))
    }

    fn read_more(&mut self) -> Result<(), Refusal> {
        const CHUNK: usize = 8 << 10;
        let left = self.deadline.saturating_duration_since(Instant::now());
        if left.is_zero() || self.stream.set_read_timeout(Some(left)).is_err() {
            return Err(Refusal::SLOW);
        }
        let mut chunk = [0; CHUNK];
        match self.stream.read(&mut chunk) {
            Ok(0) => Err(Refusal::MALFORMED),
            Ok(count) => {
                self.read.extend_from_slice(&chunk[..count]);
                Ok(())
            }
            Err(error) if error.kind() == std::io::ErrorKind::Interrupted => Ok(()),
            Err(_) => Err(Refusal::SLOW),
        }
    }
}

/// The head of a request and its length, once all of it is there.
fn parse(bytes: &[u8]) -> Result<Option<(Head, usize)>, Refusal> {
    let mut headers = [httparse::EMPTY_HEADER; MAX_HEADERS];
    let mut request = httparse::Request::new(&mut headers);
    let length = match request.parse(bytes) {
        Ok(httparse::Status::Complete(length)) => length,
        Ok(httparse::Status::Partial) => return Ok(None),
        Err(httparse::Error::TooManyHeaders) => {
            return Err(Refusal(431, "expected fewer or shorter headers"));
        }
        Err(_) => return Err(Refusal::MALFORMED),
    };
    let text = |bytes: &[u8]| String::from_utf8(bytes.to_vec()).map_err(|_| Refusal::MALFORMED);
    let (Some(method), Some(target)) = (request.method, request.path) else {
        return Err(Refusal::MALFORMED);
    };
    let (path, query) = match target.split_once('?') {
        Some((path, query)) => (path, Some(query.to_owned())),
        None => (target, None),
    };
    let headers = request.headers.iter();
    let headers = headers.map(|header| Ok((header.name.to_owned(), text(header.value)?)));
    let headers = headers.collect::<Result<_, _>>()?;
    let (method, path) = (method.to_owned(), path.to_owned());
    Ok(Some((Head { method, path, query, headers }, length)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(text: &str, expected: Result<Option<(&str, &str)>, u16>) {
        let found = parse(text.as_bytes()).map_err(|refusal| refusal.0);
        let found = found.map(|head| head.map(|(head, _)| (head.method, head.path)));
        let expected = expected.map(|e| e.map(|(method, path)| (method.into(), path.into())));
        assert_eq!(found, expected, "{text:?}");
    }

    #[test]
    fn a_request_is_read_as_it_was_sent() {
        check("", Ok(None));
        check("GET /x HTTP/1.1\r\nHost: a\r\n", Ok(None));
        check("GET /x HTTP/1.1\r\nHost: a\r\n\r\n", Ok(Some(("GET", "/x"))));
        check("GET /a/..%2f?q=1 HTTP/1.1\r\n\r\n", Ok(Some(("GET", "/a/..%2f"))));
        let head = parse(b"GET /a?q=1?2 HTTP/1.1\r\n\r\n").unwrap().unwrap().0;
        assert_eq!(head.query.as_deref(), Some("q=1?2"));
        check("\0", Err(400));
        check("GET /x HTTP/9\r\n\r\n", Err(400));
        check("GET /x HTTP/1.1\r\nno colon\r\n\r\n", Err(400));
        let many = format!("GET / HTTP/1.1\r\n{}\r\n", "a: b\r\n".repeat(MAX_HEADERS + 1));
        check(&many, Err(431));
    }

    #[test]
    fn a_header_that_comes_twice_is_none() {
        let head = |text: &str| parse(text.as_bytes()).unwrap().unwrap().0;
        let once = head("GET / HTTP/1.1\r\nHOST: a\r\n\r\n");
        assert_eq!((once.one("host"), once.one("origin")), (Ok(Some("a")), Ok(None)));
        let twice = head("GET / HTTP/1.1\r\nHost: a\r\nhost: a\r\n\r\n");
        assert_eq!(twice.one("host").map_err(|refusal| refusal.0), Err(400));
    }
}
