//! `turn`: whether a way bends to the left or to the right, without rounding.
//!
//! Source: J. R. Shewchuk, "Adaptive Precision Floating-Point Arithmetic and
//! Fast Robust Geometric Predicates", 1997: the bound of ORIENT2D's first stage,
//! and GROW-EXPANSION.

use tracer::glam::DVec2;

/// Which way it goes on.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Turn {
    /// Counter-clockwise.
    Left,
    /// Neither, or right back.
    Straight,
    /// Clockwise.
    Right,
}

impl Turn {
    fn of(determinant: f64) -> Self {
        if determinant > 0.0 {
            Self::Left
        } else if determinant < 0.0 {
            Self::Right
        } else {
            Self::Straight
        }
    }
}

/// The bend of the way from `a` by `b` to `c`.
///
/// Exact for coordinates up to about 1 in magnitude, as long as products of the
/// small ones do not leave the range of `f64`: down to 1e-140.
pub(super) fn turn(a: DVec2, b: DVec2, c: DVec2) -> Turn {
    /// `(3 + 16 e) e` with `e = 2^-53`: the error of the plain formula relative
    /// to the size of its two products.
    const BOUND: f64 = 3.330_669_073_875_472e-16;
    let left = (a.x - c.x) * (b.y - c.y);
    let right = (a.y - c.y) * (b.x - c.x);
    let determinant = left - right;
    if determinant.abs() > BOUND * (left.abs() + right.abs()) {
        return Turn::of(determinant);
    }
    exactly(a, b, c)
}

/// The same by the sum of all products, none of which is rounded.
fn exactly(a: DVec2, b: DVec2, c: DVec2) -> Turn {
    /// Two of each product.
    const PARTS: usize = 12;
    let products = [(a.x, b.y), (-a.x, c.y), (-c.x, b.y), (-a.y, b.x), (a.y, c.x), (c.y, b.x)];
    let mut expansion = [0.0; PARTS];
    let mut length = 0;
    for (x, y) in products {
        let product = x * y;
        let rest = libm::fma(x, y, -product);
        for part in [rest, product] {
            let mut carried = part;
            for slot in &mut expansion[..length] {
                let (sum, error) = two_sum(carried, *slot);
                (*slot, carried) = (error, sum);
            }
            expansion[length] = carried;
            length += 1;
        }
    }
    // The largest part that is not 0 has the sign of all.
    Turn::of(expansion.into_iter().rev().find(|part| *part != 0.0).unwrap_or(0.0))
}

/// The sum and what was rounded off it.
fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let of_b = sum - a;
    let of_a = sum - of_b;
    (sum, (a - of_a) + (b - of_b))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_bit_decides() {
        let at = DVec2::new;
        // On the diagonal, and off it by one step of f64.
        for i in 0..200 {
            let x = 0.5 + f64::from(i) * f64::EPSILON;
            let (a, b) = (at(12.0 / 32.0, 12.0 / 32.0), at(24.0 / 32.0, 24.0 / 32.0));
            assert_eq!(turn(a, b, at(x, x)), Turn::Straight, "{i}");
            assert_eq!(turn(a, b, at(x, x.next_up())), Turn::Left, "{i}");
            assert_eq!(turn(a, b, at(x, x.next_down())), Turn::Right, "{i}");
        }
        assert_eq!(turn(at(0.0, 0.0), at(1.0, 0.0), at(0.5, 1e-300)), Turn::Left);
        assert_eq!(turn(at(0.1, 0.1), at(0.2, 0.2), at(0.3, 0.3)), Turn::Straight);
        assert_eq!(turn(at(0.0, 0.0), at(0.0, 0.0), at(1.0, 1.0)), Turn::Straight);
    }

    #[test]
    fn turning_the_corners_changes_nothing() {
        let mut seed = 1_u64;
        let mut random = || {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            // Few bits, so that many are straight.
            (seed >> 61) as f64 * 0.1
        };
        let mut straight = 0;
        for _ in 0..2_000 {
            let [a, b, c] = [(); 3].map(|()| DVec2::new(random(), random()));
            let found = turn(a, b, c);
            assert_eq!(found, turn(b, c, a));
            assert_eq!(found, exactly(a, b, c));
            assert_eq!(found == Turn::Left, turn(b, a, c) == Turn::Right);
            straight += usize::from(found == Turn::Straight);
        }
        assert!(straight > 50, "{straight}");
    }
}
