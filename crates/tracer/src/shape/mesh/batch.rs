//! A mesh's answers to many rays at once: made ready together, in an order that
//! suits the memory, as packets where they run beside each other.

use super::blocks::{Block, Blocks, Number};
use super::packet::{AnyOfPacket, ClosestOfPacket, Seekers};
use super::precision::{Accurate, Fast, Precision};
use super::sight::{Sight, Sighted};
use super::trace::by_storage;
use super::visit::{Any, Best, Closest, Known, Question};
use super::winners::Winners;
use super::{Contact, Interval, Mesh, Order, Ray, Unmetered};
use crate::accel::wide::{Abreast, Bundle, Packet, RAYS, Wide};
use crate::accel::{Coherence, Turns};
use crate::simd::{Simd, Work};

impl Mesh {
    /// What [`Geometry::intersect`](super::Geometry::intersect) says of each of
    /// these rays, put in its place in `contacts`; rays without a place there are
    /// not asked.
    pub fn intersect_batch(
        &self,
        rays: &[Ray],
        range: Interval,
        coherence: Coherence,
        contacts: &mut [Option<Contact>],
    ) {
        let rays = &rays[..rays.len().min(contacts.len())];
        let Order::Wide(wide) = &self.order else {
            for (ray, contact) in rays.iter().zip(contacts) {
                *contact = self.closest(ray, range, None, &Unmetered);
            }
            return;
        };
        let batch = Batch::new((self, wide), rays, range, coherence);
        match coherence {
            Coherence::Coherent => self.level.run(ClosestOfEach::<true> { batch, contacts }),
            Coherence::Incoherent => self.level.run(ClosestOfEach::<false> { batch, contacts }),
        }
    }

    /// What [`Geometry::occludes`](super::Geometry::occludes) says of each of
    /// these rays, put in its place in `occluded`; rays without a place there are
    /// not asked.
    pub fn occludes_batch(
        &self,
        rays: &[Ray],
        range: Interval,
        coherence: Coherence,
        occluded: &mut [bool],
    ) {
        let rays = &rays[..rays.len().min(occluded.len())];
        let Order::Wide(wide) = &self.order else {
            for (ray, occluded) in rays.iter().zip(occluded) {
                *occluded = self.occluder(ray, range, None, None, &Unmetered).is_some();
            }
            return;
        };
        let batch = Batch::new((self, wide), rays, range, coherence);
        match coherence {
            Coherence::Coherent => self.level.run(AnyOfEach::<true> { batch, occluded }),
            Coherence::Incoherent => self.level.run(AnyOfEach::<false> { batch, occluded }),
        }
    }
}

/// Rays, and what they ask of a mesh.
struct Batch<'a> {
    mesh: &'a Mesh,
    wide: &'a Wide,
    rays: &'a [Ray],
    range: Interval,
    turns: Turns,
}

impl<'a> Batch<'a> {
    fn new(
        (mesh, wide): (&'a Mesh, &'a Wide),
        rays: &'a [Ray],
        range: Interval,
        coherence: Coherence,
    ) -> Self {
        let turns = match coherence {
            Coherence::Coherent => Turns::AsGiven,
            Coherence::Incoherent => Turns::of(rays, mesh.bounds, mesh.bytes()),
        };
        Self { mesh, wide, rays, range, turns }
    }

    #[inline(always)]
    fn question(&self, ray: &'a Ray) -> Question<'a, Unmetered> {
        Question { mesh: self.mesh, ray, range: self.range, from: None, meter: &Unmetered }
    }
}

/// Rays made ready for boxes and blocks.
struct Ready<'a, P: Precision> {
    /// How many there are; in the other places are any.
    count: usize,
    /// Their numbers in the batch.
    numbers: [usize; RAYS],
    rays: [&'a Ray; RAYS],
    bundle: Bundle,
    sights: [Sighted<P>; RAYS],
}

impl<'a, P: Precision> Ready<'a, P> {
    /// None yet; in their places is this one.
    #[inline(always)]
    fn new(batch: &Batch<'a>, ray: &'a Ray) -> Self {
        Self {
            count: 0,
            numbers: [0; RAYS],
            rays: [ray; RAYS],
            bundle: Bundle::new(batch.wide, batch.range),
            sights: [Sighted::nothing(); RAYS],
        }
    }

    /// Takes the rays in whose turn it is from `first` on.
    #[inline(always)]
    fn fill<S: Simd>(&mut self, simd: S, batch: &Batch<'a>, first: usize) {
        self.count = RAYS.min(batch.rays.len() - first);
        match &batch.turns {
            Turns::AsGiven => {
                let some = &batch.rays[first..first + self.count];
                for (ray, given) in self.rays.iter_mut().zip(some) {
                    *ray = given;
                }
                for (k, number) in self.numbers.iter_mut().enumerate() {
                    *number = first + k;
                }
            }
            Turns::Sorted(turns) => {
                let turns = &turns[first..first + self.count];
                for ((ray, number), &turn) in self.rays.iter_mut().zip(&mut self.numbers).zip(turns)
                {
                    (*ray, *number) = (&batch.rays[turn as usize], turn as usize);
                }
            }
        }
        let size = (batch.mesh.middle, batch.mesh.half);
        let (fours, _) = self.rays.as_chunks::<4>();
        let (sights, _) = self.sights.as_chunks_mut::<4>();
        for (k, (rays, sights)) in fours.iter().zip(sights).enumerate() {
            let abreast = Abreast::new(simd, rays);
            self.bundle.fill(simd, batch.wide, 4 * k, &abreast);
            Sighted::fill(simd, sights, rays, &abreast, size);
        }
    }
}

#[inline(always)]
fn closest_of_each<S: Simd, P: Precision, T: Number, const COHERENT: bool>(
    simd: S,
    ClosestOfEach { batch, contacts }: ClosestOfEach<'_, COHERENT>,
    blocks: &[Block<T>],
) {
    let Some(ray) = batch.rays.first() else { return };
    let mut ready = Ready::<P>::new(&batch, ray);
    let mut winners = Winners::new(simd, batch.range, batch.rays, contacts);
    let mut known = [Known::Nothing; RAYS];
    for first in (0..batch.rays.len()).step_by(RAYS) {
        ready.fill(simd, &batch, first);
        closest_of_ready::<S, P, T, COHERENT>(simd, &batch, &ready, blocks, &mut known);
        for (&number, &known) in ready.numbers.iter().zip(&known).take(ready.count) {
            winners.add(number, known, blocks);
        }
    }
    winners.finish();
}

#[inline(always)]
fn closest_of_ready<S: Simd, P: Precision, T: Number, const COHERENT: bool>(
    simd: S,
    batch: &Batch<'_>,
    ready: &Ready<'_, P>,
    blocks: &[Block<T>],
    known: &mut [Known; RAYS],
) {
    let Ready { count, rays, bundle, sights, .. } = ready;
    if COHERENT && let Some(mut packet) = Packet::new(simd, bundle) {
        let seekers = Seekers { simd, mesh: batch.mesh, rays, range: batch.range, sights, blocks };
        let best = [Best::nothing(batch.range); RAYS];
        let mut seekers = ClosestOfPacket { seekers, time: bundle.time, best };
        batch.wide.walk_packet(simd, &mut packet, all(*count), &mut seekers);
        for (known, best) in known.iter_mut().zip(&seekers.best) {
            *known = best.known;
        }
        return;
    }
    let mut best = Best::nothing(batch.range);
    let mut visitor = Closest {
        question: batch.question(rays[0]),
        sight: Sight::new(simd, &sights[0]),
        blocks,
        time: bundle.time,
        best: &mut best,
    };
    for k in 0..(*count).min(RAYS) {
        visitor.question.ray = rays[k];
        if bundle.usual >> k & 1 == 0 {
            known[k] = Known::of(batch.mesh.closest(rays[k], batch.range, None, &Unmetered));
            continue;
        }
        visitor.sight = Sight::new(simd, &sights[k]);
        *visitor.best = Best::nothing(batch.range);
        batch.wide.walk_one(simd, bundle, k, &mut visitor);
        known[k] = visitor.best.known;
    }
}

#[inline(always)]
fn any_of_each<S: Simd, P: Precision, T: Number, const COHERENT: bool>(
    simd: S,
    AnyOfEach { batch, occluded }: AnyOfEach<'_, COHERENT>,
    blocks: &[Block<T>],
) {
    let Some(ray) = batch.rays.first() else { return };
    let mut ready = Ready::<P>::new(&batch, ray);
    for first in (0..batch.rays.len()).step_by(RAYS) {
        ready.fill(simd, &batch, first);
        let mut found = [None; RAYS];
        any_of_ready::<S, P, T, COHERENT>(simd, &batch, &ready, blocks, &mut found);
        for (&number, found) in ready.numbers.iter().zip(found).take(ready.count) {
            occluded[number] = found.is_some();
        }
    }
}

#[inline(always)]
fn any_of_ready<S: Simd, P: Precision, T: Number, const COHERENT: bool>(
    simd: S,
    batch: &Batch<'_>,
    ready: &Ready<'_, P>,
    blocks: &[Block<T>],
    found: &mut [Option<u32>; RAYS],
) {
    let Ready { count, rays, bundle, sights, .. } = ready;
    if COHERENT && let Some(mut packet) = Packet::new(simd, bundle) {
        let seekers = Seekers { simd, mesh: batch.mesh, rays, range: batch.range, sights, blocks };
        let mut seekers = AnyOfPacket { seekers, found };
        batch.wide.walk_packet(simd, &mut packet, all(*count), &mut seekers);
        return;
    }
    let mut one = None;
    let mut visitor = Any {
        question: batch.question(rays[0]),
        sight: Sight::new(simd, &sights[0]),
        blocks,
        found: &mut one,
    };
    for k in 0..(*count).min(RAYS) {
        visitor.question.ray = rays[k];
        if bundle.usual >> k & 1 == 0 {
            found[k] = batch.mesh.occluder(rays[k], batch.range, None, None, &Unmetered);
            continue;
        }
        visitor.sight = Sight::new(simd, &sights[k]);
        *visitor.found = None;
        batch.wide.walk_one(simd, bundle, k, &mut visitor);
        found[k] = *visitor.found;
    }
}

/// The bits of so many rays.
fn all(count: usize) -> u32 {
    (1 << count) - 1
}

struct ClosestOfEach<'a, const COHERENT: bool> {
    batch: Batch<'a>,
    contacts: &'a mut [Option<Contact>],
}

impl<const COHERENT: bool> Work for ClosestOfEach<'_, COHERENT> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self, simd: S) {
        by_storage!(self.batch.mesh, closest_of_each::<COHERENT>(simd, self));
    }
}

struct AnyOfEach<'a, const COHERENT: bool> {
    batch: Batch<'a>,
    occluded: &'a mut [bool],
}

impl<const COHERENT: bool> Work for AnyOfEach<'_, COHERENT> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self, simd: S) {
        by_storage!(self.batch.mesh, any_of_each::<COHERENT>(simd, self));
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::super::Geometry;
    use super::super::tests::bumpy;
    use super::*;
    use crate::accel::Build;

    #[test]
    fn answers_are_in_the_rays_places_in_whatever_order_they_are_traced() {
        let mut any = fastrand::Rng::with_seed(21);
        let (vertices, faces) = bumpy(&mut any, true);
        let mesh = Mesh::new(vertices, faces, None, Build::Bvh).unwrap();
        let mut point = || DVec3::new(any.f64(), any.f64(), any.f64()) * 2.0 - 1.0;
        let rays: Vec<_> = (0..67).map(|_| Ray::new(2.0 * point(), point())).collect();
        let range = Interval::AHEAD;
        let expected: Vec<_> = rays.iter().map(|ray| mesh.intersect(ray, range)).collect();
        assert!(expected.iter().flatten().count() > 10);
        let Order::Wide(wide) = &mesh.order else { panic!("no hierarchy") };
        let batch = || {
            // 29 and 67 have no factor in common.
            let turns = Turns::Sorted((0..67).map(|k| k * 29 % 67).collect());
            Batch { mesh: &mesh, wide, rays: &rays, range, turns }
        };
        let mut contacts = vec![None; rays.len()];
        mesh.level.run(ClosestOfEach::<false> { batch: batch(), contacts: &mut contacts });
        assert_eq!(contacts, expected);
        let mut occluded = vec![false; rays.len()];
        mesh.level.run(AnyOfEach::<false> { batch: batch(), occluded: &mut occluded });
        assert!(occluded.iter().zip(&expected).all(|(is, contact)| *is == contact.is_some()));
    }

    #[test]
    fn rays_without_a_place_are_not_asked() {
        let mut any = fastrand::Rng::with_seed(22);
        let (vertices, faces) = bumpy(&mut any, true);
        let mesh = Mesh::new(vertices, faces, None, Build::Bvh).unwrap();
        // It has no poles.
        let rays = vec![Ray::new(DVec3::new(3.0, 0.1, 0.2), -DVec3::X); 40];
        for coherence in [Coherence::Coherent, Coherence::Incoherent] {
            let (mut contacts, mut occluded) = (vec![None; 18], vec![false; 18]);
            mesh.intersect_batch(&rays, Interval::AHEAD, coherence, &mut contacts);
            mesh.occludes_batch(&rays, Interval::AHEAD, coherence, &mut occluded);
            assert!(contacts.iter().all(Option::is_some) && occluded.iter().all(|&is| is));
        }
    }
}
