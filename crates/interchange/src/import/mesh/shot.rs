//! `Shot`: a camera whose picture is as wide as the picture's size says.

use scene::format::{Camera, Triple};
use tracer::glam::DVec3;

/// A camera of a file.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::import) struct Shot {
    /// Where it is.
    pub(in crate::import) eye: DVec3,
    /// Where it looks.
    pub(in crate::import) forward: DVec3,
    /// What is up.
    pub(in crate::import) up: DVec3,
    /// How rays leave it.
    pub(in crate::import) lens: Lens,
}

/// How rays leave a camera.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::import) enum Lens {
    /// From a point.
    Perspective {
        /// The angle from the bottom to the top of the picture, in radians.
        fov: f64,
        /// Width over height, where the file says it.
        aspect: Option<f64>,
    },
    /// Side by side.
    Parallel {
        /// Width and height of the window.
        size: [f64; 2],
    },
}

impl Shot {
    /// Width over height, where the file says it.
    pub(in crate::import) fn aspect(&self) -> Option<f64> {
        match self.lens {
            Lens::Perspective { aspect, .. } => aspect,
            Lens::Parallel { size: [width, height] } => Some(width / height),
        }
    }

    /// The camera for a picture so many times as wide as high; its height is the
    /// file's.
    pub(in crate::import) fn camera(&self, aspect: f64) -> Camera {
        let [view_point, view_dir, view_up]: [Triple; 3] =
            [self.eye, self.forward, self.up].map(|v| v.to_array());
        match self.lens {
            Lens::Perspective { fov, .. } => {
                let view_height = 2.0 * libm::tan(fov / 2.0);
                Camera::Perspective {
                    view_point,
                    view_dir,
                    view_up,
                    proj_normal: None,
                    view_width: aspect * view_height,
                    view_height,
                    proj_distance: 1.0,
                }
            }
            Lens::Parallel { size: [_, height] } => Camera::Parallel {
                view_point,
                view_dir,
                view_up,
                proj_normal: None,
                view_width: aspect * height,
                view_height: height,
            },
        }
    }
}
