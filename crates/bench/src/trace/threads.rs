//! CPU time of each thread of this program, so that one that only waits for
//! another, busily, is not taken for one that works.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use crate::files;
use crate::measure::{process_seconds, thread_seconds};

/// Where Linux lists a program's threads, and in the folder of each the
/// nanoseconds that it has had the processor for.
const THREADS: &str = "/proc/self/task";
const TIMES: &str = "schedstat";
const NANO: f64 = 1e-9;

/// CPU seconds that some work took.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Taken {
    /// Of the thread that was busy longest: what the work takes on a machine
    /// with nothing else to do.
    pub(crate) busiest: f64,
    /// Of all threads together, those that wait busily with them.
    pub(crate) all: f64,
}

/// Does some work, of which the threads must not end before it returns.
pub(crate) fn taken<T>(work: impl FnOnce() -> T) -> (T, Taken) {
    let before = times();
    let (own, all) = (thread_seconds(), process_seconds());
    let done = work();
    let (own, all) = (thread_seconds() - own, process_seconds() - all);
    // The list lags behind for threads that run: for the one that asks, its own
    // clock is exact.
    let others = times().into_iter().map(|(thread, time)| {
        let start = before.get(&thread).copied().unwrap_or(0.0);
        time - start
    });
    (done, Taken { busiest: others.fold(own, f64::max).min(all), all })
}

/// The seconds of each thread.
fn times() -> BTreeMap<PathBuf, f64> {
    let time = |thread: PathBuf| {
        let text = String::from_utf8(files::read_kept(&thread.join(TIMES))?).ok()?;
        let nanoseconds: f64 = text.split_whitespace().next()?.parse().ok()?;
        Some((thread, nanoseconds * NANO))
    };
    files::entries(Path::new(THREADS)).into_iter().filter_map(time).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Works this long.
    const WORK: f64 = 60e-3;
    /// Threads' times are kept by the tick of the scheduler.
    const TICK: f64 = 10e-3;

    fn work(seconds: f64) {
        let start = thread_seconds();
        while thread_seconds() - start < seconds {
            std::hint::spin_loop();
        }
    }

    #[test]
    fn the_busiest_thread_is_found_wherever_it_runs() {
        let near = |found: f64, expected: f64| {
            assert!((found - expected).abs() < TICK, "{found}, expected {expected}");
        };
        let pool = rayon::ThreadPoolBuilder::new().num_threads(2).build().unwrap();
        let ((), here) = taken(|| work(WORK));
        near(here.busiest, WORK);
        let ((), there) = taken(|| pool.install(|| work(WORK)));
        near(there.busiest, WORK);
        let both = || pool.install(|| rayon::join(|| work(WORK), || work(WORK / 2.0)));
        let (_, both) = taken(both);
        assert!(both.all >= 1.5 * WORK, "{both:?}");
        assert!(both.busiest >= WORK - TICK && both.busiest <= both.all, "{both:?}");
    }
}
