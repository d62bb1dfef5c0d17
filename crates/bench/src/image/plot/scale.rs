//! From seconds and errors to places on a panel, logarithmically.

use crate::image::curve::Point;

/// A rectangle with sides along the axes, in pixels, y downwards.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Rect {
    pub(super) left: f64,
    pub(super) top: f64,
    pub(super) right: f64,
    pub(super) bottom: f64,
}

/// Both scales of all panels, from least to most.
pub(super) struct Scales {
    inside: Rect,
    seconds: (f64, f64),
    rmse: (f64, f64),
}

/// Room around all points, as a factor.
const AROUND: f64 = 1.5;

impl Scales {
    /// Scales that hold all these, and a decade at least.
    pub(super) fn new(points: &[Point], inside: Rect) -> Self {
        let range = |numbers: &mut dyn Iterator<Item = f64>| {
            let (least, most) = numbers
                .filter(|x| *x > 0.0 && x.is_finite())
                .fold((f64::INFINITY, 0.0), |(least, most), x| (x.min(least), x.max(most)));
            let least = if least.is_finite() { least / AROUND } else { 1.0 };
            (least, (most * AROUND).max(least * 10.0))
        };
        Self {
            inside,
            seconds: range(&mut points.iter().map(|point| point.seconds)),
            rmse: range(&mut points.iter().map(|point| point.rmse)),
        }
    }

    /// Where a point is.
    pub(super) fn place(&self, point: Point) -> (f64, f64) {
        (self.x(point.seconds), self.y(point.rmse))
    }

    pub(super) fn x(&self, seconds: f64) -> f64 {
        self.inside.left + share(seconds, self.seconds) * (self.inside.right - self.inside.left)
    }

    /// Where an error is; 0 is on the floor.
    pub(super) fn y(&self, rmse: f64) -> f64 {
        self.inside.bottom - share(rmse, self.rmse) * (self.inside.bottom - self.inside.top)
    }

    /// Powers of ten and their names.
    pub(super) fn errors(&self) -> Vec<(f64, String)> {
        let (least, most) = self.rmse;
        powers(self.rmse)
            .map(ten_to_the)
            .filter(|error| (least..=most).contains(error))
            .map(|error| (error, format!("{error:e}")))
            .collect()
    }

    /// Powers of ten, and their names.
    pub(super) fn times(&self) -> Vec<(f64, String)> {
        let (least, most) = self.seconds;
        powers(self.seconds)
            .map(ten_to_the)
            .filter(|seconds| (least..=most).contains(seconds))
            .map(|seconds| (seconds, seconds.to_string()))
            .collect()
    }
}

/// The powers of ten from below to above a range.
fn powers((least, most): (f64, f64)) -> std::ops::RangeInclusive<i32> {
    libm::log10(least).floor() as i32..=libm::log10(most).ceil() as i32
}

/// The number that `1e...` is, to the bit.
fn ten_to_the(power: i32) -> f64 {
    format!("1e{power}").parse().unwrap_or(f64::NAN)
}

/// How far from the least to the most, between 0 and 1.
fn share(x: f64, (least, most): (f64, f64)) -> f64 {
    (libm::log(x.max(least) / least) / libm::log(most / least)).min(1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn left_is_faster_and_down_is_more_exact() {
        let inside = Rect { left: 0.0, top: 0.0, right: 100.0, bottom: 100.0 };
        let points = [(0.1, 1e-1), (10.0, 1e-4), (1.0, 0.0)];
        let points = points.map(|(seconds, rmse)| Point { seconds, rmse });
        let scales = Scales::new(&points, inside);
        let [a, b, c] = points.map(|point| scales.place(point));
        assert!(a.0 < c.0 && c.0 < b.0 && a.1 < b.1 && b.1 < c.1 && c.1 == 100.0);
        let names: Vec<_> = scales.errors().into_iter().map(|(_, name)| name).collect();
        assert_eq!(names, ["1e-4", "1e-3", "1e-2", "1e-1"]);
        let names: Vec<_> = scales.times().into_iter().map(|(_, name)| name).collect();
        assert_eq!(names, ["0.1", "1", "10"]);
    }
}
