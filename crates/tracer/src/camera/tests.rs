//! Eye rays against values worked out by hand, and the exact mirror symmetry.

use glam::{DVec3, dvec3};

use super::*;

const STRAIGHT: View = View {
    view_point: dvec3(1.0, 2.0, 3.0),
    view_dir: dvec3(0.0, 0.0, -5.0),
    view_up: dvec3(0.0, 7.0, 0.0),
    proj_normal: None,
    view_width: 4.0,
    view_height: 2.0,
};

#[track_caller]
fn check(view: &View, projection: Projection, (a, b): (f64, f64), p: DVec3, d: DVec3) {
    let ray = Camera::new(view, projection).unwrap().ray(a, b);
    assert!((ray.origin - p).length() < 1e-15, "{} is not {p}", ray.origin);
    assert!((ray.direction - d).length() < 1e-15, "{} is not {d}", ray.direction);
}

#[test]
fn perspective_rays_leave_the_eye_through_the_window() {
    let perspective = Projection::Perspective { proj_distance: 2.0 };
    let eye = STRAIGHT.view_point;
    check(&STRAIGHT, perspective, (0.0, 0.0), eye, dvec3(0.0, 0.0, -2.0));
    check(&STRAIGHT, perspective, (-2.0, 1.0), eye, dvec3(-2.0, 1.0, -2.0));
}

#[test]
fn parallel_rays_leave_the_window_along_the_view() {
    let eye = STRAIGHT.view_point;
    let along = dvec3(0.0, 0.0, -1.0);
    check(&STRAIGHT, Projection::Parallel, (0.0, 0.0), eye, along);
    check(&STRAIGHT, Projection::Parallel, (-2.0, 1.0), eye + dvec3(-2.0, 1.0, 0.0), along);
}

#[test]
fn an_oblique_window_keeps_its_normal_and_its_distance_along_the_view() {
    // Looks down at 3-4-5 while the window stays upright.
    let view = View {
        view_dir: dvec3(0.0, -3.0, -4.0),
        proj_normal: Some(dvec3(0.0, 0.0, 2.0)),
        ..STRAIGHT
    };
    let perspective = Projection::Perspective { proj_distance: 10.0 };
    // 10 along the view, then (a, b) in the upright window: not 10 along w.
    check(&view, perspective, (0.0, 0.0), view.view_point, dvec3(0.0, -6.0, -8.0));
    check(&view, perspective, (1.0, 2.0), view.view_point, dvec3(1.0, -4.0, -8.0));
    let corner = view.view_point + dvec3(1.0, 2.0, 0.0);
    check(&view, Projection::Parallel, (1.0, 2.0), corner, dvec3(0.0, -0.6, -0.8));
}

#[test]
fn axes_follow_the_lecture_for_a_tilted_view() {
    // w = (1, 0, 0): u = up x w = (0, 0, -1), v = w x u = (0, 1, 0).
    let view = View { view_dir: dvec3(-1.0, 0.0, 0.0), ..STRAIGHT };
    let perspective = Projection::Perspective { proj_distance: 1.0 };
    check(&view, perspective, (0.25, 0.5), view.view_point, dvec3(-1.0, 0.5, -0.25));
}

#[test]
fn look_at_spans_the_angle_between_bottom_and_top() {
    let camera = Camera::look_at(dvec3(0.0, 0.0, 5.0), DVec3::ZERO, DVec3::Y, 90.0, 2.0).unwrap();
    assert!((camera.view_height() - 2.0).abs() < 1e-15);
    assert!((camera.view_width() - 4.0).abs() < 1e-15);
    assert_eq!(camera.ray(0.0, 0.0).direction, dvec3(0.0, 0.0, -1.0));
}

#[test]
fn mirrored_pixels_have_mirrored_rays_to_the_bit() {
    for projection in [Projection::Perspective { proj_distance: 0.7 }, Projection::Parallel] {
        let view = View { view_point: dvec3(0.0, 0.3, 3.0), view_width: 1.1, ..STRAIGHT };
        let camera = Camera::new(&view, projection).unwrap();
        let mirror = |p: DVec3| dvec3(-p.x, p.y, p.z);
        for nx in [1, 2, 3, 101, 640, 16_384, 65_535] {
            for i in [0, nx / 3, nx / 2, nx - 1] {
                let left = camera.ray(pixel_center(i, nx, view.view_width), 0.123);
                let right = camera.ray(pixel_center(nx - 1 - i, nx, view.view_width), 0.123);
                assert_eq!(left.origin, mirror(right.origin), "origin {i} of {nx}");
                assert_eq!(left.direction, mirror(right.direction), "direction {i} of {nx}");
            }
        }
    }
}

#[test]
fn pixel_centers_are_the_slides_formula() {
    for (nx, extent) in [(3, 2.0), (640, 4.5), (1, 1.0)] {
        let (l, r) = (-0.5 * extent, 0.5 * extent);
        for i in 0..nx {
            let slide = l + (r - l) * (f64::from(i) + 0.5) / f64::from(nx);
            assert!((pixel_center(i, nx, extent) - slide).abs() <= 4.0 * f64::EPSILON * extent);
        }
    }
}

#[test]
fn bad_views_are_refused_with_every_reason() {
    let fields = |view: View, projection| {
        let refused = Camera::new(&view, projection).unwrap_err();
        refused.refusals().iter().map(|r| r.field).collect::<Vec<_>>()
    };
    let bad = View { view_dir: DVec3::ZERO, view_width: -1.0, ..STRAIGHT };
    let perspective = Projection::Perspective { proj_distance: f64::NAN };
    assert_eq!(fields(bad, perspective), ["view_dir", "view_width", "proj_distance"]);
    let flat = View { view_up: dvec3(0.0, 0.0, 3.0), ..STRAIGHT };
    assert_eq!(fields(flat, Projection::Parallel), ["view_up"]);
    let away = View { proj_normal: Some(dvec3(0.0, 0.0, -1.0)), ..STRAIGHT };
    assert_eq!(fields(away, Projection::Parallel), ["proj_normal"]);
    assert!(Camera::look_at(DVec3::ZERO, DVec3::ZERO, DVec3::Y, 40.0, 1.0).is_err());
    for d in [dvec3(-4.0, 1.0, -5.0), dvec3(1.0, 3.0, 7.0), dvec3(0.1, 0.2, 0.3)] {
        let flat = View { view_dir: d, view_up: 2.0 * d, ..STRAIGHT };
        assert_eq!(fields(flat, Projection::Parallel), ["view_up"], "{d}");
        assert!(Camera::look_at(DVec3::ZERO, d, -3.0 * d, 40.0, 1.0).is_err(), "{d}");
    }
    let close = Camera::look_at(DVec3::ZERO, dvec3(1e-70, 0.0, 0.0), DVec3::Y, 40.0, 1.0);
    assert_eq!(close.unwrap_err().refusals()[0].field, "at");
    let narrow = Camera::look_at(DVec3::ZERO, DVec3::X, DVec3::Y, 1e-70, f64::NAN).unwrap_err();
    assert_eq!(
        narrow.refusals().iter().map(|r| r.field).collect::<Vec<_>>(),
        ["fov_deg", "aspect"]
    );
    assert!(Camera::look_at(DVec3::ZERO, DVec3::Y, DVec3::Y, 40.0, 1.0).is_err());
    assert!(Camera::look_at(DVec3::ZERO, DVec3::X, DVec3::Y, 180.0, 1.0).is_err());
}
