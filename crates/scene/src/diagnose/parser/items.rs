//! What is between brackets, separated by commas.

use super::super::lexer::TokenKind;
use super::super::problem::Span;
use super::super::tree::{Kind, Node};
use super::super::words::excerpt;
use super::Parser;

impl Parser<'_> {
    /// Moves to the next item before `end`; nothing if there is none. `true` after a lost comma.
    pub(super) fn next_item(&mut self, start: usize, end: usize, lossy: &mut bool) -> Option<bool> {
        let mut lost_comma = false;
        if self.at > start {
            let mut separated = false;
            while matches!(self.kind(self.at, end), Some(TokenKind::Junk | TokenKind::Close(_))) {
                separated = true;
                self.at += 1;
            }
            match self.kind(self.at, end)? {
                TokenKind::Comma => self.at += 1,
                _ if separated => *lossy = true,
                TokenKind::Colon => {
                    self.report(self.span(self.at), "unexpected `:`");
                    (lost_comma, *lossy) = (true, true);
                    self.at += 1;
                }
                _ => {
                    let message = format!("expected `,` before `{}`", self.shown(self.at));
                    self.report(self.span(self.at), message);
                    lost_comma = true;
                }
            }
        }
        self.skip_empty_items(start, end, lossy);
        self.kind(self.at, end).map(|_| lost_comma)
    }

    /// Reports commas, and colons, before which a value is missing: one problem for a run of them.
    fn skip_empty_items(&mut self, start: usize, end: usize, lossy: &mut bool) {
        let first = self.at;
        self.second_comma = None;
        self.skip_junk(end);
        let empty = |kind: Option<&TokenKind>| {
            matches!(kind, Some(TokenKind::Comma | TokenKind::Colon | TokenKind::Junk))
        };
        if self.at == first && empty(self.kind(first, end)) {
            let span = self.span(first);
            let sign = span.of(self.text);
            // What was written in place of a comma is reported already.
            if matches!(sign, "," | ":") {
                self.report(span, format!("expected a value before `{sign}`"));
            }
            if sign == "," && first > start && first + 1 == end {
                // Nothing is lost between the last two commas.
                self.second_comma = Some(span);
                self.at = end;
                return;
            }
        }
        while empty(self.kind(self.at, end)) {
            *lossy = true;
            self.at += 1;
        }
        self.skip_junk(end);
    }

    pub(super) fn list(&mut self, end: usize, lossy: &mut bool) -> Vec<Node> {
        let start = self.at;
        let mut items = Vec::new();
        while self.next_item(start, end, lossy).is_some() {
            items.push(self.value(end));
        }
        items
    }

    pub(super) fn map(&mut self, end: usize, lossy: &mut bool) -> Vec<(Node, Node)> {
        let start = self.at;
        let mut entries = Vec::new();
        while self.next_item(start, end, lossy).is_some() {
            let key = self.value(end);
            let value = self.after_name(end);
            entries.push((key, value));
        }
        entries
    }

    /// The value of a name or key, with the colon between.
    pub(super) fn after_name(&mut self, end: usize) -> Node {
        let name = self.span(self.at - 1);
        let shown = excerpt(self.text, name);
        match self.kind(self.at, end) {
            Some(TokenKind::Colon) => {
                self.at += 1;
                self.skip_junk(end);
                if self.kind(self.at, end).is_some_and(TokenKind::starts_value) {
                    return self.value(end);
                }
                let junk = self.kind(self.at - 1, end) == Some(&TokenKind::Junk);
                if !junk && !self.is_cut_off() {
                    self.report(name, format!("expected a value after `{shown}:`"));
                }
                let place = self.span(self.at).start;
                self.node(Span::new(place, place), Kind::Bad)
            }
            None | Some(TokenKind::Comma | TokenKind::Close(_)) => {
                if !self.is_cut_off() {
                    self.report(name, format!("expected `:` and a value after `{shown}`"));
                }
                self.node(Span::new(name.end, name.end), Kind::Bad)
            }
            Some(TokenKind::Junk) => {
                self.skip_junk(end);
                if self.kind(self.at, end).is_some_and(TokenKind::starts_value) {
                    return self.value(end);
                }
                self.node(Span::new(name.end, name.end), Kind::Bad)
            }
            Some(_) => {
                self.report(name, format!("expected `:` after `{shown}`"));
                self.value(end)
            }
        }
    }
}
