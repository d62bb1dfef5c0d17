//! What stands in parentheses: values, or fields, or both by mistake.

use super::super::lexer::{Bracket, TokenKind};
use super::super::problem::Span;
use super::super::tree::{Field, Kind, Name, Node};
use super::super::words::excerpt;
use super::Parser;

/// An item as it was read, before it is known what the parentheses hold.
enum Item {
    /// `name: value`.
    Field(Name, Node),
    /// `name value`.
    NoColon(Name, Node),
    /// A value; `true` if a comma is missing before it.
    Plain(Node, bool),
}

impl Parser<'_> {
    /// The items up to `end`.
    pub(super) fn group(&mut self, end: usize, lossy: &mut bool) -> Kind {
        let start = self.at;
        let mut items = Vec::new();
        while let Some(lost_comma) = self.next_item(start, end, lossy) {
            items.push(self.item(end, lost_comma, lossy));
        }
        let fields = items.iter().filter(|item| matches!(item, Item::Field(..))).count();
        let plain = items.iter().filter(|item| matches!(item, Item::Plain(..))).count();
        let no_colon = items.len() - fields - plain;
        let plain_first = matches!(items.first(), Some(Item::Plain(..)));
        let is_struct = if fields > 0 { !plain_first || fields >= plain } else { no_colon > plain };
        if is_struct {
            Kind::Struct(self.fields(items, lossy))
        } else {
            Kind::Tuple(self.values(items, lossy))
        }
    }

    fn item(&mut self, end: usize, lost_comma: bool, lossy: &mut bool) -> Item {
        let at = self.at;
        let next = self.kind(at + 1, end);
        match self.kind(at, end) {
            Some(TokenKind::Ident { .. }) if next == Some(&TokenKind::Colon) => {
                let name = self.name(at);
                self.at += 1;
                Item::Field(name, self.after_name(end))
            }
            Some(TokenKind::Str(text)) if next == Some(&TokenKind::Colon) => {
                let name = Name { text: text.clone(), raw: false, span: self.span(at) };
                let shown = self.shown(at);
                let message = format!("expected the name of a field, found the text `{shown}`");
                let help = format!("names have no quotes: `{}: ...`", name.text);
                self.report_with_help(name.span, message, help);
                self.at += 1;
                Item::Field(name, self.after_name(end))
            }
            Some(TokenKind::Bad) if next == Some(&TokenKind::Colon) => {
                *lossy = true;
                let name = self.name(at);
                self.at += 1;
                Item::Field(Name { text: String::new(), ..name }, self.after_name(end))
            }
            Some(TokenKind::Ident { .. }) if self.lacks_colon(end) => {
                let name = self.name(at);
                self.at += 1;
                Item::NoColon(name, self.value(end))
            }
            _ => Item::Plain(self.value(end), lost_comma),
        }
    }

    /// Whether the name here is followed by a value that cannot belong to it.
    fn lacks_colon(&self, end: usize) -> bool {
        let name = self.span(self.at).of(self.text);
        match self.kind(self.at + 1, end) {
            Some(TokenKind::Open(Bracket::Round)) | None => false,
            Some(TokenKind::Open(Bracket::Curly)) => is_field_name(name),
            // `(radius, material: ...)` lacks more, and `(red green: 1)` lacks a comma.
            Some(TokenKind::Ident { .. }) => {
                name != "Some" && self.kind(self.at + 2, end) != Some(&TokenKind::Colon)
            }
            Some(next) => next.starts_value() && name != "Some",
        }
    }

    fn fields(&mut self, items: Vec<Item>, lossy: &mut bool) -> Vec<Field> {
        let mut fields = Vec::new();
        for item in items {
            match item {
                Item::Field(name, value) => fields.push(Field { name, value }),
                Item::NoColon(name, value) => {
                    self.report(name.span, format!("expected `:` after `{}`", name.text));
                    fields.push(Field { name, value });
                }
                Item::Plain(value, lost_comma) => {
                    if let Some(field) = self.nameless(value, lost_comma || *lossy) {
                        fields.push(field);
                    } else {
                        *lossy = true;
                    }
                }
            }
        }
        fields
    }

    /// A value among fields, which may be a field whose colon is missing.
    fn nameless(&mut self, mut value: Node, reported: bool) -> Option<Field> {
        if matches!(value.kind, Kind::Bad) {
            return None;
        }
        let name = value.name.take().filter(|name| is_field_name(&name.text));
        if let Some(name) = name {
            let kind = match value.kind {
                Kind::Ident if !reported => {
                    let message = format!("expected `:` and a value after `{}`", name.text);
                    self.report(name.span, message);
                    Kind::Bad
                }
                Kind::Ident => Kind::Bad,
                kind => {
                    self.report(name.span, format!("expected `:` after `{}`", name.text));
                    kind
                }
            };
            value = Node { span: Span::new(value.open, value.span.end), kind, ..value };
            return Some(Field { name, value });
        }
        if !reported {
            let shown = excerpt(self.text, value.span);
            self.report(value.span, format!("expected the name of a field before `{shown}`"));
        }
        None
    }

    fn values(&mut self, items: Vec<Item>, lossy: &mut bool) -> Vec<Node> {
        let mut values = Vec::new();
        for item in items {
            match item {
                Item::Plain(value, _) => values.push(value),
                Item::Field(name, value) => {
                    let message = format!("unexpected name `{}` among values", name.text);
                    if !name.text.is_empty() && !*lossy {
                        self.report(name.span, message);
                    }
                    values.push(value);
                    *lossy = true;
                }
                Item::NoColon(name, value) => {
                    let shown = excerpt(self.text, value.span);
                    self.report(value.span, format!("expected `,` before `{shown}`"));
                    let mut first = self.node(name.span, Kind::Ident);
                    first.name = Some(name);
                    values.extend([first, value]);
                }
            }
        }
        values
    }
}

/// Whether this is written like a field: keywords and variants are not.
fn is_field_name(name: &str) -> bool {
    name.starts_with(|c: char| c.is_lowercase() || c == '_')
        && !matches!(name, "true" | "false" | "inf")
}
