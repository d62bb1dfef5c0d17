//! Numbers as text: the shortest decimals that are read back as the same number.

use scene::format::Triple;
use tracer::glam::DVec3;

/// A number, with an exponent where it would be long without.
///
/// Every dialect reads such exponents: `1e-7`, `2.5e20`. A negative zero loses
/// its sign.
pub(super) fn number(x: f64) -> String {
    /// Within these it is written out.
    const PLAIN: std::ops::Range<f64> = 1e-5..1e16;
    let x = if x == 0.0 { 0.0 } else { x };
    if x == 0.0 || PLAIN.contains(&x.abs()) { x.to_string() } else { format!("{x:e}") }
}

/// Numbers with `between` between them.
pub(super) fn numbers(all: impl IntoIterator<Item = f64>, between: &str) -> String {
    all.into_iter().map(number).collect::<Vec<_>>().join(between)
}

/// `1 2 3`.
pub(super) fn spaced(v: Triple) -> String {
    numbers(v, " ")
}

/// A product, channel by channel.
pub(super) fn times(a: Triple, b: Triple) -> Triple {
    std::array::from_fn(|i| a[i] * b[i])
}

/// All channels by a number.
pub(super) fn scaled(a: Triple, by: f64) -> Triple {
    a.map(|x| x * by)
}

/// As a vector.
pub(super) fn vector(v: Triple) -> DVec3 {
    DVec3::from_array(v)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short_and_read_back_as_the_same() {
        #[track_caller]
        fn check(x: f64, expected: &str) {
            assert_eq!(number(x), expected);
            assert_eq!(number(x).parse::<f64>().unwrap(), x);
        }
        check(-0.0, "0");
        check(5e-324, "5e-324");
        check(f64::MAX, "1.7976931348623157e308");
        check(1e-5, "0.00001");
        check(9.9e-6, "9.9e-6");
        check(0.1 + 0.2, "0.30000000000000004");
        check(-1e16, "-1e16");
        check(300.0, "300");
    }
}
