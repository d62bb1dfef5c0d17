//! `Axis`: what a cylinder and a cone share, a ray seen from close to an axis
//! and the part of it that lies in a solid around that axis.
//!
//! For a point `x` and the axis `A = b - a`, a solid of revolution asks for
//! two numbers only: `m = (x - a) x A`, which is `|A|` times the distance from
//! the axis and is the same for any point of the axis in place of `a`, and the
//! height `h = (x - a).A`. Along a ray both are linear:
//! `m = M + s D` with `D = d x A`, and `h = H + s g` with `g = d.A`.
//!
//! Three things keep the digits. The ray's origin is moved next to the solid
//! before anything is squared, by [`offset_at`], which rounds once however far
//! the way. Offsets count from the nearer end, so a long axis does not coarsen
//! what happens at its other end. And discriminants come from the identities
//! that [`Approach::moment`] explains, which have no squares to cancel.

mod passing;

use glam::DVec3;

use super::Contact;
use crate::fault::{Fault, seeded};
use crate::math::{
    cross, difference_of_products, dot, max_abs, offset_at, power_of_two_below, two_sum,
};
use crate::refused::{MIN_LENGTH, Refusal, refuse_unless, show};
use crate::{Aabb, Interval, Ray, UnitVec};

/// A directed axis between two points, measured in a power of two near its
/// own length so that products of a high degree neither overflow nor underflow.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Axis {
    /// Where it starts and ends, in object space.
    pub(super) ends: [DVec3; 2],
    /// `A`, from the first end to the second, in units.
    pub(super) along: DVec3,
    /// `|A|` in units: from 1 to `2 sqrt 3`.
    pub(super) length: f64,
    /// `A` by its direction.
    pub(super) direction: UnitVec,
    /// The unit of length, a power of two.
    pub(super) unit: f64,
}

/// The point of the line to work from.
///
/// One between the planes through both ends is at most as far from the axis,
/// or from the end, as any point where the ray meets the solid. How exactly it
/// is the closest does not matter: the offsets are true for the `t` chosen.
pub(super) enum Near {
    /// The closest to the axis between the planes.
    Axis,
    /// The closest to the axis' first end between the planes.
    FirstEnd,
}

/// The refusal of two ends that make no axis.
pub(super) fn apart(
    field: &'static str,
    other: &'static str,
    from: DVec3,
    to: DVec3,
) -> Option<Refusal> {
    refuse_unless(
        !(from.is_finite() && to.is_finite()) || max_abs(to - from) >= MIN_LENGTH,
        field,
        format!("a point at least {MIN_LENGTH:e} away from `{other}`, {}", show(from)),
        || show(to),
    )
}

/// A power of two at or below a finite number above 0, kept where its inverse
/// is a normal number too.
#[inline(always)]
fn unit_of(x: f64) -> f64 {
    let smallest = f64::MIN_POSITIVE;
    power_of_two_below(x).unwrap_or(smallest).min(smallest.recip())
}

impl Axis {
    /// The axis between two finite points that are [`apart`].
    pub(super) fn new(from: DVec3, to: DVec3) -> Self {
        let along = to - from;
        let unit = unit_of(max_abs(along));
        let along = along / unit;
        // Points apart have a direction; the other is never used.
        let direction = UnitVec::new(along).unwrap_or(UnitVec::Z);
        Self { ends: [from, to], along, length: size(along), direction, unit }
    }

    /// The tightest box around the disk across the axis at one of its ends.
    pub(super) fn disk_bounds(&self, end: usize, radius: f64) -> Aabb {
        let square = self.along * self.along;
        let across = DVec3::new(square.y + square.z, square.z + square.x, square.x + square.y);
        let reach = across.map(f64::sqrt) * (radius / self.length);
        Aabb { min: self.ends[end] - reach, max: self.ends[end] + reach }
    }

    /// The size of the coordinates that a point of the solid is made of.
    #[inline(always)]
    pub(super) fn coordinates(&self) -> f64 {
        max_abs(self.ends[0]).max(max_abs(self.ends[1]))
    }

    /// The point at this distance along the axis and this offset from it, both
    /// in units, in object space.
    #[inline(always)]
    pub(super) fn point(&self, height: f64, across: DVec3) -> DVec3 {
        self.ends[0] + self.unit * (height * *self.direction + across)
    }

    /// The part of a vector across the axis, from its `m`.
    #[inline(always)]
    pub(super) fn across(&self, m: DVec3) -> DVec3 {
        cross(self.along, m) / (self.length * self.length)
    }

    /// The ray as seen from close by; `None` for one that is not finite or
    /// has no direction.
    #[inline(always)]
    pub(super) fn approach(&self, ray: &Ray, near: &Near) -> Option<Approach> {
        let longest = max_abs(ray.direction);
        if !(ray.origin.is_finite() && ray.direction.is_finite() && longest > 0.0) {
            return None;
        }
        let t_unit = unit_of(longest).recip();
        let ray = Ray::new(ray.origin, ray.direction * t_unit);
        let d = ray.direction;
        let (sideways, climb) = (cross(d, self.along), dot(d, self.along));
        let [first, second] = self.ends;
        let to_planes =
            [self.height_between(ray.origin, first), self.height_between(ray.origin, second)];
        let planes = [to_planes[0] / climb, to_planes[1] / climb];
        let from_first = ray.origin - self.ends[0];
        let unmoved = Approach {
            axis: *self,
            ray,
            t_unit,
            sideways,
            climb,
            to_planes,
            planes,
            t: 0.0,
            from_ends: [DVec3::ZERO; 2],
            nearer: 0,
            m: DVec3::ZERO,
        };
        Some(match near {
            Near::Axis => {
                let square = sideways.dot(sideways);
                let from_axis = cross(from_first, self.along);
                unmoved.seen_from_between_planes(-from_axis.dot(sideways) / square)
            }
            Near::FirstEnd => unmoved.seen_from_between_planes(-from_first.dot(d) / d.dot(d)),
        })
    }

    /// `(to - from).A`, as if rounded once.
    #[inline(always)]
    fn height_between(&self, from: DVec3, to: DVec3) -> f64 {
        let (x, x_rest) = two_sum(to.x, -from.x);
        let (y, y_rest) = two_sum(to.y, -from.y);
        let (z, z_rest) = two_sum(to.z, -from.z);
        let rest = DVec3::new(x_rest, y_rest, z_rest);
        dot(DVec3::new(x, y, z), self.along) + rest.dot(self.along)
    }
}

/// A ray as seen from its point at `t`, with a direction near 1 long: what is
/// at `s` from there is at `(t + s unit) t_unit` of the ray as given.
pub(super) struct Approach {
    axis: Axis,
    /// The ray as given, but for the length of its direction.
    ray: Ray,
    t_unit: f64,
    /// `D`, and `g`.
    pub(super) sideways: DVec3,
    pub(super) climb: f64,
    /// How high the planes through the ends are above the ray's origin, and
    /// the `t` where it meets them.
    to_planes: [f64; 2],
    planes: [f64; 2],
    t: f64,
    /// The point from either end, in units.
    from_ends: [DVec3; 2],
    nearer: usize,
    /// `M`.
    pub(super) m: DVec3,
}

impl Approach {
    /// The same ray as seen from its point at another `t`.
    #[inline(always)]
    fn seen_from(self, t: f64) -> Self {
        let [first, second] = self.axis.ends;
        let from_ends = [
            offset_at(&self.ray, t, first) / self.axis.unit,
            offset_at(&self.ray, t, second) / self.axis.unit,
        ];
        let nearer = usize::from(max_abs(from_ends[1]) < max_abs(from_ends[0]));
        Self { t, m: cross(from_ends[nearer], self.axis.along), from_ends, nearer, ..self }
    }

    #[inline(always)]
    fn seen_from_between_planes(self, t: f64) -> Self {
        let [low, high] = self.planes;
        let t = if self.climb == 0.0 { t } else { t.max(low.min(high)).min(low.max(high)) };
        self.seen_from(t)
    }

    /// The same ray as seen from its point at `s`, or from the plane that is
    /// passed on the way there.
    #[inline(always)]
    pub(super) fn moved(self, s: f64) -> Self {
        let t = self.t + s * self.axis.unit;
        self.seen_from_between_planes(t)
    }

    /// `h` of the point, from the first end.
    #[inline(always)]
    pub(super) fn height(&self) -> f64 {
        dot(self.from_ends[0], self.axis.along)
    }

    /// `|A| (p.D)`, by how far the line passes from the axis: with it,
    /// `|M x D|`, the part that both solids' discriminants have in common, is
    /// free of `M` and of cancellation. `M x D = (p x A) x (d x A)
    /// = A (A.(p x d))`, and `A.(p x d) = p.(d x A)`.
    #[inline(always)]
    pub(super) fn moment(&self) -> f64 {
        self.axis.length * dot(self.from_ends[self.nearer], self.sideways)
    }

    /// The `s` of a contact: of two that it may be the one nearest to its `t`,
    /// as a far ray's `t` has fewer digits; or the `t`'s own if neither is
    /// finite.
    #[inline(always)]
    pub(super) fn nearest(&self, [one, other]: [f64; 2], t: f64) -> f64 {
        let s = (t / self.t_unit - self.t) / self.axis.unit;
        let nearer = if (s - one).abs() <= (s - other).abs() { one } else { other };
        if nearer.is_finite() { nearer } else { s }
    }

    /// How far the point at `s` is along the axis from its first end, in units.
    #[inline(always)]
    pub(super) fn height_at(&self, s: f64) -> f64 {
        s.mul_add(self.climb, self.height()) / self.axis.length
    }

    /// The point of the ray in the plane through an end, at most `radius`
    /// units from there.
    #[inline(always)]
    pub(super) fn point_of_cap(&self, end: usize, radius: f64) -> DVec3 {
        let s = -dot(self.from_ends[end], self.axis.along) / self.climb;
        let across = self.axis.across(self.m + s * self.sideways);
        let inward = (radius / across.length()).min(1.0);
        self.axis.ends[end] + self.axis.unit * (inward * across)
    }

    /// Cuts the line's way inside the endless side, in `s`, to the solid.
    ///
    /// The planes through the ends with a part of their own, and the disks of
    /// `reach = r |A|` in them, end the solid. Whether the line goes through a
    /// disk is asked where it crosses the plane, and not by the order of that
    /// crossing and the side's: at a sharp rim, the two are so close together
    /// that a rounding of `t` would move the rim by many. Then no order is left
    /// to be mistaken: a line through a disk is inside there, and for any other
    /// the way inside the side is all between the planes, its middle included,
    /// or none of it.
    #[inline(always)]
    pub(super) fn cut(
        &self,
        side: Option<[f64; 2]>,
        parts: [Option<u32>; 2],
        reach: f64,
        caps: bool,
    ) -> Option<Crossing> {
        // A positive test: a NaN is in no order.
        let side = side.filter(|[low, high]| low <= high);
        let on_side = |s: f64| Contact { t: self.t + s * self.axis.unit, ..Contact::at(0.0) };
        let caps = caps && !seeded(Fault::CapsLost);
        if seeded(Fault::EndlessSide) {
            let [enter, leave] = side?.map(on_side);
            return Some(self.crossing(enter, leave, caps));
        }
        if self.climb == 0.0 {
            let above = parts[0].is_none() || self.to_planes[0] <= 0.0;
            let [enter, leave] = side.filter(|_| above && 0.0 <= self.to_planes[1])?.map(on_side);
            return Some(self.crossing(enter, leave, caps));
        }
        let [first, second] = if self.climb > 0.0 { [0, 1] } else { [1, 0] };
        let disk = |end: usize| {
            let s = -dot(self.from_ends[end], self.axis.along) / self.climb;
            let from_axis = size(self.m + s * self.sideways);
            // The rim is a cap's where there is one, else the side's.
            let inside = if caps { from_axis <= reach } else { from_axis < reach };
            let part = parts[end].filter(|_| inside)?;
            Some(Contact { t: self.planes[end], part, barycentric: [0.0; 2] })
        };
        let (into, out_of) = (disk(first), disk(second));
        let side = side.map(|side| side.map(on_side));
        if into.is_none() && out_of.is_none() {
            let [enter, leave] = side?;
            let middle = 0.5 * enter.t + 0.5 * leave.t;
            let after = parts[first].is_none() || self.planes[first] <= middle;
            let before = parts[second].is_none() || middle <= self.planes[second];
            return (after && before).then(|| self.crossing(enter, leave, caps));
        }
        // Through a disk's rim the side may be missed by rounding.
        let enter = into.or(side.map(|[enter, _]| enter)).or(out_of)?;
        let leave = out_of.or(side.map(|[_, leave]| leave)).or(into)?;
        Some(self.crossing(enter, leave, caps))
    }

    /// The ends in the `t` of the ray as given; without caps only those on the
    /// side.
    #[inline(always)]
    fn crossing(&self, enter: Contact, leave: Contact, caps: bool) -> Crossing {
        let leave = Contact { t: leave.t.max(enter.t), ..leave };
        let [enter, leave] = [enter, leave].map(|end| {
            (caps || end.part == SIDE).then_some(Contact { t: end.t * self.t_unit, ..end })
        });
        Crossing { enter, leave }
    }
}

/// The part of both shapes that curves.
pub(super) const SIDE: u32 = 0;

/// Where a line enters and where it leaves a solid; an end that is not on the
/// surface, as in an opening, is `None`.
pub(super) struct Crossing {
    pub(super) enter: Option<Contact>,
    pub(super) leave: Option<Contact>,
}

impl Crossing {
    /// The first end in range.
    #[inline(always)]
    pub(super) fn first(self, range: Interval) -> Option<Contact> {
        [self.enter, self.leave].into_iter().flatten().find(|c| range.contains(c.t))
    }

    /// The end where it leaves, if in range.
    #[inline(always)]
    pub(super) fn last(self, range: Interval) -> Option<Contact> {
        self.leave.filter(|c| range.contains(c.t))
    }
}

/// The roots of `a s^2 + 2 b s + c` by its discriminant `b^2 - a c`, in no
/// order, infinite for an `a` of 0; `None` for no real roots. `reach` is how
/// far away in `s` the coefficients are balanced: `b` is rounded at about
/// `a reach` and `c` at about `a reach^2`, for an `a` that has not canceled.
///
/// With `q = -b - sign(b) sqrt(disc)` one root is `q / a`. The other is `c / q`,
/// which is the better one where `a` has canceled, or `(-b + sign(b)
/// sqrt(disc)) / a`, which is the better one where `q` has, as next to a
/// tangent: there it would blow up what `c` is off by.
#[inline(always)]
pub(super) fn roots(a: f64, b: f64, c: f64, discriminant: f64, reach: f64) -> Option<[f64; 2]> {
    // Where `a` and `c` differ in sign, a negative one is rounding.
    let is_rounding = a * c <= 0.0 && discriminant < 0.0;
    let root = if is_rounding { 0.0 } else { discriminant.sqrt() };
    let (q, less) = if b < 0.0 { (root - b, -root - b) } else { (-root - b, root - b) };
    if !(root >= 0.0 && q.is_finite()) {
        return None;
    }
    let other = if a.abs() * reach < q.abs() { c / q } else { less / a };
    Some([q / a, other])
}

/// The length of a vector, off by at most its last two roundings.
#[inline(always)]
pub(super) fn size(v: DVec3) -> f64 {
    dot(v, v).sqrt()
}

/// `x^2 - y^2` for the discriminants, with the exact sign.
#[inline(always)]
pub(super) fn difference_of_squares(x: f64, y: f64) -> f64 {
    difference_of_products(x, x, y, y)
}
