//! `Mirror`: mirrored together with its camera, a scene is seen mirrored.

use scene::format::Sampler;
use serde::{Deserialize, Serialize};

use super::alike::few_roundings;
use super::motion::{Axis, Motion};
use super::{Alike, Broken, Problem, Relate, Today, problem_if};
use crate::check::File;

/// The picture is mirrored, left to right, when everything is mirrored across a
/// plane through the origin: a camera's window goes to the right by
/// `up x normal`, which a mirror turns around, and up by what it does not.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Mirror {
    /// Which axis is turned around.
    pub axis: Axis,
    /// How far each channel may be off, relative to the brightest of the
    /// picture.
    #[serde(default = "few_roundings")]
    pub within: f64,
    /// How many pixels may be off by more.
    #[serde(default)]
    pub edge_pixels: u32,
}

impl Relate for Mirror {
    fn words(&self) -> String {
        format!("Mirror(axis: {:?})", self.axis)
    }

    fn alike(&self) -> Alike {
        Alike { within: self.within, edge_pixels: self.edge_pixels }
    }

    fn problems(&self, file: &File) -> Vec<Problem> {
        let mut problems = Motion::mirror(self.axis).problems(file);
        problems.extend(problem_if(
            file.sampler != Sampler::Grid,
            "expected samples on a grid, as scattered ones are not mirrored",
        ));
        problems
    }

    fn holds(&self, today: &Today<'_>) -> Result<(), Broken> {
        today.moves(Motion::mirror(self.axis), self.alike())
    }
}
