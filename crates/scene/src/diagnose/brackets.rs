//! Which bracket closes which, where some are missing, left over or of the wrong kind.
//!
//! A missing bracket shows only later, so where it is missing is guessed: from the layout first,
//! then from what stands inside the brackets. The guesses come into play only where the text has
//! fewer closing brackets left than it has brackets open.

use super::lexer::{Bracket, Token, TokenKind};
use super::problem::Problem;

/// The end of what an opening bracket opens, as indices of tokens.
#[derive(Clone, Copy, Debug)]
pub(super) struct End {
    /// The first token that is no longer inside.
    pub(super) inside: usize,
    /// The first token after the closing bracket, if there is one.
    pub(super) after: usize,
    /// Whether the end was guessed.
    pub(super) guessed: bool,
}

/// Pairs all brackets: for each token that opens something, its end.
pub(super) fn pair(
    text: &str,
    tokens: &[Token],
    cut_short: bool,
    problems: &mut Vec<Problem>,
) -> Vec<End> {
    let end = End { inside: tokens.len(), after: tokens.len(), guessed: true };
    let left = closers_left(tokens);
    let lines = lines(text, tokens);
    let ends = vec![end; tokens.len()];
    let mut pairing = Pairing { text, tokens, lines, left, stack: Vec::new(), ends, problems };
    for i in 0..tokens.len() {
        pairing.token(i);
    }
    if !cut_short {
        pairing.finish();
    }
    pairing.ends
}

/// For each token, how many more brackets close than open from there on.
fn closers_left(tokens: &[Token]) -> Vec<isize> {
    let mut left = vec![0; tokens.len()];
    let mut sum = 0;
    for (i, token) in tokens.iter().enumerate().rev() {
        sum += match token.kind {
            TokenKind::Open(_) => -1,
            TokenKind::Close(_) => 1,
            _ => 0,
        };
        left[i] = sum;
    }
    left
}

/// Where a token stands on the page.
#[derive(Clone, Copy)]
struct Line {
    /// How far the line of the token is indented.
    indent: usize,
    /// Whether the token is the first of its line.
    first: bool,
}

fn lines(text: &str, tokens: &[Token]) -> Vec<Line> {
    let mut out = Vec::with_capacity(tokens.len());
    let (mut indent, mut read) = (0, 0);
    for (i, token) in tokens.iter().enumerate() {
        let gap = text.get(read..token.span.start).unwrap_or_default();
        let newline = gap.rfind('\n');
        let first = newline.is_some() || i == 0;
        if first {
            indent = gap.len() - newline.map_or(0, |at| at + 1);
        }
        out.push(Line { indent, first });
        read = token.span.end;
    }
    out
}

/// A bracket that is open.
struct Frame {
    open: usize,
    bracket: Bracket,
    /// How many items there are inside that begin with `name:`, with `"key":`, with neither.
    fields: usize,
    keys: usize,
    plain: usize,
}

struct Pairing<'a> {
    text: &'a str,
    tokens: &'a [Token],
    lines: Vec<Line>,
    left: Vec<isize>,
    stack: Vec<Frame>,
    ends: Vec<End>,
    problems: &'a mut Vec<Problem>,
}

/// How an item begins.
#[derive(Clone, Copy, PartialEq)]
enum Start {
    Field,
    Key,
    Call,
    Other,
}

impl Pairing<'_> {
    fn kind(&self, i: usize) -> Option<&TokenKind> {
        self.tokens.get(i).map(|token| &token.kind)
    }

    /// Whether fewer brackets close from token `i` on than are open before it.
    fn too_few(&self, i: usize) -> bool {
        self.left[i] < self.stack.len().cast_signed()
    }

    fn token(&mut self, i: usize) {
        self.by_layout(i);
        if self.begins_item(i) {
            let start = self.start(i);
            self.by_content(i, start);
            if let Some(frame) = self.stack.last_mut() {
                match start {
                    Start::Field => frame.fields += 1,
                    Start::Key => frame.keys += 1,
                    Start::Call | Start::Other => frame.plain += 1,
                }
            }
        }
        match self.tokens[i].kind {
            TokenKind::Open(bracket) => {
                self.stack.push(Frame { open: i, bracket, fields: 0, keys: 0, plain: 0 });
            }
            TokenKind::Close(bracket) => self.close(i, bracket),
            _ => {}
        }
    }

    fn begins_item(&self, i: usize) -> bool {
        let before = i.checked_sub(1).and_then(|before| self.kind(before));
        matches!(before, Some(TokenKind::Comma | TokenKind::Open(_)))
            && self.kind(i).is_some_and(TokenKind::starts_value)
    }

    fn start(&self, i: usize) -> Start {
        match (self.kind(i), self.kind(i + 1)) {
            (Some(TokenKind::Ident { .. }), Some(TokenKind::Colon)) => Start::Field,
            (Some(TokenKind::Str(_)), Some(TokenKind::Colon)) => Start::Key,
            (Some(TokenKind::Ident { .. }), Some(TokenKind::Open(Bracket::Round))) => Start::Call,
            _ => Start::Other,
        }
    }

    /// Closes what a new line, indented no further than the bracket's line, leaves behind.
    fn by_layout(&mut self, i: usize) {
        let line = self.lines[i];
        if !line.first {
            return;
        }
        let closes = matches!(self.kind(i), Some(TokenKind::Close(_)));
        while let Some(top) = self.stack.last() {
            let opened = self.lines[top.open];
            // A closing bracket stands as far left as the line of its opening one.
            let behind = line.indent < opened.indent || (line.indent == opened.indent && !closes);
            // The outermost bracket may well stand left of, or as far as, what it holds.
            if !behind || self.stack.len() < 2 || !self.too_few(i) {
                break;
            }
            self.give_up(i);
        }
    }

    /// Closes what cannot hold an item that begins like this, if something around it can.
    fn by_content(&mut self, i: usize, start: Start) {
        let holds = |frame: &Frame| match start {
            Start::Field => frame.fields > 0 && frame.bracket == Bracket::Round,
            Start::Key => frame.keys > 0 && frame.bracket == Bracket::Curly,
            Start::Call => frame.plain > 0 && frame.bracket == Bracket::Square,
            Start::Other => false,
        };
        while self.too_few(i) {
            let Some((top, around)) = self.stack.split_last() else {
                break;
            };
            let strange = match start {
                Start::Field => top.fields == 0 && top.plain + top.keys > 0,
                Start::Key => top.keys == 0 && top.plain + top.fields > 0,
                Start::Call => top.fields > 0,
                Start::Other => false,
            };
            // One level for a call, since lists stand in lists; any number for names and keys.
            let reach = if start == Start::Call { 1 } else { around.len() };
            if !strange || !around.iter().rev().take(reach).any(holds) {
                break;
            }
            self.give_up(i);
        }
    }

    /// Ends the innermost bracket before token `i`, as never closed.
    fn give_up(&mut self, i: usize) {
        let Some(frame) = self.stack.pop() else {
            return;
        };
        self.report_unclosed(frame.open, 0);
        let comma = i > frame.open + 1 && self.kind(i - 1) == Some(&TokenKind::Comma);
        let inside = if comma { i - 1 } else { i };
        self.ends[frame.open] = End { inside, after: inside, guessed: true };
    }

    fn report_unclosed(&mut self, open: usize, around: usize) {
        let span = self.tokens[open].span;
        let mut problem = Problem::new(span, format!("`{}` is never closed", span.of(self.text)));
        if around == 1 {
            problem = problem.with_help("the bracket around it is not closed either");
        } else if around > 1 {
            let help = format!("neither are the {around} brackets around it");
            problem = problem.with_help(help);
        }
        self.problems.push(problem);
    }

    fn close(&mut self, i: usize, bracket: Bracket) {
        let depth = self.stack.len().cast_signed();
        let span = self.tokens[i].span;
        let shown = span.of(self.text);
        let Some(top) = self.stack.last() else {
            return self.problems.push(Problem::new(span, format!("`{shown}` closes nothing")));
        };
        let fits = top.bracket == bracket;
        // The last bracket should close the outermost one, so one before it does not; and fields
        // that follow are at home where fields came before.
        let fields_follow = self.kind(i + 1) == Some(&TokenKind::Comma)
            && self.start(i + 2) == Start::Field
            && top.fields > 0
            && self.stack.iter().nth_back(1).is_some_and(|around| around.fields == 0);
        let more_follows =
            self.kind(i + 1).is_some_and(|next| !matches!(next, TokenKind::Close(_)));
        let early = depth == 1 && more_follows || fields_follow;
        if self.left[i] > depth && (!fits || early) {
            return self.problems.push(Problem::new(span, format!("`{shown}` closes nothing")));
        }
        let partner = self.stack.iter().rposition(|frame| frame.bracket == bracket);
        let guessed = match partner {
            _ if fits => false,
            Some(partner) if self.too_few(i) => {
                while self.stack.len() > partner + 1 {
                    self.give_up(i);
                }
                false
            }
            _ => {
                let opened = self.tokens[top.open].span.of(self.text);
                let message = format!("expected `{}`, found `{shown}`", closer(top.bracket));
                let help = format!("the innermost open bracket is `{opened}`");
                self.problems.push(Problem::new(span, message).with_help(help));
                false
            }
        };
        if let Some(frame) = self.stack.pop() {
            self.ends[frame.open] = End { inside: i, after: i + 1, guessed };
        }
    }

    /// Reports what is open at the end of the text: one problem, for it was most likely cut off.
    fn finish(&mut self) {
        if let Some(top) = self.stack.last() {
            self.report_unclosed(top.open, self.stack.len() - 1);
        }
    }
}

/// The bracket that closes.
fn closer(bracket: Bracket) -> char {
    match bracket {
        Bracket::Round => ')',
        Bracket::Square => ']',
        Bracket::Curly => '}',
    }
}
