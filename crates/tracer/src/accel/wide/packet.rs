//! `Packet`: rays that run beside each other, taken through the hierarchy
//! together: a node is tested for all of them at once, and a box for eight.
//!
//! It visits what each ray alone would visit, and a little more; who decides
//! hits is the same. So it changes the time and no answer.

use super::node::{Leaf, Node};
use super::slabs::{LARGEST, Slabs, TimeScale, is_usual, reach};
use super::walk::Visitor;
use super::{STACK, Wide};
use crate::meter::{Event, Meter};
use crate::simd::{Eight, Four, Room, Simd};
use crate::{Interval, Ray};

/// How many rays are in a packet.
pub(crate) const RAYS: usize = 16;
/// Rays tested together with one box.
const LANES: usize = 8;
/// So few rays go on alone.
const FEW: u32 = 4;

/// A number for each ray.
type Each<T> = [T; RAYS];

/// Rays that go the same way along every axis.
pub(crate) struct Packet<S: Simd> {
    /// For each axis and ray what [`Slabs`] has.
    recip: [Each<f32>; 3],
    near: [Each<f32>; 3],
    far: [Each<f32>; 3],
    down: [bool; 3],
    t_min: f32,
    /// Behind which nothing is of use to a ray.
    t_max: Each<f32>,
    /// For each axis the last start of a ray, as far as the way it goes, and the
    /// first; moved apart as near and far are.
    last: [S::F8; 3],
    first: [S::F8; 3],
    /// The least and the largest reciprocal of a direction.
    least: [S::F8; 3],
    most: [S::F8; 3],
    /// How the slabs' parameter follows from the rays'.
    pub(crate) time: TimeScale,
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

impl<S: Simd> Packet<S> {
    /// The packet of some rays, at most [`RAYS`]; `None` if they do not go the
    /// same way along every axis, or one of them cannot be computed with like
    /// that.
    #[inline(always)]
    pub(crate) fn new(simd: S, wide: &Wide, rays: &[Ray], range: Interval) -> Option<Self> {
        let first = rays.first()?;
        let (mut origin, mut direction) = ([[0.0; RAYS]; 3], [[0.0; RAYS]; 3]);
        let mut farthest = 0.0_f64;
        for k in 0..RAYS {
            // Places that are left repeat the first ray.
            let ray = rays.get(k).unwrap_or(first);
            let reach = reach(wide, ray);
            if !is_usual(wide, ray, reach) {
                return None;
            }
            farthest = farthest.max(reach);
            for axis in 0..3 {
                origin[axis][k] = ray.origin[axis];
                direction[axis][k] = ray.direction[axis];
            }
        }
        let time = TimeScale::of(wide);
        let (t_min, t_max) = (time.down(range.lo), time.up(range.hi));
        let zero = [[0.0; RAYS]; 3];
        let nothing = [simd.eight(0.0); 3];
        let mut packet = Self {
            recip: zero,
            near: zero,
            far: zero,
            down: [false; 3],
            t_min,
            t_max: [if t_max.is_nan() { f32::INFINITY } else { t_max }; RAYS],
            last: nothing,
            first: nothing,
            least: nothing,
            most: nothing,
            time,
        };
        for axis in 0..3 {
            if !packet.fill(simd, wide, axis, (&origin[axis], &direction[axis]), farthest) {
                return None;
            }
        }
        Some(packet)
    }

    /// Makes one axis ready; false if the rays go both ways along it.
    #[inline(always)]
    fn fill(
        &mut self,
        simd: S,
        wide: &Wide,
        axis: usize,
        (origin, direction): (&Each<f64>, &Each<f64>),
        farthest: f64,
    ) -> bool {
        let scale = simd.four_long(wide.scale);
        let (mut low, mut high) = ([f32::INFINITY; 2], [f32::NEG_INFINITY; 2]);
        let mut widest = 0.0_f64;
        for four in 0..RAYS / 4 {
            let at = 4 * four;
            let four_of = |each: &Each<f64>| [each[at], each[at + 1], each[at + 2], each[at + 3]];
            let o = simd.load_four_long(&four_of(origin)) * scale;
            let d = simd.load_four_long(&four_of(direction));
            let recip = simd.four_long(1.0) / d;
            let recip = recip.min(simd.four_long(LARGEST)).max(simd.four_long(-LARGEST));
            let (near, far, apart) =
                Slabs::<S>::sides(simd, wide, (o, recip), wide.extent[axis], farthest);
            let (recip, o) = (recip.to_singles(), o.to_singles());
            for (k, apart) in apart.to_array().into_iter().enumerate() {
                self.recip[axis][at + k] = recip[k];
                self.near[axis][at + k] = near[k];
                self.far[axis][at + k] = far[k];
                (low[0], high[0]) = (low[0].min(recip[k]), high[0].max(recip[k]));
                (low[1], high[1]) = (low[1].min(o[k]), high[1].max(o[k]));
                widest = widest.max(apart);
            }
        }
        // Outwards, for the rounding of the origins and of what is taken apart.
        let widest = (widest as f32).next_up();
        let (low_o, high_o) = ((low[1] - widest).next_down(), (high[1] + widest).next_up());
        let is_down = high[0] < 0.0;
        self.down[axis] = is_down;
        let (last, first) = if is_down { (low_o, high_o) } else { (high_o, low_o) };
        self.last[axis] = simd.eight(last);
        self.first[axis] = simd.eight(first);
        self.least[axis] = simd.eight(low[0]);
        self.most[axis] = simd.eight(high[0]);
        is_down || low[0] > 0.0
    }

    /// A bit for each of a node's boxes that any ray may meet, and where the
    /// first may enter it.
    #[inline(always)]
    fn enter(&self, simd: S, node: &Node, t_max: f32) -> (u32, S::F8) {
        let mut enter = simd.eight(self.t_min);
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
            let mut enter = simd.eight(self.t_min);
            let mut leave = simd.load_eight(eight(&self.t_max, lanes));
            for axis in 0..3 {
                let down = self.down[axis];
                let near = simd.eight(node.planes[axis][usize::from(down)][child]);
                let far = simd.eight(node.planes[axis][usize::from(!down)][child]);
                let recip = simd.load_eight(eight(&self.recip[axis], lanes));
                let apart = simd.load_eight(eight(&self.near[axis], lanes));
                enter = enter.max(near.times_minus(recip, apart));
                let apart = simd.load_eight(eight(&self.far[axis], lanes));
                leave = leave.min(far.times_minus(recip, apart));
            }
            met |= enter.is_at_most(leave) << (LANES * lanes);
        }
        met & rays
    }

    /// The slabs of one ray.
    #[inline(always)]
    fn slabs(&self, simd: S, ray: usize) -> Slabs<S> {
        let of = |each: &[Each<f32>; 3]| [each[0][ray], each[1][ray], each[2][ray]];
        Slabs::of(simd, of(&self.recip), of(&self.near), of(&self.far), self.down, self.t_min)
    }
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
        packet: &mut Packet<S>,
        mut rays: u32,
        meter: &impl Meter,
        visitors: &mut V,
    ) {
        let mut room = Room::<Waiting, STACK>::new();
        let mut stack = room.stack();
        let Some(mut node) = self.nodes.first() else { return };
        let (mut here, mut active) = (0_u32, rays);
        loop {
            meter.count(Event::Node);
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
                        let slabs = packet.slabs(simd, ray);
                        let t_max = &mut packet.t_max[ray];
                        let visitor = &mut visitors.of(ray);
                        if self.walk_from(simd, &slabs, child, t_max, meter, visitor) {
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
