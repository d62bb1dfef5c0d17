//! The integral over a unit, by Simpson's rule where the integrand is smooth and
//! by halving where it is not.

use tracer::Rgb;

/// Pieces to begin with: so many features side by side are told apart.
const PIECES: u32 = 4;
/// How often a piece is halved at most: a jump is then known to this part of it.
const DEEPEST: u32 = 12;
/// Simpson's weight of the middle against that of both ends.
const MIDDLE: f64 = 4.0;
const ALL: f64 = 6.0;

/// The largest channel, whatever its sign.
pub(super) fn largest(color: Rgb) -> f64 {
    color.channels().into_iter().fold(0.0, |most, x| most.max(x.abs()))
}

/// One end of a piece to the other.
#[derive(Clone, Copy)]
struct Piece {
    a: f64,
    b: f64,
    /// At both ends and in the middle.
    values: [Rgb; 3],
}

/// The integral of `f` from 0 to 1. A piece is halved while its width times the
/// bend of its three values is above `tolerance`.
pub(super) fn integral(f: &mut impl FnMut(f64) -> Rgb, tolerance: f64) -> Rgb {
    let mut sum = Rgb::BLACK;
    let mut last = f(0.0);
    for k in 0..PIECES {
        let end = |k: u32| f64::from(k) / f64::from(PIECES);
        let (a, b) = (end(k), end(k + 1));
        let (middle, next) = (f(f64::midpoint(a, b)), f(b));
        sum += halved(f, Piece { a, b, values: [last, middle, next] }, tolerance, DEEPEST);
        last = next;
    }
    sum
}

fn halved(f: &mut impl FnMut(f64) -> Rgb, piece: Piece, tolerance: f64, depth: u32) -> Rgb {
    let Piece { a, b, values: [start, middle, end] } = piece;
    let bend = largest(start + end + middle * -2.0);
    if depth == 0 || bend * (b - a) <= tolerance {
        return (start + middle * MIDDLE + end) * ((b - a) / ALL);
    }
    let m = f64::midpoint(a, b);
    let [left, right] = [f64::midpoint(a, m), f64::midpoint(m, b)].map(&mut *f);
    let left = Piece { a, b: m, values: [start, left, middle] };
    let right = Piece { a: m, b, values: [middle, right, end] };
    halved(f, left, tolerance, depth - 1) + halved(f, right, tolerance, depth - 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(f: impl Fn(f64) -> f64, expected: f64) {
        // A jump is known to a 2^14th.
        let found = integral(&mut |x| Rgb::WHITE * f(x), 1e-5).g;
        assert!((found - expected).abs() < 3e-5, "{found}");
    }

    #[test]
    fn what_is_smooth_bends_or_jumps() {
        check(|x| x * x * x, 0.25);
        check(|x| f64::from(x < 0.3), 0.3);
        check(|x| f64::from(0.41 < x && x < 0.77), 0.36);
        check(|x| (x - 0.37).abs(), 0.5 * (0.37 * 0.37 + 0.63 * 0.63));
        check(|_| 1.0, 1.0);
    }
}
