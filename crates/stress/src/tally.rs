//! `Tally`: counts, maxima and quantiles over the cases of one kernel, which
//! add up to the same whatever the order.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use crate::Metric;
use crate::metric::Sum;

/// A million.
const PPM: f64 = 1e6;

/// What one kernel did on the cases of one family.
#[derive(Debug, Clone, PartialEq)]
pub struct Tally {
    cases: u64,
    ties: u64,
    counts: Vec<u64>,
    most: Vec<f64>,
    spread: BTreeMap<Metric, Histogram>,
    /// The largest value that passes, for each metric; infinite for none.
    targets: Vec<f64>,
    offended: bool,
}

impl Tally {
    /// An empty tally. A kernel under contract notes cases that are beyond
    /// their target.
    pub fn new(targets: &[(Metric, Option<f64>)], contract: bool) -> Self {
        let mut all = vec![f64::INFINITY; Metric::ALL.len()];
        let mut spread = BTreeMap::new();
        for &(metric, target) in targets {
            if contract && matches!(metric.sum(), Sum::Count | Sum::Most) {
                all[metric.index()] = target.unwrap_or(f64::INFINITY);
            }
            if metric.sum() == Sum::P999 {
                spread.insert(metric, Histogram::new());
            }
        }
        let zero = vec![0; Metric::ALL.len()];
        let none = vec![0.0; Metric::ALL.len()];
        Self { cases: 0, ties: 0, counts: zero, most: none, spread, targets: all, offended: false }
    }

    /// One more case was judged.
    pub fn case(&mut self) {
        self.cases += 1;
    }

    /// One more case was judged, and is too close to call: any answer is right.
    pub fn tie(&mut self) {
        self.cases += 1;
        self.ties += 1;
    }

    /// One more case shows this; for metrics that are counted.
    pub fn count(&mut self, metric: Metric) {
        self.counts[metric.index()] += 1;
        // A count is beyond a target of none with its first case.
        self.offended |= self.targets[metric.index()] < 1.0;
    }

    /// A case showed this value; for metrics with a largest value. NaN counts
    /// as infinite.
    pub fn most(&mut self, metric: Metric, value: f64) {
        let value = if value.is_nan() { f64::INFINITY } else { value };
        let most = &mut self.most[metric.index()];
        *most = most.max(value);
        self.offended |= value > self.targets[metric.index()];
    }

    /// A case showed this value; for metrics with a quantile. It is left out
    /// where the family does not ask for it.
    pub fn spread(&mut self, metric: Metric, value: f64) {
        if let Some(histogram) = self.spread.get_mut(&metric) {
            histogram.add(value);
        }
    }

    /// Whether a case was beyond a target since this was last asked.
    pub fn take_offense(&mut self) -> bool {
        std::mem::take(&mut self.offended)
    }

    /// Up to `cases`, those that were not judged count as ties.
    pub fn fill_up(&mut self, cases: u64) {
        let missing = cases.saturating_sub(self.cases);
        self.cases += missing;
        self.ties += missing;
    }

    /// How many cases were judged, ties included.
    pub fn cases(&self) -> u64 {
        self.cases
    }

    /// How many of them were too close to call.
    pub fn ties(&self) -> u64 {
        self.ties
    }

    /// The metric's value over all cases.
    pub fn value(&self, metric: Metric) -> f64 {
        match metric.sum() {
            Sum::Count => self.counts[metric.index()] as f64,
            Sum::Most => self.most[metric.index()],
            Sum::Ppm => PPM * self.ties as f64 / self.cases.max(1) as f64,
            Sum::P999 => self.spread.get(&metric).map_or(0.0, |h| h.quantile(0.999)),
        }
    }

    /// Adds what another tally of the same family has.
    pub fn add(&mut self, other: &Self) {
        self.cases += other.cases;
        self.ties += other.ties;
        for (mine, theirs) in self.counts.iter_mut().zip(&other.counts) {
            *mine += theirs;
        }
        for (mine, theirs) in self.most.iter_mut().zip(&other.most) {
            *mine = mine.max(*theirs);
        }
        for (metric, theirs) in &other.spread {
            self.spread.entry(*metric).or_insert_with(Histogram::new).merge(theirs.filled());
        }
    }

    /// The tally in a form that can be stored.
    pub fn to_stored(&self) -> Stored {
        let named = |metric: &Metric| metric.name().to_owned();
        let of = |sum: Sum| Metric::ALL.iter().filter(move |m| m.sum() == sum);
        Stored {
            cases: self.cases,
            ties: self.ties,
            counts: of(Sum::Count).map(|m| (named(m), self.counts[m.index()])).collect(),
            // As bits: a text of an infinity is not a number everywhere.
            most: of(Sum::Most).map(|m| (named(m), self.most[m.index()].to_bits())).collect(),
            spread: self.spread.iter().map(|(m, h)| (named(m), h.filled().collect())).collect(),
        }
    }

    /// Adds what was stored; names that are unknown are left out.
    pub fn add_stored(&mut self, stored: &Stored) {
        self.cases += stored.cases;
        self.ties += stored.ties;
        for (name, count) in &stored.counts {
            if let Some(metric) = Metric::of_name(name) {
                self.counts[metric.index()] += count;
            }
        }
        for (name, bits) in &stored.most {
            if let Some(metric) = Metric::of_name(name) {
                let most = &mut self.most[metric.index()];
                *most = most.max(f64::from_bits(*bits));
            }
        }
        for (name, bins) in &stored.spread {
            if let Some(metric) = Metric::of_name(name) {
                let mine = self.spread.entry(metric).or_insert_with(Histogram::new);
                mine.merge(bins.iter().map(|(&bin, &count)| (bin, count)));
            }
        }
    }
}

/// Whether a case was beyond a target of any of them since this was last asked.
pub fn take_offense(tallies: &mut [Tally]) -> bool {
    // Every one is asked, so that none remembers.
    tallies.iter_mut().filter_map(|tally| tally.take_offense().then_some(())).count() > 0
}

/// A tally as it is stored between runs.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Stored {
    cases: u64,
    ties: u64,
    counts: BTreeMap<String, u64>,
    most: BTreeMap<String, u64>,
    spread: BTreeMap<String, BTreeMap<usize, u64>>,
}

/// How many values fell into each eighth of an octave, from 2^-31 to 2^64.
#[derive(Debug, Clone, PartialEq)]
struct Histogram {
    bins: Vec<u64>,
}

/// The bits of an `f64` below its exponent and the first three of its
/// mantissa: what is left by shifting is a bin of an eighth of an octave.
const BELOW_BIN: u32 = 49;
/// The bin of 2^-31, into which smaller values fall as well.
const LOWEST: u64 = 0x3e0 << 3;
/// One more than the last bin, that of 2^64 and above.
const BINS: usize = 95 * 8 + 1;

impl Histogram {
    fn new() -> Self {
        Self { bins: vec![0; BINS] }
    }

    fn add(&mut self, value: f64) {
        let value = if value.is_nan() { f64::INFINITY } else { value.max(0.0) };
        let bin = (value.to_bits() >> BELOW_BIN).saturating_sub(LOWEST) as usize;
        self.bins[bin.min(BINS - 1)] += 1;
    }

    fn merge(&mut self, other: impl Iterator<Item = (usize, u64)>) {
        for (bin, count) in other {
            if let Some(mine) = self.bins.get_mut(bin) {
                *mine += count;
            }
        }
    }

    fn filled(&self) -> impl Iterator<Item = (usize, u64)> + '_ {
        self.bins.iter().copied().enumerate().filter(|(_, count)| *count > 0)
    }

    /// The upper end of the bin in which this share of the values is reached.
    fn quantile(&self, share: f64) -> f64 {
        let total: u64 = self.bins.iter().sum();
        let wanted = (total as f64 * share).ceil() as u64;
        let mut seen = 0;
        for (bin, count) in self.filled() {
            seen += count;
            if seen >= wanted {
                return match bin {
                    0 => 0.0,
                    bin if bin == BINS - 1 => f64::INFINITY,
                    bin => f64::from_bits((LOWEST + bin as u64 + 1) << BELOW_BIN),
                };
            }
        }
        0.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn tally() -> Tally {
        let targets =
            [(Metric::Leaks, Some(0.0)), (Metric::Ulp64, Some(2.0)), (Metric::Ulp64Usual, None)];
        Tally::new(&targets, true)
    }

    #[test]
    fn a_case_beyond_its_target_is_noticed_once() {
        let mut t = tally();
        t.most(Metric::Ulp64, 2.0);
        assert!(!t.take_offense());
        t.most(Metric::Ulp64, 2.5);
        assert!(t.take_offense() && !t.take_offense());
        t.count(Metric::Leaks);
        assert!(t.take_offense());
        t.most(Metric::Ulp64, f64::NAN);
        assert!(t.take_offense() && t.value(Metric::Ulp64) == f64::INFINITY);
        let mut shown = Tally::new(&[(Metric::Leaks, Some(0.0))], false);
        shown.count(Metric::Leaks);
        assert!(!shown.take_offense() && shown.value(Metric::Leaks) == 1.0);
    }

    #[test]
    fn storing_and_adding_lose_nothing() {
        let (mut one, mut two, mut all) = (tally(), tally(), tally());
        for (k, part) in [&mut one, &mut two].into_iter().enumerate() {
            for i in 0..1000 {
                let value = f64::from(i) * 0.25 + k as f64;
                for t in [&mut *part, &mut all] {
                    t.case();
                    t.most(Metric::Ulp64, value);
                    t.spread(Metric::Ulp64Usual, value);
                }
            }
        }
        two.tie();
        all.tie();
        let mut sum = tally();
        sum.add(&one);
        sum.add_stored(&two.to_stored());
        all.take_offense();
        assert_eq!(sum, all);
        assert_eq!((sum.cases(), sum.ties()), (2001, 1));
        assert_eq!(sum.value(Metric::Ulp64), 250.75);
        // 99.9 % of 2,000 values, to within an eighth of an octave.
        let usual = sum.value(Metric::Ulp64Usual);
        assert!((249.75..=249.75 * 1.125).contains(&usual), "{usual}");
    }
}
