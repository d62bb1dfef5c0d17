//! Where on the view window something may be seen: the camera backwards.

use glam::DVec3;

use super::{Camera, Projection};
use crate::Aabb;
use crate::math::max_abs;

/// A part of the view window, in the coordinates of [`Camera::ray`], outside of
/// which no ray meets a thing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Seen {
    /// No ray meets it.
    Nowhere,
    /// Any ray may meet it.
    Everywhere,
    /// Rays meet it between these only.
    Between {
        /// The lowest and highest `a`.
        a: [f64; 2],
        /// The lowest and highest `b`.
        b: [f64; 2],
    },
    /// Rays meet it only where `c + a x + b y` is above 0, for these `c, x, y`.
    HalfPlane([f64; 3]),
}

/// All that is computed here is right to this part of the sizes that go into
/// it: the few roundings of each formula, 1e-15, times the 1e3 and 1e6 that
/// [`Camera::is_plain`] lets an oblique or wide view stretch them by. What is
/// seen is widened by as much.
const MARGIN: f64 = 1e-6;

impl Camera {
    /// Where the box is seen: an outer bound.
    pub(crate) fn sees_box(&self, bounds: &Aabb) -> Seen {
        if *bounds == Aabb::EMPTY {
            return Seen::Nowhere;
        }
        if !(bounds.is_finite() && self.is_plain()) {
            return Seen::Everywhere;
        }
        let size = max_abs(self.e) + bounds.max_abs() + self.view_width + self.view_height;
        let mut seen: Option<[[f64; 2]; 2]> = None;
        let mut behind = 0;
        let margin = MARGIN * size;
        for corner in bounds.widened(margin).corners() {
            // By half of what it was widened, so that what is ahead by nothing
            // to speak of stays ahead.
            let Some([a, b]) = self.window_point(corner, 0.5 * margin) else {
                behind += 1;
                continue;
            };
            let [a_seen, b_seen] = seen.unwrap_or([[a, a], [b, b]]);
            let grown = |[lo, hi]: [f64; 2], x: f64| [lo.min(x), hi.max(x)];
            seen = Some([grown(a_seen, a), grown(b_seen, b)]);
        }
        match seen {
            None => Seen::Nowhere,
            // What is beside the eye is seen beyond all bounds.
            Some(_) if behind > 0 => Seen::Everywhere,
            Some([a, b]) if a.iter().chain(&b).all(|x| x.is_finite()) => Seen::Between { a, b },
            Some(_) => Seen::Everywhere,
        }
    }

    /// Where the plane through `point` across `normal`, of any length, is seen:
    /// the picture on one side of its horizon.
    pub(crate) fn sees_plane(&self, point: DVec3, normal: DVec3) -> Seen {
        if !self.is_plain() {
            return Seen::Everywhere;
        }
        let (forward, u, v) = (*self.forward, *self.u, *self.v);
        let height = (point - self.e).dot(normal);
        let size = max_abs(self.e) + max_abs(point) + self.view_width + self.view_height;
        // Exact numbers are above 0 where these are, the margin added.
        let (c, x, y, scale) = match self.projection {
            Projection::Perspective { proj_distance: d } => {
                if height.abs() <= MARGIN * size * normal.length() {
                    return Seen::Everywhere;
                }
                let side = height.signum();
                let scale = d + self.view_width + self.view_height;
                (side * d * forward.dot(normal), side * u.dot(normal), side * v.dot(normal), scale)
            }
            Projection::Parallel => {
                let approach = forward.dot(normal);
                if approach.abs() <= MARGIN * normal.length() {
                    return Seen::Everywhere;
                }
                let side = approach.signum();
                (side * height, -side * u.dot(normal), -side * v.dot(normal), size)
            }
        };
        let margin = MARGIN * scale * normal.length();
        if [c, x, y, margin].iter().all(|x| x.is_finite()) {
            Seen::HalfPlane([c + margin, x, y])
        } else {
            Seen::Everywhere
        }
    }

    /// The point `(a, b)` of the window whose ray passes through `p`; `None` if
    /// `p` is not ahead of every ray's start by more than `least`.
    fn window_point(&self, p: DVec3, least: f64) -> Option<[f64; 2]> {
        let w = self.u.cross(*self.v);
        let from_eye = p - self.e;
        let ahead = from_eye.dot(w) / self.forward.dot(w);
        if !(ahead > least) {
            return None;
        }
        // In the window's plane through the eye, along the view.
        let across = from_eye - ahead * *self.forward;
        let [a, b] = [across.dot(*self.u), across.dot(*self.v)];
        Some(match self.projection {
            Projection::Perspective { proj_distance } => {
                let scale = proj_distance / ahead;
                [a * scale, b * scale]
            }
            Projection::Parallel => [a, b],
        })
    }

    /// Whether the view is neither so oblique nor so wide that rounding is
    /// stretched beyond [`MARGIN`].
    fn is_plain(&self) -> bool {
        const FLATTEST: f64 = 1e-3;
        const WIDEST: f64 = 1e6;
        let is_upright = self.forward.dot(self.u.cross(*self.v)).abs() > FLATTEST;
        let extent = self.view_width.max(self.view_height);
        let is_narrow = match self.projection {
            Projection::Perspective { proj_distance } => extent < WIDEST * proj_distance,
            Projection::Parallel => extent.is_finite(),
        };
        is_upright && is_narrow
    }
}

#[cfg(test)]
mod tests {
    use glam::dvec3;

    use super::*;
    use crate::View;

    fn views() -> Vec<Camera> {
        let view = |proj_normal| View {
            view_point: dvec3(1.0, 2.0, 3.0),
            view_dir: dvec3(0.3, -0.2, -1.0),
            view_up: DVec3::Y,
            proj_normal,
            view_width: 3.0,
            view_height: 2.0,
        };
        let perspective = Projection::Perspective { proj_distance: 1.5 };
        let mut all = Vec::new();
        for normal in [None, Some(dvec3(0.5, 0.1, 1.0))] {
            for projection in [perspective, Projection::Parallel] {
                all.push(Camera::new(&view(normal), projection).unwrap());
            }
        }
        all
    }

    /// Whether the window's point is in what is seen.
    fn is_in(seen: Seen, [a, b]: [f64; 2]) -> bool {
        match seen {
            Seen::Nowhere => false,
            Seen::Everywhere => true,
            Seen::Between { a: [a0, a1], b: [b0, b1] } => {
                (a0..=a1).contains(&a) && (b0..=b1).contains(&b)
            }
            Seen::HalfPlane([c, x, y]) => c + a * x + b * y > 0.0,
        }
    }

    #[test]
    fn a_box_is_seen_where_its_points_are() {
        let mut rng = fastrand::Rng::with_seed(3);
        let mut bounded = 0;
        for camera in views() {
            for _ in 0..2_000 {
                let mut any = || dvec3(rng.f64(), rng.f64(), rng.f64()) - 0.5;
                let (center, half) = (dvec3(1.0, 2.0, 0.0) + 8.0 * any(), any().abs());
                let bounds = Aabb { min: center - half, max: center + half };
                let seen = camera.sees_box(&bounds);
                let inside = center + half * 2.0 * any();
                // The ray through the point: found by asking backwards, and held
                // against the way forwards.
                let Some([a, b]) = camera.window_point(inside, 0.0) else { continue };
                let ray = camera.ray(a, b);
                let t = (inside - ray.origin).dot(ray.direction) / ray.direction.length_squared();
                assert!((ray.at(t) - inside).length() < 1e-9);
                assert!(is_in(seen, [a, b]), "{bounds:?}");
                bounded += u32::from(matches!(seen, Seen::Between { .. }));
            }
        }
        assert!(bounded > 3_000, "{bounded}");
    }

    #[test]
    fn a_box_is_seen_no_farther_than_its_corners() {
        // From (0, 0, 4) the near side of this box, at distance 3, is a third
        // as large on a window at distance 1.
        let camera = Camera::look_at(DVec3::Z * 4.0, DVec3::ZERO, DVec3::Y, 90.0, 1.0).unwrap();
        let bounds = Aabb { min: dvec3(-1.0, 0.0, -1.0), max: dvec3(1.0, 2.0, 1.0) };
        let Seen::Between { a, b } = camera.sees_box(&bounds) else { panic!() };
        let third = 1.0 / 3.0;
        let found = [a[0], a[1], b[0], b[1]];
        for (found, expected) in found.into_iter().zip([-third, third, 0.0, 2.0 * third]) {
            assert!((found - expected).abs() < 1e-4, "{found} {expected}");
        }
    }

    #[test]
    fn what_is_ahead_by_next_to_nothing_is_seen() {
        for projection in [Projection::Parallel, Projection::Perspective { proj_distance: 1.0 }] {
            let view = View {
                view_point: DVec3::ZERO,
                view_dir: -DVec3::Z,
                view_up: DVec3::Y,
                proj_normal: None,
                view_width: 1.0,
                view_height: 1.0,
            };
            let camera = Camera::new(&view, projection).unwrap();
            for ahead in [1e-30, 1e-22, 1e-20, 1e-9] {
                let near = dvec3(1.0, 1.0, -ahead);
                for far in [1.0, -ahead] {
                    let bounds = Aabb { min: -near.with_z(ahead), max: near.with_z(far) };
                    let seen = camera.sees_box(&bounds);
                    assert!(is_in(seen, [0.3, -0.2]), "{ahead} {far} {seen:?}");
                }
            }
        }
    }

    #[test]
    fn what_is_behind_is_not_seen() {
        for camera in views() {
            let center = camera.e - 5.0 * *camera.forward;
            let bounds = Aabb { min: center - 1.0, max: center + 1.0 };
            assert_eq!(camera.sees_box(&bounds), Seen::Nowhere);
            assert_eq!(camera.sees_box(&Aabb::EVERYTHING), Seen::Everywhere);
            assert_eq!(camera.sees_box(&Aabb::EMPTY), Seen::Nowhere);
        }
    }

    #[test]
    fn a_plane_is_seen_on_its_side_of_the_horizon() {
        let mut rng = fastrand::Rng::with_seed(4);
        let (mut met, mut missed_outside) = (0, 0);
        for camera in views() {
            for _ in 0..2_000 {
                let mut any = || dvec3(rng.f64(), rng.f64(), rng.f64()) - 0.5;
                let (point, normal) = (4.0 * any(), any());
                let seen = camera.sees_plane(point, normal);
                let window = any();
                let (a, b) = (3.0 * window.x, 2.0 * window.y);
                let ray = camera.ray(a, b);
                let t = (point - ray.origin).dot(normal) / ray.direction.dot(normal);
                if t > 0.0 {
                    met += 1;
                    assert!(is_in(seen, [a, b]));
                } else {
                    missed_outside += u32::from(!is_in(seen, [a, b]));
                }
            }
        }
        assert!(met > 1_000 && missed_outside > 1_000, "{met} {missed_outside}");
    }
}
