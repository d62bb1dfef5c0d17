//! `IdentityGroup`: an object in a group that does nothing to it looks the same.

use scene::format::Object;

use super::{Broken, Problem, Relate, Today, objects, problem_if};
use crate::check::File;

/// The picture has the very same bits when every surface is in a group of its
/// own, without steps.
pub(super) struct IdentityGroup;

impl IdentityGroup {
    /// The scene of groups.
    pub(super) fn related(file: &File) -> File {
        let mut nested = file.clone();
        nested.objects = objects::replaced(nested.objects, &|object| {
            vec![Object::Group { transform: Vec::new(), objects: vec![object], material: None }]
        });
        nested
    }
}

impl Relate for IdentityGroup {
    fn words(&self) -> String {
        "IdentityGroup".to_owned()
    }

    fn problems(&self, file: &File) -> Vec<Problem> {
        problem_if(file.objects.is_empty(), "expected an object, found none")
    }

    fn holds(&self, today: &Today<'_>) -> Result<(), Broken> {
        let found = today.fixture.render_related(&Self::related(&today.fixture.file))?;
        self.alike().compare(today.picture, &found)
    }
}
