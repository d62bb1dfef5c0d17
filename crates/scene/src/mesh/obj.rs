//! Wavefront OBJ: positions, faces, normals and texture coordinates; everything else is passed over.

use tobj::{LoadError, LoadOptions, LoadResult};
use tracer::glam::DVec3;
use tracer::shape::{MeshNormals, MeshUvs};

use super::MeshData;

/// The largest file in which the line of an error is looked for.
const SEARCHED_BYTES: usize = 4 << 20;

/// Polygons are cut into triangles as fans; objects and groups of the file are
/// put together in order. Normals and texture coordinates count where every face
/// has them. Of the latter, `u` goes right and `v` up.
pub(super) fn read(bytes: &[u8]) -> Result<MeshData, String> {
    let (models, _) = load(bytes).map_err(|error| {
        // Reading it again and again to find the line is for files that are
        // read in no time.
        if bytes.len() > SEARCHED_BYTES {
            return format!("is not a readable OBJ file: {error}");
        }
        let line = first_bad_line(bytes);
        format!("is not a readable OBJ file: line {line}: {error}")
    })?;
    let mut mesh =
        MeshData { vertices: Vec::new(), faces: Vec::new(), normals: None, uvs: no_uvs(bytes) };
    let mut normals = MeshNormals { normals: Vec::new(), faces: Vec::new() };
    let mut uvs = MeshUvs { uvs: Vec::new(), faces: Vec::new() };
    for model in models {
        let tobj::Mesh { positions, indices, normals: n, normal_indices, .. } = model.mesh;
        let tobj::Mesh { texcoords, texcoord_indices, .. } = model.mesh;
        mesh.faces.extend(shifted(&indices, mesh.vertices.len())?);
        mesh.vertices.extend(points(&positions));
        normals.faces.extend(shifted(&normal_indices, normals.normals.len())?);
        normals.normals.extend(points(&n));
        uvs.faces.extend(shifted(&texcoord_indices, uvs.uvs.len())?);
        uvs.uvs.extend(texcoords.as_chunks::<2>().0);
    }
    if every_corner_has(bytes, NORMAL) && normals.faces.len() == mesh.faces.len() {
        mesh.normals = Some(normals);
    }
    if every_corner_has(bytes, UV) && uvs.faces.len() == mesh.faces.len() {
        mesh.uvs = Ok(uvs);
    }
    Ok(mesh)
}

fn load(mut bytes: &[u8]) -> LoadResult {
    let options = LoadOptions {
        triangulate: true,
        single_index: false,
        ignore_points: true,
        ignore_lines: true,
    };
    // Materials are the scene's: a library that the file names is not opened.
    tobj::load_obj_buf(&mut bytes, &options, |_| Err(LoadError::OpenFileFailed))
}

/// Where in a corner the texture coordinates are named (`a/t` or `a/t/n`).
const UV: usize = 1;
/// Where in a corner the normal is named (`a//n` or `a/t/n`).
const NORMAL: usize = 2;

/// Why a file has no texture coordinates that can be used.
fn no_uvs(bytes: &[u8]) -> Result<MeshUvs, String> {
    let mut lines = bytes.split(|&b| b == b'\n').map(<[u8]>::trim_ascii);
    let why = if lines.any(|line| line.starts_with(b"vt ")) {
        "has texture coordinates (`vt`), but not at every corner of its faces"
    } else {
        "has no texture coordinates (`vt`)"
    };
    Err(why.to_owned())
}

/// Whether every corner of every face names one of these. The reader stands in
/// any other one where it does not.
fn every_corner_has(bytes: &[u8], place: usize) -> bool {
    let lines = bytes.split(|&b| b == b'\n').map(<[u8]>::trim_ascii);
    let faces = lines.filter_map(|line| line.strip_prefix(b"f "));
    let corners = faces.flat_map(|face| face.split(u8::is_ascii_whitespace));
    corners
        .filter(|corner| !corner.is_empty())
        .all(|corner| corner.split(|&b| b == b'/').nth(place).is_some_and(|name| !name.is_empty()))
}

fn points(numbers: &[f64]) -> impl Iterator<Item = DVec3> {
    numbers.as_chunks::<3>().0.iter().map(|&p| DVec3::from_array(p))
}

/// Triples of indices, counted on from those of the models before.
fn shifted(indices: &[u32], by: usize) -> Result<Vec<[u32; 3]>, String> {
    let shift = |i: u32| u32::try_from(i as usize + by).ok();
    let triples = indices.as_chunks::<3>().0.iter();
    triples
        .map(|&[a, b, c]| Some([shift(a)?, shift(b)?, shift(c)?]))
        .collect::<Option<_>>()
        .ok_or_else(|| "has more than 4294967295 corners".to_owned())
}

/// The line at which reading fails: the last of the shortest beginning of the
/// file that cannot be read, found by halving.
fn first_bad_line(bytes: &[u8]) -> usize {
    let ends: Vec<usize> = bytes.split_inclusive(|&b| b == b'\n').map(<[u8]>::len).collect();
    let fails = |lines: usize| load(&bytes[..ends[..lines].iter().sum()]).is_err();
    let (mut good, mut bad) = (0, ends.len());
    while bad - good > 1 {
        let middle = usize::midpoint(good, bad);
        if fails(middle) {
            bad = middle;
        } else {
            good = middle;
        }
    }
    bad
}
