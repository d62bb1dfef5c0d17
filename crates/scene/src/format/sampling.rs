//! Where samples are taken and what they count for, as a file says it.

use serde::{Deserialize, Serialize};

use super::is_default;

/// How samples are spread in their pixel; see [`tracer::Sampler`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub enum Sampler {
    /// A regular grid.
    #[default]
    Grid,
    /// One anywhere in each square cell.
    Stratified {
        /// Another one moves every sample.
        #[serde(default, skip_serializing_if = "is_default")]
        seed: u32,
    },
    /// Sobol's points, scrambled by Owen's method.
    Sobol {
        /// Another one moves every sample.
        #[serde(default, skip_serializing_if = "is_default")]
        seed: u32,
    },
}

/// What a pixel is the mean of; see [`tracer::Filter`]. Radii are in pixels.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub enum Filter {
    /// Its own samples.
    #[default]
    Box,
    /// The samples around its middle, the nearer the more.
    Tent {
        /// From where on they count nothing.
        #[serde(default = "tent_radius")]
        radius: f64,
    },
    /// The same, by a bell of three standard deviations.
    Gaussian {
        /// From where on they count nothing.
        #[serde(default = "gaussian_radius")]
        radius: f64,
    },
    /// The same, by Mitchell and Netravali's cubic pieces.
    Mitchell {
        /// From where on they count nothing.
        #[serde(default = "mitchell_radius")]
        radius: f64,
    },
}

// What each filter was made for.
impl Filter {
    /// A tent's, if not said: it interpolates between neighbors.
    pub const TENT_RADIUS: f64 = 1.0;
    /// A Gaussian's: one of half a pixel, up to three times that.
    pub const GAUSSIAN_RADIUS: f64 = 1.5;
    /// Mitchell's: its paper's cubic pieces end at the second neighbor.
    pub const MITCHELL_RADIUS: f64 = 2.0;
}

fn tent_radius() -> f64 {
    Filter::TENT_RADIUS
}
fn gaussian_radius() -> f64 {
    Filter::GAUSSIAN_RADIUS
}
fn mitchell_radius() -> f64 {
    Filter::MITCHELL_RADIUS
}

impl From<Sampler> for tracer::Sampler {
    fn from(written: Sampler) -> Self {
        match written {
            Sampler::Grid => Self::Grid,
            Sampler::Stratified { seed } => Self::Stratified { seed },
            Sampler::Sobol { seed } => Self::Sobol { seed },
        }
    }
}

impl TryFrom<Filter> for tracer::Filter {
    type Error = tracer::Refused;

    /// # Errors
    /// As [`tracer::Filter::tent`] and the others.
    fn try_from(written: Filter) -> Result<Self, Self::Error> {
        match written {
            Filter::Box => Ok(Self::BOX),
            Filter::Tent { radius } => Self::tent(radius),
            Filter::Gaussian { radius } => Self::gaussian(radius),
            Filter::Mitchell { radius } => Self::mitchell(radius),
        }
    }
}
