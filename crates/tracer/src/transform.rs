//! `Transform`: an invertible affine map between an object's space and its
//! parent's.

use glam::{DAffine3, DMat3, DVec3};

use crate::fault::{Fault, seeded};
use crate::math::{UNIT_ROUNDOFF, max_abs, sin_cos_deg};
use crate::refused::{MAX_LENGTH, refuse_unless, show};
use crate::{Aabb, Hit, Ray, Refused, UnitVec};

/// `x_parent = L x_object + T`, with both directions at hand.
///
/// A ray goes in with its translation subtracted first, so that a small object
/// far from the world's origin keeps its digits; its direction is mapped by
/// the linear part and **not renormalized**, so `t` is the same number on both
/// sides. Normals go out by the inverse transpose.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Transform {
    parent_from_object: DAffine3,
    linear_object_from_parent: DMat3,
}

impl Transform {
    /// Changes nothing.
    pub const IDENTITY: Self =
        Self { parent_from_object: DAffine3::IDENTITY, linear_object_from_parent: DMat3::IDENTITY };

    /// The map `x_parent = L x_object + T`.
    ///
    /// # Errors
    /// Refuses (as `transform`) a map without an inverse, such as a scale by
    /// zero, and numbers in it or its inverse that are too large to compute
    /// with.
    pub fn new(parent_from_object: DAffine3) -> Result<Self, Refused> {
        Self::from_parts(parent_from_object, parent_from_object.matrix3.inverse())
    }

    fn from_parts(
        parent_from_object: DAffine3,
        linear_object_from_parent: DMat3,
    ) -> Result<Self, Refused> {
        let linear = parent_from_object.matrix3;
        let in_range = |v: DVec3| v.is_finite() && max_abs(v) <= MAX_LENGTH;
        let columns = |m: DMat3| [m.x_axis, m.y_axis, m.z_axis];
        Refused::unless([
            refuse_unless(
                columns(linear).into_iter().all(in_range)
                    && columns(linear_object_from_parent).into_iter().all(in_range),
                "transform",
                format!("a map that has an inverse, both in numbers of at most {MAX_LENGTH:e}"),
                || format!("columns {}", columns(linear).map(show).join(", ")),
            ),
            refuse_unless(
                in_range(parent_from_object.translation),
                "transform",
                format!("a translation by finite numbers of at most {MAX_LENGTH:e}"),
                || show(parent_from_object.translation),
            ),
        ])?;
        Ok(Self { parent_from_object, linear_object_from_parent })
    }

    /// First `self`, then `next`. The inverses are composed as the maps are:
    /// inverting the product would lose the digits that its condition costs.
    ///
    /// # Errors
    /// As [`Transform::new`].
    pub fn then(self, next: Self) -> Result<Self, Refused> {
        let is_swapped = seeded(Fault::GroupOrderSwapped);
        let (first, next) = if is_swapped { (next, self) } else { (self, next) };
        Self::from_parts(
            next.parent_from_object * first.parent_from_object,
            first.linear_object_from_parent * next.linear_object_from_parent,
        )
    }

    /// Moves by `by`.
    ///
    /// # Errors
    /// As [`Transform::new`].
    pub fn translation(by: DVec3) -> Result<Self, Refused> {
        Self::from_parts(DAffine3::from_translation(by), DMat3::IDENTITY)
    }

    /// Scales along the axes; a negative factor mirrors.
    ///
    /// # Errors
    /// As [`Transform::new`]: no factor may be zero.
    pub fn scale(by: DVec3) -> Result<Self, Refused> {
        Refused::unless([refuse_unless(
            by.is_finite() && by.cmpne(DVec3::ZERO).all(),
            "transform",
            "three finite factors, none of them 0",
            || show(by),
        )])?;
        Self::from_parts(DAffine3::from_scale(by), DMat3::from_diagonal(by.recip()))
    }

    /// Rotates about x, then about y, then about z, by degrees; quarter turns
    /// are exact.
    ///
    /// # Errors
    /// As [`Transform::new`].
    pub fn rotation_deg(about: DVec3) -> Result<Self, Refused> {
        let about = if seeded(Fault::RotationBackwards) { -about } else { about };
        let (sx, cx) = sin_cos_deg(about.x);
        let (sy, cy) = sin_cos_deg(about.y);
        let (sz, cz) = sin_cos_deg(about.z);
        let rx = DMat3::from_cols_array(&[1.0, 0.0, 0.0, 0.0, cx, sx, 0.0, -sx, cx]);
        let ry = DMat3::from_cols_array(&[cy, 0.0, -sy, 0.0, 1.0, 0.0, sy, 0.0, cy]);
        let rz = DMat3::from_cols_array(&[cz, sz, 0.0, -sz, cz, 0.0, 0.0, 0.0, 1.0]);
        let turn = if seeded(Fault::RotationOrderSwapped) { rx * ry * rz } else { rz * ry * rx };
        Self::from_parts(DAffine3::from_mat3(turn), turn.transpose())
    }

    /// The map `x_parent = L x_object + T`.
    pub fn affine(&self) -> DAffine3 {
        self.parent_from_object
    }

    /// Whether this changes nothing.
    pub fn is_identity(&self) -> bool {
        self.parent_from_object == DAffine3::IDENTITY
    }

    /// The parent's ray, seen from the object. `t` keeps its meaning.
    pub fn object_from_parent(&self, ray: &Ray) -> Ray {
        let inverse = self.linear_object_from_parent;
        let direction = inverse * ray.direction;
        let is_unit = seeded(Fault::GroupRayNormalized);
        Ray {
            origin: inverse * (ray.origin - self.parent_from_object.translation),
            direction: if is_unit { direction.normalize_or_zero() } else { direction },
            leaving: ray.leaving,
        }
    }

    /// The object's hit, seen from the parent.
    pub fn parent_from_object(&self, hit: Hit) -> Hit {
        Hit {
            point: self.parent_from_object.transform_point3(hit.point),
            point_error: self.stretch() * hit.point_error + self.rounding(max_abs(hit.point)),
            geometric_normal: self.normal(hit.geometric_normal),
            shading_normal: self.normal(hit.shading_normal),
            ..hit
        }
    }

    /// A box around everything in `bounds`, seen from the parent, and around
    /// every hit with it: the rays that find them go in by rounded arithmetic.
    pub fn bounds(&self, bounds: &Aabb) -> Aabb {
        if *bounds == Aabb::EMPTY {
            return Aabb::EMPTY;
        }
        if !bounds.is_finite() {
            return Aabb::EVERYTHING;
        }
        let corners = bounds.corners().map(|p| self.parent_from_object.transform_point3(p));
        Aabb::around(corners).widened(self.rounding(bounds.max_abs()))
    }

    /// How far rounding may move a point of this size in the object's space,
    /// in the parent's units, on the way in and out again. On the way in the
    /// inverse rounds in proportion to its own size, and going out stretches
    /// that: together the condition of the map.
    fn rounding(&self, size: f64) -> f64 {
        /// To go out: three products and three sums.
        const OUT: f64 = 4.0;
        /// To come in again, by an inverse that was composed as the map was.
        const IN: f64 = 8.0;
        /// Of the translation, which is added once on each way; it may itself
        /// be a sum of several.
        const MOVED: f64 = 6.0;
        let translation = max_abs(self.parent_from_object.translation);
        let linear = (OUT + IN * self.condition()) * self.stretch() * size;
        UNIT_ROUNDOFF * (linear + MOVED * translation)
    }

    /// The condition of the map: how many times more than its result rounding
    /// may be off that goes in and out again.
    pub fn condition(&self) -> f64 {
        self.stretch() * norm(self.linear_object_from_parent)
    }

    /// An upper bound of how much `L` lengthens a vector.
    fn stretch(&self) -> f64 {
        norm(self.parent_from_object.matrix3)
    }

    /// Normals go by the inverse transpose; the old normal stands in where
    /// its image has no length, which an invertible map rules out short of
    /// underflow.
    fn normal(&self, n: UnitVec) -> UnitVec {
        let is_direction = seeded(Fault::NormalAsDirection);
        let linear = self.parent_from_object.matrix3;
        let map = if is_direction { linear } else { self.linear_object_from_parent.transpose() };
        if seeded(Fault::NormalNotNormalized) {
            return UnitVec::wrongly(map * *n);
        }
        UnitVec::new(map * *n).unwrap_or(n)
    }
}

/// The Frobenius norm, which bounds how much a matrix lengthens a vector.
fn norm(m: DMat3) -> f64 {
    [m.x_axis, m.y_axis, m.z_axis].map(DVec3::length_squared).iter().sum::<f64>().sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rotations_are_about_x_then_y_then_z() {
        let r = Transform::rotation_deg(DVec3::new(90.0, 0.0, 90.0)).unwrap();
        // y goes to z by x; z stays by z. x stays by x; x goes to y by z.
        assert_eq!(r.parent_from_object.transform_vector3(DVec3::Y), DVec3::Z);
        assert_eq!(r.parent_from_object.transform_vector3(DVec3::X), DVec3::Y);
        let r = Transform::rotation_deg(DVec3::new(90.0, 90.0, 0.0)).unwrap();
        // y goes to z by x, z goes to x by y.
        assert_eq!(r.parent_from_object.transform_vector3(DVec3::Y), DVec3::X);
    }

    #[test]
    fn a_ray_keeps_its_t() {
        let t = Transform::scale(DVec3::new(2.0, 4.0, 8.0)).unwrap();
        let t = t.then(Transform::translation(DVec3::new(1.0, 2.0, 3.0)).unwrap()).unwrap();
        let ray = Ray::new(DVec3::new(5.0, -1.0, 7.0), DVec3::new(-0.5, 3.0, 0.25));
        let inside = t.object_from_parent(&ray);
        let moved = t.parent_from_object.transform_point3(inside.at(1.5));
        assert_eq!(moved, ray.at(1.5));
        assert_eq!(inside.direction, DVec3::new(-0.25, 0.75, 0.03125));
    }

    #[test]
    fn a_small_object_far_away_keeps_its_digits() {
        let center = 123_456_789.0;
        let far = Transform::translation(DVec3::new(center, 0.0, 0.0)).unwrap();
        let small = Transform::scale(DVec3::splat(3e-3)).unwrap().then(far).unwrap();
        let ray = Ray::new(DVec3::new(center + 0.75, 0.375, 0.0), DVec3::X);
        // Adding 0.75 is exact, so nothing may be lost by subtracting the
        // center again; subtracting after the scale loses half the digits.
        let origin = small.object_from_parent(&ray).origin;
        assert!((origin - DVec3::new(250.0, 125.0, 0.0)).length() < 1e-12, "{origin}");
    }

    #[test]
    fn the_way_of_composing_does_not_matter() {
        let map = Transform::new(DAffine3::IDENTITY).unwrap();
        assert_eq!(map, Transform::IDENTITY);
        assert!(map.then(map).unwrap().is_identity());
    }

    #[test]
    fn maps_without_an_inverse_are_refused() {
        assert!(Transform::scale(DVec3::new(1.0, 0.0, 1.0)).is_err());
        assert!(Transform::scale(DVec3::new(1.0, f64::NAN, 1.0)).is_err());
        assert!(Transform::translation(DVec3::new(f64::INFINITY, 0.0, 0.0)).is_err());
        assert!(Transform::scale(DVec3::new(1e155, 1e-155, 1.0)).is_err());
        assert!(Transform::scale(DVec3::splat(1e-59)).is_ok(), "small is not singular");
        assert!(Transform::scale(DVec3::new(-1.0, 1.0, 1.0)).is_ok(), "mirrors are fine");
    }
}
