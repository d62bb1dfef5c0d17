//! `ScaleWindow`: a window as much larger as it is farther away shows the same.

use scene::format::Camera;
use serde::{Deserialize, Serialize};

use super::alike::few_roundings;
use super::window::Window;
use super::{Alike, Broken, Problem, Relate, Today, problem_if, problem_of_factor, shown};
use crate::check::File;

/// The picture stays when the window of a perspective view is `by` times as
/// large and as far away. The rays stay, and only their directions' lengths
/// change, which nothing may depend on.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ScaleWindow {
    /// How many times larger and farther away.
    pub by: f64,
    /// How far each channel may be off, relative to the brightest of the
    /// picture.
    #[serde(default = "few_roundings")]
    pub within: f64,
    /// How many pixels may be off by more.
    #[serde(default)]
    pub edge_pixels: u32,
}

impl Relate for ScaleWindow {
    fn words(&self) -> String {
        format!("ScaleWindow(by: {})", shown(self.by))
    }

    fn alike(&self) -> Alike {
        Alike { within: self.within, edge_pixels: self.edge_pixels }
    }

    fn problems(&self, file: &File) -> Vec<Problem> {
        let mut problems = problem_of_factor(self.by);
        problems.extend(problem_if(
            matches!(file.camera, Camera::Parallel { .. }),
            "expected a perspective camera, as a parallel one's window has no distance",
        ));
        problems.extend(problem_if(file.objects.is_empty(), "expected an object, found none"));
        problems
    }

    fn holds(&self, today: &Today<'_>) -> Result<(), Broken> {
        let file = &today.fixture.file;
        let camera = Window::of(&file.camera, file.image).farther(self.by).camera();
        let found = today.fixture.render_related(&File { camera, ..file.clone() })?;
        self.alike().compare(today.picture, &found)
    }
}
