//! The shapes: geometry only, in object space, without material or transform.
//!
//! To add one: write its file with an `impl Formulas`, add its line to
//! `shapes!` below, what a test of it counts as to [`crate::Event`], its variant
//! to the scene format, and a fixture. The
//! properties of `tests/properties.rs` then need one line to cover it.

mod axial;
mod axis_box;
mod cone;
mod cylinder;
mod disk;
mod mesh;
mod plane;
mod sphere;
mod torus;
mod triangle;

pub use axis_box::AxisBox;
pub use cone::Cone;
pub use cylinder::Cylinder;
pub use disk::Disk;
pub use mesh::{Mesh, MeshNormals, MeshUvs};
pub use plane::Plane;
pub use sphere::Sphere;
pub use torus::Torus;
pub use triangle::Triangle;

use glam::DVec3;

use crate::meter::{Event, Meter};
use crate::simd::{Formula, fused};
use crate::{Aabb, Interval, Ray, UnitVec, accel};

/// Where a ray met a shape, in the few numbers that finding the closest hit
/// needs. [`Geometry::surface`] makes the rest, once, for the winner.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Contact {
    /// The ray parameter.
    pub t: f64,
    /// Which part of the shape: the face of a box, the triangle of a mesh, the
    /// side or a cap of a cylinder or cone; 0 for shapes of one part.
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

/// From where on a shape a ray leaves it: its origin is there but for
/// rounding, and a few roundings off the surface on the side that it leaves
/// to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Departure {
    /// The [`Contact::part`] that it leaves.
    pub part: u32,
    /// Whether it leaves to the side of the geometric normal, which of a
    /// closed shape is the outside.
    pub outward: bool,
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

    /// As [`Geometry::intersect`], for a ray that is known to leave this
    /// surface. Its start is then no contact, whatever the rounding; the
    /// default makes nothing of it and leaves that to the start's distance
    /// from the surface.
    fn intersect_leaving(&self, ray: &Ray, range: Interval, from: Departure) -> Option<Contact> {
        let _ = from;
        self.intersect(ray, range)
    }

    /// The surface at a contact that [`Geometry::intersect`] returned for this
    /// ray.
    fn surface(&self, ray: &Ray, contact: &Contact) -> SurfacePoint;

    /// The texture coordinates `(u, v)` of a contact with its surface point; `None`
    /// for shapes that have none. They are finite.
    fn uv(&self, contact: &Contact, surface: &SurfacePoint) -> Option<[f64; 2]> {
        let _ = (contact, surface);
        None
    }

    /// Whether anything is hit inside `range`: what a shadow ray asks.
    fn occludes(&self, ray: &Ray, range: Interval) -> bool {
        self.intersect(ray, range).is_some()
    }

    /// As [`Geometry::occludes`], for a ray that leaves this surface.
    fn occludes_leaving(&self, ray: &Ray, range: Interval, from: Departure) -> bool {
        self.intersect_leaving(ray, range, from).is_some()
    }
}

/// The formulas behind [`Geometry`] of a shape that is not made of others:
/// compiled with fused multiply-add where the processor has it, for which they
/// and what they call must be `#[inline(always)]`.
trait Formulas {
    /// [`Geometry::bounds`].
    fn extent(&self) -> Aabb;
    /// Whether a ray that leaves it like this surely never meets it again, which
    /// is asked first: no other rays are known to [`Formulas::meet`].
    fn is_left_for_good(&self, from: Departure) -> bool;
    /// [`Geometry::intersect`], or [`Geometry::intersect_leaving`] for a ray that
    /// leaves it, but not for good: one function, which is compiled once.
    fn meet(&self, ray: &Ray, range: Interval, from: Option<Departure>) -> Option<Contact>;
    /// [`Geometry::surface`].
    fn surface_at(&self, ray: &Ray, contact: &Contact) -> SurfacePoint;
    /// [`Geometry::uv`].
    fn uv_at(&self, surface: &SurfacePoint) -> Option<[f64; 2]> {
        let _ = surface;
        None
    }
}

impl<F: Formulas> Geometry for F {
    fn bounds(&self) -> Aabb {
        self.extent()
    }
    fn intersect(&self, ray: &Ray, range: Interval) -> Option<Contact> {
        fused::<Meet, _, _, _, _>(self, ray, range, None)
    }
    #[inline]
    fn intersect_leaving(&self, ray: &Ray, range: Interval, from: Departure) -> Option<Contact> {
        if self.is_left_for_good(from) {
            return None;
        }
        fused::<Meet, _, _, _, _>(self, ray, range, Some(from))
    }
    fn surface(&self, ray: &Ray, contact: &Contact) -> SurfacePoint {
        fused::<Surface, _, _, _, _>(self, ray, contact, ())
    }
    fn uv(&self, _: &Contact, surface: &SurfacePoint) -> Option<[f64; 2]> {
        self.uv_at(surface)
    }
}

/// Where a ray meets a shape.
struct Meet;

/// The surface where it does.
struct Surface;

impl<F: Formulas> Formula<&F, &Ray, Interval, Option<Departure>> for Meet {
    type Value = Option<Contact>;
    #[inline(always)]
    fn value(shape: &F, ray: &Ray, range: Interval, from: Option<Departure>) -> Option<Contact> {
        shape.meet(ray, range, from)
    }
}

impl<F: Formulas> Formula<&F, &Ray, &Contact, ()> for Surface {
    type Value = SurfacePoint;
    #[inline(always)]
    fn value(shape: &F, ray: &Ray, contact: &Contact, (): ()) -> SurfacePoint {
        shape.surface_at(ray, contact)
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
            fn intersect_leaving(&self, ray: &Ray, range: Interval, from: Departure) -> Option<Contact> {
                match self { $(Self::$name(shape) => shape.intersect_leaving(ray, range, from),)* }
            }
            fn surface(&self, ray: &Ray, contact: &Contact) -> SurfacePoint {
                match self { $(Self::$name(shape) => shape.surface(ray, contact),)* }
            }
            fn uv(&self, contact: &Contact, surface: &SurfacePoint) -> Option<[f64; 2]> {
                match self { $(Self::$name(shape) => shape.uv(contact, surface),)* }
            }
            fn occludes(&self, ray: &Ray, range: Interval) -> bool {
                match self { $(Self::$name(shape) => shape.occludes(ray, range),)* }
            }
            fn occludes_leaving(&self, ray: &Ray, range: Interval, from: Departure) -> bool {
                match self { $(Self::$name(shape) => shape.occludes_leaving(ray, range, from),)* }
            }
        }

        impl Shape {
            /// What a ray that is held against it counts as.
            pub(crate) fn event(&self) -> Event {
                match self { $(Self::$name(_) => Event::$name,)* }
            }
        }

        $(impl From<$name> for Shape {
            fn from(shape: $name) -> Self {
                Self::$name(shape)
            }
        })*
    };
}

impl Shape {
    /// [`Geometry::intersect`], or [`Geometry::intersect_leaving`] for a ray
    /// that leaves it, counted.
    pub(crate) fn meet(
        &self,
        ray: &Ray,
        range: Interval,
        from: Option<Departure>,
        meter: &impl Meter,
    ) -> Option<Contact> {
        meter.count(self.event());
        match (self, from) {
            (Self::Mesh(mesh), _) => mesh.closest(ray, range, from, meter),
            (shape, None) => shape.intersect(ray, range),
            (shape, Some(from)) => shape.intersect_leaving(ray, range, from),
        }
    }

    /// A part that is in the ray's way, if any is: [`Geometry::occludes`], or
    /// [`Geometry::occludes_leaving`] for a ray that leaves it, counted. Of a
    /// shape of many parts none but the one called `only` is asked.
    pub(crate) fn occluder(
        &self,
        ray: &Ray,
        range: Interval,
        from: Option<Departure>,
        only: Option<u32>,
        meter: &impl Meter,
    ) -> Option<u32> {
        meter.count(self.event());
        let is_met = match (self, from) {
            (Self::Mesh(mesh), _) => return mesh.occluder(ray, range, from, only, meter),
            (shape, None) => shape.occludes(ray, range),
            (shape, Some(from)) => shape.occludes_leaving(ray, range, from),
        };
        is_met.then_some(0)
    }

    /// Whether it has texture coordinates.
    pub fn has_uv(&self) -> bool {
        match self {
            Self::Sphere(_) | Self::Plane(_) => true,
            Self::Mesh(mesh) => mesh.has_uv(),
            Self::Triangle(_)
            | Self::AxisBox(_)
            | Self::Disk(_)
            | Self::Cylinder(_)
            | Self::Cone(_)
            | Self::Torus(_) => false,
        }
    }

    /// What it is, for messages.
    pub(crate) fn words(&self) -> &'static str {
        self.event().primitive().map_or("a mesh without them", |(one, _)| one)
    }

    /// Whether a test of it takes but a few nanoseconds.
    pub(crate) fn is_quick(&self) -> bool {
        match self {
            Self::Cylinder(_) | Self::Cone(_) | Self::Torus(_) | Self::Mesh(_) => false,
            Self::Sphere(_)
            | Self::Triangle(_)
            | Self::AxisBox(_)
            | Self::Plane(_)
            | Self::Disk(_) => true,
        }
    }

    /// Boxes that hold all of the shape between them.
    pub(crate) fn coarse_boxes(&self) -> Vec<Aabb> {
        match self {
            Self::Mesh(mesh) => mesh.coarse_boxes(),
            shape => vec![shape.bounds()],
        }
    }
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
    /// A cylinder.
    Cylinder,
    /// A cone.
    Cone,
    /// A torus.
    Torus,
    /// A mesh of triangles.
    Mesh,
}
