//! `Packet`: rays that run beside each other, taken through the hierarchy
//! together: a node is tested for all of them at once, and a box for eight.
//!
//! It visits what each ray alone would visit, and a little more; who decides
//! hits is the same. So it changes the time and no answer.

use super::bundle::{Bundle, Each, RAYS};
use super::node::{Leaf, Node};
use super::walk::Visitor;
use super::{STACK, Wide};
use crate::meter::Unmetered;
use crate::simd::{Eight, Room, Simd};

/// Rays tested together with one box.
const LANES: usize = 8;
/// So few rays go on alone.
const FEW: u32 = 4;

/// Rays that go the same way along every axis.
pub(crate) struct Packet<'a, S: Simd> {
    bundle: &'a Bundle,
    down: [bool; 3],
    /// Behind which nothing is of use to a ray.
    t_max: Each<f32>,
    /// For each axis the last start of a ray, as far as the way it goes, and the
    /// first; moved apart as near and far are.
    last: [S::F8; 3],
    first: [S::F8; 3],
    /// The least and the largest reciprocal of a direction.
    least: [S::F8; 3],
    most: [S::F8; 3],
}

/// A child that waits, and the rays that may meet it.
#[derive(Clone, Copy)]
struct Waiting {
    /// Where the first ray may enter its box.
    enter: f32,
    node: u32,
    child: u32,
    rays: u32,
}

/// Who is shown the leaves that the rays of a packet may meet.
pub(crate) trait Visitors {
    /// Whether one hit is as good as another.
    const ANY: bool;
    /// The visitor of one ray.
    fn of(&mut self, ray: usize) -> impl Visitor;
}

impl<'a, S: Simd> Packet<'a, S> {
    /// The packet of the rays of a bundle; `None` if they do not go the same way
    /// along every axis, or one of them cannot be computed with like that.
    #[inline(always)]
    pub(crate) fn new(simd: S, bundle: &'a Bundle) -> Option<Self> {
        let all = (1 << RAYS) - 1;
        if bundle.usual != all {
            return None;
        }
        let t_max = if bundle.t_max.is_nan() { f32::INFINITY } else { bundle.t_max };
        let nothing = [simd.eight(0.0); 3];
        let mut packet = Self {
            bundle,
            down: [false; 3],
            t_max: [t_max; RAYS],
            last: nothing,
            first: nothing,
            least: nothing,
            most: nothing,
        };
        // Outwards, for the rounding of the origins and of what is taken apart.
        let widest = ends(simd, &bundle.apart).1.next_up();
        for axis in 0..3 {
            let (least, most) = ends(simd, &bundle.recip[axis]);
            let (low, high) = ends(simd, &bundle.origin[axis]);
            let (low, high) = ((low - widest).next_down(), (high + widest).next_up());
            let is_down = most < 0.0;
            if !is_down && !(least > 0.0) {
                return None;
            }
            packet.down[axis] = is_down;
            let (last, first) = if is_down { (low, high) } else { (high, low) };
            packet.last[axis] = simd.eight(last);
            packet.first[axis] = simd.eight(first);
            packet.least[axis] = simd.eight(least);
            packet.most[axis] = simd.eight(most);
        }
        Some(packet)
    }

    /// A bit for each of a node's boxes that any ray may meet, and where the
    /// first may enter it.
    #[inline(always)]
    fn enter(&self, simd: S, node: &Node, t_max: f32) -> (u32, S::F8) {
        let mut enter = simd.eight(self.bundle.t_min);
        let mut leave = simd.eight(t_max);
        for axis in 0..3 {
            let down = self.down[axis];
            let near = simd.load_eight(&node.planes[axis][usize::from(down)]);
            let far = simd.load_eight(&node.planes[axis][usize::from(!down)]);
            let (near, far) = (near.less(self.last[axis]), far.less(self.first[axis]));
            let (least, most) = (self.least[axis], self.most[axis]);
            enter = enter.max(near.times(least).min(near.times(most)));
            leave = leave.min(far.times(least).max(far.times(most)));
        }
        (enter.is_at_most(leave), enter)
    }

    /// Which of these rays may meet one box.
    #[inline(always)]
    fn rays_in(&self, simd: S, node: &Node, child: usize, rays: u32) -> u32 {
        let mut met = 0;
        for lanes in 0..RAYS / LANES {
            if rays >> (LANES * lanes) & ((1 << LANES) - 1) == 0 {
                continue;
            }
            let mut enter = simd.eight(self.bundle.t_min);
            let mut leave = simd.load_eight(eight(&self.t_max, lanes));
            for axis in 0..3 {
                let down = self.down[axis];
                let near = simd.eight(node.planes[axis][usize::from(down)][child]);
                let far = simd.eight(node.planes[axis][usize::from(!down)][child]);
                let recip = simd.load_eight(eight(&self.bundle.recip[axis], lanes));
                let apart = simd.load_eight(eight(&self.bundle.near[axis], lanes));
                enter = enter.max(near.times_plus(recip, apart));
                let apart = simd.load_eight(eight(&self.bundle.far[axis], lanes));
                leave = leave.min(far.times_plus(recip, apart));
            }
            met |= enter.is_at_most(leave) << (LANES * lanes);
        }
        met & rays
    }
}

/// The least and the largest of some numbers.
#[inline(always)]
fn ends<S: Simd>(simd: S, each: &Each<f32>) -> (f32, f32) {
    let (a, b) = (simd.load_eight(eight(each, 0)), simd.load_eight(eight(each, 1)));
    let (mut least, mut most) = (f32::INFINITY, f32::NEG_INFINITY);
    for x in a.min(b).to_array() {
        least = least.min(x);
    }
    for x in a.max(b).to_array() {
        most = most.max(x);
    }
    (least, most)
}

/// Eight of all.
#[inline(always)]
fn eight(each: &Each<f32>, lanes: usize) -> &[f32; LANES] {
    let (eights, _) = each.as_chunks::<LANES>();
    &eights[lanes]
}

/// The numbers of the bits, lowest first.
#[inline(always)]
fn bits(mut bits: u32) -> impl Iterator<Item = usize> {
    std::iter::from_fn(move || {
        let lowest = bits.trailing_zeros() as usize;
        bits &= bits.wrapping_sub(1);
        (lowest < RAYS).then_some(lowest)
    })
}

impl Wide {
    /// Shows the visitors the leaves whose boxes their rays may meet, of the
    /// rays whose bits are set.
    #[inline(always)]
    pub(crate) fn walk_packet<S: Simd, V: Visitors>(
        &self,
        simd: S,
        packet: &mut Packet<'_, S>,
        mut rays: u32,
        visitors: &mut V,
    ) {
        let mut room = Room::<Waiting, STACK>::new();
        let mut stack = room.stack();
        let Some(mut node) = self.nodes.first() else { return };
        let (mut here, mut active) = (0_u32, rays);
        loop {
            let t_max = packet.t_max.iter().fold(f32::NEG_INFINITY, |far, &t| far.max(t));
            let (met, enter) = packet.enter(simd, node, t_max);
            // The nearest goes on top.
            let enter = enter.to_array();
            let bottom = stack.len();
            for child in bits(met) {
                stack.push(Waiting {
                    enter: enter[child],
                    node: here,
                    child: child as u32,
                    rays: active,
                });
                let above = stack.from(bottom);
                let mut place = above.len() - 1;
                while !V::ANY && place > 0 && above[place - 1].enter < above[place].enter {
                    above.swap(place - 1, place);
                    place -= 1;
                }
            }
            (node, here, active) = loop {
                let Some(next) = stack.pop() else { return };
                let Some(parent) = self.nodes.get(next.node as usize) else { return };
                let met = packet.rays_in(simd, parent, next.child as usize & 7, next.rays & rays);
                if met == 0 {
                    continue;
                }
                let child = parent.children[next.child as usize & 7];
                if let Some(leaf) = Leaf::of_child(child) {
                    for ray in bits(met) {
                        if visitors.of(ray).visit(leaf, &mut packet.t_max[ray]) {
                            rays &= !(1 << ray);
                        }
                    }
                } else if met.count_ones() <= FEW {
                    for ray in bits(met) {
                        let slabs = packet.bundle.slabs(simd, ray);
                        let (t_max, visitor) = (&mut packet.t_max[ray], &mut visitors.of(ray));
                        if self.walk_from(simd, &slabs, child, t_max, &Unmetered, visitor) {
                            rays &= !(1 << ray);
                        }
                    }
                } else {
                    let Some(node) = self.nodes.get(child as usize) else { return };
                    break (node, child, met);
                }
                if rays == 0 {
                    return;
                }
            };
        }
    }
}
