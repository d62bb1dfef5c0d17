//! The slope of a growth: the exponent `k` of `y = c x^k`.

/// The slope of the straight line through the points' logarithms with the least
/// squares of errors; `None` for fewer than two different `x`, and for points
/// that are not above 0 and finite.
pub(crate) fn slope(points: &[(f64, f64)]) -> Option<f64> {
    let is_usable = |v: f64| v > 0.0 && v.is_finite();
    if !points.iter().all(|&(x, y)| is_usable(x) && is_usable(y)) {
        return None;
    }
    let logs: Vec<_> = points.iter().map(|&(x, y)| (x.ln(), y.ln())).collect();
    let count = logs.len() as f64;
    let mean_x = logs.iter().map(|p| p.0).sum::<f64>() / count;
    let mean_y = logs.iter().map(|p| p.1).sum::<f64>() / count;
    let across: f64 = logs.iter().map(|p| (p.0 - mean_x) * (p.0 - mean_x)).sum();
    let both: f64 = logs.iter().map(|p| (p.0 - mean_x) * (p.1 - mean_y)).sum();
    let differ = logs.iter().any(|p| p.0 != logs[0].0);
    differ.then(|| both / across)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(points: &[(f64, f64)], expected: Option<f64>) {
        let found = slope(points);
        let agree = match (found, expected) {
            (Some(found), Some(expected)) => (found - expected).abs() < 1e-12,
            (found, expected) => found == expected,
        };
        assert!(agree, "{found:?}, expected {expected:?} of {points:?}");
    }

    #[test]
    fn exponents_are_found() {
        let power = |k: f64| [1.0, 10.0, 50.0, 1e4].map(|x: f64| (x, 3.0 * x.powf(k)));
        for k in [-1.0, 0.0, 0.5, 1.0, 2.0] {
            check(&power(k), Some(k));
        }
        // Off the line by the same factor on both sides of the middle.
        check(&[(1.0, 1.0), (10.0, 30.0), (100.0, 100.0)], Some(1.0));
    }

    #[test]
    fn without_a_line_there_is_none() {
        check(&[], None);
        check(&[(1.0, 2.0)], None);
        check(&[(3.0, 2.0), (3.0, 4.0)], None);
        check(&[(1.0, 2.0), (2.0, 0.0)], None);
        check(&[(-1.0, 2.0), (2.0, 1.0)], None);
        check(&[(1.0, 2.0), (2.0, f64::NAN)], None);
    }
}
