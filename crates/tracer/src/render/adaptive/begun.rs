//! `Begun`: the first looks into a pixel that is cut, before it is cut further.

use super::place::Place;
use super::sample;
use super::survey::{Survey, beside, is_alike};
use crate::Scene;
use crate::meter::{Meter, Work};
use crate::plan::Candidates;
use crate::scene::Look;

/// A pixel that may be off by this much is begun with 2 by 2 cells: an edge of
/// contrast 1 is estimated to be off by less with 4 by 4.
const COARSE: f64 = 1.0 / 16.0;
/// A pixel that shows only one thing although one beside it shows something else
/// along their border is begun again with finer cells, up to this level: 16 by 16.
const FINEST_BEGUN: u32 = 4;

/// What is first seen of a pixel that is cut: the looks into the cells of one
/// size, by rows from the lower left.
pub(super) struct Begun {
    pub(super) level: u32,
    pub(super) looks: Vec<Look>,
}

impl Begun {
    /// The first looks at pixel `at`, for an error of `allowed` in the end.
    pub(super) fn new(
        scene: &Scene,
        at: (u32, u32),
        candidates: Candidates,
        allowed: f64,
        work: &Work<impl Meter>,
    ) -> Self {
        Self::of_level(scene, at, candidates, Self::level(allowed), work)
    }

    /// The same in a pixel beside one that shows something else along their
    /// border: with finer cells, until they show that too or what they may hide
    /// does not count.
    pub(super) fn searched(
        mut self,
        scene: &Scene,
        at: (u32, u32),
        candidates: Candidates,
        allowed: f64,
        work: &Work<impl Meter>,
    ) -> Self {
        while self.may_hide_something(allowed) {
            self = Self::of_level(scene, at, candidates, self.level + 1, work);
        }
        self
    }

    fn of_level(
        scene: &Scene,
        at: (u32, u32),
        candidates: Candidates,
        level: u32,
        work: &Work<impl Meter>,
    ) -> Self {
        let look = |place: Place| sample(scene, candidates, place.window(scene, at), work);
        Self { level, looks: Place::all(level).map(look).collect() }
    }

    /// Whether it shows one thing only, and may hide a strip of another that is
    /// half as wide as a cell and covers far more than `allowed`: what is there
    /// mostly is the end of an edge, which is less.
    pub(super) fn may_hide_something(&self, allowed: f64) -> bool {
        const MOSTLY: f64 = 8.0;
        let strip = 0.5 / f64::from(1 << self.level);
        let is_finest = self.level == FINEST_BEGUN || strip < MOSTLY * allowed;
        !is_finest && self.looks.iter().all(|look| is_alike(&self.looks[0], look))
    }

    /// The same where nothing can be seen.
    pub(super) fn nothing(scene: &Scene, allowed: f64) -> Self {
        let level = Self::level(allowed);
        let look = Look::nothing(scene.background());
        Self { level, looks: Place::all(level).map(|_| look).collect() }
    }

    fn level(allowed: f64) -> u32 {
        if allowed < COARSE { 2 } else { 1 }
    }

    /// The pixels around whose middles are unlike the cells beside them.
    pub(super) fn unlike(&self, survey: &Survey, at: (u32, u32)) -> Vec<(u32, u32)> {
        let mut unlike = Vec::new();
        for (place, look) in Place::all(self.level).zip(&self.looks) {
            for way in place.ways_out() {
                if survey.beside(at, way).is_some_and(|beyond| !is_alike(look, beyond)) {
                    unlike.extend(beside(at, way));
                }
            }
        }
        unlike
    }

    /// The look into the cell that another pixel's cell borders on, which is so
    /// far right and up of this pixel's from there.
    pub(super) fn facing(&self, place: Place, (right, up): (i32, i32)) -> &Look {
        let last = (1 << self.level) - 1;
        let along = |k: u32, way: i32| match way {
            1 => 0,
            -1 => last,
            _ => k << self.level >> place.level,
        };
        &self.looks[((along(place.y, up) << self.level) + along(place.x, right)) as usize]
    }
}
