//! `Text`: a foreign file's bytes as text, with the places of its bytes.

use super::Unreadable;
use super::report::Place;

/// A text with its lines.
#[derive(Debug)]
pub(super) struct Text<'a> {
    /// Without a byte order mark.
    pub(super) text: &'a str,
    line_starts: Vec<usize>,
}

impl<'a> Text<'a> {
    /// The text of a file, which must be UTF-8; a byte order mark before it is
    /// passed over.
    ///
    /// # Errors
    /// Another encoding, with the place of the first byte that tells.
    pub(super) fn of(bytes: &'a [u8]) -> Result<Self, Unreadable> {
        const UTF_8: &[u8] = b"\xef\xbb\xbf";
        const UTF_16: [&[u8]; 2] = [b"\xff\xfe", b"\xfe\xff"];
        let help = Some("save the file as UTF-8".to_owned());
        if UTF_16.iter().any(|mark| bytes.starts_with(mark)) {
            let message = "expected UTF-8 text, found the byte order mark of UTF-16".to_owned();
            return Err(Unreadable { place: Some((1, 1)), message, help });
        }
        let bytes = bytes.strip_prefix(UTF_8).unwrap_or(bytes);
        match std::str::from_utf8(bytes) {
            Ok(text) => Ok(Self::with_lines(text)),
            Err(error) => {
                let (good, rest) = bytes.split_at(error.valid_up_to());
                let good = Self::with_lines(std::str::from_utf8(good).unwrap_or_default());
                let byte = rest.first().copied().unwrap_or_default();
                let message = format!("expected UTF-8 text, found the byte 0x{byte:02x}");
                Err(Unreadable { place: Some(good.place(good.text.len())), message, help })
            }
        }
    }

    fn with_lines(text: &'a str) -> Self {
        let ends = text.match_indices('\n').map(|(byte, _)| byte + 1);
        Self { text, line_starts: std::iter::once(0).chain(ends).collect() }
    }

    /// The line and column of a byte; of the end for one past it.
    pub(super) fn place(&self, byte: usize) -> Place {
        let byte = self.text.floor_char_boundary(byte);
        let line = self.line_starts.partition_point(|&start| start <= byte);
        let start = self.line_starts.get(line - 1).copied().unwrap_or_default();
        (line, self.text[start..byte].chars().count() + 1)
    }
}

/// A number as these files write them.
///
/// # Errors
/// What was expected and what found, where it is none or not finite.
pub(super) fn number(word: &str) -> Result<f64, String> {
    match word.parse::<f64>() {
        Ok(number) if number.is_finite() => Ok(number),
        Ok(_) => Err(format!("expected a finite number, found \"{}\"", shown(word))),
        Err(_) => Err(format!("expected a number, found \"{}\"", shown(word))),
    }
}

/// The beginning of a word, which may be long and hold anything.
pub(super) fn shown(word: &str) -> String {
    /// The most characters that are shown.
    const MOST: usize = 40;
    let start: String = word.chars().take(MOST).collect();
    let more = if start.len() < word.len() { "..." } else { "" };
    format!("{}{more}", scene::visible(&start))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn other_encodings_are_told_with_their_place() {
        #[track_caller]
        fn check(bytes: &[u8], place: Place, message: &str) {
            let found = Text::of(bytes).unwrap_err();
            assert_eq!(found.place, Some(place));
            assert!(found.message.contains(message), "{found:?}");
        }
        check(b"\xff\xfe<\0", (1, 1), "UTF-16");
        check(b"\xfe\xff\0<", (1, 1), "UTF-16");
        check(b"a\n\xc3", (2, 1), "0xc3");
        check(b"a\nbc\xe4d", (2, 3), "0xe4");
        assert_eq!(Text::of(b"\xef\xbb\xbfab").unwrap().text, "ab");
    }

    #[test]
    fn places_count_characters() {
        let text = Text::of("a\n\u{e4}bc\n".as_bytes()).unwrap();
        for (byte, place) in [(0, (1, 1)), (1, (1, 2)), (2, (2, 1)), (4, (2, 2)), (99, (3, 1))] {
            assert_eq!(text.place(byte), place, "{byte}");
        }
        assert_eq!(Text::of(b"").unwrap().place(0), (1, 1));
    }

    #[test]
    fn numbers_are_finite() {
        for good in ["1", "-.5", "1e3", "+2", "1e-400", "0.30000000000000004"] {
            assert!(number(good).is_ok(), "{good}");
        }
        for (bad, found) in [
            ("nan", "finite"),
            ("-inf", "finite"),
            ("1e400", "finite"),
            ("1,5", "a number, found \"1,5\""),
            ("0x10", "a number"),
            ("", "a number"),
            (&"9".repeat(400), "..."),
        ] {
            assert!(number(bad).unwrap_err().contains(found), "{bad}");
        }
    }
}
