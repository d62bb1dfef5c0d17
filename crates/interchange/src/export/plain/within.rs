//! Whether a point is within a shape: shapes with a surface all around have an
//! inside, and planes have one behind them, without end.

use scene::format::Object;
use tracer::glam::DVec3;

use super::Placed;
use crate::export::text::vector;

/// Whether this point of the world is inside of an object.
pub(super) fn is_within(object: &Placed, p: DVec3) -> bool {
    let p = object.world_from_object.inverse().transform_point3(p);
    // Along an axis, from a point to another one, and the square of how far from it.
    let about = |from: DVec3, axis: DVec3| {
        let along = (p - from).dot(axis) / axis.length_squared();
        (along, (p - from - along * axis).length_squared())
    };
    match object.shape {
        // A disk has no thickness, and yet some have one behind them, but no farther than this.
        Object::Sphere { center, radius, .. } | Object::Disk { center, radius, .. } => {
            p.distance(vector(center)) < radius
        }
        Object::Box { min, max, .. } => p.cmpgt(vector(min)).all() && p.cmplt(vector(max)).all(),
        Object::Plane { point, normal, .. } => (p - vector(point)).dot(vector(normal)) < 0.0,
        Object::Torus { center, axis, major_radius, minor_radius, .. } => {
            let axis = vector(axis).normalize_or_zero();
            let (along, square) = about(vector(center), axis);
            (square.sqrt() - major_radius).hypot(along) < minor_radius
        }
        // An open one is as one with caps here.
        Object::Cylinder { a, b, radius, .. } => {
            let (along, square) = about(vector(a), vector(b) - vector(a));
            0.0 < along && along < 1.0 && square < radius * radius
        }
        Object::Cone { apex, base, radius, .. } => {
            let (along, square) = about(vector(apex), vector(base) - vector(apex));
            0.0 < along && along < 1.0 && square < (along * radius) * (along * radius)
        }
        // Their triangles need not close.
        Object::Triangle { .. } | Object::Mesh { .. } | Object::Group { .. } => false,
    }
}
