//! The time that a thread, or all of the process, has spent computing.
#![allow(unsafe_code)]

/// Nanoseconds are this part of a second.
const NANO: f64 = 1e-9;

/// CPU seconds of the calling thread, from some moment on.
pub(crate) fn thread_seconds() -> f64 {
    seconds(libc::CLOCK_THREAD_CPUTIME_ID)
}

/// CPU seconds of all threads of the process together, from some moment on.
pub(crate) fn process_seconds() -> f64 {
    seconds(libc::CLOCK_PROCESS_CPUTIME_ID)
}

fn seconds(clock: libc::clockid_t) -> f64 {
    let mut time = libc::timespec { tv_sec: 0, tv_nsec: 0 };
    // SAFETY: `time` is a `timespec` that lives until the call returns, and the
    // call writes nothing else.
    let status = unsafe { libc::clock_gettime(clock, &raw mut time) };
    debug_assert_eq!(status, 0, "these clocks are always there");
    time.tv_sec as f64 + time.tv_nsec as f64 * NANO
}

#[cfg(test)]
mod tests {
    use super::*;

    fn work(until: f64) {
        let start = thread_seconds();
        let mut x = 1.0_f64;
        while thread_seconds() - start < until {
            x = std::hint::black_box(x.sqrt() + 1.0);
        }
    }

    #[test]
    fn a_thread_s_clock_counts_its_own_work_only() {
        let (own, all) = (thread_seconds(), process_seconds());
        std::thread::scope(|scope| {
            scope.spawn(|| work(20e-3));
        });
        assert!(process_seconds() - all >= 20e-3);
        assert!(thread_seconds() - own < 10e-3);
    }
}
