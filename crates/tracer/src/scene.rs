//! `Scene`: everything a picture is made from, checked.

use crate::meter::{Meter, Unmetered, Work};
use crate::plan::Candidates;
use crate::refused::{color, not_negative, refuse_unless};
use crate::shading::Lighting;
use crate::{
    Camera, Convention, Group, Interval, Light, Ray, Refused, Rgb, SampleGrid, Show, Size, Skipping,
};

/// The parts of a scene, before they are checked together.
#[derive(Debug, Clone, PartialEq)]
pub struct SceneParts {
    /// Makes the eye rays.
    pub camera: Camera,
    /// The picture's size, the lecture's `nx` and `ny`.
    pub size: Size,
    /// Where in a pixel its samples are.
    pub samples: SampleGrid,
    /// All surfaces.
    pub world: Group,
    /// All lights.
    pub lights: Vec<Light>,
    /// Which shading formulas hold.
    pub convention: Convention,
    /// Whether lights cast shadows.
    pub shadows: bool,
    /// What a ray that hits nothing sees.
    pub background: Rgb,
    /// Multiplies every pixel of a shaded picture, background included.
    pub exposure: f64,
    /// What the picture is of.
    pub show: Show,
}

/// A scene that can be rendered; see [`crate::render`].
#[derive(Debug, Clone, PartialEq)]
pub struct Scene(SceneParts);

impl Scene {
    /// The largest width or height of a picture in pixels.
    pub const MAX_SIDE: u32 = 16_384;

    /// The largest number of pixels of a picture.
    pub const MAX_PIXELS: u64 = 1 << 26;

    /// The largest number of samples of a picture: its pixels times samples a
    /// pixel.
    pub const MAX_SAMPLES: u64 = 1 << 32;

    /// The scene of these parts.
    ///
    /// # Errors
    /// Refuses (as `image`, `samples_per_pixel`) a picture without pixels or with
    /// absurdly many of them or of samples, (as
    /// `background`, `exposure`) numbers that are negative or not finite, and
    /// (as `show`) a depth range that is not one.
    pub fn new(parts: SceneParts) -> Result<Self, Refused> {
        let Size { width, height } = parts.size;
        let samples = parts.samples.samples_per_pixel();
        let sides = 1..=Self::MAX_SIDE;
        let fits = sides.contains(&width)
            && sides.contains(&height)
            && u64::from(width) * u64::from(height) <= Self::MAX_PIXELS;
        let depth_is_a_range = match parts.show {
            Show::Depth { near, far } => 0.0 <= near && near < far && far.is_finite(),
            _ => true,
        };
        Refused::unless([
            refuse_unless(
                fits,
                "image",
                format!(
                    "a width and height from 1 to {} and at most {} pixels in all",
                    Self::MAX_SIDE,
                    Self::MAX_PIXELS
                ),
                || format!("{width} x {height}"),
            ),
            refuse_unless(
                u64::from(width) * u64::from(height) * u64::from(samples) <= Self::MAX_SAMPLES,
                "samples_per_pixel",
                format!("at most {} samples in the whole picture", Self::MAX_SAMPLES),
                || format!("{samples} in each of {width} x {height} pixels"),
            ),
            color("background", parts.background),
            not_negative("exposure", parts.exposure),
            refuse_unless(depth_is_a_range, "show", "a depth range with 0 <= near < far", || {
                format!("{:?}", parts.show)
            }),
        ])?;
        Ok(Self(parts))
    }

    /// The picture's size.
    pub fn size(&self) -> Size {
        self.0.size
    }

    /// Where in a pixel its samples are.
    pub fn samples(&self) -> SampleGrid {
        self.0.samples
    }

    /// The camera.
    pub fn camera(&self) -> &Camera {
        &self.0.camera
    }

    /// All surfaces.
    pub fn world(&self) -> &Group {
        &self.0.world
    }

    /// All lights.
    pub(crate) fn lights(&self) -> &[Light] {
        &self.0.lights
    }

    /// Whether lights cast shadows.
    pub(crate) fn shadows(&self) -> bool {
        self.0.shadows
    }

    /// What the picture is of.
    pub(crate) fn show(&self) -> Show {
        self.0.show
    }

    /// What a ray that hits nothing sees.
    pub(crate) fn background(&self) -> Rgb {
        self.0.background
    }

    /// What the whole picture is multiplied by: `exposure` where the scene is
    /// shaded, 1 for every other kind of picture.
    pub fn exposure(&self) -> f64 {
        if self.0.show == Show::Shaded { self.0.exposure } else { 1.0 }
    }

    /// The lecture's `Scene.trace(ray, tMin, tMax)`: the color of the closest
    /// surface the ray hits inside `range`, else the background. Exposure is
    /// not applied.
    ///
    /// Source: the slide with the loop over pixels, eye ray generation and scene
    /// intersection.
    pub fn trace(&self, ray: &Ray, range: Interval) -> Rgb {
        let work = Work::new(Unmetered, Skipping::On, 0);
        self.trace_among(Candidates::All, ray, range, &work)
    }

    /// [`Scene::trace`] for a ray that can meet no others than these, counted,
    /// and with or without what changes nothing.
    pub(crate) fn trace_among(
        &self,
        candidates: Candidates,
        ray: &Ray,
        range: Interval,
        work: &Work<impl Meter>,
    ) -> Rgb {
        let SceneParts { world, lights, convention, shadows, background, show, .. } = &self.0;
        let Some(hit) = world.intersect_among(candidates, ray, range, &work.meter) else {
            return *background;
        };
        let shade = || {
            let (convention, shadows) = (*convention, *shadows);
            Lighting { world, lights, convention, shadows }.shade(ray, &hit, work)
        };
        match (show.color(ray, &hit), work.skips()) {
            (Some(color), true) => color,
            (shown, _) => {
                let shaded = shade();
                shown.unwrap_or(shaded)
            }
        }
    }
}
