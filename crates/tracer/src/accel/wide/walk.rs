//! The way of a ray through the hierarchy, nearest boxes first.

use super::bundle::Bundle;
use super::node::{Leaf, Node};
use super::slabs::{Slabs, TimeScale};
use super::{STACK, Wide};
use crate::fault::{Fault, seeded};
use crate::meter::{Event, Meter, Unmetered};
use crate::simd::{Eight, Room, Simd, Stack, Work};

/// Who is shown the leaves that a ray may meet.
pub(crate) trait Visitor {
    /// Whether one hit is as good as another, so that none is sought that is
    /// closer.
    const ANY: bool;

    /// Hears how the slabs' parameter follows from the ray's.
    #[inline(always)]
    fn start(&mut self, _: TimeScale) {}

    /// Looks at a leaf; may lower `t_max`, in the slabs' parameter, behind which
    /// nothing is of use. Returns true to end the walk.
    fn visit(&mut self, leaf: Leaf, t_max: &mut f32) -> bool;

    /// Where in memory it will look for a leaf.
    fn address(&self, leaf: Leaf) -> *const u8;
}

/// A box that waits: where the ray enters it, above what is in it. Where that is
/// not negative, nearer ones are smaller numbers.
type Pending = u64;

#[inline(always)]
fn pending(enter: f32, child: u32) -> Pending {
    u64::from(enter.to_bits()) << 32 | u64::from(child)
}

/// The way of one ray of a bundle.
struct WalkOne<'a, V> {
    wide: &'a Wide,
    bundle: &'a Bundle,
    ray: usize,
    visitor: &'a mut V,
}

impl<V: Visitor> Work for WalkOne<'_, V> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self, simd: S) {
        let Self { wide, bundle, ray, visitor } = self;
        let (slabs, mut t_max) = (bundle.slabs(simd, ray), bundle.t_max);
        wide.walk_from(simd, &slabs, 0, &mut t_max, &Unmetered, visitor);
    }
}

impl Wide {
    /// Shows the visitor the leaves whose boxes the ray meets up to `t_max`.
    /// Returns whether the visitor ended the walk.
    #[inline(always)]
    pub(super) fn walk<S: Simd>(
        &self,
        simd: S,
        slabs: &Slabs<S>,
        mut t_max: f32,
        meter: &impl Meter,
        visitor: &mut impl Visitor,
    ) -> bool {
        self.walk_from(simd, slabs, 0, &mut t_max, meter, visitor)
    }

    /// [`Wide::walk`] below one node only.
    #[inline(always)]
    pub(super) fn walk_from<S: Simd, V: Visitor>(
        &self,
        simd: S,
        slabs: &Slabs<S>,
        start: u32,
        t_max: &mut f32,
        meter: &impl Meter,
        visitor: &mut V,
    ) -> bool {
        let mut room = Room::<Pending, STACK>::new();
        let mut stack = room.stack();
        let mut here = start;
        loop {
            if let Some(leaf) = Leaf::of_child(here) {
                if visitor.visit(leaf, t_max) {
                    return true;
                }
            } else {
                meter.count(Event::Node);
                let Some(node) = self.nodes.get(here as usize) else { return false };
                let (met, enter) = slabs.enter(simd, &node.planes, *t_max);
                let others = met & met.wrapping_sub(1);
                let met = if others != 0 && seeded(Fault::LeafSkipped) { others } else { met };
                if let Some(nearest) = self.nearest(simd, node, met, enter, &mut stack, visitor) {
                    here = nearest;
                    continue;
                }
            }
            here = loop {
                let Some(next) = stack.pop() else { return false };
                // A box that starts behind the best hit holds nothing closer; a NaN
                // is no bound.
                if V::ANY || !(f32::from_bits((next >> 32) as u32) > *t_max) {
                    break next as u32;
                }
            };
        }
    }

    /// Shows a visitor the leaves whose boxes one ray of a bundle may meet, as
    /// [`Wide::walk_ray`] does. Only for a ray that is usual. A function of its
    /// own, which has all registers for its loop.
    #[inline(always)]
    pub(crate) fn walk_one<S: Simd>(
        &self,
        simd: S,
        bundle: &Bundle,
        ray: usize,
        visitor: &mut impl Visitor,
    ) {
        simd.apart(WalkOne { wide: self, bundle, ray, visitor });
    }

    /// The child whose box is entered first; the others of `met` are put on the
    /// stack, the farthest first.
    #[inline(always)]
    fn nearest<S: Simd, V: Visitor>(
        &self,
        simd: S,
        node: &Node,
        met: u32,
        enter: S::F8,
        stack: &mut Stack<'_, Pending>,
        visitor: &V,
    ) -> Option<u32> {
        if met == 0 {
            return None;
        }
        // A number of at most 8 bits has its lowest below 8.
        let lowest = |bits: u32| (bits.trailing_zeros() & 7) as usize;
        let rest = met & (met - 1);
        if rest == 0 {
            return Some(node.children[lowest(met)]);
        }
        if V::ANY {
            // Any hit will do, and those near the start are no likelier.
            let mut rest = met;
            loop {
                let child = node.children[lowest(rest)];
                rest &= rest - 1;
                if rest == 0 {
                    return Some(child);
                }
                self.expect(simd, child, visitor);
                stack.push(Pending::from(child));
            }
        }
        let enter = enter.to_array();
        let waiting = |bits: u32| {
            let child = lowest(bits);
            pending(enter[child], node.children[child])
        };
        let (a, b) = (waiting(met), waiting(rest));
        self.expect(simd, a as u32, visitor);
        self.expect(simd, b as u32, visitor);
        let (first, second) = (a.min(b), a.max(b));
        let rest = rest & (rest - 1);
        if rest == 0 {
            stack.push(second);
            return Some(first as u32);
        }
        let c = waiting(rest);
        let (third, second) = (second.max(c), second.min(c));
        let (second, first) = (first.max(second), first.min(second));
        let mut rest = rest & (rest - 1);
        let bottom = stack.len();
        stack.push(third);
        stack.push(second);
        if rest == 0 {
            return Some(first as u32);
        }
        stack.push(first);
        while rest != 0 {
            stack.push(waiting(rest));
            rest &= rest - 1;
            let above = stack.from(bottom);
            let mut place = above.len() - 1;
            while place > 0 && above[place - 1] < above[place] {
                above.swap(place - 1, place);
                place -= 1;
            }
        }
        stack.pop().map(|nearest| nearest as u32)
    }

    /// Fetches what will probably be looked at soon. Which it is, is as good as
    /// random: both are found, and one chosen without a branch.
    #[inline(always)]
    fn expect<S: Simd>(&self, simd: S, child: u32, visitor: &impl Visitor) {
        let leaf = visitor.address(Leaf(child));
        let node = self.nodes.as_ptr().wrapping_add(child as usize).cast::<u8>();
        simd.prefetch(if Leaf::of_child(child).is_some() { leaf } else { node });
    }
}
