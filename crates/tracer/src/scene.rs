//! `Scene`: everything a picture is made from, checked.

use crate::fault::{Fault, seeded};
use crate::meter::{Meter, Unmetered, Work};
use crate::plan::Candidates;
use crate::refused::{color, not_negative, refuse_unless};
use crate::shading::Lighting;
use crate::specular;
use crate::{
    Camera, Convention, Filter, Group, Hit, Interval, Light, ObjectId, Ray, Refused, Rgb, Samples,
    Show, Size, Skipping, UnitVec,
};

/// The parts of a scene, before they are checked together.
#[derive(Debug, Clone, PartialEq)]
pub struct SceneParts {
    /// Makes the eye rays.
    pub camera: Camera,
    /// The picture's size, the lecture's `nx` and `ny`.
    pub size: Size,
    /// Where in a pixel its samples are.
    pub samples: Samples,
    /// How much each sample counts for the pixels around it.
    pub filter: Filter,
    /// If there is one: samples are added where a pixel's neighborhood differs,
    /// until the error of every channel is estimated to be at most this, in a
    /// picture that is shown as it is. Then `samples` must be one a pixel.
    pub error: Option<f64>,
    /// All surfaces.
    pub world: Group,
    /// All lights.
    pub lights: Vec<Light>,
    /// Which shading formulas hold.
    pub convention: Convention,
    /// Whether lights cast shadows.
    pub shadows: bool,
    /// How many times an eye ray may be reflected or refracted: what would be
    /// seen beyond is black.
    pub bounces: u32,
    /// What a ray that hits nothing sees.
    pub background: Rgb,
    /// Multiplies every pixel of a shaded picture, background included.
    pub exposure: f64,
    /// What the picture is of.
    pub show: Show,
}

/// What an eye ray saw.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Look {
    /// The color, not yet exposed.
    pub(crate) color: Rgb,
    /// Which object, and its normal there.
    pub(crate) surface: Option<(ObjectId, UnitVec)>,
    /// For each light, up to 64 of them, whether something is in its way. Of a
    /// surface that sends rays on a number that stands for that, and for all
    /// that they saw.
    pub(crate) shadows: u64,
}

impl Look {
    /// At the background.
    pub(crate) fn nothing(background: Rgb) -> Self {
        Self { color: background, surface: None, shadows: 0 }
    }

    /// At a hit that shows this color, whatever the light.
    fn flat(color: Rgb, hit: &Hit) -> Self {
        Self { color, surface: Some((hit.object, hit.geometric_normal)), shadows: 0 }
    }
}

/// A scene that can be rendered; see [`crate::render`].
#[derive(Debug, Clone, PartialEq)]
pub struct Scene(SceneParts);

impl Scene {
    /// The largest width or height of a picture in pixels.
    pub const MAX_SIDE: u32 = 16_384;

    /// The largest number of pixels of a picture.
    pub const MAX_PIXELS: u64 = 1 << 26;

    /// The smallest and largest `error`.
    pub const ERRORS: std::ops::RangeInclusive<f64> = 1e-6..=1.0;

    /// The largest number of bounces. A ray may become two at each: up to 2^17 in
    /// all.
    pub const MAX_BOUNCES: u32 = 16;

    /// The bounces of a scene that does not say.
    pub const DEFAULT_BOUNCES: u32 = 5;

    /// The largest number of samples of a picture: its pixels times samples a
    /// pixel.
    pub const MAX_SAMPLES: u64 = 1 << 32;

    /// The scene of these parts.
    ///
    /// # Errors
    /// Refuses (as `image`, `samples_per_pixel`) a picture without pixels or with
    /// absurdly many of them or of samples, (as `error`) one that is out of
    /// range or beside several samples a pixel, (as `bounces`) more than there may be, (as `background`, `exposure`) numbers that are negative or not finite, and
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
            parts.error.and_then(|error| {
                refuse_unless(
                    Self::ERRORS.contains(&error) && parts.samples == Samples::ONE,
                    "error",
                    format!(
                        "a number from {:e} to {}, and one sample on a grid to start from",
                        Self::ERRORS.start(),
                        Self::ERRORS.end()
                    ),
                    || format!("{error} with {}", parts.samples.words()),
                )
            }),
            refuse_unless(
                parts.bounces <= Self::MAX_BOUNCES,
                "bounces",
                format!("a whole number from 0 to {}", Self::MAX_BOUNCES),
                || parts.bounces.to_string(),
            ),
            color("background", parts.background),
            not_negative("exposure", parts.exposure),
            refuse_unless(depth_is_a_range, "show", "a depth range with 0 <= near < far", || {
                format!("{:?}", parts.show)
            }),
        ])?;
        Ok(Self(parts))
    }

    /// What it was made from.
    pub fn parts(&self) -> &SceneParts {
        &self.0
    }

    /// The picture's size.
    pub fn size(&self) -> Size {
        self.0.size
    }

    /// Where in a pixel its samples are.
    pub fn samples(&self) -> Samples {
        self.0.samples
    }

    /// How much each sample counts for the pixels around it.
    pub fn filter(&self) -> Filter {
        if seeded(Fault::FilterIgnored) { Filter::BOX } else { self.0.filter }
    }

    /// The error up to which samples are added, if they are.
    pub fn error(&self) -> Option<f64> {
        self.0.error
    }

    /// The same scene, with samples added up to this error, in place of those
    /// that it has.
    ///
    /// # Errors
    /// Refuses (as `error`) one that is out of range.
    pub fn with_error(&self, error: f64) -> Result<Self, Refused> {
        Self::new(SceneParts { samples: Samples::ONE, error: Some(error), ..self.0.clone() })
    }

    /// The same scene with these samples, and none added.
    ///
    /// # Errors
    /// As [`Scene::new`].
    pub fn with_samples(&self, samples: Samples) -> Result<Self, Refused> {
        Self::new(SceneParts { samples, error: None, ..self.0.clone() })
    }

    /// The same scene seen through this filter.
    ///
    /// # Errors
    /// As [`Scene::new`].
    pub fn with_filter(&self, filter: Filter) -> Result<Self, Refused> {
        Self::new(SceneParts { filter, ..self.0.clone() })
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

    /// How many times an eye ray may be reflected or refracted.
    pub(crate) fn bounces(&self) -> u32 {
        self.0.bounces.saturating_sub(u32::from(seeded(Fault::OneBounceTooFew)))
    }

    /// What shading needs of it.
    pub(crate) fn lighting(&self) -> Lighting<'_> {
        let SceneParts { world, lights, convention, shadows, .. } = &self.0;
        Lighting { world, lights, convention: *convention, shadows: *shadows }
    }

    /// What the picture is of.
    pub(crate) fn show(&self) -> Show {
        self.0.show
    }

    /// What a ray that hits nothing sees.
    pub(crate) fn background(&self) -> Rgb {
        if seeded(Fault::BackgroundIgnored) { Rgb::BLACK } else { self.0.background }
    }

    /// What the whole picture is multiplied by: `exposure` where the scene is
    /// shaded, 1 for every other kind of picture.
    pub fn exposure(&self) -> f64 {
        let is_exposed = self.0.show == Show::Shaded && !seeded(Fault::ExposureIgnored);
        if is_exposed { self.0.exposure } else { 1.0 }
    }

    /// The lecture's `Scene.trace(ray, tMin, tMax)`: the color of the closest
    /// surface the ray hits inside `range`, else the background. Exposure is
    /// not applied.
    ///
    /// Source: the slide with the loop over pixels, eye ray generation and scene
    /// intersection.
    pub fn trace(&self, ray: &Ray, range: Interval) -> Rgb {
        let work = Work::new(Unmetered, Skipping::On, 0);
        self.trace_among(Candidates::All, ray, range, &work).color
    }

    /// [`Scene::trace`] for a ray that can meet no others than these, counted,
    /// and with or without what changes nothing.
    pub(crate) fn trace_among(
        &self,
        candidates: Candidates,
        ray: &Ray,
        range: Interval,
        work: &Work<impl Meter>,
    ) -> Look {
        let SceneParts { world, show, .. } = &self.0;
        let Some(hit) = world.intersect_among(candidates, ray, range, &work.meter) else {
            return Look::nothing(self.background());
        };
        match (show.color(ray, &hit), work.skips()) {
            (Some(color), true) => Look::flat(color, &hit),
            (shown, _) => {
                let shaded = self.look(ray, &hit, self.bounces(), work);
                shown.map_or(shaded, |color| Look::flat(color, &hit))
            }
        }
    }

    /// What is seen of a hit along `ray`, which may be sent on `left` times more.
    #[inline]
    pub(crate) fn look(&self, ray: &Ray, hit: &Hit, left: u32, work: &Work<impl Meter>) -> Look {
        let (color, shadows) = if hit.material.sends_rays() {
            specular::shade(self, ray, hit, left, work)
        } else {
            self.lighting().shade(ray, hit, work)
        };
        Look { shadows, ..Look::flat(color, hit) }
    }
}
