//! The exact hit of a disk.
//!
//! A case is the center, the normal of any length, the radius and the ray:
//! thirteen numbers.

use super::plane::Crossing;
use super::{Truth, UNDECIDED, first_ahead, is_tie};
use crate::Case;
use crate::number::{Big, Dd, Number};

/// The plane's hit, if it is at most `radius` from the center.
pub fn disk(case: &Case) -> Truth {
    let (truth, sure) = first_hit::<Dd>(case);
    if sure { truth } else { first_hit::<Big>(case).0 }
}

pub(super) fn first_hit<N: Number>(case: &Case) -> (Truth, bool) {
    let (center, normal, radius, ray) = (case.point(0), case.point(3), case.number(6), case.ray(7));
    let crossing = Crossing::<N>::new(center, normal, &ray);
    let Some(hit) = crossing.hit else { return (Truth::TIE, crossing.is_sure) };
    let ahead = first_ahead([(hit.t.clone(), hit.condition)]);
    if !ahead.tie && ahead.t.is_none() {
        return (Truth::MISS, crossing.is_sure);
    }
    let square = hit.from_point.length_squared();
    let at = hit.from_point.to_f64();
    let distance = at.length();
    // `(r - distance) (r + distance)`.
    let margin = (N::of(radius).square() - square).to_f64() / (radius + distance);
    // How the distance follows the ray's origin and direction, along the
    // plane, and the normal's turn.
    let outward = at.normalize_or_zero();
    let steep = outward.dot(ray.direction) * hit.slope.length();
    let moves = (1.0 + steep * steep).sqrt()
        * (ray.origin.length() + center.length() + hit.t.to_f64().abs() * ray.direction.length())
        + steep.abs() * distance
        + radius;
    let sure = crossing.is_sure && margin.abs() > UNDECIDED * moves;
    if is_tie(margin, moves) {
        return (Truth::TIE, sure);
    }
    (if margin > 0.0 { ahead } else { Truth::MISS }, sure)
}
