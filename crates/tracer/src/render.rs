//! `render`: the lecture's two loops over the pixels, on all threads.

mod adaptive;

use rayon::prelude::*;

use crate::meter::{Counter, Event, Meter, Stats, Unmetered, Work};
use crate::plan::Candidates;
use crate::refused::refuse_unless;
use crate::{Interval, LinearImage, Plan, Refused, Rgb, Scene, Size, Skipping, pixel_center};

/// A regular grid of samples in each pixel: `side` by `side`, each in the
/// middle of its cell. One sample is the lecture's pixel center.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct SampleGrid {
    side: u32,
}

impl SampleGrid {
    /// One sample, in the middle of the pixel.
    pub const ONE: Self = Self { side: 1 };

    /// The most samples in a pixel.
    pub const MAX: u32 = 4_096;

    /// The grid of this many samples a pixel, a square number.
    ///
    /// # Errors
    /// Refuses (as `samples_per_pixel`) other numbers, 0, and absurdly many.
    pub fn new(samples_per_pixel: u32) -> Result<Self, Refused> {
        let side = samples_per_pixel.isqrt();
        let accepted =
            (1..=Self::MAX).contains(&samples_per_pixel) && side * side == samples_per_pixel;
        Refused::unless([refuse_unless(
            accepted,
            "samples_per_pixel",
            format!("a square number from 1 to {}, such as 1, 4, 9 or 16", Self::MAX),
            || samples_per_pixel.to_string(),
        )])?;
        Ok(Self { side })
    }

    /// How many samples a pixel has.
    pub fn samples_per_pixel(self) -> u32 {
        self.side * self.side
    }
}

/// Renders the scene. The picture's bits depend on the scene alone, not on
/// the number of threads; rows are shared out among those of rayon's current
/// pool.
pub fn render(scene: &Scene) -> LinearImage {
    picture::<Unmetered>(scene, &Plan::new(scene, Skipping::On)).0
}

/// [`render`] by a plan for this scene, and how often everything happened.
///
/// The picture is the same for every plan of this scene; a plan of another one
/// says nothing about it.
pub fn render_counted(scene: &Scene, plan: &Plan) -> (LinearImage, Stats) {
    let (picture, counters) = picture::<Counter>(scene, plan);
    let mut stats = Stats::default();
    for counter in counters {
        stats += Stats::from(counter);
    }
    (picture, stats)
}

/// The picture, and a meter for each row.
fn picture<M: Meter + Default + Send>(scene: &Scene, plan: &Plan) -> (LinearImage, Vec<M>) {
    if let Some(error) = scene.error() {
        return adaptive::picture(scene, plan, error);
    }
    let Size { width, height } = scene.size();
    let nothing = mean(scene, |_, _| scene.background());
    let rows: Vec<(Vec<Rgb>, M)> = (0..height)
        .into_par_iter()
        .map(|y| {
            // The lecture's row 0 is the lowest, the picture's the highest.
            let j = height - 1 - y;
            let work = Work::new(M::default(), plan.skipping(), scene.lights().len());
            let pixel = |i| {
                let candidates = plan.candidates(i, j);
                if candidates == Candidates::None {
                    work.count(Event::SkippedPixel);
                    return nothing;
                }
                work.count(Event::Pixel);
                pixel(scene, candidates, (i, j), &work)
            };
            ((0..width).map(pixel).collect(), work.meter)
        })
        .collect();
    let picture = LinearImage::from_fn(scene.size(), |x, y| rows[y as usize].0[x as usize]);
    (picture, rows.into_iter().map(|(_, meter)| meter).collect())
}

/// The mean of the samples of pixel `(i, j)`, row 0 at the bottom.
fn pixel(
    scene: &Scene,
    candidates: Candidates,
    (i, j): (u32, u32),
    work: &Work<impl Meter>,
) -> Rgb {
    let Size { width, height } = scene.size();
    let SampleGrid { side } = scene.samples();
    let camera = scene.camera();
    mean(scene, |column, row| {
        let b = pixel_center(j * side + row, height * side, camera.view_height());
        let a = pixel_center(i * side + column, width * side, camera.view_width());
        work.count(Event::EyeRay);
        scene.trace_among(candidates, &camera.ray(a, b), Interval::AHEAD, work).color
    })
}

/// The mean of a pixel's samples, exposed.
fn mean(scene: &Scene, sample: impl Fn(u32, u32) -> Rgb) -> Rgb {
    let SampleGrid { side } = scene.samples();
    let sum = mirrored_sum(side, |row| mirrored_sum(side, |column| sample(column, row)));
    sum * (scene.exposure() / f64::from(side * side))
}

/// The sum of `term(0)` to `term(n - 1)`, taken from both ends inwards, so
/// that reversing the terms gives the same bits and a mirrored picture stays
/// an exact mirror.
fn mirrored_sum(n: u32, term: impl Fn(u32) -> Rgb) -> Rgb {
    let mut sum = Rgb::BLACK;
    for k in 0..n / 2 {
        sum += term(k) + term(n - 1 - k);
    }
    if n % 2 == 1 {
        sum += term(n / 2);
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn grids_are_square() {
        for (n, accepted) in [(0, false), (1, true), (2, false), (4, true), (4096, true)] {
            assert_eq!(SampleGrid::new(n).is_ok(), accepted, "{n}");
        }
        assert!(SampleGrid::new(4097).is_err() && SampleGrid::new(u32::MAX).is_err());
        assert_eq!(SampleGrid::new(9).unwrap().samples_per_pixel(), 9);
    }

    #[test]
    fn a_sum_of_reversed_terms_has_the_same_bits() {
        for n in [1_u32, 2, 3, 8, 9] {
            let term = |k: u32| Rgb::WHITE * (1.0 / f64::from(3 * k + 1));
            assert_eq!(mirrored_sum(n, term), mirrored_sum(n, |k| term(n - 1 - k)));
        }
    }
}
