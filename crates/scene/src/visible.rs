//! `visible`: text of others inside a line of ours.

/// The text with everything escaped as `\u{...}` that would end the line, move a
/// terminal's cursor, or turn the order in which letters are shown.
///
/// ```
/// assert_eq!(scene::visible("box/a b"), "box/a b");
/// assert_eq!(scene::visible("a\n\u{1b}[2J\u{202e}b"), r"a\u{a}\u{1b}[2J\u{202e}b");
/// ```
pub fn visible(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        if is_invisible(c) { out.extend(c.escape_unicode()) } else { out.push(c) }
    }
    out
}

/// Whether a letter would not be seen, but change what is.
pub fn is_invisible(c: char) -> bool {
    c.is_control()
        // Ends of lines and paragraphs.
        || matches!(c, '\u{2028}' | '\u{2029}')
        // Marks, embeddings, overrides and isolates of direction.
        || matches!(c, '\u{61c}' | '\u{200e}' | '\u{200f}')
        || matches!(c, '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}')
}
