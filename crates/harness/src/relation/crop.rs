//! `Crop`: a window of the view shows those very pixels.

use scene::format::{Camera, Filter, Sampler, Triple};
use serde::{Deserialize, Serialize};
use tracer::glam::DVec3;
use tracer::{LinearImage, Size};

use super::alike::few_roundings;
use super::{Alike, Problem, Relate, Today, problem_if, problem_in, problem_of_error};
use crate::check::File;

/// A camera whose window is a part of the fixture's sees the pixels of that
/// part. A part beside the middle makes a straight view oblique: the window's
/// normal stays, and what was its distance is no longer along it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Crop {
    /// The part's upper left pixel.
    pub at: (u32, u32),
    /// Its width and height in pixels.
    pub size: (u32, u32),
    /// How far each channel may be off, relative to the brightest of the part.
    #[serde(default = "few_roundings")]
    pub within: f64,
    /// How many pixels may be off by more.
    #[serde(default)]
    pub edge_pixels: u32,
}

impl Relate for Crop {
    fn words(&self) -> String {
        format!("Crop(at: {:?}, size: {:?})", self.at, self.size)
    }

    fn alike(&self) -> Alike {
        Alike { within: self.within, edge_pixels: self.edge_pixels }
    }

    fn problems(&self, file: &File) -> Vec<Problem> {
        let ((x, y), (w, h), (width, height)) = (self.at, self.size, file.image);
        let fits = |at: u32, size: u32, all: u32| {
            size > 0 && u64::from(at) + u64::from(size) <= u64::from(all)
        };
        let is_part = fits(x, w, width) && fits(y, h, height) && self.size != file.image;
        let mut problems = problem_in("size", !is_part, || {
            format!(
                "expected a part of the picture, which is {width} x {height}, found {w} x {h} at \
                 ({x}, {y})"
            )
        });
        problems.extend(problem_if(
            file.sampler != Sampler::Grid || file.filter != Filter::Box,
            "expected samples on a grid and the filter `Box`, as others depend on where a pixel is",
        ));
        problems.extend(problem_of_error(file));
        problems
    }

    fn holds(&self, today: &Today<'_>) -> Result<(), String> {
        let file = &today.fixture.file;
        let window = Window::of(&file.camera, file.image).part(self, file.image);
        let part = File { camera: window.camera(), image: self.size, ..file.clone() };
        let found = today.fixture.render_related(&part)?;
        let ((x0, y0), (width, height)) = (self.at, self.size);
        let expected = LinearImage::from_fn(Size { width, height }, |x, y| {
            today.picture.get(x0 + x, y0 + y).unwrap_or_default()
        });
        self.alike().compare(&expected, &found)
    }
}

/// A view window, by what any camera has.
struct Window {
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
    fn of(camera: &Camera, (width, height): (u32, u32)) -> Self {
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

    /// The part of it that these pixels see, of so many.
    fn part(mut self, Crop { at, size, .. }: &Crop, (width, height): (u32, u32)) -> Self {
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

    /// The camera with this window.
    fn camera(&self) -> Camera {
        let [_, up, normal] = self.axes.map(|axis| axis.to_array());
        let (view_point, view_dir) = (self.eye.to_array(), self.ahead.to_array());
        let (proj_normal, [view_width, view_height]) = (Some(normal), self.size);
        let view_up = up;
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
