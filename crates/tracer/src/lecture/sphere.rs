//! Ray-sphere intersection by the lecture's algebraic and geometric forms.
//!
//! The slides have a unit sphere at the origin; a general one is moved there
//! by `p = origin - center`, with `r^2` in place of 1.

use glam::DVec3;

use crate::{Interval, Ray};

/// The quadratic formula with a direction of any length:
///
/// `t = (-d.p +- sqrt((d.p)^2 - (d.d)(p.p - r^2))) / d.d`
///
/// Loses digits as the square of the distance in radii: from 1e8 radii away
/// hit and miss are a matter of luck.
///
/// Source: slide "Ray-sphere intersection: algebraic".
pub fn sphere_algebraic(center: DVec3, radius: f64, ray: &Ray, range: Interval) -> Option<f64> {
    let p = ray.origin - center;
    let d = ray.direction;
    let discriminant = d.dot(p) * d.dot(p) - d.dot(d) * (p.dot(p) - radius * radius);
    // A negative discriminant has a NaN root, which no interval contains.
    let root = discriminant.sqrt();
    let near = (-d.dot(p) - root) / d.dot(d);
    let far = (-d.dot(p) + root) / d.dot(d);
    [near, far].into_iter().find(|&t| range.contains(t))
}

/// The picture behind the formula, for a unit direction: the ray passes the
/// center closest at `t_m`, at distance `l_m`; half the chord is
/// `sqrt(r^2 - l_m^2)` by Pythagoras.
///
/// The slide's direction is of unit length. A general one is normalized first
/// and `t` given back in its units; from far away the rounding of that alone
/// decides between hit and miss.
///
/// Source: slide "Ray-sphere intersection: algebraic", its unit-vector form
/// `t = -d.p +- sqrt((d.p)^2 - p.p + 1)`, read geometrically.
pub fn sphere_geometric(center: DVec3, radius: f64, ray: &Ray, range: Interval) -> Option<f64> {
    let p = ray.origin - center;
    let length = ray.direction.length();
    let d = ray.direction / length;
    let t_m = -d.dot(p);
    let l_m_squared = p.dot(p) - t_m * t_m;
    let half_chord = (radius * radius - l_m_squared).sqrt();
    [t_m - half_chord, t_m + half_chord]
        .into_iter()
        .map(|distance| distance / length)
        .find(|&t| range.contains(t))
}

#[cfg(test)]
mod tests {
    use glam::dvec3;

    use super::*;

    /// Both forms, one expected answer; the sphere has radius 2 at (1, 0, 0).
    #[track_caller]
    fn check(p: [f64; 3], d: [f64; 3], range: Interval, expected: Option<f64>) {
        let ray = Ray::new(DVec3::from_array(p), DVec3::from_array(d));
        for form in [sphere_algebraic, sphere_geometric] {
            let t = form(dvec3(1.0, 0.0, 0.0), 2.0, &ray, range);
            assert_eq!(t.is_some(), expected.is_some(), "{t:?} is not {expected:?}");
            if let (Some(t), Some(expected)) = (t, expected) {
                assert!((t - expected).abs() < 1e-12, "{t} is not {expected}");
            }
        }
    }

    #[test]
    fn outside_inside_behind_beside_tangent() {
        let ahead = Interval::AHEAD;
        let toward = [0.0, 0.0, -1.0];
        check([1.0, 0.0, 5.0], toward, ahead, Some(3.0));
        check([1.0, 0.0, 0.0], toward, ahead, Some(2.0));
        check([1.0, 0.0, -5.0], toward, ahead, None);
        check([4.0, 0.0, 5.0], toward, ahead, None);
        check([3.0, 0.0, 5.0], toward, ahead, Some(5.0));
    }

    #[test]
    fn t_counts_in_direction_lengths() {
        check([1.0, 0.0, 5.0], [0.0, 0.0, -0.5], Interval::AHEAD, Some(6.0));
        check([1.0, 0.0, 5.0], [0.0, 0.0, -1e3], Interval::AHEAD, Some(3e-3));
    }

    #[test]
    fn the_far_root_counts_where_the_near_one_is_out_of_range() {
        let (p, d) = ([1.0, 0.0, 5.0], [0.0, 0.0, -1.0]);
        check(p, d, Interval::new(3.5, 10.0), Some(7.0));
        check(p, d, Interval::new(3.5, 6.5), None);
        check(p, d, Interval::new(0.0, 3.0), None);
    }
}
