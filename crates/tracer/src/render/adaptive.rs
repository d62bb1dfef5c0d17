//! Samples where the error is: one in the middle of every pixel, and more in
//! those whose neighborhood differs, until the picture's root mean square error
//! is estimated to be small enough.
//!
//! A pixel that is not alike all around ([`survey`]), or where something so
//! narrow may be that no middle sees it ([`narrow`]), is cut into cells
//! ([`begun`], [`pixel`]). What is found at its border may be unlike what the pixel beside it
//! shows, as where a wire passes between middles: then that one is cut as well,
//! and so on along the wire.
//!
//! What is decided follows from what was looked at and nothing else, and in a
//! mirrored picture is decided alike.

mod begun;
mod narrow;
mod pixel;
mod place;
mod survey;

use std::collections::BTreeMap;

use rayon::prelude::*;

use super::film::{self, Splat, Spread};
use super::filter::Filter;
use super::{begun, sample};
use crate::meter::{Event, Meter, Work};
use crate::plan::Candidates;
use crate::scene::Look;
use crate::{LinearImage, Plan, Rgb, Scene, Size};
use begun::Begun;
use narrow::Narrow;
use pixel::{Known, Pixel};
use place::Place;
use survey::Survey;

/// How far above what is asked of the whole picture the error of one pixel may
/// be estimated: most pixels are calm and have next to none, but a few should
/// not be let go because they are few.
const WORST: f64 = 4.0;
/// How much of the mean square error is left to pixels that are not cut.
const CALM_PART: f64 = 0.25;
/// Pixels that are made by one thread at a time.
const BATCH: usize = 16;

/// The picture, its root mean square error estimated to be at most `error`, and
/// the meters of those who made it.
pub(super) fn picture<M: Meter + Default + Send>(
    scene: &Scene,
    plan: &Plan,
    error: f64,
) -> (LinearImage, Vec<M>) {
    let Size { width, height } = scene.size();
    let work = || Work::new(M::default(), plan.skipping(), scene.lights().len());
    let looks: Vec<(Vec<Look>, M)> = (0..height)
        .into_par_iter()
        .map(|j| {
            let work = work();
            let looks = (0..width).map(|i| survey(scene, plan, (i, j), &work)).collect();
            (looks, work.meter)
        })
        .collect();
    let (looks, mut meters): (Vec<_>, Vec<_>) = looks.into_iter().unzip();
    let survey = Survey { looks };
    // What the picture is multiplied by need not be found out as exactly, and
    // what a sharp filter makes count more must be known better.
    let peak = scene.filter().density(0.0);
    let asked = error / scene.exposure() / (peak * peak).max(1.0);
    let narrow = Narrow::of(scene, asked);
    let pixels: Vec<_> = (0..height).flat_map(|j| (0..width).map(move |i| (i, j))).collect();
    let is_cut = |at: &&At| {
        !narrow.seen_in(**at).is_empty() || !survey.is_calm(**at, CALM_PART.sqrt() * asked)
    };
    let mut todo: Vec<At> = pixels.par_iter().filter(is_cut).copied().collect();
    let few = (1.0 - CALM_PART) * pixels.len() as f64 / todo.len().max(1) as f64;
    let allowed = asked * few.sqrt().min(WORST);
    let mut begun: BTreeMap<At, Begun> = BTreeMap::new();
    let mut cut: BTreeMap<At, Spread> = BTreeMap::new();
    while !todo.is_empty() {
        let mut these = Vec::new();
        // All are begun before any is cut further: cells at a border are held
        // against those beyond it.
        while !todo.is_empty() {
            let made = in_batches(&todo, &mut meters, &work, |at, work| {
                let made = match plan.candidates(at.0, at.1) {
                    Candidates::None => Begun::nothing(scene, allowed),
                    candidates => {
                        let begun = Begun::new(scene, at, candidates, allowed, work);
                        if cut.is_empty() {
                            begun
                        } else {
                            begun.searched(scene, at, candidates, allowed, work)
                        }
                    }
                };
                let unlike = made.unlike(&survey, at);
                (made, unlike)
            });
            let unlike = taken(&todo, made, &mut begun);
            these.append(&mut todo);
            todo = unlike.into_iter().filter(|at| !begun.contains_key(at)).collect();
        }
        let known = Known { scene, survey: &survey, narrow: &narrow, begun: &begun };
        let made = in_batches(&these, &mut meters, &work, |at, work| {
            match (plan.candidates(at.0, at.1), begun.get(&at)) {
                (Candidates::None, _) | (_, None) => (survey.calm(at, scene.filter()), Vec::new()),
                (candidates, Some(begun)) => {
                    work.count(Event::RefinedPixel);
                    Pixel::new(&known, at, begun).refined(candidates, allowed, work)
                }
            }
        });
        todo = taken(&these, made, &mut cut);
    }
    let spread = |i: u32, j: u32| match cut.get(&(i, j)) {
        Some(spread) => spread.clone(),
        None => survey.calm((i, j), scene.filter()),
    };
    let picture = if scene.filter() == Filter::BOX {
        let pixel = |x, y| spread(x, height - 1 - y).mean * scene.exposure();
        LinearImage::from_fn(scene.size(), pixel)
    } else {
        film::picture(scene, |j| ((0..width).map(|i| spread(i, j)).collect(), ())).0
    };
    (picture, meters)
}

/// Where a pixel is: its column and its row, 0 at the bottom.
type At = (u32, u32);

/// What is made of each pixel, with the pixels around that it is unlike.
type Made<T> = Vec<(T, Vec<At>)>;

/// Makes something of each pixel, on all threads; adds the meters of those who
/// made it.
fn in_batches<T: Send, M: Meter + Send>(
    pixels: &[At],
    meters: &mut Vec<M>,
    work: &(impl Fn() -> Work<M> + Sync),
    make: impl Fn(At, &Work<M>) -> (T, Vec<At>) + Sync,
) -> Made<T> {
    let batches: Vec<(Made<T>, M)> = pixels
        .par_chunks(BATCH)
        .map(|batch| {
            let work = work();
            let made = batch.iter().map(|&at| make(at, &work)).collect();
            (made, work.meter)
        })
        .collect();
    let mut all = Vec::with_capacity(pixels.len());
    for (mut made, meter) in batches {
        all.append(&mut made);
        meters.push(meter);
    }
    all
}

/// Takes what was made of each pixel, and returns those around, in order.
fn taken<T>(pixels: &[At], made: Made<T>, into: &mut BTreeMap<At, T>) -> Vec<At> {
    let mut unlike = Vec::new();
    for (at, (made, mut others)) in pixels.iter().zip(made) {
        into.insert(*at, made);
        unlike.append(&mut others);
    }
    unlike.sort_unstable();
    unlike.dedup();
    unlike
}

/// The look at the middle of a pixel.
fn survey(scene: &Scene, plan: &Plan, (i, j): (u32, u32), work: &Work<impl Meter>) -> Look {
    match begun(plan, (i, j), work) {
        Candidates::None => Look::nothing(scene.background()),
        candidates => sample(scene, candidates, Place::PIXEL.window(scene, (i, j)), work),
    }
}

impl Survey {
    /// What a pixel gives to those around it that is all of the color in its
    /// middle.
    fn calm(&self, at: (u32, u32), filter: Filter) -> Spread {
        let color = self.beside(at, (0, 0)).map_or(Rgb::BLACK, |look| look.color);
        Place::PIXEL.alone(color, filter)
    }
}

impl Place {
    /// What a part of a pixel gives to those around, if it is all of one color.
    fn splat(self, filter: Filter, color: Rgb, (right, up): (f64, f64)) -> Splat {
        let ([x0, x1], [y0, y1]) = self.sides();
        let weight = filter.share(x0 - right, x1 - right) * filter.share(y0 - up, y1 - up);
        Splat::new(color, weight)
    }

    /// The same of a whole pixel.
    fn alone(self, color: Rgb, filter: Filter) -> Spread {
        Spread::new(filter, color, |right, up| self.splat(filter, color, (right, up)))
    }
}

#[cfg(test)]
mod tests;
