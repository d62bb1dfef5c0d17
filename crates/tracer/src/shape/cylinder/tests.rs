//! The cylinder against answers known on paper: ugly rays, along and across
//! the axis, at rims, from inside, and from far away.

use glam::dvec3;

use super::*;
use crate::shape::Geometry;

const AHEAD: Interval = Interval::AHEAD;

fn cylinder(caps: bool) -> Cylinder {
    Cylinder::new(dvec3(1.0, 0.0, 0.0), dvec3(1.0, 4.0, 0.0), 2.0, caps).unwrap()
}

/// `t` and the part with caps, and `t` without.
#[track_caller]
fn check(p: [f64; 3], d: [f64; 3], closed: Option<(f64, u32)>, open: Option<f64>) {
    let ray = Ray::new(DVec3::from_array(p), DVec3::from_array(d));
    assert_eq!(cylinder(true).intersect(&ray, AHEAD).map(|c| (c.t, c.part)), closed);
    assert_eq!(cylinder(false).intersect(&ray, AHEAD).map(|c| c.t), open);
}

#[test]
fn ugly_rays_miss() {
    let nan = f64::NAN;
    check([nan, 1.0, 9.0], [0.0, 0.0, -1.0], None, None);
    check([1.0, 1.0, 9.0], [0.0, nan, -1.0], None, None);
    check([1.0, 1.0, f64::INFINITY], [0.0, 0.0, -1.0], None, None);
    check([1.0, 1.0, 9.0], [0.0, 0.0, f64::NEG_INFINITY], None, None);
    check([1.0, 1.0, 9.0], [0.0, 0.0, 0.0], None, None);
    check([1.0, 1.0, 1.0], [0.0, 0.0, 0.0], None, None);
    let ray = Ray::new(dvec3(1.0, 1.0, 9.0), dvec3(0.0, 0.0, -1.0));
    assert_eq!(cylinder(true).intersect(&ray, Interval::new(0.0, nan)), None);
}

#[test]
fn across_the_axis() {
    let d = [0.0, 0.0, -1.0];
    check([1.0, 1.0, 9.0], d, Some((7.0, SIDE)), Some(7.0));
    check([1.0, 1.0, 9.0], [0.0, 0.0, -0.5], Some((14.0, SIDE)), Some(14.0));
    check([1.0, 1.0, 0.0], d, Some((2.0, SIDE)), Some(2.0));
    check([1.0, 1.0, -3.0], d, None, None);
    // Along the rims' planes the ends belong to it, and nothing beyond.
    check([1.0, 0.0, 9.0], d, Some((7.0, SIDE)), Some(7.0));
    check([1.0, 4.0, 9.0], d, Some((7.0, SIDE)), Some(7.0));
    check([1.0, 4.0_f64.next_up(), 9.0], d, None, None);
    check([1.0, -1e-300, 9.0], d, None, None);
    // Tangent, and next to it.
    check([3.0, 1.0, 9.0], d, Some((9.0, SIDE)), Some(9.0));
    check([3.0_f64.next_up(), 1.0, 9.0], d, None, None);
}

#[test]
fn along_the_axis_only_caps_are_met() {
    for x in [1.0, 2.5, 3.0, -1.0] {
        check([x, 9.0, 0.0], [0.0, -1.0, 0.0], Some((5.0, 2)), None);
        check([x, -9.0, 0.0], [0.0, 1.0, 0.0], Some((9.0, 1)), None);
        check([x, 1.0, 0.0], [0.0, -2.0, 0.0], Some((0.5, 1)), None);
    }
    check([3.0_f64.next_up(), 9.0, 0.0], [0.0, -1.0, 0.0], None, None);
}

#[test]
fn through_one_cap_and_the_side() {
    // Enters by the upper cap at (2, 4), leaves by the side at (3, 3).
    check([0.0, 6.0, 0.0], [1.0, -1.0, 0.0], Some((2.0, 2)), Some(3.0));
    // From inside out of the rim itself.
    check([1.0, 2.0, 0.0], [1.0, 1.0, 0.0], Some((2.0, 2)), Some(2.0));
}

#[test]
fn far_away_no_digits_are_lost() {
    // From 1e8 radii past the axis at half the radius: t = 1e8 - sqrt(3)/2.
    for caps in [true, false] {
        let tube = Cylinder::new(dvec3(0.0, -3.0, 0.0), DVec3::Y, 1.0, caps).unwrap();
        let ray = Ray::new(dvec3(0.5, 0.0, 1e8), dvec3(0.0, 0.0, -1.0));
        let contact = tube.intersect(&ray, AHEAD).unwrap();
        assert_eq!(contact.t, 1e8 - 0.75_f64.sqrt());
        // The point and the normal have more digits than t.
        let surface = tube.surface(&ray, &contact);
        let exact = dvec3(0.5, 0.0, 0.75_f64.sqrt());
        assert!((*surface.geometric_normal - exact).length() < 4.0 * UNIT_ROUNDOFF);
        assert!((surface.point - exact).length() < 4.0 * UNIT_ROUNDOFF);
    }
}

#[test]
fn normals_point_out_from_both_sides() {
    for (p, d, expected) in [
        ([1.0, 1.0, 9.0], [0.0, 0.0, -1.0], DVec3::Z),
        ([1.0, 1.0, 1.0], [0.0, 0.0, 3.0], DVec3::Z),
        ([2.0, 9.0, 0.5], [0.0, -1.0, 0.0], DVec3::Y),
        ([2.0, 1.0, 0.5], [0.0, -1.0, 0.0], -DVec3::Y),
    ] {
        let ray = Ray::new(DVec3::from_array(p), DVec3::from_array(d));
        let contact = cylinder(true).intersect(&ray, AHEAD).unwrap();
        let surface = cylinder(true).surface(&ray, &contact);
        assert_eq!(*surface.geometric_normal, expected);
        assert_eq!(surface.point, ray.at(contact.t));
    }
}

#[test]
fn a_ray_that_leaves_meets_only_the_way_out() {
    // Starts off the surface by rounding, on the wrong side of it.
    for off in [-1e-15, 0.0, 1e-15] {
        let leaving = |caps, p: DVec3, d: DVec3, part| {
            let normal = if part == SIDE { DVec3::Z } else { DVec3::Y };
            let from = Departure { part, outward: d.dot(normal) >= 0.0 };
            let contact = cylinder(caps).intersect_leaving(&Ray::new(p, d), AHEAD, from);
            contact.map(|c| ((c.t * 1e9).round() * 1e-9, c.part))
        };
        let on_side = dvec3(1.0, 1.0, 2.0 + off);
        for caps in [true, false] {
            assert_eq!(leaving(caps, on_side, DVec3::Z, SIDE), None);
            assert_eq!(leaving(caps, on_side, dvec3(5.0, 1.0, 0.0), SIDE), None);
            assert_eq!(leaving(caps, on_side, -DVec3::Z, SIDE), Some((4.0, SIDE)));
        }
        let up = dvec3(0.0, 4.0, -1.0);
        assert_eq!(leaving(true, on_side, up, SIDE), Some((0.75, 2)));
        assert_eq!(leaving(false, on_side, up, SIDE), None);
        let on_cap = dvec3(1.0, 4.0 + off, 0.0);
        assert_eq!(leaving(true, on_cap, DVec3::Y, 2), None);
        assert_eq!(leaving(true, on_cap, DVec3::X, 2), None);
        assert_eq!(leaving(true, on_cap, -DVec3::Y, 2), Some((4.0, 1)));
        assert_eq!(leaving(true, on_cap, dvec3(2.0, -1.0, 0.0), 2), Some((1.0, SIDE)));
    }
}

#[test]
fn sizes_at_the_limits() {
    for scale in [1e-60, 1e-12, 1e12, 5e59] {
        for caps in [true, false] {
            let (a, b) = (dvec3(0.0, 0.0, 0.0), dvec3(0.0, scale, 0.0));
            let tube = Cylinder::new(a, b, scale, caps).unwrap();
            let p = dvec3(0.0, 0.5, 2.0) * scale;
            for length in [1e-200, 1.0, 1e200] {
                let d = dvec3(0.0, 0.0, -length);
                let t = tube.intersect(&Ray::new(p, d), AHEAD).map(|c| c.t * length / scale);
                // The quotient of the extremes has no place among the numbers.
                assert!(t.is_none_or(|t| (t - 1.0).abs() < 1e-14), "{scale} {length} {t:?}");
                assert!(t.is_some() || !(1e-100..1e100).contains(&length), "{scale} {length}");
            }
        }
    }
    let ray = Ray::new(dvec3(0.5, 0.3, 1e60), dvec3(0.0, 0.0, -1.0));
    for caps in [true, false] {
        let extremes = [(1e-60, 1e60), (1e60, 1e-60), (1e-60, 1e-60)];
        for (length, radius) in extremes {
            let tube = Cylinder::new(DVec3::ZERO, DVec3::Y * length, radius, caps).unwrap();
            let t = tube.intersect(&ray, AHEAD).map(|c| c.t);
            assert!(t.is_none_or(f64::is_finite), "{length} {radius} {t:?}");
        }
    }
}

#[test]
fn bad_cylinders_are_refused() {
    let refused = Cylinder::new(DVec3::ONE, DVec3::ONE, -1.0, true).unwrap_err();
    assert_eq!(
        refused.to_string(),
        "`radius`: expected a finite number above 0 (from 1e-60 to 1e60), found -1; \
         `b`: expected a point at least 1e-60 away from `a`, (1, 1, 1), found (1, 1, 1)"
    );
    let refused = Cylinder::new(DVec3::ONE, dvec3(f64::NAN, 0.0, 0.0), 1.0, true).unwrap_err();
    assert_eq!(refused.refusals().len(), 1);
}
