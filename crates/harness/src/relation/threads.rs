//! `Threads`: the number of threads does not matter.

use rayon::ThreadPoolBuilder;

use super::{Broken, Problem, Relate, Today, problem_if};
use crate::apart::apart;
use crate::check::File;

/// The picture has the very same bits when it is made on one, two, three and
/// seven threads.
pub(super) struct Threads;

/// Alone, evenly shared and unevenly shared.
const THREADS: [usize; 4] = [1, 2, 3, 7];

impl Relate for Threads {
    fn words(&self) -> String {
        "Threads".to_owned()
    }

    fn problems(&self, file: &File) -> Vec<Problem> {
        problem_if(file.image.1 < 2, "expected two rows of pixels or more to share, found one")
    }

    fn holds(&self, today: &Today<'_>) -> Result<(), Broken> {
        for threads in THREADS {
            let pool = ThreadPoolBuilder::new().num_threads(threads).build();
            let pool = pool.map_err(|why| format!("there are no {threads} threads: {why}"))?;
            let found = apart(|| pool.install(|| today.fixture.render_linear()));
            let same = self.alike().compare(today.picture, &found);
            same.map_err(|broken| broken.map(|why| format!("{why}, on threads: {threads}")))?;
        }
        Ok(())
    }
}
