//! `Material`: how a surface sends light on.

use crate::fault::{Fault, seeded};
use crate::math::pow;
use crate::meter::{Event, Meter, Unmetered};
use crate::refused::{Refusal, color, index, length, share};
use crate::{Convention, Refused, Rgb, Skipping, UnitVec};

/// What a surface is made of.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Material {
    /// Shows this color, unlit.
    Constant(Rgb),
    /// Shows the shading normal as the color `(n + 1) / 2`.
    Normal,
    /// Scatters light uniformly in all directions.
    Lambert {
        /// `k_d`: the share of light scattered, in each channel.
        diffuse: Rgb,
    },
    /// Lambert, with a highlight about the half vector.
    BlinnPhong {
        /// `k_d`: the share of light scattered.
        diffuse: Rgb,
        /// `k_s`: the strength of the highlight.
        specular: Rgb,
        /// `p`: the highlight's sharpness, above 0.
        exponent: f64,
    },
    /// Shows `reflectance` times what the reflected ray sees.
    Mirror {
        /// The share of light reflected, in each channel.
        reflectance: Rgb,
        /// Whether that is the share straight on, which grows to 1 along the
        /// surface by Schlick's law.
        schlick: bool,
    },
    /// Shows what the reflected ray sees, by the share of light that Fresnel's
    /// equations say, and of the rest what the refracted ray sees, by Snell's
    /// law. The inside is behind the geometric normal. Radiance is not scaled
    /// by the square of the index.
    Dielectric {
        /// The index of refraction of the inside, relative to the outside.
        ior: f64,
        /// Multiplies what is refracted, each time.
        tint: Rgb,
        /// Whether Schlick's law stands in for Fresnel's equations.
        schlick: bool,
    },
    /// Whitted's sum: `BlinnPhong`, and `reflect` times what the reflected ray
    /// sees, and `transmit` times what the refracted ray sees. What is totally
    /// reflected is seen along the reflected ray, `transmit` times too.
    ///
    /// Source: Whitted, "An Improved Illumination Model for Shaded Display",
    /// 1980, equation 3.
    Whitted {
        /// `k_d`.
        diffuse: Rgb,
        /// The strength of the highlight of lights.
        specular: Rgb,
        /// The highlight's sharpness, above 0.
        exponent: f64,
        /// `k_s` of the reflected ray.
        reflect: Rgb,
        /// `k_t` of the refracted ray.
        transmit: Rgb,
        /// The index of refraction of the inside, relative to the outside.
        ior: f64,
        /// Whether `reflect` is the share straight on, which grows to 1 along
        /// the surface by Schlick's law.
        schlick: bool,
    },
    /// `BlinnPhong` under a clear coat, which is on the outside: the coat shows
    /// what the reflected ray sees, by the share of Fresnel's equations, and
    /// what is under it the rest.
    Glazed {
        /// The index of refraction of the coat, relative to the outside.
        ior: f64,
        /// Whether Schlick's law stands in for Fresnel's equations.
        schlick: bool,
        /// `k_d` of what is under it.
        diffuse: Rgb,
        /// The strength of its highlight.
        specular: Rgb,
        /// The highlight's sharpness, above 0.
        exponent: f64,
    },
}

impl Material {
    /// Whether every number may be rendered with.
    ///
    /// # Errors
    /// Refuses (as `color`, `diffuse`, `specular`, `exponent`) colors that are
    /// not finite or negative and an exponent that is not above 0; (as
    /// `reflectance`, `tint`, `reflect`, `transmit`) shares that are not from 0
    /// to 1; and (as `ior`) an index that is not from 0.01 to 100.
    pub fn checked(self) -> Result<Self, Refused> {
        let lit: [Option<Refusal>; 3] = match self {
            Self::Constant(c) => [color("color", c), None, None],
            Self::Normal | Self::Mirror { .. } | Self::Dielectric { .. } => [None, None, None],
            Self::Lambert { diffuse } => [color("diffuse", diffuse), None, None],
            Self::BlinnPhong { diffuse, specular, exponent }
            | Self::Whitted { diffuse, specular, exponent, .. }
            | Self::Glazed { diffuse, specular, exponent, .. } => [
                color("diffuse", diffuse),
                color("specular", specular),
                length("exponent", exponent),
            ],
        };
        let sent: [Option<Refusal>; 3] = match self {
            Self::Mirror { reflectance, .. } => [share("reflectance", reflectance), None, None],
            Self::Dielectric { ior, tint, .. } => [index("ior", ior), share("tint", tint), None],
            Self::Whitted { reflect, transmit, ior, .. } => {
                [share("reflect", reflect), share("transmit", transmit), index("ior", ior)]
            }
            Self::Glazed { ior, .. } => [index("ior", ior), None, None],
            Self::Constant(_) | Self::Normal | Self::Lambert { .. } | Self::BlinnPhong { .. } => {
                [None, None, None]
            }
        };
        let ([a, b, c], [d, e, f]) = (lit, sent);
        Refused::unless([a, b, c, d, e, f])?;
        Ok(self)
    }

    /// The color that the surface has by itself, before any light: what
    /// "surface color" shows. Of a mirror its reflectance, of glass its tint.
    pub fn surface_color(&self, n: UnitVec) -> Rgb {
        match *self {
            Self::Constant(color) => color,
            Self::Normal => normal_color(n),
            Self::Lambert { diffuse }
            | Self::BlinnPhong { diffuse, .. }
            | Self::Whitted { diffuse, .. }
            | Self::Glazed { diffuse, .. } => diffuse,
            Self::Mirror { reflectance, .. } => reflectance,
            Self::Dielectric { tint, .. } => tint,
        }
    }

    /// The color of a surface that light does not change; `None` for one that
    /// must be lit.
    pub(crate) fn unlit(&self, n: UnitVec) -> Option<Rgb> {
        match self {
            Self::Constant(_) | Self::Normal => Some(self.surface_color(n)),
            _ => None,
        }
    }

    /// Whether what it shows is seen along further rays.
    pub(crate) fn sends_rays(&self) -> bool {
        match self {
            Self::Mirror { .. }
            | Self::Dielectric { .. }
            | Self::Whitted { .. }
            | Self::Glazed { .. } => true,
            Self::Constant(_) | Self::Normal | Self::Lambert { .. } | Self::BlinnPhong { .. } => {
                false
            }
        }
    }

    /// The share of the light from `l` that goes towards `v`, the lecture's
    /// shading inputs being the eye direction `v`, the light direction `l`,
    /// the normal `n` and the surface's parameters. All three point away from
    /// the surface.
    ///
    /// - Lambert's cosine law: `k_d max(n.l, 0)`, by the lecture's slides
    ///   "Diffuse reflection";
    /// - Blinn-Phong adds `k_s max(n.h, 0)^p` with `h = normalize(l + v)`.
    ///
    /// The radiometric convention divides `k_d` by pi and multiplies the
    /// highlight by the cosine as well. Zero for unlit materials; of those that
    /// send rays on, what they show of lights.
    pub fn reflect(&self, convention: Convention, n: UnitVec, l: UnitVec, v: UnitVec) -> Rgb {
        self.reflect_metered((convention, Skipping::On), (n, l, v), &Unmetered)
    }

    /// [`Material::reflect`], counted. A black highlight is not computed if
    /// what changes nothing is skipped.
    pub(crate) fn reflect_metered(
        &self,
        (convention, skipping): (Convention, Skipping),
        (n, l, v): (UnitVec, UnitVec, UnitVec),
        meter: &impl Meter,
    ) -> Rgb {
        let cosine = cosine(n, l, v);
        let lambert = |k_d: Rgb| match convention {
            Convention::Classic | Convention::Attenuated => k_d * cosine,
            Convention::Radiometric if seeded(Fault::PiForgotten) => k_d * cosine,
            Convention::Radiometric => k_d * (1.0 / std::f64::consts::PI) * cosine,
        };
        match *self {
            Self::Constant(_) | Self::Normal | Self::Mirror { .. } | Self::Dielectric { .. } => {
                Rgb::BLACK
            }
            Self::Lambert { diffuse } => lambert(diffuse),
            Self::BlinnPhong { diffuse, .. }
            | Self::Whitted { diffuse, .. }
            | Self::Glazed { diffuse, .. }
                if skipping == Skipping::On && !self.has_highlight() =>
            {
                lambert(diffuse)
            }
            Self::BlinnPhong { diffuse, specular, exponent }
            | Self::Whitted { diffuse, specular, exponent, .. }
            | Self::Glazed { diffuse, specular, exponent, .. } => {
                meter.count(Event::HalfVector);
                // Light straight through the surface towards the eye has no
                // half vector, and no highlight.
                let less = if seeded(Fault::ExponentOffByOne) { 1.0 } else { 0.0 };
                let highlight = half_vector(n, l, v)
                    .map_or(0.0, |h| pow(n.dot(*h).clamp(0.0, 1.0), exponent - less));
                let highlight = match convention {
                    _ if seeded(Fault::HighlightWithoutCosine) => highlight,
                    Convention::Classic | Convention::Attenuated => highlight,
                    Convention::Radiometric => highlight * cosine,
                };
                let is_diffuse = seeded(Fault::HighlightColorDiffuse);
                let color = if is_diffuse { diffuse } else { specular };
                lambert(diffuse) + color * highlight
            }
        }
    }
}

/// `max(n.l, 0)`, or what a fault makes of it.
fn cosine(n: UnitVec, l: UnitVec, v: UnitVec) -> f64 {
    let cosine = n.dot(if seeded(Fault::CosineOfTheEye) { *v } else { *l });
    if seeded(Fault::CosineNotClamped) {
        return cosine;
    }
    if seeded(Fault::CosineTwoSided) { cosine.abs() } else { cosine.max(0.0) }
}

/// `h = normalize(l + v)`, or what a fault makes of it; `None` where it has no
/// length.
fn half_vector(n: UnitVec, l: UnitVec, v: UnitVec) -> Option<UnitVec> {
    if seeded(Fault::HalfVectorNotNormalized) {
        return Some(UnitVec::wrongly(*l + *v));
    }
    if seeded(Fault::HighlightOfPhong) {
        // Its cosine with the normal is that of the eye with the mirrored ray.
        let mirrored = 2.0 * n.dot(*l) * *n - *l;
        return Some(UnitVec::wrongly(mirrored.dot(*v) * *n));
    }
    UnitVec::new(*l + *v)
}

/// The assignment's normal shader: `(n + 1) / 2` in each channel.
pub(crate) fn normal_color(n: UnitVec) -> Rgb {
    if seeded(Fault::NormalsNotMoved) {
        return Rgb::new(n.x, n.y, n.z);
    }
    Rgb::new(0.5 * (n.x + 1.0), 0.5 * (n.y + 1.0), 0.5 * (n.z + 1.0))
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use glam::dvec3;

    use super::*;

    const RED: Rgb = Rgb::new(0.8, 0.0, 0.0);
    const ALL: [Convention; 3] =
        [Convention::Classic, Convention::Attenuated, Convention::Radiometric];

    fn at_60_degrees() -> UnitVec {
        UnitVec::new(dvec3(3.0_f64.sqrt(), 0.0, 1.0)).unwrap()
    }

    #[test]
    fn lamberts_cosine_law() {
        let material = Material::Lambert { diffuse: RED };
        let red = |l| ALL.map(|c| material.reflect(c, UnitVec::Z, l, UnitVec::Z).r);
        let close = |found: [f64; 3], expected: [f64; 3]| {
            found.iter().zip(expected).all(|(f, e)| (f - e).abs() < 1e-15)
        };
        assert!(close(red(UnitVec::Z), [0.8, 0.8, 0.8 / PI]));
        // The slide's cube, turned by 60 degrees, intercepts half the light.
        assert!(close(red(at_60_degrees()), [0.4, 0.4, 0.4 / PI]));
        assert!(close(red(UnitVec::X), [0.0; 3]));
        assert!(close(red(-UnitVec::Z), [0.0; 3]));
    }

    #[test]
    fn the_highlight_is_about_the_half_vector() {
        let material =
            Material::BlinnPhong { diffuse: Rgb::BLACK, specular: Rgb::WHITE, exponent: 2.0 };
        let red = |l, v| ALL.map(|c| material.reflect(c, UnitVec::Z, l, v).r);
        assert_eq!(red(UnitVec::Z, UnitVec::Z), [1.0; 3]);
        // h at 30 degrees: cos^2 = 3/4; the cosine of the light is 1/2.
        let found = red(at_60_degrees(), UnitVec::Z);
        let expected = [0.75, 0.75, 0.375];
        assert!(found.iter().zip(expected).all(|(f, e)| (f - e).abs() < 1e-15), "{found:?}");
        // Light from below the horizon: only the radiometric one is dark.
        let below = UnitVec::new(dvec3(1.0, 0.0, -0.1)).unwrap();
        let [classic, attenuated, radiometric] = red(below, UnitVec::Z);
        assert!(classic > 0.0 && attenuated > 0.0 && radiometric == 0.0);
        assert_eq!(red(-UnitVec::Z, UnitVec::Z), [0.0; 3], "no half vector");
    }

    #[test]
    fn bad_materials_are_refused() {
        let bad = Material::BlinnPhong {
            diffuse: Rgb::new(-0.1, 0.0, 0.0),
            specular: Rgb::new(0.0, f64::NAN, 0.0),
            exponent: 0.0,
        };
        assert_eq!(bad.checked().unwrap_err().refusals().len(), 3);
        assert!(Material::Constant(Rgb::new(0.0, 0.0, f64::INFINITY)).checked().is_err());
        assert!(Material::Lambert { diffuse: Rgb::new(7.0, 0.0, 0.0) }.checked().is_ok());
    }
}
