//! From times and errors to places on a panel, logarithmically.

use super::label::Rect;
use crate::bench::Row;

/// Both scales of all panels.
pub(super) struct Scales {
    inside: Rect,
    /// The powers of ten at the lower and the upper end.
    errors: (i32, i32),
    times: (f64, f64),
}

/// Just below what a correct rounding to `f64` leaves.
const LOWEST: i32 = -17;
/// From here on there is no digit, and more makes no difference.
const HIGHEST: i32 = 2;
/// Room, in powers of ten, below the lowest error for what is exact, and above
/// the highest for kernels without a single hit.
const MARGIN: f64 = 2.0;

/// A power of ten as people write it into programs.
fn power_of_ten(power: i32) -> String {
    format!("1e{power}")
}

impl Scales {
    /// Scales that hold all these.
    pub(super) fn new(rows: &[Row], inside: Rect) -> Self {
        let power = |x: f64| libm::log10(x).ceil() as i32;
        let highest = rows.iter().map(|row| row.error_p999).filter(|e| *e > 0.0).map(power).max();
        let errors = (LOWEST, highest.unwrap_or(0).clamp(0, HIGHEST));
        let fastest = rows.iter().map(|row| row.ns).fold(f64::INFINITY, f64::min);
        let slowest = rows.iter().map(|row| row.ns).fold(0.0, f64::max);
        // Room for labels; and a decade at least, also for no rows at all.
        let fastest = if fastest.is_finite() && fastest > 0.0 { fastest * 0.6 } else { 1.0 };
        Self { inside, errors, times: (fastest, (slowest * 2.0).max(fastest * 10.0)) }
    }

    /// Where a kernel's point is.
    pub(super) fn point(&self, row: &Row) -> (f64, f64) {
        (self.x(row.ns), self.y(row.error_p999))
    }

    fn x(&self, ns: f64) -> f64 {
        let share = libm::log(ns / self.times.0) / libm::log(self.times.1 / self.times.0);
        self.inside.left + share * (self.inside.right - self.inside.left)
    }

    /// Where an error is: 0 on the floor, NaN at the ceiling.
    pub(super) fn y(&self, error: f64) -> f64 {
        let (low, high) = (f64::from(self.errors.0), f64::from(self.errors.1));
        let power = if error == 0.0 {
            low - MARGIN / 2.0
        } else if error.is_nan() {
            high + MARGIN / 2.0
        } else {
            libm::log10(error).clamp(low, high)
        };
        let share = (power - (low - MARGIN)) / (high - low + 2.0 * MARGIN);
        self.inside.bottom - share * (self.inside.bottom - self.inside.top)
    }

    /// Places and names of errors: every second power of ten, the floor, and
    /// the ceiling.
    pub(super) fn errors(&self) -> Vec<(f64, String)> {
        let even = (self.errors.0..=self.errors.1).filter(|power| power % 2 == 0);
        let named = |power: i32| (self.y(libm::exp10(f64::from(power))), power_of_ten(power));
        let ends = [(0.0, "exact"), (f64::NAN, "no hit")].map(|(e, s)| (self.y(e), s.to_owned()));
        even.map(named).chain(ends).collect()
    }

    /// Places and names of times: 1, 2 and 5 of each power of ten.
    pub(super) fn times(&self) -> Vec<(f64, String)> {
        let (fastest, slowest) = self.times;
        let powers = libm::log10(fastest).floor() as i32..=libm::log10(slowest).ceil() as i32;
        let each = powers.flat_map(|power| [1.0, 2.0, 5.0].map(|x| x * libm::exp10(power.into())));
        each.filter(|ns| (fastest..=slowest).contains(ns))
            .map(|ns| (self.x(ns), format!("{}", (ns * 1e3).round() / 1e3)))
            .collect()
    }
}
