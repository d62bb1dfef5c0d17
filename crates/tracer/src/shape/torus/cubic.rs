//! The real roots of a cubic without a square term, in a bounded number of
//! steps and with nothing but arithmetic and square roots.

/// Where Newton's method has to stop. It descends to the root from above, at
/// worst by a third a step (a triple root), from a start that is at most
/// `q^(-1/12)` times too high: 20 steps for the tightest q of a double that
/// matters, and three to the last bit.
const MAX_STEPS: usize = 32;

/// The real roots of `v^3 + p v + q`, ascending, and how many; the rest is
/// NaN.
///
/// The root `w` of the largest magnitude is simple and found first; the other
/// two have the sum `-w` and the product `-q / w`. Where rounding decides
/// whether those two are real, they are nearly one: the cubic is zero between
/// them but for rounding.
pub(super) fn roots(p: f64, q: f64) -> [f64; 3] {
    // For q > 0 the roots are the negated ones of q < 0.
    let w = largest_root(p, q.abs());
    let mut roots = [f64::NAN; 3];
    roots[2] = w;
    if w > 0.0 {
        let product = q.abs() / w;
        let discriminant = w * w - 4.0 * product;
        if discriminant >= 0.0 {
            let far = 0.5 * (w + discriminant.sqrt());
            roots = [-far, -product / far, w];
        }
    }
    if q > 0.0 {
        let [a, b, c] = roots;
        roots = [-c, -b, -a];
    }
    roots
}

/// The largest root of `w^3 + p w - q` for `q >= 0`; it is not negative.
fn largest_root(p: f64, q: f64) -> f64 {
    // Above the root: w <= sqrt(-p) + cbrt(q), and these are above cbrt(q).
    let above_cbrt = if q < 1.0 { q.sqrt().sqrt() } else { q.sqrt() };
    let mut w = if p > 0.0 { above_cbrt.min(q / p) } else { (-p).sqrt() + above_cbrt };
    // The cubic is convex from the root up, so that each step comes nearer
    // without passing it, but for rounding, which ends the descent.
    for _ in 0..MAX_STEPS {
        let next = (2.0 * w * w * w + q) / (3.0 * w * w + p);
        if !(next < w) {
            break;
        }
        w = next;
    }
    w
}

#[cfg(test)]
mod tests {
    use super::roots;

    #[track_caller]
    fn check(p: f64, q: f64, expected: &[f64]) {
        let found: Vec<_> = roots(p, q).into_iter().filter(|v| !v.is_nan()).collect();
        assert_eq!(found.len(), expected.len(), "{found:?}");
        for (v, e) in found.iter().zip(expected) {
            assert!((v - e).abs() <= 4e-16 * (1.0 + e.abs()), "{found:?}");
        }
    }

    #[test]
    fn zeros_and_nan() {
        check(0.0, 0.0, &[0.0]);
        check(1.0, 0.0, &[0.0]);
        check(-4.0, 0.0, &[-2.0, 0.0, 2.0]);
        check(0.0, -8.0, &[2.0]);
        check(0.0, 8.0, &[-2.0]);
        check(f64::NAN, 1.0, &[]);
        check(1.0, f64::NAN, &[]);
    }

    #[test]
    fn one_two_and_three_roots() {
        // (v - 1)(v^2 + v + 4), (v - 3)(v + 1)(v + 2), (v - 2)(v + 1)^2.
        check(3.0, -4.0, &[1.0]);
        check(-7.0, -6.0, &[-2.0, -1.0, 3.0]);
        check(-7.0, 6.0, &[-3.0, 1.0, 2.0]);
        check(-3.0, -2.0, &[-1.0, -1.0, 2.0]);
    }

    #[test]
    fn tiny_roots_keep_their_digits() {
        let [far, near, w] = roots(-1.0, -1e-20);
        assert!((far + 1.0).abs() < 1e-15 && (w - 1.0).abs() < 1e-15);
        assert!((near / -1e-20 - 1.0).abs() < 1e-15, "{near}");
        assert!((roots(1.0, -1e-20)[2] / 1e-20 - 1.0).abs() < 1e-15);
    }
}
