//! Mesh files: bytes to corners, triangles and normals.

mod obj;
mod ply;

use tracer::glam::DVec3;
use tracer::shape::MeshNormals;

/// What a mesh file holds; indices are checked by the tracer.
#[derive(Debug, Clone)]
pub(crate) struct MeshData {
    pub(crate) vertices: Vec<DVec3>,
    pub(crate) faces: Vec<[u32; 3]>,
    pub(crate) normals: Option<MeshNormals>,
}

/// Reads a mesh by the ending of its file's name.
///
/// # Errors
/// What is wrong, as the end of a sentence that starts with the file's name.
pub(crate) fn read(path: &str, bytes: &[u8]) -> Result<MeshData, String> {
    let ending = path.rsplit_once('.').map_or("", |(_, ending)| ending);
    if ending.eq_ignore_ascii_case("obj") {
        obj::read(bytes)
    } else if ending.eq_ignore_ascii_case("ply") {
        ply::read(bytes)
    } else {
        Err("is neither an OBJ nor a PLY file by its name: expected one that ends in .obj or .ply"
            .to_owned())
    }
}

#[cfg(test)]
mod tests;
