//! Materials as a file has them: by name or in place.

use serde::{Deserialize, Serialize};

use super::{Texture, Triple, is_default, is_one, one};

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
    /// A mirror.
    Mirror {
        /// Share of light reflected; all of it if not said.
        #[serde(default = "white", skip_serializing_if = "is_white")]
        reflectance: Triple,
        /// Whether it grows along the surface by Schlick's law.
        #[serde(default, skip_serializing_if = "is_default")]
        schlick: bool,
    },
    /// Clear glass, water, air in them.
    Dielectric {
        /// Index of refraction of the inside, relative to the outside.
        ior: f64,
        /// Share of refracted light that goes through, at each surface.
        #[serde(default = "white", skip_serializing_if = "is_white")]
        tint: Triple,
        /// Whether Schlick's law stands in for Fresnel's equations.
        #[serde(default, skip_serializing_if = "is_default")]
        schlick: bool,
    },
    /// Lit, reflecting and transparent by fixed shares.
    Whitted {
        /// Share of light scattered; the shading's default if not said.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        diffuse: Option<Triple>,
        /// Strength of the highlight; none if not said.
        #[serde(default, skip_serializing_if = "is_default")]
        specular: Triple,
        /// Sharpness of the highlight.
        #[serde(default = "one", skip_serializing_if = "is_one")]
        exponent: f64,
        /// Share of what the reflected ray sees; none if not said.
        #[serde(default, skip_serializing_if = "is_default")]
        reflect: Triple,
        /// Share of what the refracted ray sees; none if not said.
        #[serde(default, skip_serializing_if = "is_default")]
        transmit: Triple,
        /// Index of refraction of the inside, relative to the outside.
        #[serde(default = "one", skip_serializing_if = "is_one")]
        ior: f64,
        /// Whether `reflect` grows along the surface by Schlick's law.
        #[serde(default, skip_serializing_if = "is_default")]
        schlick: bool,
        /// Multiplies `diffuse` from place to place.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        texture: Option<Texture>,
    },
    /// Uniform scattering with a highlight, under a clear coat.
    Glazed {
        /// Index of refraction of the coat, relative to the outside.
        ior: f64,
        /// Whether Schlick's law stands in for Fresnel's equations.
        #[serde(default, skip_serializing_if = "is_default")]
        schlick: bool,
        /// Share of light scattered; the shading's default if not said.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        diffuse: Option<Triple>,
        /// Strength of the highlight; none if not said.
        #[serde(default, skip_serializing_if = "is_default")]
        specular: Triple,
        /// Sharpness of the highlight.
        #[serde(default = "one", skip_serializing_if = "is_one")]
        exponent: f64,
        /// Multiplies `diffuse` from place to place.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        texture: Option<Texture>,
    },
}

fn white() -> Triple {
    [1.0; 3]
}
fn is_white(x: &Triple) -> bool {
    *x == white()
}

impl Material {
    /// Its own texture; one that is named has none by itself.
    pub fn texture(&self) -> Option<&Texture> {
        match self {
            Self::Constant { texture, .. }
            | Self::Lambert { texture, .. }
            | Self::BlinnPhong { texture, .. }
            | Self::Whitted { texture, .. }
            | Self::Glazed { texture, .. } => texture.as_ref(),
            Self::Named(_) | Self::Normal | Self::Mirror { .. } | Self::Dielectric { .. } => None,
        }
    }

    /// Where its own texture stands; `None` where none can.
    pub fn texture_mut(&mut self) -> Option<&mut Option<Texture>> {
        match self {
            Self::Constant { texture, .. }
            | Self::Lambert { texture, .. }
            | Self::BlinnPhong { texture, .. }
            | Self::Whitted { texture, .. }
            | Self::Glazed { texture, .. } => Some(texture),
            Self::Named(_) | Self::Normal | Self::Mirror { .. } | Self::Dielectric { .. } => None,
        }
    }
}
