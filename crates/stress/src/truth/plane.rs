//! The exact hit of a plane.
//!
//! A case is a point of the plane, its normal of any length and the ray:
//! twelve numbers.

use std::cmp::Ordering;

use tracer::Ray;
use tracer::glam::DVec3;

use super::{Truth, UNDECIDED, first_ahead, is_tie};
use crate::Case;
use crate::number::{Big, Dd, Number, V3};

/// `t = (a - p).n / d.n`, above 0.
pub fn plane(case: &Case) -> Truth {
    let (truth, sure) = first_hit::<Dd>(case);
    if sure { truth } else { first_hit::<Big>(case).0 }
}

pub(super) fn first_hit<N: Number>(case: &Case) -> (Truth, bool) {
    let crossing = Crossing::<N>::new(case.point(0), case.point(3), &case.ray(6));
    let sure = crossing.is_sure;
    match crossing.hit {
        None => (Truth::TIE, sure),
        Some(hit) => (first_ahead([(hit.t, hit.condition)]), sure),
    }
}

/// Where a line crosses a plane.
pub(super) struct Crossing<N> {
    /// `None` for a line that may be along the plane.
    pub(super) hit: Option<Hit<N>>,
    /// Whether the digits were enough to tell.
    pub(super) is_sure: bool,
}

/// A crossing that is there.
pub(super) struct Hit<N> {
    pub(super) t: N,
    pub(super) condition: f64,
    /// From the plane's point to the crossing.
    pub(super) from_point: V3<N>,
    /// `n / d.n`, to `f64`: how the crossing's `t` follows the ray's origin.
    pub(super) slope: DVec3,
}

impl<N: Number> Crossing<N> {
    pub(super) fn new(point: DVec3, normal: DVec3, ray: &Ray) -> Self {
        let (n, d) = (V3::<N>::of(normal), V3::<N>::of(ray.direction));
        let from_point = V3::<N>::difference(ray.origin, point);
        let height = -from_point.dot(&n);
        let approach = d.dot(&n);
        let (down, along) = (approach.to_f64(), ray.direction.length());
        let size = normal.length() * along;
        let is_sure = down.abs() > UNDECIDED * size
            && (height.to_f64().abs() > UNDECIDED * normal.length() * from_point.to_f64().length());
        if is_tie(down, 2.0 * size) || approach.sign() == Ordering::Equal {
            return Self { hit: None, is_sure };
        }
        let t = height / approach;
        let at = from_point + d.scale(&t);
        let moves = ray.origin.length() + point.length() + t.to_f64().abs() * along;
        let slope = normal / down;
        // A turn of the normal moves the plane by the distance from its point.
        let condition = slope.length() * (moves + at.to_f64().length());
        Self { hit: Some(Hit { t, condition, from_point: at, slope }), is_sure }
    }
}
