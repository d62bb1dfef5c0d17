//! `Words`: the header of a PNM or PFM file, which is text.

/// Reads words one by one, and keeps the bytes that follow.
pub(super) struct Words<'a> {
    rest: &'a [u8],
    /// Whether `#` begins a comment.
    has_comments: bool,
}

impl<'a> Words<'a> {
    /// Behind the two letters that a file begins with.
    pub(super) fn behind_magic(bytes: &'a [u8], has_comments: bool) -> Self {
        Self { rest: bytes.get(2..).unwrap_or_default(), has_comments }
    }

    /// The next word; `None` at the end, and where it is longer than any number.
    pub(super) fn next(&mut self) -> Option<&'a str> {
        const LONGEST: usize = 40;
        loop {
            let blank = self.rest.iter().take_while(|byte| byte.is_ascii_whitespace()).count();
            self.rest = &self.rest[blank..];
            if !(self.has_comments && self.rest.first() == Some(&b'#')) {
                break;
            }
            let comment = self.rest.iter().take_while(|&&byte| byte != b'\n').count();
            self.rest = &self.rest[comment..];
        }
        let length = self.rest.iter().take_while(|byte| !byte.is_ascii_whitespace()).count();
        let (word, rest) = self.rest.split_at(length);
        self.rest = rest;
        if (1..=LONGEST).contains(&length) { std::str::from_utf8(word).ok() } else { None }
    }

    /// The next word as a number.
    ///
    /// # Errors
    /// What was expected, as the rest of a sentence.
    pub(super) fn number<T: std::str::FromStr>(&mut self, what: &str) -> Result<T, String> {
        let word = self.next();
        word.and_then(|word| word.parse().ok()).ok_or_else(|| {
            let found =
                word.map_or("nothing".to_owned(), |word| format!("\"{}\"", scene::visible(word)));
            format!("expected {what} in its header, found {found}")
        })
    }

    /// What follows the one blank behind the header.
    pub(super) fn body(self) -> &'a [u8] {
        self.rest.get(1..).unwrap_or_default()
    }

    /// Everything that was not read.
    pub(super) fn rest(&self) -> &'a [u8] {
        self.rest
    }
}
