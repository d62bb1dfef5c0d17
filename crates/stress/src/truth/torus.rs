//! Where a ray meets a torus, exactly: all real roots of the quartic.
//!
//! The quartic is formed about the ray's closest approach to the center, with
//! lengths in units of the major radius, in twice the digits at least: there
//! its coefficients are of one size and all its roots are below 2.

use tracer::Ray;
use tracer::glam::DVec3;

use super::polynomial::roots_and_extrema;
use crate::number::{Dd, Number, V3};

/// All points at distance `minor_radius` from a circle of radius
/// `major_radius` about `center`, across `axis`, which has any length.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Torus {
    /// The center.
    pub center: DVec3,
    /// The way across the circle, of any length above 0.
    pub axis: DVec3,
    /// The circle's radius.
    pub major_radius: f64,
    /// The tube's radius, at most `major_radius`: a horn torus if equal.
    pub minor_radius: f64,
}

/// Where a ray meets a torus.
#[derive(Debug, Clone, PartialEq)]
pub struct TorusTruth {
    /// Every `t` above 0, ascending, as sums of two `f64`s.
    pub roots: Vec<(f64, f64)>,
    /// How fast the ray leaves the surface at the first: the length of the
    /// direction times the sine of its angle to the tangent plane, over the
    /// major radius. Times an error of `t` it is the distance of the hit from
    /// the surface.
    pub rate: f64,
    /// Whether a shift of the surface by [`TIE`] could give another first hit.
    pub tie: bool,
}

/// What is too close to call, in major radii: the error that is allowed.
pub const TIE: f64 = 1e-14;

/// How far roots are driven, over the bounding sphere's diameter, in
/// double-double: some bits above its rounding.
const PRECISION: f64 = 1e-30;

/// The radius of the sphere in which all roots are, in major radii, a little
/// larger than `1 + r/R` so that no root is at its end.
const BOUND: f64 = 2.125;

impl Torus {
    /// All hits with `t` above 0, in double-double.
    pub fn hits(&self, ray: &Ray) -> TorusTruth {
        self.hits_in::<Dd>(ray, PRECISION)
    }

    /// The same in one kind of number, roots driven to this precision.
    pub fn hits_in<N: Number>(&self, ray: &Ray, precision: f64) -> TorusTruth {
        let mut truth = TorusTruth { roots: Vec::new(), rate: 0.0, tie: false };
        let scale = N::of(self.major_radius);
        let over = N::one() / scale.clone();
        let f = V3::<N>::difference(ray.origin, self.center).scale(&over);
        let d = V3::<N>::of(ray.direction).scale(&over);
        let t_near = -(f.dot(&d) / d.length_squared());
        // In `y`, which counts major radii along the ray.
        let y_unit = d.length();
        let x = f.clone() + d.scale(&t_near);
        let d = d.scale(&(N::one() / d.length()));
        let bound = N::of(BOUND).square() - x.length_squared();
        if !(bound > N::zero()) {
            // A line past the bounding sphere, or no numbers.
            truth.tie = !bound.is_finite();
            return truth;
        }
        let axis = V3::<N>::of(self.axis);
        let axis = axis.scale(&(N::one() / axis.length()));
        let tube = N::of(self.minor_radius) / scale;
        let start = -(t_near.clone() * y_unit.clone());
        let place = |y: &N| Place::new(&(x.clone() + d.scale(y)), &axis, &tube);
        let quartic = quartic(&x, &d, &axis, &tube);
        let reach = bound.sqrt();
        let ends = (&-reach.clone(), &reach);
        let (roots, extrema) = roots_and_extrema(&quartic, ends, precision);
        let ahead: Vec<_> = roots.into_iter().filter(|y| *y > start).collect();
        // Between the start and the far end of the first hit's dip or bump, is
        // the surface touched but for a hair?
        let first = ahead.first();
        let decisive = extrema.into_iter().filter(|y| *y > start);
        let before = |y: &N| first.is_none_or(|first| y < first);
        let until = decisive.clone().filter(before).count() + 1;
        truth.tie = decisive.take(until).any(|y| !(place(&y).distance.abs() > TIE))
            || !(place(&start).distance.abs() > TIE);
        if let Some(first) = first {
            let normal = place(first).normal;
            truth.rate = d.dot(&normal).to_f64().abs() * y_unit.to_f64();
        }
        for y in ahead {
            let t = t_near.clone() + y / y_unit.clone();
            let hi = t.to_f64();
            truth.roots.push((hi, (t - N::of(hi)).to_f64()));
        }
        truth
    }
}

/// The quartic in `y` of `F(x + y d) = 0` for
/// `F(p) = (p.p + 1 - r^2)^2 - 4 (p.p - (p.n)^2)`, lowest coefficient first,
/// with `d` a unit vector.
fn quartic<N: Number>(x: &V3<N>, d: &V3<N>, axis: &V3<N>, tube: &N) -> [N; 5] {
    let n = N::of;
    // p.p + 1 - r^2 = y^2 + 2 xd y + k, and p.n = xn + y dn.
    let (xd, xx) = (x.dot(d), x.length_squared());
    let (xn, dn) = (x.dot(axis), d.dot(axis));
    let dd = d.length_squared();
    let k = xx.clone() + N::one() - tube.square();
    let four = || n(4.0);
    [
        k.square() - four() * (xx - xn.square()),
        four() * k.clone() * xd.clone() - n(8.0) * (xd.clone() - xn * dn.clone()),
        four() * xd.square() + n(2.0) * k * dd.clone() - four() * (dd.clone() - dn.square()),
        four() * xd * dd.clone(),
        dd.square(),
    ]
}

/// A point and the surface.
struct Place<N> {
    /// From the surface, outward positive, in major radii.
    distance: f64,
    /// The unit normal of the torus about the same circle through here.
    normal: V3<N>,
}

impl<N: Number> Place<N> {
    fn new(p: &V3<N>, axis: &V3<N>, tube: &N) -> Self {
        let height = p.dot(axis);
        let across = p.clone() - axis.scale(&height);
        let radius = across.length();
        let from_circle = p.clone() - across.scale(&(N::one() / radius.clone()));
        let spread = ((radius - N::one()).square() + height.square()).sqrt();
        let distance = (spread.clone() - tube.clone()).to_f64();
        Self { distance, normal: from_circle.scale(&(N::one() / spread)) }
    }
}

#[cfg(test)]
mod tests;
