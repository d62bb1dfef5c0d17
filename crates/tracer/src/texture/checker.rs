//! `Checker`: two colors by turns, in unit squares.

use crate::fault::{Fault, seeded};
use crate::refused::color;
use crate::{Refused, Rgb};

/// Two colors by turns: the first where `floor(u) + floor(v)` is even, as it is
/// between 0 and 1, the second where it is odd. A square has its left and its
/// lower side, and those at the right and above are the next one's.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Checker {
    colors: [Rgb; 2],
}

impl Checker {
    /// A checkerboard of these colors.
    ///
    /// # Errors
    /// Refuses (as `a` and `b`) colors that are negative or not finite.
    pub fn new(colors: [Rgb; 2]) -> Result<Self, Refused> {
        let [a, b] = colors;
        Refused::unless([color("a", a), color("b", b)])?;
        Ok(Self { colors })
    }

    /// The color at `(u, v)`, and which of the two it is, from 1.
    pub(super) fn look_up(&self, uv: [f64; 2]) -> (Rgb, u32) {
        // Each by itself, as a sum of two large ones may round.
        let [odd_u, odd_v] = uv.map(|x| {
            let whole = if seeded(Fault::CheckerTruncated) { x.trunc() } else { x.floor() };
            whole.rem_euclid(2.0) == 1.0
        });
        let is_odd = odd_u != odd_v;
        (self.colors[usize::from(is_odd)], 1 + u32::from(is_odd))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(uv: [f64; 2], expected: usize) {
        let colors = [Rgb::new(1.0, 0.5, 0.0), Rgb::new(0.0, 0.25, 1.0)];
        let found = Checker::new(colors).unwrap().look_up(uv);
        assert_eq!(found, (colors[expected], 1 + expected as u32), "{uv:?}");
    }

    #[test]
    fn squares_on_both_sides_of_zero() {
        check([0.5, 0.5], 0);
        check([1.5, 0.5], 1);
        check([1.5, 1.5], 0);
        check([-0.5, 0.5], 1);
        check([-0.5, -0.5], 0);
        check([-1.5, 0.5], 0);
        check([-1.5, -0.5], 1);
    }

    #[test]
    fn a_square_has_its_lower_sides() {
        check([0.0, 0.0], 0);
        check([-0.0, 0.0], 0);
        check([1.0_f64.next_down(), 0.0], 0);
        check([1.0, 0.0], 1);
        check([-1.0, 0.0], 1);
        check([0.0_f64.next_down(), 0.0], 1);
        check([1.0, 1.0], 0);
    }

    #[test]
    fn far_away_it_goes_on() {
        // Odd and even numbers as far as there are any.
        check([9_007_199_254_740_991.0, 0.0], 1);
        check([-9_007_199_254_740_991.0, 0.0], 1);
        check([9_007_199_254_740_991.0, 1.0], 0);
        check([1e60, -1e60], 0);
    }

    #[test]
    fn bad_colors_are_refused() {
        let bad = [Rgb::new(-1.0, 0.0, 0.0), Rgb::new(0.0, f64::NAN, 0.0)];
        assert_eq!(Checker::new(bad).unwrap_err().refusals().len(), 2);
    }
}
