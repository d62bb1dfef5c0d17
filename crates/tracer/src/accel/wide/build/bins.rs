//! `Bins`: what a set of references looks like from afar, and the cut in two
//! that costs least by the surface area heuristic.
//!
//! Source: Wald, "On fast Construction of SAH-based Bounding Volume
//! Hierarchies", 2007; counted in blocks as in Wald, Woop, Benthin, Johnson and
//! Ernst, "Embree: A Kernel Framework for Efficient CPU Ray Tracing", 2014.

use glam::Vec4;
use rayon::prelude::*;

use super::bounds::Bounds;
use super::reference::Reference;
use crate::simd::{Level, Simd, Work};

/// The most bins per axis, a power of two.
pub(super) const BINS: usize = 32;
/// References are put into bins by this many at a time.
const CHUNK: usize = 1 << 12;
/// A set from this size on is looked at by all threads.
pub(super) const SHARED: usize = 1 << 14;
/// Added to a number below 2^22 it leaves the nearest whole number in the last
/// bits of the sum: 1.5 * 2^23.
const TO_INTEGER: f32 = 12_582_912.0;
/// Centers closer together than this share of the units count as one: the
/// quotient that tells bins apart stays in the range of `f32`.
const ONE_PLACE: f32 = 1e-30;

/// Which bins centers fall into.
#[derive(Debug, Clone, Copy)]
pub(super) struct Grid {
    base: Vec4,
    scale: Vec4,
    /// How many bins there are in each axis.
    count: usize,
}

impl Grid {
    /// A grid over a set whose centers are all inside of `centers`. The first
    /// and the last bin are half as wide as the others.
    pub(super) fn new(centers: Bounds, count: usize) -> Self {
        let width = centers.hi - centers.lo;
        let scale = Vec4::splat((count - 1) as f32) / width;
        let scale = Vec4::select(width.cmpgt(Vec4::splat(ONE_PLACE)), scale, Vec4::ZERO);
        Self { base: centers.lo, scale: scale.with_w(0.0), count }
    }

    /// The bin in each axis, in the last bits of each lane. Its lanes compare
    /// as bins do.
    #[inline]
    fn place(&self, center: Vec4) -> Vec4 {
        (center - self.base) * self.scale + Vec4::splat(TO_INTEGER)
    }
}

/// A cut of a set in two, neither of which is empty.
#[derive(Debug, Clone, Copy)]
pub(super) struct Cut {
    grid: Grid,
    /// Up to which place references are on the left side: infinite but for one
    /// lane.
    last: Vec4,
    /// The boxes of both sides.
    pub bounds: [Bounds; 2],
    /// How many references the left side has.
    pub left: usize,
    /// The sum over both sides of area times blocks.
    pub cost: f32,
}

impl Cut {
    /// Whether a reference with this center is on the left side.
    #[inline]
    pub(super) fn is_left(&self, center: Vec4) -> bool {
        self.grid.place(center).cmple(self.last).all()
    }
}

/// The references of a set, by the bin that their center is in.
#[derive(Clone, Copy)]
pub(super) struct Bins {
    /// For each bin, those in it along each axis.
    bounds: [[Bounds; 3]; BINS],
    counts: [[u32; 4]; BINS],
    grid: Grid,
}

impl Bins {
    /// Bins without references.
    pub(super) fn empty() -> Self {
        let grid = Grid { base: Vec4::ZERO, scale: Vec4::ZERO, count: BINS };
        Self { bounds: [[Bounds::EMPTY; 3]; BINS], counts: [[0; 4]; BINS], grid }
    }

    /// Makes these the bins of a set, whatever they were before.
    #[inline(always)]
    fn refill(&mut self, grid: Grid, references: &[Reference]) {
        self.grid = grid;
        self.bounds[..grid.count].fill([Bounds::EMPTY; 3]);
        self.counts[..grid.count].fill([0; 4]);
        self.fill(references);
    }

    /// The same for a large set, in parallel.
    pub(super) fn refill_side_by_side(
        &mut self,
        level: Level,
        grid: Grid,
        references: &[Reference],
    ) {
        let filled = |some| {
            let mut bins = Self::empty();
            level.run(Refill { bins: &mut bins, grid, references: some });
            bins
        };
        let empty = || Self { grid, ..Self::empty() };
        *self = references.par_chunks(CHUNK).map(filled).reduce(empty, |a, b| a.union(&b));
    }

    /// Puts references into their bins.
    #[inline(always)]
    fn fill(&mut self, references: &[Reference]) {
        for reference in references {
            let [x, y, z, _] = self.grid.place(reference.center()).to_array();
            let bounds = reference.bounds();
            for (axis, place) in [x, y, z].into_iter().enumerate() {
                let bin = place.to_bits() as usize % BINS;
                let slot = &mut self.bounds[bin][axis];
                *slot = slot.union(bounds);
                self.counts[bin][axis] += 1;
            }
        }
    }

    /// Both together, over the same grid.
    fn union(mut self, other: &Self) -> Self {
        for bin in 0..self.grid.count {
            for axis in 0..3 {
                let slot = &mut self.bounds[bin][axis];
                *slot = slot.union(other.bounds[bin][axis]);
                self.counts[bin][axis] += other.counts[bin][axis];
            }
        }
        self
    }

    /// The cut for which the sum over both sides of area times blocks is least;
    /// `None` if along every axis all centers are in one bin.
    #[inline(always)]
    pub(super) fn best_cut(&self, block_shift: u32) -> Option<Cut> {
        let count = self.grid.count;
        let mut right_costs = [Vec4::INFINITY; BINS];
        let (mut sides, mut counts) = ([Bounds::EMPTY; 3], [0; 4]);
        for bin in (1..count).rev() {
            self.add(bin, &mut sides, &mut counts);
            right_costs[bin] = half_areas(&sides) * blocks(counts, block_shift);
        }
        let (mut sides, mut counts) = ([Bounds::EMPTY; 3], [0; 4]);
        let (mut least, mut best) = (Vec4::INFINITY, [0; 4]);
        for bin in 0..count - 1 {
            self.add(bin, &mut sides, &mut counts);
            // Where a side is empty this is NaN, and not less than anything.
            let cost = half_areas(&sides) * blocks(counts, block_shift) + right_costs[bin + 1];
            let better = cost.cmplt(least);
            least = Vec4::select(better, cost, least);
            for (axis, best) in best.iter_mut().enumerate() {
                *best = if better.test(axis) { bin } else { *best };
            }
        }
        let axis = (1..3).fold(0, |axis, k| if least[k] < least[axis] { k } else { axis });
        (least[axis] < f32::INFINITY)
            .then(|| Cut { cost: least[axis], ..self.cut(axis, best[axis]) })
    }

    #[inline(always)]
    fn add(&self, bin: usize, sides: &mut [Bounds; 3], counts: &mut [u32; 4]) {
        for (side, bounds) in sides.iter_mut().zip(self.bounds[bin]) {
            *side = side.union(bounds);
        }
        for (sum, n) in counts.iter_mut().zip(self.counts[bin]) {
            *sum += n;
        }
    }

    /// The cut behind bin `last`.
    fn cut(&self, axis: usize, last: usize) -> Cut {
        let all = |bins: &[[Bounds; 3]]| {
            bins.iter().fold(Bounds::EMPTY, |all, bounds| all.union(bounds[axis]))
        };
        let (left, right) = self.bounds[..self.grid.count].split_at(last + 1);
        let mut place = [f32::INFINITY; 4];
        place[axis] = TO_INTEGER + last as f32;
        Cut {
            grid: self.grid,
            last: Vec4::from_array(place),
            bounds: [all(left), all(right)],
            cost: 0.0,
            left: self.counts[..=last].iter().map(|n| n[axis] as usize).sum(),
        }
    }
}

/// Makes bins those of a set.
struct Refill<'a> {
    bins: &'a mut Bins,
    grid: Grid,
    references: &'a [Reference],
}

impl Work for Refill<'_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self, _: S) {
        self.bins.refill(self.grid, self.references);
    }
}

/// Makes bins those of a set, and finds its best cut.
pub(super) struct BestCut<'a> {
    pub bins: &'a mut Bins,
    pub grid: Grid,
    pub references: &'a [Reference],
    pub block_shift: u32,
}

impl Work for BestCut<'_> {
    type Output = Option<Cut>;
    #[inline(always)]
    fn run<S: Simd>(self, _: S) -> Option<Cut> {
        self.bins.refill(self.grid, self.references);
        self.bins.best_cut(self.block_shift)
    }
}

/// The half areas of three boxes, a lane each.
#[inline]
fn half_areas(boxes: &[Bounds; 3]) -> Vec4 {
    let [a, b, c] = boxes.map(|b| b.hi - b.lo);
    let x = Vec4::new(a.x, b.x, c.x, 0.0);
    let y = Vec4::new(a.y, b.y, c.y, 0.0);
    let z = Vec4::new(a.z, b.z, c.z, 0.0);
    x * y + y * z + z * x
}

/// How many blocks of `2^shift` these make, a lane each.
#[inline]
fn blocks(counts: [u32; 4], shift: u32) -> Vec4 {
    let full = (1_u32 << shift) - 1;
    Vec4::from_array(counts.map(|n| (n.saturating_add(full) >> shift).cast_signed() as f32))
}
