//! All real roots of a polynomial in an interval, in any number: between two
//! neighboring extrema it has one root or none, and the extrema are the roots
//! of its derivative.

use std::cmp::Ordering;

use crate::number::Number;

/// More steps than halving from an interval to the last of 512 bits takes.
const MOST_STEPS: usize = 1200;

/// The value at `x` of the polynomial with these coefficients, lowest first.
pub fn value<N: Number>(coefficients: &[N], x: &N) -> N {
    let step = |sum: N, c: &N| sum * x.clone() + c.clone();
    coefficients.iter().rev().fold(N::zero(), step)
}

/// The coefficients of its derivative.
pub fn derivative<N: Number>(coefficients: &[N]) -> Vec<N> {
    let terms = coefficients.iter().enumerate().skip(1);
    terms.map(|(k, c)| N::of(k as f64) * c.clone()).collect()
}

/// The roots strictly between `lo` and `hi`, ascending, each to `precision` of
/// the interval's length, and the extrema there, ascending.
///
/// A double root that the arithmetic does not find to be exactly one comes as
/// two or none, which its extremum tells: callers look at the value there.
pub fn roots_and_extrema<N: Number>(
    coefficients: &[N],
    (lo, hi): (&N, &N),
    precision: f64,
) -> (Vec<N>, Vec<N>) {
    if coefficients.len() < 2 {
        return (Vec::new(), Vec::new());
    }
    let slope = derivative(coefficients);
    let (extrema, _) = roots_and_extrema(&slope, (lo, hi), precision);
    let enough = (hi.clone() - lo.clone()).abs() * N::of(precision);
    let mut roots = Vec::new();
    let mut from = (lo.clone(), value(coefficients, lo).sign());
    for end in extrema.iter().chain(std::iter::once(hi)) {
        let to = (end.clone(), value(coefficients, end).sign());
        match (from.1, to.1) {
            // At an extremum: once, and not again from its other side.
            (_, Ordering::Equal) if end < hi => roots.push(end.clone()),
            (Ordering::Less, Ordering::Greater) | (Ordering::Greater, Ordering::Less) => {
                let bracket = (from.0, to.0.clone());
                roots.push(between(coefficients, &slope, bracket, from.1, &enough));
            }
            _ => {}
        }
        from = to;
    }
    (roots, extrema)
}

/// The root in a bracket at whose lower end the sign is `below`: Newton's
/// steps, halving wherever one leaves the bracket or gains less than that.
fn between<N: Number>(
    coefficients: &[N],
    slope: &[N],
    (mut lo, mut hi): (N, N),
    below: Ordering,
    enough: &N,
) -> N {
    let half = N::of(0.5);
    let mut x = guess(coefficients, slope, &lo, &hi, below);
    if !(x > lo && x < hi) {
        x = (lo.clone() + hi.clone()) * half.clone();
    }
    let mut last = hi.clone() - lo.clone();
    for _ in 0..MOST_STEPS {
        let y = value(coefficients, &x);
        match y.sign() {
            Ordering::Equal => return x,
            sign if sign == below => lo = x.clone(),
            _ => hi = x.clone(),
        }
        let newton = x.clone() - y / value(slope, &x);
        let gains = (newton.clone() - x.clone()).abs() * N::of(2.0) <= last;
        let next = if newton > lo && newton < hi && gains {
            newton
        } else {
            (lo.clone() + hi.clone()) * half.clone()
        };
        last = (next.clone() - x.clone()).abs();
        x = next;
        if last <= *enough {
            break;
        }
    }
    x
}

/// The root to about the digits of an `f64`, the same way; all that is asked is
/// that it saves the steps up to there.
fn guess<N: Number>(coefficients: &[N], slope: &[N], lo: &N, hi: &N, below: Ordering) -> N {
    /// Where to stop: some units in the last place.
    const ENOUGH: f64 = 1e-15;
    /// The most coefficients that are looked at: those of a quartic.
    const ROOM: usize = 5;
    let digits = |from: &[N]| {
        let mut all = [0.0; ROOM];
        for (to, c) in all.iter_mut().zip(from) {
            *to = c.to_f64();
        }
        all
    };
    let (p, dp) = (digits(coefficients), digits(slope));
    let value = |c: &[f64; ROOM], x: f64| c.iter().rev().fold(0.0, |sum, c| sum * x + c);
    let (mut lo, mut hi) = (lo.to_f64(), hi.to_f64());
    let enough = ENOUGH * (hi - lo);
    let mut x = 0.5 * (lo + hi);
    let mut last = hi - lo;
    for _ in 0..64 {
        let y = value(&p, x);
        if (y < 0.0) == (below == Ordering::Less) {
            lo = x;
        } else {
            hi = x;
        }
        let newton = x - y / value(&dp, x);
        let gains = 2.0 * (newton - x).abs() <= last;
        let next = if newton > lo && newton < hi && gains { newton } else { 0.5 * (lo + hi) };
        last = (next - x).abs();
        x = next;
        if last <= enough {
            break;
        }
    }
    N::of(x)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::{Big, Dd};

    /// The coefficients of the product of `x - root`.
    fn with_roots<N: Number>(roots: &[f64]) -> Vec<N> {
        let mut product = vec![N::one()];
        for &root in roots {
            let mut next = vec![N::zero(); product.len() + 1];
            for (k, c) in product.iter().enumerate() {
                next[k + 1] = next[k + 1].clone() + c.clone();
                next[k] = next[k].clone() - c.clone() * N::of(root);
            }
            product = next;
        }
        product
    }

    fn check<N: Number>(roots: &[f64], precision: f64, tolerance: f64) {
        let (lo, hi) = (N::of(-3.0), N::of(3.0));
        let (found, extrema) = roots_and_extrema(&with_roots::<N>(roots), (&lo, &hi), precision);
        assert_eq!(found.len(), roots.len(), "{roots:?}: {found:?}");
        assert!(extrema.len() < roots.len());
        for (x, root) in found.iter().zip(roots) {
            let off = (x.clone() - N::of(*root)).to_f64().abs();
            assert!(off <= tolerance, "{roots:?}: {x:?} is off by {off:e}");
        }
    }

    #[test]
    fn roots_that_are_apart_are_found_to_the_last_digits() {
        check::<Dd>(&[-2.0, -0.5, 0.25, 1.75], 1e-30, 1e-29);
        check::<Big>(&[-2.0, -0.5, 0.25, 1.75], 1e-140, 1e-139);
        // A Cardano's or Ferrari's formula loses half the digits of these.
        check::<Dd>(&[1.0, 1.0 + 1e-9, 1.0 + 2e-9, 1.5], 1e-30, 1e-12);
        check::<Big>(&[1.0, 1.0 + 1e-9, 1.0 + 2e-9, 1.5], 1e-140, 1e-100);
    }

    #[test]
    fn an_exact_double_root_comes_once_and_no_root_never() {
        let (lo, hi) = (Dd::of(-3.0), Dd::of(3.0));
        let (found, _) = roots_and_extrema(&with_roots::<Dd>(&[1.0, 1.0]), (&lo, &hi), 1e-30);
        assert_eq!(found, vec![Dd::one()]);
        let above = [Dd::of(1e-20), Dd::zero(), Dd::one()];
        assert!(roots_and_extrema(&above, (&lo, &hi), 1e-30).0.is_empty());
    }
}
