//! A scene's shapes as a Wavefront OBJ file, with their colors as its MTL file.
//!
//! The format has no cameras and no lights: those are to be said besides.

use std::collections::{BTreeMap, BTreeSet};

use super::plain::{Look, Plain, Solid, Triangles};
use super::text::{put, spaced};
use super::{Exported, number};
use crate::Feature;

const MAIN: &str = "scene.obj";
const MATERIALS: &str = "scene.mtl";

/// What is in the files, and what in none of them.
const CAN: &[Feature] = &[
    Feature::Triangle,
    Feature::Box,
    Feature::Plane,
    Feature::Mesh,
    Feature::Constant,
    Feature::Lambert,
    Feature::BlinnPhong,
    Feature::ColoredHighlight,
];
const BESIDE: [&str; 4] = ["cameras", "lights", "shading", "samples"];

/// # Errors
/// What OBJ has no words for: round shapes, pictures of normals or distances.
pub(super) fn write(plain: &Plain) -> Result<Exported, BTreeSet<Feature>> {
    let is_beside =
        |feature: &Feature| BESIDE.contains(&feature.family()) || *feature == Feature::Background;
    let beside: BTreeSet<_> = plain.asks.iter().copied().filter(is_beside).collect();
    let can: Vec<_> = CAN.iter().copied().chain(beside.iter().copied()).collect();
    plain.asks_only(&can)?;
    let mut text = format!("mtllib {MATERIALS}\n");
    let mut materials = String::new();
    let mut known: Vec<&Look> = Vec::new();
    let (mut corners, mut normals) = (0, 0);
    for (k, object) in plain.objects.iter().enumerate() {
        let triangles = match object.solid(plain) {
            Solid::Triangles(triangles) => triangles,
            Solid::Plane { point, normal, reach } => Triangles::square(point, normal, reach),
            // It has no words for them; that was asked before.
            _ => continue,
        };
        let m = known.iter().position(|look| **look == object.look).unwrap_or_else(|| {
            materials += &material(known.len(), &object.look);
            known.push(&object.look);
            known.len() - 1
        });
        put(&mut text, format_args!("o object{k}\nusemtl m{m}\n"));
        text += &triangles.obj(&mut corners, &mut normals);
    }
    let files = BTreeMap::from([
        (MAIN.to_owned(), text.into_bytes()),
        (MATERIALS.to_owned(), materials.into_bytes()),
    ]);
    Ok(Exported { main: MAIN.to_owned(), files, grid: 1, beside })
}

fn material(m: usize, look: &Look) -> String {
    let inside = match look {
        // Model 0 is the color as it is, 1 is Lambert's, 2 has a highlight.
        Look::Constant(color) => format!("Kd {}\nillum 0\n", spaced(*color)),
        Look::Lit { diffuse, highlight: None } => format!("Kd {}\nillum 1\n", spaced(*diffuse)),
        Look::Lit { diffuse, highlight: Some((specular, exponent)) } => format!(
            "Kd {}\nKs {}\nNs {}\nillum 2\n",
            spaced(*diffuse),
            spaced(*specular),
            number(*exponent)
        ),
        // It has no words for them; that was asked before.
        Look::Normal(_) | Look::Depth { .. } => String::new(),
    };
    format!("newmtl m{m}\n{inside}")
}

impl Triangles {
    /// As statements of an OBJ file that has so many corners and normals before.
    pub(super) fn obj(&self, corners: &mut usize, normals: &mut usize) -> String {
        let mut text = String::new();
        for corner in &self.corners {
            put(&mut text, format_args!("v {}\n", spaced(corner.to_array())));
        }
        for normal in &self.normals {
            put(&mut text, format_args!("vn {}\n", spaced(normal.to_array())));
        }
        for face in &self.faces {
            let words = face.map(|i| {
                let i = i as usize;
                let corner = *corners + i + 1;
                let normal = *normals + i + 1;
                if self.normals.is_empty() {
                    format!(" {corner}")
                } else {
                    format!(" {corner}//{normal}")
                }
            });
            put(&mut text, format_args!("f{}\n", words.concat()));
        }
        *corners += self.corners.len();
        *normals += self.normals.len();
        text
    }
}
