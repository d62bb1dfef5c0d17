//! `Show`: what the picture is of, from "image so far" to full shading.

use crate::fault::{Fault, seeded};
use crate::material::normal_color;
use crate::{Hit, Ray, Rgb};

/// What a pixel shows where its ray hits something. A miss is the background
/// in every case.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Show {
    /// Materials, lights and shadows.
    #[default]
    Shaded,
    /// White: the lecture's first "image so far".
    Silhouette,
    /// The surface's own color, unlit: its second.
    SurfaceColor,
    /// The shading normal as `(n + 1) / 2`.
    Normals,
    /// The distance from the ray's origin: white at `near` or closer, black at
    /// `far` or beyond, linear between.
    Depth {
        /// The distance that is white.
        near: f64,
        /// The distance that is black; larger than `near`.
        far: f64,
    },
    /// A color for each object, the same for the same number in any scene.
    ObjectIds,
}

impl Show {
    /// The picture of a hit; `None` where it must be shaded.
    pub(crate) fn color(&self, ray: &Ray, hit: &Hit) -> Option<Rgb> {
        match *self {
            Self::Shaded => None,
            Self::Silhouette => Some(Rgb::WHITE),
            Self::SurfaceColor => Some(hit.material.surface_color(hit.shading_normal)),
            Self::Normals => Some(normal_color(hit.shading_normal)),
            Self::Depth { near, far } => {
                let distance = (hit.point - ray.origin).length();
                let distance = if seeded(Fault::DepthIsT) { hit.t } else { distance };
                Some(Rgb::WHITE * ((far - distance) / (far - near)).clamp(0.0, 1.0))
            }
            Self::ObjectIds => Some(id_color(hit.object.0 + u32::from(seeded(Fault::IdsFromOne)))),
        }
    }
}

/// A color that tells neighboring numbers apart: channels from 0.1 to 1, by
/// the bits of a scrambled number.
///
/// Source: the finalizer of Steele, Lea, Flood, "Fast Splittable Pseudorandom
/// Number Generators", 2014.
pub fn id_color(id: u32) -> Rgb {
    let mut z = (u64::from(id) + 1).wrapping_mul(0x9E37_79B9_7F4A_7C15);
    z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    z ^= z >> 31;
    let channel = |byte: u32| 0.1 + 0.9 * ((z >> (8 * byte) & 0xFF) as f64 / 255.0);
    Rgb::new(channel(0), channel(1), channel(2))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_thousand_objects_have_colors_of_their_own() {
        let mut colors: Vec<_> =
            (0..1_000).map(|id| id_color(id).channels().map(|c| (c * 1e4) as u32)).collect();
        colors.sort_unstable();
        colors.dedup();
        assert_eq!(colors.len(), 1_000);
    }
}
