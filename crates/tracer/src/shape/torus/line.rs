//! `Line`: where a ray's line is inside a torus and where outside, with no
//! crossing lost and each found to the rounding of the surface's own equation.

use glam::DVec3;

use super::{Torus, cubic};
use crate::math::{UNIT_ROUNDOFF, max_abs, offset_at, power_of_two_below};
use crate::{Interval, Ray};

/// How much larger than the torus the search is, so that its ends are outside
/// whatever the rounding.
const ROOM: f64 = 1.0 + 1.0 / 64.0;

/// The same for a tube that is thin beside the rounding of the ring, in units
/// of the ring.
const THIN_ROOM: f64 = 1.0 / (1_u64 << 40) as f64;

/// Newton steps to a crossing; a simple root takes about six, and bisection
/// ends what is not done by then.
const MAX_STEPS: usize = 32;

/// Halvings of the whole search to below a rounding error: it is at most 2^3
/// rings long, and 2^-53 ring is wanted.
const MAX_HALVINGS: usize = 56;

/// The line of a ray in the units of a torus: `X(s) = x + s d`, relative to
/// the center.
///
/// Its origin is moved to where the ray passes the center, so that distance
/// costs no digits, and the lengths are divided by powers of two near the
/// larger radius and near the ray's direction, which rounds nothing and keeps
/// fourth powers in range. The parts across the axis stay vectors of space:
/// a frame would have to be chosen, and mirrored rays would differ.
pub(super) struct Line {
    /// `X` across the axis, at `s = 0` and per `s`.
    across: [DVec3; 2],
    /// `X` along the axis, at `s = 0` and per `s`.
    along: [f64; 2],
    major: f64,
    minor: f64,
    /// The ray's parameter at `s = 0` and per `s`.
    t: [f64; 2],
    /// The `s` that passes the center most closely, nearly 0.
    nearest: f64,
    /// The square of the distance there.
    nearest_squared: f64,
    /// `d . d`, from 1 to 12.
    dd: f64,
}

/// A part of a line cut where `g` (see [`Line::span`]) has its turning points.
pub(super) struct Span {
    /// Ascending, the first `count` of them.
    cuts: [Cut; 5],
    count: usize,
}

#[derive(Clone, Copy)]
struct Cut {
    s: f64,
    /// See [`Line::level`]; infinite where only the side is known.
    level: f64,
}

impl Cut {
    #[inline(always)]
    fn on_side(s: f64, outside: bool) -> Self {
        Self { s, level: if outside { f64::INFINITY } else { f64::NEG_INFINITY } }
    }

    /// A line that touches the surface in this very point is inside: that is
    /// a contact.
    #[inline(always)]
    fn is_outside(self) -> bool {
        self.level > 0.0
    }
}

impl Span {
    /// The rest of the span from `start` on, where the side is known.
    #[inline(always)]
    pub(super) fn starting_at(self, start: f64, outside: bool) -> Self {
        let all = &self.cuts[..self.count];
        if !(all.first().is_some_and(|first| first.s < start)) {
            return self;
        }
        let mut rest = Self { cuts: self.cuts, count: 1 };
        rest.cuts[0] = Cut::on_side(start, outside);
        for &cut in all.iter().filter(|cut| cut.s > start) {
            rest.cuts[rest.count] = cut;
            rest.count += 1;
        }
        rest
    }
}

impl Line {
    /// The line of a ray; `None` where it passes the torus by, and for numbers
    /// that are not finite. So does a direction whose every component is below
    /// the normal numbers.
    #[inline(always)]
    pub(super) fn new(torus: &Torus, ray: &Ray) -> Option<Self> {
        let unit = power_of_two_below(torus.major)?;
        let stride = power_of_two_below(max_abs(ray.direction))?;
        let d = ray.direction / stride;
        let dd = d.dot(d);
        // Any parameter near the center does, as the offset there is exact.
        let approach = -((ray.origin - torus.center) / unit).dot(d) / dd;
        let t = [approach * (unit / stride), unit / stride];
        let x = offset_at(ray, t[0], torus.center) / unit;

        let (major, minor) = (torus.major / unit, torus.minor / unit);
        let nearest = -x.dot(d) / dd;
        let nearest_squared = (x + nearest * d).length_squared();
        let reach = ROOM * (major + minor);
        // A positive test: a NaN anywhere is a miss.
        if !(nearest_squared < reach * reach) {
            return None;
        }
        let ((x_along, x_across), (d_along, d_across)) = (torus.parts(x), torus.parts(d));
        Some(Self {
            across: [x_across, d_across],
            along: [x_along, d_along],
            major,
            minor,
            t,
            nearest,
            nearest_squared,
            dd,
        })
    }

    /// The `s` of the ray's origin.
    #[inline(always)]
    pub(super) fn start(&self) -> f64 {
        -self.t[0] / self.t[1]
    }

    #[inline(always)]
    fn t(&self, s: f64) -> f64 {
        s.mul_add(self.t[1], self.t[0])
    }

    /// The surface's equation `(rho - R)^2 + z^2 - r^2`, with `rho` and `z` the
    /// distances from the axis and along it; below 0 inside. Its rounding is
    /// that of the distance to the surface, a few units of the ring.
    #[inline(always)]
    fn level(&self, s: f64) -> f64 {
        self.level_and_slope(s).0
    }

    /// The level, and how fast it rises; NaN or infinite on the axis.
    #[inline(always)]
    fn level_and_slope(&self, s: f64) -> (f64, f64) {
        let across = DVec3::splat(s).mul_add(self.across[1], self.across[0]);
        let z = s.mul_add(self.along[1], self.along[0]);
        let rho = across.length();
        let e = rho - self.major;
        let level = z.mul_add(z, (e - self.minor) * (e + self.minor));
        let rho_slope = across.dot(self.across[1]) / rho;
        (level, 2.0 * e.mul_add(rho_slope, z * self.along[1]))
    }

    /// The part of the line that may be inside, cut so that each piece has one
    /// crossing where its ends are on different sides and none where not.
    ///
    /// The torus is `g = (|X|^2 + R^2 - r^2)^2 - 4 R^2 rho^2 = 0`, a quartic in
    /// `s` with the sign of [`Line::level`], so the cuts belong to its turning
    /// points. Counted from the closest approach, `v = s - nearest`, and with
    /// `m` the square of the distance there, `g'` has no square term:
    /// `g'/4 = dd^2 v^3 + ((m + R^2 - r^2) dd - 2 R^2 b.b) v - 2 R^2 a.b`,
    /// where `a + v b` is the part across the axis.
    ///
    /// What rounding does to a turning point matters little: `g` is flat there.
    /// Two turning points that it loses are so near each other that `g` is
    /// the same at both, to far below its own rounding. On which side a turning
    /// point lies is asked of the level, which decides whether a ray grazes.
    #[inline(always)]
    pub(super) fn span(&self) -> Option<Span> {
        let (r1, r2) = (self.major, self.minor);
        let reach = ROOM * (r1 + r2);
        let half = ((reach * reach - self.nearest_squared) / self.dd).sqrt();
        // Within the slab that the tube fills. A line along the slab gives a
        // NaN or an infinity, which `max` and `min` pass over.
        let slab = ROOM * r2 + THIN_ROOM * r1;
        let [z, z_slope] = self.along;
        if z_slope == 0.0 && z.abs() > slab {
            return None;
        }
        let (middle, reach) = (-z / z_slope, (slab / z_slope).abs());
        let lo = (self.nearest - half).max(middle - reach);
        let hi = (self.nearest + half).min(middle + reach);
        if !(lo < hi) {
            return None;
        }

        let b = self.across[1];
        let a = self.across[0] + self.nearest * b;
        let twice_square = 2.0 * r1 * r1;
        let tension = (self.nearest_squared + (r1 - r2) * (r1 + r2)) * self.dd;
        let p = (tension - twice_square * b.dot(b)) / (self.dd * self.dd);
        let q = -twice_square * a.dot(b) / (self.dd * self.dd);

        let mut span = Span { cuts: [Cut::on_side(lo, true); 5], count: 1 };
        for v in cubic::roots(p, q) {
            let s = self.nearest + v;
            if span.cuts[span.count - 1].s < s && s < hi {
                span.cuts[span.count] = Cut { s, level: self.level(s) };
                span.count += 1;
            }
        }
        span.cuts[span.count] = Cut::on_side(hi, true);
        span.count += 1;
        Some(span)
    }

    /// The ray's parameter at the first crossing inside `range`.
    #[inline(always)]
    pub(super) fn first_crossing(&self, span: &Span, range: Interval) -> Option<f64> {
        span.cuts[..span.count].windows(2).find_map(|piece| {
            let [lo, hi] = [piece[0], piece[1]];
            // What rounds from a piece before or after the range is not in it.
            let may_be_in_range = self.t(hi.s) > range.lo && self.t(lo.s) < range.hi;
            let (outside, inside) = if lo.is_outside() { (lo, hi) } else { (hi, lo) };
            if lo.is_outside() == hi.is_outside() || !may_be_in_range {
                return None;
            }
            let touches = inside.level == 0.0;
            let t = self.t(if touches { inside.s } else { self.crossing(outside.s, inside.s) });
            range.contains(t).then_some(t)
        })
    }

    /// The crossing between two places: Newton's method, halving where that
    /// leaves the piece or comes no faster nearer than halving would.
    #[inline(always)]
    fn crossing(&self, mut outside: f64, mut inside: f64) -> f64 {
        let resolution = UNIT_ROUNDOFF * self.major / self.dd.sqrt();
        let mut s = 0.5 * (outside + inside);
        let mut step_before = f64::INFINITY;
        for _ in 0..MAX_STEPS {
            let (level, slope) = self.level_and_slope(s);
            if level > 0.0 {
                outside = s;
            } else {
                inside = s;
            }
            let mut next = s - level / slope;
            let within = outside.min(inside) <= next && next <= outside.max(inside);
            if !(within && (next - s).abs() <= 0.5 * step_before) {
                next = 0.5 * (outside + inside);
            }
            step_before = (next - s).abs();
            s = next;
            if step_before <= resolution {
                return s;
            }
        }
        for _ in 0..MAX_HALVINGS {
            if (outside - inside).abs() <= resolution {
                break;
            }
            let middle = 0.5 * (outside + inside);
            if self.level(middle) > 0.0 {
                outside = middle;
            } else {
                inside = middle;
            }
        }
        0.5 * (outside + inside)
    }
}
