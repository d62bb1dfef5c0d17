//! The scene format as it is written: what each file may say, and what a file
//! gets that does not say it.
//!
//! These types hold what was written, nothing checked but its form; what is
//! valid is a [`tracer::Scene`], which [`load`](crate::load())
//! makes of them. Field names are those of the tracer's constructors, so that
//! a number the tracer refuses is found in the file by its name.
//!
//! A field that later versions add must be left out of what is written back
//! where it has its default, so that old files keep their canonical text and
//! goldens their provenance.

pub mod by_name;
mod camera;
mod light;
mod material;
mod object;
mod sampling;

pub use camera::Camera;
pub use light::{Falloff, Light};
pub use material::Material;
pub use object::{Object, Transform};
pub use sampling::{Filter, Sampler};

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

/// The version of the format that this crate reads.
pub const VERSION: u32 = 1;

/// Three numbers in parentheses: a point, a direction or a color.
pub type Triple = [f64; 3];

/// A scene file. `Check` is what else a file may say under `check`, which the
/// scene itself does not read.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(
    rename = "Scene",
    deny_unknown_fields,
    bound(serialize = "Check: Serialize", deserialize = "Check: Deserialize<'de>")
)]
pub struct SceneFile<Check = Unchecked> {
    /// The format's version, [`VERSION`].
    pub version: u32,
    /// Width and height of the picture in pixels, the lecture's `nx` and `ny`.
    pub image: (u32, u32),
    /// Where the picture is taken from.
    pub camera: Camera,
    /// What there is to see, in order: of two surfaces at the very same
    /// distance the first is seen.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub objects: Vec<Object>,
    /// What lights it; none is darkness.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub lights: Vec<Light>,
    /// Materials by name, for objects to share as `Named("...")`.
    #[serde(
        default,
        skip_serializing_if = "BTreeMap::is_empty",
        deserialize_with = "by_name::deserialize"
    )]
    pub materials: BTreeMap<String, Material>,
    /// The shading formulas; the lecture's if not said.
    #[serde(default, skip_serializing_if = "is_default")]
    pub shading: Shading,
    /// Whether lights cast shadows.
    #[serde(default = "yes", skip_serializing_if = "is_yes")]
    pub shadows: bool,
    /// How many times an eye ray may be reflected or refracted.
    #[serde(default = "default_bounces", skip_serializing_if = "are_default_bounces")]
    pub bounces: u32,
    /// The color of what is not hit; black if not said.
    #[serde(default, skip_serializing_if = "is_default")]
    pub background: Triple,
    /// Multiplies every pixel of a shaded picture.
    #[serde(default = "one", skip_serializing_if = "is_one")]
    pub exposure: f64,
    /// What the picture shows.
    #[serde(default, skip_serializing_if = "is_default")]
    pub show: Show,
    /// Samples in each pixel: a square number, but for Sobol's points.
    #[serde(default = "one_sample", skip_serializing_if = "is_one_sample")]
    pub samples_per_pixel: u32,
    /// How they are spread.
    #[serde(default, skip_serializing_if = "is_default")]
    pub sampler: Sampler,
    /// How much each counts for the pixels around it.
    #[serde(default, skip_serializing_if = "is_default")]
    pub filter: Filter,
    /// Samples are added where a pixel's neighborhood differs, until its error
    /// is estimated to be at most this; see [`tracer::SceneParts::error`].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub error: Option<f64>,
    /// How the picture is stored in 8 bits.
    #[serde(default, skip_serializing_if = "is_default")]
    pub encoding: Encoding,
    /// For the caller.
    #[serde(default = "none", skip_serializing_if = "Option::is_none")]
    pub check: Option<Check>,
}

impl<Check> SceneFile<Check> {
    /// The same scene without what only its caller reads.
    pub fn without_check(self) -> SceneFile<Unchecked> {
        let Self {
            version,
            image,
            camera,
            objects,
            lights,
            materials,
            shading,
            shadows,
            bounces,
            background,
            exposure,
            show,
            samples_per_pixel,
            sampler,
            filter,
            error,
            encoding,
            check: _,
        } = self;
        SceneFile {
            version,
            image,
            camera,
            objects,
            lights,
            materials,
            shading,
            shadows,
            bounces,
            background,
            exposure,
            show,
            samples_per_pixel,
            sampler,
            filter,
            error,
            encoding,
            check: None,
        }
    }
}

/// The `check` of a caller that has none: no value of it can be written.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub enum Unchecked {}

/// Which shading formulas hold; see [`tracer::Convention`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub enum Shading {
    /// The lecture's: no falloff, no 1/pi.
    #[default]
    Classic,
    /// With `1/r^2`.
    Attenuated,
    /// With `1/r^2` and `1/pi`.
    Radiometric,
}

/// What the picture shows; see [`tracer::Show`].
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub enum Show {
    /// Materials, lights and shadows.
    #[default]
    Shaded,
    /// White where something is hit.
    Silhouette,
    /// Each surface's own color, unlit.
    SurfaceColor,
    /// Shading normals as `(n + 1) / 2`.
    Normals,
    /// Distance: white at `near`, black at `far`.
    Depth {
        /// The distance that is white.
        near: f64,
        /// The distance that is black.
        far: f64,
    },
    /// A color for each object.
    ObjectIds,
}

/// How linear values become 8 bits.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub enum Encoding {
    /// A plain power of 1/2.2, as the assignment has it.
    #[default]
    Gamma22,
    /// The sRGB curve.
    Srgb,
}

// Serde takes these by reference or as functions.
#[allow(clippy::trivially_copy_pass_by_ref)]
fn is_yes(x: &bool) -> bool {
    *x
}
#[allow(clippy::trivially_copy_pass_by_ref)]
fn is_one(x: &f64) -> bool {
    *x == 1.0
}
#[allow(clippy::trivially_copy_pass_by_ref)]
fn is_one_sample(x: &u32) -> bool {
    *x == 1
}
#[allow(clippy::trivially_copy_pass_by_ref)]
fn are_default_bounces(x: &u32) -> bool {
    *x == default_bounces()
}
pub(crate) fn is_default<T: Default + PartialEq>(x: &T) -> bool {
    *x == T::default()
}
fn yes() -> bool {
    true
}
fn one() -> f64 {
    1.0
}
fn one_sample() -> u32 {
    1
}
fn default_bounces() -> u32 {
    tracer::Scene::DEFAULT_BOUNCES
}
fn none<T>() -> Option<T> {
    None
}
