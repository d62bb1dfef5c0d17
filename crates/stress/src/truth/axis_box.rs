//! The exact first hit of an axis-aligned box.
//!
//! A case is the lowest corner, the highest and the ray: twelve numbers.

use std::cmp::Ordering;

use super::{Truth, is_tie, parts};
use crate::Case;
use crate::number::{Big, Dd, Number};

/// The last entry into a slab if it is above 0, else the first exit. Edges and
/// corners are inside, decided exactly: no hit is a tie, and a miss only if it
/// is by less than the inputs' rounding.
pub fn axis_box(case: &Case) -> Truth {
    let (min, max, ray) = (case.point(0), case.point(3), case.ray(6));
    let scale = scale_of(ray.direction.abs().max_element());
    let mut slabs = [None; 3];
    for axis in 0..3 {
        let (p, d) = (ray.origin[axis], ray.direction[axis]);
        if d == 0.0 {
            if !(min[axis] <= p && p <= max[axis]) {
                return Truth::MISS;
            }
            continue;
        }
        let (near, far) = if d > 0.0 { (min[axis], max[axis]) } else { (max[axis], min[axis]) };
        slabs[axis] = Some(Slab {
            enter: Side::new(near, p, d),
            leave: Side::new(far, p, d),
            speed: d.abs() * scale,
        });
    }
    let slabs = || slabs.iter().flatten();
    let mut is_hit = true;
    for (i, entered) in slabs().enumerate() {
        for (j, left) in slabs().enumerate() {
            let (enter, leave) = (entered.enter, left.leave);
            if i == j || order(enter.way, left.speed, leave.way, entered.speed) != Ordering::Greater
            {
                continue;
            }
            is_hit = false;
            let gap = enter.way * Dd::of(left.speed) - leave.way * Dd::of(entered.speed);
            let moves = enter.moves * left.speed + leave.moves * entered.speed;
            if !is_tie(gap.to_f64(), moves) {
                return Truth::MISS;
            }
        }
    }
    if !is_hit {
        return Truth::TIE;
    }
    let crossing = |side: Side, speed: f64| (side.way / Dd::of(speed), side.moves / speed);
    let last = slabs()
        .map(|slab| crossing(slab.enter, slab.speed))
        .reduce(|a, b| if b.0 > a.0 { b } else { a });
    let first = slabs()
        .map(|slab| crossing(slab.leave, slab.speed))
        .reduce(|a, b| if b.0 < a.0 { b } else { a });
    let ahead = [last, first].into_iter().flatten().find(|(t, _)| t.sign() == Ordering::Greater);
    ahead.map_or(Truth::MISS, |(t, condition)| {
        let (hi, lo) = parts(&t);
        Truth::hit((hi * scale, lo * scale), condition * scale)
    })
}

/// The two sides of a slab as the ray meets them, and how fast it goes across.
#[derive(Clone, Copy)]
struct Slab {
    enter: Side,
    leave: Side,
    speed: f64,
}

/// A side of a box.
#[derive(Clone, Copy)]
struct Side {
    /// From the ray's origin to the side, along the direction's sign: exact.
    way: Dd,
    /// How far that moves when it and the direction are off by their own size.
    /// The difference of the coordinates is not asked to be better than that,
    /// and not excused by more: its rounding is relative to itself.
    moves: f64,
}

impl Side {
    fn new(at: f64, p: f64, d: f64) -> Self {
        let way = Dd::difference(at, p);
        let way = if d > 0.0 { way } else { -way };
        Self { way, moves: 2.0 * way.hi().abs() }
    }
}

/// A power of two for the direction, so that denormal components make no
/// denormal products: an answer of homogeneous inequalities stays the same.
fn scale_of(longest: f64) -> f64 {
    /// Takes the smallest `f64` to 2^-562.
    const UP: f64 = f64::from_bits((1023 + 512) << 52);
    /// Directions up to here stay below 2^913.
    const MOST: f64 = f64::from_bits((1023 + 400) << 52);
    if longest <= MOST { UP } else { 1.0 }
}

/// The exact order of `a b` and `c d`.
fn order(a: Dd, b: f64, c: Dd, d: f64) -> Ordering {
    /// Products of this size have their rests in full.
    const ROOMY: std::ops::Range<f64> = 1e-250..1e300;
    let (left, right) = (a.hi() * b, c.hi() * d);
    let is_roomy = |x: f64| x == 0.0 || ROOMY.contains(&x.abs());
    if is_roomy(left) && is_roomy(right) {
        // Both products are off by two roundings, and the difference by one.
        if (left - right).abs() > 4.0 * f64::EPSILON * (left.abs() + right.abs()) {
            return left.total_cmp(&right);
        }
        if a.lo() == 0.0 && c.lo() == 0.0 {
            let exact = Dd::product(a.hi(), b).partial_cmp(&Dd::product(c.hi(), d));
            return exact.unwrap_or(Ordering::Greater);
        }
    }
    let (left, right) = (Big::from(a) * Big::of(b), Big::from(c) * Big::of(d));
    left.partial_cmp(&right).unwrap_or(Ordering::Greater)
}
