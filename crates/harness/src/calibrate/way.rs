//! `Way`: one way of making a picture, none of which may change it.

use crate::apart::apart;
use rayon::{ThreadPool, ThreadPoolBuilder};
use tracer::Instructions;
use tracer::accel::Build;

/// The numbers of threads: one, the fewest that share work, and two that no row
/// count of a picture is likely to be a multiple of.
pub const THREADS: [usize; 4] = [1, 2, 3, 7];

/// A way of making a picture.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Way {
    /// On so many threads.
    pub threads: usize,
    /// With these instructions.
    pub instructions: Instructions,
    /// For the first time, 0, or once more.
    pub repeat: u32,
}

impl Way {
    /// How its scene is built.
    pub fn build(&self) -> Build {
        Build::With(self.instructions)
    }
}

/// All ways, and the threads for them.
#[derive(Debug)]
pub struct Ways {
    all: Vec<Way>,
    pools: Vec<ThreadPool>,
}

impl Ways {
    /// Every number of [`THREADS`] with all instructions that this processor and
    /// this build have, each `repeats` times, at least once.
    ///
    /// # Errors
    /// The system does not give so many threads.
    pub fn new(repeats: u32) -> Result<Self, String> {
        let pool = |threads| ThreadPoolBuilder::new().num_threads(threads).build();
        let pools = THREADS.into_iter().map(pool).collect::<Result<_, _>>();
        let levels = Instructions::all();
        let of_threads = |threads| {
            levels.iter().flat_map(move |&instructions| {
                (0..repeats.max(1)).map(move |repeat| Way { threads, instructions, repeat })
            })
        };
        Ok(Self {
            all: THREADS.into_iter().flat_map(of_threads).collect(),
            pools: pools.map_err(|error| format!("threads: {error}"))?,
        })
    }

    /// In a fixed order.
    pub fn all(&self) -> &[Way] {
        &self.all
    }

    /// Does the work on as many threads as this way has.
    pub fn install<T: Send>(&self, way: &Way, work: impl FnOnce() -> T + Send) -> T {
        let pool = self.pools.iter().find(|pool| pool.current_num_threads() == way.threads);
        match pool {
            Some(pool) => apart(|| pool.install(work)),
            None => work(),
        }
    }
}
