//! The shapes: geometry only, in object space, without material or transform.
//!
//! To add one: write its file with an `impl Geometry`, add its line to
//! `shapes!` below, its variant to the scene format, and a fixture. The
//! properties of `tests/properties.rs` then need one line to cover it.

mod axis_box;
mod disk;
mod mesh;
mod plane;
mod sphere;
mod triangle;

pub use axis_box::AxisBox;
pub use disk::Disk;
pub use mesh::{Mesh, MeshNormals};
pub use plane::Plane;
pub use sphere::Sphere;
pub use triangle::Triangle;

use glam::DVec3;

use crate::{Aabb, Interval, Ray, UnitVec, accel};

/// Where a ray met a shape, in the few numbers that finding the closest hit
/// needs. [`Geometry::surface`] makes the rest, once, for the winner.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Contact {
    /// The ray parameter.
    pub t: f64,
    /// Which part of the shape: the face of a box, the triangle of a mesh;
    /// 0 for shapes of one part.
    pub part: u32,
    /// Weights `beta` and `gamma` of a triangle's second and third corner;
    /// 0 for other shapes.
    pub barycentric: [f64; 2],
}

impl Contact {
    /// A contact with a shape of one part.
    pub const fn at(t: f64) -> Self {
        Self { t, part: 0, barycentric: [0.0; 2] }
    }
}

impl accel::Candidate for Contact {
    fn t(&self) -> f64 {
        self.t
    }
}

/// The surface around a contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SurfacePoint {
    /// The point, put back onto the surface.
    pub point: DVec3,
    /// A bound of the distance from `point` to the true surface, which also
    /// is how far a leaving ray must start off it to miss it.
    pub error: f64,
    /// The outward normal of the true surface.
    pub geometric_normal: UnitVec,
    /// The normal to shade with.
    pub shading_normal: UnitVec,
}

/// What every shape can say.
pub trait Geometry {
    /// A finite box around the shape, or [`Aabb::EVERYTHING`].
    fn bounds(&self) -> Aabb;

    /// The contact with the lowest `t` strictly inside `range`, for a
    /// direction of any length. A ray that starts inside a closed shape meets
    /// its far side. NaN in a ray is a miss.
    fn intersect(&self, ray: &Ray, range: Interval) -> Option<Contact>;

    /// The surface at a contact that [`Geometry::intersect`] returned for this
    /// ray.
    fn surface(&self, ray: &Ray, contact: &Contact) -> SurfacePoint;

    /// Whether anything is hit inside `range`: what a shadow ray asks.
    fn occludes(&self, ray: &Ray, range: Interval) -> bool {
        self.intersect(ray, range).is_some()
    }
}

/// Makes the enum of all shapes and its dispatch from one list.
macro_rules! shapes {
    ($($(#[$doc:meta])* $name:ident,)*) => {
        /// Any shape.
        #[derive(Debug, Clone, PartialEq)]
        pub enum Shape {
            $($(#[$doc])* $name($name),)*
        }

        impl Geometry for Shape {
            fn bounds(&self) -> Aabb {
                match self { $(Self::$name(shape) => shape.bounds(),)* }
            }
            fn intersect(&self, ray: &Ray, range: Interval) -> Option<Contact> {
                match self { $(Self::$name(shape) => shape.intersect(ray, range),)* }
            }
            fn surface(&self, ray: &Ray, contact: &Contact) -> SurfacePoint {
                match self { $(Self::$name(shape) => shape.surface(ray, contact),)* }
            }
            fn occludes(&self, ray: &Ray, range: Interval) -> bool {
                match self { $(Self::$name(shape) => shape.occludes(ray, range),)* }
            }
        }

        $(impl From<$name> for Shape {
            fn from(shape: $name) -> Self {
                Self::$name(shape)
            }
        })*
    };
}

shapes! {
    /// A sphere.
    Sphere,
    /// A triangle.
    Triangle,
    /// An axis-aligned box.
    AxisBox,
    /// An infinite plane.
    Plane,
    /// A disk.
    Disk,
    /// A mesh of triangles.
    Mesh,
}
