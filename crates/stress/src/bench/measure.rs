//! Measures the kernels of one family: how far off, how often wrong, how long.

use std::hint::black_box;
use std::time::Instant;

use rayon::prelude::*;

use super::Row;
use super::contest::{Entrant, entrants};
use super::family::Family;
use super::mesh::Mesh;
use crate::truth::{Truth, distance};
use crate::{Case, Random};

/// How much is measured.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Effort {
    /// Cases whose answers are judged; rays at seams of the mesh.
    pub judged: usize,
    /// Cases that are timed, over and over. 4,096 of them take at most 0.6 MB
    /// with any kernel: they stay in a second-level cache, as a real scene's
    /// would that is worth comparing kernels on.
    pub timed: usize,
    /// Times that each kernel has its turn.
    pub rounds: usize,
    /// The least time of a turn, in seconds.
    pub turn: f64,
}

impl Effort {
    /// About half a minute on two cores.
    pub const USUAL: Self = Self { judged: 1 << 17, timed: 1 << 12, rounds: 31, turn: 2.5e-3 };
}

/// One kernel's answers against the exact ones.
#[derive(Default)]
struct Judged {
    /// Relative errors of `t` where there is a hit and the kernel says so.
    errors: Vec<f64>,
    /// Cases whose answer is not left open.
    decided: usize,
    wrong: usize,
    rays: usize,
    leaks: usize,
}

impl Judged {
    fn add(&mut self, truth: &Truth, answer: Option<f64>) {
        if truth.tie {
            return;
        }
        self.decided += 1;
        match (truth.t, answer) {
            (Some(_), None) | (None, Some(_)) => self.wrong += 1,
            (Some(exact), Some(t)) => self.errors.push(distance(t, exact) / exact.0.abs()),
            (None, None) => {}
        }
    }

    fn ppm(count: usize, of: usize) -> f64 {
        /// Parts per million of a whole.
        const PPM: f64 = 1e6;
        if of == 0 { 0.0 } else { count as f64 * PPM / of as f64 }
    }
}

/// The value that this share of the sorted values does not exceed; NaN of none.
fn quantile(sorted: &[f64], share: f64) -> f64 {
    let rank = (sorted.len() as f64 * share).ceil() as usize;
    sorted.get(rank.saturating_sub(1)).copied().unwrap_or(f64::NAN)
}

/// The rows of a family's kernels, in the order of the contest.
pub(super) fn rows(family: &Family, effort: &Effort) -> Vec<Row> {
    let cases = family.cases(effort.judged.max(effort.timed));
    let truths: Vec<_> = cases.par_iter().map(|case| family.primitive.truth(case)).collect();
    let mut entrants = entrants(family.primitive);
    let mut judged: Vec<_> = entrants.iter().map(|_| Judged::default()).collect();
    for (entrant, judged) in entrants.iter().zip(&mut judged) {
        for (case, truth) in cases[..effort.judged].iter().zip(&truths) {
            judged.add(truth, entrant.answer(case));
        }
        judged.errors.sort_by(f64::total_cmp);
    }
    if family.is_at_seams() {
        count_leaks(&entrants, &mut judged, effort.judged);
    }
    let ns = time(&mut entrants, &cases[..effort.timed], effort);
    let row = |((entrant, judged), ns): ((&Entrant, &Judged), f64)| Row {
        primitive: family.primitive.name(),
        family: family.name,
        kernel: entrant.name,
        ns,
        error_p50: quantile(&judged.errors, 0.5),
        error_p999: quantile(&judged.errors, 0.999),
        error_max: quantile(&judged.errors, 1.0),
        misclassified_ppm: Judged::ppm(judged.wrong, judged.decided),
        leaks_ppm: Judged::ppm(judged.leaks, judged.rays),
        frontier: false,
    };
    entrants.iter().zip(&judged).zip(ns).map(row).collect()
}

/// Counts the rays from inside a closed mesh for which a kernel finds no hit
/// on any of its triangles.
fn count_leaks(entrants: &[Entrant], judged: &mut [Judged], rays: usize) {
    let mesh = Mesh::new();
    let mut random = Random::of_chunk(0, "bench/leaks", 0);
    for _ in 0..rays {
        let ray = mesh.aim(&mut random);
        let around: Vec<Case> = mesh.around(&ray).collect();
        for (entrant, judged) in entrants.iter().zip(&mut *judged) {
            let hit = |case: &Case| entrant.answer(case).is_some();
            judged.rays += 1;
            // The whole mesh only where those that should be hit are not.
            let leaks = !around.iter().any(hit) && !mesh.everywhere(&ray).any(|case| hit(&case));
            judged.leaks += usize::from(leaks);
        }
    }
}

/// Nanoseconds per case of each kernel. Each pass over the cases is timed by
/// itself: it is so short that other programs, which take the processor away
/// for longer, spoil few, and these are not the median of a turn. Kernels have
/// their turns in rounds, so that a slow spell meets all alike; the result is
/// the median of the turns. Cases do not wait for each other: this is
/// throughput on one thread, not latency.
fn time(entrants: &mut [Entrant], cases: &[Case], effort: &Effort) -> Vec<f64> {
    const NANOSECONDS: f64 = 1e9;
    /// So that a turn has a median also for the slowest kernel.
    const FEWEST_PASSES: usize = 5;
    let loaded: Vec<_> = entrants.iter_mut().map(|entrant| entrant.load(cases)).collect();
    let mut turns = vec![Vec::with_capacity(effort.rounds); entrants.len()];
    let mut passes = Vec::new();
    for round in 0..effort.rounds {
        for k in 0..entrants.len() {
            // Another one begins each round: none always follows the same.
            let k = (k + round) % entrants.len();
            // Not timed: brings the cases into the cache.
            black_box(entrants[k].pass());
            passes.clear();
            let begin = Instant::now();
            while passes.len() < FEWEST_PASSES || begin.elapsed().as_secs_f64() < effort.turn {
                let start = Instant::now();
                black_box(entrants[k].pass());
                passes.push(start.elapsed().as_secs_f64());
            }
            turns[k].push(median(&mut passes) * NANOSECONDS / loaded[k] as f64);
        }
    }
    turns.iter_mut().map(|turns| median(turns)).collect()
}

fn median(values: &mut [f64]) -> f64 {
    values.sort_by(f64::total_cmp);
    quantile(values, 0.5)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantiles_of_few_and_none() {
        let values = [1.0, 2.0, 3.0, 4.0];
        assert_eq!([0.0, 0.5, 0.51, 1.0].map(|s| quantile(&values, s)), [1.0, 2.0, 3.0, 4.0]);
        assert!(quantile(&[], 0.5).is_nan());
    }

    #[test]
    fn what_is_right_wrong_and_left_open() {
        let mut judged = Judged::default();
        let two = Truth::hit((2.0, 0.0), 2.0);
        judged.add(&two, Some(2.5));
        judged.add(&two, None);
        judged.add(&Truth::MISS, Some(2.0));
        judged.add(&Truth::MISS, None);
        judged.add(&Truth::TIE, None);
        judged.add(&Truth::TIE, Some(1.0));
        assert_eq!((judged.decided, judged.wrong), (4, 2));
        assert_eq!(judged.errors, [0.25]);
        assert_eq!(Judged::ppm(judged.wrong, judged.decided), 5e5);
    }
}
