//! Samples where the error is: one in the middle of every pixel, and more in
//! those whose neighborhood differs, until each one's error is estimated to be
//! small enough.
//!
//! A pixel that is not alike all around is cut into 4 by 4 cells, and cells
//! that differ from those beside them in four again, the worst first. If a
//! straight edge runs through a cell, anywhere in it, a sample anywhere in it
//! is off by `contrast / sqrt(6)` in the root mean square; that is each cell's
//! estimate, and those of a pixel add up as independent errors do. To be
//! independent where an edge follows a row or column, samples are not in the
//! middle of their cells: [`in_cell`] spreads them.
//!
//! What is decided for a pixel depends on the looks around it and nothing
//! else, and in a mirrored picture is decided alike.

use rayon::prelude::*;

use super::{begun, sample};
use crate::meter::{Event, Meter, Work};
use crate::plan::Candidates;
use crate::scene::Look;
use crate::{LinearImage, Plan, Rgb, Scene, Size};

/// Cells are not cut below a 64th of a pixel: 4096 in all, as many as a grid
/// may have samples.
const DEEPEST: u32 = 6;
/// The mean square error of a cell that an edge of contrast 1 runs through: of
/// `p (1 - p)`, where each part `p` of the cell is as likely.
const VARIANCE: f64 = 1.0 / 6.0;
/// The cosine beyond which two normals are alike: about 25 degrees.
const ALIKE: f64 = 0.9;

/// The picture, every pixel's error estimated to be at most `error`, and the
/// meters of those who made it.
pub(super) fn picture<M: Meter + Default + Send>(
    scene: &Scene,
    plan: &Plan,
    error: f64,
) -> (LinearImage, Vec<M>) {
    let Size { width, height } = scene.size();
    let work = || Work::new(M::default(), plan.skipping(), scene.lights().len());
    let survey: Vec<(Vec<Look>, M)> = (0..height)
        .into_par_iter()
        .map(|j| {
            let work = work();
            let looks = (0..width).map(|i| survey(scene, plan, (i, j), &work)).collect();
            (looks, work.meter)
        })
        .collect();
    let (looks, mut meters): (Vec<_>, Vec<_>) = survey.into_iter().unzip();
    let survey = Survey { looks };
    // What the picture is multiplied by need not be found out as exactly.
    let allowed = error / scene.exposure();
    let rows: Vec<(Vec<Rgb>, M)> = (0..height)
        .into_par_iter()
        .map(|y| {
            // The lecture's row 0 is the lowest, the picture's the highest.
            let j = height - 1 - y;
            let work = work();
            let pixel = |i| {
                let candidates = plan.candidates(i, j);
                if candidates == Candidates::None || survey.is_calm((i, j), allowed) {
                    return survey.looks[j as usize][i as usize].color;
                }
                work.count(Event::RefinedPixel);
                let mut pixel = Pixel { scene, survey: &survey, at: (i, j), cells: Vec::new() };
                pixel.refined(candidates, allowed, &work)
            };
            let row = (0..width).map(|i| pixel(i) * scene.exposure()).collect();
            (row, work.meter)
        })
        .collect();
    let picture = LinearImage::from_fn(scene.size(), |x, y| rows[y as usize].0[x as usize]);
    meters.extend(rows.into_iter().map(|(_, meter)| meter));
    (picture, meters)
}

/// The look at the middle of a pixel.
fn survey(scene: &Scene, plan: &Plan, (i, j): (u32, u32), work: &Work<impl Meter>) -> Look {
    match begun(plan, (i, j), work) {
        Candidates::None => Look::nothing(scene.background()),
        candidates => look(scene, candidates, (i, j), (0, 0, 0), work),
    }
}

/// The look at the sample of a cell of pixel `(i, j)`.
fn look(
    scene: &Scene,
    candidates: Candidates,
    (i, j): (u32, u32),
    (level, x, y): Place,
    work: &Work<impl Meter>,
) -> Look {
    let (Size { width, height }, camera) = (scene.size(), scene.camera());
    let (right, up) = (in_cell(level, x, y, SPREAD[0]), in_cell(level, y, x, SPREAD[1]));
    let a = window_coordinate((i, width), (level, x, right), camera.view_width());
    let b = window_coordinate((j, height), (level, y, up), camera.view_height());
    sample(scene, candidates, [a, b], work)
}

/// Where on the window, from its middle, a sample is: in one of `n` pixels, one
/// of its `2^level` cells, and so many parts of `2^(level + 1)` into that.
/// Like [`crate::pixel_center`], with an exact negative on the other side.
fn window_coordinate((pixel, n): (u32, u32), (level, cell, part): Place, extent: f64) -> f64 {
    let (cells, parts) = (1_i64 << level, 2_i64 << level);
    let all = i64::from(n) * cells * parts;
    let here = (i64::from(pixel) * cells + i64::from(cell)) * parts + i64::from(part);
    extent * (2 * here - all) as f64 / (2 * all) as f64
}

/// Odd numbers that spread the bits of small ones, for each axis its own: with
/// one for both, samples would stay on the diagonals of their cells.
const SPREAD: [u32; 2] = [0x9e37_79b9, 0x85eb_ca6b];

/// How many parts of `2^(level + 1)` into its cell a sample is along one axis,
/// if the cell is number `along` of that axis and `across` of the other.
///
/// Along a row or column of a pixel's cells every such place in a half comes
/// once: the radical inverse of the place from the pixel's middle, its bits
/// turned in another way for each row. Mirrored cells have mirrored samples.
///
/// Source: for the radical inverse turned by a bit-wise exclusive or, Kollig and
/// Keller, "Efficient Multidimensional Sampling", 2002.
fn in_cell(level: u32, along: u32, across: u32, spread: u32) -> u32 {
    let (cells, parts) = (1_u32 << level, 2_u32 << level);
    let half = cells / 2;
    if half == 0 {
        return parts / 2;
    }
    let from_middle = |k: u32| if k < half { half - 1 - k } else { k - half };
    // As many bits as it takes to number half of the cells.
    let bits = level - 1;
    let reversed = |k: u32| k.reverse_bits().checked_shr(32 - bits).unwrap_or(0);
    let turn = from_middle(along).wrapping_mul(spread).checked_shr(32 - bits).unwrap_or(0);
    // Of 2^level places for a sample in half of the parts, the middle one.
    let part = 4 * reversed(from_middle(across) ^ turn) + 2;
    if along < half { part } else { parts - part }
}

/// The looks at the middles of all pixels, row 0 at the bottom.
struct Survey {
    looks: Vec<Vec<Look>>,
}

impl Survey {
    /// The look so many pixels to the right and up, if that is in the picture.
    fn beside(&self, (i, j): (u32, u32), (right, up): (i32, i32)) -> Option<&Look> {
        let (i, j) = (i.checked_add_signed(right)?, j.checked_add_signed(up)?);
        self.looks.get(j as usize)?.get(i as usize)
    }

    /// Whether the look at the pixel's middle will do for all of it: those
    /// around see the same thing, and what they see bends so little that the
    /// mean is off by no more than `allowed`.
    fn is_calm(&self, at: (u32, u32), allowed: f64) -> bool {
        let Some(here) = self.beside(at, (0, 0)) else { return true };
        let around = (0..9).map(|k| (k % 3 - 1, k / 3 - 1));
        if !around.filter_map(|way| self.beside(at, way)).all(|look| is_alike(here, look)) {
            return false;
        }
        // The mean of a parabola over a unit is its middle plus 1/24 of its
        // second difference.
        [(1, 0), (0, 1)].into_iter().all(|(right, up)| {
            let ends = [(right, up), (-right, -up)].map(|way| self.beside(at, way));
            let [Some(one), Some(other)] = ends else { return true };
            let bend = (one.color + other.color) + here.color * -2.0;
            bend.channels().into_iter().all(|x| x.abs() <= 24.0 * allowed)
        })
    }
}

/// Whether both see the same object, from about the same side, in the same
/// shadows.
fn is_alike(one: &Look, other: &Look) -> bool {
    let same_surface = match (one.surface, other.surface) {
        (None, None) => true,
        (Some((object, n)), Some((other, m))) => object == other && n.dot(*m) > ALIKE,
        _ => false,
    };
    same_surface && one.shadows == other.shadows
}

/// The largest difference of any channel.
fn contrast(one: Rgb, other: Rgb) -> f64 {
    (one + other * -1.0).channels().into_iter().fold(0.0, |most, x| most.max(x.abs()))
}

/// A part of a pixel, with the look at its sample.
struct Cell {
    look: Look,
    /// The first of four: lower left, lower right, upper left, upper right;
    /// 0, which is the pixel, for none.
    parts: usize,
}

/// Where a cell is: how often the pixel was halved, the column and the row.
type Place = (u32, u32, u32);

/// A pixel that is cut into cells.
struct Pixel<'a> {
    scene: &'a Scene,
    survey: &'a Survey,
    at: (u32, u32),
    /// The pixel itself first.
    cells: Vec<Cell>,
}

impl Pixel<'_> {
    /// Its mean color, the error estimated to be at most `allowed`.
    fn refined(&mut self, candidates: Candidates, allowed: f64, work: &Work<impl Meter>) -> Rgb {
        let middle = self.survey.looks[self.at.1 as usize][self.at.0 as usize];
        self.cells.push(Cell { look: middle, parts: 0 });
        self.cut(0, (0, 0, 0), candidates, work);
        for part in 0..4 {
            self.cut(1 + part, (1, part as u32 % 2, part as u32 / 2), candidates, work);
        }
        loop {
            let mut leaves = Vec::new();
            let (color, error) = self.mean(0, (0, 0, 0), &mut leaves);
            if error <= allowed * allowed {
                return color;
            }
            leaves.retain(|&(_, (level, ..), _)| level < DEEPEST);
            let worst = leaves.iter().map(|leaf| leaf.2).fold(0.0, f64::max);
            if !(worst > 0.0) {
                return color;
            }
            // All that are half as bad: one by one would be too slow, and would
            // prefer one side.
            for (cell, place, _) in leaves.into_iter().filter(|leaf| leaf.2 >= 0.25 * worst) {
                self.cut(cell, place, candidates, work);
            }
        }
    }

    /// Cuts a cell in four.
    fn cut(
        &mut self,
        cell: usize,
        (level, x, y): Place,
        candidates: Candidates,
        work: &Work<impl Meter>,
    ) {
        self.cells[cell].parts = self.cells.len();
        for part in 0..4 {
            let place = (level + 1, 2 * x + part % 2, 2 * y + part / 2);
            let look = look(self.scene, candidates, self.at, place, work);
            self.cells.push(Cell { look, parts: 0 });
        }
    }

    /// A cell's color times its area, and the square of its error; adds the
    /// cells that are not cut to `leaves`, with the square of the error of each.
    ///
    /// Sums are taken by quarters, so that mirrored cells give the same bits.
    fn mean(&self, cell: usize, place: Place, leaves: &mut Vec<(usize, Place, f64)>) -> (Rgb, f64) {
        let (level, x, y) = place;
        let Cell { look, parts } = &self.cells[cell];
        if *parts == 0 {
            let area = 1.0 / f64::from(1_u32 << (2 * level));
            let error = area * area * self.variance(look, place);
            leaves.push((cell, place, error));
            return (look.color * area, error);
        }
        let [a, b, c, d] = [0, 1, 2, 3].map(|part: u32| {
            let place = (level + 1, 2 * x + part % 2, 2 * y + part / 2);
            self.mean(parts + part as usize, place, leaves)
        });
        ((a.0 + b.0) + (c.0 + d.0), (a.1 + b.1) + (c.1 + d.1))
    }

    /// The mean square error of a cell's color, by its contrast with what is
    /// left, right, below and above.
    fn variance(&self, look: &Look, (level, x, y): Place) -> f64 {
        let ways = [(1, 0), (-1, 0), (0, 1), (0, -1)];
        let variances = ways.into_iter().filter_map(|(right, up)| {
            let side = 1_u32 << level;
            let x = x.checked_add_signed(right).filter(|x| *x < side);
            let y = y.checked_add_signed(up).filter(|y| *y < side);
            let (beside, variance) = if let (Some(x), Some(y)) = (x, y) {
                (self.covering((level, x, y)), VARIANCE)
            } else {
                // The edge is somewhere on the way to the middle of the next
                // pixel, half a pixel beyond the cell's own half: in that with
                // this chance, and then the cell is off by up to a half.
                let chance = 1.0 / f64::from(side + 1);
                (self.survey.beside(self.at, (right, up))?, chance / 12.0)
            };
            let contrast = contrast(look.color, beside.color);
            Some(variance * (contrast * contrast))
        });
        variances.fold(0.0, f64::max)
    }

    /// The look at the smallest cell, no smaller than this one, that covers it.
    fn covering(&self, (level, x, y): Place) -> &Look {
        let mut cell = &self.cells[0];
        for halved in 1..=level {
            if cell.parts == 0 {
                break;
            }
            let (right, up) = (x >> (level - halved) & 1, y >> (level - halved) & 1);
            cell = &self.cells[cell.parts + (2 * up + right) as usize];
        }
        &cell.look
    }
}

#[cfg(test)]
mod tests;
