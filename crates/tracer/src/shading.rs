//! `Convention`: the three ways in which the course has shaded its pictures,
//! and the light that reaches a hit.

use std::cell::Cell;

use crate::fault::{Fault, seeded};
use crate::light::{Falloff, Kind};
use crate::meter::{Event, Meter, Work};
use crate::{Group, Hit, Interval, Light, Ray, Rgb, UnitVec};

/// Which shading formulas a scene means. They differ in the light's falloff,
/// the factor 1/pi, the highlight's cosine, and where shadow rays start.
///
/// | | classic | attenuated | radiometric |
/// |---|---|---|---|
/// | years | 2011-2013 | 2015, 2017 | 2018, 2019 |
/// | point light falloff, unless it says | none | `1/r^2` | `1/r^2` |
/// | Lambert | `k_d max(n.l,0)` | the same | `k_d/pi max(n.l,0)` |
/// | Blinn-Phong adds | `k_s max(n.h,0)^p` | the same | times `max(n.l,0)` |
/// | shadow ray from | the surface | distance 1e-6 | distance 1e-3 |
/// | a light seen from behind the normal | counts | counts | gives 0 |
///
/// Source: the assignment "Ray 1" of Cornell CS4620 in these years; measured
/// against its reference pictures.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Convention {
    /// The lecture's: what a scene gets that says nothing.
    #[default]
    Classic,
    /// Classic with `1/r^2`.
    Attenuated,
    /// Physical units: a light's intensity in watts per steradian gives
    /// radiance.
    Radiometric,
}

impl Convention {
    /// What a point light does that does not say.
    pub fn default_falloff(self) -> Falloff {
        match self {
            Self::Classic => Falloff::Constant,
            Self::Attenuated | Self::Radiometric => Falloff::InverseSquare,
        }
    }

    /// The diffuse color of a surface that does not say.
    pub fn default_diffuse(self) -> Rgb {
        match self {
            Self::Classic | Self::Attenuated => Rgb::WHITE,
            Self::Radiometric => Rgb::new(0.2, 0.2, 0.2),
        }
    }

    /// The distance from the surface within which nothing casts a shadow.
    ///
    /// Classic has none: its shadow rays start off the surface by no more than
    /// its rounding error. The later assignments skipped a fixed distance, and
    /// their pictures show it where objects touch.
    fn shadow_gap(self) -> f64 {
        match self {
            Self::Classic => 0.0,
            Self::Attenuated => 1e-6,
            Self::Radiometric => 1e-3,
        }
    }
}

/// What shading needs of a scene.
pub(crate) struct Lighting<'a> {
    pub(crate) world: &'a Group,
    pub(crate) lights: &'a [Light],
    pub(crate) convention: Convention,
    pub(crate) shadows: bool,
}

/// A light seen from a hit.
struct Incident {
    /// Towards the light.
    l: UnitVec,
    intensity: Rgb,
    /// From the hit to the light, and where on it the light is.
    shadow_ray: Ray,
    range: Interval,
}

impl Lighting<'_> {
    /// The light that leaves the hit against `ray`, and a bit for each of the
    /// lights that something is in the way of.
    pub(crate) fn shade(&self, ray: &Ray, hit: &Hit, work: &Work<impl Meter>) -> (Rgb, u64) {
        let n = hit.shading_normal;
        let unlit = hit.material.unlit(n);
        match (unlit, work.skips()) {
            (Some(color), true) => (color, 0),
            (unlit, _) => {
                let lit = self.radiance(ray, hit, work);
                unlit.map_or(lit, |color| (color, 0))
            }
        }
    }

    /// The light of all lights that leaves a lit surface against `ray`, and a
    /// bit for each that something is in the way of.
    pub(crate) fn radiance(&self, ray: &Ray, hit: &Hit, work: &Work<impl Meter>) -> (Rgb, u64) {
        work.count(Event::ShadedHit);
        let skips = work.skips();
        let n = hit.shading_normal;
        // A hit has a direction, and a direction a length.
        let v = UnitVec::new(-ray.direction).unwrap_or(UnitVec::Z);
        let turned_away = n.dot(*v) <= 0.0;
        let (mut radiance, mut shadows) = (Rgb::BLACK, 0);
        let shadows_are_cast = self.shadows && !seeded(Fault::ShadowRayDropped);
        let lost = usize::from(seeded(Fault::LastLightLost)).min(self.lights.len());
        let lights = &self.lights[..self.lights.len() - lost];
        for (number, light) in lights.iter().enumerate() {
            let is_dark = light.intensity() == Rgb::BLACK;
            if is_dark && skips {
                continue;
            }
            if let Kind::Ambient { intensity } = light.0 {
                if seeded(Fault::AmbientLost) {
                    continue;
                }
                radiance += hit.material.surface_color(n) * intensity;
                continue;
            }
            let matters = self.convention == Convention::Radiometric;
            if turned_away && matters && !seeded(Fault::TurnedAwayIgnored) {
                continue;
            }
            let Some(incident) = self.incident(light, hit) else {
                continue;
            };
            let share = hit.material.reflect_metered(
                (self.convention, work.skipping),
                (n, incident.l, v),
                &work.meter,
            );
            let adds = share != Rgb::BLACK && !is_dark;
            if skips && !(adds && shadows_are_cast) {
                work.count(Event::SkippedShadowRay);
            } else {
                work.count(Event::ShadowRay);
                let Incident { shadow_ray, range, .. } = &incident;
                let last = work.occluders.get(number).filter(|_| skips);
                let first = last.and_then(Cell::get);
                let occluder = if first.is_some() && seeded(Fault::ShadowCacheTrusted) {
                    first
                } else {
                    self.world.occluder(shadow_ray, *range, first, &work.meter)
                };
                if let Some(last) = last {
                    last.set(occluder);
                }
                if occluder.is_some() && shadows_are_cast {
                    if adds {
                        shadows |= 1_u64.checked_shl(number as u32).unwrap_or(0);
                    }
                    continue;
                }
            }
            if adds || !skips {
                radiance += share * incident.intensity;
            }
        }
        let dimmed = if seeded(Fault::LightDimmed) { radiance * 0.98 } else { radiance };
        (dimmed, shadows)
    }

    /// The light as the hit sees it; `None` where it is at the very point,
    /// and for light without a direction.
    fn incident(&self, light: &Light, hit: &Hit) -> Option<Incident> {
        let gap = self.convention.shadow_gap();
        match light.0 {
            Kind::Point { position, intensity, falloff } => {
                let to_light = position - hit.point;
                let r = to_light.length();
                let l = UnitVec::new(to_light)?;
                let intensity = colored(intensity);
                let intensity = match falloff {
                    _ if seeded(Fault::FalloffMissing) => intensity,
                    Falloff::Constant => intensity,
                    Falloff::InverseSquare if seeded(Fault::FalloffLinear) => intensity * (1.0 / r),
                    Falloff::InverseSquare => intensity * (1.0 / (r * r)),
                };
                let shadow_ray = hit.leaving_to(position);
                // The ray ends at the light at t = 1.
                let end = if seeded(Fault::ShadowRayUnlimited) { f64::INFINITY } else { 1.0 };
                Some(Incident { l, intensity, shadow_ray, range: Interval::new(gap / r, end) })
            }
            Kind::Directional { to_light, intensity } => Some(Incident {
                l: to_light,
                intensity: colored(intensity),
                shadow_ray: hit.leaving(*to_light),
                range: Interval::new(gap, f64::INFINITY),
            }),
            Kind::Ambient { .. } => None,
        }
    }
}

/// The color of a light, or what a fault makes of it.
fn colored(intensity: Rgb) -> Rgb {
    if seeded(Fault::LightColorLost) { Rgb::WHITE * intensity.g } else { intensity }
}
