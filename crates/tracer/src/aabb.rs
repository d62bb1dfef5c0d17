//! `Aabb`: an axis-aligned bounding box, which may be empty or unbounded.

use glam::DVec3;

use crate::UnitVec;
use crate::math::max_abs;

/// All points `x` with `min <= x <= max` in each axis.
///
/// It bounds shapes for an accelerator, which allows for the rounding of their
/// formulas, and is not itself a shape: see [`crate::shape::AxisBox`] for the
/// box that renders.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Aabb {
    /// The lowest corner.
    pub min: DVec3,
    /// The highest corner.
    pub max: DVec3,
}

impl Aabb {
    /// Holds no point; the neutral element of [`Aabb::union`].
    pub const EMPTY: Self =
        Self { min: DVec3::splat(f64::INFINITY), max: DVec3::splat(f64::NEG_INFINITY) };

    /// Holds every point: the bounds of a plane.
    pub const EVERYTHING: Self =
        Self { min: DVec3::splat(f64::NEG_INFINITY), max: DVec3::splat(f64::INFINITY) };

    /// The smallest box around some points.
    pub fn around(points: impl IntoIterator<Item = DVec3>) -> Self {
        points.into_iter().fold(Self::EMPTY, |b, p| Self { min: b.min.min(p), max: b.max.max(p) })
    }

    /// The smallest box around the circle of this radius around `center`, across
    /// a normal `n`: along axis `k` it reaches `radius sqrt(1 - n_k^2)`.
    pub(crate) fn around_circle(center: DVec3, n: UnitVec, radius: f64) -> Self {
        let squares = *n * *n;
        let across = DVec3::new(
            (squares.y + squares.z).sqrt(),
            (squares.z + squares.x).sqrt(),
            (squares.x + squares.y).sqrt(),
        );
        let reach = radius * across;
        Self { min: center - reach, max: center + reach }
    }

    /// The smallest box that holds both.
    #[must_use]
    pub fn union(self, other: Self) -> Self {
        Self { min: self.min.min(other.min), max: self.max.max(other.max) }
    }

    /// Whether every coordinate is finite; not so for [`Aabb::EMPTY`].
    pub fn is_finite(&self) -> bool {
        self.min.is_finite() && self.max.is_finite()
    }

    /// The largest absolute coordinate; meaningful for finite boxes only.
    pub fn max_abs(&self) -> f64 {
        max_abs(self.min).max(max_abs(self.max))
    }

    /// The middle; meaningful for finite boxes only.
    pub fn center(&self) -> DVec3 {
        0.5 * self.min + 0.5 * self.max
    }

    /// Half the surface area; 0 for an empty box.
    pub fn half_area(&self) -> f64 {
        let e = self.max - self.min;
        if e.min_element() < 0.0 { 0.0 } else { e.x * e.y + e.y * e.z + e.z * e.x }
    }

    /// The box widened on every side by `by`.
    #[must_use]
    pub fn widened(self, by: f64) -> Self {
        Self { min: self.min - DVec3::splat(by), max: self.max + DVec3::splat(by) }
    }

    /// The eight corners.
    pub fn corners(&self) -> [DVec3; 8] {
        std::array::from_fn(|i| {
            let pick = |bit: usize, lo: f64, hi: f64| if i >> bit & 1 == 0 { lo } else { hi };
            DVec3::new(
                pick(0, self.min.x, self.max.x),
                pick(1, self.min.y, self.max.y),
                pick(2, self.min.z, self.max.z),
            )
        })
    }

    /// Whether the point is inside or within `slack` of the box.
    pub fn contains(&self, p: DVec3, slack: f64) -> bool {
        let wide = self.widened(slack);
        p.cmpge(wide.min).all() && p.cmple(wide.max).all()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_circle_touches_all_sides_of_its_box() {
        let axis = Aabb::around_circle(DVec3::X, UnitVec::Y, 2.0);
        assert_eq!(axis, Aabb { min: DVec3::new(-1.0, 0.0, -2.0), max: DVec3::new(3.0, 0.0, 2.0) });
        let n = UnitVec::new(DVec3::new(1.0, 2.0, -2.0)).unwrap();
        let circle = Aabb::around_circle(DVec3::ZERO, n, 3.0);
        let side = DVec3::new(8.0_f64.sqrt(), 5.0_f64.sqrt(), 5.0_f64.sqrt());
        assert!((circle.max - side).length() < 1e-14 && circle.min == -circle.max, "{circle:?}");
    }
}
