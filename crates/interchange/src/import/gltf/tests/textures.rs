//! Textures of glTF files.

use super::*;
use crate::import::tests::{at_unit_square, four_colors, letters, png};

/// The square from 0 to 1 with coordinates from the upper left, unlit, with a
/// texture; the picture is in the third view.
fn square(picture: &[u8]) -> Value {
    let mut bytes = Vec::new();
    let mut put = |numbers: &[f32]| bytes.extend(numbers.iter().flat_map(|x| x.to_le_bytes()));
    let corners = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    put(corners.map(|[x, y]| [x, y, 0.0]).as_flattened());
    put(corners.map(|[x, y]| [x, 1.0 - y]).as_flattened());
    bytes.extend(picture);
    let data = STANDARD.encode(&bytes);
    json!({
        "asset": {"version": "2.0"},
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [
            {"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "mode": 6, "material": 0},
        ]}],
        "materials": [{
            "doubleSided": true,
            "pbrMetallicRoughness": {"baseColorTexture": {"index": 0}},
            "extensions": {"KHR_materials_unlit": {}},
        }],
        "textures": [{"source": 0}],
        "images": [{"bufferView": 2, "mimeType": "image/png"}],
        "samplers": [{}],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"},
            {"bufferView": 1, "componentType": 5126, "count": 4, "type": "VEC2"},
        ],
        "bufferViews": [
            {"buffer": 0, "byteLength": 48},
            {"buffer": 0, "byteOffset": 48, "byteLength": 32},
            {"buffer": 0, "byteOffset": 80, "byteLength": picture.len()},
        ],
        "buffers": [{"byteLength": bytes.len(), "uri": format!("data:;base64,{data}")}],
    })
}

fn import_square(
    picture: &[u8],
    change: impl FnOnce(&mut Value),
) -> Result<Imported, Vec<Unreadable>> {
    let mut document = square(picture);
    change(&mut document);
    let files = [("a b.png", picture), ("b", picture)];
    let assets = files.map(|(name, bytes)| (name.to_owned(), bytes.to_vec()));
    let text = document.to_string();
    let source = Source { name: "a.gltf", bytes: text.as_bytes() };
    crate::import::import(source, &at_unit_square(), &BTreeMap::from(assets))
}

/// The four pixels of the square, and everything that is lost.
#[track_caller]
fn check(change: impl FnOnce(&mut Value), pixels: &str, expected_lost: &str) {
    let imported = import_square(&four_colors(), change).unwrap();
    assert_eq!(letters(&imported), pixels);
    assert_eq!(lost(&imported), expected_lost);
}

const UPRIGHT: &str = "r-- -g- --b rgb";

#[test]
fn pictures_stand_upright_wherever_they_are() {
    check(|_| (), UPRIGHT, "");
    let data = STANDARD.encode(four_colors());
    let inline = format!("data:image/png;base64,{data}");
    check(|all| all["images"][0] = json!({"uri": inline}), UPRIGHT, "");
    check(|all| all["images"][0] = json!({"uri": "./a%20b.png"}), UPRIGHT, "");
    // By its bytes it is one.
    check(|all| all["images"][0] = json!({"uri": "b", "mimeType": "image/jpeg"}), UPRIGHT, "");
    let imported = import_square(&four_colors(), |all| all["images"][0] = json!({"uri": "b"}));
    assert_eq!(imported.unwrap().files["b.png"], four_colors());
    check(
        |all| {
            all["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"] = json!([0, 1, 1, 1]);
        },
        "--- -g- --b -gb",
        "",
    );
}

#[test]
fn samplers_say_what_is_seen_beyond() {
    let with = |sampler: Value| {
        move |all: &mut Value| {
            all["textures"][0]["sampler"] = 0.into();
            all["samplers"][0] = sampler;
        }
    };
    check(with(json!({})), UPRIGHT, "");
    check(with(json!({"magFilter": 9728, "minFilter": 9987})), UPRIGHT, "");
    check(with(json!({"wrapS": 33071, "wrapT": 33071, "magFilter": 9729})), UPRIGHT, "");
    let place = "materials[0]: baseColorTexture: the texture is repeated";
    let mirrored = format!("{place}, and not mirrored by turns\n");
    check(with(json!({"wrapS": 33648})), UPRIGHT, &mirrored);
    let one_way = format!("{place} both ways, and not one way alone\n");
    check(with(json!({"wrapT": 33071})), UPRIGHT, &one_way);
    let texture = |sampler: Value| {
        let imported = import_square(&four_colors(), with(sampler)).unwrap();
        let material = imported.scene.materials.into_values().next().unwrap();
        format!("{:?}", material.texture().unwrap())
    };
    let clamped = texture(json!({"wrapS": 33071, "wrapT": 33071, "magFilter": 9728}));
    assert!(clamped.contains("Nearest") && clamped.contains("Clamp"), "{clamped}");
    let plain = texture(json!({}));
    assert!(plain.contains("Bilinear") && plain.contains("Repeat"), "{plain}");
}

#[test]
fn textures_that_are_not_read_are_lost() {
    let white = "rgb rgb rgb rgb";
    let place = "materials[0]: baseColorTexture:";
    let info = "baseColorTexture";
    check(
        |all| all["materials"][0]["pbrMetallicRoughness"][info]["texCoord"] = 1.into(),
        white,
        &format!("{place} the texture is left out, as it has coordinates of its own\n"),
    );
    check(
        |all| {
            let texture = &mut all["materials"][0]["pbrMetallicRoughness"][info];
            texture["extensions"] = json!({"KHR_texture_transform": {"scale": [2, 2]}});
        },
        UPRIGHT,
        &format!("{place} the extension KHR_texture_transform is not read\n"),
    );
    check(
        |all| all["textures"][0] = json!({"extensions": {"KHR_texture_basisu": {"source": 0}}}),
        white,
        &format!(
            "{place} the extension KHR_texture_basisu is not read\n\
             {place} the texture is left out, as it has no picture that is read\n"
        ),
    );
    check(
        |all| {
            let look = &mut all["materials"][0];
            look["extensions"] = json!({});
            look["pbrMetallicRoughness"]["roughnessFactor"] = 0.into();
            all["meshes"][0]["primitives"][0]["attributes"] = json!({"POSITION": 0});
        },
        "--- --- --- ---",
        &format!("{place} the texture is left out\n"),
    );
    let jpeg = import_square(b"\xff\xd8\xff\xe0", |all| {
        all["images"][0]["mimeType"] = "image/jpeg".into();
    });
    let said = "the texture is left out: images[0] is no PNG file, the only pictures that are read";
    assert_eq!(lost(&jpeg.unwrap()), format!("{place} {said}\n"));
    let blended = |all: &mut Value| all["materials"][0]["alphaMode"] = "BLEND".into();
    let clear = import_square(&png(1, &[[9, 9, 9, 0]]), blended).unwrap();
    assert!(lost(&clear).contains("images[0] is not opaque, first at (0, 0)"), "{}", lost(&clear));
    assert!(lost(&clear).contains("alphaMode: it is opaque"), "{}", lost(&clear));
    check(
        |all| all["meshes"][0]["primitives"][0]["attributes"] = json!({"POSITION": 0}),
        white,
        "material \"material 0\": faces without texture coordinates are shown without its texture\n",
    );
}

#[test]
fn alpha_does_not_count_where_the_material_is_opaque() {
    let colors = [[255, 0, 0, 0], [0, 255, 0, 255], [0, 0, 255, 7], [255, 255, 255, 254]];
    let clear = png(2, &colors);
    for mode in [None, Some("OPAQUE")] {
        let imported = import_square(&clear, |all| {
            if let Some(mode) = mode {
                all["materials"][0]["alphaMode"] = mode.into();
            }
        });
        let imported = imported.unwrap();
        assert_eq!((letters(&imported).as_str(), lost(&imported).as_str()), (UPRIGHT, ""));
    }
    // One picture of two materials counts in one and not in the other.
    let imported = import_square(&clear, |all| {
        let mut other = all["materials"][0].clone();
        other["alphaMode"] = "MASK".into();
        all["materials"].as_array_mut().unwrap().push(other);
        let mut primitive = all["meshes"][0]["primitives"][0].clone();
        primitive["material"] = 1.into();
        all["meshes"][0]["primitives"].as_array_mut().unwrap().push(primitive);
    });
    let said = lost(&imported.unwrap());
    let of = |material: &str| said.lines().filter(|line| line.starts_with(material)).count();
    assert_eq!((of("materials[0]"), of("materials[1]")), (0, 2), "{said}");
}

#[test]
fn broken_textures_are_refused() {
    #[track_caller]
    fn check(change: impl FnOnce(&mut Value), expected: &str) {
        check_refused(&import_square(&four_colors(), change), expected);
    }
    let info = |all: &mut Value, index: u32| {
        all["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["index"] = index.into();
    };
    check(|all| info(all, 1), "materials[0]: expected one of the 1 textures, found number 1");
    check(
        |all| all["textures"][0]["source"] = 7.into(),
        "textures[0]: expected one of the 1 images, found number 7",
    );
    check(
        |all| all["textures"][0]["sampler"] = 7.into(),
        "textures[0]: expected one of the 1 samplers, found number 7",
    );
    let sampler = |key: &'static str| {
        move |all: &mut Value| {
            all["textures"][0]["sampler"] = 0.into();
            all["samplers"][0][key] = 5.into();
        }
    };
    check(sampler("wrapT"), "expected a wrap of 10497, 33071 or 33648, found 5");
    check(sampler("magFilter"), "expected a magFilter of 9728 or 9729, found 5");
    check(|all| all["images"][0] = json!({}), "images[0] is not there: expected a `uri` or a");
    check(
        |all| all["images"][0]["uri"] = "a b.png".into(),
        "expected a `uri` or a `bufferView`, one of them",
    );
    check(
        |all| all["images"][0] = json!({"uri": "gone.png"}),
        "materials[0]: images[0] is not there: the file \"gone.png\" does not exist",
    );
    for outside in ["../a b.png", "/a b.png", "http://localhost/a.png", "%2e%2e/a b.png"] {
        check(
            |all| all["images"][0] = json!({"uri": outside}),
            "expected a file in the document's own folder or below it",
        );
    }
    check(|all| all["images"][0] = json!({"uri": "data:image/png,x"}), "expected `data:` with");
    check(|all| all["images"][0]["bufferView"] = 9.into(), "expected one of the 3 bufferViews");
    check(|all| all["bufferViews"][2]["byteLength"] = 99_999.into(), "bufferViews[2]: expected");
    let whole = four_colors();
    for length in [0, 8, whole.len() / 2, whole.len() - 1] {
        let cut = import_square(&whole[..length], |_| ());
        check_refused(&cut, "materials[0]: images[0] is not a readable PNG file");
    }
}
