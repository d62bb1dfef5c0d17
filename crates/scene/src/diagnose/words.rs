//! Phrases of the messages.

use super::problem::Span;
use super::tree::{Kind, Node};

/// A quoted piece of the text is cut to this many characters.
const EXCERPT_CHARS: usize = 40;

/// The text in `span` on one line, shortened.
pub(super) fn excerpt(text: &str, span: Span) -> String {
    let mut out = String::new();
    for (count, word) in span.of(text).split_whitespace().enumerate() {
        if count > 0 {
            out.push(' ');
        }
        out.push_str(word);
        // A long text need not be read to its end.
        if let Some((cut, _)) = out.char_indices().nth(EXCERPT_CHARS) {
            out.truncate(cut);
            out.push('…');
            break;
        }
    }
    out
}

/// The words for a value that is not what was expected.
pub(super) fn found(text: &str, node: &Node) -> String {
    let excerpt = excerpt(text, node.span);
    match node.kind {
        Kind::Str(_) => format!("the text `{excerpt}`"),
        Kind::Char(_) => format!("the character `{excerpt}`"),
        Kind::List(_) => format!("the list `{excerpt}`"),
        Kind::Map(_) => format!("the map `{excerpt}`"),
        _ if excerpt.is_empty() => "nothing".to_owned(),
        _ => format!("`{excerpt}`"),
    }
}

/// "1 value", "2 values".
pub(super) fn values(count: usize) -> String {
    if count == 1 { "1 value".to_owned() } else { format!("{count} values") }
}

/// "`a`, `b`, `c`".
pub(super) fn list(names: &[&str]) -> String {
    let quoted: Vec<String> = names.iter().map(|name| format!("`{name}`")).collect();
    quoted.join(", ")
}

/// The name that was most likely meant, if any is near.
pub fn nearest<'n>(name: &str, known: impl IntoIterator<Item = &'n str>) -> Option<&'n str> {
    let name = name.to_lowercase();
    let mut best: Option<(usize, &str)> = None;
    for candidate in known {
        let lower = candidate.to_lowercase();
        // `objetcs` is one slip of the hand, not two letters changed.
        let distance = strsim::damerau_levenshtein(&name, &lower);
        let letters = lower.chars().count().min(name.chars().count());
        let near = distance <= letters.div_ceil(3).min(MOST_SLIPS) && distance < letters;
        if near && best.is_none_or(|(least, _)| distance < least) {
            best = Some((distance, candidate));
        }
    }
    best.map(|(_, candidate)| candidate)
}

/// Two names further apart than this are different names, however long they are.
const MOST_SLIPS: usize = 3;
