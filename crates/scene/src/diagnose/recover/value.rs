//! A node of the tree as serde's deserializer.

use serde::de::{Deserialize, DeserializeOwned, Deserializer, Visitor};

use super::super::literal;
use super::super::tree::{Kind, Node};
use super::super::words;
use super::dummy::Dummy;
use super::error::Error;
use super::{Run, access, fields, variant};

/// A value to be read.
#[derive(Clone, Copy)]
pub(super) struct Value<'a> {
    run: &'a Run<'a>,
    node: &'a Node,
    /// Whether the value is what is in the parentheses of `node`, as of `Some(...)` or a variant.
    ///
    /// Tuples and structs have no parentheses of their own there.
    inside: bool,
}

impl<'a> Value<'a> {
    pub(super) fn new(run: &'a Run<'a>, node: &'a Node) -> Self {
        Self { run, node, inside: false }
    }

    pub(super) fn inside(run: &'a Run<'a>, node: &'a Node) -> Self {
        Self { run, node, inside: true }
    }

    /// The node of a value that is one whole; nothing if a stand-in must do.
    fn sole(&self, expected: &str) -> Option<&'a Node> {
        if self.run.is_replaced(self.node) {
            return None;
        }
        if !self.inside {
            return Some(self.node);
        }
        let found = match &self.node.kind {
            Kind::Tuple(items) => match items.as_slice() {
                [one] => return (!self.run.is_replaced(one)).then_some(one),
                [] => "nothing".to_owned(),
                items => words::values(items.len()),
            },
            _ => "fields".to_owned(),
        };
        if !self.node.lossy {
            let name = self.node.name.as_ref().map_or("", |name| &name.text);
            let message = format!("expected {expected} in `{name}(...)`, found {found}");
            self.run.report(self.node.span, message, None);
        }
        self.run.set_mark(self.node, super::Mark::Replaced);
        None
    }

    /// The value of a literal that `ron` reads as a `T`.
    fn literal<T: DeserializeOwned>(&self, expected: &str) -> Option<T> {
        let node = self.sole(expected)?;
        let source = node.span.of(self.run.text);
        let read = match node.kind {
            Kind::Number | Kind::Char(_) | Kind::Ident => literal::read(source),
            _ => None,
        };
        if read.is_none() {
            self.run.mismatch(node, expected, literal_help(node, source));
        }
        read
    }

    fn text(&self) -> Option<&'a str> {
        let expected = "a text in quotes";
        let node = self.sole(expected)?;
        if let Kind::Str(text) = &node.kind {
            return Some(text);
        }
        let help = match &node.kind {
            Kind::Ident => Some(format!("write `\"{}\"`", node.span.of(self.run.text))),
            _ => None,
        };
        self.run.mismatch(node, expected, help);
        None
    }

    fn tuple<'de, V: Visitor<'de>>(
        self,
        name: Option<&'static str>,
        len: usize,
        visitor: V,
    ) -> Result<V::Value, Error> {
        let expected = format!("{} in parentheses", words::values(len));
        if !self.run.is_replaced(self.node) {
            match access::tuple_items(self.run, self.node, self.inside, name, len) {
                Some(items) => {
                    return access::elements(self.run, self.node, items, Some(len), visitor);
                }
                None => self.run.mismatch(self.node, &expected, None),
            }
        }
        Dummy::default().deserialize_tuple(len, visitor)
    }

    /// What is in a `Some(...)`; `Err` holds the verdict if it is not that.
    fn option(&self) -> Result<Self, bool> {
        let first = match &self.node.kind {
            Kind::Tuple(items) if self.inside => items.first(),
            _ if self.inside => None,
            _ => Some(self.node),
        };
        let Some(first) = first else { return Ok(*self) };
        if !first.is_keyword("None") && !first.is_keyword("Some") {
            return Ok(*self);
        }
        let Some(node) = self.sole("one value") else {
            return Err(false);
        };
        match &node.kind {
            Kind::Ident if node.is_keyword("None") => return Err(false),
            Kind::BareSome(inner) => return Ok(Self::new(self.run, inner)),
            Kind::Tuple(_) | Kind::Struct(_) if node.is_keyword("Some") => {
                return Ok(Self::inside(self.run, node));
            }
            _ => {}
        }
        let expected = if node.is_keyword("None") { "`None` alone" } else { "`Some(...)`" };
        self.run.mismatch(node, expected, None);
        Err(false)
    }
}

/// How a wrong literal may be put right.
fn literal_help(node: &Node, source: &str) -> Option<String> {
    let suffixes = ["f32", "f64", "i8", "i16", "i32", "i64", "u8", "u16", "u32", "u64"];
    let suffix = suffixes.iter().find(|suffix| source.ends_with(**suffix))?;
    let digits = source.strip_suffix(suffix).filter(|_| matches!(node.kind, Kind::Number))?;
    Some(format!("write `{digits}`, without the type"))
}

/// Methods that read a literal, or feed a stand-in.
macro_rules! literals {
    ($($method:ident => $visit:ident($type:ty, $expected:expr, $dummy:expr);)*) => {
        $(fn $method<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Error> {
            visitor.$visit(self.literal::<$type>(&$expected).unwrap_or($dummy))
        })*
    };
}

macro_rules! range {
    ($type:ty) => {
        format!("a whole number from {} to {}", <$type>::MIN, <$type>::MAX)
    };
}

impl<'de> Deserializer<'de> for Value<'_> {
    type Error = Error;

    literals! {
        deserialize_bool => visit_bool(bool, "`true` or `false`", false);
        deserialize_i8 => visit_i8(i8, range!(i8), 1);
        deserialize_i16 => visit_i16(i16, range!(i16), 1);
        deserialize_i32 => visit_i32(i32, range!(i32), 1);
        deserialize_i64 => visit_i64(i64, range!(i64), 1);
        deserialize_u8 => visit_u8(u8, range!(u8), 1);
        deserialize_u16 => visit_u16(u16, range!(u16), 1);
        deserialize_u32 => visit_u32(u32, range!(u32), 1);
        deserialize_u64 => visit_u64(u64, range!(u64), 1);
        deserialize_f32 => visit_f32(f32, "a number", 1.0);
        deserialize_f64 => visit_f64(f64, "a number", 1.0);
        deserialize_char => visit_char(char, "one character in single quotes", 'a');
    }

    fn deserialize_str<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Error> {
        visitor.visit_str(self.text().unwrap_or_default())
    }

    fn deserialize_string<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Error> {
        self.deserialize_str(visitor)
    }

    fn deserialize_bytes<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Error> {
        self.deserialize_byte_buf(visitor)
    }

    fn deserialize_byte_buf<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Error> {
        let expected = "bytes as `b\"...\"`";
        let Some(node) = self.sole(expected) else {
            return visitor.visit_bytes(&[]);
        };
        match &node.kind {
            Kind::Bytes(bytes) => visitor.visit_bytes(bytes),
            Kind::List(_) => visitor.visit_byte_buf(Vec::deserialize(self)?),
            _ => {
                self.run.mismatch(node, expected, None);
                visitor.visit_bytes(&[])
            }
        }
    }

    fn deserialize_option<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Error> {
        if self.run.is_replaced(self.node) {
            return visitor.visit_none();
        }
        match self.option() {
            Ok(value) if self.run.deeper(value.node) => {
                let made = visitor.visit_some(value);
                self.run.shallower();
                self.run.settle(value.node, made)
            }
            _ => visitor.visit_none(),
        }
    }

    fn deserialize_unit<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Error> {
        let empty = matches!(&self.node.kind, Kind::Tuple(items) if items.is_empty());
        // `ron` wants this in one piece.
        let exact = self.node.span.of(self.run.text) == "()";
        if !(empty && (self.inside || exact)) {
            self.run.mismatch(self.node, "`()`", None);
        }
        visitor.visit_unit()
    }

    fn deserialize_unit_struct<V: Visitor<'de>>(
        self,
        name: &'static str,
        visitor: V,
    ) -> Result<V::Value, Error> {
        let named = self.node.name.as_ref().is_some_and(|found| found.text == name);
        if !self.inside && matches!(self.node.kind, Kind::Ident) && named {
            return visitor.visit_unit();
        }
        if !self.inside && (self.run.tree.explicit_names || self.node.name.is_some()) {
            self.run.mismatch(self.node, &format!("`{name}`"), None);
        }
        self.deserialize_unit(visitor)
    }

    fn deserialize_newtype_struct<V: Visitor<'de>>(
        self,
        name: &'static str,
        visitor: V,
    ) -> Result<V::Value, Error> {
        match self.sole("one value") {
            Some(node) if self.run.deeper(node) => {
                let made = visitor.visit_newtype_struct(Value::new(self.run, node));
                self.run.shallower();
                self.run.settle(node, made)
            }
            _ => Dummy::default().deserialize_newtype_struct(name, visitor),
        }
    }

    fn deserialize_seq<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Error> {
        let expected = "a list in brackets";
        if let Some(node) = self.sole(expected) {
            match &node.kind {
                Kind::List(items) => return access::elements(self.run, node, items, None, visitor),
                Kind::Tuple(items) if node.name.is_none() => {
                    let found = words::found(self.run.text, node);
                    let message = format!("expected {expected}, found {found}");
                    let help = Some("lists are written `[...]`".to_owned());
                    self.run.misshapen(node, node.span, message, help);
                    return access::elements(self.run, node, items, None, visitor);
                }
                _ => self.run.mismatch(node, expected, None),
            }
        }
        Dummy::default().deserialize_seq(visitor)
    }

    fn deserialize_tuple<V: Visitor<'de>>(self, len: usize, visitor: V) -> Result<V::Value, Error> {
        self.tuple(None, len, visitor)
    }

    fn deserialize_tuple_struct<V: Visitor<'de>>(
        self,
        name: &'static str,
        len: usize,
        visitor: V,
    ) -> Result<V::Value, Error> {
        self.tuple(Some(name), len, visitor)
    }

    fn deserialize_map<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Error> {
        match self.sole("a map in braces") {
            Some(node) => access::map(self.run, node, visitor),
            None => Dummy::default().deserialize_map(visitor),
        }
    }

    fn deserialize_struct<V: Visitor<'de>>(
        self,
        name: &'static str,
        names: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Error> {
        if !self.run.is_replaced(self.node) {
            if !self.inside {
                fields::check_name(self.run, self.node, name);
            }
            if let Some(body) = fields::body(self.run, self.node, self.inside, name, names) {
                return fields::read(self.run, body, name, "", names, visitor);
            }
        }
        Dummy::default().deserialize_struct(name, names, visitor)
    }

    fn deserialize_enum<V: Visitor<'de>>(
        self,
        name: &'static str,
        names: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Error> {
        let one_of = variant::one_of(names);
        match self.sole(&one_of) {
            Some(node) => variant::read(self.run, node, name, names, visitor),
            None => Dummy::default().deserialize_enum(name, names, visitor),
        }
    }

    fn deserialize_identifier<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Error> {
        let expected = "a name";
        match self.sole(expected) {
            Some(Node { kind: Kind::Ident, name: Some(name), .. }) => visitor.visit_str(&name.text),
            Some(node) => {
                self.run.mismatch(node, expected, None);
                visitor.visit_str("")
            }
            None => visitor.visit_str(""),
        }
    }

    fn deserialize_any<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Error> {
        access::any(self, self.run, self.node, self.inside, visitor)
    }

    fn deserialize_ignored_any<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Error> {
        visitor.visit_unit()
    }
}
