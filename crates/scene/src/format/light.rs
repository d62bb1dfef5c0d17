//! Lights as a file has them.

use serde::{Deserialize, Serialize};

use super::Triple;

/// A light; see [`tracer::Light`].
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub enum Light {
    /// A light at a point.
    Point {
        /// Where it is.
        position: Triple,
        /// How bright; white of 1 if not said.
        #[serde(default = "white")]
        intensity: Triple,
        /// With distance; the shading's own if not said.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        falloff: Option<Falloff>,
    },
    /// A light infinitely far away.
    Directional {
        /// The way its light travels.
        direction: Triple,
        /// How bright; white of 1 if not said.
        #[serde(default = "white")]
        intensity: Triple,
    },
    /// Light from everywhere, without shadows.
    Ambient {
        /// How bright.
        intensity: Triple,
    },
}

/// How a point light weakens with distance.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum Falloff {
    /// Not at all. Not called `None`, which RON would take for "left out".
    Constant,
    /// As the square of the distance.
    InverseSquare,
}

fn white() -> Triple {
    [1.0; 3]
}
