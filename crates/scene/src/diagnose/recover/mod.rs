//! A value made out of a tree, whatever is wrong with it, with every problem on the way.
//!
//! serde gives up a value at its first error. Where the error is of our own making, such as a text
//! where a number belongs, a stand-in is fed and the run goes on. Where the type itself refuses,
//! the run ends; but something was learned (this node needs a stand-in, this type needs that
//! field), and the next run gets further. What is learned of a type holds for all its values, so
//! the number of runs grows with the variety of the mistakes, not with the length of the file.

mod access;
mod dummy;
mod error;
mod facts;
mod fields;
mod value;
mod variant;

use std::cell::{Cell, RefCell};
use std::collections::{HashMap, HashSet};

use serde::de::DeserializeOwned;

use super::problem::{Problem, Span};
use super::tree::{Kind, Node, Tree};
use super::words;
use error::Error;
use facts::Facts;
use value::Value;

/// How often a value may be tried anew; each further run costs as much as the first.
const MOST_RUNS: usize = 64;

/// How deeply `ron` lets values nest, by its own way of counting.
const MOST_NESTED: usize = 128;

/// What [`recover`] gives.
pub(super) struct Recovered<T> {
    pub(super) value: Option<T>,
    pub(super) problems: Vec<Problem>,
    pub(super) doubts: Doubts,
    /// Places of commas that `ron` takes although they seem one too many.
    pub(super) excused: HashSet<Span>,
}

/// The places where a value is not what the text says.
#[derive(Debug)]
pub(super) struct Doubts {
    stand_ins: Vec<bool>,
    injected: HashSet<(usize, &'static str)>,
}

impl Doubts {
    /// Whether the value of this node, or how many values it holds, was made up.
    pub(super) fn is_stand_in(&self, node: &Node) -> bool {
        matches!(node.kind, Kind::Bad) || self.stand_ins.get(node.id).copied().unwrap_or(true)
    }

    /// Whether this node lacks a field of this name, which was made up.
    pub(super) fn is_injected(&self, node: &Node, field: &str) -> bool {
        self.injected.iter().any(|&(id, name)| id == node.id && name == field)
    }
}

/// Makes a `T` of a tree; notes in the tree which names were meant.
pub(super) fn recover<T: DeserializeOwned>(text: &str, tree: &mut Tree) -> Recovered<T> {
    let run = Run::new(text, tree);
    let mut value = None;
    for tried in 1.. {
        run.again.set(false);
        run.depth.set(0);
        let made = run.settle(&tree.root, T::deserialize(Value::new(&run, &tree.root)));
        value = made.ok().or(value);
        if !run.again.get() {
            break;
        }
        if tried == MOST_RUNS {
            let end = tree.root.span.end;
            run.report(Span::new(end, end), super::problem::NOT_LISTED, None);
            break;
        }
    }
    let Run { problems, marks, meant, injected, excused, .. } = run;
    let stand_ins = marks.into_inner().iter().map(|mark| *mark != Mark::Sound).collect();
    let doubts = Doubts { stand_ins, injected: injected.into_inner() };
    tree.meant = meant.into_inner();
    Recovered { value, problems: problems.into_inner(), doubts, excused: excused.into_inner() }
}

/// What is known of a node.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Mark {
    Sound,
    /// Its brackets, name or number of values are wrong, and reported; what is inside is read.
    Misshapen,
    /// A stand-in takes its place.
    Replaced,
}

/// What the runs over one tree share.
struct Run<'t> {
    text: &'t str,
    tree: &'t Tree,
    excused: RefCell<HashSet<Span>>,
    problems: RefCell<Vec<Problem>>,
    marks: RefCell<Vec<Mark>>,
    /// Which name of a field was meant, by the node of its value.
    meant: RefCell<HashMap<usize, &'static str>>,
    /// Which variant was meant, by the node.
    variants: RefCell<HashMap<usize, &'static str>>,
    /// Fields that were made up, by the node that lacks them.
    injected: RefCell<HashSet<(usize, &'static str)>>,
    facts: RefCell<Facts>,
    /// Whether something was learned that asks for another run.
    again: Cell<bool>,
    depth: Cell<usize>,
    too_deep: Cell<bool>,
}

impl<'t> Run<'t> {
    fn new(text: &'t str, tree: &'t Tree) -> Self {
        Self {
            text,
            tree,
            excused: RefCell::default(),
            problems: RefCell::default(),
            marks: RefCell::new(vec![Mark::Sound; tree.len]),
            meant: RefCell::default(),
            variants: RefCell::default(),
            injected: RefCell::default(),
            facts: RefCell::default(),
            again: Cell::new(false),
            depth: Cell::new(0),
            too_deep: Cell::new(false),
        }
    }

    fn report(&self, span: Span, message: impl Into<String>, help: Option<String>) {
        let problem = Problem { span, message: message.into(), help };
        self.problems.borrow_mut().push(problem);
    }

    fn mark(&self, node: &Node) -> Mark {
        self.marks.borrow().get(node.id).copied().unwrap_or(Mark::Replaced)
    }

    fn set_mark(&self, node: &Node, mark: Mark) {
        if let Some(place) = self.marks.borrow_mut().get_mut(node.id) {
            *place = mark;
        }
    }

    /// Whether a stand-in takes the place of this node.
    fn is_replaced(&self, node: &Node) -> bool {
        matches!(node.kind, Kind::Bad) || self.mark(node) == Mark::Replaced
    }

    /// Reports that a node is not what is `expected`; a stand-in takes its place.
    fn mismatch(&self, node: &Node, expected: &str, help: Option<String>) {
        if !self.is_replaced(node) {
            let found = words::found(self.text, node);
            self.report(node.span, format!("expected {expected}, found {found}"), help);
            self.set_mark(node, Mark::Replaced);
        }
    }

    /// Reports, once, something wrong with the outside of a node whose inside is read all the same.
    fn misshapen(&self, node: &Node, span: Span, message: String, help: Option<String>) {
        if self.mark(node) == Mark::Sound {
            self.report(span, message, help);
            self.set_mark(node, Mark::Misshapen);
        }
    }

    /// Takes what the type made of a node; reports its error, so that the next run does without.
    fn settle<T>(&self, node: &Node, made: Result<T, Error>) -> Result<T, Error> {
        let error = match made {
            Ok(value) => return Ok(value),
            Err(Error::Reported) => return Err(Error::Reported),
            Err(error) => error,
        };
        if self.is_replaced(node) {
            return Err(Error::Unfit);
        }
        match error {
            Error::Unfit => {}
            Error::Expected(expected) => self.mismatch(node, &expected, None),
            error => self.report(node.anchor(), error.to_string(), None),
        }
        self.set_mark(node, Mark::Replaced);
        self.again.set(true);
        Err(Error::Reported)
    }

    /// Notes that the tuple in the parentheses of `node` has no parentheses of its own.
    ///
    /// `ron` takes a comma after the last value there, and another one after the tuple.
    fn unwrapped(&self, node: &Node) {
        if let Some(comma) = self.tree.second_commas.get(&node.id) {
            self.excused.borrow_mut().insert(*comma);
        }
    }

    /// Ends this run, since the next one knows more.
    fn retry(&self) -> Error {
        self.again.set(true);
        Error::Reported
    }

    /// Goes one level down as `ron` counts them; false, and a problem, if it would refuse.
    fn deeper(&self, node: &Node) -> bool {
        let depth = self.depth.get();
        if depth < MOST_NESTED {
            self.depth.set(depth + 1);
            return true;
        }
        if !self.too_deep.replace(true) {
            self.report(node.span, "values are nested too deeply here", None);
        }
        self.set_mark(node, Mark::Replaced);
        false
    }

    fn shallower(&self) {
        self.depth.set(self.depth.get().saturating_sub(1));
    }
}
