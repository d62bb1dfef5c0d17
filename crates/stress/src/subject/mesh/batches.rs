//! Batches of rays against the list, ray by ray: closest hits and shadows, of rays
//! that keep together and of others.

use std::sync::{Arc, LazyLock};

use tracer::accel::Coherence;
use tracer::shape::Geometry;
use tracer::{Interval, Ray};

use super::brute_force::{self, KINDS, MESHES, Make, Pair, bits};
use crate::family::{Family, Kernel, Volume};
use crate::{Case, Metric, Random};

/// The most rays in a batch: several packets of any width, and some that fill none.
const MOST: usize = 150;

pub(super) fn families() -> Vec<Family> {
    KINDS.iter().map(|&(name, make)| family(name, make)).collect()
}

type Pairs = Arc<LazyLock<Vec<Pair>, Box<dyn FnOnce() -> Vec<Pair> + Send>>>;

/// Where a case has the number that its rays come from, after the one of its mesh.
const SEED: usize = 1;
/// Numbers of a seed are below this, and so exact.
const SEEDS: usize = 1 << 30;

fn family(name: &'static str, make: Make) -> Family {
    let all = move || (0..MESHES).filter_map(|i| brute_force::pair(name, make, i)).collect();
    let makes: Pairs = Arc::new(LazyLock::new(Box::new(all)));
    let judges = Arc::clone(&makes);
    Family {
        primitive: "mesh",
        name: format!("batches/{name}"),
        kernels: vec![Kernel::GOLDRAY],
        targets: vec![(Metric::Disagreements, Some(0.0))],
        volume: Volume { quick: 2_000, full: 500_000 },
        generate: Box::new(move |random| {
            let number = random.below(makes.len());
            Case::EMPTY.with(number as f64).with(random.below(SEEDS) as f64)
        }),
        judge: Box::new(move |case, tallies| {
            let Some(pair) = judges.get(case.number(0) as usize) else { return };
            let mut random = Random::of_chunk(0, name, case.number(SEED) as u64);
            let (rays, range) = batch(pair, &mut random);
            let agree = agrees(pair, &rays, range);
            for tally in tallies {
                tally.case();
                if !agree {
                    tally.count(Metric::Disagreements);
                }
            }
        }),
    }
}

/// Rays that keep together, more or less, or go anywhere, and a range for all.
fn batch(pair: &Pair, random: &mut Random) -> (Vec<Ray>, Interval) {
    let first = brute_force::ray(pair, random);
    let range = brute_force::range(pair, &first, random);
    let count = 1 + random.below(MOST);
    let apart = random.one_of(&[f64::NAN, 0.0, 1e-15, 1e-3, 0.1, 1.0]);
    let next = |_| {
        if apart.is_nan() {
            return brute_force::ray(pair, random);
        }
        let length = first.direction.length();
        let start = random.one_of(&[0.0, 1.0]) * apart * length;
        let origin = first.origin + start * random.point();
        Ray::new(origin, first.direction + apart * length * random.point())
    };
    ((0..count).map(next).collect(), range)
}

fn agrees(Pair { list, bvh, .. }: &Pair, rays: &[Ray], range: Interval) -> bool {
    let alone: Vec<_> = rays.iter().map(|ray| bits(list.intersect(ray, range))).collect();
    [Coherence::Coherent, Coherence::Incoherent].into_iter().all(|coherence| {
        let (mut contacts, mut occluded) = (vec![None; rays.len()], vec![false; rays.len()]);
        bvh.intersect_batch(rays, range, coherence, &mut contacts);
        bvh.occludes_batch(rays, range, coherence, &mut occluded);
        let same = alone.iter().zip(contacts).all(|(&one, other)| one == bits(other));
        same && alone.iter().zip(occluded).all(|(one, other)| one.is_some() == other)
    })
}
