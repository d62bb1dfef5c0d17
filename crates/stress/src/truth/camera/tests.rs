//! The exact camera against values worked out by hand, and in one precision
//! against the other.

use tracer::glam::dvec3;
use tracer::{Camera, pixel_center};

use super::*;
use crate::number::{Big, Dd};

/// Of the largest error of the oracle's volume number in these formulas.
const DIGITS: f64 = 1e-30;

#[track_caller]
fn close(x: Dd, y: Dd) {
    let error = ((x - y) / y).to_f64().abs();
    assert!(error <= DIGITS, "{x:?} {y:?}: {error:e}");
}

/// As [`close`], for numbers about 1.
#[track_caller]
fn near(x: f64, y: f64) {
    assert!((x - y).abs() <= DIGITS, "{x:e} {y}");
}

fn half(fov_deg: f64) -> Dd {
    Dd::of(fov_deg) * pi() / Dd::of(360.0)
}

#[test]
fn pi_and_tangents_that_are_known() {
    // The parts of pi in two `f64`s.
    close(pi(), Dd::sum(std::f64::consts::PI, 1.224_646_799_147_353_2e-16));
    let root3 = Dd::of(3.0).sqrt();
    close(tan(&half(90.0)), Dd::one());
    close(tan(&half(120.0)), root3);
    close(tan(&half(60.0)), Dd::one() / root3);
    close(tan(&half(135.0)), Dd::one() + Dd::of(2.0).sqrt());
}

#[test]
fn both_precisions_agree_on_tangents() {
    let pi_big = pi::<Big>();
    for k in 1..=1700 {
        let fov_deg = f64::from(k) * 0.1;
        let big = tan(&(Big::of(fov_deg) * pi_big.clone() / Big::of(360.0)));
        let error = (Big::from(tan(&half(fov_deg))) - big.clone()).abs() / big;
        assert!(error.to_f64() <= DIGITS, "{fov_deg}: {:e}", error.to_f64());
        let libm = libm::tan(fov_deg.to_radians() * 0.5);
        assert!((tan(&half(fov_deg)).to_f64() / libm - 1.0).abs() < 1e-14);
    }
}

const VIEW: View = View {
    view_point: dvec3(1.0, 2.0, 3.0),
    view_dir: dvec3(0.0, -3.0, -4.0),
    view_up: dvec3(0.0, 7.0, 0.0),
    proj_normal: Some(dvec3(0.0, 0.0, 2.0)),
    view_width: 4.0,
    view_height: 2.0,
};

#[test]
fn distances_are_those_on_the_window() {
    let pixel = Pixel { i: 5, j: 1, nx: 8, ny: 4 };
    // The window is (0, -6, -8) from the eye; pixel (5, 1) is at (0.75, -0.25)
    // in it, and its pixels are squares of one half.
    let perspective = Projection::Perspective { proj_distance: 10.0 };
    let exact = ExactCamera::<Dd>::of_view(&VIEW, perspective);
    let at = |origin: DVec3, direction: DVec3| exact.miss(pixel, &Ray::new(origin, direction));
    let way = dvec3(0.75, -6.25, -8.0);
    let eye = VIEW.view_point;
    near(at(eye, way).pixels, 0.0);
    near(at(eye, 0.5 * way).pixels, 0.0);
    near(at(eye, way + dvec3(0.5, 0.0, 0.0)).pixels, 1.0);
    near(at(eye + dvec3(0.0, 0.25, 0.0), way).pixels, 0.5);
    assert_eq!(at(eye, -way), Miss::NEVER);
    assert_eq!(at(eye, dvec3(f64::NAN, 0.0, -1.0)), Miss::NEVER);

    let exact = ExactCamera::<Dd>::of_view(&VIEW, Projection::Parallel);
    let at =
        |origin: DVec3, direction: DVec3| exact.miss(pixel, &Ray::new(eye + origin, direction));
    let start = dvec3(0.75, -0.25, 0.0);
    near(at(start, dvec3(0.0, -3.0, -4.0)).pixels, 0.0);
    near(at(start + dvec3(0.0, 3.0, 4.0), dvec3(0.0, -3.0, -4.0)).pixels, 0.0);
    near(at(start + dvec3(0.5, 0.0, 0.0), dvec3(0.0, -3.0, -4.0)).pixels, 1.0);
    // A direction that is off shows one window's width of 4 on, 3.2 deep.
    let turned = at(start, dvec3(0.5, -3.0, -4.0)).pixels;
    assert!((turned - 0.8).abs() < 1e-12, "{turned}");
}

#[test]
fn both_precisions_agree_on_distances() {
    let look_at = LookAt {
        eye: dvec3(1e8, 2.0, 3e4),
        at: DVec3::ZERO,
        up: DVec3::Y,
        fov_deg: 37.0,
        aspect: 1.5,
    };
    let LookAt { eye, at, up, fov_deg, aspect } = look_at;
    let camera = Camera::look_at(eye, at, up, fov_deg, aspect).unwrap();
    let dd = ExactCamera::<Dd>::of_look_at(&look_at, &pi());
    let big = ExactCamera::<Big>::of_look_at(&look_at, &pi());
    for i in (0..65_536).step_by(4096) {
        let pixel = Pixel { i, j: i / 2, nx: 65_536, ny: 43_691 };
        let a = pixel_center(pixel.i, pixel.nx, camera.view_width());
        let b = pixel_center(pixel.j, pixel.ny, camera.view_height());
        let ray = camera.ray(a, b);
        let (dd, big) = (dd.miss(pixel, &ray), big.miss(pixel, &ray));
        assert!((dd.pixels - big.pixels).abs() <= 1e-20, "{} {}", dd.pixels, big.pixels);
        assert!((dd.condition_error - big.condition_error).abs() <= 1e-10);
    }
}
