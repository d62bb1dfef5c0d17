//! Random rays and transforms, the same in every run.
#![allow(clippy::unwrap_used, dead_code)]

use tracer::glam::{DVec3, dvec3};
use tracer::shape::Plane;
use tracer::{Group, Interval, Material, Member, Object, Ray, Transform};

/// Random numbers with a fixed seed.
pub(crate) struct Any(pub(crate) fastrand::Rng);

impl Any {
    pub(crate) fn new(seed: u64) -> Self {
        Self(fastrand::Rng::with_seed(seed))
    }

    /// From -1 to 1.
    pub(crate) fn number(&mut self) -> f64 {
        2.0 * self.0.f64() - 1.0
    }

    /// In the cube from -1 to 1.
    pub(crate) fn point(&mut self) -> DVec3 {
        dvec3(self.number(), self.number(), self.number())
    }

    /// Not shorter than 0.1.
    pub(crate) fn direction(&mut self) -> DVec3 {
        std::iter::repeat_with(|| self.point()).find(|d| d.length() > 0.1).unwrap()
    }

    /// A corner of that cube.
    pub(crate) fn corner(&mut self) -> DVec3 {
        self.point().signum()
    }

    /// Turned, stretched along an axis, and turned again.
    pub(crate) fn stretching(&mut self, stretch: f64) -> Transform {
        let turn = |p: DVec3| Transform::rotation_deg(p * 180.0).unwrap();
        let scale = Transform::scale(dvec3(stretch, 1.0, 1.0)).unwrap();
        turn(self.point()).then(scale).unwrap().then(turn(self.point())).unwrap()
    }

    /// From outside or inside the cube, aimed near it; directions of many
    /// lengths.
    pub(crate) fn ray(&mut self) -> Ray {
        let origin = self.point() * 3.0;
        let length = [1e-3, 0.3, 1.0, 40.0][self.0.usize(0..4)];
        Ray::new(origin, (self.point() - origin) * length)
    }
}

/// A point through the transform, by way of a hit.
pub(crate) fn there_from_here(transform: &Transform, point: DVec3) -> DVec3 {
    let plane = Plane::new(point, DVec3::Z).unwrap();
    let ray = Ray::new(point + DVec3::Z, -DVec3::Z);
    let object = Object::new(plane.into(), Material::Normal);
    let hit = Group::world(vec![Member::Object(object)]).intersect(&ray, Interval::AHEAD).unwrap();
    transform.parent_from_object(tracer::Hit { point, ..hit }).point
}
