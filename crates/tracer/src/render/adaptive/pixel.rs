//! `Pixel`: one that is cut into cells until its error is small enough.
//!
//! It is cut into 4 by 4 cells, or 2 by 2 where little is asked for, and cells that differ from those beside them in
//! four again, the worst first. If a straight edge runs through a cell, anywhere
//! in it, a sample anywhere in it is off by `contrast / sqrt(6)` in the root
//! mean square; that is the estimate for a cell that differs, and those of a pixel
//! add up as independent errors do. To be independent where an edge follows a row or
//! column, samples are not in the middles of their cells: [`Place`] spreads
//! them.

use std::collections::BTreeMap;
use std::ops::Add;

use super::begun::Begun;
use super::narrow::{Bounds, Narrow};
use super::place::Place;
use super::survey::{Survey, beside, contrast, is_alike};
use super::{Spread, sample};
use crate::meter::{Meter, Work};
use crate::plan::Candidates;
use crate::scene::Look;
use crate::{Rgb, Scene};

/// Cells are not cut below a 64th of a pixel: 4096 in all, as many as other
/// pixels may have samples.
const DEEPEST: u32 = 6;
/// The mean square error of a cell that an edge of contrast 1 runs through: of
/// `p (1 - p)`, where each part `p` of the cell is as likely.
const VARIANCE: f64 = 1.0 / 24.0;
/// The same of one that differs from a cell at its corner only: an edge can run
/// through little of it, but a corner may lie in it.
const AT_CORNER: f64 = VARIANCE / 8.0;

/// What a cell's part of the mean square error comes to when it is cut: an edge
/// runs through two of four, each of which counts a 16th.
const CUT: f64 = 1.0 / 8.0;

/// A part of a pixel, with the look at its sample.
struct Cell {
    look: Look,
    /// The first of four quarters; 0, which is the pixel, for none.
    parts: usize,
}

/// A cell that is not cut, and the square of its part of the pixel's error.
struct Leaf {
    cell: usize,
    place: Place,
    error: f64,
}

/// What is known of a picture before its pixels are cut further.
pub(super) struct Known<'a> {
    pub(super) scene: &'a Scene,
    pub(super) survey: &'a Survey,
    pub(super) narrow: &'a Narrow,
    pub(super) begun: &'a BTreeMap<(u32, u32), Begun>,
}

/// A pixel that is cut into cells.
pub(super) struct Pixel<'a> {
    known: &'a Known<'a>,
    at: (u32, u32),
    /// The pixel itself first.
    cells: Vec<Cell>,
}

impl<'a> Pixel<'a> {
    /// Pixel `at` as it was begun.
    pub(super) fn new(known: &'a Known<'a>, at: (u32, u32), begun: &Begun) -> Self {
        let middle = known.survey.looks[at.1 as usize][at.0 as usize];
        let mut pixel = Self { known, at, cells: vec![Cell { look: middle, parts: 0 }] };
        let mut row = vec![(0, Place::PIXEL)];
        for level in 1..=begun.level {
            let mut next = Vec::new();
            for (cell, place) in row {
                pixel.cells[cell].parts = pixel.cells.len();
                for part in 0..4 {
                    let place = place.quarter(part);
                    // Those that are cut in turn are not looked at.
                    let look = if level == begun.level {
                        begun.looks[((place.y << level) + place.x) as usize]
                    } else {
                        middle
                    };
                    next.push((pixel.cells.len(), place));
                    pixel.cells.push(Cell { look, parts: 0 });
                }
            }
            row = next;
        }
        pixel
    }

    /// What it shows, the error estimated to be at most `allowed`, and the
    /// pixels around whose middles are unlike the cells beside them.
    pub(super) fn refined(
        mut self,
        candidates: Candidates,
        allowed: f64,
        work: &Work<impl Meter>,
    ) -> (Spread, Vec<(u32, u32)>) {
        let narrow = self.known.narrow.seen_in(self.at);
        let narrow = narrow.iter().filter(|bounds| bounds.part_in(self.at).1 >= allowed);
        let narrow: Vec<_> = narrow.copied().collect();
        self.cut_narrow(&narrow, 0, Place::PIXEL, candidates, work);
        let leaves = loop {
            let mut leaves = Vec::new();
            let error = self.leaves(0, Place::PIXEL, &mut leaves);
            let most = allowed * allowed;
            let Some(least) = (error > most).then(|| least_to_cut(&leaves, error, most)).flatten()
            else {
                break leaves;
            };
            for leaf in leaves {
                if leaf.can_be_cut() && leaf.error >= least {
                    self.cut(leaf.cell, leaf.place, candidates, work);
                }
            }
        };
        let unlike = self.unlike(&leaves, allowed);
        (self.spread(&leaves), unlike)
    }

    /// The pixels around that are not begun, or show one thing only, and are
    /// unlike the cells beside them.
    fn unlike(&self, leaves: &[Leaf], allowed: f64) -> Vec<(u32, u32)> {
        let mut unlike = Vec::new();
        for leaf in leaves {
            for way in leaf.place.ways_out() {
                let Some(next) = beside(self.at, way) else { continue };
                let look = match self.known.begun.get(&next) {
                    Some(begun) if begun.may_hide_something(allowed) => &begun.looks[0],
                    Some(_) => continue,
                    None => match self.known.survey.beside(self.at, way) {
                        Some(look) => look,
                        None => continue,
                    },
                };
                if !is_alike(&self.cells[leaf.cell].look, look) {
                    unlike.push(next);
                }
            }
        }
        unlike.sort_unstable();
        unlike.dedup();
        unlike
    }

    /// Cuts a cell in four.
    fn cut(&mut self, cell: usize, place: Place, candidates: Candidates, work: &Work<impl Meter>) {
        self.cells[cell].parts = self.cells.len();
        for part in 0..4 {
            let window = place.quarter(part).window(self.known.scene, self.at);
            let look = sample(self.known.scene, candidates, window, work);
            self.cells.push(Cell { look, parts: 0 });
        }
    }

    /// Cuts cells that something narrow reaches into, until two of them are no
    /// wider than what of that is in the pixel.
    fn cut_narrow(
        &mut self,
        narrow: &[Bounds],
        cell: usize,
        place: Place,
        candidates: Candidates,
        work: &Work<impl Meter>,
    ) {
        /// Widths are rounded, in mirrored pictures in another way, and most
        /// are short fractions.
        const ROUNDED: f64 = 0.97;
        let is_wide = |bounds: &Bounds| {
            let is_wider = ROUNDED * bounds.part_in(self.at).0 * f64::from(place.count()) < 2.0;
            is_wider && bounds.reaches(self.at, place.sides())
        };
        if place.level == DEEPEST || !narrow.iter().any(is_wide) {
            return;
        }
        if self.cells[cell].parts == 0 {
            self.cut(cell, place, candidates, work);
        }
        for part in 0..4 {
            let cell = self.cells[cell].parts + part as usize;
            self.cut_narrow(narrow, cell, place.quarter(part), candidates, work);
        }
    }

    /// Lists the cells that are not cut, and adds up the squares of their errors,
    /// by quarters, so that mirrored cells give the same bits.
    fn leaves(&self, cell: usize, place: Place, leaves: &mut Vec<Leaf>) -> f64 {
        let Cell { look, parts } = &self.cells[cell];
        if *parts == 0 {
            let error = place.area() * place.area() * self.variance(look, place);
            leaves.push(Leaf { cell, place, error });
            return error;
        }
        let mut quarter = |k: u32| self.leaves(parts + k as usize, place.quarter(k), leaves);
        let [a, b, c, d] = [0, 1, 2, 3].map(&mut quarter);
        (a + b) + (c + d)
    }

    /// The sum of a term of each cell that is not cut, by quarters.
    fn sum<T: Add<Output = T>>(
        &self,
        cell: usize,
        place: Place,
        term: &impl Fn(Rgb, Place) -> T,
    ) -> T {
        let Cell { look, parts } = &self.cells[cell];
        if *parts == 0 {
            return term(look.color, place);
        }
        let [a, b, c, d] =
            [0, 1, 2, 3].map(|k| self.sum(parts + k as usize, place.quarter(k), term));
        (a + b) + (c + d)
    }

    /// What it gives to the pixels around.
    fn spread(&self, leaves: &[Leaf]) -> Spread {
        let filter = self.known.scene.filter();
        let first = self.cells[leaves[0].cell].look.color;
        if leaves.iter().all(|leaf| self.cells[leaf.cell].look.color == first) {
            // As if it had not been cut, to the bit.
            return Place::PIXEL.alone(first, filter);
        }
        let mean = self.sum(0, Place::PIXEL, &|color, place| color * place.area());
        Spread::new(filter, mean, |right, up| {
            self.sum(0, Place::PIXEL, &|color, place| place.splat(filter, color, (right, up)))
        })
    }

    /// The mean square error of a cell's color, by its contrast with those
    /// around.
    fn variance(&self, look: &Look, place: Place) -> f64 {
        let ways = [(1, 0), (-1, 0), (0, 1), (0, -1), (1, 1), (1, -1), (-1, 1), (-1, -1)];
        let variances = ways.into_iter().filter_map(|way| {
            let is_corner = way.0 != 0 && way.1 != 0;
            let (contrast, variance) = if let Some(place) = place.beside(way) {
                let contrast = self.contrast_across(look.color, self.covering(place), way);
                (contrast, if is_corner { AT_CORNER } else { VARIANCE })
            } else if is_corner {
                return None;
            } else {
                // The edge is somewhere on the way to the next pixel's sample,
                // half of its own cell beyond the border: in this cell with that
                // chance, and then the cell is off by up to a half.
                let (beyond, halved) = self.beyond(place, way)?;
                let cells = f64::from(1 << halved);
                let chance = cells / (cells + f64::from(place.count()));
                (contrast(look.color, beyond.color), chance / 12.0)
            };
            Some(variance * (contrast * contrast))
        });
        variances.fold(0.0, f64::max)
    }

    /// The look beside a cell in the next pixel, and how often that was halved
    /// for it.
    fn beyond(&self, place: Place, way: (i32, i32)) -> Option<(&Look, u32)> {
        let next = beside(self.at, way)?;
        match self.known.begun.get(&next) {
            Some(begun) => Some((begun.facing(place, way), begun.level)),
            None => Some((self.known.survey.beside(self.at, way)?, 0)),
        }
    }

    /// The smallest cell, no smaller than this one, that covers it.
    fn covering(&self, Place { level, x, y }: Place) -> &Cell {
        let mut cell = &self.cells[0];
        for halved in 1..=level {
            if cell.parts == 0 {
                break;
            }
            let (right, up) = (x >> (level - halved) & 1, y >> (level - halved) & 1);
            cell = &self.cells[cell.parts + (2 * up + right) as usize];
        }
        cell
    }

    /// The largest contrast of a color with what a cell shows at its side, or
    /// corner, that one comes to this way.
    fn contrast_across(&self, color: Rgb, cell: &Cell, way: (i32, i32)) -> f64 {
        if cell.parts == 0 {
            return contrast(color, cell.look.color);
        }
        let faces = |part: &usize| {
            let nearest = |way: i32, k: usize| way == 0 || k == usize::from(way < 0);
            nearest(way.0, part % 2) && nearest(way.1, part / 2)
        };
        let parts = (0..4).filter(faces).map(|part| &self.cells[cell.parts + part]);
        parts.map(|part| self.contrast_across(color, part, way)).fold(0.0, f64::max)
    }
}

impl Leaf {
    fn can_be_cut(&self) -> bool {
        self.place.level < DEEPEST
    }
}

/// The smallest error of cells that are to be cut, so that the pixel's square
/// error comes from `error` to `most`, or those that are half as bad as the worst
/// if it does not: the next cells may be no better than they look. `None` if no
/// cell can be cut that has an error.
///
/// It is a value and not a number of cells, so that no side is preferred.
fn least_to_cut(leaves: &[Leaf], error: f64, most: f64) -> Option<f64> {
    let mut errors: Vec<_> =
        leaves.iter().filter(|leaf| leaf.can_be_cut()).map(|leaf| leaf.error).collect();
    errors.retain(|error| *error > 0.0);
    errors.sort_unstable_by(|a, b| b.total_cmp(a));
    let worst = errors.first()?;
    let mut left = error;
    let enough = errors.iter().find(|cut| {
        left -= (1.0 - CUT) * *cut;
        left <= most
    });
    Some(enough.unwrap_or(&0.0).max(0.25 * worst))
}
