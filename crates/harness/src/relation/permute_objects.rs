//! `PermuteObjects`: the order of objects does not matter.

use scene::format::{Object, Show};
use serde::{Deserialize, Serialize};

use super::{Alike, Broken, Problem, Relate, Today, objects, problem_if};
use crate::check::File;

/// The picture has the very same bits when the objects of every list are in the
/// reverse order. Of two surfaces at the very same distance the first is seen:
/// `edge_pixels` is for those that show such a tie.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PermuteObjects {
    /// How many pixels may differ.
    #[serde(default)]
    pub edge_pixels: u32,
}

impl PermuteObjects {
    /// The scene in the reverse order.
    pub(super) fn related(file: &File) -> File {
        let mut reversed = file.clone();
        reversed.objects = in_reverse(reversed.objects);
        reversed
    }
}

impl Relate for PermuteObjects {
    fn words(&self) -> String {
        "PermuteObjects()".to_owned()
    }

    fn alike(&self) -> Alike {
        Alike { edge_pixels: self.edge_pixels, ..Alike::BITS }
    }

    fn problems(&self, file: &File) -> Vec<Problem> {
        let is_list = |object: &&Object| match object {
            Object::Group { objects, .. } => objects.len() > 1,
            _ => false,
        };
        let has_list = file.objects.len() > 1 || objects::all(&file.objects).iter().any(is_list);
        let mut problems = problem_if(!has_list, "expected two objects in one list, found none");
        problems.extend(problem_if(
            file.show == Show::ObjectIds,
            "expected a picture that does not show numbers of objects, as these follow the order",
        ));
        problems
    }

    fn holds(&self, today: &Today<'_>) -> Result<(), Broken> {
        let found = today.fixture.render_related(&Self::related(&today.fixture.file))?;
        self.alike().compare(today.picture, &found)
    }
}

fn in_reverse(objects: Vec<Object>) -> Vec<Object> {
    let reverse = |object| match object {
        Object::Group { transform, objects, material } => {
            Object::Group { transform, objects: in_reverse(objects), material }
        }
        surface => surface,
    };
    objects.into_iter().rev().map(reverse).collect()
}
