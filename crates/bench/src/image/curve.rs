//! Seconds against error: what is best, and how long a given error takes.

/// A setting's cost and error.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Point {
    pub(crate) seconds: f64,
    pub(crate) rmse: f64,
}

/// How long an error takes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Reach {
    /// Between a setting that is worse and one that is better, so many seconds.
    Between(f64),
    /// The fastest of all settings is that good already.
    Cheapest(f64),
    /// No setting tried is that good; the best one takes so many seconds.
    NotWithin(f64),
}

impl Reach {
    /// The seconds; as few as it can be where no setting is good enough.
    pub(crate) fn seconds(self) -> f64 {
        match self {
            Self::Between(seconds) | Self::Cheapest(seconds) | Self::NotWithin(seconds) => seconds,
        }
    }
}

/// The numbers of the points that no other one beats, from the fastest to the
/// most exact: each is more exact than all that are faster.
pub(crate) fn frontier(points: &[Point]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..points.len()).collect();
    order.sort_by(|&i, &j| {
        let (p, q) = (points[i], points[j]);
        p.seconds.total_cmp(&q.seconds).then(p.rmse.total_cmp(&q.rmse))
    });
    let mut best = f64::INFINITY;
    order.retain(|&i| {
        let is_better = points[i].rmse < best;
        best = best.min(points[i].rmse);
        is_better
    });
    order
}

/// The numbers of those of the frontier that say how long these errors take: the
/// fastest, the most exact, and for each error the last that is worse and the
/// first that is not. In the order of the points.
pub(crate) fn telling(points: &[Point], targets: &[f64]) -> Vec<usize> {
    let frontier = frontier(points);
    let mut chosen: Vec<usize> = frontier.first().copied().into_iter().collect();
    for &target in targets {
        let reaching = frontier.iter().position(|&i| points[i].rmse <= target);
        let k = reaching.unwrap_or(frontier.len().saturating_sub(1));
        let before = k.checked_sub(1).filter(|_| reaching.is_some());
        chosen.extend(before.into_iter().chain([k]).filter_map(|k| frontier.get(k)));
    }
    chosen.sort_unstable();
    chosen.dedup();
    chosen
}

/// How long an error takes whoever has these points: on the straight line
/// between the two of the frontier around it, both axes logarithmic. `None`
/// without points.
pub(crate) fn reach(points: &[Point], rmse: f64) -> Option<Reach> {
    let frontier: Vec<_> = frontier(points).into_iter().map(|i| points[i]).collect();
    let last = frontier.last()?;
    let Some(k) = frontier.iter().position(|point| point.rmse <= rmse) else {
        return Some(Reach::NotWithin(last.seconds));
    };
    let better = frontier[k];
    let Some(worse) = k.checked_sub(1).map(|k| frontier[k]) else {
        return Some(Reach::Cheapest(better.seconds));
    };
    // An error of 0 is infinitely far down: the line is then upright.
    let share = if better.rmse > 0.0 {
        libm::log(worse.rmse / rmse) / libm::log(worse.rmse / better.rmse)
    } else {
        0.0
    };
    let longer = share * libm::log(better.seconds / worse.seconds);
    Some(Reach::Between(worse.seconds * libm::exp(longer)))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn points(all: &[(f64, f64)]) -> Vec<Point> {
        all.iter().map(|&(seconds, rmse)| Point { seconds, rmse }).collect()
    }

    #[test]
    fn the_frontier_is_what_nothing_beats() {
        let all =
            points(&[(4.0, 0.1), (1.0, 0.5), (2.0, 0.6), (2.0, 0.2), (5.0, 0.1), (8.0, 0.01)]);
        assert_eq!(frontier(&all), [1, 3, 0, 5]);
        assert!(frontier(&[]).is_empty());
    }

    #[test]
    fn seconds_lie_on_the_line_of_logarithms() {
        #[track_caller]
        fn check(rmse: f64, expected: Option<Reach>) {
            // A slope of -1/2, as of independent samples, and then of -2.
            let all = points(&[(1.0, 1e-1), (100.0, 1e-2), (1000.0, 1e-4)]);
            let found = reach(&all, rmse);
            let close = found.zip(expected).is_some_and(|(a, b)| {
                std::mem::discriminant(&a) == std::mem::discriminant(&b)
                    && (a.seconds() / b.seconds() - 1.0).abs() < 1e-12
            });
            assert!(close, "{found:?} for {expected:?}");
        }
        check(0.2, Some(Reach::Cheapest(1.0)));
        check(1e-1, Some(Reach::Cheapest(1.0)));
        check(1e-1 / 10_f64.sqrt(), Some(Reach::Between(10.0)));
        check(1e-2, Some(Reach::Between(100.0)));
        check(1e-3, Some(Reach::Between(100.0 * 10_f64.sqrt())));
        check(1e-5, Some(Reach::NotWithin(1000.0)));
        assert_eq!(reach(&[], 0.1), None);
        let exact = points(&[(1.0, 1e-1), (2.0, 0.0)]);
        assert_eq!(reach(&exact, 1e-3), Some(Reach::Between(1.0)));
    }

    #[test]
    fn the_points_that_tell_are_around_the_targets() {
        let all = points(&[
            (1.0, 1e-1),
            (2.0, 5e-2),
            (3.0, 2e-2),
            (4.0, 2e-3),
            (5.0, 1e-3),
            (6.0, 5e-4),
            (3.5, 3e-2),
        ]);
        assert_eq!(telling(&all, &[1e-2, 1e-3]), [0, 2, 3, 4]);
        assert_eq!(telling(&all, &[1e-2, 1e-4]), [0, 2, 3, 5]);
        for target in [1e-2, 1e-3] {
            let told: Vec<_> = telling(&all, &[target]).into_iter().map(|i| all[i]).collect();
            assert_eq!(reach(&told, target), reach(&all, target));
        }
        assert!(telling(&[], &[1.0]).is_empty());
    }
}
