//! `SplitBoxes`: a box looks like its twelve triangles.

use scene::format::{Object, Show, Triple};
use serde::{Deserialize, Serialize};

use super::alike::few_roundings;
use super::{Alike, Broken, Problem, Relate, Today, objects, problem_if, problem_of_error};
use crate::check::File;

/// The picture stays when every box is replaced by the twelve triangles of its
/// faces. One without thickness stays, as it has faces of no area.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SplitBoxes {
    /// How far each channel may be off, relative to the brightest of the
    /// picture.
    #[serde(default = "few_roundings")]
    pub within: f64,
    /// How many pixels may be off by more.
    #[serde(default)]
    pub edge_pixels: u32,
}

impl SplitBoxes {
    /// The scene without boxes.
    pub(super) fn related(file: &File) -> File {
        let mut split = file.clone();
        split.objects = objects::replaced(split.objects, &|object| match object {
            Object::Box { min, max, material } if is_thick(min, max) => {
                let triangle = |[a, b, c]: [Triple; 3]| {
                    let material = material.clone();
                    Object::Triangle { a, b, c, material }
                };
                triangles(min, max).into_iter().map(triangle).collect()
            }
            other => vec![other],
        });
        split
    }
}

impl Relate for SplitBoxes {
    fn words(&self) -> String {
        "SplitBoxes()".to_owned()
    }

    fn alike(&self) -> Alike {
        Alike { within: self.within, edge_pixels: self.edge_pixels }
    }

    fn problems(&self, file: &File) -> Vec<Problem> {
        let splits = |object: &&Object| match **object {
            Object::Box { min, max, .. } => is_thick(min, max),
            _ => false,
        };
        let boxes = objects::all(&file.objects).iter().filter(|object| splits(object)).count();
        let mut problems =
            problem_if(boxes == 0, "expected a box with thickness among the objects, found none");
        problems.extend(problem_if(
            file.show == Show::ObjectIds,
            "expected a picture that does not show numbers of objects, as triangles have their own",
        ));
        problems.extend(problem_of_error(file));
        problems
    }

    fn holds(&self, today: &Today<'_>) -> Result<(), Broken> {
        let found = today.fixture.render_related(&Self::related(&today.fixture.file))?;
        self.alike().compare(today.picture, &found)
    }
}

/// Whether every face has an area.
pub(super) fn is_thick(min: Triple, max: Triple) -> bool {
    min.iter().zip(max).all(|(&lo, hi)| lo < hi)
}

/// Two triangles for each face, counter-clockwise as seen from outside.
pub(super) fn triangles(min: Triple, max: Triple) -> Vec<[Triple; 3]> {
    let mut all = Vec::new();
    for axis in 0..3 {
        let (right, up) = ((axis + 1) % 3, (axis + 2) % 3);
        for side in [min, max] {
            let corner = |r: Triple, u: Triple| {
                let mut corner = side;
                (corner[right], corner[up]) = (r[right], u[up]);
                corner
            };
            let around = [corner(min, min), corner(max, min), corner(max, max), corner(min, max)];
            let [a, b, c, d] = around;
            if side == max {
                all.extend([[a, b, c], [a, c, d]]);
            } else {
                all.extend([[a, c, b], [a, d, c]]);
            }
        }
    }
    all
}
