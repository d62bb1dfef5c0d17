//! `Gathered`: all candidates that are there, looked at once.

use rayon::prelude::*;

use super::partition::Set;
use super::reference::Reference;
use super::units::Units;
use super::{Candidates, Options};
use crate::Aabb;
use crate::math::power_of_two_below;

/// Largest coordinates from `1 / USUAL` to `USUAL` are taken as they are.
const USUAL: f32 = (1_u64 << 40) as f32;
/// Candidates are looked at by this many at a time.
const CHUNK: usize = 4096;

/// The candidates as references, with room for more of them.
pub(crate) struct Gathered {
    /// Around all boxes; empty where there are none.
    pub bounds: Aabb,
    /// Boxes are taken times this power of two.
    pub scale: f64,
    pub(super) units: Units,
    /// The first `count` are those of the candidates, in the order of their
    /// numbers.
    pub(super) references: Vec<Reference>,
    pub(super) count: u32,
    pub(super) set: Set,
}

/// What was found in a chunk.
struct Found {
    bounds: Aabb,
    set: Set,
    count: usize,
}

impl Gathered {
    /// The candidates times the power of two that makes their largest
    /// coordinate about 1.
    pub(crate) fn new(candidates: &impl Candidates, options: Options) -> Self {
        let scale_of = |largest| 1.0 / power_of_two_below(largest).unwrap_or(1.0);
        let guess = scale_of(candidates.largest());
        let gathered = Self::scaled(candidates, options, guess);
        let scale = scale_of(gathered.bounds.max_abs());
        let is_usual = scale == guess || gathered.count == 0;
        if is_usual { gathered } else { Self::scaled(candidates, options, scale) }
    }

    /// The candidates times this.
    pub(super) fn scaled(candidates: &impl Candidates, options: Options, scale: f64) -> Self {
        let numbers = candidates.count() as usize;
        // Saturating, and 0 for NaN; references are counted in 32 bits.
        let spare =
            |count: usize| ((count as f64 * options.extra) as usize).min(u32::MAX as usize - count);
        let mut references = Reference::blanks(numbers + spare(numbers));
        let mut units = Units::SCENE;
        let places = &mut references[..numbers];
        let mut found = fill(candidates, scale, units, places);
        let largest = found.set.bounds.lo.abs().max(found.set.bounds.hi.abs());
        let largest = largest.truncate().max_element();
        let is_usual = largest == 0.0 || (1.0 / USUAL..=USUAL).contains(&largest);
        if !is_usual && found.count > 0 {
            units = Units::of(scale * found.bounds.max_abs());
            found = fill(candidates, scale, units, places);
        }
        let Found { bounds, set, count } = found;
        references.truncate(count + spare(count));
        Self { bounds, scale, units, references, count: count as u32, set }
    }

    /// How many candidates are there.
    pub(crate) fn count(&self) -> usize {
        self.count as usize
    }

    /// Their numbers, in order.
    pub(crate) fn numbers(&self) -> Vec<u32> {
        self.references[..self.count()].iter().map(Reference::number).collect()
    }
}

/// Puts the references of the candidates that are there into the first places.
fn fill(
    candidates: &impl Candidates,
    scale: f64,
    units: Units,
    references: &mut [Reference],
) -> Found {
    let fill = |(chunk, places): (usize, &mut [Reference])| {
        let mut found = Found { bounds: Aabb::EMPTY, set: Set::EMPTY, count: 0 };
        for k in 0..places.len() {
            let number = (chunk * CHUNK + k) as u32;
            let Some(bounds) = candidates.bounds(number) else { continue };
            found.bounds = found.bounds.union(bounds);
            let (min, max) = (bounds.min * scale, bounds.max * scale);
            let reference = Reference::new(
                [units.below(min.x), units.below(min.y), units.below(min.z)],
                [units.above(max.x), units.above(max.y), units.above(max.z)],
                number,
            );
            found.set = found.set.with(&reference);
            places[found.count] = reference;
            found.count += 1;
        }
        found
    };
    let chunks = references.par_chunks_mut(CHUNK).enumerate();
    let found: Vec<Found> = chunks.map(fill).collect();
    let mut all = Found { bounds: Aabb::EMPTY, set: Set::EMPTY, count: 0 };
    for (chunk, found) in found.into_iter().enumerate() {
        let first = chunk * CHUNK;
        if first > all.count {
            references.copy_within(first..first + found.count, all.count);
        }
        all.bounds = all.bounds.union(found.bounds);
        all.set = all.set.union(found.set);
        all.count += found.count;
    }
    all
}
