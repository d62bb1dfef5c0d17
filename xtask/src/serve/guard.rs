//! `Guard`: who may ask, and whose word changes something.
//!
//! Any page of the web may send requests to this machine's ports. It does not
//! know the token; it can make a browser take its own name for this machine's
//! (DNS rebinding), but not send our host with it; and it cannot send our origin.

use std::fmt;

use super::request::{Head, Refusal};

/// 128 bits that nobody guesses, new for each run.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Token(String);

impl Token {
    /// Letters of a token: two for each of its 16 bytes.
    const LETTERS: usize = 32;

    /// Another one each time, from the operating system.
    ///
    /// # Errors
    /// It has no randomness.
    pub fn random() -> std::io::Result<Self> {
        let mut bytes = [0; 16];
        getrandom::fill(&mut bytes).map_err(std::io::Error::other)?;
        Ok(Self(format!("{:032x}", u128::from_ne_bytes(bytes))))
    }

    /// What [`Token`] prints; `None` for anything else.
    pub fn parse(text: &str) -> Option<Self> {
        let is_hex = text.bytes().all(|c| matches!(c, b'0'..=b'9' | b'a'..=b'f'));
        (text.len() == Self::LETTERS && is_hex).then(|| Self(text.to_owned()))
    }

    /// Whether this is the token, in a time that does not tell how much of it is.
    fn is(&self, text: &str) -> bool {
        let differing = self.0.bytes().zip(text.bytes()).fold(0, |all, (a, b)| all | (a ^ b));
        text.len() == self.0.len() && std::hint::black_box(differing) == 0
    }
}

impl fmt::Display for Token {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

/// What requests are held against.
#[derive(Debug)]
pub(super) struct Guard {
    pub(super) port: u16,
    pub(super) token: Token,
}

impl Guard {
    /// The part of the path behind the token.
    ///
    /// # Errors
    /// Another host than this one, and no or another token.
    pub(super) fn admit<'a>(&self, head: &'a Head) -> Result<&'a str, Refusal> {
        self.host(head)?;
        let parts = head.path.strip_prefix('/').and_then(|path| path.split_once('/'));
        match parts {
            Some((token, rest)) if self.token.is(token) => Ok(rest),
            _ => Err(Refusal::NOT_FOUND),
        }
    }

    /// Refuses what may not change anything: a request that is not of the page
    /// that was served from here, or is no JSON.
    ///
    /// # Errors
    /// Such a request.
    pub(super) fn may_change(&self, head: &Head) -> Result<(), Refusal> {
        let origin = format!("http://{}", self.host(head)?);
        if head.one("origin")? != Some(&origin) {
            return Err(Refusal(403, "expected a request of the page that was served"));
        }
        if head.one("sec-fetch-site")?.is_some_and(|site| site != "same-origin") {
            return Err(Refusal(403, "expected a request of the page that was served"));
        }
        let kind = head.one("content-type")?.and_then(|kind| kind.split(';').next());
        if !kind.is_some_and(|kind| kind.trim().eq_ignore_ascii_case("application/json")) {
            return Err(Refusal(415, "expected the content type application/json"));
        }
        Ok(())
    }

    /// The name of ours that the request was sent to.
    fn host(&self, head: &Head) -> Result<String, Refusal> {
        let sent = head.one("host")?.unwrap_or_default();
        let mut ours =
            ["127.0.0.1", "localhost"].map(|host| format!("{host}:{}", self.port)).into_iter();
        let host = ours.find(|host| sent.eq_ignore_ascii_case(host));
        host.ok_or(Refusal(403, "expected the address that was printed"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TOKEN: &str = "0123456789abcdef0123456789abcdef";

    fn guard() -> Guard {
        Guard { port: 8000, token: Token::parse(TOKEN).unwrap() }
    }

    fn head(path: &str, headers: &[(&str, &str)]) -> Head {
        let headers = headers.iter().map(|&(name, value)| (name.to_owned(), value.to_owned()));
        Head { method: "POST".into(), path: path.into(), query: None, headers: headers.collect() }
    }

    #[test]
    fn only_our_host_and_the_token_are_admitted() {
        #[track_caller]
        fn check(host: Option<&str>, path: &str, expected: Result<&str, u16>) {
            let head = head(path, &host.map(|host| ("Host", host)).into_iter().collect::<Vec<_>>());
            assert_eq!(guard().admit(&head).map_err(|refusal| refusal.0), expected, "{path}");
        }
        let ours = Some("127.0.0.1:8000");
        let page = format!("/{TOKEN}/");
        for host in [None, Some(""), Some("127.0.0.1"), Some("127.0.0.1:80"), Some("a.b:8000")] {
            check(host, &page, Err(403));
        }
        check(ours, &page, Ok(""));
        check(Some("LocalHost:8000"), &format!("{page}api/state"), Ok("api/state"));
        let wrong = TOKEN.replace('f', "e");
        let (short, long) = (&TOKEN[..31], format!("{TOKEN}0"));
        for token in ["", "x", short, &long, &wrong, &TOKEN.to_uppercase()] {
            check(ours, &format!("/{token}/"), Err(404));
        }
        for path in ["", "/", "//", &format!("/{TOKEN}"), &format!("//{TOKEN}/"), TOKEN] {
            check(ours, path, Err(404));
        }
    }

    #[test]
    fn only_our_own_page_changes_something() {
        #[track_caller]
        fn check(more: &[(&str, &str)], expected: Result<(), u16>) {
            let headers = [&[("Host", "localhost:8000")], more].concat();
            let found = guard().may_change(&head("/", &headers)).map_err(|refusal| refusal.0);
            assert_eq!(found, expected, "{more:?}");
        }
        let (origin, json) =
            (("Origin", "http://localhost:8000"), ("Content-Type", "application/json"));
        check(&[origin, json], Ok(()));
        check(&[origin, ("content-type", "Application/JSON; charset=utf-8")], Ok(()));
        check(&[origin, json, ("Sec-Fetch-Site", "same-origin")], Ok(()));
        for site in ["cross-site", "same-site", "none", ""] {
            check(&[origin, json, ("Sec-Fetch-Site", site)], Err(403));
        }
        check(&[json], Err(403));
        for other in
            ["null", "", "http://127.0.0.1:8000", "https://localhost:8000", "http://localhost"]
        {
            check(&[("Origin", other), json], Err(403));
        }
        check(&[origin, origin, json], Err(400));
        check(&[origin], Err(415));
        for kind in ["text/plain", "", "application/x-www-form-urlencoded", "application/jsonx"] {
            check(&[origin, ("Content-Type", kind)], Err(415));
        }
    }

    #[test]
    fn tokens_are_long_and_never_the_same() {
        let (a, b) = (Token::random().unwrap(), Token::random().unwrap());
        assert_ne!(a, b);
        assert_eq!(Token::parse(&a.to_string()), Some(a));
        for text in ["", "0", &TOKEN[1..], &TOKEN.to_uppercase(), &format!("{TOKEN}0")] {
            assert_eq!(Token::parse(text), None);
        }
    }
}
