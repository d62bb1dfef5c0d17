//! `Wide`: a bounding volume hierarchy of eight boxes to a node, which are
//! tested together in `f32`.
//!
//! It promises the linear list's answers: its box test may let a ray in that
//! misses, never keep one out that a candidate's own formula would hit.

mod build;
mod bundle;
mod node;
mod packet;
mod slabs;
mod walk;

pub(crate) use build::{Candidates, Gathered, Options, Span};
pub(crate) use bundle::{Abreast, Bundle, RAYS, longest};
pub(crate) use node::{Leaf, MOST_PLACES};
pub(crate) use packet::{Packet, Visitors};
pub(crate) use slabs::TimeScale;
pub(crate) use walk::Visitor;

use build::Tree;
use glam::DVec3;
use rayon::prelude::*;

use crate::meter::Meter;
use crate::simd::Simd;
use crate::{Aabb, Interval, Ray};
use node::Node;
use slabs::Slabs;

/// Room for the boxes that wait, seven on each level at most.
const STACK: usize = 7 * build::MAX_DEPTH + 1;

/// A bounding volume hierarchy over the boxes of some candidates.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Wide {
    /// The root first.
    nodes: Vec<Node>,
    /// Boxes are stored times this power of two, which makes the largest
    /// coordinate about 1.
    scale: f64,
    /// For each axis the largest coordinate of any box, scaled; and 0.
    extent: [f64; 4],
    /// The largest of these.
    largest: f64,
    /// An origin of a larger coordinate, scaled, is too far away to compute with.
    farthest: f64,
    /// How much boxes are widened, in the largest coordinate of an origin plus
    /// that of the boxes.
    thickness: f64,
}

impl Wide {
    /// The hierarchy over the candidates that were gathered. Each leaf is put
    /// where `leaf` says, which is told its number and where its candidates are
    /// in the items; there are at most `options.leaf_size`. Returns the leaves
    /// in the order of their numbers, and the items, too.
    pub(crate) fn new(
        gathered: Gathered,
        candidates: &impl Candidates,
        rounding: f64,
        options: Options,
        leaf: impl Fn(u32, Span) -> Leaf + Sync,
    ) -> (Self, Vec<Span>, Vec<u32>) {
        let scale = gathered.scale;
        let is_empty = gathered.count() == 0;
        let bounds = if is_empty { Aabb::around([DVec3::ZERO]) } else { gathered.bounds };
        let [x, y, z] = (bounds.min.abs().max(bounds.max.abs()) * scale).to_array();
        let Tree { branches, leaves, items } = build::build(gathered, candidates, options);
        let nodes = branches.par_iter().map(|branch| Node::new(branch, &leaf)).collect();
        let largest = x.max(y).max(z);
        let wide = Self {
            nodes,
            scale,
            extent: [x, y, z, 0.0],
            largest,
            farthest: slabs::FARTHEST * largest,
            thickness: slabs::thickness(rounding),
        };
        (wide, leaves, items)
    }

    /// How many bytes it takes.
    pub(crate) fn bytes(&self) -> usize {
        size_of_val(self.nodes.as_slice())
    }

    /// Shows a visitor the leaves whose boxes the ray may meet inside the range,
    /// nearest first. Returns whether the visitor ended it.
    #[inline(always)]
    pub(crate) fn walk_ray<S: Simd, V: Visitor>(
        &self,
        simd: S,
        ray: &Ray,
        range: Interval,
        meter: &impl Meter,
        visitor: &mut V,
    ) -> bool {
        let (slabs, time) = Slabs::new(simd, self, ray, range);
        visitor.start(time);
        self.walk(simd, &slabs, time.up(range.hi), meter, visitor)
    }

    /// The boxes of the nodes down to a few levels.
    pub(crate) fn coarse_boxes(&self) -> Vec<Aabb> {
        /// At most 64 boxes.
        const LEVELS: u32 = 2;
        let mut boxes = Vec::new();
        let mut pending = vec![(0_u32, 0)];
        while let Some((node, level)) = pending.pop() {
            let Some(node) = self.nodes.get(node as usize) else { continue };
            for k in (0..8).filter(|&k| node.has(k)) {
                let child = node.children[k];
                if level + 1 == LEVELS || Leaf::of_child(child).is_some() {
                    let side =
                        |side: usize| [0, 1, 2].map(|axis| f64::from(node.planes[axis][side][k]));
                    let [min, max] =
                        [0, 1].map(|upper| DVec3::from_array(side(upper)) / self.scale);
                    boxes.push(Aabb { min, max });
                } else {
                    pending.push((child, level + 1));
                }
            }
        }
        boxes
    }
}
