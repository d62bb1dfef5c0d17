//! Where a ray first meets a cone, exactly.

use tracer::glam::DVec3;

use super::frustum::Frustum;

/// The cone that widens from its apex to `radius` at its base, closed by a
/// disk there or open. Its cap is that of end `b`: part 2 of the frustum.
pub fn cone(apex: DVec3, base: DVec3, radius: f64, caps: bool) -> Frustum {
    Frustum { a: apex, b: base, radius_a: 0.0, radius_b: radius, caps }
}
