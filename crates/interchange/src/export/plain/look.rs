//! `Look`: how a surface looks, with all that a material leaves open filled in.

use scene::format::{Material, Shading, Show, Triple};
use tracer::Convention;

use super::Lamp;
use crate::export::text::{scaled, times};

/// How a surface looks.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::export) enum Look {
    /// This color, lit or not.
    Constant(Triple),
    /// The normal as a color, times a number.
    Normal(f64),
    /// The distance from the ray's origin: white at `near`, black at `far`.
    Depth { near: f64, far: f64 },
    /// Lambert's cosine law, and a highlight if there is one: its strength, above
    /// 0 in some channel, and its exponent.
    Lit { diffuse: Triple, highlight: Option<(Triple, f64)> },
}

impl Look {
    /// That of a material which is not a name.
    pub(super) fn of(material: Option<&Material>, shading: Shading) -> Self {
        let convention = match shading {
            Shading::Classic => Convention::Classic,
            Shading::Attenuated => Convention::Attenuated,
            Shading::Radiometric => Convention::Radiometric,
        };
        let filled = |diffuse: &Option<Triple>| {
            diffuse.unwrap_or_else(|| convention.default_diffuse().channels())
        };
        match material {
            Some(Material::Constant { color, .. }) => Self::Constant(*color),
            Some(Material::Normal) => Self::Normal(1.0),
            Some(Material::Lambert { diffuse, .. }) => {
                Self::Lit { diffuse: filled(diffuse), highlight: None }
            }
            Some(Material::BlinnPhong { diffuse, specular, exponent, .. }) => {
                let highlight = (*specular != [0.0; 3]).then_some((*specular, *exponent));
                Self::Lit { diffuse: filled(diffuse), highlight }
            }
            // A name that leads nowhere is a problem that was told before, and no writer
            // has words for what sends rays on.
            None
            | Some(
                Material::Named(_)
                | Material::Mirror { .. }
                | Material::Dielectric { .. }
                | Material::Whitted { .. }
                | Material::Glazed { .. },
            ) => Self::Lit { diffuse: filled(&None), highlight: None },
        }
    }

    /// What it is in a picture of this kind.
    pub(super) fn plain(self, show: Show, exposure: f64, lamps: &[Lamp], ambient: Triple) -> Self {
        match (show, self) {
            (Show::Silhouette, _) => Self::Constant([1.0; 3]),
            (Show::SurfaceColor, Self::Lit { diffuse, .. }) => Self::Constant(diffuse),
            (Show::Normals, _) => Self::Normal(1.0),
            (Show::Depth { near, far }, _) => Self::Depth { near, far },
            (Show::Shaded, Self::Constant(color)) => Self::Constant(scaled(color, exposure)),
            (Show::Shaded, Self::Normal(by)) => Self::Normal(by * exposure),
            (Show::Shaded, Self::Lit { diffuse, .. }) if lamps.is_empty() => {
                Self::Constant(times(diffuse, ambient))
            }
            (_, look) => look,
        }
    }

    /// Whether light changes it.
    pub(in crate::export) fn is_lit(&self) -> bool {
        matches!(self, Self::Lit { .. })
    }
}

/// The color of a number, in a picture of objects' numbers.
pub(super) fn numbered(number: usize) -> Look {
    let number = u32::try_from(number).unwrap_or(u32::MAX);
    Look::Constant(tracer::id_color(number).channels())
}

/// The largest of a color's channels.
pub(super) fn brightest([r, g, b]: Triple) -> f64 {
    r.max(g).max(b)
}
