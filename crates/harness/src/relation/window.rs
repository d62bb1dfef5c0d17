//! `Window`: a camera's view window, to be cut and moved.

use scene::format::{Camera, Triple};
use tracer::glam::DVec3;

/// A view window, by what any camera has.
pub(crate) struct Window {
    eye: DVec3,
    /// From the eye to the window's middle in a perspective view, along the
    /// rays in a parallel one.
    ahead: DVec3,
    is_perspective: bool,
    /// To the right, up, and back towards the viewer.
    axes: [DVec3; 3],
    size: [f64; 2],
}

impl Window {
    /// The window of a camera of a picture of this size.
    pub(crate) fn of(camera: &Camera, (width, height): (u32, u32)) -> Self {
        let v3 = DVec3::from_array;
        match *camera {
            Camera::Perspective {
                view_point,
                view_dir,
                view_up,
                proj_normal,
                view_width,
                view_height,
                proj_distance,
            } => Self {
                eye: v3(view_point),
                ahead: proj_distance * v3(view_dir).normalize(),
                is_perspective: true,
                axes: axes(view_dir, view_up, proj_normal),
                size: [view_width, view_height],
            },
            Camera::Parallel {
                view_point,
                view_dir,
                view_up,
                proj_normal,
                view_width,
                view_height,
            } => Self {
                eye: v3(view_point),
                ahead: v3(view_dir),
                is_perspective: false,
                axes: axes(view_dir, view_up, proj_normal),
                size: [view_width, view_height],
            },
            Camera::LookAt { eye, at, up, fov_deg } => {
                let ahead = v3(at) - v3(eye);
                let high = 2.0 * libm::tan(0.5 * fov_deg.to_radians());
                Self {
                    eye: v3(eye),
                    ahead: ahead.normalize(),
                    is_perspective: true,
                    axes: axes(ahead.to_array(), up, None),
                    size: [high * f64::from(width) / f64::from(height), high],
                }
            }
        }
    }

    /// The part of it that these pixels see: from `at`, `size` of so many.
    pub(crate) fn part(
        mut self,
        at: (u32, u32),
        size: (u32, u32),
        (width, height): (u32, u32),
    ) -> Self {
        let [u, v, _] = self.axes;
        // How far the part's middle is right of and above the whole's, in
        // halves of pixels.
        let right = f64::from(2 * at.0 + size.0) - f64::from(width);
        let up = f64::from(height) - f64::from(2 * at.1 + size.1);
        let pixel = [self.size[0] / f64::from(width), self.size[1] / f64::from(height)];
        let middle = 0.5 * (right * pixel[0] * u + up * pixel[1] * v);
        if self.is_perspective {
            self.ahead += middle;
        } else {
            self.eye += middle;
        }
        self.size = [pixel[0] * f64::from(size.0), pixel[1] * f64::from(size.1)];
        self
    }

    /// One so many times as large and as far away.
    pub(crate) fn farther(mut self, times: f64) -> Self {
        self.ahead *= times;
        self.size = self.size.map(|size| times * size);
        self
    }

    /// The camera with this window.
    pub(crate) fn camera(&self) -> Camera {
        let [_, view_up, normal] = self.axes.map(|axis| axis.to_array());
        let (view_point, view_dir) = (self.eye.to_array(), self.ahead.to_array());
        let (proj_normal, [view_width, view_height]) = (Some(normal), self.size);
        if self.is_perspective {
            let proj_distance = self.ahead.length();
            Camera::Perspective {
                view_point,
                view_dir,
                view_up,
                proj_normal,
                view_width,
                view_height,
                proj_distance,
            }
        } else {
            Camera::Parallel { view_point, view_dir, view_up, proj_normal, view_width, view_height }
        }
    }
}

/// The window's axes `u, v, w`, by the assignment's formulas.
fn axes(view_dir: Triple, view_up: Triple, proj_normal: Option<Triple>) -> [DVec3; 3] {
    let v3 = DVec3::from_array;
    let w = proj_normal.map_or(-v3(view_dir), v3).normalize();
    let u = v3(view_up).cross(w).normalize();
    [u, w.cross(u).normalize(), w]
}
