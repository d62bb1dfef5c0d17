//! `Matrix`: the stress suite's families, run chunk by chunk on all threads,
//! stopped and taken up again anywhere with the same result.

use std::collections::BTreeMap;

use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use crate::family::Family;
use crate::kept::Kept;
use crate::tally::{self, Stored, Tally};
use crate::{Case, Random};

/// Cases to a chunk: each has random numbers of its own.
const CHUNK: u64 = 1 << 14;

/// Chunks run between two looks at the outside world.
const WAVE: usize = 64;

/// The most failing cases kept of one family.
const KEPT: usize = 16;

/// Which run it is: two runs with the same are the same.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Plan {
    /// Whether to run the large number of cases.
    pub full: bool,
    /// What the random numbers start from.
    pub seed: u64,
    /// The program that runs, so that no run is taken up by another one.
    pub program: String,
}

/// A run that may be half done.
pub struct Matrix<'a> {
    families: &'a [Family],
    plan: Plan,
    progress: Vec<Progress>,
    /// What another choice of families left in the stored run.
    others: BTreeMap<String, StoredProgress>,
}

/// How far one family is.
struct Progress {
    chunks: u64,
    tallies: Vec<Tally>,
    offenders: Vec<Case>,
}

/// A half-done run, as it is stored.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct StoredMatrix {
    plan: Plan,
    families: BTreeMap<String, StoredProgress>,
}

#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
struct StoredProgress {
    chunks: u64,
    tallies: Vec<Stored>,
    /// The failing cases' numbers, as bits.
    offenders: Vec<Vec<u64>>,
}

impl<'a> Matrix<'a> {
    /// A run of which nothing is done.
    pub fn new(families: &'a [Family], plan: Plan) -> Self {
        let start = |family: &Family| Progress {
            chunks: 0,
            tallies: family.tallies(),
            offenders: Vec::new(),
        };
        Self {
            progress: families.iter().map(start).collect(),
            families,
            plan,
            others: BTreeMap::new(),
        }
    }

    /// Takes up a stored run; false, and nothing happens, if it was another.
    /// What it has of families that are not in this one is kept for later.
    pub fn resume(&mut self, stored: &StoredMatrix) -> bool {
        if stored.plan != self.plan {
            return false;
        }
        self.others = stored.families.clone();
        for (family, progress) in self.families.iter().zip(&mut self.progress) {
            let Some(done) = stored.families.get(&family.label()) else { continue };
            progress.chunks = done.chunks;
            for (tally, stored) in progress.tallies.iter_mut().zip(&done.tallies) {
                tally.add_stored(stored);
            }
            let numbers = |bits: &Vec<u64>| -> Vec<f64> {
                bits.iter().map(|&bits| f64::from_bits(bits)).collect()
            };
            progress.offenders =
                done.offenders.iter().filter_map(|bits| Case::of(&numbers(bits))).collect();
        }
        true
    }

    /// The run as it stands, to be stored.
    pub fn to_stored(&self) -> StoredMatrix {
        let bits = |case: &Case| case.numbers().iter().map(|x| x.to_bits()).collect();
        let one = |(family, progress): (&Family, &Progress)| {
            let stored = StoredProgress {
                chunks: progress.chunks,
                tallies: progress.tallies.iter().map(Tally::to_stored).collect(),
                offenders: progress.offenders.iter().map(bits).collect(),
            };
            (family.label(), stored)
        };
        let mut families = self.others.clone();
        families.extend(self.families.iter().zip(&self.progress).map(one));
        StoredMatrix { plan: self.plan.clone(), families }
    }

    /// How many cases the whole run has.
    pub fn total(&self) -> u64 {
        self.families.iter().map(|family| self.volume(family)).sum()
    }

    /// How many cases are done.
    pub fn done(&self) -> u64 {
        let cases = |(family, p): (&Family, &Progress)| (p.chunks * CHUNK).min(self.volume(family));
        self.families.iter().zip(&self.progress).map(cases).sum()
    }

    /// Runs on for a while. Returns the label of the family that it is at;
    /// `None` when all is done.
    pub fn advance(&mut self) -> Option<String> {
        let mut wave = Vec::with_capacity(WAVE);
        for (i, (family, progress)) in self.families.iter().zip(&self.progress).enumerate() {
            let chunks = self.volume(family).div_ceil(CHUNK);
            let room = WAVE - wave.len();
            wave.extend((progress.chunks..chunks).take(room).map(|chunk| (i, chunk)));
        }
        let (last, _) = *wave.last()?;
        let run = |&(i, chunk): &(usize, u64)| (i, self.chunk(&self.families[i], chunk));
        let results: Vec<_> = wave.par_iter().map(run).collect();
        // In the order of the chunks, whoever was done first.
        for (i, (tallies, offenders)) in results {
            let progress = &mut self.progress[i];
            progress.chunks += 1;
            for (all, one) in progress.tallies.iter_mut().zip(&tallies) {
                all.add(one);
            }
            let room = KEPT - progress.offenders.len().min(KEPT);
            progress.offenders.extend(offenders.into_iter().take(room));
        }
        Some(self.families[last].label())
    }

    /// Each family with the tallies of its kernels.
    pub fn results(&self) -> impl Iterator<Item = (&'a Family, &[Tally])> {
        self.families.iter().zip(&self.progress).map(|(f, p)| (f, &*p.tallies))
    }

    /// The cases on which a kernel under contract failed, up to 16 a family.
    pub fn offenders(&self) -> Vec<Kept> {
        let of = |(family, progress): (&Family, &Progress)| -> Vec<_> {
            let kept = |case: &Case| Kept { family: family.label(), case: *case };
            progress.offenders.iter().map(kept).collect()
        };
        self.families.iter().zip(&self.progress).flat_map(of).collect()
    }

    fn volume(&self, family: &Family) -> u64 {
        if self.plan.full { family.volume.full } else { family.volume.quick }
    }

    fn chunk(&self, family: &Family, chunk: u64) -> (Vec<Tally>, Vec<Case>) {
        let mut random = Random::of_chunk(self.plan.seed, &family.label(), chunk);
        let mut tallies = family.tallies();
        let mut offenders = Vec::new();
        let cases = CHUNK.min(self.volume(family).saturating_sub(chunk * CHUNK));
        for _ in 0..cases {
            let case = (family.generate)(&mut random);
            (family.judge)(&case, &mut tallies);
            if tally::take_offense(&mut tallies) && offenders.len() < KEPT {
                offenders.push(case);
            }
        }
        for (kernel, tally) in family.kernels.iter().zip(&mut tallies) {
            if kernel.contract {
                tally.fill_up(cases);
            }
        }
        (tallies, offenders)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Kernel, Metric, Volume};

    /// Counts numbers below one in a thousand as leaks.
    fn families(quick: u64) -> Vec<Family> {
        let family = |name: &str| Family {
            primitive: "coin",
            name: name.to_owned(),
            kernels: vec![Kernel::GOLDRAY, Kernel::textbook("other")],
            targets: vec![(Metric::Leaks, Some(0.0)), (Metric::Ulp64, None)],
            volume: Volume { quick, full: 3 * quick },
            generate: Box::new(|random| Case::EMPTY.with(random.unit())),
            judge: Box::new(|case, tallies| {
                for tally in tallies {
                    tally.case();
                    tally.most(Metric::Ulp64, case.number(0));
                    if case.number(0) < 1e-3 {
                        tally.count(Metric::Leaks);
                    }
                }
            }),
        };
        vec![family("one"), family("two")]
    }

    fn plan(full: bool) -> Plan {
        Plan { full, seed: 1, program: "this".to_owned() }
    }

    fn finish(matrix: &mut Matrix<'_>) {
        while matrix.advance().is_some() {}
    }

    #[test]
    fn every_case_is_run_once_and_failing_ones_are_kept() {
        let families = families(40_000);
        let mut matrix = Matrix::new(&families, plan(false));
        assert_eq!((matrix.total(), matrix.done()), (80_000, 0));
        finish(&mut matrix);
        assert_eq!(matrix.done(), 80_000);
        for (_, tallies) in matrix.results() {
            assert_eq!(tallies[0].cases(), 40_000);
            let leaks = tallies[0].value(Metric::Leaks);
            assert!((15.0..80.0).contains(&leaks), "{leaks}");
        }
        let offenders = matrix.offenders();
        assert_eq!(offenders.len(), 2 * KEPT);
        for kept in &offenders {
            let family = families.iter().find(|f| f.label() == kept.family).unwrap();
            assert!(family.offends(&kept.case));
        }
        let harmless = Case::EMPTY.with(0.5);
        assert!(!families[0].offends(&harmless));
    }

    #[test]
    fn a_stopped_run_ends_as_one_that_was_not() {
        let families = families(1_000_000);
        let mut whole = Matrix::new(&families, plan(true));
        finish(&mut whole);
        let mut first = Matrix::new(&families, plan(true));
        first.advance();
        first.advance();
        let stored = first.to_stored();
        let mut second = Matrix::new(&families, plan(true));
        assert!(second.resume(&stored));
        assert_eq!(second.done(), first.done());
        assert!(0 < second.done() && second.done() < second.total());
        finish(&mut second);
        assert_eq!(second.to_stored(), whole.to_stored());
        for other in [plan(false), Plan { seed: 2, ..plan(true) }] {
            assert!(!Matrix::new(&families, other).resume(&stored));
        }
    }

    #[test]
    fn families_run_one_by_one_end_as_all_together() {
        let families = families(20_000);
        let mut all = Matrix::new(&families, plan(true));
        finish(&mut all);
        let mut one = Matrix::new(&families[..1], plan(true));
        finish(&mut one);
        let mut other = Matrix::new(&families[1..], plan(true));
        assert!(other.resume(&one.to_stored()));
        finish(&mut other);
        assert_eq!(other.to_stored(), all.to_stored());
    }

    #[test]
    fn the_number_of_threads_does_not_matter() {
        let families = families(100_000);
        let run = |threads| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            let mut matrix = Matrix::new(&families, plan(false));
            pool.install(|| finish(&mut matrix));
            matrix.to_stored()
        };
        assert_eq!(run(1), run(3));
    }
}
