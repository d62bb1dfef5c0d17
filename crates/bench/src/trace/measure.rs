//! One measurement: engines by turns over the same rays, each timed by its
//! thread's CPU time, and what they answered held against the exact answers.

use super::engine::Named;
use super::rays::{Query, RaySet};
use crate::measure::{Spread, thread_seconds};

/// A `t` that is farther from the exact one than this part of it is wrong.
const WRONG_PART: f64 = 1e-3;
const MILLION: f64 = 1e6;

/// What one engine did with one set.
#[derive(Debug, Clone)]
pub(crate) struct Measured {
    pub(crate) engine: &'static str,
    /// Millions of rays a second.
    pub(crate) mrays_s: Spread,
    pub(crate) wrong: usize,
}

/// Measures the engines on a set of at least one ray. In every repetition each
/// has a turn, and another one is the first; a repetition before the first
/// warms up and is not counted.
pub(crate) fn measure(
    engines: &mut [Named],
    set: &RaySet,
    reference: &[Option<f64>],
    reps: usize,
) -> Vec<Measured> {
    let count = engines.len();
    let mut speeds = vec![Vec::new(); count];
    let mut wrong = vec![0; count];
    for rep in 0..=reps {
        for turn in 0..count {
            let number = (turn + rep) % count;
            let engine = &mut engines[number].1;
            engine.load(set);
            let start = thread_seconds();
            engine.trace();
            let seconds = thread_seconds() - start;
            if rep == 0 {
                let found = count_wrong(&engine.answers(), reference, set.query);
                wrong[number] = found.total();
            } else {
                speeds[number].push(set.rays.len() as f64 / seconds / MILLION);
            }
        }
    }
    let measured = engines.iter().zip(speeds).zip(wrong).map(|((engine, speeds), wrong)| {
        Measured { engine: engine.0, mrays_s: Spread::of(&speeds), wrong }
    });
    measured.collect()
}

/// Answers that are another than the exact one.
#[derive(Debug, Default, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Wrong {
    /// A hit for a miss, or the other way round.
    pub(crate) hit_or_miss: usize,
    /// A hit at another `t`.
    pub(crate) elsewhere: usize,
}

impl Wrong {
    pub(crate) fn total(self) -> usize {
        self.hit_or_miss + self.elsewhere
    }
}

/// Counts the answers that are wrong; of a ray of which only was asked whether
/// it hits, `t` is none.
pub(crate) fn count_wrong(
    answers: &[Option<f64>],
    reference: &[Option<f64>],
    query: Query,
) -> Wrong {
    let mut wrong = Wrong::default();
    for pair in answers.iter().zip(reference) {
        match pair {
            (None, None) => {}
            (Some(t), Some(exact)) => {
                let is_near = (t - exact).abs() <= WRONG_PART * exact.abs();
                wrong.elsewhere += usize::from(query == Query::Closest && !is_near);
            }
            _ => wrong.hit_or_miss += 1,
        }
    }
    wrong
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_wrong_is_counted() {
        let wrong = |hit_or_miss, elsewhere| Wrong { hit_or_miss, elsewhere };
        let exact = [None, Some(2.0), Some(2.0), None, Some(2.0), Some(2.0)];
        let answers = [None, Some(2.001), Some(2.1), Some(1.0), None, Some(f64::NAN)];
        assert_eq!(count_wrong(&answers, &exact, Query::Closest), wrong(2, 2));
        assert_eq!(count_wrong(&answers, &exact, Query::Any), wrong(2, 0), "any hit may be any");
    }
}
