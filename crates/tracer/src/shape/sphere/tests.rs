//! The stable sphere against answers known on paper, and where the textbook
//! form fails.

use glam::dvec3;

use super::*;
use crate::lecture::{sphere_algebraic, sphere_geometric};
use crate::shape::Geometry;

#[track_caller]
fn check(p: [f64; 3], d: [f64; 3], range: Interval, expected: Option<f64>) {
    let sphere = Sphere::new(dvec3(1.0, 0.0, 0.0), 2.0).unwrap();
    let ray = Ray::new(DVec3::from_array(p), DVec3::from_array(d));
    assert_eq!(sphere.intersect(&ray, range).map(|c| c.t), expected);
}

const AHEAD: Interval = Interval::AHEAD;

#[test]
fn ugly_rays_miss() {
    let nan = f64::NAN;
    check([nan, 0.0, 5.0], [0.0, 0.0, -1.0], AHEAD, None);
    check([1.0, 0.0, 5.0], [0.0, nan, -1.0], AHEAD, None);
    check([1.0, 0.0, f64::INFINITY], [0.0, 0.0, -1.0], AHEAD, None);
    check([1.0, 0.0, 5.0], [0.0, 0.0, 0.0], AHEAD, None);
    check([1.0, 0.0, 5.0], [0.0, 0.0, -1.0], Interval::new(nan, 9.0), None);
    check([1.0, 0.0, 5.0], [0.0, 0.0, -1.0], Interval::new(0.0, nan), None);
}

#[test]
fn outside_inside_behind_beside_tangent() {
    let d = [0.0, 0.0, -1.0];
    check([1.0, 0.0, 5.0], d, AHEAD, Some(3.0));
    check([1.0, 0.0, 5.0], [0.0, 0.0, -0.5], AHEAD, Some(6.0));
    check([1.0, 0.0, 0.0], d, AHEAD, Some(2.0));
    check([1.0, 0.0, 1.0], d, AHEAD, Some(3.0));
    check([1.0, 0.0, -5.0], d, AHEAD, None);
    check([4.0, 0.0, 5.0], d, AHEAD, None);
    check([3.0, 0.0, 5.0], d, AHEAD, Some(5.0));
    check([3.0_f64.next_up(), 0.0, 5.0], d, AHEAD, None);
    check([3.0_f64.next_down(), 0.0, 5.0], d, AHEAD, Some(5.0 - 4.214_684_851_089_403e-8));
}

#[test]
fn on_the_surface() {
    let (out, into) = ([0.0, 0.0, 1.0], [0.0, 0.0, -1.0]);
    check([1.0, 0.0, 2.0], out, AHEAD, None);
    check([1.0, 0.0, 2.0], into, AHEAD, Some(4.0));
    check([1.0, 0.0, 2.0], [1.0, 0.0, 0.0], AHEAD, None);
}

#[test]
fn the_range_picks_the_root() {
    let (p, d) = ([1.0, 0.0, 5.0], [0.0, 0.0, -1.0]);
    check(p, d, Interval::new(3.0, 10.0), Some(7.0));
    check(p, d, Interval::new(0.0, 3.0), None);
    check(p, d, Interval::new(-9.0, -1.0), None);
}

#[test]
fn far_away_it_keeps_the_digits_that_the_textbook_loses() {
    // From 1e8 radii the ray passes at half the radius: t = 1e8 - sqrt(3)/2.
    let sphere = Sphere::new(DVec3::ZERO, 1.0).unwrap();
    let ray = Ray::new(dvec3(0.5, 0.0, 1e8), dvec3(0.0, 0.0, -1.0));
    let exact = 1e8 - 0.75_f64.sqrt();
    let t = sphere.intersect(&ray, AHEAD).unwrap().t;
    assert!((t - exact).abs() <= 1.5e-8, "{t}");
    for textbook in [sphere_algebraic, sphere_geometric] {
        // The slide's discriminant is a difference of 1e16s: its digits are gone.
        let t = textbook(DVec3::ZERO, 1.0, &ray, AHEAD);
        assert!(t.is_none_or(|t| (t - exact).abs() > 0.1), "{t:?}");
    }
}

#[test]
fn the_surface_point_is_on_the_sphere_and_the_normal_points_out() {
    let sphere = Sphere::new(dvec3(1.0, 0.0, 0.0), 2.0).unwrap();
    for (origin, expected) in [(5.0, 1.0), (0.0, -1.0)] {
        let ray = Ray::new(dvec3(1.0, 0.0, origin), dvec3(0.0, 0.0, -3.0));
        let contact = sphere.intersect(&ray, AHEAD).unwrap();
        let surface = sphere.surface(&ray, &contact);
        assert_eq!(surface.point, dvec3(1.0, 0.0, 2.0 * expected));
        assert_eq!(*surface.geometric_normal, dvec3(0.0, 0.0, expected), "outward, not flipped");
    }
}

#[test]
fn bad_spheres_are_refused() {
    for radius in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(Sphere::new(DVec3::ZERO, radius).is_err(), "{radius}");
    }
    let both = Sphere::new(dvec3(0.0, f64::NAN, 0.0), -1.0).unwrap_err();
    assert_eq!(both.refusals().len(), 2);
}
