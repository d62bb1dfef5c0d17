//! `Trail`: a number for the way that a color came, so that samples can be told
//! apart by what is seen in mirrors and behind glass.
//!
//! Ways by the same objects, from about the same sides and in the same shadows
//! have the same number. Others have the same one by a chance of about 2^-64.

use glam::DVec3;

use crate::scene::Look;

/// The way so far.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Trail(pub(super) u64);

impl Trail {
    /// No light, and no way.
    pub(super) const START: Self = Self(0);
    /// A step by reflection.
    pub(super) const REFLECTED: u64 = 1;
    /// A step by refraction.
    pub(super) const REFRACTED: u64 = 2;

    /// The way with a step to what was seen there.
    #[must_use]
    pub(super) fn and(self, step: u64, seen: &Look) -> Self {
        let surface = seen
            .surface
            .map_or(0, |(object, n)| (u64::from(object.0) + 1) << 8 | u64::from(side(*n)) << 1 | 1);
        [step, surface, seen.shadows].into_iter().fold(self, Self::mixed)
    }

    /// Source: the finalizer of Steele, Lea, Flood, "Fast Splittable Pseudorandom
    /// Number Generators", 2014.
    fn mixed(self, with: u64) -> Self {
        let mut z = (self.0 ^ with).wrapping_add(0x9E37_79B9_7F4A_7C15);
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        Self(z ^ (z >> 31))
    }
}

/// Which of 125 sides a normal looks to. Mirrored normals that look to the same
/// side look to the same side.
fn side(n: DVec3) -> u8 {
    /// Components in five classes; the limits are not those of common normals.
    const CLASSES: f64 = 2.3;
    // The cast rounds towards 0, and so in a mirrored scene as well.
    n.to_array().into_iter().fold(0, |side, x| 5 * side + ((CLASSES * x) as i8 + 2).cast_unsigned())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{ObjectId, Rgb, UnitVec};

    fn look(object: u32, n: UnitVec, shadows: u64) -> Look {
        Look { color: Rgb::BLACK, surface: Some((ObjectId(object), n)), shadows }
    }

    #[test]
    fn ways_differ_by_step_object_side_shadow_and_order() {
        let there = |step, object, n, shadows| Trail::START.and(step, &look(object, n, shadows));
        let near_z = UnitVec::new(glam::dvec3(0.1, -0.1, 1.0)).unwrap();
        let one = there(1, 0, UnitVec::Z, 0);
        assert_eq!(one, there(1, 0, near_z, 0));
        let way = |steps: [u64; 2]| {
            steps.iter().fold(Trail::START, |way, &s| way.and(s, &look(3, UnitVec::X, 0)))
        };
        let mut all = vec![
            one,
            there(2, 0, UnitVec::Z, 0),
            there(1, 1, UnitVec::Z, 0),
            there(1, 0, -UnitVec::Z, 0),
            there(1, 0, UnitVec::X, 0),
            there(1, 0, UnitVec::Z, 1),
            Trail::START.and(1, &Look::nothing(Rgb::BLACK)),
            Trail::START,
            way([1, 2]),
            way([2, 1]),
            way([1, 1]),
        ];
        let count = all.len();
        all.sort_unstable_by_key(|trail| trail.0);
        all.dedup();
        assert_eq!(all.len(), count);
    }

    #[test]
    fn mirrored_normals_differ_where_normals_do() {
        let ring = (0..1000).map(|k| f64::from(k) * 0.0063);
        let sides = |sign: f64| {
            let sides =
                ring.clone().map(|a| side(glam::dvec3(sign * libm::cos(a), libm::sin(a), 0.0)));
            let sides: Vec<_> = sides.collect();
            sides.windows(2).map(|pair| pair[0] == pair[1]).collect::<Vec<_>>()
        };
        assert_eq!(sides(1.0), sides(-1.0));
        assert!(sides(1.0).contains(&false));
    }
}
