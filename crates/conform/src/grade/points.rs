//! `Points`: what a part of a grade is worth, in hundredths, so that what is shown
//! adds up.

use std::fmt;
use std::iter::Sum;

/// Points, in hundredths.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct Points(u64);

impl Points {
    /// The most that a part may be worth.
    pub const MOST: f64 = 1e6;

    /// So many points, if they have two decimals at most and are from 0 to
    /// [`Points::MOST`].
    pub fn new(points: f64) -> Option<Self> {
        /// More than the error of writing a decimal number as a binary one.
        const NEAR: f64 = 1e-6;
        if !(0.0..=Self::MOST).contains(&points) {
            return None;
        }
        let hundredths = (points * 100.0).round();
        ((points * 100.0 - hundredths).abs() < NEAR).then_some(Self(hundredths as u64))
    }

    /// As many of it as of the whole, rounded to the nearest hundredth, half up;
    /// nothing of no whole.
    #[must_use]
    pub fn share(self, part: u64, whole: u64) -> Self {
        let (points, part, whole) = (u128::from(self.0), u128::from(part), u128::from(whole));
        // It is no more than the points themselves.
        Self((2 * points * part.min(whole) + whole).checked_div(2 * whole).unwrap_or(0) as u64)
    }

    /// So many times it.
    #[must_use]
    pub fn times(self, count: u64) -> Self {
        Self(self.0.saturating_mul(count))
    }

    /// What is left without these; not less than nothing.
    #[must_use]
    pub fn less(self, others: Self) -> Self {
        Self(self.0.saturating_sub(others.0))
    }

    /// As a number.
    pub fn value(self) -> f64 {
        self.0 as f64 / 100.0
    }
}

impl Sum for Points {
    fn sum<I: Iterator<Item = Self>>(points: I) -> Self {
        Self(points.fold(0, |sum, one| sum.saturating_add(one.0)))
    }
}

impl fmt::Display for Points {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match (self.0 / 100, self.0 % 100) {
            (whole, 0) => write!(f, "{whole}"),
            (whole, rest) if rest % 10 == 0 => write!(f, "{whole}.{}", rest / 10),
            (whole, rest) => write!(f, "{whole}.{rest:02}"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(points: f64, expected: Option<&str>) {
        let shown = Points::new(points).map(|points| points.to_string());
        assert_eq!(shown.as_deref(), expected, "{points}");
    }

    #[test]
    fn points_have_two_decimals() {
        check(f64::NAN, None);
        check(f64::INFINITY, None);
        check(-1.0, None);
        check(-0.0, Some("0"));
        check(0.001, None);
        check(1e6 + 1.0, None);
        check(0.07, Some("0.07"));
        check(2.5, Some("2.5"));
        check(1.15, Some("1.15"));
        check(1e6, Some("1000000"));
    }

    #[track_caller]
    fn share(points: f64, part: u64, whole: u64, expected: &str) {
        let share = Points::new(points).unwrap().share(part, whole);
        assert_eq!(share.to_string(), expected, "{part} of {whole} of {points}");
    }

    #[test]
    fn a_share_is_rounded_and_never_more() {
        share(10.0, 0, 0, "0");
        share(10.0, 0, 3, "0");
        share(10.0, 1, 3, "3.33");
        share(10.0, 2, 3, "6.67");
        share(10.0, 3, 3, "10");
        share(10.0, 4, 3, "10");
        share(0.01, 1, 2, "0.01");
        share(1e6, u64::MAX, u64::MAX, "1000000");
    }

    #[test]
    fn sums_do_not_go_below_nothing() {
        let points = |value| Points::new(value).unwrap();
        assert_eq!(points(1.5).less(points(2.0)).to_string(), "0");
        assert_eq!([points(1.5), points(0.25)].into_iter().sum::<Points>().value(), 1.75);
        assert_eq!(points(0.5).times(3).to_string(), "1.5");
        assert_eq!(points(0.5).times(u64::MAX), Points(u64::MAX));
    }
}
