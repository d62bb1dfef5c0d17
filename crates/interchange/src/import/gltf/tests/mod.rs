//! glTF files: a sample in all forms, and what is read of it.

mod hostile;
mod looks;
mod textures;

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use serde_json::{Value, json};
use tracer::glam::{DMat3, DVec3};

use super::*;
use crate::import::tests::{TETRAHEDRON, check_refused, lost, picture};

/// The sample body: positions, normals and texture coordinates in `f32`, then
/// indices in one, two and four bytes.
fn bytes() -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut put = |x: f64| bytes.extend((x as f32).to_le_bytes());
    TETRAHEDRON.as_flattened().as_flattened().iter().for_each(|&x| put(x));
    for i in 0..12 {
        [f64::from(i / 3) * 0.125, -2.0, 0.5].into_iter().for_each(&mut put);
    }
    (0..12).for_each(|i| [f64::from(i) / 16.0, 0.25].into_iter().for_each(&mut put));
    (0..12_u8).for_each(|i| bytes.push(i));
    (0..12_u16).for_each(|i| bytes.extend(i.to_le_bytes()));
    (0..12_u32).for_each(|i| bytes.extend(i.to_le_bytes()));
    bytes
}

/// A document with one mesh of them in one node; its buffer has no address.
fn document() -> Value {
    let view = |offset: usize, length: usize| json!({"buffer": 0, "byteOffset": offset, "byteLength": length});
    let list = |view: usize, kind: u32, shape: &str| json!({"bufferView": view, "componentType": kind, "count": 12, "type": shape});
    json!({
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 3}]}],
        "accessors": [
            list(0, 5126, "VEC3"), list(1, 5126, "VEC3"), list(2, 5126, "VEC2"),
            list(3, 5121, "SCALAR"), list(4, 5123, "SCALAR"), list(5, 5125, "SCALAR"),
        ],
        "bufferViews": [
            view(0, 144), view(144, 144), view(288, 96), view(384, 12), view(396, 24), view(420, 48),
        ],
        "buffers": [{"byteLength": bytes().len()}],
    })
}

/// As JSON that has its buffer in it.
pub(in crate::import) fn text(mut document: Value) -> String {
    if document["buffers"][0].get("uri").is_none() {
        let data = STANDARD.encode(bytes());
        document["buffers"][0]["uri"] =
            format!("data:application/gltf-buffer;base64,{data}").into();
    }
    document.to_string()
}

/// The sample as a GLB file.
pub(in crate::import) fn glb(document: &Value) -> Vec<u8> {
    let mut json = document.to_string().into_bytes();
    json.resize(json.len().next_multiple_of(4), b' ');
    let mut buffer = bytes();
    buffer.resize(buffer.len().next_multiple_of(4), 0);
    let length = 12 + 8 + json.len() + 8 + buffer.len();
    let word = |x: usize| (x as u32).to_le_bytes();
    let mut file = b"glTF".to_vec();
    file.extend([word(2), word(length), word(json.len())].concat());
    file.extend(b"JSON");
    file.extend(json);
    file.extend(word(buffer.len()));
    file.extend(b"BIN\0");
    file.extend(buffer);
    file
}

/// The sample document, for tests of all formats.
pub(in crate::import) fn sample(has_normals: bool) -> Value {
    let mut document = document();
    if has_normals {
        document["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] = 1.into();
    }
    document
}

fn import_file(name: &str, bytes: &[u8]) -> Result<Imported, Vec<Unreadable>> {
    let mut assets = BTreeMap::new();
    assets.insert("some data.bin".to_owned(), self::bytes());
    crate::import::import(Source { name, bytes }, &Wishes::default(), &assets)
}

/// The sample with changes.
fn import(change: impl FnOnce(&mut Value)) -> Result<Imported, Vec<Unreadable>> {
    let mut document = document();
    change(&mut document);
    import_file("a.gltf", text(document).as_bytes())
}

/// The corners of the triangles of an imported mesh, by the number of the file.
fn corners(imported: &Imported, file: usize) -> Vec<[DVec3; 3]> {
    let text = String::from_utf8(imported.files.values().nth(file).unwrap().clone()).unwrap();
    let numbers = |line: &str| -> Vec<f64> {
        line.split([' ', '/']).filter_map(|word| word.parse().ok()).collect()
    };
    let of = |keyword: &'static str| text.lines().filter(move |line| line.starts_with(keyword));
    let vertices: Vec<_> = of("v ").map(|line| DVec3::from_slice(&numbers(line))).collect();
    let step = |face: &str| face.split(' ').nth(1).map_or(1, |corner| corner.split('/').count());
    of("f ")
        .map(|face| {
            let all = numbers(face);
            [0, 1, 2].map(|k| vertices[all[k * step(face)] as usize - 1])
        })
        .collect()
}

/// The sample body's triangles, moved.
fn moved(map: impl Fn(DVec3) -> DVec3) -> Vec<[DVec3; 3]> {
    TETRAHEDRON.iter().map(|face| face.map(|p| map(DVec3::from(p)))).collect()
}

#[test]
fn all_forms_are_the_same() {
    let inside = import_file("a.gltf", text(document()).as_bytes()).unwrap();
    assert_eq!(import_file("a.glb", &glb(&document())).unwrap(), inside);
    assert_eq!(import_file("a.gltf", &glb(&document())).unwrap(), inside, "bytes tell");
    for uri in ["some data.bin", "some%20data.bin", "./some%20data.bin"] {
        let outside = import(|all| all["buffers"][0]["uri"] = uri.into());
        assert_eq!(outside.unwrap(), inside, "{uri}");
    }
    assert_eq!(lost(&inside), "");
    assert_eq!(corners(&inside, 0), moved(|p| p));
    picture(&inside);
    for indices in [4, 5] {
        let other = import(|all| all["meshes"][0]["primitives"][0]["indices"] = indices.into());
        assert_eq!(other.unwrap(), inside);
    }
    let without = import(|all| {
        all["meshes"][0]["primitives"][0].as_object_mut().unwrap().remove("indices");
    });
    assert_eq!(without.unwrap(), inside);
}

#[test]
fn normals_and_coordinates_are_kept() {
    let imported = import(|all| {
        let attributes = &mut all["meshes"][0]["primitives"][0]["attributes"];
        *attributes = json!({"POSITION": 0, "NORMAL": 1, "TEXCOORD_0": 2, "TANGENT": 99});
    });
    let imported = imported.unwrap();
    let text = String::from_utf8(imported.files["a-default.obj"].clone()).unwrap();
    assert!(text.contains("vn 0.375 -2 0.5\n"), "{text}");
    assert!(text.contains("vt 0.0625 0.75\n"), "from the lower left: {text}");
    assert!(text.contains("f 1/1/1 2/2/2 3/3/3\n"), "{text}");
    picture(&imported);
}

#[test]
fn strips_and_fans_turn_as_the_specification_says() {
    let with = |mode: u32| {
        let imported = import(|all| {
            all["meshes"][0]["primitives"][0]["mode"] = mode.into();
            all["accessors"][3]["count"] = 5.into();
        });
        corners(&imported.unwrap(), 0)
    };
    let p = |i: usize| DVec3::from(TETRAHEDRON.as_flattened()[i]);
    assert_eq!(with(5), [[p(0), p(1), p(2)], [p(1), p(3), p(2)], [p(2), p(3), p(4)]]);
    assert_eq!(with(6), [[p(1), p(2), p(0)], [p(2), p(3), p(0)], [p(3), p(4), p(0)]]);
    // A list of five has one triangle.
    assert_eq!(with(4), [[p(0), p(1), p(2)]]);
}

#[test]
fn nodes_move_what_is_in_them() {
    let with = |nodes: Value| import(|all| all["nodes"] = nodes).unwrap();
    let steps = with(json!([
        {"translation": [1, 2, 3], "children": [1]},
        {"rotation": [0, 0, 2, 2], "scale": [2, 1, 0.5], "mesh": 0},
    ]));
    // A quarter turn about z, after the scale: (x, y, z) to (-y, 2 x, z / 2).
    let map = |p: DVec3| DVec3::new(1.0 - p.y, 2.0 + 2.0 * p.x, 3.0 + 0.5 * p.z);
    assert_eq!(corners(&steps, 0), moved(map));
    let matrix = with(json!([{
        "matrix": [0, 2, 0, 0, -1, 0, 0, 0, 0, 0, 0.5, 0, 1, 2, 3, 1], "mesh": 0
    }]));
    assert_eq!(corners(&matrix, 0), moved(map));
    // A shear, and the same mesh as it is, in one file.
    let shear = [1.0, 0.0, 0.0, 0.0, 0.5, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0];
    let both = with(json!([{"children": [1, 2]}, {"matrix": shear, "mesh": 0}, {"mesh": 0}]));
    let mut expected = moved(|p| DVec3::new(p.x + 0.5 * p.y, p.y, p.z));
    expected.extend(moved(|p| p));
    assert_eq!(corners(&both, 0), expected);
    // In a mirror, corners change places, so that fronts stay fronts.
    let mirrored = with(json!([{"scale": [-1, 1, 1], "mesh": 0}]));
    let flip = |[a, b, c]: [DVec3; 3]| [a, c, b];
    let expected = moved(|p| DVec3::new(-p.x, p.y, p.z)).into_iter().map(flip);
    assert_eq!(corners(&mirrored, 0), expected.collect::<Vec<_>>());
}

#[test]
fn normals_stay_across_their_surface() {
    for scale in [[3.0, 0.5, 1.0], [-1.0, 1.0, 2.0], [-1.0, -1.0, -2.0]] {
        let imported = import(|all| {
            all["nodes"] = json!([{"rotation": [0.5, 0.5, 0.5, 0.5], "children": [1]},
                {"scale": scale, "mesh": 0}]);
            all["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] = 1.into();
        });
        let text = String::from_utf8(imported.unwrap().files["a-default.obj"].clone()).unwrap();
        let normal = text.lines().filter(|line| line.starts_with("vn")).nth(3).unwrap();
        let normal: Vec<f64> = normal[3..].split(' ').map(|x| x.parse().unwrap()).collect();
        // By hand: divide by the scale, then x goes to y, y to z, z to x.
        let n = DVec3::new(0.125, -2.0, 0.5) / DVec3::from(scale);
        let expected = (DMat3::from_cols(DVec3::Y, DVec3::Z, DVec3::X) * n).normalize();
        assert!((DVec3::from_slice(&normal) - expected).length() < 1e-15, "{normal:?}, {expected}");
    }
    let flat = import(|all| {
        all["nodes"][0]["scale"] = json!([1, 1, 0]);
        all["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] = 1.into();
    });
    assert!(lost(&flat.unwrap()).contains("its node has no inverse: normals are left out"));
}

#[test]
fn sparse_and_quantized_numbers() {
    let imported = import(|all| {
        // Vertex 2 of the sample becomes vertex 0's, and vertex 5 vertex 1's.
        all["bufferViews"].as_array_mut().unwrap().extend([
            json!({"buffer": 0, "byteOffset": 386, "byteLength": 1}),
            json!({"buffer": 0, "byteOffset": 0, "byteLength": 12}),
        ]);
        all["accessors"][0]["sparse"] = json!({
            "count": 1,
            "indices": {"bufferView": 6, "componentType": 5121},
            "values": {"bufferView": 7},
        });
    });
    let mut expected = moved(|p| p);
    expected[0][2] = expected[0][0];
    assert_eq!(corners(&imported.unwrap(), 0), expected);
    // Indices 0 to 11 in two bytes, as positions between 0 and 1.
    let imported = import(|all| {
        all["extensionsRequired"] = json!(["KHR_mesh_quantization"]);
        all["extensionsUsed"] = json!(["KHR_mesh_quantization"]);
        all["accessors"][0] = json!({
            "bufferView": 4, "componentType": 5123, "count": 3, "type": "VEC3", "normalized": true,
        });
        all["bufferViews"][4]["byteStride"] = 8.into();
        all["accessors"][3]["count"] = 3.into();
    });
    let imported = imported.unwrap();
    let row = |i: f64| DVec3::new(i, i + 1.0, i + 2.0) / 65_535.0;
    assert_eq!(corners(&imported, 0), [[row(0.0), row(4.0), row(8.0)]]);
    assert_eq!(lost(&imported), "");
}
