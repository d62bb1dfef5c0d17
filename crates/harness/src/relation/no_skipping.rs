//! `NoSkipping`: what is skipped does not matter.

use tracer::Skipping;

use super::{Broken, Problem, Relate, Today, problem_if};
use crate::check::File;

/// The picture has the very same bits when every pixel sends its rays and every
/// hit is lit by every light, whatever comes of it.
pub(super) struct NoSkipping;

impl Relate for NoSkipping {
    fn words(&self) -> String {
        "NoSkipping".to_owned()
    }

    fn problems(&self, file: &File) -> Vec<Problem> {
        problem_if(file.objects.is_empty(), "expected an object, found none")
    }

    fn holds(&self, today: &Today<'_>) -> Result<(), Broken> {
        let plan = today.fixture.plan(Skipping::Off);
        let (found, _) = today.fixture.render_counted(&plan);
        self.alike().compare(today.picture, &found)
    }
}
