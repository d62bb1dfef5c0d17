//! `Builder`: a mesh of a PLY file's elements.

use tracer::glam::DVec3;

use super::body::Values;
use super::header::{Element, Property};
use crate::import::Unreadable;
use crate::import::mesh::part::{LARGEST, MOST_ELEMENTS, Part, is_point};
use crate::import::mesh::stage::Stage;
use crate::import::mesh::unreadable_at_all;
use crate::polygon::{Cutter, Problem, off_plane};

/// Where the element at hand has what.
#[derive(Debug, Clone, Copy)]
enum Columns {
    Vertex {
        position: [usize; 3],
        normal: Option<[usize; 3]>,
        uv: Option<[usize; 2]>,
    },
    /// Polygons by their corners.
    Face {
        corners: usize,
    },
    /// Strips of triangles, one after the other with -1 between.
    Strips {
        corners: usize,
    },
    /// What is no mesh.
    Other,
}

/// What is read so far.
#[derive(Debug)]
pub(super) struct Builder {
    columns: Columns,
    values: Values,
    part: Part,
    has_vertices: bool,
    has_faces: bool,
    /// Polygons, which may come before the vertices, as their lengths and corners.
    lengths: Vec<u32>,
    corners: Vec<u32>,
}

impl Default for Builder {
    fn default() -> Self {
        Self {
            columns: Columns::Other,
            values: Values::new(),
            part: Part::default(),
            has_vertices: false,
            has_faces: false,
            lengths: Vec::new(),
            corners: Vec::new(),
        }
    }
}

/// Names of a face's list of corners.
const CORNERS: [&str; 2] = ["vertex_indices", "vertex_index"];
/// What a scanner says of its measurements, which no picture shows.
const MEASUREMENTS: [&str; 5] = ["confidence", "quality", "curvature", "flags", "intensity"];

impl Builder {
    /// Makes ready for the things of an element, and notes what of them is lost.
    ///
    /// # Errors
    /// A vertex without a place, a face without corners.
    pub(super) fn begin(&mut self, element: &Element, stage: &mut Stage) -> Result<(), Unreadable> {
        let one = |names: &[&str]| {
            element.find(names).filter(|&i| element.properties[i].length.is_none())
        };
        let list = |names: &[&str]| {
            element.find(names).filter(|&i| {
                let Property { length, of, .. } = &element.properties[i];
                length.is_some() && of.is_whole()
            })
        };
        let triple = |names: [&str; 3]| {
            let [x, y, z] = names.map(|name| one(&[name]));
            Some([x?, y?, z?])
        };
        let needs = |what: &str| {
            unreadable_at_all(format!("expected an element `{}` with {what}", element.name))
        };
        let mut used = Vec::new();
        self.columns = match &element.name[..] {
            "vertex" => {
                let position =
                    triple(["x", "y", "z"]).ok_or_else(|| needs("properties x, y and z"))?;
                let normal = triple(["nx", "ny", "nz"]);
                let uv = [["u", "v"], ["s", "t"], ["texture_u", "texture_v"]]
                    .into_iter()
                    .find_map(|[u, v]| Some([one(&[u])?, one(&[v])?]));
                used.extend(position);
                used.extend(normal.into_iter().flatten());
                used.extend(uv.into_iter().flatten());
                self.has_vertices = true;
                Columns::Vertex { position, normal, uv }
            }
            "face" => {
                let what = "a list `vertex_indices` of whole numbers";
                let corners = list(&CORNERS).ok_or_else(|| needs(what))?;
                used.push(corners);
                self.has_faces = true;
                Columns::Face { corners }
            }
            "tristrips" => {
                let what = "a list `vertex_indices` of whole numbers";
                let corners = list(&CORNERS).ok_or_else(|| needs(what))?;
                used.push(corners);
                self.has_faces = true;
                Columns::Strips { corners }
            }
            _ => {
                if element.count > 0 {
                    let name = format!("element {}", element.name);
                    let what = format!("{} of them are left out", element.count);
                    stage.lost.add(None, name, what);
                }
                Columns::Other
            }
        };
        if !matches!(self.columns, Columns::Other) && element.count > 0 {
            unused(element, &used, stage);
        }
        Ok(())
    }

    /// Where the values of the next thing go.
    pub(super) fn values(&mut self) -> &mut Values {
        &mut self.values
    }

    /// Takes the values of one thing.
    ///
    /// # Errors
    /// What is wrong with them.
    pub(super) fn take(&mut self) -> Result<(), String> {
        if self.part.vertices.len() + self.corners.len() / 3 >= MOST_ELEMENTS {
            return Err(format!(
                "expected at most {MOST_ELEMENTS} vertices and triangles together"
            ));
        }
        match self.columns {
            Columns::Vertex { position, normal, uv } => {
                let point = |at: [usize; 3]| DVec3::from_array(at.map(|i| self.values[i][0]));
                if !is_point(point(position)) {
                    return Err(format!("expected numbers of at most {LARGEST:e}"));
                }
                self.part.vertices.push(point(position));
                self.part.normals.extend(normal.map(point));
                self.part.uvs.extend(uv.map(|at| at.map(|i| self.values[i][0])));
            }
            Columns::Face { corners } => {
                for &corner in &self.values[corners] {
                    self.corners.push(index(corner)?);
                }
                self.lengths.push(self.values[corners].len() as u32);
            }
            Columns::Strips { corners } => {
                for strip in self.values[corners].split(|&corner| corner == -1.0) {
                    for (i, triangle) in strip.windows(3).enumerate() {
                        let [a, b, c] = [triangle[0], triangle[1], triangle[2]];
                        // Every second turns the other way.
                        let turned = if i % 2 == 0 { [a, b, c] } else { [b, a, c] };
                        for corner in turned {
                            self.corners.push(index(corner)?);
                        }
                        self.lengths.push(3);
                    }
                }
            }
            Columns::Other => {}
        }
        Ok(())
    }

    /// The mesh; `None` where there are no vertices or no faces.
    ///
    /// # Errors
    /// Corners that are none of the vertices.
    pub(super) fn finish(mut self, stage: &mut Stage) -> Result<Option<Part>, Unreadable> {
        if !self.has_vertices || !self.has_faces {
            return Ok(None);
        }
        let vertices = self.part.vertices.len();
        let mut cutter = Cutter::default();
        let mut rest = &self.corners[..];
        let (mut polygon, mut bent) = (Vec::new(), 0_usize);
        for (number, &length) in self.lengths.iter().enumerate() {
            let (corners, after) = rest.split_at(length as usize);
            rest = after;
            if let Some(bad) = corners.iter().find(|&&corner| corner as usize >= vertices) {
                let message = format!(
                    "`face` number {number}: expected numbers below {vertices}, as there are so \
                     many vertices, found {bad}"
                );
                return Err(unreadable_at_all(message));
            }
            polygon.clear();
            polygon.extend(corners.iter().map(|&corner| self.part.vertices[corner as usize]));
            let cut = if length < 3 { Err(Problem::NoArea) } else { cutter.cut(&polygon) };
            match cut {
                Ok(triangles) => {
                    /// Of a polygon's size; less than this is not seen.
                    const FLAT: f64 = 1e-3;
                    bent += usize::from(length > 3 && off_plane(&polygon) > FLAT);
                    self.part.faces.extend(triangles.iter().map(|t| t.map(|i| corners[i])));
                }
                Err(problem @ Problem::TooMuchWork) => {
                    let why = format!("`face` number {number} {}", problem.text());
                    return Err(unreadable_at_all(format!("expected simpler polygons: {why}")));
                }
                Err(problem) => {
                    let what = format!("a polygon that {} is left out", problem.text());
                    stage.lost.add(None, "`face`", what);
                }
            }
        }
        if bent > 0 {
            stage.chosen.push(format!(
                "{bent} polygons are not flat: they are cut as they look along the axis that \
                 their normal is nearest to"
            ));
        }
        let mut part = self.part;
        if !part.normals.is_empty() {
            part.normal_faces.clone_from(&part.faces);
        }
        if !part.uvs.is_empty() {
            part.uv_faces.clone_from(&part.faces);
        }
        Ok(Some(part))
    }
}

/// Notes the properties that no mesh has.
fn unused(element: &Element, used: &[usize], stage: &mut Stage) {
    let mut measured = Vec::new();
    for (i, property) in element.properties.iter().enumerate() {
        let name = &property.name;
        if used.contains(&i) {
            continue;
        }
        if MEASUREMENTS.contains(&&name[..]) {
            measured.push(name.clone());
            continue;
        }
        let what = match &name[..] {
            "red" | "green" | "blue" | "alpha" | "diffuse_red" | "diffuse_green"
            | "diffuse_blue" => "colors are left out",
            "texcoord" | "texnumber" => "textures are left out",
            _ => "it is left out",
        };
        stage.lost.add(None, format!("property {name} of `{}`", element.name), what);
    }
    if !measured.is_empty() {
        stage.chosen.push(format!(
            "of `{}` the picture shows nothing of {}, which are measurements",
            element.name,
            measured.join(", ")
        ));
    }
}

fn index(corner: f64) -> Result<u32, String> {
    // Whole numbers of at most 32 bits, by their type.
    if corner < 0.0 {
        return Err(format!("expected the numbers of vertices, from 0, found {corner}"));
    }
    Ok(corner as u32)
}
