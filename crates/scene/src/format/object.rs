//! Objects and groups as a file has them.

use serde::{Deserialize, Serialize};
use tracer::Refused;
use tracer::glam::DVec3;
use tracer::shape::{AxisBox, Cone, Cylinder, Disk, Plane, Shape, Sphere, Torus, Triangle};

use super::{Material, Triple, is_default};

/// A surface, or a group of them. An object without a material takes its
/// group's, and at the top the shading's default Lambert.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub enum Object {
    /// See [`tracer::shape::Sphere`].
    Sphere {
        /// Its center.
        center: Triple,
        /// Its radius.
        radius: f64,
        /// What it is made of.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        material: Option<Material>,
    },
    /// See [`tracer::shape::Triangle`].
    Triangle {
        /// The first corner.
        a: Triple,
        /// The second corner, counter-clockwise as seen from the front.
        b: Triple,
        /// The third corner.
        c: Triple,
        /// What it is made of.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        material: Option<Material>,
    },
    /// See [`tracer::shape::AxisBox`].
    Box {
        /// The lowest corner.
        min: Triple,
        /// The highest corner.
        max: Triple,
        /// What it is made of.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        material: Option<Material>,
    },
    /// See [`tracer::shape::Plane`].
    Plane {
        /// Any point of it.
        point: Triple,
        /// Its normal, of any length.
        normal: Triple,
        /// What it is made of.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        material: Option<Material>,
    },
    /// See [`tracer::shape::Disk`].
    Disk {
        /// Its center.
        center: Triple,
        /// Its normal, of any length.
        normal: Triple,
        /// Its radius.
        radius: f64,
        /// What it is made of.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        material: Option<Material>,
    },
    /// See [`tracer::shape::Torus`].
    Torus {
        /// Its center.
        center: Triple,
        /// The axis that it goes around, of any length.
        axis: Triple,
        /// From the center to the middle of the tube.
        major_radius: f64,
        /// The tube's own radius, at most the major one.
        minor_radius: f64,
        /// What it is made of.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        material: Option<Material>,
    },
    /// See [`tracer::shape::Cylinder`].
    Cylinder {
        /// Where its axis starts.
        a: Triple,
        /// Where its axis ends.
        b: Triple,
        /// Its radius.
        radius: f64,
        /// Whether it is a tube, without the caps.
        #[serde(default, skip_serializing_if = "is_default")]
        open: bool,
        /// What it is made of.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        material: Option<Material>,
    },
    /// See [`tracer::shape::Cone`].
    Cone {
        /// Its tip.
        apex: Triple,
        /// The center of its base.
        base: Triple,
        /// The radius of its base.
        radius: f64,
        /// Whether it is a funnel, without the base.
        #[serde(default, skip_serializing_if = "is_default")]
        open: bool,
        /// What it is made of.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        material: Option<Material>,
    },
    /// A mesh from an OBJ or PLY file; see [`tracer::shape::Mesh`].
    Mesh {
        /// The file, in the scene's own folder or below it.
        file: String,
        /// Whether to shade each triangle flat although the file has normals.
        #[serde(default, skip_serializing_if = "is_default")]
        flat: bool,
        /// What it is made of.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        material: Option<Material>,
    },
    /// Objects in a space of their own.
    Group {
        /// What is done to them, first to last.
        #[serde(default, skip_serializing_if = "Vec::is_empty")]
        transform: Vec<Transform>,
        /// What is in it.
        objects: Vec<Object>,
        /// The material of those in it that have none.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        material: Option<Material>,
    },
}

impl Object {
    /// The object's own material, if it says one.
    pub fn material(&self) -> Option<&Material> {
        match self {
            Self::Sphere { material, .. }
            | Self::Triangle { material, .. }
            | Self::Box { material, .. }
            | Self::Plane { material, .. }
            | Self::Disk { material, .. }
            | Self::Cylinder { material, .. }
            | Self::Cone { material, .. }
            | Self::Torus { material, .. }
            | Self::Mesh { material, .. }
            | Self::Group { material, .. } => material.as_ref(),
        }
    }

    /// Where the object's own material is said.
    pub fn material_mut(&mut self) -> &mut Option<Material> {
        match self {
            Self::Sphere { material, .. }
            | Self::Triangle { material, .. }
            | Self::Box { material, .. }
            | Self::Plane { material, .. }
            | Self::Disk { material, .. }
            | Self::Cylinder { material, .. }
            | Self::Cone { material, .. }
            | Self::Torus { material, .. }
            | Self::Mesh { material, .. }
            | Self::Group { material, .. } => material,
        }
    }

    /// The shape that its own numbers make, or why they make none; `None` for
    /// a mesh and a group, which need more than that.
    pub(crate) fn shape(&self) -> Option<Result<Shape, Refused>> {
        let point = DVec3::from_array;
        Some(match *self {
            Self::Sphere { center, radius, .. } => {
                Sphere::new(point(center), radius).map(Shape::from)
            }
            Self::Triangle { a, b, c, .. } => {
                Triangle::new(point(a), point(b), point(c)).map(Shape::from)
            }
            Self::Box { min, max, .. } => AxisBox::new(point(min), point(max)).map(Shape::from),
            Self::Plane { point: a, normal, .. } => {
                Plane::new(point(a), point(normal)).map(Shape::from)
            }
            Self::Disk { center, normal, radius, .. } => {
                Disk::new(point(center), point(normal), radius).map(Shape::from)
            }
            Self::Torus { center, axis, major_radius, minor_radius, .. } => {
                Torus::new(point(center), point(axis), major_radius, minor_radius).map(Shape::from)
            }
            Self::Cylinder { a, b, radius, open, .. } => {
                Cylinder::new(point(a), point(b), radius, !open).map(Shape::from)
            }
            Self::Cone { apex, base, radius, open, .. } => {
                Cone::new(point(apex), point(base), radius, !open).map(Shape::from)
            }
            Self::Mesh { .. } | Self::Group { .. } => return None,
        })
    }
}

/// One step of a group's transform.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub enum Transform {
    /// Moves along the axes.
    Translate(f64, f64, f64),
    /// Rotates about x, then y, then z, in degrees.
    RotateDeg(f64, f64, f64),
    /// Scales along the axes; a negative factor mirrors.
    Scale(f64, f64, f64),
}
