//! Times of contestants in turns: the processor's clock of one thread, medians
//! and spread.

use std::hint::black_box;
use std::time::Instant;

use rustix::time::{ClockId, clock_gettime};
use serde::{Deserialize, Serialize};

/// Nanoseconds of a second.
const NANOSECONDS: f64 = 1e9;

/// Seconds that this thread has had the processor for. Other programs do not
/// move it, but for what they leave in the caches.
pub(crate) fn thread_seconds() -> f64 {
    seconds(ClockId::ThreadCPUTime)
}

/// Seconds that all threads of this program have had the processor for,
/// together.
pub(crate) fn process_seconds() -> f64 {
    seconds(ClockId::ProcessCPUTime)
}

fn seconds(clock: ClockId) -> f64 {
    let time = clock_gettime(clock);
    time.tv_sec as f64 + time.tv_nsec as f64 / NANOSECONDS
}

/// A value from several turns: the median, and between which the turns were.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub(crate) struct Spread {
    /// The middle turn.
    pub(crate) median: f64,
    /// The lowest.
    pub(crate) low: f64,
    /// The highest.
    pub(crate) high: f64,
}

impl Spread {
    /// Of these values; of none, NaN.
    pub(crate) fn of(values: &[f64]) -> Self {
        let mut sorted = values.to_vec();
        sorted.sort_by(f64::total_cmp);
        let at = |index: usize| sorted.get(index).copied().unwrap_or(f64::NAN);
        let last = sorted.len().saturating_sub(1);
        let median = f64::midpoint(at(last / 2), at(sorted.len() / 2));
        Self { median, low: at(0), high: at(last) }
    }

    /// Each multiplied by this.
    pub(crate) fn times(self, factor: f64) -> Self {
        Self { median: self.median * factor, low: self.low * factor, high: self.high * factor }
    }

    /// What this much takes, as how much a second is done.
    pub(crate) fn rate(self, amount: f64) -> Self {
        Self { median: amount / self.median, low: amount / self.high, high: amount / self.low }
    }
}

/// Something that is timed, over and over; it returns a number that depends on
/// all its work.
pub(crate) type Pass<'a> = Box<dyn FnMut() -> f64 + 'a>;

/// How much is measured.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Effort {
    /// Turns of each contestant.
    pub(crate) rounds: usize,
    /// The least time of a turn, in seconds: enough passes to be far above
    /// what reading the clock takes.
    pub(crate) turn: f64,
}

/// Seconds of a pass of each contestant, on this thread. All have a turn in
/// each round, so that a slow spell meets all alike, and each round begins with
/// another one, so that none always follows the same.
pub(crate) fn in_turns(contestants: &mut [Pass<'_>], effort: Effort) -> Vec<Spread> {
    let mut turns = vec![Vec::with_capacity(effort.rounds); contestants.len()];
    for round in 0..effort.rounds {
        for k in 0..contestants.len() {
            let k = (k + round) % contestants.len();
            // Not timed: brings its data into the cache.
            black_box(contestants[k]());
            turns[k].push(turn(&mut contestants[k], effort.turn));
        }
    }
    turns.iter().map(|turns| Spread::of(turns)).collect()
}

/// Seconds of a pass, from as many as take the least time together.
fn turn(pass: &mut Pass<'_>, least: f64) -> f64 {
    let mut passes = 0_u32;
    let begin = thread_seconds();
    loop {
        black_box(pass());
        passes += 1;
        let taken = thread_seconds() - begin;
        if taken >= least {
            return taken / f64::from(passes);
        }
    }
}

/// Seconds of the wall's clock and of the processor's, on all threads, that
/// something takes.
pub(crate) fn wall_and_processor<T>(work: impl FnOnce() -> T) -> (T, f64, f64) {
    let (wall, processor) = (Instant::now(), process_seconds());
    let done = work();
    (done, wall.elapsed().as_secs_f64(), process_seconds() - processor)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn medians_of_few_and_none() {
        let spread = |values: &[f64]| Spread::of(values);
        assert_eq!(spread(&[3.0, 1.0, 2.0]), Spread { median: 2.0, low: 1.0, high: 3.0 });
        assert_eq!(spread(&[4.0, 1.0]), Spread { median: 2.5, low: 1.0, high: 4.0 });
        assert!(spread(&[]).median.is_nan());
        let rate = spread(&[1.0, 2.0, 4.0]).rate(8.0);
        assert_eq!(rate, Spread { median: 4.0, low: 2.0, high: 8.0 });
    }

    #[test]
    fn twice_the_work_takes_longer_and_every_contestant_is_timed() {
        let work = |count: u64| -> Pass<'static> {
            Box::new(move || (0..black_box(count)).map(|k| (k as f64).sqrt()).sum())
        };
        let effort = Effort { rounds: 5, turn: 2e-3 };
        let found = in_turns(&mut [work(1_000), work(8_000)], effort);
        assert_eq!(found.len(), 2);
        assert!(found[0].median > 0.0 && found[0].median * 3.0 < found[1].median, "{found:?}");
        let begin = process_seconds();
        black_box(work(1_000_000)());
        assert!(process_seconds() > begin);
    }
}
