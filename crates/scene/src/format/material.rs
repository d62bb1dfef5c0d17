//! Materials as a file has them: by name or in place.

use serde::{Deserialize, Serialize};

use super::Triple;

/// What a surface is made of; see [`tracer::Material`].
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub enum Material {
    /// One of the file's `materials`.
    Named(String),
    /// This color, unlit.
    Constant {
        /// The color.
        color: Triple,
    },
    /// The normal as a color, unlit.
    Normal,
    /// Uniform scattering.
    Lambert {
        /// Share of light scattered; the shading's default if not said.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        diffuse: Option<Triple>,
    },
    /// Uniform scattering with a highlight.
    BlinnPhong {
        /// Share of light scattered; the shading's default if not said.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        diffuse: Option<Triple>,
        /// Strength of the highlight.
        specular: Triple,
        /// Sharpness of the highlight.
        exponent: f64,
    },
}
