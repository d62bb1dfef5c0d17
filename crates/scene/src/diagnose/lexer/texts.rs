//! Texts, bytes and characters in quotes.

use super::super::literal;
use super::super::problem::{Span, offset};
use super::super::words::excerpt;
use super::{Lexer, TokenKind};

/// More bytes than a character takes however it is escaped.
const LONGEST_CHARACTER: usize = 64;

impl Lexer<'_> {
    /// A text in `"`, which stands `prefix` bytes from here; false if it has no end.
    pub(super) fn quoted(&mut self, prefix: usize) -> bool {
        let rest = self.rest();
        let inside = &rest[prefix + 1..];
        // The line's end is looked for only where it matters, and no further
        // than needed: a file may be one line of a million texts.
        match closing_quote(inside, '"') {
            Some(end) if !self.one_line_texts || !inside[..end].contains('\n') => {
                self.literal(prefix + 1 + end + 1);
                true
            }
            _ if self.one_line_texts => {
                let line = inside.find('\n').unwrap_or(inside.len());
                self.report(prefix + 1, "`\"` is never closed");
                let next = likely_end(&inside[..line]);
                let shown = inside[..next.unwrap_or(line)].trim_end();
                self.out.cut_short |= next.is_none() && inside[line..].trim_end().is_empty();
                self.push(TokenKind::Bad, prefix + 1 + shown.len());
                true
            }
            _ => false,
        }
    }

    /// A text like `r#"..."#`, whose `#` or `"` stands `prefix` bytes from here.
    pub(super) fn raw_text(&mut self, prefix: usize) {
        let rest = self.rest();
        let inside = rest[prefix..].trim_start_matches('#');
        let start = rest.len() - inside.len();
        let end = format!("\"{}", &rest[prefix..start]);
        let Some(inside) = inside.strip_prefix('"') else {
            self.report(start, format!("expected `\"` after `{}`", &rest[..start]));
            return self.push(TokenKind::Bad, start);
        };
        if let Some(found) = inside.find(&end) {
            self.literal(start + 1 + found + end.len());
        } else {
            self.report(start + 1, format!("`{}` is never closed by `{end}`", &rest[..=start]));
            self.out.cut_short = true;
            self.push(TokenKind::Bad, rest.len());
        }
    }

    /// A character in `'`, which stands `prefix` bytes from here.
    pub(super) fn character(&mut self, prefix: usize) {
        let rest = self.rest();
        let inside = &rest[prefix + 1..];
        let inside = &inside[..inside.floor_char_boundary(LONGEST_CHARACTER)];
        let line = inside.find('\n').unwrap_or(inside.len());
        // `'''` is a quote.
        if inside.starts_with("''") {
            return self.literal(prefix + 3);
        }
        match closing_quote(&inside[..line], '\'') {
            Some(end) => self.literal(prefix + 1 + end + 1),
            None => self.junk(),
        }
    }

    /// A complete text or character, `len` bytes long.
    fn literal(&mut self, len: usize) {
        let source = &self.rest()[..len];
        let kind = if source.starts_with("b'") {
            literal::read::<u8>(source).map(|_| TokenKind::Number)
        } else if source.starts_with('b') {
            match literal::read::<ron::Value>(source) {
                Some(ron::Value::Bytes(bytes)) => Some(TokenKind::Bytes(bytes)),
                _ => None,
            }
        } else if source.starts_with('\'') {
            literal::read::<char>(source).map(TokenKind::Char)
        } else {
            literal::read::<String>(source).map(TokenKind::Str)
        };
        if kind.is_none() {
            self.bad_literal(source);
        }
        self.push(kind.unwrap_or(TokenKind::Bad), len);
    }

    fn bad_literal(&mut self, source: &str) {
        let shown = excerpt(source, Span::new(0, source.len()));
        if source.contains('\\') {
            let error = ron::from_str::<ron::Value>(source).err();
            let at = error.map_or(0, |error| offset(source, error.span.start)).min(source.len());
            let message = format!("`{shown}` has an escape that is not known");
            let problem = self.report(0, message);
            problem.span = Span::new(problem.span.start + at, problem.span.start + source.len());
            problem.help = Some(
                "escapes are `\\n`, `\\t`, `\\\\`, `\\\"`, `\\u{41}`; \
                in `r\"...\"` a backslash is only a backslash"
                    .to_owned(),
            );
        } else {
            self.report(source.len(), format!("`{shown}` is not one character")).help =
                Some("texts are written in `\"`".to_owned());
        }
    }
}

/// Where the first `quote` is that no backslash protects.
fn closing_quote(inside: &str, quote: char) -> Option<usize> {
    let mut escaped = false;
    for (i, c) in inside.char_indices() {
        match c {
            _ if escaped => escaped = false,
            '\\' => escaped = true,
            _ if c == quote => return Some(i),
            _ => {}
        }
    }
    None
}

/// Where a text that is never closed most likely ends: before what separates or closes values.
fn likely_end(line: &str) -> Option<usize> {
    let mut open = 0;
    line.find(|c| match c {
        '(' | '[' | '{' => {
            open += 1;
            false
        }
        ')' | ']' | '}' if open > 0 => {
            open -= 1;
            false
        }
        c => open == 0 && matches!(c, ',' | ':' | ')' | ']' | '}'),
    })
}
