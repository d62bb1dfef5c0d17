//! `Tally`: what came of some fixtures, counted.

use std::collections::BTreeMap;

use crate::{FixtureResult, Outcome, outcome};

/// What came of some fixtures with one renderer.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Tally {
    /// How many ended so; what did not occur is left out.
    pub outcomes: BTreeMap<Outcome, u64>,
    /// The interior pixel that is farthest off.
    pub worst: Option<Worst>,
    /// Pixels that were compared.
    pub pixels: u64,
    /// Interior pixels beyond the tolerance.
    pub interior_off: u64,
    /// Edge pixels that were compared.
    pub edge_pixels: u64,
    /// Those beyond the tolerance.
    pub edge_off: u64,
}

/// The interior pixel that is farthest off.
#[derive(Debug, Clone, PartialEq)]
pub struct Worst {
    /// Its error, relative.
    pub error: f64,
    /// In which fixture.
    pub fixture: String,
    /// Column and row, from the top left.
    pub at: Option<(u32, u32)>,
}

impl Tally {
    /// Counts these results, each with its fixture's name.
    pub fn of<'a>(results: impl Iterator<Item = (&'a str, &'a FixtureResult)>) -> Self {
        let mut tally = Self::default();
        for (name, result) in results {
            tally.add(name, result);
        }
        tally
    }

    fn add(&mut self, name: &str, result: &FixtureResult) {
        *self.outcomes.entry(result.outcome).or_default() += 1;
        let Some(numbers) = &result.numbers else { return };
        self.pixels += numbers.pixels;
        self.interior_off += numbers.interior_off;
        self.edge_pixels += numbers.edge_pixels;
        self.edge_off += numbers.edge_off;
        let error = numbers.worst_interior;
        // A NaN is worse than any number, the first of equals stays.
        let is_worse =
            |worst: &Worst| error > worst.error || error.is_nan() && !worst.error.is_nan();
        if self.worst.as_ref().is_none_or(is_worse) {
            let at = numbers.worst_at;
            self.worst = Some(Worst { error, fixture: name.to_owned(), at });
        }
    }

    /// How many ended so.
    pub fn count(&self, outcome: Outcome) -> u64 {
        self.outcomes.get(&outcome).copied().unwrap_or(0)
    }

    /// How many there are.
    pub fn total(&self) -> u64 {
        self.outcomes.values().sum()
    }

    /// How many passed.
    pub fn passed(&self) -> u64 {
        self.count(Outcome::Pass)
    }

    /// How many were asked for and did not come right.
    pub fn failed(&self) -> u64 {
        let failures = self.outcomes.iter().filter(|(outcome, _)| outcome::is_failure(**outcome));
        failures.map(|(_, count)| count).sum()
    }

    /// Every outcome that occurred but a pass, in words: "2 fail, 1 crashed".
    pub fn rest_words(&self) -> String {
        let rest = outcome::ALL.into_iter().filter(|o| *o != Outcome::Pass && self.count(*o) > 0);
        let words = rest.map(|o| format!("{} {}", self.count(o), outcome::words(o)));
        words.collect::<Vec<_>>().join(", ")
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::trial::result;

    #[track_caller]
    fn worst(errors: &[f64], expected: &str) {
        let results: Vec<_> = errors.iter().map(|&error| result(Outcome::Fail, error)).collect();
        let names: Vec<_> = (0..errors.len()).map(|i| i.to_string()).collect();
        let tally = Tally::of(names.iter().map(String::as_str).zip(&results));
        assert_eq!(tally.worst.map(|worst| worst.fixture).as_deref(), Some(expected), "{errors:?}");
    }

    #[test]
    fn the_worst_pixel_is_the_farthest_off() {
        worst(&[f64::NAN, f64::INFINITY], "0");
        worst(&[f64::INFINITY, f64::NAN, f64::NAN], "1");
        worst(&[0.0, 0.0], "0");
        worst(&[1e-6, 1e-5, 1e-7], "1");
        worst(&[1.0, f64::INFINITY], "1");
    }

    #[test]
    fn outcomes_are_counted_and_told() {
        let mut crashed = result(Outcome::Crashed, 0.0);
        crashed.numbers = None;
        let all = [result(Outcome::Pass, 0.0), result(Outcome::Fail, 1.0), crashed];
        let tally = Tally::of(["a", "b", "c"].into_iter().zip(&all));
        assert_eq!((tally.total(), tally.passed(), tally.failed()), (3, 1, 2));
        assert_eq!(tally.rest_words(), "1 fail, 1 crashed");
        assert_eq!(tally.pixels, 200, "of two pictures");
        assert_eq!(Tally::default().rest_words(), "");
        assert_eq!(Tally::default().worst, None);
    }
}
