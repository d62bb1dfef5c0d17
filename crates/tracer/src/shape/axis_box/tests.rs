//! The box for every sign and zero of the direction, from outside and inside.

use glam::dvec3;

use super::*;
use crate::shape::Geometry;

const MIN: DVec3 = dvec3(-1.0, -2.0, -3.0);
const MAX: DVec3 = dvec3(1.0, 2.0, 3.0);

#[track_caller]
fn hit(p: DVec3, d: DVec3) -> Option<(f64, [f64; 3])> {
    let shape = AxisBox::new(MIN, MAX).unwrap();
    let ray = Ray::new(p, d);
    let contact = shape.intersect(&ray, Interval::AHEAD)?;
    Some((contact.t, shape.surface(&ray, &contact).geometric_normal.to_array()))
}

#[test]
fn every_sign_and_zero_of_d_from_outside_and_inside() {
    // All 26 directions with components in {-1, 0, 1}, aimed at the center.
    for i in 0..27 {
        let sign = |k: i32| f64::from(i / 3_i32.pow(k as u32) % 3 - 1);
        let d = dvec3(sign(0), sign(1), sign(2));
        if d == DVec3::ZERO {
            continue;
        }
        // Leaves first through the nearest side, which has the smallest extent.
        let axis = (0..3).find(|&k| d[k] != 0.0).unwrap();
        let mut out = [0.0; 3];
        out[axis] = d[axis];
        let into = out.map(|n| -n);
        let half = MAX[axis];
        for zero in [0.0, -0.0] {
            let d = DVec3::select(d.cmpeq(DVec3::ZERO), DVec3::splat(zero), d);
            assert_eq!(hit(DVec3::ZERO, d), Some((half, out)), "from inside, {d}");
            assert_eq!(hit(-10.0 * d, d), Some((10.0 - half, into)), "from outside, {d}");
            assert_eq!(hit(-10.0 * d, 4.0 * d), Some(((10.0 - half) / 4.0, into)), "longer {d}");
            assert_eq!(hit(10.0 * d, d), None, "behind, {d}");
        }
    }
}

#[test]
fn beside_the_box() {
    assert_eq!(hit(dvec3(1.5, 0.0, 9.0), dvec3(0.0, 0.0, -1.0)), None);
    assert_eq!(hit(dvec3(-1.5, 0.0, 9.0), dvec3(0.0, 0.0, -1.0)), None);
    assert_eq!(hit(dvec3(9.0, 9.0, 0.0), dvec3(-1.0, 1.0, 0.0)), None);
    assert_eq!(hit(dvec3(3.1, 0.0, 0.0), dvec3(-1.0, 1.0, 0.0)), None);
}

#[test]
fn along_faces_edges_and_through_corners() {
    let down = dvec3(0.0, 0.0, -1.0);
    let top = [0.0, 0.0, 1.0];
    assert_eq!(hit(dvec3(1.0, 0.0, 9.0), down), Some((6.0, top)), "in a face's plane");
    assert_eq!(hit(dvec3(1.0, 2.0, 9.0), down), Some((6.0, top)), "along an edge");
    assert_eq!(hit(dvec3(1.0_f64.next_up(), 2.0, 9.0), down), None);
    assert_eq!(hit(2.0 * MAX, -MAX).map(|(t, _)| t), Some(1.0), "through a corner");
}

#[test]
fn edges_are_hit_however_the_quotients_round() {
    let shape = AxisBox::new(MIN, MAX).unwrap();
    let mut rng = fastrand::Rng::with_seed(3);
    let mut any = || dvec3(rng.f64(), rng.f64(), rng.f64()) * 2.0 - 1.0;
    let mut seen = 0;
    for _ in 0..100_000 {
        // Aim at a point of the edge x = 1, y = 2 that the ray meets from
        // outside: past it in one axis means out of it in the other.
        let target = dvec3(1.0, 2.0, 3.0 * any().z);
        let direction = dvec3(-any().x.abs() - 0.1, any().y.abs() + 0.1, any().z);
        let origin = target - direction;
        // Only where the target is exactly on the ray is a miss an error.
        if origin + direction == target && (target - origin) == direction {
            seen += 1;
            let ray = Ray::new(origin, direction);
            assert!(shape.intersect(&ray, Interval::AHEAD).is_some(), "{ray:?}");
        }
    }
    assert!(seen > 1_000, "{seen}");
}

#[test]
fn a_flat_box_is_hit() {
    let flat = AxisBox::new(dvec3(-1.0, 0.0, -1.0), dvec3(1.0, 0.0, 1.0)).unwrap();
    let ray = Ray::new(dvec3(0.3, 3.0, 0.2), dvec3(0.0, -2.0, 0.0));
    let contact = flat.intersect(&ray, Interval::AHEAD).unwrap();
    assert_eq!(contact.t, 1.5);
    assert_eq!(flat.surface(&ray, &contact).geometric_normal, UnitVec::Y);
}

#[test]
fn ugly_rays_miss() {
    let nan = f64::NAN;
    assert_eq!(hit(dvec3(nan, 0.0, 9.0), dvec3(0.0, 0.0, -1.0)), None);
    assert_eq!(hit(dvec3(0.0, 0.0, 9.0), dvec3(nan, 0.0, -1.0)), None);
    assert_eq!(hit(dvec3(0.0, 0.0, f64::INFINITY), dvec3(0.0, 0.0, -1.0)), None);
    assert_eq!(hit(dvec3(0.0, 0.0, 0.0), DVec3::ZERO), None);
}

#[test]
fn bad_boxes_are_refused() {
    let refused = AxisBox::new(MAX, MIN).unwrap_err();
    assert_eq!(refused.refusals()[0].field, "max");
    assert!(AxisBox::new(MIN, dvec3(1.0, f64::NAN, 1.0)).is_err());
}
