//! The rays of a packet at the leaves of a mesh's hierarchy.

use super::blocks::{Block, Number};
use super::precision::Precision;
use super::sight::{Sight, Sighted};
use super::visit::{Any, Best, Closest, Question};
use super::{Interval, Mesh, Ray, Unmetered};
use crate::accel::wide::{RAYS, TimeScale, Visitor, Visitors};
use crate::simd::Simd;

/// The rays of a packet, and what they ask.
pub(super) struct Seekers<'a, S: Simd, P: Precision, T> {
    pub(super) simd: S,
    pub(super) mesh: &'a Mesh,
    pub(super) rays: &'a [&'a Ray; RAYS],
    pub(super) range: Interval,
    pub(super) sights: &'a [Sighted<P>; RAYS],
    pub(super) blocks: &'a [Block<T>],
}

impl<'a, S: Simd, P: Precision, T: Number> Seekers<'a, S, P, T> {
    #[inline(always)]
    fn question(&self, ray: usize) -> Question<'a, Unmetered> {
        let Self { mesh, rays, range, .. } = *self;
        Question { mesh, ray: rays[ray % RAYS], range, from: None, meter: &Unmetered }
    }

    #[inline(always)]
    fn sight(&self, ray: usize) -> Sight<'a, S, P> {
        Sight::new(self.simd, &self.sights[ray % RAYS])
    }
}

/// For the closest hit of each ray.
pub(super) struct ClosestOfPacket<'a, S: Simd, P: Precision, T> {
    pub(super) seekers: Seekers<'a, S, P, T>,
    pub(super) time: TimeScale,
    pub(super) best: [Best; RAYS],
}

impl<S: Simd, P: Precision, T: Number> Visitors for ClosestOfPacket<'_, S, P, T> {
    const ANY: bool = false;

    #[inline(always)]
    fn of(&mut self, ray: usize) -> impl Visitor {
        let Self { seekers, time, best } = self;
        Closest {
            question: seekers.question(ray),
            sight: seekers.sight(ray),
            blocks: seekers.blocks,
            time: *time,
            best: &mut best[ray % RAYS],
        }
    }
}

/// For any hit of each ray.
pub(super) struct AnyOfPacket<'a, 'b, S: Simd, P: Precision, T> {
    pub(super) seekers: Seekers<'a, S, P, T>,
    pub(super) found: &'b mut [Option<u32>; RAYS],
}

impl<S: Simd, P: Precision, T: Number> Visitors for AnyOfPacket<'_, '_, S, P, T> {
    const ANY: bool = true;

    #[inline(always)]
    fn of(&mut self, ray: usize) -> impl Visitor {
        let Self { seekers, found } = self;
        Any {
            question: seekers.question(ray),
            sight: seekers.sight(ray),
            blocks: seekers.blocks,
            found: &mut found[ray % RAYS],
        }
    }
}
