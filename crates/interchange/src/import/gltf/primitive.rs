//! Primitives: triangles, strips and fans, put where their node is.
//!
//! The map of a node goes into the corners, in `f64`; normals go by its inverse
//! transpose, and where it mirrors, triangles turn the other way, so that fronts
//! stay fronts.

use std::collections::BTreeMap;

use tracer::glam::{DAffine3, DMat3, DVec3};

use super::accessor::{indices, tuples};
use super::buffer::Buffers;
use super::document::{Document, Primitive};
use crate::import::mesh::part::{LARGEST, MOST_ELEMENTS, Part, is_point};
use crate::import::mesh::tally::Tally;

/// Triangles by their material, apart where they have normals and texture
/// coordinates and where not.
#[derive(Debug, Default)]
pub(super) struct Parts {
    numbers: BTreeMap<(Option<usize>, bool, bool), usize>,
    pub(super) all: Vec<(Part, Option<usize>)>,
    elements: usize,
}

impl Parts {
    /// Adds a primitive as its node has it; `place` says which it is.
    ///
    /// # Errors
    /// What is wrong with it.
    pub(super) fn add(
        &mut self,
        (document, buffers): (&Document, &mut Buffers<'_>),
        primitive: &Primitive,
        world: &DAffine3,
        place: &str,
        lost: &mut Tally,
    ) -> Result<(), String> {
        let mode = primitive.mode.unwrap_or(4);
        let cut: fn(&[u32]) -> Vec<[u32; 3]> = match mode {
            0..=3 => {
                let what = if mode == 0 { "points are left out" } else { "lines are left out" };
                lost.add(None, place, what);
                return Ok(());
            }
            4 => triangles,
            5 => strip,
            6 => fan,
            _ => return Err(format!("expected a mode from 0 to 6, found {mode}")),
        };
        let attribute = |name: &str| primitive.attributes.get(name).copied();
        for name in primitive.attributes.keys() {
            let what = match &name[..] {
                "COLOR_0" => "colors of vertices are left out",
                name if name.starts_with('_') => "numbers of the file's own are left out",
                _ => continue,
            };
            lost.add(None, format!("{place}: {name}"), what);
        }
        let Some(positions) = attribute("POSITION") else {
            lost.add(None, place, "it has no POSITION and is left out");
            return Ok(());
        };
        let positions = tuples::<3>(document, buffers, positions)?;
        let count = positions.len();
        let as_many = |name: &str, found: usize| {
            let message = format!("expected {count} of {name}, one for each vertex, found {found}");
            if found == count { Ok(()) } else { Err(message) }
        };
        let corners = match primitive.indices {
            Some(index) => indices(document, buffers, index)?,
            None => (0..count as u32).collect(),
        };
        if let Some(bad) = corners.iter().find(|&&corner| corner as usize >= count) {
            return Err(format!("expected indices below {count}, found {bad}"));
        }
        let mut faces = cut(&corners);
        if mode == 4 && !corners.len().is_multiple_of(3) {
            lost.add(None, place, "corners that are not enough for a triangle are left out");
        }
        self.elements += count + faces.len();
        if self.elements > MOST_ELEMENTS {
            return Err(format!(
                "expected at most {MOST_ELEMENTS} vertices and triangles in all nodes together"
            ));
        }
        let linear = world.matrix3;
        if linear.determinant() < 0.0 {
            for face in &mut faces {
                face.swap(1, 2);
            }
        }
        let mut normals = Vec::new();
        if let Some(index) = attribute("NORMAL") {
            let written = tuples::<3>(document, buffers, index)?;
            as_many("NORMAL", written.len())?;
            if let Some(map) = normal_map(linear) {
                normals = written.into_iter().map(|n| moved(map, DVec3::from(n))).collect();
            } else {
                lost.add(None, place, "its node has no inverse: normals are left out");
            }
        }
        let mut uvs = Vec::new();
        if let Some(index) = attribute("TEXCOORD_0") {
            let written = tuples::<2>(document, buffers, index)?;
            as_many("TEXCOORD_0", written.len())?;
            // From the lower left, not the upper.
            uvs = written.into_iter().map(|[u, v]| [u, 1.0 - v]).collect();
        }
        let mut vertices = Vec::with_capacity(count);
        for p in positions {
            let p = world.transform_point3(DVec3::from(p));
            if !is_point(p) {
                let most = format!("numbers of at most {LARGEST:e}");
                return Err(format!("expected vertices of {most} after its node's map, found {p}"));
            }
            vertices.push(p);
        }
        self.put(primitive.material, Part { vertices, faces, normals, uvs, ..Part::default() });
        Ok(())
    }

    fn put(&mut self, material: Option<usize>, more: Part) {
        let (has_normals, has_uvs) = (!more.normals.is_empty(), !more.uvs.is_empty());
        let number = *self.numbers.entry((material, has_normals, has_uvs)).or_insert_with(|| {
            self.all.push((Part::default(), material));
            self.all.len() - 1
        });
        let part = &mut self.all[number].0;
        // All together are at most `MOST_ELEMENTS`.
        let before = part.vertices.len() as u32;
        let faces = more.faces.iter().map(|face| face.map(|corner| corner + before));
        if has_normals {
            part.normal_faces.extend(faces.clone());
        }
        if has_uvs {
            part.uv_faces.extend(faces.clone());
        }
        part.faces.extend(faces);
        part.vertices.extend(more.vertices);
        part.normals.extend(more.normals);
        part.uvs.extend(more.uvs);
    }
}

fn triangles(corners: &[u32]) -> Vec<[u32; 3]> {
    corners.as_chunks::<3>().0.to_vec()
}

fn strip(corners: &[u32]) -> Vec<[u32; 3]> {
    let turn =
        |(i, c): (usize, &[u32])| if i % 2 == 0 { [c[0], c[1], c[2]] } else { [c[0], c[2], c[1]] };
    corners.windows(3).enumerate().map(turn).collect()
}

fn fan(corners: &[u32]) -> Vec<[u32; 3]> {
    let Some((&first, rest)) = corners.split_first() else { return Vec::new() };
    rest.windows(2).map(|pair| [pair[0], pair[1], first]).collect()
}

/// The map of normals, up to their length; `None` where there is no inverse.
fn normal_map(linear: DMat3) -> Option<DMat3> {
    let [x, y, z] = [linear.x_axis, linear.y_axis, linear.z_axis];
    let determinant = linear.determinant();
    let sign = if determinant < 0.0 { -1.0 } else { 1.0 };
    let cofactors = DMat3::from_cols(y.cross(z), z.cross(x), x.cross(y));
    (determinant != 0.0 && determinant.is_finite()).then(|| cofactors * sign)
}

/// A normal that keeps its bits where the map changes none, and else has length 1.
fn moved(map: DMat3, normal: DVec3) -> DVec3 {
    if map == DMat3::IDENTITY { normal } else { (map * normal).normalize_or_zero() }
}
