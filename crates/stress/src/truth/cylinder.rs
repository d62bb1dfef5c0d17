//! Where a ray first meets a cylinder, exactly.

use tracer::glam::DVec3;

use super::frustum::Frustum;

/// The cylinder about the axis from `a` to `b`, closed by disks or open.
pub fn cylinder(a: DVec3, b: DVec3, radius: f64, caps: bool) -> Frustum {
    Frustum { a, b, radius_a: radius, radius_b: radius, caps }
}
