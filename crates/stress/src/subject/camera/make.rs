//! Random cameras with a pixel of theirs, of the kinds that the families ask
//! about.

use tracer::glam::DVec3;
use tracer::{Projection, View};

use super::{look_at_case, view_case};
use crate::truth::camera::{LookAt, Pixel};
use crate::{Case, Random};

/// The most pixels a side.
const MOST_PIXELS: u32 = 65_536;

/// The farthest view point from the world's origin.
const FARTHEST: f64 = 1e8;

/// Between the far edges of the window, along its longer side, in degrees. At
/// 1 degree across 65,536 pixels the last bit of a direction alone is worth
/// 4e-10 pixels, and three of them more than is aimed at.
const FOV_DEG: (f64, f64) = (2.0, 170.0);

/// The narrowest of an oblique view: its window shows the last bit of a ray's
/// direction up to four times larger, see [`leaning`].
const OBLIQUE_FROM_DEG: f64 = 4.0;

/// Without the distance of [`Projection`].
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Rays {
    Perspective,
    Parallel,
}

/// What kind of view.
pub(super) struct Kind {
    /// How its rays leave the window.
    pub(super) rays: Rays,
    /// Whether the window is turned against the view.
    pub(super) oblique: bool,
    /// Whether the view point may be farther than its window is large.
    pub(super) far: bool,
    /// Whether up is nearly along the window's normal.
    pub(super) up_along: bool,
}

/// Either kind of rays, straight or oblique, from up to the farthest view point.
pub(super) fn any_kind(random: &mut Random) -> Kind {
    let rays = random.one_of(&[Rays::Perspective, Rays::Parallel]);
    Kind { rays, oblique: random.coin(), ..PERSPECTIVE }
}

/// Straight, from up to the farthest view point.
pub(super) const PERSPECTIVE: Kind =
    Kind { rays: Rays::Perspective, oblique: false, far: true, up_along: false };

/// Straight, the view point about as far as the window is large.
pub(super) const PARALLEL: Kind = Kind { rays: Rays::Parallel, far: false, ..PERSPECTIVE };

/// A view of [`tracer::Camera::new`] and a pixel of it.
pub(super) fn view(random: &mut Random, kind: &Kind) -> Case {
    let (pixel, aspect) = pixel(random);
    let forward = random.direction();
    let normal = if kind.oblique { leaning(random, -forward) } else { -forward };
    let up = if kind.up_along {
        normal * random.sign() + random.across(normal) * random.decades(1e-9, 1e-2)
    } else {
        let side = random.across(normal);
        leaning(random, side)
    };
    let distance = random.decades(1e-3, 1e6);
    let fov_deg = fov_deg(random, if kind.oblique { OBLIQUE_FROM_DEG } else { FOV_DEG.0 });
    let longer = distance * 2.0 * libm::tan(fov_deg.to_radians() * 0.5);
    let (view_width, view_height) =
        if aspect > 1.0 { (longer, longer / aspect) } else { (longer * aspect, longer) };
    let away = if kind.far { random.decades(1e-3, FARTHEST) } else { longer * random.unit() };
    let view = View {
        view_point: random.direction() * away,
        view_dir: forward * random.decades(1e-3, 1e3),
        view_up: up * random.decades(1e-3, 1e3),
        proj_normal: kind.oblique.then(|| normal * random.decades(1e-3, 1e3)),
        view_width,
        view_height,
    };
    let projection = match kind.rays {
        Rays::Perspective => Projection::Perspective { proj_distance: distance },
        Rays::Parallel => Projection::Parallel,
    };
    view_case(pixel, &view, projection)
}

/// The arguments of [`tracer::Camera::look_at`] and a pixel.
pub(super) fn look_at(random: &mut Random) -> Case {
    let (pixel, aspect) = pixel(random);
    let eye = random.direction() * random.decades(1e-3, FARTHEST);
    let forward = random.direction();
    // What is looked at need not be far, but its distance is not rounded away.
    let at = eye + forward * random.decades(1e-3 * eye.length(), FARTHEST);
    let side = random.across(forward);
    let up = leaning(random, side) * random.decades(1e-3, 1e3);
    let longer = fov_deg(random, FOV_DEG.0);
    let fov_deg = if aspect > 1.0 {
        2.0 * libm::atan(libm::tan(longer.to_radians() * 0.5) / aspect).to_degrees()
    } else {
        longer
    };
    look_at_case(pixel, &LookAt { eye, at, up, fov_deg, aspect })
}

/// A unit vector less than about 75 degrees from this one.
fn leaning(random: &mut Random, from: DVec3) -> DVec3 {
    /// The tangent of that angle.
    const FARTHEST: f64 = 4.0;
    (from + random.across(from) * random.between(0.0, FARTHEST)).normalize()
}

/// Whole, round and any angles.
fn fov_deg(random: &mut Random, lo: f64) -> f64 {
    let hi = FOV_DEG.1;
    match random.below(3) {
        0 => random.one_of(&[lo, 30.0, 40.0, 45.0, 60.0, 90.0, 120.0, 135.0, 170.0]),
        1 => random.decades(lo, hi),
        _ => random.between(lo, hi),
    }
}

/// A pixel, corners and the middle among them, and the width over the height
/// that makes the picture's pixels square.
fn pixel(random: &mut Random) -> (Pixel, f64) {
    let side = |random: &mut Random| match random.below(4) {
        0 => MOST_PIXELS,
        1 => random.one_of(&[1, 2, 3, 101, 640, 1080, 16_384, 65_535]),
        _ => random.decades(1.0, f64::from(MOST_PIXELS)) as u32,
    };
    let place = |random: &mut Random, n: u32| match random.below(4) {
        0 => random.one_of(&[0, n - 1]),
        1 => random.one_of(&[n / 2, (n - 1) / 2]),
        _ => random.below(n as usize) as u32,
    };
    let (nx, ny) = (side(random), side(random));
    let (i, j) = (place(random, nx), place(random, ny));
    (Pixel { i, j, nx, ny }, f64::from(nx) / f64::from(ny))
}
