//! `Survey`: what the middles of all pixels show, and where that will do.

use crate::Rgb;
use crate::scene::Look;

/// The cosine beyond which two normals are alike: about 25 degrees.
const ALIKE: f64 = 0.9;

/// The looks at the middles of all pixels, row 0 at the bottom.
pub(super) struct Survey {
    pub(super) looks: Vec<Vec<Look>>,
}

impl Survey {
    /// The look so many pixels to the right and up, if that is in the picture.
    pub(super) fn beside(&self, at: (u32, u32), way: (i32, i32)) -> Option<&Look> {
        let (i, j) = beside(at, way)?;
        self.looks.get(j as usize)?.get(i as usize)
    }

    /// Whether the look at the pixel's middle will do for all of it: those
    /// around see the same thing, and what they see bends so little that the
    /// mean is off by no more than `allowed`.
    pub(super) fn is_calm(&self, at: (u32, u32), allowed: f64) -> bool {
        let Some(here) = self.beside(at, (0, 0)) else { return true };
        if !ways().filter_map(|way| self.beside(at, way)).all(|look| is_alike(here, look)) {
            return false;
        }
        // The mean of a parabola over a unit is its middle plus 1/24 of its
        // second difference.
        let bend = [(1, 0), (0, 1)].into_iter().map(|(right, up)| {
            let ends = [(right, up), (-right, -up)].map(|way| self.beside(at, way));
            let [Some(one), Some(other)] = ends else { return 0.0 };
            let bend = (one.color + other.color) + here.color * -2.0;
            bend.channels().into_iter().fold(0.0, |most: f64, x| most.max(x.abs()))
        });
        bend.sum::<f64>() <= 24.0 * allowed
    }
}

/// The eight ways to the pixels around one, and the one to itself.
fn ways() -> impl Iterator<Item = (i32, i32)> {
    (0..9).map(|k| (k % 3 - 1, k / 3 - 1))
}

/// The pixel so many to the right and up; it may lie above or right of the
/// picture, but not below or left.
pub(super) fn beside((i, j): (u32, u32), (right, up): (i32, i32)) -> Option<(u32, u32)> {
    Some((i.checked_add_signed(right)?, j.checked_add_signed(up)?))
}

/// Whether both see the same object and part of its texture, from about the same
/// side, in the same shadows, and the same so in mirrors and through glass.
pub(super) fn is_alike(one: &Look, other: &Look) -> bool {
    let same_surface = match (one.surface, other.surface) {
        (None, None) => true,
        (Some((object, n)), Some((other, m))) => object == other && n.dot(*m) > ALIKE,
        _ => false,
    };
    same_surface && one.texel == other.texel && one.shadows == other.shadows
}

/// The largest difference of any channel.
pub(super) fn contrast(one: Rgb, other: Rgb) -> f64 {
    (one + other * -1.0).channels().into_iter().fold(0.0, |most, x| most.max(x.abs()))
}
