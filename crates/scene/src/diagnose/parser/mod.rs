//! Tokens made into a tree, whatever is missing between them.

mod group;
mod items;

use std::collections::HashMap;

use super::brackets::End;
use super::lexer::{Bracket, Token, TokenKind};
use super::problem::{Problem, Span};
use super::tree::{Kind, Name, Node};
use super::words::excerpt;

/// `ron` refuses what is nested deeper, and so does the stack some day.
const MOST_NESTED: usize = 128;

/// What a text was made into.
pub(super) struct Parsed {
    pub(super) root: Node,
    pub(super) nodes: usize,
    /// A second comma at the end of a tuple, by its node.
    pub(super) second_commas: HashMap<usize, Span>,
}

/// The tree of a text.
pub(super) fn parse(
    text: &str,
    tokens: &[Token],
    ends: &[End],
    cut_short: bool,
    problems: &mut Vec<Problem>,
) -> Parsed {
    let mut parser = Parser {
        text,
        tokens,
        ends,
        problems,
        at: 0,
        nodes: 0,
        depth: 0,
        too_deep: false,
        second_comma: None,
        second_commas: HashMap::new(),
    };
    parser.skip_junk(tokens.len());
    let root = if parser.at < tokens.len() {
        parser.value(tokens.len())
    } else {
        let place = Span::new(text.len(), text.len());
        if tokens.is_empty() && !cut_short {
            parser.report(place, "the file is empty: expected a value");
        }
        parser.node(place, Kind::Bad)
    };
    parser.trailing();
    Parsed { root, nodes: parser.nodes, second_commas: parser.second_commas }
}

struct Parser<'a> {
    text: &'a str,
    tokens: &'a [Token],
    ends: &'a [End],
    problems: &'a mut Vec<Problem>,
    at: usize,
    nodes: usize,
    depth: usize,
    too_deep: bool,
    /// The comma after the last one of the brackets just read.
    second_comma: Option<Span>,
    second_commas: HashMap<usize, Span>,
}

impl Parser<'_> {
    fn kind(&self, i: usize, end: usize) -> Option<&TokenKind> {
        if i < end { self.tokens.get(i).map(|token| &token.kind) } else { None }
    }

    fn span(&self, i: usize) -> Span {
        let end = Span::new(self.text.len(), self.text.len());
        self.tokens.get(i).map_or(end, |token| token.span)
    }

    fn shown(&self, i: usize) -> String {
        excerpt(self.text, self.span(i))
    }

    fn report(&mut self, span: Span, message: impl Into<String>) {
        self.problems.push(Problem::new(span, message));
    }

    fn report_with_help(&mut self, span: Span, message: String, help: String) {
        self.problems.push(Problem::new(span, message).with_help(help));
    }

    fn node(&mut self, span: Span, kind: Kind) -> Node {
        self.nodes += 1;
        Node { id: self.nodes - 1, span, name: None, open: span.start, lossy: false, kind }
    }

    fn name(&self, i: usize) -> Name {
        let span = self.span(i);
        let raw = matches!(self.kind(i, i + 1), Some(TokenKind::Ident { raw: true }));
        let text = span.of(self.text);
        let text = if raw { text.strip_prefix("r#").unwrap_or(text) } else { text };
        Name { text: text.to_owned(), raw, span }
    }

    /// Skips what was reported already and stands for nothing.
    fn skip_junk(&mut self, end: usize) {
        while matches!(self.kind(self.at, end), Some(TokenKind::Junk | TokenKind::Close(_))) {
            self.at += 1;
        }
    }

    /// Reports what follows the value that is the whole text.
    fn trailing(&mut self) {
        self.skip_junk(self.tokens.len());
        if self.at < self.tokens.len() {
            let message =
                format!("unexpected `{}` after the end of the value", self.shown(self.at));
            self.report(self.span(self.at), message);
        }
    }

    /// A value, or a bad one if there is none here. `end` is after the current token.
    fn value(&mut self, end: usize) -> Node {
        let at = self.at;
        let span = self.span(at);
        let Some(kind) = self.kind(at, end).cloned() else {
            return self.node(Span::new(span.start, span.start), Kind::Bad);
        };
        let kind = match kind {
            // The last word of a text that was cut off may be half a word.
            TokenKind::Number | TokenKind::Ident { .. }
                if self.depth > 0 && span.end == self.text.len() =>
            {
                Kind::Bad
            }
            TokenKind::Number => Kind::Number,
            TokenKind::Str(text) => Kind::Str(text),
            TokenKind::Char(c) => Kind::Char(c),
            TokenKind::Bytes(bytes) => Kind::Bytes(bytes),
            TokenKind::Ident { raw } => return self.named(end, raw),
            TokenKind::Open(_) => return self.bracket(None),
            TokenKind::Bad => {
                self.at += 1;
                if self.kind(self.at, end) == Some(&TokenKind::Open(Bracket::Round)) {
                    self.at = self.ends[self.at].after;
                }
                return self.node(Span::new(span.start, self.last_byte()), Kind::Bad);
            }
            TokenKind::Comma | TokenKind::Colon | TokenKind::Close(_) | TokenKind::Junk => {
                self.at += 1;
                let message = format!("expected a value, found `{}`", self.shown(at));
                self.report(span, message);
                Kind::Bad
            }
        };
        self.at = at + 1;
        self.node(span, kind)
    }

    /// Whether the text ends inside of brackets, which is reported there.
    fn is_cut_off(&self) -> bool {
        self.at >= self.tokens.len()
    }

    /// Where the last token taken ends.
    fn last_byte(&self) -> usize {
        self.at.checked_sub(1).map_or(0, |last| self.span(last).end)
    }

    /// A value that begins with a name.
    fn named(&mut self, end: usize, raw: bool) -> Node {
        let name = self.name(self.at);
        self.at += 1;
        match self.kind(self.at, end) {
            Some(TokenKind::Open(Bracket::Round)) => return self.bracket(Some(name)),
            Some(next) if next.starts_value() && !raw && name.text == "Some" => {
                return self.bare_some(name, end);
            }
            Some(TokenKind::Open(Bracket::Curly)) => {
                let shown = &name.text;
                let message = format!("expected `(` after `{shown}`, found `{{`");
                let help = format!("fields are written in parentheses: `{shown}(...)`");
                self.report_with_help(self.span(self.at), message, help);
                return self.bracket(Some(name));
            }
            _ => {}
        }
        let mut node = self.node(name.span, Kind::Ident);
        node.name = Some(name);
        node
    }

    fn bare_some(&mut self, name: Name, end: usize) -> Node {
        let start = name.span.start;
        let kind = if self.deeper(name.span) {
            let value = self.value(end);
            self.depth -= 1;
            Kind::BareSome(Box::new(value))
        } else {
            self.at = end;
            Kind::Bad
        };
        let mut node = self.node(Span::new(start, self.last_byte()), kind);
        node.name = Some(name);
        node
    }

    /// Goes one level down; false, and a problem, if that is too deep.
    fn deeper(&mut self, place: Span) -> bool {
        if self.depth < MOST_NESTED {
            self.depth += 1;
            return true;
        }
        if !self.too_deep {
            self.too_deep = true;
            let message = format!("values are nested more than {MOST_NESTED} deep");
            self.report(place, message);
        }
        false
    }

    /// What stands in brackets, after `name`.
    fn bracket(&mut self, name: Option<Name>) -> Node {
        let opened = self.at;
        let open = self.span(opened);
        let start = name.as_ref().map_or(open.start, |name| name.span.start);
        let End { inside, after, guessed } = self.ends[opened];
        let mut lossy = guessed;
        self.at += 1;
        let kind = if self.deeper(open) {
            let kind = match self.tokens[opened].kind {
                TokenKind::Open(Bracket::Square) => Kind::List(self.list(inside, &mut lossy)),
                TokenKind::Open(Bracket::Curly) if name.is_none() => {
                    Kind::Map(self.map(inside, &mut lossy))
                }
                _ => self.group(inside, &mut lossy),
            };
            self.depth -= 1;
            kind
        } else {
            Kind::Bad
        };
        self.at = after;
        let mut node = self.node(Span::new(start, self.last_byte()), kind);
        if let Some(comma) = self.second_comma.take() {
            self.second_commas.insert(node.id, comma);
        }
        node.open = open.start;
        node.name = name;
        node.lossy = lossy;
        node
    }
}
