//! The fields of a struct or of a variant.

use serde::de::value::StrDeserializer;
use serde::de::{DeserializeSeed, Deserializer, MapAccess, Visitor};

use super::super::problem::Span;
use super::super::tree::{Kind, Name, Node};
use super::super::words;
use super::access::{nested, too_many_parentheses};
use super::dummy::Dummy;
use super::error::Error;
use super::{Mark, Run};

/// Where fields are written.
pub(super) struct Body<'a> {
    /// The node that has the fields.
    owner: &'a Node,
    entries: Vec<Entry<'a>>,
}

struct Entry<'a> {
    name: &'a str,
    place: Span,
    value: &'a Node,
}

/// Reports a name before a struct that is not the struct's.
pub(super) fn check_name(run: &Run<'_>, node: &Node, expected: &'static str) {
    let message = match &node.name {
        Some(name) if name.text != expected => {
            format!("expected the name `{expected}`, found `{}`", name.text)
        }
        None if run.tree.explicit_names => format!("expected the name `{expected}` before `(`"),
        _ => return,
    };
    let has_fields = matches!(node.kind, Kind::Struct(_) | Kind::Tuple(_));
    if has_fields {
        run.misshapen(node, node.anchor(), message, None);
    }
}

/// The fields of a node; nothing, and a problem, if it cannot have any.
pub(super) fn body<'a>(
    run: &Run<'_>,
    node: &'a Node,
    inside: bool,
    name: &str,
    known: &[&str],
) -> Option<Body<'a>> {
    let entry = |name: &'a Name, value| Entry { name: &name.text, place: name.span, value };
    let expected =
        if name.is_empty() { "fields in parentheses" } else { "`name: value` in parentheses" };
    let entries = match &node.kind {
        Kind::Struct(fields) => {
            fields.iter().map(|field| entry(&field.name, &field.value)).collect()
        }
        Kind::Tuple(items) => match items.as_slice() {
            [] => Vec::new(),
            [one] if inside && has_fields(one) => {
                too_many_parentheses(run, node, one);
                return body(run, one, false, name, known);
            }
            _ => {
                run.mismatch(node, expected, form(name, known));
                return None;
            }
        },
        Kind::Map(entries) => {
            let found = words::found(run.text, node);
            let message = format!("expected {expected}, found {found}");
            let help = Some("write `(name: value)` in place of `{\"name\": value}`".to_owned());
            run.misshapen(node, node.span, message, help);
            let keys = entries.iter().filter_map(|(key, value)| match (&key.kind, &key.name) {
                (Kind::Str(text), _) => Some(Entry { name: text, place: key.span, value }),
                (_, Some(name)) => Some(entry(name, value)),
                _ => None,
            });
            keys.collect()
        }
        _ => {
            run.mismatch(node, expected, form(name, known));
            return None;
        }
    };
    Some(Body { owner: node, entries })
}

/// How to write it, if its fields are known.
fn form(name: &str, known: &[&str]) -> Option<String> {
    let fields: Vec<_> = known.iter().map(|field| format!("{field}: ...")).collect();
    (!known.is_empty()).then(|| format!("write `{name}({})`", fields.join(", ")))
}

/// Whether this holds fields, or nothing, in parentheses.
fn has_fields(node: &Node) -> bool {
    match &node.kind {
        Kind::Struct(_) => true,
        Kind::Tuple(items) => items.is_empty(),
        _ => false,
    }
}

/// Reads the fields of the struct `label`, or of that variant.
pub(super) fn read<'de, V: Visitor<'de>>(
    run: &Run<'_>,
    body: Body<'_>,
    label: &str,
    variant: &str,
    known: &'static [&'static str],
    visitor: V,
) -> Result<V::Value, Error> {
    let owner = body.owner;
    if !run.deeper(owner) {
        return Dummy::default().deserialize_struct("", known, visitor);
    }
    let (required, closed) = {
        let mut facts = run.facts.borrow_mut();
        let fact = facts.of::<V>(variant);
        (fact.required.clone(), fact.closed)
    };
    let made = visitor.visit_map(Fields {
        run,
        owner,
        label,
        known,
        required: &required,
        closed,
        entries: body.entries,
        next: 0,
        seen: Vec::new(),
        value: None,
    });
    run.shallower();
    match made {
        Err(Error::MissingField(name)) if !required.contains(&name) => {
            run.facts.borrow_mut().of::<V>(variant).required.push(name);
            Err(run.retry())
        }
        Err(Error::UnknownField) if !closed => {
            run.facts.borrow_mut().of::<V>(variant).closed = true;
            Err(run.retry())
        }
        made => made,
    }
}

struct Fields<'a> {
    run: &'a Run<'a>,
    owner: &'a Node,
    label: &'a str,
    known: &'static [&'static str],
    required: &'a [&'static str],
    closed: bool,
    entries: Vec<Entry<'a>>,
    next: usize,
    seen: Vec<&'a str>,
    value: Option<&'a Node>,
}

impl<'a> Fields<'a> {
    /// The name that was meant by an entry.
    fn meant(&self, entry: &Entry<'a>) -> &'a str {
        self.run.meant.borrow().get(&entry.value.id).copied().unwrap_or(entry.name)
    }

    /// The next field that is written down, known and not a repetition.
    fn written(&mut self) -> Option<(&'a str, &'a Node)> {
        while let Some(entry) = self.entries.get(self.next) {
            self.next += 1;
            let value = entry.value;
            if entry.name.is_empty() || self.run.mark(value) == Mark::Replaced && self.skips(entry)
            {
                continue;
            }
            if self.closed && !self.known.contains(&self.meant(entry)) {
                self.unknown(entry);
            }
            let name = self.meant(entry);
            if self.closed && !self.known.contains(&name) {
                continue;
            }
            if self.seen.contains(&name) && self.known.contains(&name) {
                let message = format!("the field `{name}` is given twice");
                self.run.report(entry.place, message, None);
                self.run.set_mark(value, Mark::Replaced);
                continue;
            }
            return Some((name, value));
        }
        None
    }

    /// Whether a replaced value belongs to an entry that was reported as one too many.
    fn skips(&self, entry: &Entry<'a>) -> bool {
        let name = self.meant(entry);
        self.seen.contains(&name) || self.closed && !self.known.contains(&name)
    }

    fn unknown(&self, entry: &Entry<'a>) {
        let taken: Vec<&str> = self.entries.iter().map(|entry| self.meant(entry)).collect();
        let free = self.known.iter().copied().filter(|name| !taken.contains(name));
        let nearest = words::nearest(entry.name, free);
        let known = match self.known {
            [] => "it has no fields".to_owned(),
            known => format!("known here: {}", words::list(known)),
        };
        let help = match nearest {
            Some(name) => format!("did you mean `{name}`? {known}"),
            None => known,
        };
        let message = format!("unknown field `{}` in `{}`", entry.name, self.label);
        self.run.report(entry.place, message, Some(help));
        match self.known.iter().find(|name| Some(**name) == nearest) {
            Some(name) => {
                self.run.meant.borrow_mut().insert(entry.value.id, name);
            }
            None => self.run.set_mark(entry.value, Mark::Replaced),
        }
    }

    /// The next field that must be made up.
    fn made_up(&mut self) -> Option<&'static str> {
        let lacking = |name: &&&'static str| !self.seen.contains(*name);
        let name = *self.required.iter().find(lacking)?;
        let first = self.run.injected.borrow_mut().insert((self.owner.id, name));
        if first && !self.owner.lossy {
            let message = format!("`{}` has no field `{name}`, which it needs", self.label);
            self.run.report(self.owner.anchor(), message, None);
        }
        Some(name)
    }
}

impl<'de> MapAccess<'de> for Fields<'_> {
    type Error = Error;

    fn next_key_seed<S: DeserializeSeed<'de>>(
        &mut self,
        seed: S,
    ) -> Result<Option<S::Value>, Error> {
        self.value = None;
        let name = if let Some((name, value)) = self.written() {
            self.value = Some(value);
            // `ron` counts the name as a level of its own.
            if self.run.deeper(value) {
                self.run.shallower();
            }
            name
        } else if let Some(name) = self.made_up() {
            name
        } else {
            return Ok(None);
        };
        self.seen.push(name);
        seed.deserialize(StrDeserializer::new(name)).map(Some)
    }

    fn next_value_seed<S: DeserializeSeed<'de>>(&mut self, seed: S) -> Result<S::Value, Error> {
        match self.value.take() {
            Some(node) => nested(self.run, node, seed),
            None => seed.deserialize(Dummy::default()).map_err(|_| Error::Unfit),
        }
    }
}
