//! `Fields`: the children of an element by name, and the values that they hold.
//!
//! Whatever is not asked for is lost by name and place: an unknown child or
//! attribute, text where elements are expected, an element that stands twice.

use std::collections::BTreeMap;

use roxmltree::Node;

use crate::import::report::Report;
use crate::import::text::{Text, number, shown};

/// An element of the tree.
pub(super) type Element<'t> = Node<'t, 't>;

/// The name in lower case; empty for one of another namespace, which nothing
/// here is.
pub(super) fn name_of(node: Element<'_>) -> String {
    let name = node.tag_name();
    if name.namespace().is_some() { String::new() } else { name.name().to_ascii_lowercase() }
}

/// The name as the file has it.
pub(super) fn written_name(node: Element<'_>) -> &str {
    node.tag_name().name()
}

/// The value of an attribute, whose name may be in any case.
pub(super) fn attribute<'t>(node: Element<'t>, name: &str) -> Option<&'t str> {
    let is_it = |a: &roxmltree::Attribute<'_, '_>| {
        a.namespace().is_none() && a.name().eq_ignore_ascii_case(name)
    };
    node.attributes().find(is_it).map(|attribute| attribute.value())
}

/// What reading needs everywhere: the text for places, and where to report.
pub(super) struct Notes<'a> {
    pub(super) text: &'a Text<'a>,
    pub(super) report: Report,
}

impl Notes<'_> {
    /// An element whose wish is not met.
    pub(super) fn lost(&mut self, node: Element<'_>, what: impl Into<String>) {
        let text = self.text;
        self.report.lost(|| text.place(node.range().start), written_name(node), what);
    }

    /// An element that makes no sense.
    pub(super) fn unreadable(&mut self, node: Element<'_>, what: &str, help: Option<&str>) {
        let text = self.text;
        let message = format!("{}: {what}", written_name(node));
        self.report.unreadable(|| text.place(node.range().start), message, help);
    }

    /// Reports attributes other than these.
    pub(super) fn only_attributes(&mut self, node: Element<'_>, known: &[&str]) {
        for attribute in node.attributes() {
            let is_known = known.iter().any(|name| attribute.name().eq_ignore_ascii_case(name));
            if !is_known || attribute.namespace().is_some() {
                let text = self.text;
                let place = || text.place(attribute.range().start);
                let what = format!(
                    "the attribute {}=\"{}\" is not known and is left out",
                    shown(attribute.name()),
                    shown(attribute.value())
                );
                self.report.lost(place, written_name(node), what);
            }
        }
    }

    /// Reports text between the elements of `node`.
    pub(super) fn no_text(&mut self, node: Element<'_>) {
        for child in node.children().filter(Node::is_text) {
            let found = child.text().unwrap_or_default().trim();
            if !found.is_empty() {
                let text = self.text;
                let what = format!("the text \"{}\" between elements is left out", shown(found));
                self.report.lost(|| text.place(child.range().start), written_name(node), what);
            }
        }
    }

    /// The text that an element holds, trimmed.
    pub(super) fn text_of(&mut self, node: Element<'_>) -> String {
        self.only_attributes(node, &[]);
        for child in node.children().filter(Node::is_element) {
            self.lost(child, format!("is not known inside {} and is left out", written_name(node)));
        }
        let texts = node.children().filter(Node::is_text).filter_map(|child| child.text());
        texts.collect::<String>().trim().to_owned()
    }

    /// `N` numbers that an element holds; `None` with a problem.
    pub(super) fn numbers<const N: usize>(&mut self, node: Element<'_>) -> Option<[f64; N]> {
        let held = self.text_of(node);
        let words: Vec<&str> = held.split_whitespace().collect();
        let expected = match N {
            1 => "a number".to_owned(),
            n => format!("{n} numbers"),
        };
        if words.len() != N {
            let found = format!("expected {expected}, found \"{}\"", shown(&held));
            self.unreadable(node, &found, None);
            return None;
        }
        let mut numbers = [0.0; N];
        for (slot, word) in numbers.iter_mut().zip(words) {
            match number(java(word)) {
                Ok(number) => *slot = number,
                Err(why) => {
                    self.unreadable(node, &why, None);
                    return None;
                }
            }
        }
        Some(numbers)
    }
}

/// A number as Java's `Double.parseDouble` takes it, by which the course's
/// programs read theirs: a letter `f` or `d` may follow.
fn java(word: &str) -> &str {
    let digits = word.strip_suffix(['f', 'F', 'd', 'D']).unwrap_or(word);
    if digits.ends_with(|c: char| c.is_ascii_digit() || c == '.') { digits } else { word }
}

/// The children of an element that stand for its fields.
pub(super) struct Fields<'t> {
    found: BTreeMap<&'static str, Element<'t>>,
}

impl<'t> Fields<'t> {
    /// The children with these names, which are in lower case, but for those in
    /// `elsewhere`, which the caller reads itself. Of two with one name the last
    /// counts, as in the course's programs.
    pub(super) fn of(
        node: Element<'t>,
        known: &[&'static str],
        elsewhere: &[&str],
        notes: &mut Notes<'_>,
    ) -> Self {
        notes.no_text(node);
        let mut found = BTreeMap::new();
        for child in node.children().filter(Node::is_element) {
            let name = name_of(child);
            if let Some(known) = known.iter().find(|known| **known == name) {
                if let Some(before) = found.insert(*known, child) {
                    let what = "stands twice in one element: only the last one counts";
                    notes.lost(before, what);
                }
            } else if !elsewhere.contains(&name.as_str()) {
                let inside = written_name(node);
                notes.lost(child, format!("is not known inside {inside} and is left out"));
            }
        }
        Self { found }
    }

    /// The element of this name.
    pub(super) fn get(&self, name: &str) -> Option<Element<'t>> {
        self.found.get(name).copied()
    }

    /// The three numbers of a field; `None` if it is not there or is a problem.
    pub(super) fn triple(&self, name: &str, notes: &mut Notes<'_>) -> Option<[f64; 3]> {
        self.get(name).and_then(|node| notes.numbers(node))
    }

    /// The number of a field; `None` if it is not there or is a problem.
    pub(super) fn number(&self, name: &str, notes: &mut Notes<'_>) -> Option<f64> {
        self.get(name).and_then(|node| notes.numbers(node)).map(|[number]| number)
    }
}
