//! `Words`: a file's words one after the other, comments left out.

use crate::import::text::{number, shown};

/// A word, and where it is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Word<'a> {
    pub(super) text: &'a str,
    /// Its first byte in the file.
    pub(super) at: usize,
    /// Whether it is the first of its line.
    pub(super) begins_line: bool,
}

impl Word<'_> {
    /// Whether it could begin an element: no number begins with a letter.
    pub(super) fn is_name(&self) -> bool {
        self.text.starts_with(|c: char| c.is_alphabetic())
    }
}

/// The words of a text; `#` begins a comment, which ends with its line.
#[derive(Debug, Clone)]
pub(super) struct Words<'a> {
    text: &'a str,
    at: usize,
    begins_line: bool,
}

impl<'a> Words<'a> {
    pub(super) fn of(text: &'a str) -> Self {
        Self { text, at: 0, begins_line: true }
    }

    /// The next word, which is not taken.
    pub(super) fn peek(&self) -> Option<Word<'a>> {
        self.clone().next()
    }

    /// The next word as a number.
    ///
    /// # Errors
    /// What is there instead, and where. A word that could begin an element is
    /// not taken.
    pub(super) fn number(&mut self) -> Result<f64, (usize, String)> {
        let Some(word) = self.peek() else {
            return Err((self.text.len(), "expected a number, found the end".to_owned()));
        };
        if word.is_name() {
            let message = format!("expected a number, found \"{}\"", shown(word.text));
            return Err((word.at, message));
        }
        self.next();
        number(word.text).map_err(|why| (word.at, why))
    }

    /// Passes over everything up to a line that begins with a name.
    pub(super) fn skip_element(&mut self) {
        while self.peek().is_some_and(|word| !(word.begins_line && word.is_name())) {
            self.next();
        }
    }
}

impl<'a> Iterator for Words<'a> {
    type Item = Word<'a>;

    fn next(&mut self) -> Option<Word<'a>> {
        loop {
            let rest = self.text.get(self.at..)?;
            let found = rest.chars().next()?;
            if found == '\n' {
                self.at += 1;
                self.begins_line = true;
            } else if found.is_whitespace() {
                self.at += found.len_utf8();
            } else if found == '#' {
                self.at += rest.find('\n').unwrap_or(rest.len());
            } else {
                let end = rest.find(|c: char| c.is_whitespace() || c == '#').unwrap_or(rest.len());
                let (at, begins_line) = (self.at, self.begins_line);
                self.at += end;
                self.begins_line = false;
                return Some(Word { text: &rest[..end], at, begins_line });
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn comments_and_lines() {
        let words: Vec<_> = Words::of("# a\n s 1 #b\r\n\t2\u{e4}#c").collect();
        let found: Vec<_> = words.iter().map(|w| (w.text, w.at, w.begins_line)).collect();
        assert_eq!(found, [("s", 5, true), ("1", 7, false), ("2\u{e4}", 14, true)]);
        assert_eq!(Words::of("").next(), None);
        assert_eq!(Words::of("#").next(), None);
    }

    #[test]
    fn a_missing_number_leaves_the_next_element() {
        let mut words = Words::of("1 x");
        assert_eq!(words.number(), Ok(1.0));
        assert_eq!(words.number(), Err((2, "expected a number, found \"x\"".to_owned())));
        assert_eq!(words.next().unwrap().text, "x");
        assert_eq!(words.number(), Err((3, "expected a number, found the end".to_owned())));
    }
}
