//! `Words`: the words of a text file with their places, statement by statement
//! or one after the other.
//!
//! Bytes need not be UTF-8. A line ends with LF, CR or both. Nothing is kept but
//! the words of one statement, and not more than [`MOST_WORDS`] of those.

/// Line and column, both from 1.
pub(in crate::import) type Place = (usize, usize);

/// The most words of a statement that are looked at: a polygon of 20,000 corners
/// and its keyword.
pub(in crate::import) const MOST_WORDS: usize = 20_001;

/// A word where it stands.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::import) struct Word<'a> {
    /// The word.
    pub(in crate::import) text: &'a [u8],
    /// Where it starts.
    pub(in crate::import) place: Place,
    /// The byte at which it starts.
    start: usize,
}

impl Word<'_> {
    /// The word as in a message: not too long.
    pub(in crate::import) fn shown(&self) -> String {
        shown(self.text)
    }

    /// The whole number that it is.
    ///
    /// # Errors
    /// What was expected and found.
    pub(in crate::import) fn whole<T: std::str::FromStr>(&self) -> Result<T, String> {
        let number = std::str::from_utf8(self.text).ok().and_then(|text| text.parse().ok());
        number.ok_or_else(|| format!("expected a whole number, found \"{}\"", self.shown()))
    }

    /// The finite number that it is, rounded once.
    ///
    /// # Errors
    /// What was expected and found.
    pub(in crate::import) fn number(&self) -> Result<f64, String> {
        let text = std::str::from_utf8(self.text).ok();
        let number = text.and_then(|text| text.parse().ok()).filter(|x: &f64| x.is_finite());
        number.ok_or_else(|| format!("expected a number, found \"{}\"", self.shown()))
    }
}

/// Bytes as in a message: not too long.
pub(in crate::import) fn shown(bytes: &[u8]) -> String {
    const LONGEST: usize = 60;
    let text = String::from_utf8_lossy(&bytes[..bytes.len().min(4 * LONGEST)]);
    let mut short: String = text.chars().take(LONGEST).flat_map(char::escape_debug).collect();
    if text.chars().count() > LONGEST || bytes.len() > 4 * LONGEST {
        short.push_str("...");
    }
    short
}

/// A text and how far it is read.
#[derive(Debug, Clone)]
pub(in crate::import) struct Words<'a> {
    bytes: &'a [u8],
    at: usize,
    line: usize,
    column: usize,
    has_comments: bool,
}

impl<'a> Words<'a> {
    /// A text without comments, in which a backslash is a letter like others.
    pub(in crate::import) fn plain(bytes: &'a [u8]) -> Self {
        const UTF_8: &[u8] = b"\xef\xbb\xbf";
        let at = if bytes.starts_with(UTF_8) { UTF_8.len() } else { 0 };
        Self { bytes, at, line: 1, column: 1, has_comments: false }
    }

    /// A text in which what follows a `#` is a comment, and a line that ends with
    /// a backslash goes on in the next.
    pub(in crate::import) fn with_comments(bytes: &'a [u8]) -> Self {
        Self { has_comments: true, ..Self::plain(bytes) }
    }

    /// Where the next byte is.
    pub(in crate::import) fn place(&self) -> Place {
        (self.line, self.column)
    }

    /// What is not read yet.
    pub(in crate::import) fn rest(&self) -> &'a [u8] {
        &self.bytes[self.at..]
    }

    /// The next word, on whatever line it is.
    pub(in crate::import) fn next_word(&mut self) -> Option<Word<'a>> {
        loop {
            if let Some(word) = self.word_of_line() {
                return Some(word);
            }
            if !self.end_line() {
                return None;
            }
        }
    }

    /// Goes on with the next line.
    pub(in crate::import) fn skip_line(&mut self) {
        while self.peek().is_some_and(|byte| !is_line_end(byte)) {
            self.step();
        }
        self.end_line();
    }

    /// The words of the next statement that has any; whether there is one. Of
    /// one that has too many, one more than [`MOST_WORDS`].
    pub(in crate::import) fn next_statement(&mut self, words: &mut Vec<Word<'a>>) -> bool {
        words.clear();
        loop {
            while let Some(word) = self.word_of_line() {
                if words.len() <= MOST_WORDS {
                    words.push(word);
                }
            }
            if !self.end_line() || !words.is_empty() {
                return !words.is_empty();
            }
        }
    }

    /// The words of the next line, which may have none; whether there is one.
    /// Nothing after that line has been looked at: what follows may be no text.
    pub(in crate::import) fn next_header_line(&mut self, words: &mut Vec<Word<'a>>) -> bool {
        words.clear();
        while let Some(word) = self.word_of_line() {
            if words.len() <= MOST_WORDS {
                words.push(word);
            }
        }
        self.end_line()
    }

    /// What was written from one word of a statement to its last.
    pub(in crate::import) fn text(&self, words: &[Word<'a>]) -> &'a [u8] {
        match (words.first(), words.last()) {
            (Some(first), Some(last)) => &self.bytes[first.start..last.start + last.text.len()],
            _ => b"",
        }
    }

    fn peek(&self) -> Option<u8> {
        self.bytes.get(self.at).copied()
    }

    fn step(&mut self) {
        /// The two highest bits of a byte that goes on with a letter of UTF-8.
        const GOES_ON: (u8, u8) = (0xc0, 0x80);
        let goes_on = self.peek().is_some_and(|byte| byte & GOES_ON.0 == GOES_ON.1);
        self.column += usize::from(!goes_on);
        self.at += 1;
    }

    /// Passes over the end of a line; false at the end of the text.
    fn end_line(&mut self) -> bool {
        let Some(byte) = self.peek() else { return false };
        self.at += 1;
        if byte == b'\r' && self.peek() == Some(b'\n') {
            self.at += 1;
        }
        (self.line, self.column) = (self.line + 1, 1);
        true
    }

    /// The next word of this line.
    fn word_of_line(&mut self) -> Option<Word<'a>> {
        loop {
            match self.peek()? {
                byte if is_line_end(byte) => return None,
                b'#' if self.has_comments => {
                    while self.peek().is_some_and(|byte| !is_line_end(byte)) {
                        self.step();
                    }
                }
                b'\\' if self.goes_on() => {
                    self.step();
                    self.end_line();
                }
                byte if is_space(byte) => self.step(),
                _ => break,
            }
        }
        let (start, place) = (self.at, self.place());
        while self.peek().is_some_and(|byte| !is_line_end(byte) && !is_space(byte)) {
            if self.goes_on() {
                break;
            }
            self.step();
        }
        Some(Word { text: &self.bytes[start..self.at], place, start })
    }

    /// Whether here is the backslash that ends a line.
    fn goes_on(&self) -> bool {
        let next = self.bytes.get(self.at + 1);
        let is_last = next.is_none_or(|&byte| is_line_end(byte));
        self.has_comments && self.peek() == Some(b'\\') && is_last
    }
}

fn is_line_end(byte: u8) -> bool {
    matches!(byte, b'\n' | b'\r')
}

fn is_space(byte: u8) -> bool {
    matches!(byte, b' ' | b'\t' | 0x0b | 0x0c)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Statements, each as its words with their places.
    #[track_caller]
    fn check(text: &str, expected: &[&str]) {
        let mut words = Words::with_comments(text.as_bytes());
        let (mut statement, mut found) = (Vec::new(), Vec::new());
        while words.next_statement(&mut statement) {
            let one = |w: &Word<'_>| format!("{}@{}:{}", w.shown(), w.place.0, w.place.1);
            found.push(statement.iter().map(one).collect::<Vec<_>>().join(" "));
        }
        assert_eq!(found, expected, "{text:?}");
    }

    #[test]
    fn statements_have_words_with_places() {
        check("", &[]);
        check("\n \n\t#x\n", &[]);
        check("a b\nc", &["a@1:1 b@1:3", "c@2:1"]);
        check("a\r\nb\rc\n\rd", &["a@1:1", "b@2:1", "c@3:1", "d@5:1"]);
        check("\u{feff}ä b#c", &["ä@1:1 b#c@1:3"]);
        check("a # b \\\nc", &["a@1:1", "c@2:1"]);
        check("a \\\n b\\\r\nc\nd\\", &["a@1:1 b@2:2 c@3:1", "d@4:1"]);
        check("a\\b\\ c", &["a\\\\b\\\\@1:1 c@1:6"]);
        check("\\\n\\\n", &[]);
    }

    #[test]
    fn numbers_are_finite() {
        let of = |text: &'static str| Words::plain(text.as_bytes()).next_word().unwrap();
        assert_eq!(of("-1.5e-3").number(), Ok(-1.5e-3));
        assert_eq!(of(".5").number(), Ok(0.5));
        assert!(of("inf").number().is_err() && of("1e999").number().is_err());
        assert_eq!(of("1x").number(), Err("expected a number, found \"1x\"".to_owned()));
        assert_eq!(of("-3").whole(), Ok(-3));
        assert!(of("1.0").whole::<i64>().is_err());
        assert_eq!(shown(&[b'a'; 500]), format!("{}...", "a".repeat(60)));
        assert_eq!(shown(b"\xff\0"), "\u{fffd}\\0");
    }
}
