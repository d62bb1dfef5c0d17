//! `Spread`: the light of one pixel's samples, shared out among the pixels
//! around it by a filter.

use std::collections::VecDeque;
use std::ops::Add;

use rayon::prelude::*;

use super::filter::Filter;
use super::{Mean, mirrored_sum};
use crate::{LinearImage, Rgb, Scene, Size};

/// Light, and how much of all light that is.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Splat {
    light: Rgb,
    weight: f64,
}

impl Splat {
    /// A color that counts this much.
    pub(super) fn new(color: Rgb, weight: f64) -> Self {
        Self { light: color * weight, weight }
    }
}

impl Add for Splat {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self { light: self.light + other.light, weight: self.weight + other.weight }
    }
}

/// What a pixel's samples give to those around it.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Spread {
    /// The mean of its samples.
    pub(super) mean: Rgb,
    /// For each pixel in reach, by rows from the lower left, itself in the
    /// middle; none for a box, of which the mean is all.
    pub(super) splats: Vec<Splat>,
}

impl Spread {
    /// `to(right, up)` is what a pixel so far away gets.
    pub(super) fn new(filter: Filter, mean: Rgb, to: impl Fn(f64, f64) -> Splat) -> Self {
        if filter == Filter::BOX {
            return Self { mean, splats: Vec::new() };
        }
        let reach = filter.reach();
        let steps = || (0..=2 * reach).map(|k| f64::from(k) - f64::from(reach));
        let splats = steps().flat_map(|up| steps().map(move |right| (right, up)));
        Self { mean, splats: splats.map(|(right, up)| to(right, up)).collect() }
    }

    /// How one that is `Mean` over samples is shared out: `sample(k)` is a
    /// color and how far from the pixel's middle it was seen.
    pub(super) fn of_samples(filter: Filter, mean: Mean, seen: &[(Rgb, [f64; 2])]) -> Self {
        let own = mean.of(|k| seen[k as usize].0);
        Self::new(filter, own, |right, up| {
            mean.of(|k| {
                let (color, [x, y]) = seen[k as usize];
                Splat::new(color, filter.density(x - right) * filter.density(y - up))
            })
        })
    }
}

impl std::ops::Mul<f64> for Splat {
    type Output = Self;
    fn mul(self, s: f64) -> Self {
        Self { light: self.light * s, weight: self.weight * s }
    }
}

/// Rows that are made at a time: enough for every thread, and all that is kept
/// of a picture that is not done.
const BAND: u32 = 64;

/// The picture whose row `j`, 0 at the bottom, is spread as `row(j)` says, and
/// who made each row.
pub(super) fn picture<M: Send>(
    scene: &Scene,
    row: impl Fn(u32) -> (Vec<Spread>, M) + Sync,
) -> (LinearImage, Vec<M>) {
    let (Size { width, height }, reach) = (scene.size(), scene.filter().reach());
    let mut meters = Vec::new();
    let mut kept: VecDeque<Vec<Spread>> = VecDeque::new();
    let (mut first_kept, mut next) = (0, 0);
    let mut lines: Vec<Vec<Rgb>> = Vec::new();
    for first in (0..height).step_by(BAND as usize) {
        let end = (first + BAND).min(height);
        let made_up_to = (end + reach).min(height);
        let made: Vec<_> = (next..made_up_to).into_par_iter().map(&row).collect();
        for (spread, meter) in made {
            kept.push_back(spread);
            meters.push(meter);
        }
        next = made_up_to;
        let around = Around { rows: &kept, first: first_kept, reach };
        let line = |j| (0..width).map(|i| around.pixel(i, j) * scene.exposure()).collect();
        lines.par_extend((first..end).into_par_iter().map(line));
        while first_kept + reach < end && !kept.is_empty() {
            kept.pop_front();
            first_kept += 1;
        }
    }
    let pixel = |x: u32, y: u32| lines[(height - 1 - y) as usize][x as usize];
    (LinearImage::from_fn(scene.size(), pixel), meters)
}

/// The rows that a pixel gets light from.
struct Around<'a> {
    rows: &'a VecDeque<Vec<Spread>>,
    /// The number of the first of them.
    first: u32,
    reach: u32,
}

impl Around<'_> {
    /// What pixel `(i, j)` gets from all around.
    ///
    /// The weights of random samples add up to 1 only on average, and beyond
    /// the picture's border there are none. What lacks, or is too much, is taken
    /// to be of the pixel's own mean: so a flat part of a picture stays flat,
    /// and there is nothing to divide by. Sums are taken from both ends inwards,
    /// so that mirrored pictures have mirrored bits.
    fn pixel(&self, i: u32, j: u32) -> Rgb {
        let across = 2 * self.reach + 1;
        let all = mirrored_sum(across, |up| {
            mirrored_sum(across, |right| self.from((i, j), (right, up)).unwrap_or_default())
        });
        let own = self.spread(i, j).map_or(Rgb::BLACK, |own| own.mean);
        all.light + own * (1.0 - all.weight)
    }

    /// What a pixel gets from the one that is so far right and up of the lowest,
    /// leftmost one in reach; `None` if that is not in the picture.
    fn from(&self, (i, j): (u32, u32), (right, up): (u32, u32)) -> Option<Splat> {
        let (i, j) = ((i + right).checked_sub(self.reach)?, (j + up).checked_sub(self.reach)?);
        // Seen from there, this one is on the other side.
        let across = 2 * self.reach + 1;
        let here = (across - 1 - up) * across + (across - 1 - right);
        self.spread(i, j)?.splats.get(here as usize).copied()
    }

    fn spread(&self, i: u32, j: u32) -> Option<&Spread> {
        self.rows.get(j.checked_sub(self.first)? as usize)?.get(i as usize)
    }
}
