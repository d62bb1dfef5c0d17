//! `Group`: surfaces under one transform, and the closest hit among them.

use crate::accel::{Accelerator, Build};
use crate::shape::{Departure, Geometry, Shape};
use crate::{Aabb, Hit, Interval, Material, ObjectId, Ray, Transform};

/// A shape with what it is made of.
#[derive(Debug, Clone, PartialEq)]
pub struct Object {
    shape: Shape,
    material: Material,
    id: ObjectId,
}

impl Object {
    /// An object; its number is given by the outermost group around it.
    pub fn new(shape: Shape, material: Material) -> Self {
        Self { shape, material, id: ObjectId::default() }
    }

    fn intersect(&self, ray: &Ray, range: Interval) -> Option<Hit> {
        let contact = match self.departure(ray) {
            None => self.shape.intersect(ray, range),
            Some(from) => self.shape.intersect_leaving(ray, range, from),
        }?;
        let surface = self.shape.surface(ray, &contact);
        Some(Hit {
            t: contact.t,
            point: surface.point,
            point_error: surface.error,
            geometric_normal: surface.geometric_normal,
            shading_normal: surface.shading_normal,
            material: self.material,
            object: self.id,
            part: contact.part,
        })
    }

    fn occludes(&self, ray: &Ray, range: Interval) -> bool {
        match self.departure(ray) {
            None => self.shape.occludes(ray, range),
            Some(from) => self.shape.occludes_leaving(ray, range, from),
        }
    }

    /// From where the ray leaves this object, if it does.
    fn departure(&self, ray: &Ray) -> Option<Departure> {
        ray.leaving.filter(|(object, _)| *object == self.id).map(|(_, from)| from)
    }
}

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
            Self::Object(object) => object.shape.bounds(),
            Self::Group(group) => group.bounds,
        }
    }

    fn rounding(&self) -> f64 {
        match self {
            Self::Object(_) => 1.0,
            Self::Group(group) => group.rounding,
        }
    }

    fn intersect(&self, ray: &Ray, range: Interval) -> Option<Hit> {
        match self {
            Self::Object(object) => object.intersect(ray, range),
            Self::Group(group) => group.intersect(ray, range),
        }
    }

    fn occludes(&self, ray: &Ray, range: Interval) -> bool {
        match self {
            Self::Object(object) => object.occludes(ray, range),
            Self::Group(group) => group.occludes(ray, range),
        }
    }
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
        let boxes: Vec<_> = members.iter().map(Member::bounds).collect();
        let inside = boxes.iter().fold(Aabb::EMPTY, |all, &b| all.union(b));
        let inner = members.iter().map(Member::rounding).fold(1.0, f64::max);
        let outer = if transform.is_identity() { 1.0 } else { transform.condition() };
        let mut group = Self {
            transform: (!transform.is_identity()).then_some(transform),
            accelerator: Accelerator::build(build, &boxes, inner),
            rounding: outer * inner,
            bounds: transform.bounds(&inside),
            members,
        };
        group.number(0);
        group
    }

    /// The outermost group of a scene: no transform, the default accelerator.
    pub fn world(members: Vec<Member>) -> Self {
        Self::new(Transform::IDENTITY, members, Build::default())
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
        let closest = |ray: &Ray| {
            let test = |i: u32, range| self.members[i as usize].intersect(ray, range);
            self.accelerator.closest(ray, range, test).map(|(_, hit)| hit)
        };
        match &self.transform {
            None => closest(ray),
            Some(transform) => {
                let hit = closest(&transform.object_from_parent(ray))?;
                Some(transform.parent_from_object(hit))
            }
        }
    }

    /// Whether any member is hit inside `range`: what a shadow ray asks. Stops
    /// at the first one found.
    pub fn occludes(&self, ray: &Ray, range: Interval) -> bool {
        let any = |ray: &Ray| {
            let test = |i: u32| self.members[i as usize].occludes(ray, range);
            self.accelerator.any(ray, range, test)
        };
        match &self.transform {
            None => any(ray),
            Some(transform) => any(&transform.object_from_parent(ray)),
        }
    }

    /// Numbers the objects from `next` on, in order, groups opened in place;
    /// returns the number after the last. A group starts at 0, until another
    /// one takes it in.
    fn number(&mut self, mut next: u32) -> u32 {
        for member in &mut self.members {
            match member {
                Member::Object(object) => {
                    object.id = ObjectId(next);
                    next += 1;
                }
                Member::Group(group) => next = group.number(next),
            }
        }
        next
    }
}
