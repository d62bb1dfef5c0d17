//! The literals of RON, as `ron` itself reads them.
//!
//! A literal is cut out of the text by the lexer, then handed to `ron`: what is a good number,
//! escape or letter is decided in one place.

use serde::de::{DeserializeOwned, IgnoredAny};

/// The value of a literal that is a `T`; nothing if it is something else.
pub(super) fn read<T: DeserializeOwned>(literal: &str) -> Option<T> {
    ron::from_str(literal).ok()
}

/// Whether a name may begin with this character.
pub(super) fn starts_name(c: char) -> bool {
    if c.is_ascii() {
        return c == '_' || c.is_ascii_alphabetic();
    }
    c.is_alphabetic() && ron::from_str::<IgnoredAny>(c.encode_utf8(&mut [0; 4])).is_ok()
}

/// Whether a name may go on with this character.
pub(super) fn continues_name(c: char) -> bool {
    if c.is_ascii() {
        return c == '_' || c.is_ascii_alphanumeric();
    }
    !is_space(c) && ron::from_str::<IgnoredAny>(&format!("a{c}")).is_ok()
}

/// Whether a name may go on with this character if it is written `r#name`.
pub(super) fn continues_raw_name(c: char) -> bool {
    matches!(c, '.' | '+' | '-') || continues_name(c)
}

/// The characters between tokens, besides comments.
pub(super) fn is_space(c: char) -> bool {
    let beyond_ascii = ['\u{85}', '\u{200E}', '\u{200F}', '\u{2028}', '\u{2029}'];
    matches!(c, ' ' | '\t' | '\n' | '\r' | '\x0B' | '\x0C') || beyond_ascii.contains(&c)
}
