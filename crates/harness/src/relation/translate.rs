//! `Translate`: moved together with its camera, a scene looks the same.

use scene::format::Triple;
use serde::{Deserialize, Serialize};

use super::alike::few_roundings;
use super::motion::Motion;
use super::{Alike, Broken, Problem, Relate, Today, problem_in, shown};
use crate::check::File;

/// The picture stays when objects, point lights and camera are moved.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Translate {
    /// Along each axis.
    pub by: Triple,
    /// How far each channel may be off, relative to the brightest of the
    /// picture.
    #[serde(default = "few_roundings")]
    pub within: f64,
    /// How many pixels may be off by more.
    #[serde(default)]
    pub edge_pixels: u32,
}

impl Relate for Translate {
    fn words(&self) -> String {
        let [x, y, z] = self.by.map(shown);
        format!("Translate(by: ({x}, {y}, {z}))")
    }

    fn alike(&self) -> Alike {
        Alike { within: self.within, edge_pixels: self.edge_pixels }
    }

    fn problems(&self, file: &File) -> Vec<Problem> {
        /// A shorter way would round to none beside most scenes.
        const LEAST: f64 = 1e-3;
        let is_finite = self.by.iter().all(|x| x.is_finite());
        let is_a_way = is_finite && self.by.iter().any(|x| x.abs() >= LEAST);
        let mut problems = problem_in("by", !is_a_way, || {
            format!("expected three finite numbers, one of {LEAST} or more, found {:?}", self.by)
        });
        problems.extend(Motion::translation(self.by).problems(file));
        problems
    }

    fn holds(&self, today: &Today<'_>) -> Result<(), Broken> {
        today.moves(Motion::translation(self.by), self.alike())
    }
}
