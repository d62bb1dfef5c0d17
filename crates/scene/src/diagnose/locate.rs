//! The place of a value in a text, by its path.

use std::borrow::Cow;

use super::problem::Span;
use super::tree::{Field, Kind, Node, Tree};

/// A step from a value to one inside it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Step {
    /// Into a field of a struct, or of a variant that has fields.
    Field(Cow<'static, str>),
    /// Into an element of a list or tuple, or a value of a tuple variant; counts from 0.
    Index(usize),
    /// To the value of a key of a map.
    Key(String),
}

impl Step {
    /// The step to the value of this key.
    pub fn key(name: impl Into<String>) -> Self {
        Self::Key(name.into())
    }
}

impl From<&'static str> for Step {
    fn from(field: &'static str) -> Self {
        Self::Field(Cow::Borrowed(field))
    }
}

impl From<usize> for Step {
    fn from(index: usize) -> Self {
        Self::Index(index)
    }
}

/// How far a path leads.
pub(super) enum Reach<'p> {
    /// To a value that is written down.
    Value,
    /// To a value from which this field, or what is behind it, is left out.
    LeftOut(&'p str),
}

impl Tree {
    /// The place of the value at `path`.
    ///
    /// Where the value is not written down, such as that of a field left out: the name of the
    /// nearest struct or variant around it that is, or its opening bracket if it has no name.
    pub(crate) fn locate(&self, path: &[Step]) -> Span {
        let (trail, reach) = self.follow(path);
        let last = trail.last().copied().unwrap_or(&self.root);
        match reach {
            Reach::Value => last.span,
            Reach::LeftOut(_) => last.anchor(),
        }
    }

    /// The values on the way along `path`, from the whole to the last one that is written down.
    pub(super) fn follow<'p>(&self, path: &'p [Step]) -> (Vec<&Node>, Reach<'p>) {
        let mut trail = vec![&self.root];
        let mut node = &self.root;
        for step in path {
            while let Some(inner) = self.some(node, step) {
                node = inner;
                trail.push(node);
            }
            let next = match step {
                Step::Field(name) => self.field(node, name).map(|field| &field.value),
                Step::Index(index) => element(node, *index),
                Step::Key(key) => entry(node, key).map(|(_, value)| value),
            };
            let Some(next) = next else {
                let name = match step {
                    Step::Field(name) => name.as_ref(),
                    Step::Key(key) => key,
                    Step::Index(_) => "",
                };
                return (trail, Reach::LeftOut(name));
            };
            node = next;
            trail.push(node);
        }
        (trail, Reach::Value)
    }

    /// What is in a `Some(...)`, or in a variant around a struct that has this field.
    fn some<'n>(&self, node: &'n Node, step: &Step) -> Option<&'n Node> {
        let inner = match &node.kind {
            Kind::BareSome(inner) => return Some(inner),
            Kind::Tuple(items) => match items.as_slice() {
                [inner] => inner,
                _ => return None,
            },
            _ => return None,
        };
        let opens = match step {
            Step::Field(name) => self.field(inner, name).is_some(),
            // `Some(1, 2)` holds the values of a tuple as they are.
            Step::Index(_) | Step::Key(_) => {
                matches!(inner.kind, Kind::List(_) | Kind::Map(_) | Kind::Tuple(_))
            }
        };
        (node.is_keyword("Some") || node.name.is_some() && opens).then_some(inner)
    }

    fn field<'n>(&self, node: &'n Node, name: &str) -> Option<&'n Field> {
        let Kind::Struct(fields) = &node.kind else {
            return None;
        };
        fields.iter().find(|field| self.meant_name(field) == name)
    }

    /// The name of a field, or the one that was meant.
    pub(super) fn meant_name<'n>(&'n self, field: &'n Field) -> &'n str {
        self.meant.get(&field.value.id).copied().unwrap_or(&field.name.text)
    }
}

fn element(node: &Node, index: usize) -> Option<&Node> {
    match &node.kind {
        Kind::List(items) | Kind::Tuple(items) => items.get(index),
        _ => None,
    }
}

/// The last entry of this key, since a later one replaces those before it.
fn entry<'n>(node: &'n Node, key: &str) -> Option<&'n (Node, Node)> {
    let Kind::Map(entries) = &node.kind else {
        return None;
    };
    entries.iter().rev().find(|(name, _)| match &name.kind {
        Kind::Str(text) => text == key,
        _ => name.name.as_ref().is_some_and(|name| name.text == key),
    })
}
