//! What a run found, as JSON.

use serde::Serialize;

use super::measure::Measured;
use super::rays::RaySet;
use crate::machine::Machine;

/// The version of this format.
pub(crate) const SCHEMA: u32 = 1;

/// Everything that a run found.
#[derive(Debug, Serialize)]
pub(crate) struct Report {
    pub(crate) schema: u32,
    pub(crate) machine: Machine,
    /// What was measured beside goldray, with versions.
    pub(crate) peers: Vec<String>,
    pub(crate) rows: Vec<Row>,
    pub(crate) builds: Vec<Build>,
    pub(crate) aimed: Vec<Aimed>,
    /// How many rays' exact answers were looked at twice, and how many of them
    /// a walk over all triangles answers otherwise.
    pub(crate) checked: Checked,
}

/// Exact answers beside those of a walk over all triangles.
#[derive(Debug, Default, Clone, Copy, PartialEq, Serialize)]
pub(crate) struct Checked {
    pub(crate) rays: usize,
    pub(crate) differ: usize,
}

/// Building one engine's hierarchy over one mesh.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(crate) struct Build {
    pub(crate) scene: String,
    pub(crate) triangles: usize,
    pub(crate) engine: String,
    pub(crate) threads: usize,
    /// CPU milliseconds of the busiest thread: the median, and the least and the
    /// most.
    pub(crate) ms: f64,
    pub(crate) spread: [f64; 2],
    /// CPU milliseconds of all threads, also of those that wait busily: the
    /// median.
    pub(crate) all_threads_ms: f64,
    /// Milliseconds by the wall's clock: the median. Other programs move it.
    pub(crate) wall_ms: f64,
    /// Bytes for each triangle that it keeps, its copy of the mesh with them.
    pub(crate) bytes_per_triangle: f64,
}

/// Rays through edges and corners, on one engine.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(crate) struct Aimed {
    pub(crate) scene: String,
    /// From where, at what.
    pub(crate) rays: String,
    pub(crate) engine: String,
    /// How many there are, and how many are answered wrong.
    pub(crate) of: usize,
    pub(crate) wrong: usize,
    /// Hits for misses and the other way round.
    pub(crate) hit_or_miss: usize,
    /// Hits elsewhere.
    pub(crate) elsewhere: usize,
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
            spread: [measured.mrays_s.low, measured.mrays_s.high],
            wrong: measured.wrong,
        }
    }
}

impl Report {
    /// All of it as text.
    ///
    /// # Errors
    /// What JSON cannot say.
    pub(crate) fn json(&self) -> Result<String, String> {
        let text = serde_json::to_string_pretty(self);
        text.map(|text| text + "\n").map_err(|why| format!("the report cannot be written: {why}"))
    }
}
