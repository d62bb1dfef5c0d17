//! Lists, tuples and maps, element by element.

use serde::de::value::StrDeserializer;
use serde::de::{DeserializeSeed, Deserializer, MapAccess, SeqAccess, Visitor};

use super::super::literal;
use super::super::tree::{Kind, Node};
use super::super::words;
use super::dummy::Dummy;
use super::error::Error;
use super::value::Value;
use super::{Mark, Run, fields};

/// The values of a tuple of `len`; nothing if the node is none.
pub(super) fn tuple_items<'a>(
    run: &Run<'_>,
    node: &'a Node,
    inside: bool,
    name: Option<&'static str>,
    len: usize,
) -> Option<&'a [Node]> {
    match &node.kind {
        Kind::Tuple(items) if inside => match items.as_slice() {
            [one] if len != 1 => match &one.kind {
                Kind::Tuple(inner) | Kind::List(inner) => {
                    too_many_parentheses(run, node, one);
                    Some(inner)
                }
                _ => {
                    run.unwrapped(node);
                    Some(items)
                }
            },
            items => {
                run.unwrapped(node);
                Some(items)
            }
        },
        Kind::Tuple(items) => {
            check_tuple_name(run, node, name);
            Some(items)
        }
        Kind::List(items) => {
            let (expected, found) = (words::values(len), words::found(run.text, node));
            let message = format!("expected {expected} in parentheses, found {found}");
            let help = Some("write `(...)` in place of `[...]`".to_owned());
            run.misshapen(node, node.span, message, help);
            Some(items)
        }
        _ => None,
    }
}

/// Reports brackets of their own around what stands in the parentheses of a variant or `Some`.
pub(super) fn too_many_parentheses(run: &Run<'_>, node: &Node, inner: &Node) {
    let shown = words::excerpt(run.text, inner.span);
    let within = inner.span.of(run.text);
    let body = within.get(inner.open - inner.span.start + 1..within.len() - 1).unwrap_or("...");
    let name = node.name.as_ref().map_or("", |name| &name.text);
    let whole = super::super::problem::Span::new(0, body.len());
    let help = format!("write `{name}({})`", words::excerpt(body, whole));
    let message = format!("`{shown}` needs no brackets of its own in `{name}(...)`");
    run.misshapen(node, inner.span, message, Some(help));
}

/// Reports a name before a tuple that `ron` does not take.
fn check_tuple_name(run: &Run<'_>, node: &Node, expected: Option<&'static str>) {
    let problem = match (&node.name, expected) {
        (Some(name), None) => format!("expected values in parentheses, found `{}`", name.text),
        (Some(name), Some(expected)) if name.text != expected => {
            format!("expected the name `{expected}`, found `{}`", name.text)
        }
        (Some(name), Some(_)) if name.span.end != node.open => {
            format!("expected `(` right after `{}`", name.text)
        }
        (None, Some(expected)) if run.tree.explicit_names => {
            format!("expected the name `{expected}` before `(`")
        }
        _ => return,
    };
    run.misshapen(node, node.anchor(), problem, None);
}

/// Reads the values `items` of `node`, which should be `len`, or any number of them.
pub(super) fn elements<'de, V: Visitor<'de>>(
    run: &Run<'_>,
    node: &Node,
    items: &[Node],
    len: Option<usize>,
    visitor: V,
) -> Result<V::Value, Error> {
    if !run.deeper(node) {
        return match len {
            Some(len) => Dummy::default().deserialize_tuple(len, visitor),
            None => Dummy::default().deserialize_seq(visitor),
        };
    }
    let report_count = |len: usize| {
        let found = items.len();
        let message = format!("expected {} in parentheses, found {found}", words::values(len));
        if node.lossy {
            run.set_mark(node, Mark::Misshapen);
        } else {
            run.misshapen(node, node.span, message, None);
        }
    };
    let exact = run.facts.borrow_mut().of::<V>("").exact;
    let lacking = len.map_or(0, |len| len.saturating_sub(items.len()));
    if exact && lacking > 0 {
        report_count(items.len() + lacking);
    }
    let made_up = if exact { lacking } else { 0 };
    let mut elements = Elements { run, items, made_up };
    let made = visitor.visit_seq(&mut elements);
    let left = elements.items.len();
    run.shallower();
    match made {
        Ok(value) => {
            if left > 0 {
                report_count(items.len() - left);
            }
            Ok(value)
        }
        Err(Error::Length { .. }) if !exact && lacking > 0 => {
            run.facts.borrow_mut().of::<V>("").exact = true;
            Err(run.retry())
        }
        Err(error) => Err(error),
    }
}

struct Elements<'a> {
    run: &'a Run<'a>,
    items: &'a [Node],
    /// How many values are given after the last one.
    made_up: usize,
}

impl<'de> SeqAccess<'de> for Elements<'_> {
    type Error = Error;

    fn next_element_seed<S: DeserializeSeed<'de>>(
        &mut self,
        seed: S,
    ) -> Result<Option<S::Value>, Error> {
        if let Some((node, items)) = self.items.split_first() {
            self.items = items;
            return nested(self.run, node, seed).map(Some);
        }
        let Some(made_up) = self.made_up.checked_sub(1) else {
            return Ok(None);
        };
        self.made_up = made_up;
        seed.deserialize(Dummy::default()).map(Some).map_err(|_| Error::Unfit)
    }
}

/// Reads a value inside another one.
pub(super) fn nested<'de, S: DeserializeSeed<'de>>(
    run: &Run<'_>,
    node: &Node,
    seed: S,
) -> Result<S::Value, Error> {
    let made = if run.deeper(node) {
        let made = seed.deserialize(Value::new(run, node));
        run.shallower();
        made
    } else {
        seed.deserialize(Dummy::default())
    };
    run.settle(node, made)
}

/// Reads a map.
pub(super) fn map<'de, V: Visitor<'de>>(
    run: &Run<'_>,
    node: &Node,
    visitor: V,
) -> Result<V::Value, Error> {
    let expected = "a map in braces";
    let entries: Vec<(Key<'_>, &Node)> = match &node.kind {
        Kind::Map(entries) => entries.iter().map(|(key, value)| (Key::Node(key), value)).collect(),
        Kind::Struct(fields) if node.name.is_none() => {
            let found = words::found(run.text, node);
            let message = format!("expected {expected}, found {found}");
            let help = Some("maps are written `{\"key\": value}`".to_owned());
            run.misshapen(node, node.span, message, help);
            fields.iter().map(|field| (Key::Name(&field.name.text), &field.value)).collect()
        }
        _ => {
            run.mismatch(node, expected, None);
            return Dummy::default().deserialize_map(visitor);
        }
    };
    if !run.deeper(node) {
        return Dummy::default().deserialize_map(visitor);
    }
    let made = visitor.visit_map(Entries { run, left: entries.into_iter(), value: None });
    run.shallower();
    made
}

enum Key<'a> {
    Node(&'a Node),
    Name(&'a str),
}

struct Entries<'a, I> {
    run: &'a Run<'a>,
    left: I,
    value: Option<&'a Node>,
}

impl<'a, 'de, I: Iterator<Item = (Key<'a>, &'a Node)>> MapAccess<'de> for Entries<'a, I> {
    type Error = Error;

    fn next_key_seed<S: DeserializeSeed<'de>>(
        &mut self,
        seed: S,
    ) -> Result<Option<S::Value>, Error> {
        let Some((key, value)) = self.left.next() else {
            return Ok(None);
        };
        self.value = Some(value);
        match key {
            Key::Node(node) => nested(self.run, node, seed).map(Some),
            Key::Name(name) => seed.deserialize(StrDeserializer::new(name)).map(Some),
        }
    }

    fn next_value_seed<S: DeserializeSeed<'de>>(&mut self, seed: S) -> Result<S::Value, Error> {
        match self.value.take() {
            Some(node) => nested(self.run, node, seed),
            None => seed.deserialize(Dummy::default()),
        }
    }
}

/// Reads whatever is there, for types that decide by what they see.
pub(super) fn any<'de, V: Visitor<'de>>(
    value: Value<'_>,
    run: &Run<'_>,
    node: &Node,
    inside: bool,
    visitor: V,
) -> Result<V::Value, Error> {
    if run.is_replaced(node) {
        return visitor.visit_unit();
    }
    let source = node.span.of(run.text);
    match &node.kind {
        Kind::Tuple(items) if items.is_empty() => visitor.visit_unit(),
        Kind::Tuple(items) if inside && items.len() == 1 => {
            any(Value::new(run, &items[0]), run, &items[0], false, visitor)
        }
        Kind::Tuple(_) | Kind::BareSome(_) if !inside && node.is_keyword("Some") => {
            value.deserialize_option(visitor)
        }
        Kind::Tuple(items) | Kind::List(items) => elements(run, node, items, None, visitor),
        Kind::Struct(_) => match fields::body(run, node, inside, "", &[]) {
            Some(body) => fields::read(run, body, "", "", &[], visitor),
            None => visitor.visit_unit(),
        },
        Kind::Map(_) => map(run, node, visitor),
        Kind::Str(text) => visitor.visit_str(text),
        Kind::Char(c) => visitor.visit_char(*c),
        Kind::Bytes(bytes) => visitor.visit_bytes(bytes),
        Kind::Ident if node.is_keyword("None") => visitor.visit_none(),
        Kind::Number | Kind::Ident => {
            if let Some(number) = literal::read::<u64>(source) {
                visitor.visit_u64(number)
            } else if let Some(number) = literal::read::<i64>(source) {
                visitor.visit_i64(number)
            } else if let Some(number) = literal::read::<f64>(source) {
                visitor.visit_f64(number)
            } else if let Some(truth) = literal::read::<bool>(source) {
                visitor.visit_bool(truth)
            } else if matches!(node.kind, Kind::Number) {
                run.mismatch(node, "a number", None);
                visitor.visit_f64(1.0)
            } else {
                visitor.visit_unit()
            }
        }
        Kind::Bad | Kind::BareSome(_) => visitor.visit_unit(),
    }
}
