//! Ray-slab and ray-box intersection, for every sign and zero of `d`.

use glam::DVec3;

use crate::Ray;
use crate::fault::{Fault, seeded};

/// Where a ray enters and leaves the slab `min <= x <= max` of one axis:
///
/// `p_x + t_min d_x = x_min`, so `t_min = (x_min - p_x) / d_x`, likewise
/// `t_max`; with a negative `d_x` the ray meets the other side first. With
/// `d_x = 0` (either sign) the ray never crosses a side: it is inside for all
/// `t`, sides included, or for none.
///
/// Returns `(enter, leave)` with `enter <= leave`; `None` for a ray that never
/// is inside, and for NaN.
///
/// Source: slides "Ray-slab intersection" and "`d_x` positive or negative".
///
/// ```
/// use tracer::lecture::ray_slab;
/// assert_eq!(ray_slab(0.0, 2.0, 1.0, 3.0), Some((0.5, 1.5)));
/// assert_eq!(ray_slab(4.0, -2.0, 1.0, 3.0), Some((0.5, 1.5)));
/// assert_eq!(ray_slab(0.0, 0.0, 1.0, 3.0), None);
/// ```
#[inline(always)]
pub fn ray_slab(p: f64, d: f64, min: f64, max: f64) -> Option<(f64, f64)> {
    if d == 0.0 {
        let always = seeded(Fault::ZeroDirectionAlwaysInside);
        let never = seeded(Fault::ZeroDirectionNeverInside);
        return (!never && (always || min <= p && p <= max))
            .then_some((f64::NEG_INFINITY, f64::INFINITY));
    }
    let is_upward = d > 0.0 || seeded(Fault::SlabNotSwapped);
    let (near, far) = if is_upward { (min, max) } else { (max, min) };
    let (enter, leave) = ((near - p) / d, (far - p) / d);
    (enter <= leave).then_some((enter, leave))
}

/// Where a ray enters and leaves a box: inside the box is inside all three
/// slabs, so it enters at the last entry and leaves at the first exit.
///
/// Returns `(enter, leave)` for the whole line, whatever their signs; `None`
/// where the slabs' intervals do not meet. Grazing an edge or a corner counts
/// when the quotients come out equal; the box that renders,
/// [`AxisBox`](crate::shape::AxisBox), allows for their rounding.
///
/// Source: slides "Ray-slab intersection", in three axes.
pub fn ray_box(min: DVec3, max: DVec3, ray: &Ray) -> Option<(f64, f64)> {
    let (p, d) = (ray.origin, ray.direction);
    let (enter_x, leave_x) = ray_slab(p.x, d.x, min.x, max.x)?;
    let (enter_y, leave_y) = ray_slab(p.y, d.y, min.y, max.y)?;
    let (enter_z, leave_z) = ray_slab(p.z, d.z, min.z, max.z)?;
    let enter = enter_x.max(enter_y).max(enter_z);
    let leave = leave_x.min(leave_y).min(leave_z);
    (enter <= leave).then_some((enter, leave))
}

#[cfg(test)]
mod tests {
    use glam::dvec3;

    use super::*;

    const ALL: Option<(f64, f64)> = Some((f64::NEG_INFINITY, f64::INFINITY));

    #[track_caller]
    fn check(p: f64, d: f64, expected: Option<(f64, f64)>) {
        assert_eq!(ray_slab(p, d, -1.0, 3.0), expected);
    }

    #[test]
    fn slab_for_every_sign_of_d() {
        check(-5.0, 2.0, Some((2.0, 4.0)));
        check(7.0, -2.0, Some((2.0, 4.0)));
        check(7.0, 2.0, Some((-4.0, -2.0)));
        check(-5.0, -2.0, Some((-4.0, -2.0)));
        check(0.0, 1.0, Some((-1.0, 3.0)));
        check(0.0, -1.0, Some((-3.0, 1.0)));
        check(-1.0, 1.0, Some((0.0, 4.0)));
    }

    #[test]
    fn slab_for_both_zeros_of_d() {
        for zero in [0.0, -0.0] {
            check(0.0, zero, ALL);
            check(-1.0, zero, ALL);
            check(3.0, zero, ALL);
            check(3.0_f64.next_up(), zero, None);
            check(-5.0, zero, None);
        }
    }

    #[test]
    fn slab_with_special_numbers() {
        check(f64::NAN, 1.0, None);
        check(0.0, f64::NAN, None);
        check(f64::NAN, 0.0, None);
        check(0.0, 5e-324, ALL);
        check(-5.0, 5e-324, Some((f64::INFINITY, f64::INFINITY)));
    }

    #[test]
    fn box_is_where_all_three_slabs_are() {
        let (min, max) = (dvec3(0.0, 0.0, 0.0), dvec3(1.0, 2.0, 4.0));
        let across = |p, d| ray_box(min, max, &Ray::new(p, d));
        assert_eq!(across(dvec3(-1.0, 1.0, 1.0), DVec3::X), Some((1.0, 2.0)));
        assert_eq!(across(dvec3(2.0, 1.0, 1.0), DVec3::X), Some((-2.0, -1.0)));
        assert_eq!(across(dvec3(-1.0, 3.0, 1.0), DVec3::X), None);
        assert_eq!(across(dvec3(0.5, 1.0, 1.0), dvec3(1.0, 1.0, 1.0)), Some((-0.5, 0.5)));
        // Along an edge, and through a corner.
        assert_eq!(across(dvec3(0.0, -2.0, 0.0), DVec3::Y), Some((2.0, 4.0)));
        assert_eq!(across(dvec3(-1.0, -1.0, 0.0), dvec3(1.0, 1.0, 0.0)), Some((1.0, 2.0)));
        // Past a corner: the slabs are met one after the other.
        assert_eq!(across(dvec3(-1.0, 2.0, 1.0), dvec3(1.0, 1.0, 0.0)), None);
    }
}
