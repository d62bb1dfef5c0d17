//! Mesh files: bytes to corners, triangles and normals.

mod obj;
mod ply;

use tracer::glam::DVec3;
use tracer::shape::MeshNormals;

/// What a mesh file holds; indices are checked by the tracer.
#[derive(Debug, Clone)]
pub struct MeshData {
    /// Its corners.
    pub vertices: Vec<DVec3>,
    /// Its triangles, by the numbers of their corners.
    pub faces: Vec<[u32; 3]>,
    /// Normals at the triangles' corners, if it has them.
    pub normals: Option<MeshNormals>,
}

/// Whether a file's name is that of a mesh.
///
/// # Errors
/// What is wrong, as the end of a sentence that starts with the file's name.
pub(crate) fn check_ending(path: &str) -> Result<(), String> {
    reader(path).map(|_| ())
}

/// Whether a file's name is one that a scene may name as a mesh.
pub fn is_mesh(path: &str) -> bool {
    check_ending(path).is_ok()
}

/// Reads a mesh by the ending of its file's name.
///
/// # Errors
/// What is wrong, as the end of a sentence that starts with the file's name.
pub fn read(path: &str, bytes: &[u8]) -> Result<MeshData, String> {
    reader(path)?(bytes)
}

type Reader = fn(&[u8]) -> Result<MeshData, String>;

fn reader(path: &str) -> Result<Reader, String> {
    let ending = path.rsplit_once('.').map_or("", |(_, ending)| ending);
    match ending.to_ascii_lowercase().as_str() {
        "obj" => Ok(obj::read),
        "ply" => Ok(ply::read),
        _ => Err("is neither an OBJ nor a PLY file by its name: expected one that ends in .obj \
                  or .ply"
            .to_owned()),
    }
}

#[cfg(test)]
mod tests;
