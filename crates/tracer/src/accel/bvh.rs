//! `Bvh`: a hierarchy over candidates of any kind, which their owner tests one
//! by one.
//!
//! It promises the linear list's answers: what holds them may let a ray in that
//! misses, never keep one out that a candidate's own formula would hit.

use super::list::end_after;
use super::wide::{Candidates, Gathered, Leaf, Options, Span, TimeScale, Visitor, Wide};
use super::{Build, Candidate};
use crate::fault::{Fault, seeded};
use crate::meter::Meter;
use crate::simd::{Level, Simd, Work};
use crate::{Aabb, Interval, Ray};

/// A bounding volume hierarchy.
#[derive(Debug, Clone, PartialEq)]
pub struct Bvh {
    wide: Wide,
    /// The instructions to walk it with.
    level: Level,
    /// Candidate numbers, leaf after leaf.
    order: Vec<u32>,
    /// Candidates without a finite box: tested by every ray.
    unbounded: Vec<u32>,
}

impl Bvh {
    /// The hierarchy over candidates with these boxes; see
    /// [`Accelerator::build`](super::Accelerator::build).
    pub fn new(boxes: &[Aabb], rounding: f64, build: Build) -> Self {
        let (bounded, unbounded): (Vec<u32>, Vec<u32>) =
            (0..boxes.len() as u32).partition(|&i| boxes[i as usize].is_finite());
        let finite = Boxes(bounded.iter().map(|&i| boxes[i as usize]).collect());
        // Boxes are tested eight at a time, in less time than any one candidate:
        // each has one of its own.
        let level = build.level();
        let options = Options { leaf_size: 1, extra: 0.0, level };
        let gathered = Gathered::new(&finite, options);
        let leaf = |_, span: Span| Leaf::new(span.first, span.count);
        let (wide, _, mut order) = Wide::new(gathered, &finite, rounding, options, leaf);
        for item in &mut order {
            *item = bounded[*item as usize];
        }
        Self { wide, level, order, unbounded }
    }

    /// See [`Accelerator::closest`](super::Accelerator::closest).
    pub(crate) fn closest<H: Candidate>(
        &self,
        ray: &Ray,
        range: Interval,
        meter: &impl Meter,
        test: impl FnMut(u32, Interval) -> Option<H>,
    ) -> Option<(u32, H)> {
        let time = TimeScale::ANY;
        let number = u32::MAX;
        let mut closest =
            Closest { bvh: self, range, test, best: None, number, t_best: range.hi, time };
        for &i in &self.unbounded {
            closest.consider(i);
        }
        self.walk(ray, range.until(closest.t_best), meter, &mut closest);
        closest.best.map(|hit| (closest.number, hit))
    }

    /// See [`Accelerator::any`](super::Accelerator::any).
    pub(crate) fn any(
        &self,
        ray: &Ray,
        range: Interval,
        meter: &impl Meter,
        mut test: impl FnMut(u32) -> bool,
    ) -> bool {
        self.unbounded.iter().any(|&i| test(i))
            || self.walk(ray, range, meter, &mut Any { bvh: self, test })
    }

    fn walk<V: Visitor, M: Meter>(
        &self,
        ray: &Ray,
        range: Interval,
        meter: &M,
        visitor: &mut V,
    ) -> bool {
        M::run(self.level, Walk { wide: &self.wide, ray, range, meter, visitor })
    }

    fn candidates(&self, leaf: Leaf) -> &[u32] {
        &self.order[leaf.place()..leaf.place() + leaf.count()]
    }
}

/// Candidates of which nothing is known but their boxes.
struct Boxes(Vec<Aabb>);

impl Candidates for Boxes {
    fn count(&self) -> u32 {
        self.0.len() as u32
    }
    fn bounds(&self, number: u32) -> Option<Aabb> {
        Some(self.0[number as usize])
    }
}

struct Closest<'a, H, F> {
    bvh: &'a Bvh,
    range: Interval,
    test: F,
    best: Option<H>,
    /// Its candidate, and its `t`; none yet, and the end of the range.
    number: u32,
    t_best: f64,
    time: TimeScale,
}

impl<H: Candidate, F: FnMut(u32, Interval) -> Option<H>> Closest<'_, H, F> {
    fn consider(&mut self, i: u32) {
        // One step past the best `t` for a lower number, which wins with an equal
        // one, as in the list.
        let is_first = (i < self.number) != seeded(Fault::TieGoesToTheLast);
        let wins_ties = self.best.is_some() && is_first;
        let until = if wins_ties {
            self.t_best.next_up().min(self.range.hi)
        } else {
            end_after(self.t_best, false, self.range)
        };
        if let Some(hit) = (self.test)(i, self.range.until(until)) {
            (self.t_best, self.number) = (hit.t(), i);
            self.best = Some(hit);
        }
    }
}

impl<H: Candidate, F: FnMut(u32, Interval) -> Option<H>> Visitor for Closest<'_, H, F> {
    const ANY: bool = false;

    fn start(&mut self, time: TimeScale) {
        self.time = time;
    }

    fn visit(&mut self, leaf: Leaf, t_max: &mut f32) -> bool {
        for &i in self.bvh.candidates(leaf) {
            self.consider(i);
        }
        *t_max = self.time.up(self.t_best);
        self.best.is_some() && seeded(Fault::FirstLeafWins)
    }

    #[inline(always)]
    fn address(&self, _: Leaf) -> *const u8 {
        // Candidates are anywhere; this is in the cache already.
        std::ptr::from_ref(self.bvh).cast()
    }
}

struct Any<'a, F> {
    bvh: &'a Bvh,
    test: F,
}

impl<F: FnMut(u32) -> bool> Visitor for Any<'_, F> {
    const ANY: bool = true;

    fn visit(&mut self, leaf: Leaf, _: &mut f32) -> bool {
        self.bvh.candidates(leaf).iter().any(|&i| (self.test)(i))
    }

    #[inline(always)]
    fn address(&self, _: Leaf) -> *const u8 {
        // Candidates are anywhere; this is in the cache already.
        std::ptr::from_ref(self.bvh).cast()
    }
}

struct Walk<'a, V, M> {
    wide: &'a Wide,
    ray: &'a Ray,
    range: Interval,
    meter: &'a M,
    visitor: &'a mut V,
}

impl<V: Visitor, M: Meter> Work for Walk<'_, V, M> {
    type Output = bool;

    #[inline(always)]
    fn run<S: Simd>(self, simd: S) -> bool {
        let Self { wide, ray, range, meter, visitor } = self;
        wide.walk_ray(simd, ray, range, meter, visitor)
    }
}
