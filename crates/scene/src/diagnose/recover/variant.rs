//! A variant of an enum.

use serde::de::value::StrDeserializer;
use serde::de::{DeserializeSeed, Deserializer, EnumAccess, VariantAccess, Visitor};

use super::super::problem::Span;
use super::super::tree::{Kind, Name, Node};
use super::super::words;
use super::dummy::Dummy;
use super::error::Error;
use super::value::Value;
use super::{Mark, Run, access, fields};

/// "one of `A`, `B`".
pub(super) fn one_of(names: &[&str]) -> String {
    match names {
        [only] => format!("`{only}`"),
        names => format!("one of {}", words::list(names)),
    }
}

/// Reads a variant of the enum that has the variants `names`.
pub(super) fn read<'de, V: Visitor<'de>>(
    run: &Run<'_>,
    node: &Node,
    name: &'static str,
    names: &'static [&'static str],
    visitor: V,
) -> Result<V::Value, Error> {
    let closed = run.facts.borrow_mut().of::<V>("").closed;
    let Some(tag) = tag(run, node, names, closed).filter(|_| levels(run, node)) else {
        return Dummy::default().deserialize_enum(name, names, visitor);
    };
    let made = visitor.visit_enum(Variant { run, node, tag });
    run.shallower();
    match made {
        Err(Error::UnknownVariant) if !closed => {
            run.facts.borrow_mut().of::<V>("").closed = true;
            Err(run.retry())
        }
        made => made,
    }
}

/// Goes down into a variant, for which `ron` needs one level, and one more for its name.
fn levels(run: &Run<'_>, node: &Node) -> bool {
    if !run.deeper(node) {
        return false;
    }
    let enough = run.deeper(node);
    run.shallower();
    enough
}

/// The name of the variant that is written, or was meant; nothing, and a problem, if there is none.
fn tag<'a>(
    run: &Run<'_>,
    node: &'a Node,
    names: &'static [&'static str],
    closed: bool,
) -> Option<&'a str> {
    let name = match (&node.kind, &node.name) {
        (Kind::Ident | Kind::Tuple(_) | Kind::Struct(_), Some(name)) => name,
        (kind, _) => {
            let help = match kind {
                Kind::Str(text) if names.contains(&text.as_str()) => {
                    Some(format!("write `{text}`, without quotes"))
                }
                _ => None,
            };
            run.mismatch(node, &one_of(names), help);
            return None;
        }
    };
    if let Some(meant) = run.variants.borrow().get(&node.id) {
        return Some(meant);
    }
    if !closed || names.contains(&name.text.as_str()) {
        return Some(&name.text);
    }
    unknown(run, node, name, names)
}

fn unknown(
    run: &Run<'_>,
    node: &Node,
    name: &Name,
    names: &'static [&'static str],
) -> Option<&'static str> {
    let nearest = words::nearest(&name.text, names.iter().copied());
    let message = format!("unknown variant `{}`; expected {}", name.text, one_of(names));
    run.report(name.span, message, nearest.map(|name| format!("did you mean `{name}`?")));
    let meant = names.iter().copied().find(|name| Some(*name) == nearest);
    match meant {
        Some(meant) => {
            run.variants.borrow_mut().insert(node.id, meant);
        }
        None => run.set_mark(node, Mark::Replaced),
    }
    meant
}

struct Variant<'a> {
    run: &'a Run<'a>,
    node: &'a Node,
    tag: &'a str,
}

impl Variant<'_> {
    /// Whether the variant's name is only the nearest to the one written, which is reported.
    fn is_guessed(&self) -> bool {
        self.run.variants.borrow().contains_key(&self.node.id)
    }

    /// Whether the variant has parentheses, as it should; reports it otherwise.
    fn has_parentheses(&self, holds: &str) -> bool {
        if !matches!(self.node.kind, Kind::Ident) {
            return true;
        }
        if !self.is_guessed() {
            let message = format!("`{0}` needs {holds}: `{0}(...)`", self.tag);
            self.run.report(self.node.span, message, None);
        }
        self.run.set_mark(self.node, Mark::Replaced);
        false
    }
}

impl<'de> EnumAccess<'de> for Variant<'_> {
    type Error = Error;
    type Variant = Self;

    fn variant_seed<S: DeserializeSeed<'de>>(self, seed: S) -> Result<(S::Value, Self), Error> {
        Ok((seed.deserialize(StrDeserializer::new(self.tag))?, self))
    }
}

impl<'de> VariantAccess<'de> for Variant<'_> {
    type Error = Error;

    fn unit_variant(self) -> Result<(), Error> {
        if !matches!(self.node.kind, Kind::Ident) && !self.is_guessed() {
            let place = Span::new(self.node.open, self.node.span.end);
            let message = format!("`{}` takes no values", self.tag);
            let help = Some("leave out the parentheses".to_owned());
            self.run.misshapen(self.node, place, message, help);
        }
        Ok(())
    }

    fn newtype_variant_seed<S: DeserializeSeed<'de>>(self, seed: S) -> Result<S::Value, Error> {
        if self.has_parentheses("a value") && self.run.deeper(self.node) {
            let made = seed.deserialize(Value::inside(self.run, self.node));
            self.run.shallower();
            return self.run.settle(self.node, made);
        }
        seed.deserialize(Dummy::default())
    }

    fn tuple_variant<V: Visitor<'de>>(self, len: usize, visitor: V) -> Result<V::Value, Error> {
        if self.has_parentheses(&words::values(len)) {
            if let Kind::Tuple(items) = &self.node.kind {
                return access::elements(self.run, self.node, items, Some(len), visitor);
            }
            let expected = format!("{} in parentheses", words::values(len));
            self.run.mismatch(self.node, &expected, None);
        }
        Dummy::default().deserialize_tuple(len, visitor)
    }

    fn struct_variant<V: Visitor<'de>>(
        self,
        names: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Error> {
        if self.has_parentheses("fields")
            && let Some(body) = fields::body(self.run, self.node, false, self.tag, names)
        {
            return fields::read(self.run, body, self.tag, self.tag, names, visitor);
        }
        Dummy::default().deserialize_struct("", names, visitor)
    }
}
