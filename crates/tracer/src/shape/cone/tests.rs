//! The cone against answers known on paper: ugly rays, the apex, the other
//! half that is not there, generators, the base, and far away.

use glam::dvec3;

use super::*;
use crate::shape::Geometry;

const AHEAD: Interval = Interval::AHEAD;

/// As high as wide at the base: the side rises at 45 degrees.
fn cone(caps: bool) -> Cone {
    Cone::new(dvec3(1.0, 2.0, 0.0), dvec3(1.0, 0.0, 0.0), 2.0, caps).unwrap()
}

/// `t` and the part with a base, and `t` without.
#[track_caller]
fn check(p: [f64; 3], d: [f64; 3], closed: Option<(f64, u32)>, open: Option<f64>) {
    let ray = Ray::new(DVec3::from_array(p), DVec3::from_array(d));
    let near = |x: f64| (x * 1e12).round() / 1e12;
    assert_eq!(cone(true).intersect(&ray, AHEAD).map(|c| (near(c.t), c.part)), closed);
    assert_eq!(cone(false).intersect(&ray, AHEAD).map(|c| near(c.t)), open);
}

#[test]
fn ugly_rays_miss() {
    let nan = f64::NAN;
    check([nan, 1.0, 9.0], [0.0, 0.0, -1.0], None, None);
    check([1.0, 1.0, 9.0], [0.0, nan, -1.0], None, None);
    check([1.0, 1.0, f64::INFINITY], [0.0, 0.0, -1.0], None, None);
    check([1.0, 1.0, 9.0], [0.0, f64::INFINITY, -1.0], None, None);
    check([1.0, 1.0, 9.0], [0.0, 0.0, 0.0], None, None);
    check([1.0, 2.0, 0.0], [0.0, 0.0, 0.0], None, None);
}

#[test]
fn across_the_axis() {
    let d = [0.0, 0.0, -1.0];
    check([1.0, 1.0, 9.0], d, Some((8.0, SIDE)), Some(8.0));
    check([1.0, 1.0, 0.0], d, Some((1.0, SIDE)), Some(1.0));
    check([1.0, 1.0, -1.5], d, None, None);
    check([1.0, 0.0, 9.0], d, Some((7.0, SIDE)), Some(7.0));
    check([1.0, -1e-300, 9.0], d, None, None);
    // Above the apex is the half that is not there.
    check([1.0, 3.0, 9.0], d, None, None);
    check([1.0, 2.0, 9.0], d, Some((9.0, SIDE)), Some(9.0));
}

#[test]
fn along_the_axis() {
    let (down, up) = ([0.0, -1.0, 0.0], [0.0, 1.0, 0.0]);
    check([1.0, 9.0, 0.0], down, Some((7.0, SIDE)), Some(7.0));
    check([1.0, -9.0, 0.0], up, Some((9.0, BASE)), Some(11.0));
    check([1.0, 1.0, 0.0], down, Some((1.0, BASE)), None);
    check([1.0, 1.0, 0.0], up, Some((1.0, SIDE)), Some(1.0));
    check([2.5, 9.0, 0.0], down, Some((8.5, SIDE)), Some(8.5));
    check([3.5, 9.0, 0.0], down, None, None);
}

#[test]
fn along_a_generator() {
    // Parallel to the side's slope, inside it: in by the base, out never or
    // the other way round.
    check([0.0, 2.0, 0.0], [1.0, -1.0, 0.0], Some((0.5, SIDE)), Some(0.5));
    check([2.0, 0.5, 0.0], [-1.0, 1.0, 0.0], Some((1.25, SIDE)), Some(1.25));
    check([2.5, -0.5, 0.0], [-1.0, 1.0, 0.0], Some((0.5, BASE)), Some(2.0));
    // Above it, in the plane of the axis: only the half that is not there.
    check([3.0, 2.0, 0.0], [1.0, -1.0, 0.0], None, None);
}

#[test]
fn every_ray_from_inside_gets_out() {
    let mut rng = fastrand::Rng::with_seed(1);
    let cone = cone(true);
    for i in 0..10_000 {
        let mut any = || dvec3(rng.f64(), rng.f64(), rng.f64()) * 2.0 - 1.0;
        let inside = dvec3(1.0, 0.5, 0.0) + 0.3 * any();
        // At the apex, at the rim, or anywhere.
        let rim = any().with_y(0.0).normalize() * 2.0;
        let to = [cone.axis.ends[0], cone.axis.ends[1] + rim, inside + any()][i % 3];
        let ray = Ray::new(inside, to - inside);
        assert!(cone.intersect(&ray, AHEAD).is_some(), "{ray:?}");
    }
}

#[test]
fn far_away_no_digits_are_lost() {
    for caps in [true, false] {
        let ray = Ray::new(dvec3(1.5, 1.0, 1e8), dvec3(0.0, 0.0, -1.0));
        let contact = cone(caps).intersect(&ray, AHEAD).unwrap();
        assert_eq!(contact.t, 1e8 - 0.75_f64.sqrt());
        // The point and the normal have more digits than t.
        let surface = cone(caps).surface(&ray, &contact);
        let exact = dvec3(1.5, 1.0, 0.75_f64.sqrt());
        let normal = dvec3(0.5, 1.0, 0.75_f64.sqrt()) / 2.0_f64.sqrt();
        assert!((*surface.geometric_normal - normal).length() < 4.0 * UNIT_ROUNDOFF);
        assert!((surface.point - exact).length() < 8.0 * UNIT_ROUNDOFF);
    }
}

#[test]
fn at_the_apex_the_normal_is_the_axis() {
    let ray = Ray::new(dvec3(1.0, 9.0, 0.0), dvec3(0.0, -1.0, 0.0));
    let contact = cone(true).intersect(&ray, AHEAD).unwrap();
    let surface = cone(true).surface(&ray, &contact);
    assert_eq!((surface.point, *surface.geometric_normal), (dvec3(1.0, 2.0, 0.0), DVec3::Y));
}

#[test]
fn a_ray_that_leaves_meets_only_the_way_out() {
    let leaving = |caps, p: DVec3, d: DVec3, part| {
        let normal = if part == SIDE { dvec3(1.0, 1.0, 0.0) } else { -DVec3::Y };
        let from = Departure { part, outward: d.dot(normal) >= 0.0 };
        let contact = cone(caps).intersect_leaving(&Ray::new(p, d), AHEAD, from);
        contact.map(|c| ((c.t * 1e9).round() / 1e9, c.part))
    };
    // Starts off the surface by rounding, on either side of it.
    for off in [-1e-15, 0.0, 1e-15] {
        let on_side = dvec3(2.0 + off, 1.0, 0.0);
        for caps in [true, false] {
            assert_eq!(leaving(caps, on_side, DVec3::X, SIDE), None);
            assert_eq!(leaving(caps, on_side, DVec3::Z, SIDE), None);
            assert_eq!(leaving(caps, on_side, -DVec3::X, SIDE), Some((2.0, SIDE)));
        }
        assert_eq!(leaving(true, on_side, -DVec3::Y, SIDE), Some((1.0, BASE)));
        assert_eq!(leaving(false, on_side, -DVec3::Y, SIDE), None);
        let on_base = dvec3(1.0, off, 0.0);
        assert_eq!(leaving(true, on_base, -DVec3::Y, BASE), None);
        assert_eq!(leaving(true, on_base, DVec3::Y, BASE), Some((2.0, SIDE)));
        assert_eq!(leaving(true, on_base, dvec3(1.0, 1.0, 0.0), BASE), Some((1.0, SIDE)));
    }
}

#[test]
fn sizes_at_the_limits() {
    for scale in [1e-60, 1e-12, 1e12, 5e59] {
        for caps in [true, false] {
            let cone = Cone::new(DVec3::ZERO, DVec3::Y * scale, scale, caps).unwrap();
            let ray = Ray::new(dvec3(0.0, 0.5, 2.0) * scale, DVec3::Z * -scale);
            let t = cone.intersect(&ray, AHEAD).unwrap().t;
            assert!((t - 1.5).abs() < 1e-14, "{scale} {t:?}");
        }
    }
    let ray = Ray::new(dvec3(0.5, 0.3, 1e60), dvec3(0.0, 0.0, -1.0));
    for caps in [true, false] {
        for (length, radius) in [(1e-60, 1e60), (1e60, 1e-60), (1e-60, 1e-60)] {
            let cone = Cone::new(DVec3::ZERO, DVec3::Y * length, radius, caps).unwrap();
            let contact = cone.intersect(&ray, AHEAD);
            assert!(contact.is_none_or(|c| c.t.is_finite()), "{length} {radius} {contact:?}");
        }
    }
}

#[test]
fn bad_cones_are_refused() {
    let refused = Cone::new(DVec3::ONE, DVec3::ONE, 0.0, true).unwrap_err();
    assert_eq!(refused.refusals().len(), 2);
    assert_eq!(refused.refusals()[1].field, "base");
}
