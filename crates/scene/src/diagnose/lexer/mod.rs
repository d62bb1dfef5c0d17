//! A text cut into tokens.
//!
//! Takes linear time, and any text: what is no token is a problem and left behind.

mod texts;

use super::literal::{continues_name, continues_raw_name, is_space, starts_name};
use super::problem::{Problem, Span};
use super::words::excerpt;

/// The tokens of a text.
pub(super) struct Lexed {
    pub(super) tokens: Vec<Token>,
    pub(super) problems: Vec<Problem>,
    /// Whether the end of the text was lost in a comment or text that is never closed.
    pub(super) cut_short: bool,
    /// Whether the text asks that structs have their names written.
    pub(super) explicit_names: bool,
}

/// A piece of the text that is not blank.
#[derive(Debug)]
pub(super) struct Token {
    pub(super) kind: TokenKind,
    pub(super) span: Span,
}

/// What a token is.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum TokenKind {
    Open(Bracket),
    Close(Bracket),
    Comma,
    Colon,
    /// A number, or something that begins like one.
    Number,
    Str(String),
    Char(char),
    Bytes(Vec<u8>),
    Ident {
        raw: bool,
    },
    /// A value that is wrong in itself, and reported.
    Bad,
    /// A character of no meaning, reported.
    Junk,
}

/// The pairs of brackets.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Bracket {
    Round,
    Square,
    Curly,
}

impl TokenKind {
    /// Whether a value may begin with this.
    pub(super) fn starts_value(&self) -> bool {
        !matches!(self, Self::Close(_) | Self::Comma | Self::Colon | Self::Junk)
    }
}

/// Cuts up a text.
pub(super) fn lex(text: &str) -> Lexed {
    let mut lexer = Lexer::new(text, false);
    if lexer.run() {
        return lexer.out;
    }
    // A text was never closed, so some quote is missing. It is most likely missing on the line
    // where a text goes on into the next.
    let mut lexer = Lexer::new(text, true);
    lexer.run();
    lexer.out
}

struct Lexer<'t> {
    text: &'t str,
    at: usize,
    /// Whether a text in quotes must end on its line.
    one_line_texts: bool,
    out: Lexed,
}

impl<'t> Lexer<'t> {
    fn new(text: &'t str, one_line_texts: bool) -> Self {
        let out = Lexed {
            tokens: Vec::new(),
            problems: Vec::new(),
            cut_short: false,
            explicit_names: false,
        };
        Self { text, at: 0, one_line_texts, out }
    }

    fn rest(&self) -> &'t str {
        &self.text[self.at..]
    }

    fn push(&mut self, kind: TokenKind, len: usize) {
        let span = Span::new(self.at, self.at + len);
        self.at = span.end;
        self.out.tokens.push(Token { kind, span });
    }

    fn report(&mut self, len: usize, message: impl Into<String>) -> &mut Problem {
        let problem = Problem::new(Span::new(self.at, self.at + len), message);
        let index = self.out.problems.len();
        self.out.problems.push(problem);
        &mut self.out.problems[index]
    }

    /// Whether every text in quotes was closed.
    fn run(&mut self) -> bool {
        const MARK: char = '\u{FEFF}';
        if self.rest().starts_with(MARK) {
            self.report(MARK.len_utf8(), "the file begins with a byte order mark").help =
                Some("save it as UTF-8 without this mark".to_owned());
            self.at = MARK.len_utf8();
        }
        self.blank();
        while self.rest().starts_with('#') && self.attribute() {
            self.blank();
        }
        while let Some(c) = self.rest().chars().next() {
            if !self.token(c) {
                return false;
            }
            self.blank();
        }
        true
    }

    /// Skips what is blank, comments included.
    fn blank(&mut self) {
        loop {
            let rest = self.rest();
            self.at += rest.len() - rest.trim_start_matches(is_space).len();
            let rest = self.rest();
            if rest.starts_with("//") {
                self.at += rest.find('\n').unwrap_or(rest.len());
            } else if rest.starts_with("/*") {
                self.at += self.block_comment();
            } else {
                break;
            }
        }
    }

    /// The length of the comment that begins here.
    fn block_comment(&mut self) -> usize {
        let rest = self.rest().as_bytes();
        let (mut depth, mut i) = (1, 2);
        while let Some(pair) = rest.get(i..i + 2) {
            match pair {
                b"/*" => (depth, i) = (depth + 1, i + 2),
                b"*/" => (depth, i) = (depth - 1, i + 2),
                _ => i += 1,
            }
            if depth == 0 {
                return i;
            }
        }
        self.report(2, "`/*` is never closed by `*/`");
        self.out.cut_short = true;
        rest.len()
    }

    /// An attribute `#![...]`; false if it has no end on which to go on.
    fn attribute(&mut self) -> bool {
        // A `]` may stand inside an attribute, in a text or comment: more than a few do not.
        const ENDS_TRIED: usize = 8;
        let rest = self.rest();
        let ends = || rest.match_indices(']').map(|(i, _)| i + 1);
        let whole =
            |&end: &usize| super::literal::read::<()>(&format!("{}()", &rest[..end])).is_some();
        if let Some(end) = ends().take(ENDS_TRIED).find(whole) {
            self.out.explicit_names |= rest[..end].contains("explicit_struct_names");
            self.at += end;
            return true;
        }
        let line = rest.find('\n').unwrap_or(rest.len());
        let Some(end) = ends().next().filter(|&end| rest.starts_with("#!") && end <= line) else {
            return false;
        };
        let message = format!("unknown attribute `{}`", excerpt(rest, Span::new(0, end)));
        self.report(end, message).help =
            Some("attributes look like `#![enable(implicit_some)]`".to_owned());
        self.at += end;
        true
    }

    /// Takes one token; false for a text without end.
    fn token(&mut self, c: char) -> bool {
        let rest = self.rest();
        match c {
            '(' => self.push(TokenKind::Open(Bracket::Round), 1),
            ')' => self.push(TokenKind::Close(Bracket::Round), 1),
            '[' => self.push(TokenKind::Open(Bracket::Square), 1),
            ']' => self.push(TokenKind::Close(Bracket::Square), 1),
            '{' => self.push(TokenKind::Open(Bracket::Curly), 1),
            '}' => self.push(TokenKind::Close(Bracket::Curly), 1),
            ',' => self.push(TokenKind::Comma, 1),
            ':' => self.push(TokenKind::Colon, 1),
            '"' => return self.quoted(0),
            '\'' => self.character(0),
            'b' if rest.starts_with("b\"") => return self.quoted(1),
            'b' if rest.starts_with("b'") => self.character(1),
            'b' if rest.starts_with("br\"") || rest.starts_with("br#") => self.raw_text(2),
            'r' if ["r\"", "r#\"", "r##"].iter().any(|start| rest.starts_with(start)) => {
                self.raw_text(1);
            }
            '0'..='9' | '+' | '-' | '.' => self.push(TokenKind::Number, length(rest, true)),
            _ if starts_name(c) => self.name(),
            '=' => self.instead_of(c, TokenKind::Colon, "a value follows its name after `:`"),
            ';' => self.instead_of(c, TokenKind::Comma, "values are separated by `,`"),
            _ => self.junk(),
        }
        true
    }

    fn instead_of(&mut self, c: char, meant: TokenKind, help: &str) {
        self.report(1, format!("unexpected `{c}`")).help = Some(help.to_owned());
        self.push(meant, 1);
    }

    fn name(&mut self) {
        let rest = self.rest();
        if let Some(raw) = rest.strip_prefix("r#") {
            match length(raw, true) {
                0 => self.junk(),
                len => self.push(TokenKind::Ident { raw: true }, len + 2),
            }
            return;
        }
        let len = length(rest, false);
        // `ron` takes `Some-1`, since `Some` needs no parentheses.
        if &rest[..len] == "Some" || !rest[len..].starts_with(['.', '+', '-']) {
            return self.push(TokenKind::Ident { raw: false }, len);
        }
        let whole = length(rest, true);
        let shown = excerpt(rest, Span::new(0, whole));
        self.report(whole, format!("`{shown}` is neither a name nor a number")).help =
            Some("names are letters, digits and `_`; texts are written in quotes".to_owned());
        self.push(TokenKind::Bad, whole);
    }

    /// Characters of no meaning, up to the next blank or bracket.
    fn junk(&mut self) {
        let rest = self.rest();
        let ends = |c: char| is_space(c) || c.is_ascii();
        let first = rest.chars().next().map_or(1, char::len_utf8);
        let len = match rest[first..].find(ends) {
            Some(len) if !rest.is_char_boundary(1) => first + len,
            None if !rest.is_char_boundary(1) => rest.len(),
            _ => first,
        };
        let shown = excerpt(rest, Span::new(0, len));
        let message = if rest[..len].chars().any(|c| c.is_control() || c.is_whitespace()) {
            format!("unexpected character `{}`", rest[..len].escape_unicode())
        } else {
            format!("unexpected `{shown}`")
        };
        self.report(len, message);
        self.push(TokenKind::Junk, len);
    }
}

/// The length of the number or name at the start of `text`.
fn length(text: &str, number: bool) -> usize {
    let goes_on = if number { continues_raw_name } else { continues_name };
    text.find(|c| !goes_on(c)).unwrap_or(text.len())
}
