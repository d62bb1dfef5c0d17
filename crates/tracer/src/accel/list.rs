//! `List`: the lecture's loop over all surfaces, linear in their number.

use super::Candidate;
use crate::Interval;
use crate::fault::{Fault, seeded};

/// Tests every candidate in order.
#[derive(Debug, Clone, PartialEq)]
pub struct List {
    len: u32,
}

impl List {
    /// A list of this many candidates.
    pub fn new(len: usize) -> Self {
        Self { len: len as u32 }
    }

    /// The lecture's loop: each surface is asked for a hit in
    /// `(tMin, tBest)`, so a later one must be strictly closer to win.
    ///
    /// ```text
    /// tBest = +inf; firstSurface = null;
    /// for surface in surfaceList {
    ///     hitSurface, t = surface.intersect(ray, tMin, tBest);
    ///     if hitSurface is not null { tBest = t; firstSurface = hitSurface; }
    /// }
    /// ```
    ///
    /// Source: slide "Intersection against many shapes".
    pub fn closest<H: Candidate>(
        &self,
        range: Interval,
        mut test: impl FnMut(u32, Interval) -> Option<H>,
    ) -> Option<(u32, H)> {
        let mut t_best = range.hi;
        let mut first_surface = None;
        for surface in 0..self.len {
            let end = end_after(t_best, first_surface.is_some(), range);
            if let Some(hit) = test(surface, range.until(end)) {
                t_best = hit.t();
                first_surface = Some((surface, hit));
            }
        }
        first_surface
    }

    /// Whether the test is true for any candidate.
    pub fn any(&self, test: impl FnMut(u32) -> bool) -> bool {
        (0..self.len).any(test)
    }
}

/// Where the range ends for the next surface, if the best hit is at `t_best`.
#[inline(always)]
pub(crate) fn end_after(t_best: f64, is_hit: bool, range: Interval) -> f64 {
    if is_hit && seeded(Fault::TieGoesToTheLast) {
        return t_best.next_up();
    }
    if seeded(Fault::LastHitWins) { range.hi } else { t_best }
}
