//! What a run found, as JSON.

use serde::Serialize;

use super::measure::Measured;
use super::rays::RaySet;

/// The version of this format.
pub(crate) const SCHEMA: u32 = 1;

/// Everything that a run found.
#[derive(Debug, Default, Serialize)]
pub(crate) struct Report {
    pub(crate) schema: u32,
    pub(crate) machine: String,
    pub(crate) rows: Vec<Row>,
}

/// One engine on one set of rays.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(crate) struct Row {
    pub(crate) scene: String,
    pub(crate) triangles: usize,
    pub(crate) rays: String,
    pub(crate) query: String,
    pub(crate) count: usize,
    pub(crate) engine: String,
    /// Millions of rays a second: the median.
    pub(crate) mrays_s: f64,
    /// The slowest and the fastest repetition.
    pub(crate) spread: [f64; 2],
    /// Rays with another answer than the exact one.
    pub(crate) wrong: usize,
}

impl Row {
    pub(crate) fn new(scene: &str, triangles: usize, set: &RaySet, measured: &Measured) -> Self {
        Self {
            scene: scene.to_owned(),
            triangles,
            rays: set.name.clone(),
            query: set.query.name().to_owned(),
            count: set.rays.len(),
            engine: measured.engine.to_owned(),
            mrays_s: measured.mrays_s.median,
            spread: [measured.mrays_s.min, measured.mrays_s.max],
            wrong: measured.wrong,
        }
    }
}
