//! The torus against answers known on paper: R = 4, r = 1 around an axis.

use glam::dvec3;

use super::*;
use crate::shape::Geometry;

const AHEAD: Interval = Interval::AHEAD;

/// Around the z axis through (1, 0, 0).
fn ring() -> Torus {
    Torus::new(dvec3(1.0, 0.0, 0.0), dvec3(0.0, 0.0, 0.5), 4.0, 1.0).unwrap()
}

fn ray(p: [f64; 3], d: [f64; 3]) -> Ray {
    Ray::new(DVec3::from_array(p), DVec3::from_array(d))
}

/// All contacts, each asked for after the one before.
fn all(torus: &Torus, ray: &Ray) -> Vec<f64> {
    let mut found = Vec::new();
    let mut range = AHEAD;
    while let Some(contact) = torus.intersect(ray, range) {
        found.push(contact.t);
        range.lo = contact.t;
    }
    found
}

#[track_caller]
fn check(p: [f64; 3], d: [f64; 3], expected: &[f64]) {
    assert_eq!(all(&ring(), &ray(p, d)), expected);
}

#[test]
fn ugly_rays_miss() {
    let nan = f64::NAN;
    check([nan, 0.0, 5.0], [0.0, 0.0, -1.0], &[]);
    check([5.0, 0.0, 5.0], [0.0, nan, -1.0], &[]);
    check([5.0, 0.0, f64::INFINITY], [0.0, 0.0, -1.0], &[]);
    check([5.0, 0.0, 5.0], [0.0, 0.0, f64::NEG_INFINITY], &[]);
    check([5.0, 0.0, 5.0], [0.0, 0.0, 0.0], &[]);
    check([5.0, 0.0, 5.0], [0.0, 0.0, -5e-324], &[]);
    let through = ray([5.0, 0.0, 5.0], [0.0, 0.0, -1.0]);
    for range in [Interval::new(nan, 9.0), Interval::new(0.0, nan), Interval::new(9.0, 1.0)] {
        assert_eq!(ring().intersect(&through, range), None);
        assert_eq!(
            ring().intersect_leaving(&through, range, Departure { part: 0, outward: true }),
            None
        );
    }
}

#[test]
fn along_the_axis() {
    let d = [0.0, 0.0, -1.0];
    check([5.0, 0.0, 5.0], d, &[4.0, 6.0]);
    check([5.0, 0.0, 5.0], [0.0, 0.0, -0.5], &[8.0, 12.0]);
    check([5.0, 0.0, 0.0], d, &[1.0]);
    check([5.0, 0.0, -5.0], d, &[]);
    // Through the hole, past the rim, and touching both rims.
    check([1.0, 0.0, 5.0], d, &[]);
    check([6.5, 0.0, 5.0], d, &[]);
    check([4.0, 0.0, 5.0], d, &[5.0]);
    check([6.0, 0.0, 5.0], d, &[5.0]);
    check([4.0_f64.next_down(), 0.0, 5.0], d, &[]);
    check([6.0_f64.next_up(), 0.0, 5.0], d, &[]);
}

#[test]
fn in_the_plane_of_the_ring_there_are_four() {
    check([-9.0, 0.0, 0.0], [1.0, 0.0, 0.0], &[5.0, 7.0, 13.0, 15.0]);
    check([-9.0, 0.0, 0.0], [2.0, 0.0, 0.0], &[2.5, 3.5, 6.5, 7.5]);
    check([1.0, 0.0, 0.0], [1.0, 0.0, 0.0], &[3.0, 5.0]);
    check([-3.0, 0.0, 0.0], [1.0, 0.0, 0.0], &[1.0, 7.0, 9.0]);
    // Across at 4 of 5: out at sqrt(25 - 16) = 3, and only there.
    check([-9.0, 4.0, 0.0], [1.0, 0.0, 0.0], &[7.0, 13.0]);
    // Touching the inner rim from within the tube is no way out of it.
    check([-9.0, 3.0, 0.0], [1.0, 0.0, 0.0], &[6.0, 14.0]);
    check([-9.0, 5.0, 0.0], [1.0, 0.0, 0.0], &[10.0]);
    check([-9.0, 5.0_f64.next_up(), 0.0], [1.0, 0.0, 0.0], &[]);
    // Along the circle on top, and below and above it.
    check([-9.0, 0.0, 1.0], [1.0, 0.0, 0.0], &[6.0, 14.0]);
    check([-9.0, 0.0, 1.0_f64.next_up()], [1.0, 0.0, 0.0], &[]);
}

#[test]
fn the_range_is_open() {
    let torus = ring();
    let four = ray([-9.0, 0.0, 0.0], [1.0, 0.0, 0.0]);
    let t = |lo, hi| torus.intersect(&four, Interval::new(lo, hi)).map(|c| c.t);
    assert_eq!(t(5.0, 7.0), None);
    assert_eq!(t(5.0, 7.0_f64.next_up()), Some(7.0));
    assert_eq!(t(5.0_f64.next_down(), 7.0), Some(5.0));
    assert_eq!(t(7.5, f64::INFINITY), Some(13.0));
    assert_eq!(t(-9.0, 0.0), None);
}

#[test]
fn from_far_away_and_in_any_size_nothing_is_lost() {
    for size in [4e-60, 1e-30, 0.3, 1.0, 1e30, 1e59] {
        let torus = Torus::new(DVec3::ZERO, DVec3::Y, size, 0.25 * size).unwrap();
        for distance in [10.0, 1e5, 1e8] {
            for length in [1e-30, 1.0, 1e30] {
                let origin = dvec3(0.25, 0.0, distance) * size;
                let found = all(&torus, &Ray::new(origin, DVec3::NEG_Z * length));
                let outer = (1.25_f64 * 1.25 - 0.25 * 0.25).sqrt();
                let inner = (0.75_f64 * 0.75 - 0.25 * 0.25).sqrt();
                let expected = [-outer, -inner, inner, outer].map(|z| distance + z);
                assert_eq!(found.len(), 4, "{size} {distance}");
                for (t, e) in found.iter().zip(expected) {
                    let off = (t * (length / size) - e).abs();
                    assert!(off <= 4.0 * f64::EPSILON * e, "{size} {distance} {length}: {off}");
                }
            }
        }
    }
}

#[test]
fn a_horn_torus_is_met_in_its_very_middle() {
    let horn = Torus::new(DVec3::ZERO, DVec3::Z, 2.0, 2.0).unwrap();
    // The circles touch in the origin: in and out of both, twice at once there.
    let found = all(&horn, &ray([-9.0, 0.0, 0.0], [1.0, 0.0, 0.0]));
    assert_eq!((found.first(), found.last()), (Some(&5.0), Some(&13.0)));
    let down = ray([0.0, 0.0, 9.0], [0.0, 0.0, -1.0]);
    let contact = horn.intersect(&down, AHEAD).unwrap();
    assert_eq!(contact.t, 9.0);
    assert_eq!(horn.surface(&down, &contact).point, DVec3::ZERO);
}

#[test]
fn a_ray_that_leaves_does_not_meet_its_start() {
    // The start is off the surface to either side by as much as it may be.
    let torus = ring();
    for off in [-1.0, 0.0, 1.0].map(|k| k * 0.5 * torus.error()) {
        let t = |p, d, outward| {
            let from = Departure { part: 0, outward };
            let contact = torus.intersect_leaving(&ray(p, d), AHEAD, from);
            contact.map(|c| (c.t * 1e9).round() / 1e9)
        };
        // From the outer rim: away, along, and back through the tube.
        let outer = [6.0 + off, 0.0, 0.0];
        assert_eq!(t(outer, [1.0, 0.0, 0.0], true), None);
        assert_eq!(t(outer, [0.0, 1.0, 0.0], true), None);
        assert_eq!(t(outer, [-1.0, 0.0, 0.0], false), Some(2.0));
        // From the inner rim: across the hole, down it, and into the tube.
        let inner = [4.0 + off, 0.0, 0.0];
        assert_eq!(t(inner, [-1.0, 0.0, 0.0], true), Some(6.0));
        assert_eq!(t(inner, [0.0, 0.0, 1.0], true), None);
        assert_eq!(t(inner, [1.0, 0.0, 0.0], false), Some(2.0));
    }
}

#[test]
fn the_surface_point_is_on_the_torus_and_the_normal_points_out() {
    let torus = ring();
    let four = ray([-9.0, 0.0, 0.0], [3.0, 0.0, 0.0]);
    for (x, out) in [(-4.0, -1.0), (-2.0, 1.0), (4.0, -1.0), (6.0, 1.0)] {
        let surface = torus.surface(&four, &Contact::at((x + 9.0) / 3.0));
        assert_eq!(surface.point, dvec3(x, 0.0, 0.0));
        assert_eq!(*surface.geometric_normal, dvec3(out, 0.0, 0.0));
        assert!(surface.error > 0.0 && surface.error < 1e-14);
    }
}

#[test]
fn bounds_are_tight() {
    let Aabb { min, max } = ring().bounds();
    assert_eq!((min, max), (dvec3(-4.0, -5.0, -1.0), dvec3(6.0, 5.0, 1.0)));
    // The ring leans by 3:4:5.
    let leaning = Torus::new(DVec3::ZERO, dvec3(0.0, 6.0, 8.0), 5.0, 0.5).unwrap();
    let reach = dvec3(5.5, 4.5, 3.5);
    assert!((leaning.bounds().max - reach).abs().max_element() < 2e-15);
    assert!((leaning.bounds().min + reach).abs().max_element() < 2e-15);
}

#[test]
fn bad_tori_are_refused() {
    let new = |axis, major, minor| Torus::new(DVec3::ZERO, axis, major, minor);
    for radius in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e-61, 1e61] {
        assert!(new(DVec3::Y, radius, 1.0).is_err(), "{radius}");
        assert!(new(DVec3::Y, 1.0, radius).is_err(), "{radius}");
    }
    assert!(new(DVec3::Y, 1.0, 1.0).is_ok());
    assert_eq!(new(DVec3::ZERO, f64::NAN, -1.0).unwrap_err().refusals().len(), 3);
    assert_eq!(
        new(DVec3::Y, 1.0, 1.5).unwrap_err().to_string(),
        "`minor_radius`: expected at most the `major_radius`, 1, as the tube would cut itself, \
         found 1.5"
    );
}
