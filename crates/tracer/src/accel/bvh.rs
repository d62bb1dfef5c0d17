//! `Bvh`: a binary bounding volume hierarchy, built by the surface area
//! heuristic over bins.
//!
//! It promises the linear list's answers: its box test may let a ray in that
//! misses, never keep one out that a candidate's own formula would hit.

use glam::DVec3;

use super::{Candidate, LEAF};
use crate::math::{UNIT_ROUNDOFF, max_abs};
use crate::meter::{Event, Meter};
use crate::{Aabb, Interval, Ray};

/// Bins per axis when a node is split.
const BINS: usize = 16;
/// Below this depth nodes are halved by count, which bounds the depth at
/// twice this for up to 2^32 candidates, and so the traversal's stack.
const SAH_DEPTH: usize = 32;
/// Room for one pending sibling per level.
const STACK: usize = 2 * SAH_DEPTH + 1;

/// A bounding volume hierarchy.
#[derive(Debug, Clone, PartialEq)]
pub struct Bvh {
    /// The root first; a node's left child follows it directly.
    nodes: Vec<Node>,
    /// Candidate numbers, leaf after leaf.
    order: Vec<u32>,
    /// Candidates without a finite box: tested by every ray.
    unbounded: Vec<u32>,
    /// The largest coordinate of any box, for the rounding of box tests.
    extent: f64,
    /// How many times more than a shape's own formulas the candidates round.
    rounding: f64,
}

#[derive(Debug, Clone, PartialEq)]
struct Node {
    bounds: Aabb,
    /// Of a leaf: its first place in `order`. Of an inner node: its right child.
    first: u32,
    /// Of a leaf: how many candidates. Of an inner node: 0.
    count: u32,
}

impl Bvh {
    /// The hierarchy over candidates with these boxes; see
    /// [`Accelerator::build`](super::Accelerator::build).
    pub fn new(boxes: &[Aabb], rounding: f64) -> Self {
        let (bounded, unbounded): (Vec<u32>, Vec<u32>) =
            (0..boxes.len() as u32).partition(|&i| boxes[i as usize].is_finite());
        let extent = bounded.iter().map(|&i| boxes[i as usize].max_abs()).fold(0.0, f64::max);
        let mut bvh = Self { nodes: Vec::new(), order: bounded, unbounded, extent, rounding };
        if !bvh.order.is_empty() {
            let mut builder = Builder { boxes, nodes: Vec::new() };
            builder.node(&mut bvh.order, 0, 0);
            bvh.nodes = builder.nodes;
        }
        bvh
    }

    /// See [`Accelerator::closest`](super::Accelerator::closest).
    pub(crate) fn closest<H: Candidate>(
        &self,
        ray: &Ray,
        range: Interval,
        meter: &impl Meter,
        mut test: impl FnMut(u32, Interval) -> Option<H>,
    ) -> Option<(u32, H)> {
        let mut best: Option<(u32, H)> = None;
        let mut t_best = range.hi;
        let mut consider = |i: u32, t_best: &mut f64| {
            // One step past the best `t`, so that an equal one is seen too and
            // the lower number can win, as in the list.
            let until = if best.is_some() { t_best.next_up().min(range.hi) } else { range.hi };
            if let Some(hit) = test(i, range.until(until)) {
                let wins = best.as_ref().is_none_or(|(j, b)| (hit.t(), i) < (b.t(), *j));
                if wins {
                    *t_best = hit.t();
                    best = Some((i, hit));
                }
            }
        };
        for &i in &self.unbounded {
            consider(i, &mut t_best);
        }
        self.walk(ray, range.lo, &mut t_best, meter, |i, t_best| {
            consider(i, t_best);
            false
        });
        best
    }

    /// See [`Accelerator::any`](super::Accelerator::any).
    pub(crate) fn any(
        &self,
        ray: &Ray,
        range: Interval,
        meter: &impl Meter,
        mut test: impl FnMut(u32) -> bool,
    ) -> bool {
        let mut t_end = range.hi;
        self.unbounded.iter().any(|&i| test(i))
            || self.walk(ray, range.lo, &mut t_end, meter, |i, _| test(i))
    }

    /// The boxes of the nodes down to a few levels, and one of everything if
    /// there are candidates without a box.
    pub(super) fn coarse_boxes(&self) -> Vec<Aabb> {
        /// At most 2^5 boxes.
        const LEVELS: u32 = 5;
        let mut boxes = vec![];
        if !self.unbounded.is_empty() {
            boxes.push(Aabb::EVERYTHING);
        }
        let mut pending = vec![(0_u32, 0)];
        while let Some((node, level)) = pending.pop() {
            let Some(&Node { bounds, first, count }) = self.nodes.get(node as usize) else {
                continue;
            };
            if count > 0 || level == LEVELS {
                boxes.push(bounds);
            } else {
                pending.extend([(node + 1, level + 1), (first, level + 1)]);
            }
        }
        boxes
    }

    /// Visits the candidates of all leaves whose box the ray meets in
    /// `[t_min, t_max]`, nearer child first, until `visit` returns true. It
    /// may lower `t_max`.
    fn walk(
        &self,
        ray: &Ray,
        t_min: f64,
        t_max: &mut f64,
        meter: &impl Meter,
        mut visit: impl FnMut(u32, &mut f64) -> bool,
    ) -> bool {
        if self.nodes.is_empty() {
            return false;
        }
        let slabs = Slabs::new(ray, self.extent, self.rounding);
        let mut stack = [(0_u32, f64::NEG_INFINITY); STACK];
        let mut top = 0;
        let mut node = 0_u32;
        loop {
            let Node { first, count, .. } = self.nodes[node as usize];
            if count > 0 {
                for &i in &self.order[first as usize..(first + count) as usize] {
                    if visit(i, t_max) {
                        return true;
                    }
                }
            } else {
                let (left, right) = (node + 1, first);
                let enter = |child: u32, t_max| {
                    meter.count(Event::Node);
                    slabs.enter(&self.nodes[child as usize].bounds, t_min, t_max)
                };
                match (enter(left, *t_max), enter(right, *t_max)) {
                    (Some(l), Some(r)) => {
                        let (near, far) =
                            if l <= r { (left, (right, r)) } else { (right, (left, l)) };
                        stack[top] = far;
                        top += 1;
                        node = near;
                        continue;
                    }
                    (Some(_), None) => {
                        node = left;
                        continue;
                    }
                    (None, Some(_)) => {
                        node = right;
                        continue;
                    }
                    (None, None) => {}
                }
            }
            loop {
                if top == 0 {
                    return false;
                }
                top -= 1;
                // A box that starts behind the best hit holds nothing closer.
                if stack[top].1 <= *t_max {
                    node = stack[top].0;
                    break;
                }
            }
        }
    }
}

/// A ray made ready for box tests that never err on the side of a miss.
struct Slabs {
    origin: DVec3,
    inverse: DVec3,
    /// How far boxes are widened to make up for rounding, here and in the
    /// candidates' own formulas.
    pad: f64,
}

/// The widening of boxes, in roundings of `S`, the origin's largest coordinate
/// plus the boxes': with `u` the unit roundoff, boxes grow by `64 u S` on each
/// side.
///
/// Proof that nothing is lost. Where a shape's test returns `t`, the point
/// `o + t d` is within `32 u S` of the shape's box (`docs/accuracy.md` goes
/// through the shapes). Here `min - pad - o` is off by `3 u S` at most, and its
/// product with the rounded reciprocal by `5 u S` more, in units of length. So
/// the side where the ray enters is computed at least `(64 - 32 - 3 - 5) u S`
/// of the way before that point, the other side as much behind it, and
/// `enter <= t <= leave` holds in the numbers as they are computed: the box is
/// kept, and it is kept as well when another `t` was found that is not below
/// this one.
const PADDING: f64 = 64.0;

impl Slabs {
    fn new(ray: &Ray, extent: f64, rounding: f64) -> Self {
        let pad = PADDING * UNIT_ROUNDOFF * rounding * (max_abs(ray.origin) + extent);
        Self { origin: ray.origin, inverse: ray.direction.recip(), pad }
    }

    /// Where the ray enters the widened box, if it is in it within
    /// `[t_min, t_max]`.
    ///
    /// A zero in the direction makes both quotients infinite: of opposite
    /// signs inside the slab, of equal ones outside. `f64::max` and `min` pass
    /// over the NaN of an origin exactly on a widened side, which is outside
    /// the box itself.
    fn enter(&self, bounds: &Aabb, t_min: f64, t_max: f64) -> Option<f64> {
        let (mut enter, mut leave) = (t_min, t_max);
        for axis in 0..3 {
            let a = (bounds.min[axis] - self.pad - self.origin[axis]) * self.inverse[axis];
            let b = (bounds.max[axis] + self.pad - self.origin[axis]) * self.inverse[axis];
            enter = enter.max(a.min(b));
            leave = leave.min(a.max(b));
        }
        (enter <= leave).then_some(enter)
    }
}

struct Builder<'a> {
    boxes: &'a [Aabb],
    nodes: Vec<Node>,
}

impl Builder<'_> {
    /// Builds the node over `items`, which start at `first` in the order.
    fn node(&mut self, items: &mut [u32], first: u32, depth: usize) {
        let bounds = self.bounds(items);
        let index = self.nodes.len();
        self.nodes.push(Node { bounds, first, count: items.len() as u32 });
        if items.len() <= LEAF {
            return;
        }
        let middle = self.split(items, depth);
        let (left, right) = items.split_at_mut(middle);
        self.node(left, first, depth + 1);
        let right_child = self.nodes.len() as u32;
        self.node(right, first + middle as u32, depth + 1);
        self.nodes[index].first = right_child;
        self.nodes[index].count = 0;
    }

    fn bounds(&self, items: &[u32]) -> Aabb {
        items.iter().fold(Aabb::EMPTY, |all, &i| all.union(self.boxes[i as usize]))
    }

    fn center(&self, item: u32) -> DVec3 {
        self.boxes[item as usize].center()
    }

    /// Orders the items into two non-empty parts and returns where the second
    /// starts.
    fn split(&self, items: &mut [u32], depth: usize) -> usize {
        let centers = Aabb::around(items.iter().map(|&i| self.center(i)));
        let widths = centers.max - centers.min;
        let plane = if depth < SAH_DEPTH { self.best_plane(items, &centers) } else { None };
        if let Some((axis, bin)) = plane {
            // Stable, so that equal inputs give equal trees.
            items.sort_by_key(|&i| bin_of(self.center(i)[axis], &centers, axis) > bin);
            return items.partition_point(|&i| bin_of(self.center(i)[axis], &centers, axis) <= bin);
        }
        let axis = (0..3).fold(0, |best, k| if widths[k] > widths[best] { k } else { best });
        items.sort_by(|&i, &j| self.center(i)[axis].total_cmp(&self.center(j)[axis]));
        items.len() / 2
    }

    /// The axis and last bin of the left part that cost least by the surface
    /// area heuristic; `None` where all centers are one.
    ///
    /// Source: Wald, "On fast Construction of SAH-based Bounding Volume
    /// Hierarchies", 2007.
    fn best_plane(&self, items: &[u32], centers: &Aabb) -> Option<(usize, usize)> {
        let mut best: Option<(f64, usize, usize)> = None;
        for axis in 0..3 {
            if !(centers.max[axis] > centers.min[axis]) {
                continue;
            }
            let mut bins = [(Aabb::EMPTY, 0_u32); BINS];
            for &i in items {
                let bin = &mut bins[bin_of(self.center(i)[axis], centers, axis)];
                *bin = (bin.0.union(self.boxes[i as usize]), bin.1 + 1);
            }
            let sweep = |bins: &mut dyn Iterator<Item = &(Aabb, u32)>| {
                let mut so_far = (Aabb::EMPTY, 0_u32);
                let mut costs = [0.0; BINS];
                for (cost, bin) in costs.iter_mut().zip(bins) {
                    so_far = (so_far.0.union(bin.0), so_far.1 + bin.1);
                    *cost = so_far.0.half_area() * f64::from(so_far.1);
                }
                costs
            };
            let from_left = sweep(&mut bins.iter());
            let from_right = sweep(&mut bins.iter().rev());
            for last in 0..BINS - 1 {
                let cost = from_left[last] + from_right[BINS - 2 - last];
                let both_filled = bins[..=last].iter().any(|b| b.1 > 0)
                    && bins[last + 1..].iter().any(|b| b.1 > 0);
                if both_filled && best.is_none_or(|(least, ..)| cost < least) {
                    best = Some((cost, axis, last));
                }
            }
        }
        best.map(|(_, axis, bin)| (axis, bin))
    }
}

/// Which bin a coordinate falls into; the last one takes its upper end.
fn bin_of(x: f64, centers: &Aabb, axis: usize) -> usize {
    let (lo, hi) = (centers.min[axis], centers.max[axis]);
    let share = (x - lo) / (hi - lo) * BINS as f64;
    // Saturating, and 0 for NaN.
    (share as usize).min(BINS - 1)
}
