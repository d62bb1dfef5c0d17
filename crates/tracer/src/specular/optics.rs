//! Mirror reflection, refraction, and the share of light that each has.
//!
//! Directions have length 1 and point the way that the ray goes; the normal is
//! on the side that the ray comes from. Every formula is a few products and
//! roots, the same for a mirrored scene but for signs.

use glam::DVec3;

use crate::UnitVec;
use crate::fault::{Fault, seeded};

/// The ray's direction in a mirror: `r = d - 2 (n.d) n`.
///
/// Source: Whitted, "An Improved Illumination Model for Shaded Display", 1980,
/// the vector `R`.
pub(super) fn reflect(d: DVec3, n: UnitVec) -> DVec3 {
    let mirrored = d - *n * (2.0 * n.dot(d));
    if seeded(Fault::ReflectionReversed) { -mirrored } else { mirrored }
}

/// How a ray goes on beyond a surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Refraction {
    /// Its direction, of length 1.
    pub(super) direction: DVec3,
    /// The cosine of its angle with the normal, above 0.
    pub(super) cosine: f64,
}

/// Snell's law, `sin i = ior sin t`: the direction beyond a surface, behind
/// which the index of refraction is `ior` times that before it. `None` is total
/// internal reflection, and refraction along the surface with it.
///
/// With `m = ior cos t`, `t = (d + (cos i - m) n) / ior`. An index of 1 changes
/// no bit of the direction.
///
/// Source: Heckbert, "Derivation of Refraction Formulas", in Glassner (ed.), "An
/// Introduction to Ray Tracing", 1989; `m^2` is written without `1 - cos^2 i`,
/// which would round where the ray grazes.
pub(super) fn refract(d: DVec3, n: UnitVec, ior: f64) -> Option<Refraction> {
    let cos_i = -n.dot(d);
    let squared = (ior - 1.0) * (ior + 1.0) + cos_i * cos_i;
    if !(squared > 0.0) {
        return None;
    }
    let m = squared.sqrt();
    Some(Refraction { direction: (d + *n * (cos_i - m)) / ior, cosine: m / ior })
}

/// The share of unpolarized light that is reflected where the angles with the
/// normal have the cosines `cos_i` and `cos_t`: the mean of those of its two
/// polarizations.
///
/// Source: Fresnel's equations, as in Born and Wolf, "Principles of Optics", 7th
/// edition, section 1.5.2.
pub(super) fn fresnel(ior: f64, cos_i: f64, cos_t: f64) -> f64 {
    let share = |a: f64, b: f64| {
        // Both are 0 only along a surface between media that are the same.
        if a + b > 0.0 { ((a - b) / (a + b)) * ((a - b) / (a + b)) } else { 0.0 }
    };
    0.5 * (share(cos_i, ior * cos_t) + share(ior * cos_i, cos_t))
}

/// The share that is reflected straight back, `((ior - 1) / (ior + 1))^2`: what
/// [`fresnel`] gives for cosines of 1.
pub(super) fn straight_on(ior: f64) -> f64 {
    let root = (ior - 1.0) / (ior + 1.0);
    root * root
}

/// Schlick's share, `r0 + (1 - r0) (1 - cos)^5`: `r0` straight on, all along the
/// surface.
///
/// Source: Schlick, "An Inexpensive BRDF Model for Physically-based Rendering",
/// 1994, equation 15.
pub(super) fn schlick(r0: f64, cosine: f64) -> f64 {
    let x = 1.0 - cosine;
    r0 + (1.0 - r0) * ((x * x) * (x * x) * x)
}

#[cfg(test)]
mod tests;
