//! `Chain`: points or edges in the order of a border, in boxes of boxes, so that
//! few are looked at for those that are somewhere.
//!
//! Neighbors on a border are near each other, so that its order is as good as
//! any that would be made. Nothing is rounded inwards: what is left out is
//! surely elsewhere.

use super::predicate::{Point, turn};

/// How far something reaches along x, y, their sum and their difference; turned
/// upside down for nothing at all.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Reach([[f64; 2]; 4]);

impl Reach {
    const NONE: Self = Self([[f64::INFINITY, f64::NEG_INFINITY]; 4]);

    /// That of the least shape around these points.
    pub(super) fn of(points: &[Point]) -> Self {
        points.iter().fold(Self::NONE, |all, &[x, y]| {
            // Each is rounded once and so in order: what is apart here is apart.
            all.with(Self([x, y, x + y, x - y].map(|along| [along; 2])))
        })
    }

    fn with(self, Self(other): Self) -> Self {
        let Self(own) = self;
        let both = |k: usize| [own[k][0].min(other[k][0]), own[k][1].max(other[k][1])];
        Self(std::array::from_fn(both))
    }

    /// Whether the two may have a point in common.
    pub(super) fn meets(&self, Self(other): &Self) -> bool {
        self.0.iter().zip(other).all(|(a, b)| a[0] <= b[1] && b[0] <= a[1])
    }

    /// Whether all of it is to the right of the line from `a` to `b`.
    pub(super) fn is_right_of(&self, a: Point, b: Point) -> bool {
        turn(a, b, self.leftmost(a, b)).is_lt()
    }

    /// Whether all of it is on one side of the line from `a` to `b`, or on it.
    pub(super) fn is_beside(&self, a: Point, b: Point) -> bool {
        turn(a, b, self.leftmost(a, b)).is_le() || turn(b, a, self.leftmost(b, a)).is_le()
    }

    /// The corner of its box that is farthest to the left of a line.
    fn leftmost(&self, a: Point, b: Point) -> Point {
        let Self([[left, right], [down, up], ..]) = *self;
        [if b[1] < a[1] { right } else { left }, if a[0] < b[0] { up } else { down }]
    }
}

/// What lies between two lines of one direction, which is what long things
/// beside each other are told apart by.
#[derive(Debug, Clone, Copy)]
struct Strip {
    along: Point,
    across: [f64; 2],
}

impl Strip {
    const NONE: Self = Self { along: [0.0; 2], across: [0.0; 2] };

    fn around(along: Point, points: impl Iterator<Item = Point>) -> Self {
        let none = [f64::INFINITY, f64::NEG_INFINITY];
        let across = points.fold(none, |[low, high], [x, y]| {
            let (left, right) = (along[0] * y, along[1] * x);
            let middle = left - right;
            // Of what three roundings move it by, and what is too small to be rounded.
            let off = 2.0 * f64::EPSILON * (left.abs() + right.abs()) + f64::MIN_POSITIVE;
            [low.min(middle - off), high.max(middle + off)]
        });
        Self { along, across }
    }

    fn width(&self) -> f64 {
        let [x, y] = self.along;
        let length = x.abs() + y.abs();
        if length > 0.0 { (self.across[1] - self.across[0]) / length } else { f64::INFINITY }
    }

    fn may_hold(&self, points: &[Point]) -> bool {
        let [low, high] = Self::around(self.along, points.iter().copied()).across;
        low <= self.across[1] && self.across[0] <= high
    }
}

/// A tree of what each part reaches: the two halves of node `k` are the nodes
/// `2 k` and `2 k + 1`, and the things themselves the last half of all.
#[derive(Debug)]
pub(super) struct Chain {
    nodes: Vec<Reach>,
    strips: Vec<Strip>,
}

impl Chain {
    /// Of the edges of a border, by number of the corners where they begin.
    pub(super) fn of_edges(points: &[Point]) -> Self {
        let n = points.len();
        let edge = |i: usize| [points[i], points[(i + 1) % n]];
        Self::new((0..n).map(|i| Reach::of(&edge(i))).collect(), points)
    }

    /// Of its corners.
    pub(super) fn of_corners(points: &[Point]) -> Self {
        Self::new(points.iter().map(|&p| Reach::of(&[p])).collect(), points)
    }

    /// Each thing is somewhere on the edge that begins at its corner.
    fn new(things: Vec<Reach>, points: &[Point]) -> Self {
        let n = things.len();
        let leaves = n.next_power_of_two();
        let mut nodes = vec![Reach::NONE; leaves];
        nodes.extend(things);
        nodes.resize(2 * leaves, Reach::NONE);
        let mut strips = vec![Strip::NONE; 2 * leaves];
        for k in (1..2 * leaves).rev() {
            // The edges of its things, and so one corner more.
            let size = leaves >> k.ilog2();
            let first = k * size - leaves;
            let corners = || (first..(first + size + 1).min(n + 1)).map(|i| points[i % n]);
            if first >= n {
                continue;
            }
            let [a, b] = [points[first], points[(first + size).min(n) % n]];
            let mut ways = vec![[b[0] - a[0], b[1] - a[1]]];
            if k < leaves {
                nodes[k] = nodes[2 * k].with(nodes[2 * k + 1]);
                ways.extend([strips[2 * k].along, strips[2 * k + 1].along]);
            }
            let all = ways.into_iter().map(|along| Strip::around(along, corners()));
            strips[k] = all.min_by(|a, b| a.width().total_cmp(&b.width())).unwrap_or(Strip::NONE);
        }
        Self { nodes, strips }
    }

    /// Takes one out.
    pub(super) fn remove(&mut self, thing: usize) {
        let mut k = self.nodes.len() / 2 + thing;
        self.nodes[k] = Reach::NONE;
        while k > 1 {
            k /= 2;
            self.nodes[k] = self.nodes[2 * k].with(self.nodes[2 * k + 1]);
        }
    }

    /// The first thing from number `from` on that is the one, and how many nodes
    /// were looked at. It has a point in common with the line or triangle of
    /// `points`, and only what `may_hold` says may hold it is looked into.
    pub(super) fn first(
        &self,
        from: usize,
        points: &[Point],
        may_hold: impl Fn(&Reach) -> bool,
        is_it: impl Fn(usize) -> bool,
    ) -> (Option<usize>, u64) {
        let leaves = self.nodes.len() / 2;
        let own = Reach::of(points);
        let mut looks = 0;
        // Nodes to look into, with how many things each is made of.
        let mut open = vec![(1, leaves)];
        while let Some((k, size)) = open.pop() {
            let end = (k + 1) * size - leaves;
            if end <= from {
                continue;
            }
            looks += 1;
            let reach = &self.nodes[k];
            if !(own.meets(reach) && self.strips[k].may_hold(points) && may_hold(reach)) {
                continue;
            }
            if size > 1 {
                open.extend([(2 * k + 1, size / 2), (2 * k, size / 2)]);
            } else if is_it(k - leaves) {
                return (Some(k - leaves), looks);
            }
        }
        (None, looks)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_is_found_and_nothing_is_left_out() {
        let mut rng = fastrand::Rng::with_seed(3);
        for n in [1, 2, 3, 8, 13, 100] {
            let points: Vec<Point> = (0..n).map(|_| [rng.f64(), rng.f64()]).collect();
            let mut chain = Chain::of_corners(&points);
            let mut is_left = vec![true; n];
            for _ in 0..n {
                let gone = rng.usize(0..n);
                chain.remove(gone);
                is_left[gone] = false;
                let [a, b, c] = [0; 3].map(|_| [rng.f64(), rng.f64()]);
                let [b, c] = if turn(a, b, c).is_gt() { [b, c] } else { [c, b] };
                let from = rng.usize(0..n);
                let sides = [(a, b), (b, c), (c, a)];
                let is_it = |i: usize| sides.iter().all(|&(a, b)| turn(a, b, points[i]).is_ge());
                let expected = (from..n).find(|&i| is_left[i] && is_it(i));
                let may_hold = |reach: &Reach| !reach.is_right_of(a, b);
                assert_eq!(chain.first(from, &[a, b, c], may_hold, is_it).0, expected);
            }
        }
    }

    #[test]
    fn beside_a_line() {
        let of = |points: &[Point]| Reach::of(points);
        let (a, b) = ([0.0, 0.0], [2.0, 1.0]);
        for (points, is_beside, is_right) in [
            ([[0.0, 1.0], [1.0, 2.0]], true, false),
            ([[0.0, -2.0], [2.0, -0.5]], true, true),
            ([[0.0, -1.0], [2.0, 1.0]], false, false),
            ([[2.0, 1.0], [2.0, 3.0]], true, false),
            ([[2.0, 1.0], [3.0, 1.0]], true, false),
        ] {
            let reach = of(&points);
            assert_eq!(reach.is_beside(a, b), is_beside, "{points:?}");
            assert_eq!(reach.is_beside(b, a), is_beside, "{points:?}");
            assert_eq!(reach.is_right_of(a, b), is_right, "{points:?}");
        }
    }
}
