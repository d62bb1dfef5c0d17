//! `QuarterTurn`: turned together with its camera, a scene looks the same.

use serde::{Deserialize, Serialize};

use super::alike::few_roundings;
use super::motion::{Axis, Motion};
use super::{Alike, Broken, Problem, Relate, Today};
use crate::check::File;

/// The picture stays when everything is turned by 90 degrees about a world
/// axis, which moves coordinates without rounding. Colors of normals turn too.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct QuarterTurn {
    /// About which axis, counter-clockwise as seen from its end.
    pub axis: Axis,
    /// How far each channel may be off, relative to the brightest of the
    /// picture.
    #[serde(default = "few_roundings")]
    pub within: f64,
    /// How many pixels may be off by more.
    #[serde(default)]
    pub edge_pixels: u32,
}

impl Relate for QuarterTurn {
    fn words(&self) -> String {
        format!("QuarterTurn(axis: {:?})", self.axis)
    }

    fn alike(&self) -> Alike {
        Alike { within: self.within, edge_pixels: self.edge_pixels }
    }

    fn problems(&self, file: &File) -> Vec<Problem> {
        Motion::quarter_turn(self.axis).problems(file)
    }

    fn holds(&self, today: &Today<'_>) -> Result<(), Broken> {
        today.moves(Motion::quarter_turn(self.axis), self.alike())
    }
}
