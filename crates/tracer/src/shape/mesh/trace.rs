//! A mesh's answers to one ray, by a list, a few blocks or the hierarchy.

use super::blocks::{Block, Blocks, Number};
use super::precision::{Accurate, Fast, Precision};
use super::sight::{Sight, Sighted};
use super::visit::{All, Any, Best, Closest, Known, Question};
use super::{Contact, Departure, Event, Interval, Mesh, Meter, Order, Ray, Shear, Unmetered};
use crate::accel::wide::{Leaf, TimeScale, Visitor};
use crate::simd::{Simd, Work, run_plainly};

impl Mesh {
    /// How many of its triangles the ray crosses inside `range`, near and far:
    /// odd for a ray from inside a closed mesh, even from outside.
    pub fn crossings(&self, ray: &Ray, range: Interval) -> u32 {
        let shear = Shear::new(ray);
        if let Order::List(list) = &self.order {
            let mut count = 0;
            list.any(|i| {
                count += u32::from(self.contact(&shear, i, range).is_some());
                false
            });
            return count;
        }
        let question = self.question(ray, range, None, &Unmetered);
        let mut found = run_plainly(Crossed(&question));
        // One that is in several leaves is found in each.
        found.sort_unstable();
        found.dedup();
        found.len() as u32
    }

    /// The first contact of a ray, which may leave one of the triangles.
    pub(in super::super) fn closest<M: Meter>(
        &self,
        ray: &Ray,
        range: Interval,
        from: Option<Departure>,
        meter: &M,
    ) -> Option<Contact> {
        if let Order::List(list) = &self.order {
            let shear = Shear::new(ray);
            let test = |i, range| {
                meter.count(Event::Triangle);
                self.contact(&shear, i, range).filter(|_| self.is_open(ray, from, i))
            };
            let (part, contact) = list.closest(range, test)?;
            return Some(Contact { part, ..contact });
        }
        M::run(self.level, ClosestOf(&self.question(ray, range, from, meter)))
    }

    /// A triangle that the ray meets: any, or if it does the one called `only`.
    pub(in super::super) fn occluder<M: Meter>(
        &self,
        ray: &Ray,
        range: Interval,
        from: Option<Departure>,
        only: Option<u32>,
        meter: &M,
    ) -> Option<u32> {
        let shear = Shear::new(ray);
        let is_met = |i| {
            meter.count(Event::Triangle);
            self.contact(&shear, i, range).is_some() && self.is_open(ray, from, i)
        };
        if let Some(only) = only {
            return is_met(only).then_some(only);
        }
        if let Order::List(list) = &self.order {
            let mut found = None;
            list.any(|i| {
                found = is_met(i).then_some(i);
                found.is_some()
            });
            return found;
        }
        M::run(self.level, AnyOf(&self.question(ray, range, from, meter)))
    }

    /// The contact with one triangle.
    fn contact(&self, shear: &Shear, triangle: u32, range: Interval) -> Option<Contact> {
        shear.intersect(self.corners(triangle)?, range)
    }

    /// Whether a ray that leaves `from` may meet this triangle.
    fn is_open(&self, ray: &Ray, from: Option<Departure>, triangle: u32) -> bool {
        from.is_none_or(|from| {
            let corners = self.corners(triangle);
            corners.is_some_and(|corners| self.may_meet(ray.direction, from, triangle, corners))
        })
    }

    #[inline(always)]
    fn question<'a, M: Meter>(
        &'a self,
        ray: &'a Ray,
        range: Interval,
        from: Option<Departure>,
        meter: &'a M,
    ) -> Question<'a, M> {
        Question { mesh: self, ray, range, from, meter }
    }
}

/// Shows the visitor what the ray may meet of the mesh.
#[inline(always)]
fn show<S: Simd, V: Visitor, M: Meter>(simd: S, question: &Question<'_, M>, visitor: &mut V) {
    let Question { mesh, ray, range, meter, .. } = question;
    if let Order::Wide(wide) = &mesh.order {
        wide.walk_ray(simd, ray, *range, *meter, visitor);
        return;
    }
    let mut t_max = f32::INFINITY;
    for place in 0..mesh.blocks.len() as u32 {
        if visitor.visit(Leaf::new(place, 1), &mut t_max) {
            break;
        }
    }
}

/// Calls a function that has a precision and a number of storage for the mesh's.
macro_rules! by_storage {
    ($mesh:expr, $call:ident $(::<$more:tt>)? ($($arg:expr),*)) => {
        match (&$mesh.blocks, $mesh.is_fast) {
            (Blocks::Single(blocks), false) => $call::<S, Accurate, _ $(, $more)?>($($arg,)* blocks),
            (Blocks::Single(blocks), true) => $call::<S, Fast, _ $(, $more)?>($($arg,)* blocks),
            (Blocks::Double(blocks), _) => $call::<S, Accurate, _ $(, $more)?>($($arg,)* blocks),
        }
    };
}
pub(super) use by_storage;

#[inline(always)]
fn closest<S: Simd, P: Precision, T: Number, M: Meter>(
    simd: S,
    question: &Question<'_, M>,
    blocks: &[Block<T>],
) -> Known {
    let (sighted, mut best) = (question.sighted::<P>(), Best::nothing(question.range));
    let mut visitor = Closest {
        question: *question,
        sight: Sight::new(simd, &sighted),
        blocks,
        time: TimeScale::ANY,
        best: &mut best,
    };
    show(simd, question, &mut visitor);
    best.known
}

#[inline(always)]
fn contact<S: Simd, P: Precision, T: Number, M: Meter>(
    simd: S,
    question: &Question<'_, M>,
    blocks: &[Block<T>],
) -> Option<Contact> {
    closest::<S, P, T, M>(simd, question, blocks).contact(question, blocks)
}

#[inline(always)]
fn any<S: Simd, P: Precision, T: Number, M: Meter>(
    simd: S,
    question: &Question<'_, M>,
    blocks: &[Block<T>],
) -> Option<u32> {
    let sighted = question.sighted::<P>();
    let sight = Sight::new(simd, &sighted);
    let mut found = None;
    show(simd, question, &mut Any { question: *question, sight, blocks, found: &mut found });
    found
}

#[inline(always)]
fn crossed<S: Simd, P: Precision, T: Number, M: Meter>(
    simd: S,
    question: &Question<'_, M>,
    blocks: &[Block<T>],
) -> Vec<u32> {
    let sighted = question.sighted::<P>();
    let sight = Sight::new(simd, &sighted);
    let mut visitor = All { question: *question, sight, blocks, found: Vec::new() };
    show(simd, question, &mut visitor);
    visitor.found
}

impl<M: Meter> Question<'_, M> {
    #[inline(always)]
    fn sighted<P: Precision>(&self) -> Sighted<P> {
        Sighted::new(self.ray, self.mesh.middle, self.mesh.half)
    }
}

struct ClosestOf<'a, M>(&'a Question<'a, M>);

impl<M: Meter> Work for ClosestOf<'_, M> {
    type Output = Option<Contact>;
    #[inline(always)]
    fn run<S: Simd>(self, simd: S) -> Option<Contact> {
        by_storage!(self.0.mesh, contact::<M>(simd, self.0))
    }
}

struct AnyOf<'a, M>(&'a Question<'a, M>);

impl<M: Meter> Work for AnyOf<'_, M> {
    type Output = Option<u32>;
    #[inline(always)]
    fn run<S: Simd>(self, simd: S) -> Option<u32> {
        by_storage!(self.0.mesh, any::<M>(simd, self.0))
    }
}

struct Crossed<'a, M>(&'a Question<'a, M>);

impl<M: Meter> Work for Crossed<'_, M> {
    type Output = Vec<u32>;
    #[inline(always)]
    fn run<S: Simd>(self, simd: S) -> Vec<u32> {
        by_storage!(self.0.mesh, crossed::<M>(simd, self.0))
    }
}
