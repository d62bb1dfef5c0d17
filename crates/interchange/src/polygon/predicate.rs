//! Signs that no rounding changes: to which side a line turns, and which way
//! around a polygon goes.
//!
//! They are right for all coordinates that are at most 1e266 times smaller than
//! the largest and were brought to size by [`to_size`].

use std::cmp::Ordering;

/// A point of the plane.
pub(super) type Point = [f64; 2];

/// The points times a power of two, so that no product of them leaves the range
/// of `f64` on either side. Nothing is rounded by it.
pub(super) fn to_size(points: &mut [Point]) {
    /// The power of two below the largest coordinate afterwards.
    const EXPONENT: i32 = 400;
    let largest = points.as_flattened().iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    if largest > 0.0 && largest.is_finite() {
        let by = EXPONENT - libm::ilogb(largest);
        for x in points.as_flattened_mut() {
            *x = libm::scalbn(*x, by);
        }
    }
}

/// `Greater` where the way from `a` by `b` to `c` turns left, `Less` where it
/// turns right, `Equal` where it goes straight on or back.
///
/// Source: J. R. Shewchuk, "Adaptive Precision Floating-Point Arithmetic and
/// Fast Robust Geometric Predicates", 1997, `orient2d` with its first bound.
pub(super) fn turn(a: Point, b: Point, c: Point) -> Ordering {
    /// `(3 + 16 u) u` for `u = 2^-53`, rounded up.
    const BOUND: f64 = 3.330_669_073_875_472e-16;
    let left = (a[0] - c[0]) * (b[1] - c[1]);
    let right = (a[1] - c[1]) * (b[0] - c[0]);
    let area = left - right;
    let size = left.abs() + right.abs();
    // Below this size products may have lost digits to underflow.
    if size > f64::MIN_POSITIVE / f64::EPSILON && area.abs() > BOUND * size {
        return sign(area);
    }
    let mut exact = Expansion::default();
    for (x, y) in [(a, b), (b, c), (c, a)] {
        exact.add_cross(x, y);
    }
    exact.sign()
}

/// `Greater` where a polygon goes counter-clockwise, `Less` where it goes
/// clockwise, `Equal` where it has no area.
pub(super) fn orientation(points: &[Point]) -> Ordering {
    let mut area = Expansion::default();
    for (i, &p) in points.iter().enumerate() {
        area.add_cross(p, points[(i + 1) % points.len()]);
    }
    area.sign()
}

fn sign(x: f64) -> Ordering {
    x.partial_cmp(&0.0).unwrap_or(Ordering::Equal)
}

/// A sum that is never rounded: parts that do not overlap, the smallest first.
#[derive(Debug, Default)]
struct Expansion(Vec<f64>);

impl Expansion {
    /// Adds `p x q`.
    fn add_cross(&mut self, p: Point, q: Point) {
        self.add_product(p[0], q[1]);
        self.add_product(-p[1], q[0]);
    }

    fn add_product(&mut self, a: f64, b: f64) {
        let product = a * b;
        self.add(a.mul_add(b, -product));
        self.add(product);
    }

    fn add(&mut self, x: f64) {
        let mut sum = x;
        let mut kept = 0;
        for i in 0..self.0.len() {
            let (next, rest) = two_sum(sum, self.0[i]);
            if rest != 0.0 {
                self.0[kept] = rest;
                kept += 1;
            }
            sum = next;
        }
        self.0.truncate(kept);
        if sum != 0.0 {
            self.0.push(sum);
        }
    }

    fn sign(&self) -> Ordering {
        self.0.last().map_or(Ordering::Equal, |&largest| sign(largest))
    }
}

/// `a + b` rounded, and what the rounding left out.
///
/// Source: Knuth, "The Art of Computer Programming", volume 2, section 4.2.2.
fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let b_seen = sum - a;
    (sum, (a - (sum - b_seen)) + (b - b_seen))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(points: [Point; 3], expected: Ordering) {
        let mut sized = points;
        to_size(&mut sized);
        let [a, b, c] = sized;
        for (x, y, z) in [(a, b, c), (b, c, a), (c, a, b)] {
            assert_eq!(turn(x, y, z), expected, "{points:?}");
            assert_eq!(turn(y, x, z), expected.reverse(), "{points:?}");
        }
        assert_eq!(orientation(&sized), expected, "{points:?}");
    }

    #[test]
    fn turns_are_exact() {
        let one = 1.0 + f64::EPSILON;
        check([[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]], Ordering::Greater);
        check([[0.5, 0.5], [12.0, 12.0], [24.0, 24.0]], Ordering::Equal);
        check([[0.5, 0.5], [12.0, 12.0], [24.0, 24.0_f64.next_up()]], Ordering::Greater);
        check([[0.5_f64.next_up(), 0.5], [12.0, 12.0], [24.0, 24.0]], Ordering::Less);
        check([[0.0, 0.0], [one, 1.0], [one * one, one]], Ordering::Greater);
        check([[1e60, 0.0], [1e60, 1e-100], [1e60, 3e-100]], Ordering::Equal);
        check([[5e-324, 0.0], [0.0, 5e-324], [0.0, 0.0]], Ordering::Greater);
        check([[0.0; 2]; 3], Ordering::Equal);
    }

    #[test]
    fn points_far_away_lose_no_digits() {
        let far = 1e15;
        let square = [[far, far], [far + 1.0, far], [far + 1.0, far + 1.0], [far, far + 1.0]];
        assert_eq!(orientation(&square), Ordering::Greater);
        let back: Vec<_> = square.into_iter().rev().collect();
        assert_eq!(orientation(&back), Ordering::Less);
    }
}
