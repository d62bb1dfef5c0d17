//! What is asked of the cone.

use tracer::Interval;
use tracer::shape::{Cone, Geometry};

use super::frustum::{Body, Contact, RAY_AT};
use crate::truth::cone::cone;
use crate::{Case, Family};

/// All its families.
pub(super) fn families() -> Vec<Family> {
    let exact = |case: &Case| cone(case.point(0), case.point(3), case.number(6), caps(case));
    // The only cap, that of the base, is part 1.
    Body { primitive: "cone", exact, contact, far_cap: 1, tip: "apex" }.families()
}

fn caps(case: &Case) -> bool {
    case.number(7) > 0.0
}

/// The tracer's first contact beyond this `t`.
pub(super) fn contact(case: &Case, beyond: f64) -> Contact {
    let shape = Cone::new(case.point(0), case.point(3), case.number(6), caps(case)).ok()?;
    let range = Interval::new(beyond, f64::INFINITY);
    shape.intersect(&case.ray(RAY_AT), range).map(|contact| (contact.t, contact.part))
}
