//! `Ears`: a polygon from which corners are cut off one by one.
//!
//! Source: G. H. Meisters, "Polygons Have Ears", 1975.

use tracer::glam::DVec2;

use super::orientation::{Turn, turn};

/// The most tests of a corner against a triangle: seconds of them. No polygon
/// that anybody draws needs a hundredth.
const MOST_TESTS: usize = 300_000_000;

/// What stands in the way of an ear. Borders that touch themselves, as where a
/// hole is tied to the outside, have none by the strict rule.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Rule {
    /// A corner inside or on its border.
    Strict,
    /// A corner inside.
    Touching,
}

/// What is left of a polygon.
pub(super) struct Ears<'a> {
    flat: &'a [DVec2],
    ring: &'a [usize],
    next: Vec<usize>,
    previous: Vec<usize>,
    left: usize,
    tests: usize,
}

impl<'a> Ears<'a> {
    /// The polygon whose corners are `flat` at the numbers of `ring`, turning to
    /// the left.
    pub(super) fn new(flat: &'a [DVec2], ring: &'a [usize]) -> Self {
        let n = ring.len();
        let next = (0..n).map(|i| (i + 1) % n).collect();
        let previous = (0..n).map(|i| (i + n - 1) % n).collect();
        Self { flat, ring, next, previous, left: n, tests: 0 }
    }

    /// Its triangles; `None` if there is no way to cut it.
    pub(super) fn cut(mut self) -> Option<Vec<[usize; 3]>> {
        let mut triangles = Vec::with_capacity(self.left.saturating_sub(2));
        let (mut at, mut passed, mut rule) = (0, 0, Rule::Strict);
        while self.left > 2 {
            let (before, after) = (self.previous[at], self.next[at]);
            match turn(self.corner(before), self.corner(at), self.corner(after)) {
                // It bounds nothing.
                Turn::Straight => {
                    at = self.remove(at);
                    (passed, rule) = (0, Rule::Strict);
                    continue;
                }
                Turn::Left if self.is_ear(at, rule)? => {
                    triangles.push([before, at, after].map(|i| self.ring[i]));
                    at = self.remove(at);
                    (passed, rule) = (0, Rule::Strict);
                    continue;
                }
                Turn::Left | Turn::Right => {}
            }
            at = after;
            passed += 1;
            if passed > self.left {
                match rule {
                    Rule::Strict => (passed, rule) = (0, Rule::Touching),
                    Rule::Touching => return None,
                }
            }
        }
        (!triangles.is_empty()).then_some(triangles)
    }

    fn corner(&self, i: usize) -> DVec2 {
        self.flat[self.ring[i]]
    }

    /// Takes a corner out; gives the one where to go on, from which fans spread
    /// less than if it were the next.
    fn remove(&mut self, at: usize) -> usize {
        let (before, after) = (self.previous[at], self.next[at]);
        self.next[before] = after;
        self.previous[after] = before;
        self.left -= 1;
        self.next[after]
    }

    /// Whether the triangle at a corner has no other corner in it; `None` when
    /// all tests are used up.
    fn is_ear(&mut self, at: usize, rule: Rule) -> Option<bool> {
        let (before, after) = (self.previous[at], self.next[at]);
        let [a, b, c] = [before, at, after].map(|i| self.corner(i));
        let (low, high) = (a.min(b).min(c), a.max(b).max(c));
        let mut other = self.next[after];
        while other != before {
            let p = self.corner(other);
            self.tests += 1;
            if self.tests > MOST_TESTS {
                return None;
            }
            let is_near = p.cmpge(low).all() && p.cmple(high).all();
            if is_near && p != a && p != b && p != c {
                let sides = [turn(a, b, p), turn(b, c, p), turn(c, a, p)];
                let is_inside = match rule {
                    Rule::Strict => sides.iter().all(|side| *side != Turn::Right),
                    Rule::Touching => sides.iter().all(|side| *side == Turn::Left),
                };
                if is_inside {
                    return Some(false);
                }
            }
            other = self.next[other];
        }
        Some(true)
    }
}
