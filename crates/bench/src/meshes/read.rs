//! Mesh files: bytes, packed or not, to triangles.

use std::io::Read;

use flate2::read::GzDecoder;
use ply_rs_bw::parser::{Parser, Reader};
use ply_rs_bw::ply::{Property, PropertyAccess, PropertyAccessResult};

use super::TriangleMesh;

/// Reads a mesh by the ending of its file's name: `.ply` or `.obj`, and one of
/// these packed as `.gz` or `.zst`.
///
/// # Errors
/// What is wrong, as the end of a sentence that starts with the file's name.
pub(super) fn by_name(name: &str, bytes: &[u8]) -> Result<TriangleMesh, String> {
    let unreadable = |why: &dyn std::fmt::Display| format!("is not readable: {why}");
    let (stem, ending) = name.rsplit_once('.').unwrap_or((name, ""));
    let mut unpacked = Vec::new();
    match ending {
        "gz" => {
            GzDecoder::new(bytes).read_to_end(&mut unpacked).map_err(|why| unreadable(&why))?;
            by_name(stem, &unpacked)
        }
        "zst" => {
            let mut packed = bytes;
            let decoder = ruzstd::decoding::StreamingDecoder::new(&mut packed);
            let mut decoder = decoder.map_err(|why| unreadable(&why))?;
            decoder.read_to_end(&mut unpacked).map_err(|why| unreadable(&why))?;
            by_name(stem, &unpacked)
        }
        "ply" => ply(bytes),
        "obj" => obj(bytes),
        _ => Err("expected a name that ends in .ply or .obj, or in one of these and .gz or .zst"
            .to_owned()),
    }
}

/// A corner of a PLY file; other properties are passed over.
struct Vertex([f32; 3]);

impl PropertyAccess for Vertex {
    fn new() -> Self {
        Self([f32::NAN; 3])
    }

    fn set_property(&mut self, name: &str, value: Property) -> PropertyAccessResult {
        let axis = ["x", "y", "z"].iter().position(|axis| *axis == name);
        let (Some(axis), Some(value)) = (axis, value.to_f32_lossy()) else {
            return PropertyAccessResult::Ignored;
        };
        self.0[axis] = value;
        PropertyAccessResult::Set
    }
}

/// A polygon of a PLY file.
struct Face(Vec<u32>);

impl PropertyAccess for Face {
    fn new() -> Self {
        Self(Vec::new())
    }

    fn set_property(&mut self, name: &str, value: Property) -> PropertyAccessResult {
        let is_list = name == "vertex_indices" || name == "vertex_index";
        let Some(list) = is_list.then(|| value.to_u32_list()).flatten() else {
            return PropertyAccessResult::Ignored;
        };
        self.0 = list;
        PropertyAccessResult::Set
    }
}

fn ply(bytes: &[u8]) -> Result<TriangleMesh, String> {
    let unreadable = |why: &dyn std::fmt::Display| format!("is not a readable PLY file: {why}");
    let mut reader = Reader::new(bytes);
    let header = Parser::<Vertex>::new().read_header(&mut reader);
    let header = header.map_err(|why| unreadable(&why))?;
    let mut mesh = TriangleMesh { vertices: Vec::new(), faces: Vec::new() };
    for element in header.elements.values() {
        match element.name.as_str() {
            "vertex" => {
                let parser = Parser::<Vertex>::new();
                let vertices = parser.read_payload_for_element(&mut reader, element, &header);
                let vertices = vertices.map_err(|why| unreadable(&why))?;
                mesh.vertices = vertices.into_iter().map(|vertex| vertex.0).collect();
            }
            "face" => {
                let parser = Parser::<Face>::new();
                let faces = parser.read_payload_for_element(&mut reader, element, &header);
                for face in faces.map_err(|why| unreadable(&why))? {
                    push_fan(&mut mesh.faces, &face.0);
                }
            }
            other => return Err(format!("expected elements `vertex` and `face`, found `{other}`")),
        }
    }
    checked(mesh)
}

fn obj(mut bytes: &[u8]) -> Result<TriangleMesh, String> {
    let options = tobj::LoadOptions { triangulate: true, ..tobj::LoadOptions::default() };
    // Materials are not looked at.
    let no_materials = |_: &std::path::Path| Err(tobj::LoadError::OpenFileFailed);
    let (models, _) = tobj::load_obj_buf(&mut bytes, &options, no_materials)
        .map_err(|why| format!("is not a readable OBJ file: {why}"))?;
    let mut mesh = TriangleMesh { vertices: Vec::new(), faces: Vec::new() };
    for model in models {
        let first = mesh.vertices.len() as u32;
        let corners = model.mesh.positions.chunks_exact(3);
        mesh.vertices.extend(corners.map(|p| [p[0], p[1], p[2]].map(|x| x as f32)));
        let faces = model.mesh.indices.chunks_exact(3);
        mesh.faces.extend(faces.map(|f| [f[0] + first, f[1] + first, f[2] + first]));
    }
    checked(mesh)
}

/// Cuts a polygon into triangles that share its first corner.
fn push_fan(faces: &mut Vec<[u32; 3]>, polygon: &[u32]) {
    if let [first, rest @ ..] = polygon {
        faces.extend(rest.windows(2).map(|pair| [*first, pair[0], pair[1]]));
    }
}

fn checked(mesh: TriangleMesh) -> Result<TriangleMesh, String> {
    if mesh.faces.is_empty() {
        return Err("expected at least one triangle, found none".to_owned());
    }
    if let Some(wrong) = mesh.faces.iter().flatten().find(|&&i| i as usize >= mesh.vertices.len()) {
        let count = mesh.vertices.len();
        return Err(format!("expected numbers of its {count} corners, found {wrong}"));
    }
    if !mesh.vertices.iter().flatten().all(|x| x.is_finite()) {
        return Err("expected finite corners, found one that is not".to_owned());
    }
    Ok(mesh)
}

#[cfg(test)]
mod tests {
    use super::*;

    const TETRAHEDRON: &str = "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\n\
        property float y\nproperty float z\nelement face 2\n\
        property list uchar int vertex_indices\nend_header\n\
        0 0 0\n1 0 0\n1 1 0\n0 1 0.5\n4 0 1 2 3\n3 0 2 1\n";

    #[test]
    fn polygons_become_fans() {
        let mesh = by_name("a.ply", TETRAHEDRON.as_bytes()).unwrap();
        assert_eq!(mesh.vertices[3], [0.0, 1.0, 0.5]);
        assert_eq!(mesh.faces, [[0, 1, 2], [0, 2, 3], [0, 2, 1]]);
        let square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";
        assert_eq!(by_name("a.obj", square.as_bytes()).unwrap().faces.len(), 2);
    }

    #[test]
    fn what_is_wrong_is_said() {
        let wrong = |name: &str, text: &str| by_name(name, text.as_bytes()).unwrap_err();
        assert!(wrong("a.stl", "").starts_with("expected a name that ends in"));
        assert!(wrong("a.ply.gz", "no gzip").starts_with("is not readable"));
        let far = TETRAHEDRON.replace("3 0 2 1", "3 0 2 7");
        assert_eq!(wrong("a.ply", &far), "expected numbers of its 4 corners, found 7");
        let no_height = TETRAHEDRON.replace("property float z", "property float w");
        assert!(wrong("a.ply", &no_height).contains("finite"));
    }
}
