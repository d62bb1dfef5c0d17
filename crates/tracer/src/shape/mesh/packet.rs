//! Batches of rays that run beside each other, a packet at a time.

use super::blocks::{Block, Number};
use super::precision::Precision;
use super::sight::{Sight, Sighted};
use super::visit::{Any, Best, Closest, Known, Question};
use super::{Interval, Mesh, Ray, Unmetered};
use crate::accel::wide::{Packet, RAYS, TimeScale, Visitor, Visitors, Wide};
use crate::simd::Simd;

/// The rays of a packet, and what was found for each.
struct Seekers<'a, S: Simd, P: Precision, T> {
    simd: S,
    blocks: &'a [Block<T>],
    time: TimeScale,
    questions: [Question<'a, Unmetered>; RAYS],
    /// The rays seen by blocks, of those that have met one.
    sights: [Option<Sighted>; RAYS],
    best: [Best; RAYS],
    precision: std::marker::PhantomData<P>,
}

impl<'a, S: Simd, P: Precision, T: Number> Seekers<'a, S, P, T> {
    #[inline(always)]
    fn new(
        simd: S,
        mesh: &'a Mesh,
        rays: &'a [Ray],
        range: Interval,
        blocks: &'a [Block<T>],
        time: TimeScale,
    ) -> Self {
        let first = Question { mesh, ray: &rays[0], range, from: None, meter: &Unmetered };
        let mut questions = [first; RAYS];
        for (question, ray) in questions.iter_mut().zip(rays) {
            question.ray = ray;
        }
        Self {
            simd,
            blocks,
            time,
            questions,
            sights: [None; RAYS],
            best: [Best::nothing(range); RAYS],
            precision: std::marker::PhantomData,
        }
    }

    #[inline(always)]
    fn sight(&mut self, ray: usize) -> Sight<S, P> {
        let Question { ray: of, mesh, .. } = self.questions[ray];
        let sighted = match self.sights[ray] {
            Some(sighted) => sighted,
            None => Sighted::new::<P>(of, mesh.middle, mesh.half),
        };
        self.sights[ray] = Some(sighted);
        Sight::new(self.simd, sighted)
    }
}

/// For the closest hit of each ray.
struct ClosestOfPacket<'a, S: Simd, P: Precision, T>(Seekers<'a, S, P, T>);

impl<S: Simd, P: Precision, T: Number> Visitors for ClosestOfPacket<'_, S, P, T> {
    const ANY: bool = false;

    #[inline(always)]
    fn of(&mut self, ray: usize) -> impl Visitor {
        let sight = self.0.sight(ray);
        let Seekers { simd, blocks, time, questions, best, .. } = &mut self.0;
        let (question, best) = (&questions[ray], &mut best[ray]);
        Closest { simd: *simd, question, sight, blocks, time: *time, best }
    }
}

/// For any hit of each ray.
struct AnyOfPacket<'a, S: Simd, P: Precision, T> {
    seekers: Seekers<'a, S, P, T>,
    found: [Option<u32>; RAYS],
}

impl<S: Simd, P: Precision, T: Number> Visitors for AnyOfPacket<'_, S, P, T> {
    const ANY: bool = true;

    #[inline(always)]
    fn of(&mut self, ray: usize) -> impl Visitor {
        let sight = self.seekers.sight(ray);
        let Seekers { simd, blocks, questions, .. } = &self.seekers;
        let (question, found) = (&questions[ray], &mut self.found[ray]);
        Any { simd: *simd, question, sight, blocks, found }
    }
}

/// The bits of so many rays.
fn all(count: usize) -> u32 {
    (1 << count) - 1
}

/// What is known of the closest hits of the rays of a packet; `None` if they are
/// none.
#[inline(always)]
pub(super) fn closest<S: Simd, P: Precision, T: Number>(
    simd: S,
    (mesh, wide): (&Mesh, &Wide),
    rays: &[Ray],
    range: Interval,
    blocks: &[Block<T>],
) -> Option<[Known; RAYS]> {
    let mut packet = Packet::new(simd, wide, rays, range)?;
    let seekers = Seekers::<S, P, T>::new(simd, mesh, rays, range, blocks, packet.time);
    let mut seekers = ClosestOfPacket(seekers);
    wide.walk_packet(simd, &mut packet, all(rays.len()), &Unmetered, &mut seekers);
    let best = seekers.0.best;
    let mut known = [Known::Nothing; RAYS];
    for (known, best) in known.iter_mut().zip(best) {
        *known = best.known;
    }
    Some(known)
}

/// Whether the rays of a packet hit anything; false if they are none.
#[inline(always)]
pub(super) fn any<S: Simd, P: Precision, T: Number>(
    simd: S,
    (mesh, wide): (&Mesh, &Wide),
    rays: &[Ray],
    range: Interval,
    blocks: &[Block<T>],
    occluded: &mut [bool],
) -> bool {
    let Some(mut packet) = Packet::new(simd, wide, rays, range) else { return false };
    let seekers = Seekers::<S, P, T>::new(simd, mesh, rays, range, blocks, packet.time);
    let mut seekers = AnyOfPacket { seekers, found: [None; RAYS] };
    wide.walk_packet(simd, &mut packet, all(rays.len()), &Unmetered, &mut seekers);
    for (occluded, found) in occluded.iter_mut().zip(seekers.found) {
        *occluded = found.is_some();
    }
    true
}
