//! Cases as the textbook kernels take them: a primitive and a ray, in a
//! precision.

use tracer::glam::DVec3;

use super::{Ray, Real, Vector, sphere, triangle};
use crate::Case;

/// A vector in the precision.
fn vector<R: Real>(p: DVec3) -> Vector<R> {
    p.to_array().map(R::of)
}

/// A ray in the precision.
fn in_precision<R: Real>(ray: &tracer::Ray) -> Ray<R> {
    Ray { origin: vector(ray.origin), direction: vector(ray.direction) }
}

/// A sphere and a ray, in a precision.
pub struct AtSphere<R> {
    /// The first four numbers: center and radius.
    pub sphere: sphere::Sphere<R>,
    /// The other six.
    pub ray: Ray<R>,
}

impl<R: Real> AtSphere<R> {
    /// The case, each number rounded to the precision.
    pub fn new(case: &Case) -> Self {
        let (center, radius) = (vector(case.point(0)), R::of(case.number(3)));
        Self { sphere: sphere::Sphere { center, radius }, ray: in_precision(&case.ray(4)) }
    }
}

/// A triangle and a ray, in a precision.
pub struct AtTriangle<R> {
    /// The first nine numbers.
    pub corners: triangle::Corners<R>,
    /// The other six.
    pub ray: Ray<R>,
}

impl<R: Real> AtTriangle<R> {
    /// The case, each number rounded to the precision.
    pub fn new(case: &Case) -> Self {
        Self::of([0, 3, 6].map(|first| case.point(first)), &case.ray(9))
    }

    /// These corners and this ray, each number rounded to the precision.
    pub fn of(corners: [DVec3; 3], ray: &tracer::Ray) -> Self {
        Self { corners: corners.map(vector), ray: in_precision(ray) }
    }
}
