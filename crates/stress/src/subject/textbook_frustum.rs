//! The textbook's cylinder and cone: the quadratic with `b^2 - 4 a c` about an
//! end, and the caps' planes; shown beside the kernels that render.

use tracer::glam::DVec3;

use super::frustum::RAY_AT;
use crate::Case;

/// A kernel in `f64` and in `f32`.
type Pair = [fn(&Case) -> Option<f64>; 2];

/// The cylinder.
pub(super) const CYLINDER: Pair =
    [|case| in_f64::first_hit(case, 1.0), |case| in_f32::first_hit(case, 1.0)];

/// The cone.
pub(super) const CONE: Pair =
    [|case| in_f64::first_hit(case, 0.0), |case| in_f32::first_hit(case, 0.0)];

macro_rules! textbook {
    ($module:ident, $float:ident) => {
        mod $module {
            use super::{Case, DVec3, RAY_AT};

            type Vector = [$float; 3];

            // One of the two modules converts to what it has.
            #[allow(clippy::unnecessary_cast)]
            fn vector(v: DVec3) -> Vector {
                v.to_array().map(|x| x as $float)
            }

            fn dot(a: Vector, b: Vector) -> $float {
                a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
            }

            /// `a + k b`.
            fn along(a: Vector, k: $float, b: Vector) -> Vector {
                [a[0] + k * b[0], a[1] + k * b[1], a[2] + k * b[2]]
            }

            /// The first `t` above 0, with this part of the radius at `a`.
            #[allow(clippy::unnecessary_cast, clippy::cast_lossless)]
            pub(super) fn first_hit(case: &Case, narrowing: $float) -> Option<f64> {
                let (a, b) = (vector(case.point(0)), vector(case.point(3)));
                let (radius, caps) = (case.number(6) as $float, case.number(7) > 0.0);
                let ray = case.ray(RAY_AT);
                let (o, d) = (vector(ray.origin), vector(ray.direction));
                let w = along(b, -1.0, a);
                let length = dot(w, w).sqrt();
                let w = along([0.0; 3], 1.0 / length, w);
                let f = along(o, -1.0, a);
                let (fw, dw) = (dot(f, w), dot(d, w));
                let (f, d) = (along(f, -fw, w), along(d, -dw, w));
                let slope = (1.0 - narrowing) * radius / length;
                let at_a = narrowing * radius;
                let qa = dot(d, d) - slope * slope * dw * dw;
                let qb = 2.0 * (dot(f, d) - slope * dw * (at_a + slope * fw));
                let qc = dot(f, f) - (at_a + slope * fw) * (at_a + slope * fw);
                let root = (qb * qb - 4.0 * qa * qc).sqrt();
                let mut first = $float::INFINITY;
                for t in [(-qb - root) / (2.0 * qa), (-qb + root) / (2.0 * qa)] {
                    let height = fw + t * dw;
                    if 0.0 <= height && height <= length && 0.0 < t && t < first {
                        first = t;
                    }
                }
                for (height, radius) in [(0.0, at_a), (length, radius)] {
                    let t = (height - fw) / dw;
                    let p = along(f, t, d);
                    if caps && dot(p, p) <= radius * radius && 0.0 < t && t < first {
                        first = t;
                    }
                }
                (first < $float::INFINITY).then_some(first as f64)
            }
        }
    };
}

textbook!(in_f64, f64);
textbook!(in_f32, f32);
