//! `Chain`: transforms one inside the other, made from one number, and what
//! they do exactly.
//!
//! A case has room for a ray and a seed, not for four matrices: the seed
//! stands for them. A kept case means the same as long as [`Random`] draws the
//! same numbers from a seed.

use tracer::accel::Build;
use tracer::glam::{DAffine3, DMat3, DVec3};
use tracer::shape::Shape;
use tracer::{Group, Material, Member, Object, Transform};

use crate::Random;
use crate::number::{Dd, Number, V3};
use crate::truth::UNIT_ROUNDOFF;

/// The most transforms in one another.
pub(super) const DEEPEST: usize = 4;

/// What the chains of a family may do.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Limits {
    /// The size of the object in the world is at most this, and at least one
    /// over this; so is the scale of each transform.
    pub(super) scale: f64,
    /// The largest translation, in the world's units.
    pub(super) translation: f64,
    /// The same, in sizes of the object: beyond 2^53 of them it has no shape.
    pub(super) sizes: f64,
}

/// A number that stands for a chain.
pub(super) fn seed(random: &mut Random) -> f64 {
    /// Exact in an `f64`.
    const SEEDS: f64 = 4_294_967_296.0;
    (random.unit() * SEEDS).floor()
}

/// Transforms, the innermost first.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Chain {
    maps: Vec<DAffine3>,
}

impl Chain {
    /// The chain that a seed stands for: 1 to 4 rotations with a scale, half of
    /// them mirrored, half of them stretched and sheared, and a translation.
    pub(super) fn of_seed(seed: f64, limits: Limits) -> Self {
        let mut random = Random::of_chunk(seed as u64, "chain", 0);
        let depth = 1 + random.below(DEEPEST);
        let mut scales: Vec<f64> = Vec::with_capacity(depth);
        let mut size = 1.0;
        for _ in 0..depth {
            // So that the product stays within the limits as well.
            let lo = (1.0 / (limits.scale * size)).max(1.0 / limits.scale);
            let hi = (limits.scale / size).min(limits.scale);
            let scale = random.decades(lo, hi);
            size *= scale;
            scales.push(scale);
        }
        let farthest = limits.translation.min(limits.sizes * size);
        let mut maps = Vec::with_capacity(depth);
        // The size of a unit of the parent, seen from the world.
        let mut unit = size;
        for scale in scales {
            unit /= scale;
            let far = random.decades(farthest * 1e-6, farthest) / unit;
            maps.push(DAffine3 {
                matrix3: linear(&mut random) * scale,
                translation: far * random.direction(),
            });
        }
        Self { maps }
    }

    /// One transform of a large condition: a scale of 1e-6 to 1 along any
    /// direction, between two rotations.
    pub(super) fn stretched(seed: f64) -> Self {
        let mut random = Random::of_chunk(seed as u64, "stretched", 0);
        let mut turn = || {
            let x = random.direction();
            let y = random.across(x);
            DMat3::from_cols(x, y, x.cross(y))
        };
        let (first, then) = (turn(), turn());
        let scale = DMat3::from_diagonal(DVec3::new(1.0, 1.0, random.decades(1e-6, 1.0)));
        Self { maps: vec![DAffine3 { matrix3: then * scale * first, translation: DVec3::ZERO }] }
    }

    /// The shape inside all transforms; `None` if one is refused.
    pub(super) fn group(&self, shape: Shape) -> Option<Group> {
        let object = Member::Object(Object::new(shape, Material::Normal));
        let wrap = |inner: Member, &map: &DAffine3| {
            let group = Group::new(Transform::new(map).ok()?, vec![inner], Build::Bvh);
            Some(Member::Group(group))
        };
        match self.maps.iter().try_fold(object, wrap)? {
            Member::Group(group) => Some(group),
            object @ Member::Object(_) => Some(Group::world(vec![object])),
        }
    }

    /// The whole map, as products of `f64`s.
    pub(super) fn product(&self) -> DAffine3 {
        self.maps.iter().fold(DAffine3::IDENTITY, |inner, &outer| outer * inner)
    }

    /// The whole map and its inverse.
    pub(super) fn exact(&self) -> Exact {
        let mut columns = [DVec3::X, DVec3::Y, DVec3::Z].map(V3::<Dd>::of);
        let mut translation = V3::of(DVec3::ZERO);
        let (mut reach, mut inner_reach) = (0.0, 0.0);
        for map in &self.maps {
            let m = map.matrix3;
            let outer = [m.x_axis, m.y_axis, m.z_axis].map(V3::of);
            columns = columns.map(|column| along(&outer, &column));
            translation = along(&outer, &translation) + V3::of(map.translation);
            // What was inside is stretched with it.
            inner_reach = norm(&outer) * reach;
            reach = inner_reach + map.translation.length();
        }
        let [x, y, z] = columns;
        let volume = Dd::one() / x.dot(&y.cross(&z));
        let rows = [y.cross(&z), z.cross(&x), x.cross(&y)].map(|row| row.scale(&volume));
        let (stretch, shrink) = (norm(&columns), norm(&rows));
        Exact { columns, rows, translation, stretch, shrink, reach, inner_reach }
    }
}

/// A rotation, mirrored, sheared and stretched or not, with a condition of at
/// most about 10.
fn linear(random: &mut Random) -> DMat3 {
    let x = random.direction();
    let y = random.across(x);
    let turn = DMat3::from_cols(x, y, x.cross(y) * random.sign());
    if random.coin() {
        return turn;
    }
    let shear = random.point() * 0.5;
    let stretch = DVec3::new(random.between(1.0, 2.0), random.between(1.0, 2.0), 1.0);
    let bend = DMat3::from_cols(
        DVec3::X,
        DVec3::new(shear.x, 1.0, 0.0),
        DVec3::new(shear.y, shear.z, 1.0),
    );
    turn * bend * DMat3::from_diagonal(stretch)
}

/// A chain's map between the object's space and the world, in [`Dd`].
#[derive(Debug, Clone, Copy)]
pub(super) struct Exact {
    columns: [V3<Dd>; 3],
    rows: [V3<Dd>; 3],
    translation: V3<Dd>,
    /// An upper bound of how much the map lengthens, within a factor of
    /// sqrt(3): the object's size in the world over that in its own space.
    pub(super) stretch: f64,
    /// The same of the inverse.
    shrink: f64,
    /// The sum of all translations' lengths, each as the world sees it.
    pub(super) reach: f64,
    /// The same without the outermost translation, which a ray that goes in
    /// is rid of by one subtraction before anything else is rounded.
    inner_reach: f64,
}

impl Exact {
    /// What changes nothing, and rounds nothing.
    pub(super) fn identity() -> Self {
        let columns = [DVec3::X, DVec3::Y, DVec3::Z].map(V3::of);
        let translation = V3::of(DVec3::ZERO);
        Self {
            columns,
            rows: columns,
            translation,
            stretch: 1.0,
            shrink: 0.0,
            reach: 0.0,
            inner_reach: 0.0,
        }
    }

    /// A point of the world, in the object's space.
    pub(super) fn object_point(&self, p: &V3<Dd>) -> V3<Dd> {
        self.object_vector(&(*p - self.translation))
    }

    /// A direction of the world, in the object's space.
    pub(super) fn object_vector(&self, d: &V3<Dd>) -> V3<Dd> {
        V3::new(self.rows[0].dot(d), self.rows[1].dot(d), self.rows[2].dot(d))
    }

    /// A point of the object, in the world.
    pub(super) fn world_point(&self, p: &V3<Dd>) -> V3<Dd> {
        along(&self.columns, p) + self.translation
    }

    /// The length in the world of the gradient of a function that has this
    /// gradient in the object's space.
    pub(super) fn gradient_length(&self, gradient: DVec3) -> f64 {
        let rows = self.rows.map(|row| row.to_f64());
        (rows[0] * gradient.x + rows[1] * gradient.y + rows[2] * gradient.z).length()
    }

    /// How far the translations inside others move a point of the object's
    /// space when they are rounded once.
    pub(super) fn inner_rounding(&self) -> f64 {
        UNIT_ROUNDOFF * self.shrink * self.inner_reach
    }

    /// How far a point at distance `from_object` (in the object's space) of
    /// the object moves there when what it comes from is rounded once: the
    /// world's coordinates, the translations and the matrices.
    pub(super) fn rounding(&self, world: DVec3, from_object: f64) -> f64 {
        let of_places = self.shrink * (self.reach + world.length());
        UNIT_ROUNDOFF * (of_places + self.shrink * self.stretch * from_object)
    }
}

/// `sum columns[k] v[k]`.
fn along(columns: &[V3<Dd>; 3], v: &V3<Dd>) -> V3<Dd> {
    columns[0].scale(&v.x) + columns[1].scale(&v.y) + columns[2].scale(&v.z)
}

/// The Frobenius norm.
fn norm(columns: &[V3<Dd>; 3]) -> f64 {
    columns.iter().map(|column| column.to_f64().length_squared()).sum::<f64>().sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_exact_inverse_undoes_the_map_and_agrees_with_the_tracers() {
        let limits = Limits { scale: 1e6, translation: 1e8, sizes: 1e9 };
        let mut random = Random::of_chunk(0, "chains", 0);
        let mut deepest = 0;
        for _ in 0..1_000 {
            let chain = Chain::of_seed(seed(&mut random), limits);
            deepest = deepest.max(chain.maps.len());
            let exact = chain.exact();
            let p = V3::<Dd>::of(random.point());
            let back = exact.object_point(&exact.world_point(&p)) - p;
            assert!(back.to_f64().length() < 1e-20, "{back:?}");
            let there = exact.world_point(&p).to_f64();
            let product = chain.product().transform_point3(p.to_f64());
            let size = exact.stretch + exact.reach;
            assert!((there - product).length() < 1e-14 * size);
            assert!(exact.stretch > 1e-7 && exact.stretch < 1e9);
        }
        assert_eq!(deepest, DEEPEST);
    }
}
