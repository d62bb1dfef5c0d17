//! `Crop`: a window of the view shows those very pixels.

use scene::format::{Filter, Sampler};
use serde::{Deserialize, Serialize};
use tracer::{LinearImage, Size};

use super::alike::few_roundings;
use super::window::Window;
use super::{Alike, Broken, Problem, Relate, Today, problem_if, problem_in, problem_of_error};
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

    fn holds(&self, today: &Today<'_>) -> Result<(), Broken> {
        let file = &today.fixture.file;
        let window = Window::of(&file.camera, file.image).part(self.at, self.size, file.image);
        let part = File { camera: window.camera(), image: self.size, ..file.clone() };
        let found = today.fixture.render_related(&part)?;
        let ((x0, y0), (width, height)) = (self.at, self.size);
        let expected = LinearImage::from_fn(Size { width, height }, |x, y| {
            today.picture.get(x0 + x, y0 + y).unwrap_or_default()
        });
        self.alike().compare(&expected, &found)
    }
}
