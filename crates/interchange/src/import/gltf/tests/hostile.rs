//! glTF files that are wrong, by mistake or on purpose.

use super::*;

#[track_caller]
fn check(change: impl FnOnce(&mut Value), expected: &str) {
    check_refused(&import(change), expected);
}

#[test]
fn texts_that_are_no_documents() {
    let check =
        |text: &str, expected| check_refused(&import_file("a.gltf", text.as_bytes()), expected);
    check("", "1:1: expected a glTF document, found: EOF");
    check("{\n \"asset\": 3}", "2:11: expected a glTF document, found: invalid type: integer `3`");
    check("{\"asset\": {\"version\": \"2.0\"}}", "expected triangles or polygons, found none");
    check("{}", "expected glTF of version 2.0 in `asset`, found \"\"");
    check("[]", "expected glTF of version 2.0");
    check("[1]", "expected a glTF document");
    check("{\"nodes\": [{\"mesh\": -1}]}", "invalid value: integer `-1`");
    check("{\"nodes\": [{\"translation\": [1e999, 0, 0]}]}", "number out of range");
    check(&"[".repeat(1_000_000), "expected a glTF document");
    // What is not looked at may be as deep as it likes.
    check(&"{\"extras\":".repeat(1_000_000), "expected a glTF document, found: EOF");
}

#[test]
fn versions_and_extensions_that_are_not_known() {
    check(|all| all["asset"]["version"] = "1.0".into(), "version 2.0 in `asset`, found \"1.0\"");
    check(|all| all["asset"]["minVersion"] = "2.1".into(), "found \"2.1\"");
    check(
        |all| all["extensionsRequired"] = json!(["KHR_draco_mesh_compression"]),
        "KHR_materials_volume, KHR_mesh_quantization, found \"KHR_draco_mesh_compression\"",
    );
}

#[test]
fn buffers_outside_the_folder_are_refused() {
    for uri in [
        "../some data.bin",
        "a/../some data.bin",
        "/some data.bin",
        "//host/a.bin",
        "http://127.0.0.1/a.bin",
        "HTTPS:a.bin",
        "file:///some%20data.bin",
        "file:some%20data.bin",
        "%2e%2e/some%20data.bin",
        "%2E%2E%2Fsome%20data.bin",
        "..%2fsome data.bin",
        "%2fsome data.bin",
        "..%5csome data.bin",
        "..\\some data.bin",
        "C:\\a.bin",
        "a%00.bin",
        "a%ff.bin",
        "%",
        "",
        ".",
        "a//b.bin",
        "././some data.bin",
    ] {
        let expected = "buffers[0]: expected a file in the document's own folder";
        check(|all| all["buffers"][0]["uri"] = uri.into(), expected);
    }
    let set = |uri: &'static str| move |all: &mut Value| all["buffers"][0]["uri"] = uri.into();
    check(set("gone.bin"), "buffers[0]: the file \"gone.bin\" does not exist");
    check(set("data:,abc"), "expected `data:` with a type");
    check(set("data:;base64,!!!"), "expected bytes in base 64");
    check(set("data:;base64,AAAA"), "buffers[0]: expected 468 bytes, found 3");
    let long = |all: &mut Value| all["buffers"][0]["byteLength"] = u64::MAX.into();
    check(long, "buffers[0]: expected 18446744073709551615 bytes, found 468");
}

#[test]
fn numbers_that_lead_nowhere() {
    check(|all| all["scene"] = 7.into(), "expected one of the 1 scenes, found number 7");
    check(
        |all| all["scenes"][0]["nodes"] = json!([9]),
        "expected one of the 1 nodes, found number 9",
    );
    check(|all| all["nodes"][0]["mesh"] = 9.into(), "nodes[0]: expected one of the 1 meshes");
    check(|all| all["nodes"][0]["camera"] = 9.into(), "nodes[0]: expected one of the 0 cameras");
    let light = json!({"KHR_lights_punctual": {"light": 9}});
    check(|all| all["nodes"][0]["extensions"] = light, "nodes[0]: expected one of the 0 lights");
    let primitive = |key: &'static str, value: Value| {
        move |all: &mut Value| all["meshes"][0]["primitives"][0][key] = value
    };
    check(primitive("indices", 9.into()), "primitives[0]: expected one of the 6 accessors");
    check(primitive("material", 9.into()), "expected one of the 0 materials");
    check(primitive("mode", 7.into()), "expected a mode from 0 to 6, found 7");
    check(primitive("attributes", json!({"POSITION": 9})), "expected one of the 6 accessors");
    let few = json!({"POSITION": 0, "NORMAL": 6});
    let normals = |all: &mut Value| {
        let mut more = all["accessors"][1].clone();
        more["count"] = 3.into();
        all["accessors"].as_array_mut().unwrap().push(more);
        primitive("attributes", few)(all);
    };
    check(normals, "expected 12 of NORMAL, one for each vertex, found 3");
}

#[test]
fn accessors_that_lie() {
    let accessor = |number: usize, key: &'static str, value: Value| {
        move |all: &mut Value| all["accessors"][number][key] = value
    };
    check(accessor(0, "bufferView", 9.into()), "accessors[0]: expected one of the 6 bufferViews");
    check(accessor(0, "count", 13.into()), "expected room for 13 elements of 12 bytes from byte 0");
    check(
        accessor(0, "count", u64::MAX.into()),
        "accessors[0]: expected at most 16777216 elements",
    );
    check(accessor(0, "byteOffset", 1.into()), "from byte 1 on in bufferViews[0], which has 144");
    check(accessor(0, "byteOffset", u64::MAX.into()), "from byte 18446744073709551615 on");
    check(accessor(0, "componentType", 5124.into()), "expected a componentType such as 5126");
    check(accessor(0, "type", "VEC4".into()), "expected the type VEC3, found \"VEC4\"");
    check(accessor(3, "componentType", 5120.into()), "expected whole numbers from 0 for `indices`");
    check(accessor(3, "normalized", true.into()), "expected whole numbers from 0 for `indices`");
    check(accessor(0, "count", 3.into()), "expected indices below 3, found 3");
    let view =
        |key: &'static str, value: Value| move |all: &mut Value| all["bufferViews"][0][key] = value;
    check(view("buffer", 9.into()), "expected one of the 1 buffers, found number 9");
    check(view("byteLength", 469.into()), "expected 469 bytes from byte 0 on in buffers[0]");
    check(
        view("byteOffset", u64::MAX.into()),
        "bufferViews[0]: expected 144 bytes from byte 184467",
    );
    check(view("byteStride", 0.into()), "expected a byteStride of at least 12, found 0");
    check(view("byteStride", u64::MAX.into()), "expected room for 12 elements");
    let nothing = |all: &mut Value| {
        all["accessors"][0].as_object_mut().unwrap().remove("bufferView");
        all["accessors"][0]["count"] = 10_000_000.into();
    };
    check(nothing, "expected a bufferView for 10000000 elements");
    let sparse = |count: u64, offset: u64| {
        move |all: &mut Value| {
            all["accessors"][0]["sparse"] = json!({
                "count": count,
                "indices": {"bufferView": 3, "componentType": 5121, "byteOffset": offset},
                "values": {"bufferView": 0},
            });
        }
    };
    check(sparse(13, 0), "expected at most 12 sparse elements, found 13");
    check(sparse(2, 11), "expected room for 2 elements of 1 bytes from byte 11");
    let beyond = |all: &mut Value| {
        sparse(6, 6)(all);
        all["accessors"][0]["count"] = 8.into();
    };
    check(beyond, "expected sparse indices below 8, found 8");
    let not_a_number = |all: &mut Value| {
        let mut bytes = bytes();
        bytes[8..12].copy_from_slice(&f32::NAN.to_le_bytes());
        let data = STANDARD.encode(bytes);
        all["buffers"][0]["uri"] = format!("data:;base64,{data}").into();
    };
    check(not_a_number, "accessors[0]: expected finite numbers, found another as number 2");
}

#[test]
fn nodes_that_are_no_tree() {
    let nodes = |nodes: Value| move |all: &mut Value| all["nodes"] = nodes;
    check(nodes(json!([{"children": [0]}])), "nodes[0]: expected a tree of nodes");
    check(nodes(json!([{"children": [1]}, {"children": [0]}])), "nodes[0]: expected a tree");
    let diamond = json!([{"children": [1, 2]}, {"children": [3]}, {"children": [3]}, {}]);
    check(nodes(diamond), "nodes[3]: expected a tree of nodes");
    check(nodes(json!([{"children": [5]}])), "expected one of the 1 nodes, found number 5");
    let zero = json!([{"rotation": [0, 0, 0, 0]}]);
    check(nodes(zero), "nodes[0]: expected a rotation of length 1");
    let row = [1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
    check(nodes(json!([{"matrix": row}])), "expected a matrix whose last row is 0, 0, 0, 1");
    let one = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
    let both = json!([{"matrix": one, "scale": [1, 1, 1]}]);
    check(nodes(both), "expected a matrix or its steps, found both");
    check(nodes(json!([{"mesh": 0, "scale": [1e70, 1, 1]}])), "expected vertices of numbers");
    let wild = json!([{"scale": [1e300, 1e300, 1e300], "children": [1]},
        {"scale": [1e300, 1e300, 1e300], "mesh": 0}]);
    check(nodes(wild), "expected vertices of numbers");
}

#[test]
fn a_million_nodes_inside_each_other_are_no_trouble() {
    const COUNT: usize = 1_000_000;
    let mut nodes: String =
        (1..COUNT).fold(String::new(), |all, child| all + &format!("{{\"children\":[{child}]}},"));
    nodes += "{\"mesh\":0}";
    let mut document = document();
    document["nodes"] = "NODES".into();
    let text = text(document).replace("\"NODES\"", &format!("[{nodes}]"));
    let imported = import_file("a.gltf", text.as_bytes()).unwrap();
    assert_eq!(corners(&imported, 0), moved(|p| p));
}

#[test]
fn the_same_mesh_too_often_is_refused_in_time() {
    let many = |all: &mut Value| {
        // Four thousand vertices in a node, and ten thousand nodes.
        let accessor = json!({"componentType": 5126, "count": 4000, "type": "VEC3"});
        all["accessors"] = json!([accessor]);
        all["meshes"] = json!([{"primitives": [{"attributes": {"POSITION": 0}}]}]);
        all["nodes"] = (0..10_000).map(|_| json!({"mesh": 0})).collect();
        all["scenes"][0]["nodes"] = (0..10_000).collect();
    };
    check(many, "expected at most 16777216 vertices and triangles in all nodes together");
}

#[test]
fn views_that_are_none() {
    let camera = |camera: Value| {
        move |all: &mut Value| {
            all["cameras"] = json!([camera]);
            all["nodes"][0]["camera"] = 0.into();
        }
    };
    check(camera(json!({})), "cameras[0]: expected `perspective` or `orthographic`");
    check(camera(json!({"perspective": {"yfov": 0}})), "expected a yfov between 0 and pi, found 0");
    check(camera(json!({"perspective": {"yfov": 3.2}})), "found 3.2");
    let wide = json!({"perspective": {"yfov": 1, "aspectRatio": 1e9}});
    check(camera(wide), "expected aspectRatio from 0.001 to 1000");
    let flat = json!({"orthographic": {"xmag": 1, "ymag": 0}});
    check(camera(flat), "expected xmag and ymag above 0, found 1 and 0");
    let nowhere = |all: &mut Value| {
        camera(json!({"perspective": {"yfov": 1}}))(all);
        all["nodes"][0]["scale"] = json!([0, 0, 0]);
    };
    check(nowhere, "expected a camera that looks somewhere");
    let light = |light: Value| {
        move |all: &mut Value| {
            all["extensions"] = json!({"KHR_lights_punctual": {"lights": [light]}});
            all["nodes"][0]["extensions"] = json!({"KHR_lights_punctual": {"light": 0}});
        }
    };
    check(light(json!({"type": "sun"})), "expected a light of type point, directional or spot");
    let dark = json!({"type": "point", "intensity": -1});
    check(light(dark), "lights[0]: expected a color and an intensity from 0");
    let color = |all: &mut Value| {
        all["materials"] = json!([{"pbrMetallicRoughness": {"baseColorFactor": [2, 0, 0, 1]}}]);
        all["meshes"][0]["primitives"][0]["material"] = 0.into();
    };
    check(color, "materials[0]: expected a baseColorFactor of numbers from 0 to 1");
}

#[test]
fn glb_files_that_are_cut_or_lie() {
    let whole = glb(&document());
    let check = |bytes: &[u8], expected| check_refused(&import_file("a.glb", bytes), expected);
    check(b"glTF", "expected a header of 12 bytes, found the end");
    check(&whole[..whole.len() - 1], "as it says, found");
    let with = |at: usize, word: u32| {
        let mut bytes = whole.clone();
        bytes[at..at + 4].copy_from_slice(&word.to_le_bytes());
        bytes
    };
    check(&with(4, 1), "expected version 2 of GLB, found 1");
    check(&with(12, u32::MAX), "expected a first chunk");
    check(&with(12, 4), "expected another chunk");
    let broken = |at: usize| {
        let mut bytes = whole.clone();
        bytes[at] = b'!';
        bytes
    };
    check(
        &broken(20),
        "expected a glTF document in the JSON of the GLB file, found: expected value",
    );
    check(&with(16, 0), "expected the first chunk of a GLB file to be JSON");
    let json = u32::from_le_bytes(whole[12..16].try_into().unwrap()) as usize;
    check(&with(20 + json, u32::MAX), "expected another chunk");
    check(&with(20 + json, 8), "buffers[0]: expected 468 bytes, found 8");
    check(&with(20 + json + 4, 1), "expected a `uri`, as there is no binary chunk");
}
