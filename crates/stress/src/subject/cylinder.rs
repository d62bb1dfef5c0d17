//! What is asked of the cylinder.

use tracer::Interval;
use tracer::shape::{Cylinder, Geometry};

use super::frustum::{Body, Contact, RAY_AT};
use crate::truth::cylinder::cylinder;
use crate::{Case, Family};

/// All its families.
pub(super) fn families() -> Vec<Family> {
    let exact = |case: &Case| cylinder(case.point(0), case.point(3), case.number(6), caps(case));
    // The cap at `b` is part 2.
    Body { primitive: "cylinder", exact, contact, far_cap: 2, tip: "center" }.families()
}

fn caps(case: &Case) -> bool {
    case.number(7) > 0.0
}

/// The tracer's first contact beyond this `t`.
pub(super) fn contact(case: &Case, beyond: f64) -> Contact {
    let shape = Cylinder::new(case.point(0), case.point(3), case.number(6), caps(case)).ok()?;
    let range = Interval::new(beyond, f64::INFINITY);
    shape.intersect(&case.ray(RAY_AT), range).map(|contact| (contact.t, contact.part))
}
