//! `ScaleUnits`: in other units of length a scene looks the same.

use serde::{Deserialize, Serialize};

use super::alike::few_roundings;
use super::motion::Motion;
use super::{Alike, Broken, Problem, Relate, Today, problem_of_factor, shown};
use crate::check::File;

/// The picture stays when every length is `by` times as long, and every light
/// that falls off with the square of the distance `by * by` times as bright.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ScaleUnits {
    /// How many times longer.
    pub by: f64,
    /// How far each channel may be off, relative to the brightest of the
    /// picture.
    #[serde(default = "few_roundings")]
    pub within: f64,
    /// How many pixels may be off by more.
    #[serde(default)]
    pub edge_pixels: u32,
}

impl Relate for ScaleUnits {
    fn words(&self) -> String {
        format!("ScaleUnits(by: {})", shown(self.by))
    }

    fn alike(&self) -> Alike {
        Alike { within: self.within, edge_pixels: self.edge_pixels }
    }

    fn problems(&self, file: &File) -> Vec<Problem> {
        let mut problems = problem_of_factor(self.by);
        problems.extend(Motion::scale(self.by).problems(file));
        problems
    }

    fn holds(&self, today: &Today<'_>) -> Result<(), Broken> {
        today.moves(Motion::scale(self.by), self.alike())
    }
}
