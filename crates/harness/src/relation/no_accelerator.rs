//! `NoAccelerator`: the accelerator does not matter.

use scene::format::Object;
use tracer::accel::Build;

use super::{Broken, Problem, Relate, Today, objects, problem_if};
use crate::check::File;

/// The picture has the very same bits when every ray is held against every
/// object and every triangle, one after the other.
pub(super) struct NoAccelerator;

impl Relate for NoAccelerator {
    fn words(&self) -> String {
        "NoAccelerator".to_owned()
    }

    fn problems(&self, file: &File) -> Vec<Problem> {
        let has_several = |object: &&Object| match object {
            Object::Group { objects, .. } => objects.len() > 1,
            Object::Mesh { .. } => true,
            _ => false,
        };
        let has_several =
            file.objects.len() > 1 || objects::all(&file.objects).iter().any(has_several);
        problem_if(!has_several, "expected a mesh or two objects in one list, found neither")
    }

    fn holds(&self, today: &Today<'_>) -> Result<(), Broken> {
        let found = today.fixture.render_related_by(&today.fixture.file, Build::List)?;
        self.alike().compare(today.picture, &found)
    }
}
