//! `apart`: work on a thread of its own.

use std::panic::resume_unwind;

/// What `work` gives, done on a thread of its own while this one waits.
///
/// A thread of a rayon pool that waits for another pool begins the next piece of
/// its own pool's work meanwhile, on top of this one, and so on until no stack is
/// left. Waiting for a plain thread it does not.
pub(crate) fn apart<T: Send>(work: impl FnOnce() -> T + Send) -> T {
    let done = std::thread::scope(|scope| scope.spawn(work).join());
    // What the work panicked with, if it did, is not this one's to swallow.
    done.unwrap_or_else(|panic| resume_unwind(panic))
}

#[cfg(test)]
mod tests {
    use rayon::prelude::*;

    use super::*;

    #[test]
    fn waiting_for_another_pool_takes_no_stack() {
        // So deep that frames of each piece on top of the others would not fit.
        let pieces: Vec<usize> = (0..4_000).collect();
        let outer = rayon::ThreadPoolBuilder::new().num_threads(2).build().unwrap();
        let sum: usize = outer.install(|| {
            let piece = |&i: &usize| {
                let inner = rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap();
                // What a picture takes at least.
                let room = std::hint::black_box([1_u8; 4_096]);
                apart(|| inner.install(|| i)) * usize::from(room[i % room.len()])
            };
            pieces.par_iter().map(piece).sum()
        });
        assert_eq!(sum, 4_000 * 3_999 / 2);
    }
}
