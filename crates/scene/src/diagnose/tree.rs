//! A text as a tree of values with their places.

use std::collections::HashMap;

use super::problem::{Problem, Span};
use super::{brackets, lexer, parser};

/// A RON text as far as it could be understood.
#[derive(Debug)]
pub(crate) struct Tree {
    pub(super) root: Node,
    /// How many nodes there are; their `id`s count from 0.
    pub(super) len: usize,
    /// Whether the text asks that structs have their names written.
    pub(super) explicit_names: bool,
    /// A second comma at the end of a tuple, by its node.
    pub(super) second_commas: HashMap<usize, Span>,
    /// Names of fields as they were meant, by the `id` of the field's value.
    pub(super) meant: HashMap<usize, &'static str>,
}

/// A value.
#[derive(Debug)]
pub(super) struct Node {
    pub(super) id: usize,
    /// From the first byte of the name, or of the value, to its last one.
    pub(super) span: Span,
    pub(super) name: Option<Name>,
    /// Where the opening bracket is, for what has one.
    pub(super) open: usize,
    /// Whether something inside could not be kept, or the end is not where it seems.
    pub(super) lossy: bool,
    pub(super) kind: Kind,
}

/// A name as it stands in the text.
#[derive(Clone, Debug)]
pub(super) struct Name {
    pub(super) text: String,
    /// Written `r#name`, which is never a keyword like `true` or `None`.
    pub(super) raw: bool,
    pub(super) span: Span,
}

/// The shape of a value.
#[derive(Debug)]
pub(super) enum Kind {
    /// Not to be understood, and reported.
    Bad,
    /// A number, or something that begins like one.
    Number,
    Str(String),
    Char(char),
    Bytes(Vec<u8>),
    /// A name on its own: a unit struct or variant, `true`, `None`, `inf`.
    Ident,
    /// Values in parentheses, or nothing in parentheses.
    Tuple(Vec<Node>),
    /// At least one `name: value` in parentheses.
    Struct(Vec<Field>),
    List(Vec<Node>),
    Map(Vec<(Node, Node)>),
    /// `Some value` without parentheses, which `ron` takes where `Some` may be left out.
    BareSome(Box<Node>),
}

/// A `name: value`.
#[derive(Debug)]
pub(super) struct Field {
    pub(super) name: Name,
    pub(super) value: Node,
}

impl Tree {
    /// Reads a text, with the problems that need no knowledge of what it should hold.
    pub(crate) fn read(text: &str) -> (Self, Vec<Problem>) {
        let lexed = lexer::lex(text);
        let mut problems = lexed.problems;
        let ends = brackets::pair(text, &lexed.tokens, lexed.cut_short, &mut problems);
        let parsed = parser::parse(text, &lexed.tokens, &ends, lexed.cut_short, &mut problems);
        super::problem::arrange(&mut problems);
        let tree = Self {
            root: parsed.root,
            len: parsed.nodes,
            explicit_names: lexed.explicit_names,
            second_commas: parsed.second_commas,
            meant: HashMap::new(),
        };
        (tree, problems)
    }
}

impl Node {
    /// Where to point for the whole of a value: its name, else its bracket, else all of it.
    pub(super) fn anchor(&self) -> Span {
        match (&self.name, &self.kind) {
            (Some(name), _) => name.span,
            (None, Kind::Tuple(_) | Kind::Struct(_) | Kind::List(_) | Kind::Map(_)) => {
                Span::new(self.open, self.open + 1)
            }
            (None, _) => self.span,
        }
    }

    /// Whether this begins with exactly the keyword `word`.
    pub(super) fn is_keyword(&self, word: &str) -> bool {
        self.name.as_ref().is_some_and(|name| !name.raw && name.text == word)
    }
}
