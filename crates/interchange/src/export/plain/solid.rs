//! `Solid`: a shape in the world's own space, for dialects that turn and move
//! less than goldray does.

use scene::MeshData;
use scene::format::{Object, Triple};
use tracer::glam::{DAffine3, DMat3, DVec3};

use super::{Placed, Plain};
use crate::export::text::vector;

/// A shape in the world's space. Normals and corners are turned as their
/// shape is, a mirror included: they point outwards still.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::export) enum Solid {
    Sphere {
        center: DVec3,
        radius: f64,
    },
    /// Seen as far as `reach` from the point.
    Plane {
        point: DVec3,
        normal: DVec3,
        reach: f64,
    },
    Disk {
        center: DVec3,
        normal: DVec3,
        radius: f64,
    },
    Torus {
        center: DVec3,
        axis: DVec3,
        major_radius: f64,
        minor_radius: f64,
    },
    Cylinder {
        a: DVec3,
        b: DVec3,
        radius: f64,
        open: bool,
    },
    Cone {
        apex: DVec3,
        base: DVec3,
        radius: f64,
        open: bool,
    },
    Triangles(Triangles),
}

/// Triangles that share corners.
#[derive(Debug, Clone, Default, PartialEq)]
pub(in crate::export) struct Triangles {
    pub(in crate::export) corners: Vec<DVec3>,
    /// For each corner, of length 1; none at all for flat triangles.
    pub(in crate::export) normals: Vec<DVec3>,
    pub(in crate::export) faces: Vec<[u32; 3]>,
}

impl Placed {
    /// The shape in the world's space. A round one whose transform stretches it
    /// comes out wrong: that is [`Feature::StretchedRound`](crate::Feature), to be
    /// asked before.
    pub(in crate::export) fn solid(&self, plain: &Plain) -> Solid {
        let m = self.world_from_object;
        let scale = m.matrix3.x_axis.length();
        let point = |p: Triple| m.transform_point3(vector(p));
        let normal = |n: Triple| turned(m.matrix3, vector(n));
        match self.shape {
            Object::Sphere { center, radius, .. } => {
                Solid::Sphere { center: point(center), radius: radius * scale }
            }
            Object::Plane { point: p, normal: n, .. } => {
                Solid::Plane { point: point(p), normal: normal(n), reach: self.reach }
            }
            Object::Disk { center, normal: n, radius, .. } => {
                Solid::Disk { center: point(center), normal: normal(n), radius: radius * scale }
            }
            Object::Torus { center, axis, major_radius, minor_radius, .. } => Solid::Torus {
                center: point(center),
                axis: normal(axis),
                major_radius: major_radius * scale,
                minor_radius: minor_radius * scale,
            },
            Object::Cylinder { a, b, radius, open, .. } => {
                Solid::Cylinder { a: point(a), b: point(b), radius: radius * scale, open }
            }
            Object::Cone { apex, base, radius, open, .. } => {
                Solid::Cone { apex: point(apex), base: point(base), radius: radius * scale, open }
            }
            Object::Triangle { a, b, c, .. } => {
                let corners = [a, b, c].map(vector).to_vec();
                Solid::Triangles(moved(m, corners, Vec::new(), vec![[0, 1, 2]]))
            }
            Object::Box { min, max, .. } => {
                let (corners, faces) = of_box(vector(min), vector(max));
                Solid::Triangles(moved(m, corners, Vec::new(), faces))
            }
            Object::Mesh { ref file, flat, .. } => {
                Solid::Triangles(plain.meshes.get(file).map_or_else(Triangles::default, |mesh| {
                    let Triangles { corners, normals, faces } = of_mesh(mesh, flat);
                    moved(m, corners, normals, faces)
                }))
            }
            // `Placed` is none.
            Object::Group { .. } => Solid::Triangles(Triangles::default()),
        }
    }
}

/// A normal by the inverse transpose, its length as it was but for a stretch.
fn turned(m: DMat3, n: DVec3) -> DVec3 {
    if m == DMat3::IDENTITY {
        return n;
    }
    let turned = m.inverse().transpose() * n.normalize_or_zero();
    turned.normalize_or_zero()
}

fn moved(
    m: DAffine3,
    corners: Vec<DVec3>,
    normals: Vec<DVec3>,
    mut faces: Vec<[u32; 3]>,
) -> Triangles {
    let corners = corners.into_iter().map(|p| m.transform_point3(p)).collect();
    let normals = normals.into_iter().map(|n| turned(m.matrix3, n)).collect();
    if m.matrix3.determinant() < 0.0 {
        for [_, b, c] in &mut faces {
            std::mem::swap(b, c);
        }
    }
    Triangles { corners, normals, faces }
}

/// The corners by the bits of their numbers, x first; the sides counter-clockwise
/// from outside.
fn of_box(min: DVec3, max: DVec3) -> (Vec<DVec3>, Vec<[u32; 3]>) {
    const SIDES: [[u32; 4]; 6] =
        [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]];
    let corner = |k: u32| {
        let pick = |axis: usize| if k >> axis & 1 == 1 { max[axis] } else { min[axis] };
        DVec3::new(pick(0), pick(1), pick(2))
    };
    let faces = SIDES.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]);
    ((0..8).map(corner).collect(), faces.collect())
}

/// A mesh whose corners have one normal each: a corner is there once for every
/// normal that it has. A triangle that lacks a normal is flat, as in goldray.
fn of_mesh(mesh: &MeshData, flat: bool) -> Triangles {
    let Some(of) = mesh.normals.as_ref().filter(|_| !flat) else {
        let (corners, faces) = (mesh.vertices.clone(), mesh.faces.clone());
        return Triangles { corners, normals: Vec::new(), faces };
    };
    let mut known = std::collections::BTreeMap::new();
    let mut all = Triangles::default();
    let at = |i: u32, list: &[DVec3]| list.get(i as usize).copied().unwrap_or_default();
    for (face, normal_face) in mesh.faces.iter().zip(&of.faces) {
        let corners = face.map(|i| at(i, &mesh.vertices));
        let normals = normal_face.map(|i| at(i, &of.normals).normalize_or_zero());
        let is_smooth = normals.iter().all(|n| *n != DVec3::ZERO);
        let [a, b, c] = corners;
        let flat_normal = (b - a).cross(c - a).normalize_or_zero();
        let made: [u32; 3] = std::array::from_fn(|k| {
            let (key, normal) = if is_smooth {
                ((face[k], Some(normal_face[k])), normals[k])
            } else {
                // A corner of its own for each flat triangle.
                ((u32::try_from(all.faces.len() * 3 + k).unwrap_or(u32::MAX), None), flat_normal)
            };
            *known.entry(key).or_insert_with(|| {
                all.corners.push(corners[k]);
                all.normals.push(normal);
                u32::try_from(all.corners.len() - 1).unwrap_or(u32::MAX)
            })
        });
        all.faces.push(made);
    }
    all
}

impl Triangles {
    /// As a PLY file of text, with 64 bits in each number.
    pub(in crate::export) fn ply(&self) -> Vec<u8> {
        use crate::export::text::spaced;
        let has_normals = !self.normals.is_empty();
        let normals = if has_normals {
            "property double nx\nproperty double ny\nproperty double nz\n"
        } else {
            ""
        };
        let mut text = format!(
            "ply\nformat ascii 1.0\nelement vertex {}\nproperty double x\nproperty double y\n\
             property double z\n{normals}element face {}\n\
             property list uchar int vertex_indices\nend_header\n",
            self.corners.len(),
            self.faces.len()
        );
        for (k, corner) in self.corners.iter().enumerate() {
            text += &spaced(corner.to_array());
            if let Some(normal) = self.normals.get(k) {
                text += " ";
                text += &spaced(normal.to_array());
            }
            text += "\n";
        }
        for [a, b, c] in &self.faces {
            text += &format!("3 {a} {b} {c}\n");
        }
        text.into_bytes()
    }
}
