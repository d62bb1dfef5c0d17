//! The time that this thread has spent computing.

/// CPU seconds of this thread, from some moment on.
pub(crate) fn thread_seconds() -> f64 {
    /// Nanoseconds are this part of a second.
    const NANO: f64 = 1e-9;
    let mut time = libc::timespec { tv_sec: 0, tv_nsec: 0 };
    // SAFETY: `time` is a `timespec` that lives until the call returns, and the
    // call writes nothing else.
    let status = unsafe { libc::clock_gettime(libc::CLOCK_THREAD_CPUTIME_ID, &raw mut time) };
    debug_assert_eq!(status, 0, "the clock of the own thread is always there");
    time.tv_sec as f64 + time.tv_nsec as f64 * NANO
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_clock_goes_while_computing() {
        let start = thread_seconds();
        let mut x = 1.0_f64;
        while thread_seconds() - start < 1e-3 {
            x = std::hint::black_box(x.sqrt() + 1.0);
        }
        let rest = thread_seconds();
        std::thread::sleep(std::time::Duration::from_millis(30));
        assert!(thread_seconds() - rest < 0.02, "sleeping is not computing");
    }
}
