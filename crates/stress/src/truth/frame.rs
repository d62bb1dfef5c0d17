//! A ray seen from a frustum's axis: the roots of its surfaces and how far
//! each quantity moves when the inputs are rounded.

use std::cmp::Ordering;

use tracer::Ray;

use super::UNIT_ROUNDOFF;
use super::frustum::Frustum;
use crate::number::{Number, V3};

/// A decision is a tie if its margin is at most this many times what one
/// rounding of each input may move it by: a kernel that is right to 8 such
/// roundings, the target, decides everything else.
pub(super) const TIE: f64 = 8.0;

/// Where the line of a ray meets one of the surfaces.
pub(super) struct Root<N> {
    pub(super) t: N,
    /// The condition number times `|t|`.
    pub(super) condition: f64,
    /// Whether the surface has that point, ends and rims included.
    pub(super) on_body: bool,
    pub(super) part: u32,
}

/// The ray relative to end `a`; lengths in units of a power of two near the
/// body's size, directions of one near their own length, so that no power of
/// them leaves the range of a double-double.
pub(super) struct Frame<N> {
    f: V3<N>,
    d: V3<N>,
    /// The axis, `b - a`.
    w: V3<N>,
    ww: N,
    fw: N,
    dw: N,
    radius_a: N,
    /// The radius at `b` less that at `a`.
    taper: N,
    /// The inputs' magnitudes in `f64`, which is enough for a condition.
    sizes: Sizes,
    /// What `t` is to be multiplied with.
    pub(super) t_unit: f64,
}

struct Sizes {
    origin: f64,
    direction: f64,
    a: f64,
    b: f64,
    length: f64,
    radius_a: f64,
    radius_b: f64,
    /// The taper's magnitude over the length.
    slope: f64,
    /// The direction's part along the axis.
    along: f64,
    /// The direction's part across the axis.
    across: f64,
}

/// How a ray goes by the axis and the ends.
pub(super) struct Course<N> {
    /// Where on the whole line `phi` is least.
    least: Least<N>,
    /// Where it passes the ends, in order, each with how far one rounding of
    /// the inputs may move it; for a ray across the axis, how far it is between
    /// the ends and how far that may move.
    ends: Result<[(N, N); 2], (f64, f64)>,
}

enum Least<N> {
    At(N),
    /// It rises all along, or stays.
    First,
    /// It falls all along.
    Last,
}

/// A part of a ray, without an end where it has none.
pub(super) type Part<N> = (N, Option<N>);

impl<N: Number> Course<N> {
    /// The part of the ray ahead between the ends, these moved outward by so
    /// many times what one rounding of the inputs may do; `None` if empty.
    pub(super) fn ahead(&self, outward: f64) -> Option<Part<N>> {
        let by = |moved: &N| N::of(outward) * moved.clone();
        match &self.ends {
            Ok([(first, first_moved), (last, last_moved)]) => {
                let lo = (first.clone() - by(first_moved)).max(N::zero());
                let hi = last.clone() + by(last_moved);
                (lo <= hi).then_some((lo, Some(hi)))
            }
            Err((between, moved)) => {
                let inside = *between >= -outward * UNIT_ROUNDOFF * moved;
                inside.then(|| (N::zero(), None))
            }
        }
    }

    /// Where in a part `phi` is least.
    pub(super) fn nearest(&self, (lo, hi): &Part<N>) -> N {
        let t = match (&self.least, hi) {
            (Least::At(t), _) => t.clone().max(lo.clone()),
            (Least::Last, Some(hi)) => return hi.clone(),
            _ => return lo.clone(),
        };
        hi.as_ref().map_or(t.clone(), |hi| t.min(hi.clone()))
    }
}

/// The hypotenuse, of numbers that are near 1 or need not be told from 0.
fn hypotenuse(x: f64, y: f64) -> f64 {
    (x * x + y * y).sqrt()
}

/// A point of the ray.
struct Place<N> {
    s: N,
    /// From the axis.
    q: V3<N>,
    rho: N,
    phi: N,
}

/// The power of two in `x`; 1 for 0.
fn power_of_two(x: f64) -> f64 {
    if x > 0.0 { libm::ldexp(1.0, libm::ilogb(x)) } else { 1.0 }
}

impl<N: Number> Frame<N> {
    pub(super) fn new(body: &Frustum, ray: &Ray) -> Self {
        let widest = body.radius_a.max(body.radius_b);
        let unit = 1.0 / power_of_two((body.b - body.a).abs().max_element().max(widest));
        let way = 1.0 / power_of_two(ray.direction.abs().max_element());
        let scale = N::of(unit);
        let f = V3::<N>::difference(ray.origin, body.a).scale(&scale);
        let w = V3::<N>::difference(body.b, body.a).scale(&scale);
        let d = V3::<N>::of(ray.direction).scale(&N::of(way));
        let (ww, fw, dw) = (w.length_squared(), f.dot(&w), d.dot(&w));
        let taper = N::difference(body.radius_b, body.radius_a) * scale.clone();
        let length = ww.clone().sqrt().to_f64();
        let sizes = Sizes {
            origin: ray.origin.length() * unit,
            direction: d.to_f64().length(),
            a: body.a.length() * unit,
            b: body.b.length() * unit,
            length,
            radius_a: body.radius_a * unit,
            radius_b: body.radius_b * unit,
            slope: taper.to_f64().abs() / length,
            along: dw.to_f64().abs() / length,
            across: d.cross(&w).to_f64().length() / length,
        };
        let radius_a = N::of(body.radius_a) * scale;
        Self { f, d, w, ww, fw, dw, radius_a, taper, sizes, t_unit: way / unit }
    }

    fn place(&self, t: &N) -> Place<N> {
        let p = self.f.clone() + self.d.scale(t);
        let s = p.dot(&self.w) / self.ww.clone();
        let q = p - self.w.scale(&s);
        let rho = q.length();
        let phi = rho.clone() - (self.radius_a.clone() + self.taper.clone() * s.clone());
        Place { s, q, rho, phi }
    }

    /// How far inside the side the ray is at `t`, negative outside; and how far
    /// that may be off for one rounding of each input, [`TIE`] times.
    pub(super) fn depth(&self, t: &N) -> (f64, f64) {
        let place = self.place(t);
        (-place.phi.to_f64(), TIE * UNIT_ROUNDOFF * self.phi_moves(t, &place))
    }

    /// How far `phi` moves when every input is off by its own size: the sum of
    /// `|d phi / d v| |v|`.
    ///
    /// With `q` the unit vector from the axis, `w` that along it, `k` the slope
    /// and `l` the length: `d phi/d x = q - k w`, `d phi/d a = (k rho / l -
    /// (1 - s)) q + k (1 - s) w`, `d phi/d b = (-k rho / l - s) q + k s w`.
    fn phi_moves(&self, t: &N, place: &Place<N>) -> f64 {
        let z = &self.sizes;
        let (s, rho) = (place.s.to_f64(), place.rho.to_f64());
        let k = z.slope * self.taper.to_f64().signum();
        let at_a = hypotenuse(k * rho / z.length - (1.0 - s), k * (1.0 - s));
        let at_b = hypotenuse(k * rho / z.length + s, k * s);
        hypotenuse(1.0, k) * self.ray_moves(t)
            + at_a * z.a
            + at_b * z.b
            + (1.0 - s).abs() * z.radius_a
            + s.abs() * z.radius_b
    }

    /// How far the ray's point moves.
    fn ray_moves(&self, t: &N) -> f64 {
        self.sizes.origin + t.to_f64().abs() * self.sizes.direction
    }

    /// How far `s` moves, in lengths along the axis:
    /// `d s/d a = -((1 - s) w + rho q) / l^2`, `d s/d b = (rho q - s w) / l^2`.
    fn height_moves(&self, t: &N, place: &Place<N>) -> f64 {
        let z = &self.sizes;
        let (s, tilt) = (place.s.to_f64(), place.rho.to_f64() / z.length);
        self.ray_moves(t) + hypotenuse(1.0 - s, tilt) * z.a + hypotenuse(s, tilt) * z.b
    }

    /// How the ray goes by the axis and the ends.
    pub(super) fn course(&self) -> Course<N> {
        // `phi` is convex: a hyperbola less a straight line.
        let d_across = self.d.cross(&self.w);
        let a = d_across.length_squared() / self.ww.clone();
        let slope = self.taper.clone() * self.dw.clone() / self.ww.clone();
        let free = a.clone() - slope.square();
        let least = if free > N::zero() {
            let f_across = self.f.cross(&self.w);
            let middle = -(f_across.dot(&d_across) / d_across.length_squared());
            let lag = if slope.sign() == Ordering::Equal {
                N::zero()
            } else {
                self.place(&middle).rho * slope / (a * free).sqrt()
            };
            Least::At(middle + lag)
        } else if slope > N::zero() {
            // Steeper than the side: `phi` falls or rises all along.
            Least::Last
        } else {
            Least::First
        };
        if self.dw.sign() == Ordering::Equal {
            let t = if let Least::At(t) = &least { t.clone() } else { N::zero() };
            let place = self.place(&t);
            let height = place.s.to_f64() * self.sizes.length;
            let above = height.min(self.sizes.length - height);
            let moved = self.height_moves(&t, &place);
            return Course { least, ends: Err((above, moved)) };
        }
        let end = |height: N| {
            let t = (height - self.fw.clone()) / self.dw.clone();
            let moved = self.height_moves(&t, &self.place(&t)) / self.sizes.along;
            (t, N::of(UNIT_ROUNDOFF * moved))
        };
        let (at_a, at_b) = (end(N::zero()), end(self.ww.clone()));
        let ends = if at_a.0 > at_b.0 { [at_b, at_a] } else { [at_a, at_b] };
        Course { least, ends: Ok(ends) }
    }

    /// Where the line meets the side or its continuation.
    ///
    /// `rho^2 = R^2` times the fourth power of the length is
    /// `w^2 |x w|^2 = (r_a w^2 + k x.w)^2`, a quadratic; formed about the ray's
    /// closest approach to `a`, as past an apex both roots are near there, and
    /// as many digits would be lost twice.
    pub(super) fn side_roots(&self) -> Vec<Root<N>> {
        let middle = -(self.f.dot(&self.d) / self.d.length_squared());
        let f = self.f.clone() + self.d.scale(&middle);
        let fw = f.dot(&self.w);
        let (d, f) = (self.d.cross(&self.w), f.cross(&self.w));
        let ww = || self.ww.clone();
        let widens = self.taper.clone() * self.dw.clone();
        let radius = self.radius_a.clone() * ww() + self.taper.clone() * fw;
        let a = ww() * d.length_squared() - widens.square();
        let b = ww() * d.dot(&f) - widens * radius.clone();
        let c = ww() * f.length_squared() - radius.square();
        let disc = b.square() - a.clone() * c.clone();
        if !(disc >= N::zero()) {
            return Vec::new();
        }
        let root = disc.sqrt();
        let q = if b.sign() == Ordering::Less { root - b } else { -(b + root) };
        [q.clone() / a, c / q]
            .into_iter()
            .filter(N::is_finite)
            .map(|t| self.side_root(middle.clone() + t))
            .collect()
    }

    fn side_root(&self, t: N) -> Root<N> {
        let place = self.place(&t);
        let z = &self.sizes;
        let moves = self.phi_moves(&t, &place);
        let rising = self.taper.clone() * self.dw.clone() / self.ww.clone();
        let slope = place.q.dot(&self.d) / place.rho.clone() - rising;
        let mut slope = slope.to_f64().abs();
        // So near the apex that the rounded inputs may pass it on the other
        // side, where the cone is met under another angle.
        if !(place.rho.to_f64() > TIE * UNIT_ROUNDOFF * moves) {
            slope = slope.min((z.across - z.slope * z.along).abs());
        }
        let on_body = place.s >= N::zero() && place.s <= N::one();
        Root { t, condition: moves / slope, on_body, part: 0 }
    }

    /// Where the line meets the planes of the caps that there are.
    pub(super) fn cap_roots(&self) -> Vec<Root<N>> {
        let z = &self.sizes;
        let cap = |part: u32| {
            let height = if part == 1 { N::zero() } else { self.ww.clone() };
            let t = (height - self.fw.clone()) / self.dw.clone();
            let place = self.place(&t);
            let rho = place.rho.to_f64();
            // The cap's own end moves it, and both tilt it.
            let (at, tilt) = (hypotenuse(z.length, rho), rho);
            let (at_a, at_b) = if part == 1 { (at, tilt) } else { (tilt, at) };
            let moves = z.length * self.ray_moves(&t) + at_a * z.a + at_b * z.b;
            let condition = moves / (z.along * z.length);
            Root { t, condition, on_body: place.phi <= N::zero(), part }
        };
        let there = [(1, z.radius_a), (2, z.radius_b)];
        let crossed = self.dw.sign() != Ordering::Equal;
        let there = there.into_iter().filter(|(_, radius)| crossed && *radius > 0.0);
        there.map(|(part, _)| cap(part)).collect()
    }

    /// Whether a point of the side is surely beyond the ends (`Greater`),
    /// surely between them (`Less`), or too close to a rim to call (`Equal`).
    /// An apex is no rim.
    pub(super) fn beyond_ends(&self, t: &N, condition: f64) -> Ordering {
        let z = &self.sizes;
        let place = self.place(t);
        let moves = self.height_moves(t, &place) + z.along * condition;
        let doubt = TIE * UNIT_ROUNDOFF * moves;
        let above = |from: N| (from * self.ww.clone().sqrt()).to_f64();
        let ends =
            [(above(place.s.clone()), z.radius_a), (above(N::one() - place.s.clone()), z.radius_b)];
        let mut verdict = Ordering::Less;
        for (inside, radius) in ends {
            if inside < -doubt {
                return Ordering::Greater;
            }
            if !(inside > doubt) && radius > 0.0 {
                verdict = Ordering::Equal;
            }
        }
        verdict
    }
}
