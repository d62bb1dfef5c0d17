//! Cameras as a file has them: the assignment's, and one by field of view.

use serde::{Deserialize, Serialize};

use super::Triple;

/// Where the picture is taken from.
///
/// The first two are the assignment's, with its names and defaults; see
/// [`tracer::View`].
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub enum Camera {
    /// Rays from the eye through the view window.
    Perspective {
        /// The eye.
        view_point: Triple,
        /// Where it looks.
        #[serde(default = "into_the_screen")]
        view_dir: Triple,
        /// What is up.
        #[serde(default = "up")]
        view_up: Triple,
        /// The window's normal, back towards the viewer; `-view_dir` if not
        /// said, anything else is an oblique view.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        proj_normal: Option<Triple>,
        /// Width of the window.
        #[serde(default = "one")]
        view_width: f64,
        /// Height of the window.
        #[serde(default = "one")]
        view_height: f64,
        /// Distance of the window from the eye, along `view_dir`.
        #[serde(default = "one")]
        proj_distance: f64,
    },
    /// Rays along `view_dir` from the view window.
    Parallel {
        /// The center of the window.
        view_point: Triple,
        /// Where it looks.
        #[serde(default = "into_the_screen")]
        view_dir: Triple,
        /// What is up.
        #[serde(default = "up")]
        view_up: Triple,
        /// The window's normal; see above.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        proj_normal: Option<Triple>,
        /// Width of the window.
        #[serde(default = "one")]
        view_width: f64,
        /// Height of the window.
        #[serde(default = "one")]
        view_height: f64,
    },
    /// A straight perspective view of a point.
    LookAt {
        /// The eye.
        eye: Triple,
        /// The point in the middle of the picture.
        at: Triple,
        /// What is up.
        #[serde(default = "up")]
        up: Triple,
        /// Angle between the bottom and the top of the picture, in degrees.
        fov_deg: f64,
    },
}

fn into_the_screen() -> Triple {
    [0.0, 0.0, -1.0]
}
fn up() -> Triple {
    [0.0, 1.0, 0.0]
}
fn one() -> f64 {
    1.0
}
