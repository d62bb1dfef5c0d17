//! `Look`: how a surface looks, with all that a material leaves open filled in;
//! `Way`: where it sends rays on.

use scene::format::{Material, Shading, Show, Triple};
use tracer::Convention;

use super::Lamp;
use crate::Feature;
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
        let is_textured = material.is_some_and(|material| material.texture().is_some());
        let filled = |diffuse: &Option<Triple>| match diffuse {
            Some(diffuse) => *diffuse,
            None if is_textured => [1.0; 3],
            None => convention.default_diffuse().channels(),
        };
        let lit = |diffuse: &Option<Triple>, specular: &Triple, exponent: f64| {
            let highlight = (*specular != [0.0; 3]).then_some((*specular, exponent));
            Self::Lit { diffuse: filled(diffuse), highlight }
        };
        match material {
            Some(Material::Constant { color, .. }) => Self::Constant(*color),
            Some(Material::Normal) => Self::Normal(1.0),
            Some(Material::Lambert { diffuse, .. }) => lit(diffuse, &[0.0; 3], 1.0),
            Some(
                Material::BlinnPhong { diffuse, specular, exponent, .. }
                | Material::Whitted { diffuse, specular, exponent, .. }
                | Material::Glazed { diffuse, specular, exponent, .. },
            ) => lit(diffuse, specular, *exponent),
            // The colors that they have by themselves.
            Some(Material::Mirror { reflectance, .. }) => Self::Constant(*reflectance),
            Some(Material::Dielectric { tint, .. }) => Self::Constant(*tint),
            // A name that leads nowhere is a problem that was told before.
            None | Some(Material::Named(_)) => lit(&None, &[0.0; 3], 1.0),
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

/// How a surface sends rays on, and so shows what they see.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::export) enum Way {
    /// This and nothing else.
    Mirror { reflectance: Triple, schlick: bool },
    /// This and nothing else.
    Glass { ior: f64, tint: Triple, schlick: bool },
    /// Beside its own light.
    Sum { reflect: Triple, transmit: Triple, ior: f64, schlick: bool },
    /// Over its own light, from outside.
    Glaze { ior: f64, schlick: bool },
}

impl Way {
    /// That of a material which is not a name; none for one that sends no rays on.
    pub(super) fn of(material: &Material) -> Option<Self> {
        match *material {
            Material::Mirror { reflectance, schlick } => {
                Some(Self::Mirror { reflectance, schlick })
            }
            Material::Dielectric { ior, tint, schlick } => Some(Self::Glass { ior, tint, schlick }),
            Material::Whitted { reflect, transmit, ior, schlick, .. } => {
                Some(Self::Sum { reflect, transmit, ior, schlick })
            }
            Material::Glazed { ior, schlick, .. } => Some(Self::Glaze { ior, schlick }),
            Material::Named(_)
            | Material::Constant { .. }
            | Material::Normal
            | Material::Lambert { .. }
            | Material::BlinnPhong { .. } => None,
        }
    }

    /// Whether the surface shows light of its own beside.
    pub(super) fn is_lit(self) -> bool {
        matches!(self, Self::Sum { .. } | Self::Glaze { .. })
    }

    /// Whether rays go through. Light does not in goldray: eye rays do, and those that
    /// are sent on.
    pub(in crate::export) fn is_clear(self) -> bool {
        match self {
            Self::Glass { .. } => true,
            Self::Sum { transmit, .. } => transmit != [0.0; 3],
            Self::Mirror { .. } | Self::Glaze { .. } => false,
        }
    }

    /// The index of refraction of what is inside, where the picture depends on it: it
    /// bends rays, or says how much is reflected.
    pub(in crate::export) fn index(self) -> Option<f64> {
        match self {
            Self::Glass { ior, .. } | Self::Glaze { ior, schlick: false } => Some(ior),
            Self::Sum { ior, .. } if self.is_clear() => Some(ior),
            Self::Mirror { .. } | Self::Sum { .. } | Self::Glaze { .. } => None,
        }
    }

    /// What it asks for.
    pub(super) fn asks(self) -> Vec<Feature> {
        let (feature, schlick) = match self {
            Self::Mirror { schlick, .. } => (Feature::Mirror, schlick),
            Self::Glass { schlick, .. } => (Feature::Dielectric, schlick),
            Self::Sum { schlick, .. } => (Feature::Whitted, schlick),
            Self::Glaze { schlick, .. } => (Feature::Glazed, schlick),
        };
        [Some(feature), schlick.then_some(Feature::Schlick)].into_iter().flatten().collect()
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
