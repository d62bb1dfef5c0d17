//! What a walk through a mesh's hierarchy does at its leaves: the closest hit,
//! or any.
//!
//! In accurate mode a leaf is looked at in plain `f64` with a bound of the
//! error. What that decides is decided; for the rest, and for the winner's
//! numbers, [`Shear`] has the last word. So the answer is that of a loop over
//! all triangles, whatever was looked at.

use super::super::triangle::Shear;
use super::blocks::{Block, LANES, Number};
use super::precision::Precision;
use super::sight::{Meetings, Sight};
use super::{Contact, Departure, Mesh};
use crate::accel::wide::{Leaf, TimeScale, Visitor};
use crate::meter::{Event, Meter};
use crate::simd::{Simd, Work};
use crate::{Interval, Ray};

/// A ray and what it asks of a mesh.
#[derive(Clone, Copy)]
pub(super) struct Question<'a, M> {
    pub(super) mesh: &'a Mesh,
    pub(super) ray: &'a Ray,
    pub(super) range: Interval,
    pub(super) from: Option<Departure>,
    pub(super) meter: &'a M,
}

impl<M: Meter> Question<'_, M> {
    /// Whether the ray may meet the triangle of this number in a lane of a block.
    #[inline(always)]
    fn may_meet<T: Number>(&self, block: &Block<T>, lane: usize) -> bool {
        self.from.is_none_or(|from| {
            let number = block.numbers[lane];
            self.mesh.may_meet(self.ray.direction, from, number, block.triangle(lane))
        })
    }

    /// The contact with the triangle in a lane, as exactly as can be.
    #[inline(always)]
    fn decide<T: Number>(&self, block: &Block<T>, lane: usize) -> Option<Contact> {
        let contact = Shear::new(self.ray).decide(block.triangle(lane), self.range)?;
        Some(Contact { part: block.numbers[lane], ..contact })
    }

    /// Whether the ray leaves this very triangle.
    #[inline(always)]
    fn leaves(&self, number: u32) -> bool {
        self.from.is_some_and(|from| from.part == number)
    }
}

/// Whether the ray meets the triangle in a lane: asked where a look has not
/// settled it, which is rare.
struct Decide<'a, T, M> {
    question: &'a Question<'a, M>,
    block: &'a Block<T>,
    lane: usize,
}

impl<T: Number, M: Meter> Work for Decide<'_, T, M> {
    type Output = bool;
    #[inline(always)]
    fn run<S: Simd>(self, _: S) -> bool {
        self.question.decide(self.block, self.lane).is_some()
    }
}

/// Looks for the closest hit.
pub(super) struct Closest<'a, S: Simd, P: Precision, T, M> {
    pub(super) simd: S,
    pub(super) question: &'a Question<'a, M>,
    pub(super) sight: Sight<S, P>,
    pub(super) blocks: &'a [Block<T>],
    pub(super) time: TimeScale,
    pub(super) best: &'a mut Best,
}

/// The best hit so far.
#[derive(Clone, Copy)]
pub(super) struct Best {
    /// Its `t` is between these; at first, where the range ends.
    lo: f64,
    hi: f64,
    pub(super) known: Known,
}

/// What is known of a first hit.
#[derive(Clone, Copy)]
pub(super) enum Known {
    /// There is none.
    Nothing,
    /// It is the triangle in this lane of this block, for sure.
    Sure { block: usize, lane: usize },
    /// All.
    Contact(Contact),
}

impl Best {
    /// Nothing yet.
    #[inline(always)]
    pub(super) fn nothing(range: Interval) -> Self {
        Self { lo: range.hi, hi: range.hi, known: Known::Nothing }
    }
}

impl Known {
    /// The hit in numbers.
    #[inline(always)]
    pub(super) fn contact<T: Number, M: Meter>(
        self,
        question: &Question<'_, M>,
        blocks: &[Block<T>],
    ) -> Option<Contact> {
        match self {
            Self::Nothing => None,
            Self::Sure { block, lane } => question.decide(&blocks[block], lane),
            Self::Contact(contact) => Some(contact),
        }
    }
}

impl<S: Simd, P: Precision, T: Number, M: Meter> Closest<'_, S, P, T, M> {
    /// One that may be met, or may be closest, or neither: found out exactly.
    #[cold]
    fn ask(&mut self, block: usize, lane: usize) {
        let here = &self.blocks[block];
        let Some(contact) = self.question.decide(here, lane) else { return };
        if !self.question.may_meet(here, lane) {
            return;
        }
        let best = self.best.known.contact(self.question, self.blocks);
        // Of equal ones the lower number wins, as in the list.
        let order = |contact: &Contact| (contact.t, contact.part);
        let wins = best.is_none_or(|best| order(&contact) < order(&best));
        if let Some(best) = if wins { Some(contact) } else { best } {
            *self.best = Best { lo: best.t, hi: best.t, known: Known::Contact(best) };
        }
    }
}

/// The lanes of the bits, lowest first.
#[inline(always)]
fn lanes(mut bits: u32) -> impl Iterator<Item = usize> {
    std::iter::from_fn(move || {
        let lane = bits.trailing_zeros() as usize;
        bits &= bits.wrapping_sub(1);
        (lane < LANES).then_some(lane)
    })
}

impl<S: Simd, P: Precision, T: Number, M: Meter> Visitor for Closest<'_, S, P, T, M> {
    const ANY: bool = false;

    #[inline(always)]
    fn start(&mut self, time: TimeScale) {
        self.time = time;
    }

    #[inline(always)]
    fn visit(&mut self, leaf: Leaf, t_max: &mut f32) -> bool {
        let place = leaf.place();
        let block = &self.blocks[place];
        self.question.meter.count_many(Event::Triangle, || block.count());
        let Some(seen) = self.sight.look(self.simd, block) else { return false };
        let range = self.question.range;
        if P::DOUBT == 0.0 {
            let t = seen.t();
            for lane in lanes(seen.met) {
                let t = t[lane];
                if range.lo < t && t < self.best.lo && self.question.may_meet(block, lane) {
                    let [beta, gamma] = seen.weights();
                    let barycentric = [beta[lane], gamma[lane]];
                    let contact = Contact { t, part: block.numbers[lane], barycentric };
                    *self.best = Best { lo: t, hi: t, known: Known::Contact(contact) };
                }
            }
        } else {
            let Meetings { sure, lo, hi } = self.sight.meetings(self.simd, &seen);
            for lane in lanes(seen.met) {
                let (is_sure, lo, hi) = (sure >> lane & 1 == 1, lo[lane], hi[lane]);
                if is_sure && (lo > self.best.hi || hi < range.lo)
                    || self.question.leaves(block.numbers[lane])
                {
                    continue;
                }
                if !(is_sure && lo > range.lo && hi < self.best.lo) {
                    self.ask(place, lane);
                } else if self.question.may_meet(block, lane) {
                    *self.best = Best { lo, hi, known: Known::Sure { block: place, lane } };
                }
            }
        }
        *t_max = self.time.up(self.best.hi);
        false
    }

    #[inline(always)]
    fn expect(&self, leaf: Leaf) {
        if let Some(block) = self.blocks.get(leaf.place()) {
            self.simd.prefetch(block);
        }
    }
}

/// Looks for any hit.
pub(super) struct Any<'a, S: Simd, P: Precision, T, M> {
    pub(super) simd: S,
    pub(super) question: &'a Question<'a, M>,
    pub(super) sight: Sight<S, P>,
    pub(super) blocks: &'a [Block<T>],
    /// Which triangle was hit.
    pub(super) found: &'a mut Option<u32>,
}

impl<S: Simd, P: Precision, T: Number, M: Meter> Visitor for Any<'_, S, P, T, M> {
    const ANY: bool = true;

    #[inline(always)]
    fn visit(&mut self, leaf: Leaf, _: &mut f32) -> bool {
        let block = &self.blocks[leaf.place()];
        self.question.meter.count_many(Event::Triangle, || block.count());
        let Some(seen) = self.sight.look(self.simd, block) else { return false };
        let range = self.question.range;
        let known = if P::DOUBT == 0.0 {
            let t = seen.t();
            Meetings { sure: seen.met, lo: t, hi: t }
        } else {
            self.sight.meetings(self.simd, &seen)
        };
        for lane in lanes(seen.met) {
            let is_sure = known.sure >> lane & 1 == 1;
            let t = Interval::new(known.lo[lane], known.hi[lane]);
            let is_met = if is_sure && range.lo < t.lo && t.hi < range.hi {
                true
            } else if P::DOUBT == 0.0 || is_sure && !(t.lo < range.hi && range.lo < t.hi) {
                false
            } else {
                self.simd.apart(Decide { question: self.question, block, lane })
            };
            if is_met && self.question.may_meet(block, lane) {
                *self.found = Some(block.numbers[lane]);
                return true;
            }
        }
        false
    }

    #[inline(always)]
    fn expect(&self, leaf: Leaf) {
        if let Some(block) = self.blocks.get(leaf.place()) {
            self.simd.prefetch(block);
        }
    }
}

/// Looks for all hits.
pub(super) struct All<'a, S: Simd, P: Precision, T, M> {
    pub(super) simd: S,
    pub(super) question: &'a Question<'a, M>,
    pub(super) sight: Sight<S, P>,
    pub(super) blocks: &'a [Block<T>],
    /// The numbers of the triangles that were hit.
    pub(super) found: Vec<u32>,
}

impl<S: Simd, P: Precision, T: Number, M: Meter> Visitor for All<'_, S, P, T, M> {
    const ANY: bool = true;

    #[inline(always)]
    fn visit(&mut self, leaf: Leaf, _: &mut f32) -> bool {
        let block = &self.blocks[leaf.place()];
        if let Some(seen) = self.sight.look(self.simd, block) {
            let hit = |&lane: &usize| self.question.decide(block, lane).is_some();
            self.found.extend(lanes(seen.met).filter(hit).map(|lane| block.numbers[lane]));
        }
        false
    }

    #[inline(always)]
    fn expect(&self, _: Leaf) {}
}
