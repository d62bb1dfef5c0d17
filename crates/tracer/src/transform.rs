//! `Transform`: an invertible affine map between an object's space and its
//! parent's.

use glam::{DAffine3, DMat3, DVec3};

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
    /// An upper bound of how much `L` lengthens a vector.
    stretch: f64,
}

impl Transform {
    /// Changes nothing.
    pub const IDENTITY: Self = Self {
        parent_from_object: DAffine3::IDENTITY,
        linear_object_from_parent: DMat3::IDENTITY,
        stretch: 1.0,
    };

    /// The map `x_parent = L x_object + T`.
    ///
    /// # Errors
    /// Refuses (as `transform`) numbers that are not finite, and a map that
    /// has no inverse, such as a scale by zero.
    pub fn new(parent_from_object: DAffine3) -> Result<Self, Refused> {
        let linear = parent_from_object.matrix3;
        let inverse = linear.inverse();
        let reach = max_abs(parent_from_object.translation);
        let invertible = parent_from_object.is_finite()
            && inverse.is_finite()
            && linear.determinant() != 0.0
            && reach <= MAX_LENGTH;
        Refused::unless([refuse_unless(
            invertible,
            "transform",
            "an invertible map of finite numbers",
            || {
                let [x, y, z] = [linear.x_axis, linear.y_axis, linear.z_axis].map(show);
                format!(
                    "columns {x}, {y}, {z} and translation {}",
                    show(parent_from_object.translation)
                )
            },
        )])?;
        let squares = [linear.x_axis, linear.y_axis, linear.z_axis].map(DVec3::length_squared);
        Ok(Self {
            parent_from_object,
            linear_object_from_parent: inverse,
            stretch: squares.iter().sum::<f64>().sqrt(),
        })
    }

    /// First `self`, then `next`.
    ///
    /// # Errors
    /// As [`Transform::new`].
    pub fn then(self, next: Self) -> Result<Self, Refused> {
        Self::new(next.parent_from_object * self.parent_from_object)
    }

    /// Moves by `by`.
    ///
    /// # Errors
    /// As [`Transform::new`].
    pub fn translation(by: DVec3) -> Result<Self, Refused> {
        Self::new(DAffine3::from_translation(by))
    }

    /// Scales along the axes; a negative factor mirrors.
    ///
    /// # Errors
    /// As [`Transform::new`]: no factor may be zero.
    pub fn scale(by: DVec3) -> Result<Self, Refused> {
        Self::new(DAffine3::from_scale(by))
    }

    /// Rotates about x, then about y, then about z, by degrees; quarter turns
    /// are exact.
    ///
    /// # Errors
    /// As [`Transform::new`].
    pub fn rotation_deg(about: DVec3) -> Result<Self, Refused> {
        let (sx, cx) = sin_cos_deg(about.x);
        let (sy, cy) = sin_cos_deg(about.y);
        let (sz, cz) = sin_cos_deg(about.z);
        let rx = DMat3::from_cols_array(&[1.0, 0.0, 0.0, 0.0, cx, sx, 0.0, -sx, cx]);
        let ry = DMat3::from_cols_array(&[cy, 0.0, -sy, 0.0, 1.0, 0.0, sy, 0.0, cy]);
        let rz = DMat3::from_cols_array(&[cz, sz, 0.0, -sz, cz, 0.0, 0.0, 0.0, 1.0]);
        Self::new(DAffine3::from_mat3(rz * ry * rx))
    }

    /// Whether this changes nothing.
    pub fn is_identity(&self) -> bool {
        self.parent_from_object == DAffine3::IDENTITY
    }

    /// The parent's ray, seen from the object. `t` keeps its meaning.
    pub fn object_from_parent(&self, ray: &Ray) -> Ray {
        let inverse = self.linear_object_from_parent;
        Ray::new(
            inverse * (ray.origin - self.parent_from_object.translation),
            inverse * ray.direction,
        )
    }

    /// The object's hit, seen from the parent.
    pub fn parent_from_object(&self, hit: Hit) -> Hit {
        let translation = self.parent_from_object.translation;
        // Three products and three sums a component, each off by one rounding.
        let rounding = 8.0 * UNIT_ROUNDOFF;
        let size = self.stretch * max_abs(hit.point) + max_abs(translation);
        Hit {
            point: self.parent_from_object.transform_point3(hit.point),
            point_error: self.stretch * hit.point_error + rounding * size,
            geometric_normal: self.normal(hit.geometric_normal),
            shading_normal: self.normal(hit.shading_normal),
            ..hit
        }
    }

    /// A box around everything in `bounds`, seen from the parent.
    pub fn bounds(&self, bounds: &Aabb) -> Aabb {
        if *bounds == Aabb::EMPTY {
            return Aabb::EMPTY;
        }
        if !bounds.is_finite() {
            return Aabb::EVERYTHING;
        }
        let corners = bounds.corners().map(|p| self.parent_from_object.transform_point3(p));
        Aabb::around(corners).for_rounded_points()
    }

    /// Normals go by the inverse transpose; the old normal stands in where
    /// its image has no length, which an invertible map rules out short of
    /// underflow.
    fn normal(&self, n: UnitVec) -> UnitVec {
        UnitVec::new(self.linear_object_from_parent.transpose() * *n).unwrap_or(n)
    }
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
    fn maps_without_an_inverse_are_refused() {
        assert!(Transform::scale(DVec3::new(1.0, 0.0, 1.0)).is_err());
        assert!(Transform::scale(DVec3::new(1.0, f64::NAN, 1.0)).is_err());
        assert!(Transform::translation(DVec3::new(f64::INFINITY, 0.0, 0.0)).is_err());
        assert!(Transform::scale(DVec3::new(-1.0, 1.0, 1.0)).is_ok(), "mirrors are fine");
    }
}
