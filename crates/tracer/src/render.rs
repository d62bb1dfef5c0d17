//! `render`: the lecture's two loops over the pixels, on all threads.

mod adaptive;
mod edges;
mod film;
mod filter;
mod objects;
mod pattern;
mod samples;

pub use edges::{Around, edges};
pub use filter::Filter;
pub use objects::objects_seen;
pub use samples::{Sampler, Samples};

use std::ops::{Add, Mul};

use rayon::prelude::*;

use crate::fault::{Fault, seeded};
use crate::meter::{Counter, Event, Meter, Stats, Unmetered, Work};
use crate::plan::Candidates;
use crate::scene::Look;
use crate::{Interval, LinearImage, Plan, Rgb, Scene, Size, Skipping};
use film::Spread;
use pattern::spot;

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

/// The picture, and the meters of those who made it.
fn picture<M: Meter + Default + Send>(scene: &Scene, plan: &Plan) -> (LinearImage, Vec<M>) {
    let (picture, meters) = match scene.error() {
        Some(error) => adaptive::picture(scene, plan, error),
        None if scene.filter() == Filter::BOX => boxed(scene, plan),
        None => filtered(scene, plan),
    };
    (stored(picture), meters)
}

/// The picture as it is stored, or what a fault makes of it.
fn stored(picture: LinearImage) -> LinearImage {
    let Size { width, height } = picture.size();
    let is_flipped = seeded(Fault::RowOrderFlipped);
    let columns = width - u32::from(seeded(Fault::LastColumnLost));
    let rows = height - u32::from(seeded(Fault::LastRowLost));
    if !is_flipped && (columns, rows) == (width, height) {
        return picture;
    }
    LinearImage::from_fn(picture.size(), |x, y| {
        let from = if is_flipped { height - 1 - y } else { y };
        picture.get(x, from).filter(|_| x < columns && y < rows).unwrap_or(Rgb::BLACK)
    })
}

/// The picture whose pixels are the means of their own samples.
fn boxed<M: Meter + Default + Send>(scene: &Scene, plan: &Plan) -> (LinearImage, Vec<M>) {
    let Size { width, height } = scene.size();
    let mean = Mean::of_scene(scene);
    let nothing = mean.of(|_| scene.background());
    let rows: Vec<(Vec<Rgb>, M)> = (0..height)
        .into_par_iter()
        .map(|y| {
            // The lecture's row 0 is the lowest, the picture's the highest.
            let j = height - 1 - y;
            let work = Work::new(M::default(), plan.skipping(), scene.lights().len());
            let pixel = |i| match begun(plan, (i, j), &work) {
                Candidates::None => nothing,
                candidates => mean
                    .of(|k| sample(scene, candidates, spot(scene, (i, j), k).window, &work).color),
            };
            ((0..width).map(pixel).collect(), work.meter)
        })
        .collect();
    let picture = LinearImage::from_fn(scene.size(), |x, y| rows[y as usize].0[x as usize]);
    (picture, rows.into_iter().map(|(_, meter)| meter).collect())
}

/// The picture whose pixels are weighted means of the samples around.
fn filtered<M: Meter + Default + Send>(scene: &Scene, plan: &Plan) -> (LinearImage, Vec<M>) {
    // Exposed in the end.
    let mean = Mean { exposure: 1.0, ..Mean::of_scene(scene) };
    let spread = |at, color: &dyn Fn([f64; 2]) -> Rgb| {
        let samples = 0..scene.samples().samples_per_pixel();
        let spots = samples.map(|k| spot(scene, at, k));
        let seen: Vec<_> = spots.map(|spot| (color(spot.window), spot.offset)).collect();
        Spread::of_samples(scene.filter(), mean, &seen)
    };
    let nothing = |at| spread(at, &|_| scene.background());
    // On a grid, every pixel that shows nothing shows the same.
    let on_grid = scene.samples().sampler() == Sampler::Grid;
    let same_nothing = on_grid.then(|| nothing((0, 0)));
    film::picture(scene, |j| {
        let work = Work::new(M::default(), plan.skipping(), scene.lights().len());
        let pixel = |i| match (begun(plan, (i, j), &work), &same_nothing) {
            (Candidates::None, Some(same)) => same.clone(),
            (Candidates::None, None) => nothing((i, j)),
            (candidates, _) => {
                spread((i, j), &|window| sample(scene, candidates, window, &work).color)
            }
        };
        ((0..scene.size().width).map(pixel).collect(), work.meter)
    })
}

/// Who may be seen in a pixel that is about to be made, which is counted.
fn begun(plan: &Plan, (i, j): (u32, u32), work: &Work<impl Meter>) -> Candidates {
    let candidates = plan.candidates(i, j);
    let is_nothing = candidates == Candidates::None;
    work.count(if is_nothing { Event::SkippedPixel } else { Event::Pixel });
    candidates
}

/// What the eye ray through this point of the window sees.
fn sample(
    scene: &Scene,
    candidates: Candidates,
    [a, b]: [f64; 2],
    work: &Work<impl Meter>,
) -> Look {
    work.count(Event::EyeRay);
    scene.trace_among(candidates, &scene.camera().ray(a, b), Interval::AHEAD, work)
}

/// How the mean of a pixel's samples is taken.
#[derive(Debug, Clone, Copy)]
struct Mean {
    samples: Samples,
    exposure: f64,
}

impl Mean {
    /// That of this scene, exposed.
    fn of_scene(scene: &Scene) -> Self {
        Self { samples: scene.samples(), exposure: scene.exposure() }
    }

    /// The mean of a term of each sample, exposed. Those of a grid are summed
    /// by rows, so that mirrored pictures have mirrored bits.
    fn of<T>(self, term: impl Fn(u32) -> T) -> T
    where
        T: Copy + Default + Add<Output = T> + Mul<f64, Output = T>,
    {
        let n = self.samples.samples_per_pixel();
        let is_lost = |k: u32| seeded(Fault::SampleLost) && 1 < n && k == n - 1;
        let term = |k: u32| if is_lost(k) { T::default() } else { term(k) };
        let sum = if self.samples.sampler() == Sampler::Grid {
            let side = self.samples.side();
            mirrored_sum(side, |row| mirrored_sum(side, |column| term(row * side + column)))
        } else {
            (0..n).fold(T::default(), |sum, k| sum + term(k))
        };
        sum * (self.exposure / f64::from(n))
    }
}

/// The sum of `term(0)` to `term(n - 1)`, taken from both ends inwards, so
/// that reversing the terms gives the same bits and a mirrored picture stays
/// an exact mirror.
fn mirrored_sum<T: Copy + Default + Add<Output = T>>(n: u32, term: impl Fn(u32) -> T) -> T {
    let mut sum = T::default();
    for k in 0..n / 2 {
        sum = sum + (term(k) + term(n - 1 - k));
    }
    if n % 2 == 1 {
        sum = sum + term(n / 2);
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sum_of_reversed_terms_has_the_same_bits() {
        for n in [1_u32, 2, 3, 8, 9] {
            let term = |k: u32| Rgb::WHITE * (1.0 / f64::from(3 * k + 1));
            assert_eq!(mirrored_sum(n, term), mirrored_sum(n, |k| term(n - 1 - k)));
        }
    }
}
