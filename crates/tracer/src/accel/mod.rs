//! Finding the closest of many candidates: the linear list as the reference,
//! and a bounding volume hierarchy that gives the same answers sooner.
//!
//! An accelerator knows boxes and numbers only. Whoever owns the candidates
//! (a group its members, a mesh its triangles) passes a test for one of them,
//! so the same structure serves all, and another can take its place here
//! without touching its users.
//!
//! The contract of every accelerator: the candidate with the lowest `t` wins,
//! and of several with the very same `t` the one that comes first in the
//! list. So the answer does not depend on the structure.

mod bvh;
mod list;
mod turns;
pub(crate) mod wide;

pub use bvh::Bvh;
pub use list::List;
pub(crate) use list::end_after;
pub(crate) use turns::Turns;

use crate::meter::Meter;
use crate::simd::{Instructions, Level};
use crate::{Aabb, Interval, Ray};

/// What a test returns: something with a `t` to compare.
pub trait Candidate {
    /// The ray parameter of the hit.
    fn t(&self) -> f64;
}

impl Candidate for f64 {
    fn t(&self) -> f64 {
        *self
    }
}

/// Which accelerator to build.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Build {
    /// The linear list of the lecture: the reference.
    List,
    /// A bounding volume hierarchy.
    #[default]
    Bvh,
    /// A bounding volume hierarchy whose triangles are met in `f32`: sooner, and
    /// not exact.
    Fast,
    /// [`Build::Bvh`] with these instructions in place of the processor's best:
    /// to show that no picture depends on them.
    With(Instructions),
}

impl Build {
    /// The instructions that what is built is walked with.
    pub(crate) fn level(self) -> Level {
        match self {
            Self::With(instructions) => instructions.level(),
            Self::List | Self::Bvh | Self::Fast => Level::best(),
        }
    }
}

/// How the rays of a batch lie to each other. A hint: it changes the time and
/// no answer.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Coherence {
    /// Neighbors in the batch run beside each other, as eye rays of a tile do
    /// and those from there to a light.
    Coherent,
    /// They go anywhere.
    Incoherent,
}

/// A structure over the boxes of some candidates, numbered in their order.
#[derive(Debug, Clone, PartialEq)]
pub enum Accelerator {
    /// Tests every candidate.
    List(List),
    /// Skips candidates whose boxes the ray misses.
    Bvh(Bvh),
}

impl Accelerator {
    /// The accelerator over candidates with these boxes; a box may be
    /// unbounded. A single one is tested sooner than its box.
    ///
    /// `rounding` is how many times more than a shape's own formulas the
    /// candidates' tests may round: 1 for shapes, the condition of its
    /// transform for a group.
    pub fn build(build: Build, boxes: &[Aabb], rounding: f64) -> Self {
        match build {
            Build::Bvh | Build::Fast | Build::With(_) if boxes.len() > 1 => {
                Self::Bvh(Bvh::new(boxes, rounding, build))
            }
            _ => Self::List(List::new(boxes.len())),
        }
    }

    /// The candidate that is hit first inside `range`, with its number.
    ///
    /// `test(i, range)` is candidate `i`'s closest hit strictly inside the
    /// range that it is given. Each one that it finds there is the best so far.
    pub(crate) fn closest<H: Candidate>(
        &self,
        ray: &Ray,
        range: Interval,
        meter: &impl Meter,
        test: impl FnMut(u32, Interval) -> Option<H>,
    ) -> Option<(u32, H)> {
        match self {
            Self::List(list) => list.closest(range, test),
            Self::Bvh(bvh) => bvh.closest(ray, range, meter, test),
        }
    }

    /// Whether `test(i)` is true for any candidate that the ray may meet
    /// inside `range`.
    pub(crate) fn any(
        &self,
        ray: &Ray,
        range: Interval,
        meter: &impl Meter,
        test: impl FnMut(u32) -> bool,
    ) -> bool {
        match self {
            Self::List(list) => list.any(test),
            Self::Bvh(bvh) => bvh.any(ray, range, meter, test),
        }
    }
}
