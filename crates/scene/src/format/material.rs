//! Materials as a file has them: by name or in place.

use serde::{Deserialize, Serialize};

use super::{Texture, Triple};

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
        /// What multiplies it from place to place.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        texture: Option<Texture>,
    },
    /// The normal as a color, unlit.
    Normal,
    /// Uniform scattering.
    Lambert {
        /// Share of light scattered; the shading's default if not said, and white under
        /// a texture.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        diffuse: Option<Triple>,
        /// What multiplies it from place to place.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        texture: Option<Texture>,
    },
    /// Uniform scattering with a highlight.
    BlinnPhong {
        /// Share of light scattered; the shading's default if not said, and white under
        /// a texture.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        diffuse: Option<Triple>,
        /// What multiplies that share from place to place.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        texture: Option<Texture>,
        /// Strength of the highlight.
        specular: Triple,
        /// Sharpness of the highlight.
        exponent: f64,
    },
}

impl Material {
    /// Its own texture; one that is named has none by itself.
    pub fn texture(&self) -> Option<&Texture> {
        match self {
            Self::Constant { texture, .. }
            | Self::Lambert { texture, .. }
            | Self::BlinnPhong { texture, .. } => texture.as_ref(),
            Self::Named(_) | Self::Normal => None,
        }
    }
}
