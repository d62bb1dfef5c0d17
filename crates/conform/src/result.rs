//! `Run`: what came of asking a renderer for the pictures of a suite.

use std::collections::{BTreeMap, BTreeSet};

use interchange::Feature;
use serde::{Deserialize, Serialize};
use tracer::LinearImage;

use crate::adapter::DEFAULT_REACH;

/// A renderer's run over fixtures, as it is written to `results.json`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Run {
    /// The version of this record, [`Run::SCHEMA`].
    pub schema: u32,
    /// Who rendered.
    pub renderer: RendererInfo,
    /// How far an interior pixel may be off, relative; see [`Numbers::worst_interior`].
    pub tolerance: f64,
    /// How far a sample is moved to tell edges, in pixels.
    pub edge_reach: f64,
    /// One for each fixture, by name.
    pub fixtures: BTreeMap<String, FixtureResult>,
}

impl Run {
    /// The version of the record.
    pub const SCHEMA: u32 = 1;
}

/// How far pictures may be off, in words: what an adapter allows is part of what a card
/// says. The reach of edges is named where it is more than usual.
pub fn held_to(tolerance: f64, edge_reach: f64) -> String {
    let tolerance = crate::card::error(tolerance);
    match edge_reach {
        reach if reach > DEFAULT_REACH => {
            format!("{tolerance}, what is within {reach} px of an edge may be either side")
        }
        _ => tolerance,
    }
}

/// Which renderer.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RendererInfo {
    /// Its name for people.
    pub name: String,
    /// The name of its folders and badge: letters, digits, `-`, `_`.
    pub id: String,
    /// What it says when asked for its version; empty if it is not asked.
    pub version: String,
}

/// What came of one fixture.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FixtureResult {
    /// What the scene asks for.
    pub features: BTreeSet<Feature>,
    /// What came of it.
    pub outcome: Outcome,
    /// Why, in sentences; empty for a pass.
    pub findings: Vec<String>,
    /// The comparison, where there was a picture of the right size.
    pub numbers: Option<Numbers>,
    /// How long the renderer took.
    pub elapsed_ms: f64,
}

/// What came of asking for a picture.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Outcome {
    /// Every interior pixel is right, and what is known on paper holds.
    Pass,
    /// A picture that is wrong.
    Fail,
    /// The adapter or its dialect does not have what the scene asks for: not asked.
    Unsupported,
    /// The renderer ended with an error, or by a signal.
    Crashed,
    /// It was killed after its timeout.
    TimedOut,
    /// It ended well and wrote no picture.
    NoPicture,
    /// What it wrote is no picture, or part of one.
    BadPicture,
    /// A picture of another size.
    WrongSize,
}

/// A picture beside goldray's.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Numbers {
    /// Pixels of the picture.
    pub pixels: u64,
    /// Those whose sample sees something else when it is moved by the reach.
    pub edge_pixels: u64,
    /// Edge pixels beyond the tolerance.
    pub edge_off: u64,
    /// Interior pixels beyond the tolerance.
    pub interior_off: u64,
    /// The largest error of an interior pixel: its worst channel's distance from
    /// the nearest value that the file could stand for, relative to the pixel's
    /// brightest channel.
    pub worst_interior: f64,
    /// Where that is.
    pub worst_at: Option<(u32, u32)>,
}

/// A run with its pictures, in memory.
#[derive(Debug, Clone)]
pub struct Conformed {
    /// What came of it.
    pub run: Run,
    /// By fixture, where there was a picture of the right size.
    pub evidence: BTreeMap<String, Evidence>,
}

/// What a result was found by.
#[derive(Debug, Clone)]
pub struct Evidence {
    /// goldray's picture, linear, exposure applied.
    pub reference: LinearImage,
    /// The renderer's, with each number of its file taken as it is.
    pub actual: LinearImage,
    /// The least that each number of the file may stand for: half a step below, or
    /// minus infinity where it was clamped.
    pub low: LinearImage,
    /// The most: half a step above, or infinity.
    pub high: LinearImage,
    /// Whether each pixel is an edge, row-major.
    pub edges: Vec<bool>,
    /// Whether each pixel is beyond the tolerance, row-major.
    pub off: Vec<bool>,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_allowed_is_said() {
        assert_eq!(held_to(1e-5, DEFAULT_REACH), "1e-5");
        assert_eq!(held_to(0.1, 1e-3), "0.1");
        let wide = "1e-5, what is within 0.1 px of an edge may be either side";
        assert_eq!(held_to(1e-5, 0.1), wide);
    }
}
