//! The meshes that rays are sent through: read from where they are installed,
//! or generated.

mod architecture;
mod read;
mod round;

use std::path::Path;

use crate::{files, peers};

/// A mesh as every engine takes it: corners and, for each triangle, the numbers
/// of its three.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct TriangleMesh {
    pub(crate) vertices: Vec<[f32; 3]>,
    pub(crate) faces: Vec<[u32; 3]>,
}

/// From where a mesh is looked at.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Viewpoint {
    /// From outside, so that its box fills the picture; light from above.
    Outside,
    /// From a place inside; both places in the mesh's own space.
    Inside { eye: [f64; 3], at: [f64; 3], light: [f64; 3] },
}

/// A mesh with its name and its viewpoint.
#[derive(Debug)]
pub(crate) struct SceneMesh {
    pub(crate) name: String,
    pub(crate) mesh: TriangleMesh,
    pub(crate) view: Viewpoint,
    /// Whether its surface is closed, so that a line meets it an even number of
    /// times.
    pub(crate) is_closed: bool,
}

/// The scenes that a run without `--scenes` measures.
pub(crate) const USUAL: [&str; 6] =
    ["dragon-11k", "dragon-47k", "dragon-202k", "dragon-871k", "kitchen", "hall"];

/// The dragons, and their files.
const DRAGONS: [(&str, &str); 4] = [
    ("dragon-11k", "dragon_vrip_res4.ply.gz"),
    ("dragon-47k", "dragon_vrip_res3.ply.gz"),
    ("dragon-202k", "dragon_vrip_res2.ply.gz"),
    ("dragon-871k", "dragon_vrip.ply.gz"),
];

/// Where the kitchen's own example stands, and what it looks at.
const KITCHEN_EYE: [f64; 3] = [3.0, 1.5, 1.4];
const KITCHEN_AT: [f64; 3] = [-3.9, 1.5, -1.7];
/// A lamp under the kitchen's ceiling.
const KITCHEN_LIGHT: [f64; 3] = [0.0, 2.2, 0.0];

/// Triangles in the smallest and the largest mesh that `bumpy-N` makes.
const BUMPY_RANGE: std::ops::RangeInclusive<u32> = 8..=4_000_000;

/// The mesh of this name; `Ok(None)` if it is a known one that is not
/// installed.
///
/// # Errors
/// A name that is none, and a file that cannot be read.
pub(crate) fn named(name: &str) -> Result<Option<SceneMesh>, String> {
    let scene =
        |mesh, view, is_closed| Some(SceneMesh { name: name.to_owned(), mesh, view, is_closed });
    if let Some((_, file)) = DRAGONS.iter().find(|(dragon, _)| *dragon == name) {
        let mesh = read_if_there(&peers::dragon_folder().join(file))?;
        // The scan has holes under its feet and elsewhere.
        return Ok(mesh.and_then(|mesh| scene(mesh, Viewpoint::Outside, false)));
    }
    match name {
        "kitchen" => {
            let view = Viewpoint::Inside { eye: KITCHEN_EYE, at: KITCHEN_AT, light: KITCHEN_LIGHT };
            let mesh = peers::kitchen().map(|path| read_if_there(&path)).transpose()?.flatten();
            Ok(mesh.and_then(|mesh| scene(mesh, view, false)))
        }
        "hall" => Ok(scene(architecture::hall(), architecture::VIEW, false)),
        _ => {
            let triangles = name.strip_prefix("bumpy-").and_then(|count| count.parse().ok());
            let triangles = triangles.filter(|count| BUMPY_RANGE.contains(count));
            let triangles = triangles.ok_or_else(|| {
                format!(
                    "--scenes: expected one of {}, or bumpy-N with N triangles from {} to {}, \
                     found `{name}`",
                    USUAL.join(", "),
                    BUMPY_RANGE.start(),
                    BUMPY_RANGE.end(),
                )
            })?;
            Ok(scene(round::bumpy(triangles), Viewpoint::Outside, true))
        }
    }
}

fn read_if_there(path: &Path) -> Result<Option<TriangleMesh>, String> {
    let Some(bytes) = files::read_kept(path) else {
        return Ok(None);
    };
    let name = path.to_string_lossy();
    let mesh = read::by_name(&name, &bytes);
    mesh.map(Some).map_err(|why| {
        format!("{name}: {why}; install it again: cargo xtask bench peers --install")
    })
}

impl TriangleMesh {
    /// The corners of the box around all of it.
    pub(crate) fn bounds(&self) -> [[f64; 3]; 2] {
        let mut bounds = [[f64::INFINITY; 3], [f64::NEG_INFINITY; 3]];
        for vertex in &self.vertices {
            for axis in 0..3 {
                let x = f64::from(vertex[axis]);
                bounds[0][axis] = bounds[0][axis].min(x);
                bounds[1][axis] = bounds[1][axis].max(x);
            }
        }
        bounds
    }
}

#[cfg(test)]
mod tests;
