//! Textures as a file has them.

use serde::{Deserialize, Serialize};

use super::{Triple, is_default};

/// Two numbers in parentheses, for `u` and `v`.
pub type Pair = [f64; 2];

/// What multiplies a material's color from place to place; see
/// [`tracer::Texture`].
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub enum Texture {
    /// Two colors by turns, in squares of texture coordinates.
    Checker {
        /// The color of the square from 0 to 1.
        a: Triple,
        /// The color of the squares beside it.
        b: Triple,
        /// How many squares there are to a unit; 1 if not said.
        #[serde(default = "ones", skip_serializing_if = "are_ones")]
        scale: Pair,
        /// What is added to the scaled coordinates.
        #[serde(default, skip_serializing_if = "is_default")]
        offset: Pair,
    },
    /// A picture from a PNG file.
    Image {
        /// The file, in the scene's own folder or below it.
        file: String,
        /// What is seen between the middles of texels.
        #[serde(default, skip_serializing_if = "is_default")]
        filter: TexelFilter,
        /// What is seen beyond the picture's borders.
        #[serde(default, skip_serializing_if = "is_default")]
        wrap: Wrap,
        /// How the file's codes stand for linear values.
        #[serde(default, skip_serializing_if = "is_default")]
        encoding: TexelEncoding,
        /// How many pictures there are to a unit; 1 if not said.
        #[serde(default = "ones", skip_serializing_if = "are_ones")]
        scale: Pair,
        /// What is added to the scaled coordinates.
        #[serde(default, skip_serializing_if = "is_default")]
        offset: Pair,
    },
}

/// What is seen between texels; see [`tracer::texture::TexelFilter`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub enum TexelFilter {
    /// The texel that the place is in.
    Nearest,
    /// The four around.
    #[default]
    Bilinear,
}

/// What is seen beyond the borders; see [`tracer::texture::Wrap`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub enum Wrap {
    /// The picture again.
    #[default]
    Repeat,
    /// The texel at the border.
    Clamp,
}

/// How a file's codes stand for linear values.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Default, Serialize, Deserialize)]
pub enum TexelEncoding {
    /// By the sRGB curve, as most pictures are stored.
    #[default]
    Srgb,
    /// By a plain power of 2.2.
    Gamma22,
    /// As they are.
    Linear,
}

fn ones() -> Pair {
    [1.0; 2]
}
// Serde takes it by reference.
#[allow(clippy::trivially_copy_pass_by_ref)]
fn are_ones(pair: &Pair) -> bool {
    *pair == ones()
}
