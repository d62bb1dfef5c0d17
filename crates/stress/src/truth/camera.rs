//! The exact camera: where a pixel's center lies, and how far from it a
//! computed eye ray passes.
//!
//! Written from the definitions in [`tracer::Camera`], with the tangent of
//! `look_at` from the exact degrees by its series.

use std::cmp::Ordering;

use tracer::glam::DVec3;
use tracer::{Projection, Ray, View};

use super::UNIT_ROUNDOFF;
use crate::number::{Number, V3};

/// The arguments of [`tracer::Camera::look_at`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LookAt {
    /// Where the camera is.
    pub eye: DVec3,
    /// Where it looks.
    pub at: DVec3,
    /// What is up in the picture.
    pub up: DVec3,
    /// The angle between the window's bottom and top edge, in degrees.
    pub fov_deg: f64,
    /// The picture's width over its height.
    pub aspect: f64,
}

/// Pixel `(i, j)` of a picture of `nx` by `ny`, row 0 at the bottom.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Pixel {
    /// Column.
    pub i: u32,
    /// Row.
    pub j: u32,
    /// Pixels in a row.
    pub nx: u32,
    /// Rows.
    pub ny: u32,
}

/// By how much a computed ray is off.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Miss {
    /// In pixels of the view window: the distance from the pixel's center to
    /// where the ray passes the window, and for a parallel ray also to where
    /// it passes the same window one window's width on.
    pub pixels: f64,
    /// The same in units of what one rounding of each vector of the view, of
    /// the window's sides and of the angle may do.
    pub condition_error: f64,
}

impl Miss {
    /// Of a ray that does not pass the window at all.
    const NEVER: Self = Self { pixels: f64::INFINITY, condition_error: f64::INFINITY };
}

/// A camera of exact numbers.
#[derive(Debug, Clone)]
pub struct ExactCamera<N> {
    e: DVec3,
    u: V3<N>,
    v: V3<N>,
    w: V3<N>,
    /// `view_dir` of length 1.
    forward: V3<N>,
    /// Of the window from the eye, along `forward`; `None` is parallel.
    distance: Option<N>,
    width: N,
    height: N,
    /// By how much more than its own rounding error a point of the window
    /// moves, as the up direction and the angle are off by theirs.
    window_condition: f64,
}

impl<N: Number> ExactCamera<N> {
    /// The camera of [`tracer::Camera::new`].
    pub fn of_view(view: &View, projection: Projection) -> Self {
        let view_dir = V3::of(view.view_dir);
        let normal = view.proj_normal.map_or_else(|| -view_dir.clone(), V3::of);
        let distance = match projection {
            Projection::Perspective { proj_distance } => Some(N::of(proj_distance)),
            Projection::Parallel => None,
        };
        let sides = (N::of(view.view_width), N::of(view.view_height));
        Self::of(view.view_point, (&view_dir, &normal, view.view_up), distance, sides, 1.0)
    }

    /// The camera of [`tracer::Camera::look_at`]; `pi` is [`pi`] in this number.
    pub fn of_look_at(view: &LookAt, pi: &N) -> Self {
        let view_dir = V3::difference(view.at, view.eye);
        let half = N::of(view.fov_deg) * pi.clone() / N::of(360.0);
        let angle = 2.0 * half.to_f64();
        let height = N::of(2.0) * tan(&half);
        let width = height.clone() * N::of(view.aspect);
        let back = -view_dir.clone();
        // d(tan x)/dx times x over tan x, with the angle 2 x.
        let angle_condition = angle / libm::sin(angle);
        let axes = (&view_dir, &back, view.up);
        Self::of(view.eye, axes, Some(N::one()), (width, height), angle_condition)
    }

    fn of(
        e: DVec3,
        (view_dir, normal, up): (&V3<N>, &V3<N>, DVec3),
        distance: Option<N>,
        (width, height): (N, N),
        side_condition: f64,
    ) -> Self {
        let w = unit(normal);
        let across = unit(&V3::of(up)).cross(&w);
        let u = unit(&across);
        let v = w.cross(&u);
        let window_condition = side_condition + 1.0 / across.length().to_f64();
        Self { e, v, u, w, forward: unit(view_dir), distance, width, height, window_condition }
    }

    /// How far the computed ray of a pixel is from the exact one.
    pub fn miss(&self, pixel: Pixel, ray: &Ray) -> Miss {
        let a = center(pixel.i, pixel.nx, &self.width);
        let b = center(pixel.j, pixel.ny, &self.height);
        let in_window = self.u.scale(&a) + self.v.scale(&b);
        // Where the exact ray leads, the points that it passes, and how far
        // the farthest of them is from what the view's vectors turn about.
        let (way, points, reach) = if let Some(d) = &self.distance {
            let way = self.forward.scale(d) + in_window.clone();
            (way.clone(), [Some(way), None], d.to_f64())
        } else {
            let next = in_window.clone() + self.forward.scale(&self.width);
            let reach = self.e.length() + self.width.to_f64();
            (self.forward.clone(), [Some(in_window.clone()), Some(next)], reach)
        };
        let (origin, direction) = (V3::difference(ray.origin, self.e), V3::of(ray.direction));
        let towards = direction.dot(&self.w);
        if !(direction.is_finite() && origin.is_finite() && towards < N::zero()) {
            return Miss::NEVER;
        }
        let moved = reach + in_window.length().to_f64() * self.window_condition;
        // Along a slanted ray, the window shows an error larger.
        let cosine = -(way.dot(&self.w) / way.length()).to_f64();
        let allowed = UNIT_ROUNDOFF * moved / cosine;
        let mut miss = Miss { pixels: 0.0, condition_error: 0.0 };
        for point in points.into_iter().flatten() {
            // To where the ray passes the point's plane across the window's normal.
            let t = (point.clone() - origin.clone()).dot(&self.w) / towards.clone();
            let off = origin.clone() + direction.scale(&t) - point;
            let (x, y) = (off.dot(&self.u).to_f64(), off.dot(&self.v).to_f64());
            let x_pixels = x * f64::from(pixel.nx) / self.width.to_f64();
            let y_pixels = y * f64::from(pixel.ny) / self.height.to_f64();
            miss.pixels = most(miss.pixels, libm::hypot(x_pixels, y_pixels));
            miss.condition_error = most(miss.condition_error, libm::hypot(x, y) / allowed);
        }
        miss
    }
}

/// The larger; infinite where one is no number.
fn most(a: f64, b: f64) -> f64 {
    if a <= b {
        b
    } else if b <= a {
        a
    } else {
        f64::INFINITY
    }
}

/// The lecture's `l + (r - l)(i + 0.5)/n` with `r = -l = extent/2`.
fn center<N: Number>(i: u32, n: u32, extent: &N) -> N {
    let half = N::of(0.5);
    let right = extent.clone() * half.clone();
    let share = (N::of(f64::from(i)) + half) / N::of(f64::from(n));
    extent.clone() * share - right
}

fn unit<N: Number>(v: &V3<N>) -> V3<N> {
    v.scale(&(N::one() / v.length()))
}

/// The tangent of an angle from 0 to below a quarter turn, in radians: sine
/// and cosine of its eighth by their series, then doubled three times.
pub fn tan<N: Number>(angle: &N) -> N {
    let eighth = angle.clone() * N::of(0.125);
    let minus_square = -eighth.square();
    // x^k/k!, the next term of either series being two powers on.
    let series = |first: N, k: f64| {
        let (mut sum, mut term, mut k) = (first.clone(), first, k);
        loop {
            term = term * minus_square.clone() / N::of((k + 1.0) * (k + 2.0));
            let next = sum.clone() + term.clone();
            // Also ends where something is no number.
            if next.partial_cmp(&sum).is_none_or(Ordering::is_eq) {
                return sum;
            }
            (sum, k) = (next, k + 2.0);
        }
    };
    let (mut sin, mut cos) = (series(eighth.clone(), 1.0), series(N::one(), 0.0));
    for _ in 0..3 {
        let twice = N::of(2.0) * sin.clone() * cos.clone();
        (sin, cos) = (twice, cos.square() - sin.square());
    }
    sin / cos
}

/// Pi, as `16 atan(1/5) - 4 atan(1/239)`.
///
/// Source: J. Machin, 1706.
pub fn pi<N: Number>() -> N {
    let atan_of_part = |n: f64| {
        let part = N::one() / N::of(n);
        let (minus_square, mut power, mut sum) = (-part.square(), part.clone(), part);
        let mut k = 1.0;
        loop {
            power = power * minus_square.clone();
            k += 2.0;
            let next = sum.clone() + power.clone() / N::of(k);
            if next.partial_cmp(&sum).is_none_or(Ordering::is_eq) {
                return sum;
            }
            sum = next;
        }
    };
    N::of(16.0) * atan_of_part(5.0) - N::of(4.0) * atan_of_part(239.0)
}

#[cfg(test)]
mod tests;
