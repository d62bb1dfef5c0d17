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
use super::sight::Sight;
use super::{Contact, Departure, Mesh};
use crate::accel::wide::{Leaf, TimeScale, Visitor};
use crate::fault::{Fault, seeded};
use crate::meter::{Event, Meter};
use crate::simd::Simd;
use crate::{Interval, Ray};

/// A ray and what it asks of a mesh.
pub(super) struct Question<'a, M> {
    pub(super) mesh: &'a Mesh,
    pub(super) ray: &'a Ray,
    pub(super) range: Interval,
    pub(super) from: Option<Departure>,
    pub(super) meter: &'a M,
}

impl<M> Clone for Question<'_, M> {
    #[inline(always)]
    fn clone(&self) -> Self {
        *self
    }
}

// Whatever the meter is.
impl<M> Copy for Question<'_, M> {}

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

/// Looks for the closest hit.
pub(super) struct Closest<'a, S: Simd, P: Precision, T, M> {
    pub(super) question: Question<'a, M>,
    pub(super) sight: Sight<'a, S, P>,
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
    /// All of a hit, if there is one.
    #[inline(always)]
    pub(super) fn of(contact: Option<Contact>) -> Self {
        contact.map_or(Self::Nothing, Self::Contact)
    }

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

/// The best hit, with the triangle in a lane that may be met, or may be closest,
/// or neither: found out exactly.
#[cold]
#[inline(never)]
fn asked<T: Number, M: Meter>(
    question: Question<'_, M>,
    blocks: &[Block<T>],
    best: Best,
    (block, lane): (usize, usize),
) -> Best {
    let here = &blocks[block];
    let Some(contact) = asked_alone(question, here, lane) else { return best };
    if !question.may_meet(here, lane) {
        return best;
    }
    let known = match best.known {
        Known::Nothing => None,
        Known::Sure { block, lane } => asked_alone(question, &blocks[block], lane),
        Known::Contact(contact) => Some(contact),
    };
    // Of equal ones the lower number wins, as in the list.
    let order = |contact: &Contact| (contact.t, contact.part);
    let wins = known.is_none_or(|known| order(&contact) < order(&known));
    match if wins { Some(contact) } else { known } {
        Some(contact) => Best { lo: contact.t, hi: contact.t, known: Known::Contact(contact) },
        None => best,
    }
}

/// The contact with the triangle in a lane, by itself.
#[inline(always)]
fn asked_alone<T: Number, M: Meter>(
    question: Question<'_, M>,
    block: &Block<T>,
    lane: usize,
) -> Option<Contact> {
    let contact = super::decided(question.ray, block.triangle(lane), question.range)?;
    Some(Contact { part: block.numbers[lane % LANES], ..contact })
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
        let range = self.question.range;
        let seen = self.sight.look(block, (range.lo, self.best.hi));
        if seen.met == 0 {
            return false;
        }
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
            let [lo, hi] = seen.range();
            for lane in lanes(seen.met) {
                let (is_sure, lo, hi) = (seen.sure >> lane & 1 == 1, lo[lane], hi[lane]);
                if self.question.leaves(block.numbers[lane]) || is_sure && lo > self.best.hi {
                    continue;
                }
                if !(is_sure && lo > range.lo && hi < self.best.lo) {
                    *self.best = asked(self.question, self.blocks, *self.best, (place, lane));
                } else if self.question.may_meet(block, lane) {
                    *self.best = Best { lo, hi, known: Known::Sure { block: place, lane } };
                }
            }
        }
        *t_max = self.time.up(self.best.hi);
        !matches!(self.best.known, Known::Nothing) && seeded(Fault::FirstLeafWins)
    }

    #[inline(always)]
    fn address(&self, leaf: Leaf) -> *const u8 {
        self.blocks.as_ptr().wrapping_add(leaf.place()).cast()
    }
}

/// Looks for any hit.
pub(super) struct Any<'a, S: Simd, P: Precision, T, M> {
    pub(super) question: Question<'a, M>,
    pub(super) sight: Sight<'a, S, P>,
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
        let range = self.question.range;
        let seen = self.sight.look(block, (range.lo, range.hi));
        if seen.met == 0 {
            return false;
        }
        let [lo, hi] = seen.range();
        for lane in lanes(seen.met) {
            let is_sure = seen.sure >> lane & 1 == 1;
            let is_met = if is_sure && range.lo < lo[lane] && hi[lane] < range.hi {
                true
            } else if P::DOUBT == 0.0 {
                false
            } else {
                asked_alone(self.question, block, lane).is_some()
            };
            if is_met && self.question.may_meet(block, lane) {
                *self.found = Some(block.numbers[lane]);
                return true;
            }
        }
        false
    }

    #[inline(always)]
    fn address(&self, leaf: Leaf) -> *const u8 {
        self.blocks.as_ptr().wrapping_add(leaf.place()).cast()
    }
}

/// Looks for all hits.
pub(super) struct All<'a, S: Simd, P: Precision, T, M> {
    pub(super) question: Question<'a, M>,
    pub(super) sight: Sight<'a, S, P>,
    pub(super) blocks: &'a [Block<T>],
    /// The numbers of the triangles that were hit.
    pub(super) found: Vec<u32>,
}

impl<S: Simd, P: Precision, T: Number, M: Meter> Visitor for All<'_, S, P, T, M> {
    const ANY: bool = true;

    #[inline(always)]
    fn visit(&mut self, leaf: Leaf, _: &mut f32) -> bool {
        let block = &self.blocks[leaf.place()];
        let seen = self.sight.look(block, (self.question.range.lo, self.question.range.hi));
        let hit = |&lane: &usize| asked_alone(self.question, block, lane).is_some();
        self.found.extend(lanes(seen.met).filter(hit).map(|lane| block.numbers[lane]));
        false
    }

    #[inline(always)]
    fn address(&self, leaf: Leaf) -> *const u8 {
        self.blocks.as_ptr().wrapping_add(leaf.place()).cast()
    }
}
