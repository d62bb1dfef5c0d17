//! `Parts`: what a surface's color is made of, for one ray.

use glam::DVec3;

use super::Part;
use super::optics::{Refraction, fresnel, reflect, refract, schlick, straight_on};
use crate::fault::{Fault, seeded};
use crate::{Hit, Material, Ray, Rgb, UnitVec};

/// What is lit, reflected and refracted of a color.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Parts {
    /// Whether the ray comes from behind the surface.
    pub(super) leaves: bool,
    /// The share of its own light that a surface shows, if it is lit.
    pub(super) lit: Option<f64>,
    /// What it shows of what is before it.
    pub(super) reflected: Part,
    /// What it shows of what is behind it.
    pub(super) refracted: Part,
}

impl Parts {
    /// Those of a hit, which is seen along `ray`; none of a material that sends
    /// no rays on.
    pub(super) fn of(ray: &Ray, hit: &Hit) -> Self {
        let nothing = Self { leaves: false, lit: None, reflected: None, refracted: None };
        let white = |share: f64| Rgb::WHITE * share;
        match hit.material {
            Material::Mirror { reflectance, schlick } => {
                let meeting = Meeting::of(ray, hit, 1.0);
                let share = meeting.grown(reflectance, schlick);
                Self {
                    leaves: meeting.leaves,
                    reflected: Some((meeting.reflected, share)),
                    ..nothing
                }
            }
            Material::Dielectric { ior, tint, schlick } => {
                let meeting = Meeting::of(ray, hit, ior);
                let r = meeting.reflectance(schlick);
                let is_tinted = seeded(Fault::TintOfReflection);
                let share = if is_tinted { tint * r } else { white(r) };
                let refracted = meeting.refracted.map(|way| (way.direction, tint * (1.0 - r)));
                if meeting.refracted.is_none() && seeded(Fault::TotalReflectionIgnored) {
                    return nothing;
                }
                Self {
                    leaves: meeting.leaves,
                    reflected: Some((meeting.reflected, share)),
                    refracted,
                    ..nothing
                }
            }
            Material::Whitted { reflect, transmit, ior, schlick, .. } => {
                let meeting = Meeting::of(ray, hit, ior);
                let share = meeting.grown(reflect, schlick);
                let (share, refracted) = match meeting.refracted {
                    Some(way) => (share, Some((way.direction, transmit))),
                    None if seeded(Fault::TotalReflectionIgnored) => (share, None),
                    // What cannot go through goes the way of the reflection.
                    None => (share + transmit, None),
                };
                Self {
                    leaves: meeting.leaves,
                    lit: Some(1.0),
                    reflected: Some((meeting.reflected, share)),
                    refracted,
                }
            }
            Material::Glazed { ior, schlick, .. } => {
                let meeting = Meeting::of(ray, hit, ior);
                // The glaze is on the outside.
                let r = if meeting.leaves { 0.0 } else { meeting.reflectance(schlick) };
                let reflected = Some((meeting.reflected, white(r)));
                Self { leaves: meeting.leaves, lit: Some(1.0 - r), reflected, ..nothing }
            }
            Material::Constant(_)
            | Material::Normal
            | Material::Lambert { .. }
            | Material::BlinnPhong { .. } => nothing,
        }
    }
}

impl Parts {
    /// What is reflected and what is refracted, each with whether its ray leaves on
    /// the outside.
    pub(super) fn ways(&self) -> [(Part, bool); 2] {
        [(self.reflected, !self.leaves), (self.refracted, self.leaves)]
    }
}

/// How a ray meets a surface between two media.
#[derive(Debug, Clone, Copy)]
struct Meeting {
    /// Whether it comes from behind.
    leaves: bool,
    /// The index of refraction beyond, relative to that before the surface.
    ior: f64,
    /// The cosine of the ray's angle with the normal, not negative.
    cosine: f64,
    /// The direction that a mirror sends it.
    reflected: DVec3,
    /// How it goes on beyond; `None` is total internal reflection.
    refracted: Option<Refraction>,
}

impl Meeting {
    /// `ior` is that of the inside, relative to the outside.
    fn of(ray: &Ray, hit: &Hit, ior: f64) -> Self {
        // A hit has a direction, and a direction a length.
        let d = UnitVec::new(ray.direction).unwrap_or(UnitVec::Z);
        let outward = hit.geometric_normal;
        let leaves = outward.dot(*d) > 0.0;
        let ior = if leaves && !seeded(Fault::IndexNotInverted) { 1.0 / ior } else { ior };
        let (true_normal, bent) =
            if leaves { (-outward, -hit.shading_normal) } else { (outward, hit.shading_normal) };
        let bent = if seeded(Fault::ReflectionFaceted) { true_normal } else { bent };
        let about =
            |n: UnitVec| Self::about(*d, n, ior, leaves).filter(|it| it.keeps_to(true_normal));
        about(bent).unwrap_or_else(|| Self::at(*d, true_normal, ior, leaves))
    }

    /// About a normal that is on the side that the ray comes from.
    fn about(d: DVec3, n: UnitVec, ior: f64, leaves: bool) -> Option<Self> {
        (-n.dot(d) > 0.0).then(|| Self::at(d, n, ior, leaves))
    }

    fn at(d: DVec3, n: UnitVec, ior: f64, leaves: bool) -> Self {
        let (reflected, refracted) = (reflect(d, n), refract(d, n, ior));
        Self { leaves, ior, cosine: -n.dot(d), reflected, refracted }
    }

    /// Whether both ways are on their sides of the true surface.
    fn keeps_to(&self, true_normal: UnitVec) -> bool {
        let reflects = true_normal.dot(self.reflected) > 0.0;
        reflects && self.refracted.is_none_or(|way| true_normal.dot(way.direction) < 0.0)
    }

    /// The share that is reflected between the media.
    fn reflectance(&self, is_schlick: bool) -> f64 {
        let Some(way) = self.refracted else { return 1.0 };
        if seeded(Fault::FresnelForgotten) {
            return straight_on(self.ior);
        }
        if is_schlick {
            // Of the two angles the one in the thinner medium, as the share
            // must be 1 where total reflection begins.
            let cosine = if self.ior < 1.0 { way.cosine } else { self.cosine };
            return schlick(straight_on(self.ior), cosine);
        }
        fresnel(self.ior, self.cosine, way.cosine)
    }

    /// A mirror's reflectance straight on, grown by Schlick's law if it does.
    fn grown(&self, straight_on: Rgb, is_schlick: bool) -> Rgb {
        if !is_schlick || seeded(Fault::SchlickForgotten) {
            return straight_on;
        }
        Rgb::from(straight_on.channels().map(|r0| schlick(r0, self.cosine)))
    }
}
