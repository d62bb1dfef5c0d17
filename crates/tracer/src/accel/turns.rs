//! `Turns`: the order in which a batch's rays are best traced: neighbors that
//! visit the same boxes find them in the cache.

use glam::DVec3;

use crate::math::max_abs;
use crate::{Aabb, Ray};

/// Fewer rays are traced as given: there are too few to each box.
const FEWEST: usize = 1 << 12;
/// Fewer bytes of boxes and triangles stay in a cache that is near: putting the
/// rays in order then takes longer than it saves.
const MUCH: usize = 40 << 20;
/// How many pairs of neighbors are looked at to see whether rays are in order.
const PAIRS: usize = 64;
/// Rays are in order if neighbors start closer than this part of the scene, in
/// the mean along its longest side.
const NEAR: f64 = 1.0 / 32.0;

/// Bits of a key for where along an axis a ray starts, and for where along it
/// the ray goes.
const START: u32 = 4;
const WAY: u32 = 3;
/// All bits of a key: three axes of both. It is sorted by halves.
const KEY: u32 = 3 * (START + WAY);
const HALF: u32 = KEY.div_ceil(2);

/// The order of some rays.
pub(crate) enum Turns {
    /// That of the batch.
    AsGiven,
    /// The numbers of the rays, one after the other.
    Sorted(Vec<u32>),
}

impl Turns {
    /// The order for rays whose scene has these bounds and takes so many bytes: as
    /// given, unless there are many that jump about in much; then by cells of a
    /// grid of starts, and in each by direction.
    pub(crate) fn of(rays: &[Ray], bounds: Aabb, bytes: usize) -> Self {
        let side = (bounds.max - bounds.min).max_element();
        let fits = bytes >= MUCH && rays.len() >= FEWEST && u32::try_from(rays.len()).is_ok();
        if !fits || !(side > 0.0) || !side.is_finite() || are_in_order(rays, side) {
            return Self::AsGiven;
        }
        let keys = rays
            .iter()
            .enumerate()
            .map(|(number, ray)| u64::from(key(ray, bounds.min, 1.0 / side)) << 32 | number as u64);
        let sorted = by_digit(by_digit(keys.collect(), 32), 32 + HALF);
        Self::Sorted(sorted.into_iter().map(|entry| entry as u32).collect())
    }
}

/// Whether neighbors start near each other, as far as a sample tells.
fn are_in_order(rays: &[Ray], side: f64) -> bool {
    let step = (rays.len() / PAIRS).max(1);
    let pairs = rays.windows(2).step_by(step);
    let count = pairs.len() as f64;
    let sum: f64 = pairs.map(|pair| max_abs(pair[1].origin - pair[0].origin)).sum();
    // So is a NaN.
    !(sum > NEAR * side * count)
}

/// The cell of a ray's start, above that of its direction.
fn key(ray: &Ray, min: DVec3, scale: f64) -> u32 {
    let start = (ray.origin - min) * scale;
    let way = ray.direction * (0.5 / max_abs(ray.direction)) + 0.5;
    interleaved(start, START) << (3 * WAY) | interleaved(way, WAY)
}

/// The bits of three numbers from 0 to 1, those of the same weight side by side.
fn interleaved(place: DVec3, bits: u32) -> u32 {
    let cells = f64::from(1_u32 << bits);
    // Saturates: a NaN goes to the first cell, as good as any.
    let cell = |x: f64| SPREAD[((x * cells) as usize).min((1 << bits) - 1) % SPREAD.len()];
    cell(place.x) << 2 | cell(place.y) << 1 | cell(place.z)
}

/// The bits of each number, three places apart.
const SPREAD: [u32; 1 << START] = {
    let mut spread = [0; 1 << START];
    let mut number = 0;
    while number < spread.len() {
        let mut bit = 0;
        while bit < START {
            spread[number] |= (number as u32 >> bit & 1) << (3 * bit);
            bit += 1;
        }
        number += 1;
    }
    spread
};

/// Sorted by half a key from this bit on; what is equal there keeps its order.
fn by_digit(entries: Vec<u64>, shift: u32) -> Vec<u64> {
    let digit = |entry: u64| (entry >> shift) as usize & ((1 << HALF) - 1);
    let mut places = vec![0_u32; 1 << HALF];
    for &entry in &entries {
        places[digit(entry)] += 1;
    }
    let mut sum = 0;
    for place in &mut places {
        (*place, sum) = (sum, sum + *place);
    }
    let mut sorted = vec![0; entries.len()];
    for entry in entries {
        let place = &mut places[digit(entry)];
        sorted[*place as usize] = entry;
        *place += 1;
    }
    sorted
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shuffled(count: usize) -> Vec<Ray> {
        let mut random = fastrand::Rng::with_seed(3);
        let mut point = || DVec3::new(random.f64(), random.f64(), random.f64());
        (0..count).map(|_| Ray::new(point(), point() - 0.5)).collect()
    }

    const UNIT: Aabb = Aabb { min: DVec3::ZERO, max: DVec3::ONE };

    #[test]
    fn every_ray_has_one_turn() {
        let rays = shuffled(10_000);
        let Turns::Sorted(mut numbers) = Turns::of(&rays, UNIT, MUCH) else { panic!("not sorted") };
        numbers.sort_unstable();
        assert!(numbers.iter().enumerate().all(|(k, &number)| k as u32 == number));
        assert_eq!(numbers.len(), rays.len());
    }

    #[test]
    fn turns_go_by_cell_of_the_start_and_then_by_direction() {
        let rays = shuffled(10_000);
        let Turns::Sorted(turns) = Turns::of(&rays, UNIT, MUCH) else { panic!("not sorted") };
        let keys = turns.iter().map(|&k| key(&rays[k as usize], DVec3::ZERO, 1.0));
        assert!(keys.is_sorted());
        let jump = |order: &dyn Fn(usize) -> usize| -> f64 {
            let start = |k: usize| rays[order(k)].origin;
            (1..rays.len()).map(|k| start(k).distance(start(k - 1))).sum()
        };
        assert!(jump(&|k| turns[k] as usize) < 0.25 * jump(&|k| k));
    }

    #[test]
    fn rays_in_order_few_rays_and_rays_of_no_scene_go_as_given() {
        let mut rays = shuffled(10_000);
        assert!(matches!(Turns::of(&rays[..FEWEST - 1], UNIT, MUCH), Turns::AsGiven));
        assert!(matches!(Turns::of(&rays, UNIT, MUCH - 1), Turns::AsGiven));
        assert!(matches!(Turns::of(&rays, Aabb::EMPTY, MUCH), Turns::AsGiven));
        rays.sort_by_key(|ray| key(ray, DVec3::ZERO, 1.0));
        assert!(
            matches!(Turns::of(&rays, UNIT, MUCH), Turns::Sorted(_)),
            "16 cells a side are far apart"
        );
        for ray in &mut rays {
            ray.origin = DVec3::splat(0.5);
        }
        assert!(matches!(Turns::of(&rays, UNIT, MUCH), Turns::AsGiven));
    }

    #[test]
    fn strange_rays_have_turns_too() {
        let mut rays = shuffled(10_000);
        rays[17].origin = DVec3::NAN;
        rays[18].direction = DVec3::ZERO;
        rays[19].origin = DVec3::splat(f64::MAX);
        let Turns::Sorted(turns) = Turns::of(&rays, UNIT, MUCH) else { panic!("not sorted") };
        let sum: usize = turns.iter().map(|&k| k as usize).sum();
        assert_eq!(sum, rays.len() * (rays.len() - 1) / 2);
    }
}
