//! PLY, text or binary: the elements `vertex` and `face`; everything else is
//! passed over.

use ply_rs_bw::parser::Parser;
use ply_rs_bw::ply::{DefaultElement, Property};
use tracer::glam::DVec3;
use tracer::shape::{MeshNormals, MeshUvs};

use super::MeshData;

/// A vertex has `x`, `y`, `z` and may have `nx`, `ny`, `nz` and texture coordinates
/// by one of the names in [`UVS`]; a face has a list
/// `vertex_indices` (or `vertex_index`) and is cut into triangles as a fan.
pub(super) fn read(mut bytes: &[u8]) -> Result<MeshData, String> {
    let parser = Parser::<DefaultElement>::new();
    let header = parser.read_ply_header(&mut &*bytes).map_err(|error| unreadable(&error))?;
    // The parser makes as many elements as the header says, even of nothing.
    for element in header.elements.values() {
        if element.properties.is_empty() || element.count > bytes.len() {
            return Err(format!(
                "is not a readable PLY file: {} elements `{}` of {} properties in {} bytes",
                element.count,
                element.name,
                element.properties.len(),
                bytes.len()
            ));
        }
    }
    let ply = parser.read_ply(&mut bytes).map_err(|error| unreadable(&error))?;
    let elements = |name: &str| {
        let found = ply.payload.get(name).filter(|elements| !elements.is_empty());
        found.ok_or_else(|| format!("has no element `{name}`, which a mesh needs"))
    };
    let (vertices, faces) = (elements("vertex")?, elements("face")?);

    let uvs = UVS.into_iter().find_map(|names| {
        vertices.iter().map(|v| numbers(v, names)).collect::<Option<Vec<[f64; 2]>>>()
    });
    let mut mesh =
        MeshData { vertices: Vec::new(), faces: Vec::new(), normals: None, uvs: Err(no_uvs()) };
    for vertex in vertices {
        let position = triple(vertex, ["x", "y", "z"])
            .ok_or("has a vertex without the numbers `x`, `y` and `z`")?;
        mesh.vertices.push(position);
    }
    for (number, face) in faces.iter().enumerate() {
        let corners = ["vertex_indices", "vertex_index"]
            .into_iter()
            .find_map(|name| indices(face.get(name)?))
            .ok_or_else(|| {
                format!(
                    "has a face without a list `vertex_indices` of whole numbers from 0: \
                     number {number}"
                )
            })?;
        let [first, rest @ ..] = &corners[..] else {
            continue;
        };
        mesh.faces.extend(rest.windows(2).map(|pair| [*first, pair[0], pair[1]]));
    }
    let normals: Option<Vec<_>> = vertices.iter().map(|v| triple(v, ["nx", "ny", "nz"])).collect();
    mesh.normals = normals.map(|normals| MeshNormals { normals, faces: mesh.faces.clone() });
    if let Some(uvs) = uvs {
        mesh.uvs = Ok(MeshUvs { uvs, faces: mesh.faces.clone() });
    }
    Ok(mesh)
}

/// The first line of the parser's error says what; the rest is its inside.
fn unreadable(error: &impl std::fmt::Display) -> String {
    let error = error.to_string();
    let first: String = error.lines().next().unwrap_or("").chars().take(80).collect();
    format!("is not a readable PLY file: {first}")
}

/// The names of a vertex's `u` and `v`, as programs write them.
const UVS: [[&str; 2]; 4] =
    [["s", "t"], ["u", "v"], ["texture_u", "texture_v"], ["texture_s", "texture_t"]];

/// Why a file has no texture coordinates.
fn no_uvs() -> String {
    let names = UVS.map(|[u, v]| format!("`{u}` and `{v}`"));
    format!("has vertices without texture coordinates ({})", names.join(", "))
}

fn triple(element: &DefaultElement, names: [&str; 3]) -> Option<DVec3> {
    numbers(element, names).map(DVec3::from_array)
}

/// Numbers of an element by their names.
fn numbers<const N: usize>(element: &DefaultElement, names: [&str; N]) -> Option<[f64; N]> {
    let mut found = [0.0; N];
    for (found, name) in found.iter_mut().zip(names) {
        *found = number(element.get(name)?)?;
    }
    Some(found)
}

fn number(property: &Property) -> Option<f64> {
    match *property {
        Property::Char(x) => Some(x.into()),
        Property::UChar(x) => Some(x.into()),
        Property::Short(x) => Some(x.into()),
        Property::UShort(x) => Some(x.into()),
        Property::Int(x) => Some(x.into()),
        Property::UInt(x) => Some(x.into()),
        Property::Float(x) => Some(x.into()),
        Property::Double(x) => Some(x),
        _ => None,
    }
}

/// A list of whole numbers as indices; `None` for another kind of property and
/// for a negative number.
fn indices(property: &Property) -> Option<Vec<u32>> {
    fn all<T: Copy + TryInto<u32>>(list: &[T]) -> Option<Vec<u32>> {
        list.iter().map(|&i| i.try_into().ok()).collect()
    }
    match property {
        Property::ListChar(list) => all(list),
        Property::ListUChar(list) => all(list),
        Property::ListShort(list) => all(list),
        Property::ListUShort(list) => all(list),
        Property::ListInt(list) => all(list),
        Property::ListUInt(list) => all(list),
        _ => None,
    }
}
