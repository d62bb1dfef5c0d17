//! The exact hit of a triangle.
//!
//! A case is the three corners and the ray: fifteen numbers.

use std::cmp::Ordering;

use super::{Truth, UNDECIDED, first_ahead, is_tie, parts};
use crate::Case;
use crate::number::{Big, Dd, Number, V3};

/// Where the ray meets the triangle; close to its edges is a tie.
pub fn triangle(case: &Case) -> Truth {
    let (truth, sure) = first_hit::<Dd>(case, false);
    if sure { truth } else { first_hit::<Big>(case, false).0 }
}

/// As [`triangle`], with the edges and corners inside and no ties: whole
/// numbers leave no doubt.
pub fn triangle_on_lattice(case: &Case) -> Truth {
    /// Products of three differences of such numbers are exact in 106 bits,
    /// and so are their sums.
    const MOST: f64 = (1_u64 << 26) as f64;
    let (truth, sure) = first_hit::<Dd>(case, true);
    let is_small = case.numbers().iter().all(|x| x.abs() <= MOST && x.trunc() == *x);
    if is_small || sure { truth } else { first_hit::<Big>(case, true).0 }
}

pub(super) fn first_hit<N: Number>(case: &Case, on_lattice: bool) -> (Truth, bool) {
    let corners = [case.point(0), case.point(3), case.point(6)];
    let ray = case.ray(9);
    let d = V3::<N>::of(ray.direction);
    let length = ray.direction.length();
    let seen = corners.map(|corner| V3::<N>::difference(corner, ray.origin));
    // On which side of each edge the ray passes: six times the volume that the
    // edge spans with the direction, seen from the origin.
    let (mut signs, mut sides, mut ties, mut sure) = ([0_u32; 2], [0.0; 3], 0, true);
    for (k, value) in sides.iter_mut().enumerate() {
        let (i, j) = ((k + 1) % 3, (k + 2) % 3);
        let edge = V3::<N>::difference(corners[j], corners[i]);
        let across = seen[i].cross(&edge);
        let side = d.dot(&across);
        let (from, to, along) = (seen[i].to_f64(), seen[j].to_f64(), edge.to_f64());
        let moves = ray.direction.cross(along).length() * ray.origin.length()
            + across.to_f64().length() * length
            + ray.direction.cross(to).length() * corners[i].length()
            + ray.direction.cross(from).length() * corners[j].length();
        *value = side.to_f64();
        sure &= value.abs() > UNDECIDED * (from.length() * along.length() * length).max(moves);
        if !on_lattice && is_tie(*value, moves) {
            ties += 1;
        } else {
            match side.sign() {
                Ordering::Less => signs[0] += 1,
                Ordering::Greater => signs[1] += 1,
                Ordering::Equal => {}
            }
        }
    }
    if signs[0] > 0 && signs[1] > 0 {
        return (Truth::MISS, sure);
    }
    if ties > 0 {
        return (Truth::TIE, sure);
    }
    let normal = V3::<N>::difference(corners[1], corners[0])
        .cross(&V3::<N>::difference(corners[2], corners[0]));
    let approach = d.dot(&normal);
    if approach.sign() == Ordering::Equal {
        // Along the plane, or no plane.
        return (Truth::MISS, sure);
    }
    let down = approach.to_f64();
    let t = seen[0].dot(&normal) / approach;
    let sum = sides[0] + sides[1] + sides[2];
    let weighted: f64 = (0..3).map(|k| sides[k] / sum * corners[k].length()).sum();
    let moves = ray.origin.length() + t.to_f64().abs() * length + weighted;
    let condition = normal.to_f64().length() / down.abs() * moves;
    if on_lattice {
        let is_ahead = t.sign() == Ordering::Greater;
        return (if is_ahead { Truth::hit(parts(&t), condition) } else { Truth::MISS }, sure);
    }
    (first_ahead([(t, condition)]), sure)
}
