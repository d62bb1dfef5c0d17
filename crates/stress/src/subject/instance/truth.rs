//! Where a ray meets a sphere, a box and a triangle near the origin of their
//! own space, exactly, and how close it comes to missing them.

use tracer::glam::DVec3;

use crate::number::{Dd, Number, V3};

/// A ray in the object's space.
pub(super) struct Ray {
    pub(super) origin: V3<Dd>,
    pub(super) direction: V3<Dd>,
    /// How far rounding the inputs may move it sideways.
    pub(super) rounding: f64,
}

/// The exact answer.
pub(super) enum Meeting {
    /// At this `t`, with this cosine between the ray and the normal.
    Hit(Dd, f64),
    Miss,
    /// Rounding the inputs may decide.
    Tie,
}

/// The objects.
pub(super) const CORNERS: [DVec3; 3] =
    [DVec3::new(-1.0, -0.5, 0.25), DVec3::new(0.75, -1.0, -0.5), DVec3::new(0.125, 1.0, 0.375)];

impl Ray {
    fn length(&self) -> f64 {
        self.direction.length().to_f64()
    }

    /// The sphere of radius 1 around the origin.
    pub(super) fn sphere(&self) -> Meeting {
        let a = self.direction.length_squared();
        let b = -self.origin.dot(&self.direction);
        let across = self.origin + self.direction.scale(&(b / a));
        let discriminant = Dd::one() - across.length_squared();
        // The distance to the silhouette is half of that, near it.
        if discriminant.to_f64().abs() <= 2.0 * self.rounding {
            return Meeting::Tie;
        }
        if discriminant < Dd::zero() {
            return Meeting::Miss;
        }
        let root = (a * discriminant).sqrt();
        let cosine = discriminant.to_f64().sqrt();
        for t in [(b - root) / a, (b + root) / a] {
            if self.starts_at(t, cosine) {
                return Meeting::Tie;
            }
            if t > Dd::zero() {
                return Meeting::Hit(t, cosine);
            }
        }
        Meeting::Miss
    }

    /// The box from -1 to 1.
    pub(super) fn axis_box(&self) -> Meeting {
        let of = |v: &V3<Dd>| [v.x, v.y, v.z];
        let (p, d) = (of(&self.origin), of(&self.direction));
        let cosines = d.map(|d| d.to_f64().abs() / self.length());
        let (mut enter, mut leave) = (None, None);
        for axis in 0..3 {
            let sides = [-Dd::one(), Dd::one()].map(|side| (side - p[axis]) / d[axis]);
            let (t_in, t_out) = (sides[0].min(sides[1]), sides[0].max(sides[1]));
            if enter.is_none_or(|(t, _)| t_in > t) {
                enter = Some((t_in, axis));
            }
            if leave.is_none_or(|(t, _)| t_out < t) {
                leave = Some((t_out, axis));
            }
        }
        let (Some((t_in, k_in)), Some((t_out, k_out))) = (enter, leave) else {
            return Meeting::Miss;
        };
        let doubt = self.rounding / self.length() * (1.0 / cosines[k_in] + 1.0 / cosines[k_out]);
        if (t_out - t_in).to_f64().abs() <= doubt {
            return Meeting::Tie;
        }
        if t_in > t_out {
            return Meeting::Miss;
        }
        for (t, k) in [(t_in, k_in), (t_out, k_out)] {
            if self.starts_at(t, cosines[k]) {
                return Meeting::Tie;
            }
            if t > Dd::zero() {
                return Meeting::Hit(t, cosines[k]);
            }
        }
        Meeting::Miss
    }

    /// The triangle of [`CORNERS`].
    pub(super) fn triangle(&self) -> Meeting {
        let corners = CORNERS.map(V3::<Dd>::of);
        let [a, b, c] = corners;
        let normal = (b - a).cross(&(c - a));
        let approach = self.direction.dot(&normal);
        let t = (a - self.origin).dot(&normal) / approach;
        let size = normal.length().to_f64();
        let cosine = approach.to_f64().abs() / (size * self.length());
        if self.starts_at(t, cosine) {
            return Meeting::Tie;
        }
        let x = self.origin + self.direction.scale(&t);
        // The distances inside of the three edges.
        let inside = |k: usize| {
            let (p, edge) = (corners[k], corners[(k + 1) % 3] - corners[k]);
            edge.cross(&(x - p)).dot(&normal).to_f64() / (size * edge.length().to_f64())
        };
        let least = [0, 1, 2].map(inside).into_iter().fold(f64::INFINITY, f64::min);
        if least.abs() <= self.rounding / cosine || !least.is_finite() {
            Meeting::Tie
        } else if least > 0.0 && t > Dd::zero() {
            Meeting::Hit(t, cosine)
        } else {
            Meeting::Miss
        }
    }

    /// Whether rounding may decide on which side of the origin `t` is.
    fn starts_at(&self, t: Dd, cosine: f64) -> bool {
        t.to_f64().abs() * self.length() <= self.rounding / cosine
    }
}
