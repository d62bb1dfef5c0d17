//! `Ring`: the corners that are left of a polygon while ears are taken off.

use std::collections::BTreeSet;

use super::chain::{Chain, Reach};
use super::predicate::{Point, turn};

/// Corners in their order around.
#[derive(Debug)]
pub(super) struct Ring<'a> {
    points: &'a [Point],
    before: Vec<usize>,
    after: Vec<usize>,
    is_left: Vec<bool>,
    left: usize,
    chain: Chain,
    /// Corners that may be ears: their triangles are not known to be none.
    open: BTreeSet<usize>,
}

impl<'a> Ring<'a> {
    pub(super) fn new(points: &'a [Point]) -> Self {
        let n = points.len();
        let mut ring = Self {
            points,
            before: (0..n).map(|i| (i + n - 1) % n).collect(),
            after: (0..n).map(|i| (i + 1) % n).collect(),
            is_left: vec![true; n],
            left: n,
            chain: Chain::of_corners(points),
            open: (0..n).collect(),
        };
        ring.trim((0..n).rev().collect());
        ring
    }

    /// How many corners are left.
    pub(super) fn len(&self) -> usize {
        self.left
    }

    /// Those that are left.
    pub(super) fn corners(&self) -> Vec<usize> {
        (0..self.points.len()).filter(|&i| self.is_left[i]).collect()
    }

    /// A corner between its neighbors.
    pub(super) fn around(&self, b: usize) -> [usize; 3] {
        [self.before[b], b, self.after[b]]
    }

    /// The next corner from this one on, and around, that may be an ear.
    pub(super) fn next_open(&self, from: usize) -> Option<usize> {
        self.open.range(from..).next().or(self.open.first()).copied()
    }

    /// This corner is no ear until one beside it is gone.
    pub(super) fn close(&mut self, corner: usize) {
        self.open.remove(&corner);
    }

    /// All may be ears again.
    pub(super) fn open_all(&mut self) {
        self.open = self.corners().into_iter().collect();
    }

    /// Takes out a corner, and all ways there and back again that come of it.
    pub(super) fn remove(&mut self, corner: usize) {
        let beside = self.take(corner);
        self.trim(beside.into());
    }

    fn take(&mut self, corner: usize) -> [usize; 2] {
        let [a, _, c] = self.around(corner);
        (self.after[a], self.before[c]) = (c, a);
        self.is_left[corner] = false;
        self.left -= 1;
        self.chain.remove(corner);
        self.open.remove(&corner);
        self.open.extend([a, c]);
        [a, c]
    }

    /// Takes out all ways there and back again, which have no area, that are at
    /// these corners.
    fn trim(&mut self, mut at: Vec<usize>) {
        while let Some(corner) = at.pop() {
            if self.is_left[corner] && self.left > 2 && self.is_spike(corner) {
                at.extend(self.take(corner));
            }
        }
    }

    /// Whether a corner is where the next or the one before is, or the way goes
    /// back there.
    fn is_spike(&self, corner: usize) -> bool {
        let [a, b, c] = self.around(corner).map(|i| self.points[i]);
        let to = |p: Point| [0, 1].map(|k| p[k].partial_cmp(&b[k]));
        a == b || b == c || (turn(a, b, c).is_eq() && to(a) == to(c))
    }

    /// Whether a corner and its neighbors make a triangle with no other corner in
    /// it or on its rim, but where one of its own is; and what work that was.
    pub(super) fn is_ear(&self, corner: usize) -> (bool, u64) {
        let [a, b, c] = self.around(corner).map(|i| self.points[i]);
        if !turn(a, b, c).is_gt() {
            return (false, 1);
        }
        let sides = [(a, b), (b, c), (c, a)];
        let may_hold = |reach: &Reach| !sides.iter().any(|&(a, b)| reach.is_right_of(a, b));
        let is_in = |i: usize| {
            let p = self.points[i];
            ![a, b, c].contains(&p) && !sides.iter().any(|&(a, b)| turn(a, b, p).is_lt())
        };
        let (inside, looks) = self.chain.first(0, &[a, b, c], may_hold, is_in);
        (inside.is_none(), looks)
    }
}
