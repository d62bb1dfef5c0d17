//! `Group`: surfaces under one transform, and the closest hit among them.

use crate::accel::{Accelerator, Build, end_after};
use crate::fault::{Fault, seeded};
use crate::meter::{Event, Meter, Unmetered};
use crate::plan::Candidates;
use crate::shape::Geometry;
use crate::{Aabb, Hit, Interval, Object, Ray, Transform};

/// What a group holds: objects and other groups.
#[derive(Debug, Clone, PartialEq)]
pub enum Member {
    /// A shape with a material.
    Object(Object),
    /// A group in this group's space.
    Group(Group),
}

impl Member {
    fn bounds(&self) -> Aabb {
        match self {
            Self::Object(object) => object.shape().bounds(),
            Self::Group(group) => group.bounds,
        }
    }

    /// Whether a test of it takes no longer than one of eight boxes.
    fn is_quick(&self) -> bool {
        match self {
            Self::Object(object) => object.shape().is_quick(),
            Self::Group(_) => false,
        }
    }

    fn rounding(&self) -> f64 {
        match self {
            Self::Object(_) => 1.0,
            Self::Group(group) => group.rounding,
        }
    }

    /// See [`Group::meet`].
    fn meet(
        &self,
        ray: &Ray,
        range: Interval,
        meter: &impl Meter,
        hit: &mut Option<Hit>,
    ) -> Option<f64> {
        match self {
            Self::Object(object) => object.meet(ray, range, meter, hit),
            Self::Group(group) => group.meet(ray, range, meter, hit),
        }
    }

    /// A part of it that is in the ray's way, or if it is the one called `only`;
    /// of a group nothing is known but that it is.
    fn occluder(
        &self,
        ray: &Ray,
        range: Interval,
        only: Option<u32>,
        meter: &impl Meter,
    ) -> Option<u32> {
        match (self, only) {
            (Self::Object(object), _) => object.occluder(ray, range, only, meter),
            (Self::Group(group), None) => group.occluder(ray, range, None, meter).map(|_| 0),
            (Self::Group(_), Some(_)) => None,
        }
    }
}

/// Who is in a ray's way.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Occluder {
    /// Which member of the group.
    pub(crate) member: u32,
    /// Which part of it, if it is an object.
    pub(crate) part: u32,
}

/// Hears of an object: in which member of the group it is, the boxes that hold
/// it, and how it stands there.
pub(crate) type Visit<'a> = dyn FnMut(usize, &Object, &[Aabb], Placed) + 'a;

/// How an object stands in a group's space.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Placed {
    /// Whether a transform is between the object and the group.
    pub(crate) moved: bool,
    /// How many times more than its shape's own formulas its hits round.
    pub(crate) rounding: f64,
}

/// Members in a space of their own, placed in the parent's by a transform.
/// A group may be empty; it is never hit.
#[derive(Debug, Clone, PartialEq)]
pub struct Group {
    /// `None` is the identity, which is left out and costs nothing.
    transform: Option<Transform>,
    members: Vec<Member>,
    accelerator: Accelerator,
    /// In the parent's space.
    bounds: Aabb,
    /// How many times more than a shape's own formulas its hits round.
    rounding: f64,
}

impl Group {
    /// A group whose members' space is placed by `transform`.
    pub fn new(transform: Transform, members: Vec<Member>, build: Build) -> Self {
        /// So many quick tests take no longer than asking which are needed.
        const FEW: usize = 3;
        let few = members.len() <= FEW && members.iter().all(Member::is_quick);
        let build = if few { Build::List } else { build };
        let boxes: Vec<_> = members.iter().map(Member::bounds).collect();
        let inside = boxes.iter().fold(Aabb::EMPTY, |all, &b| all.union(b));
        let inner = members.iter().map(Member::rounding).fold(1.0, f64::max);
        let outer = if transform.is_identity() { 1.0 } else { transform.condition() };
        let mut group = Self {
            transform: (!transform.is_identity()).then_some(transform),
            accelerator: Accelerator::build(build, &boxes, inner),
            rounding: outer * inner,
            bounds: if seeded(Fault::GroupBoxNotMoved) {
                inside
            } else {
                transform.bounds(&inside)
            },
            members,
        };
        group.number(0);
        group
    }

    /// The outermost group of a scene: no transform, the default accelerator.
    pub fn world(members: Vec<Member>) -> Self {
        Self::new(Transform::IDENTITY, members, Build::default())
    }

    /// Which members are groups.
    pub(crate) fn inner_groups(&self) -> impl Iterator<Item = usize> {
        let is_group = |(_, member): &(usize, &Member)| matches!(member, Member::Group(_));
        self.members.iter().enumerate().filter(is_group).map(|(i, _)| i)
    }

    /// A box around all members, in the parent's space.
    pub fn bounds(&self) -> Aabb {
        self.bounds
    }

    /// The lecture's `Group.intersect(ray, tMin, tMax)`: the closest hit of
    /// any member strictly inside `range`. The ray goes in by the inverse
    /// transform, not renormalized, so `t` compares across groups.
    ///
    /// Source: slide "Intersection against many shapes".
    pub fn intersect(&self, ray: &Ray, range: Interval) -> Option<Hit> {
        self.intersect_metered(ray, range, &Unmetered)
    }

    /// [`Group::intersect`], counted.
    pub(crate) fn intersect_metered(
        &self,
        ray: &Ray,
        range: Interval,
        meter: &impl Meter,
    ) -> Option<Hit> {
        let mut hit = None;
        self.meet(ray, range, meter, &mut hit);
        hit
    }

    /// The `t` of the closest hit inside `range`, which is put where the best one
    /// so far is: whoever asks makes the range end there, and a hit is too large
    /// to be handed on and on.
    fn meet(
        &self,
        ray: &Ray,
        range: Interval,
        meter: &impl Meter,
        hit: &mut Option<Hit>,
    ) -> Option<f64> {
        let mut closest = |ray: &Ray| {
            let test = |i: u32, range| self.members[i as usize].meet(ray, range, meter, hit);
            self.accelerator.closest(ray, range, meter, test).map(|(_, t)| t)
        };
        let Some(transform) = &self.transform else { return closest(ray) };
        meter.count(Event::Group);
        let t = closest(&transform.object_from_parent(ray))?;
        *hit = hit.map(|hit| transform.parent_from_object(hit));
        Some(t)
    }

    /// Whether any member is hit inside `range`: what a shadow ray asks. Stops
    /// at the first one found.
    pub fn occludes(&self, ray: &Ray, range: Interval) -> bool {
        self.occluder(ray, range, None, &Unmetered).is_some()
    }

    /// Who is in the ray's way, if anybody is, counted: [`Group::occludes`].
    /// Whoever is `first` is tried before all others, which changes the way to
    /// the answer and which one is found, not whether there is one.
    pub(crate) fn occluder(
        &self,
        ray: &Ray,
        range: Interval,
        first: Option<Occluder>,
        meter: &impl Meter,
    ) -> Option<Occluder> {
        let is_met = |ray: &Ray, member: u32, only: Option<u32>| {
            let part = self.members[member as usize].occluder(ray, range, only, meter)?;
            Some(Occluder { member, part })
        };
        let any = |ray: &Ray| {
            let hint = first.filter(|hint| (hint.member as usize) < self.members.len());
            let mut found = hint.and_then(|hint| is_met(ray, hint.member, Some(hint.part)));
            if found.is_none() {
                self.accelerator.any(ray, range, meter, |member| {
                    found = is_met(ray, member, None);
                    found.is_some()
                });
            }
            found
        };
        match &self.transform {
            None => any(ray),
            Some(transform) => {
                meter.count(Event::Group);
                any(&transform.object_from_parent(ray))
            }
        }
    }

    /// [`Group::intersect`] of a group without a transform, for a ray that can
    /// meet no other members than these.
    pub(crate) fn intersect_among(
        &self,
        candidates: Candidates,
        ray: &Ray,
        range: Interval,
        meter: &impl Meter,
    ) -> Option<Hit> {
        let (Candidates::These(mut bits), None) = (candidates, &self.transform) else {
            return self.intersect_metered(ray, range, meter);
        };
        // As the list does: a later one must be strictly closer.
        let (mut t_best, mut closest) = (range.hi, None);
        while bits != 0 {
            let member = &self.members[bits.trailing_zeros() as usize];
            bits &= bits - 1;
            let end = end_after(t_best, closest.is_some(), range);
            if let Some(t) = member.meet(ray, range.until(end), meter, &mut closest) {
                t_best = t;
            }
        }
        closest
    }

    /// Calls `visit` with every object, the boxes being in the space of this
    /// group's parent.
    pub(crate) fn visit(&self, visit: &mut Visit<'_>) {
        for (i, member) in self.members.iter().enumerate() {
            match member {
                Member::Object(object) => {
                    self.place(&object.shape().coarse_boxes(), 1.0, |boxes, placed| {
                        visit(i, object, boxes, placed);
                    });
                }
                Member::Group(group) => group.visit(&mut |_, object, boxes, placed| {
                    let inner = placed.rounding;
                    self.place(boxes, inner, |boxes, here| {
                        let moved = placed.moved || here.moved;
                        visit(i, object, boxes, Placed { moved, ..here });
                    });
                }),
            }
        }
    }

    fn place(&self, boxes: &[Aabb], rounding: f64, place: impl FnOnce(&[Aabb], Placed)) {
        match &self.transform {
            None => place(boxes, Placed { moved: false, rounding }),
            Some(transform) => {
                let boxes: Vec<_> = boxes.iter().map(|b| transform.bounds(b)).collect();
                place(&boxes, Placed { moved: true, rounding: rounding * transform.condition() });
            }
        }
    }

    /// Numbers the objects from `next` on, in order, groups opened in place;
    /// returns the number after the last. A group starts at 0, until another
    /// one takes it in.
    fn number(&mut self, mut next: u32) -> u32 {
        for member in &mut self.members {
            match member {
                Member::Object(object) => {
                    object.set_number(next);
                    next += 1;
                }
                Member::Group(group) => next = group.number(next),
            }
        }
        next
    }
}
