//! Cameras, lights and materials of glTF files, and what is lost.

use scene::format::{Camera, Falloff, Light, Material};

use super::*;

#[test]
fn the_first_camera_is_the_view() {
    let imported = import(|all| {
        all["cameras"] = json!([
            {"type": "perspective", "perspective": {"yfov": 1.0, "znear": 0.1, "aspectRatio": 2.0}},
            {"type": "orthographic",
             "orthographic": {"xmag": 3.0, "ymag": 1.5, "znear": 0, "zfar": 9}},
        ]);
        all["nodes"] = json!([
            {"mesh": 0, "children": [1, 2]},
            // Looks along -x: half a turn of -z about y and z would; here -z to -x.
            {"camera": 0, "translation": [9, 0.25, 0.25], "rotation": [0, 0.5, 0, 0.5],
             "scale": [7, 7, 7]},
            {"camera": 1},
        ]);
    });
    let mut imported = imported.unwrap();
    assert_eq!(imported.scene.image, (512, 256));
    let Camera::Perspective { view_point, view_dir, view_up, view_width, view_height, .. } =
        imported.scene.camera
    else {
        panic!("{:?}", imported.scene.camera);
    };
    let near = |a: [f64; 3], b: [f64; 3]| (DVec3::from(a) - DVec3::from(b)).length() < 1e-12;
    assert_eq!(view_point, [9.0, 0.25, 0.25]);
    assert!(near(view_dir, [-1.0, 0.0, 0.0]) && near(view_up, [0.0, 1.0, 0.0]), "{view_dir:?}");
    assert_eq!(view_height, 2.0 * libm::tan(0.5));
    assert_eq!(view_width, 2.0 * view_height);
    assert!(imported.chosen.iter().any(|said| said.contains("the first of 2 cameras")));
    picture(&imported);
    imported.scene.image = (1, 1);

    let parallel = import(|all| {
        all["cameras"] = json!([
            {"type": "orthographic", "orthographic": {"xmag": 1.5, "ymag": 3.0, "znear": 0, "zfar": 9}},
        ]);
        all["nodes"] = json!([{"mesh": 0}, {"camera": 0, "translation": [0, 0, 5]}]);
        all["scenes"][0]["nodes"] = json!([0, 1]);
    });
    let parallel = parallel.unwrap();
    assert_eq!(parallel.scene.image, (256, 512));
    let Camera::Parallel { view_width, view_height, .. } = parallel.scene.camera else {
        panic!("{:?}", parallel.scene.camera);
    };
    assert_eq!((view_width, view_height), (3.0, 6.0));
    picture(&parallel);
}

#[test]
fn a_wished_camera_and_size_come_first() {
    let mut with_camera = document();
    with_camera["cameras"] = json!([{"perspective": {"yfov": 1.0, "aspectRatio": 2.0}}]);
    with_camera["nodes"][0]["camera"] = 0.into();
    let text = text(with_camera);
    let camera = Camera::LookAt { eye: [5.0; 3], at: [0.0; 3], up: [0.0, 1.0, 0.0], fov_deg: 30.0 };
    let import = |camera, image| {
        let source = Source { name: "a.gltf", bytes: text.as_bytes() };
        crate::import::import(
            source,
            &Wishes { camera, image, ..Wishes::default() },
            &scene::NoAssets,
        )
        .unwrap()
    };
    let wished = import(Some(camera), Some((30, 20)));
    assert_eq!((wished.scene.camera, wished.scene.image), (camera, (30, 20)));
    let direction = [-5.0; 3];
    assert!(
        matches!(wished.scene.lights[0], Light::Directional { direction: d, .. } if d == direction)
    );
    assert_eq!(import(Some(camera), None).scene.image, (512, 512));
    let Camera::Perspective { view_width, view_height, .. } =
        import(None, Some((30, 10))).scene.camera
    else {
        panic!("not the file's");
    };
    assert_eq!(view_width, 3.0 * view_height, "pixels are square");
}

#[test]
fn lights_are_where_their_nodes_are() {
    let imported = import(|all| {
        all["extensionsUsed"] = json!(["KHR_lights_punctual"]);
        all["extensions"] = json!({"KHR_lights_punctual": {"lights": [
            {"type": "point", "color": [1, 0.5, 0], "intensity": 8, "range": 3},
            {"type": "directional"},
            {"type": "spot", "spot": {}},
        ]}});
        let light = |light: u32| json!({"KHR_lights_punctual": {"light": light}});
        all["nodes"] = json!([
            {"mesh": 0, "children": [1, 2, 3]},
            {"extensions": light(0), "translation": [1, 2, 3]},
            {"extensions": light(1), "matrix": [0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 1]},
            {"extensions": light(2)},
        ]);
    });
    let imported = imported.unwrap();
    assert_eq!(
        imported.scene.lights,
        [
            Light::Point {
                position: [1.0, 2.0, 3.0],
                intensity: [8.0, 4.0, 0.0],
                falloff: Some(Falloff::InverseSquare),
            },
            Light::Directional { direction: [-0.0, -0.0, -1.0], intensity: [1.0; 3] },
        ]
    );
    let found = lost(&imported);
    assert_eq!(
        found,
        "lights[0]: range: it is left out: the light reaches everywhere\n\
         lights[2]: spot lights are left out\n"
    );
    picture(&imported);
}

/// The material that it becomes, what is lost, and that something is seen.
#[track_caller]
fn check(material: &Value, expected: &Material, expected_lost: &str) {
    picture(&check_unseen(material, expected, expected_lost));
}

/// The same, but for a mirror with nothing around.
#[track_caller]
fn check_unseen(material: &Value, expected: &Material, expected_lost: &str) -> Imported {
    let imported = import(|all| {
        all["meshes"][0]["primitives"][0]["material"] = 0.into();
        all["materials"] = json!([material]);
    });
    let imported = imported.unwrap();
    assert_eq!(imported.scene.materials.values().next(), Some(expected), "{material}");
    assert_eq!(lost(&imported), expected_lost, "{material}");
    imported
}

#[test]
fn materials_are_their_base_colors() {
    let white = || Material::Lambert { diffuse: Some([1.0; 3]), texture: None };
    let plain = json!({"metallicFactor": 0, "baseColorFactor": [1, 0.5, 0, 0.25]});
    let orange = || Material::Lambert { diffuse: Some([1.0, 0.5, 0.0]), texture: None };
    check(&json!({"pbrMetallicRoughness": plain}), &orange(), "");
    let lost = "materials[0]: pbrMetallicRoughness: metallic 1 and roughness 1 are left out: it \
                scatters its base color evenly\n";
    check(&json!({"name": "a"}), &white(), lost);
    let smooth = |metal: u32| {
        let base = [1.0, 0.5, 0.0, 1.0];
        json!({"pbrMetallicRoughness":
            {"metallicFactor": metal, "roughnessFactor": 0, "baseColorFactor": base}})
    };
    let mirror = Material::Mirror { reflectance: [1.0, 0.5, 0.0], schlick: true };
    check_unseen(&smooth(1), &mirror, "");
    let glazed = Material::Glazed {
        texture: None,
        ior: 1.5,
        schlick: true,
        diffuse: Some([1.0, 0.5, 0.0]),
        specular: [0.0; 3],
        exponent: 1.0,
    };
    check(&smooth(0), &glazed, "");
    let unlit = json!({"KHR_materials_unlit": {}});
    check(
        &json!({"extensions": unlit, "pbrMetallicRoughness": plain, "emissiveFactor": [1, 1, 1]}),
        &Material::Constant { color: [1.0, 0.5, 0.0], texture: None },
        "",
    );
    let all = json!({
        "pbrMetallicRoughness": {"metallicFactor": 0},
        "normalTexture": {}, "occlusionTexture": {}, "emissiveTexture": {},
        "emissiveFactor": [1, 0, 0], "alphaMode": "BLEND",
        "extensions": {"KHR_materials_ior": {"ior": 1.25}, "KHR_materials_sheen": {}},
    });
    let what = [
        "normalTexture: the texture is left out",
        "occlusionTexture: the texture is left out",
        "emissiveTexture: the texture is left out",
        "emissiveFactor: it emits no light",
        "alphaMode: it is opaque",
        "KHR_materials_sheen: this extension is not read",
        "KHR_materials_ior: it is left out",
    ];
    let lost = what.map(|what| format!("materials[0]: {what}\n")).concat();
    check(&all, &white(), &lost);
}

#[test]
fn clear_glass_is_glass_and_other_is_lost() {
    let with = |change: fn(&mut Value)| {
        let mut material = json!({
            "pbrMetallicRoughness":
                {"metallicFactor": 0, "roughnessFactor": 0, "baseColorFactor": [1, 0.5, 0.25, 1]},
            "extensions": {
                "KHR_materials_transmission": {"transmissionFactor": 1},
                "KHR_materials_volume": {"thicknessFactor": 0.5},
                "KHR_materials_ior": {"ior": 1.25},
            },
        });
        change(&mut material);
        material
    };
    let glass = |ior| Material::Dielectric { ior, tint: [1.0, 0.5, 0.25], schlick: true };
    check_unseen(&with(|_| ()), &glass(1.25), "");
    let without_index = with(|all| all["extensions"]["KHR_materials_ior"] = json!({}));
    check_unseen(&without_index, &glass(1.5), "");
    let glazed = |ior| Material::Glazed {
        texture: None,
        ior,
        schlick: true,
        diffuse: Some([1.0, 0.5, 0.25]),
        specular: [0.0; 3],
        exponent: 1.0,
    };
    let lost = "materials[0]: KHR_materials_transmission: it is opaque: only what has no metal, no \
                roughness, all of its light going through and a volume without attenuation is glass\n";
    let lost_too: [fn(&mut Value); 4] = [
        |all| all["extensions"]["KHR_materials_transmission"]["transmissionFactor"] = 0.5.into(),
        |all| all["extensions"]["KHR_materials_transmission"]["transmissionTexture"] = json!({}),
        |all| all["extensions"]["KHR_materials_volume"]["attenuationDistance"] = 1.into(),
        |all| all["extensions"]["KHR_materials_volume"]["thicknessFactor"] = 0.into(),
    ];
    for change in lost_too {
        check(&with(change), &glazed(1.25), lost);
    }
    let no_index = |all: &mut Value| {
        all["extensions"]["KHR_materials_transmission"]["transmissionFactor"] = 0.5.into();
        all["extensions"]["KHR_materials_ior"]["ior"] = 0.into();
    };
    let both = format!("{lost}materials[0]: KHR_materials_ior: it is left out\n");
    check(&with(no_index), &glazed(1.5), &both);
    let closed = with(|all| all["extensions"]["KHR_materials_transmission"] = json!({}));
    check(&closed, &glazed(1.25), "materials[0]: KHR_materials_volume: it is opaque\n");
}

#[test]
fn each_material_has_its_mesh_and_name() {
    let imported = import(|all| {
        let primitive = |material: u32| json!({"attributes": {"POSITION": 0}, "indices": 3, "material": material});
        all["meshes"][0]["primitives"] = json!([primitive(1), primitive(0), primitive(1),
            {"attributes": {"POSITION": 0}}]);
        let matte = json!({"metallicFactor": 0});
        all["materials"] = json!([
            {"name": "same", "pbrMetallicRoughness": matte, "doubleSided": true},
            {"name": "same", "pbrMetallicRoughness": matte, "doubleSided": true},
        ]);
    });
    let imported = imported.unwrap();
    let names: Vec<_> = imported.scene.materials.keys().collect();
    assert_eq!(names, ["default", "same", "same (1)"]);
    let files: Vec<_> = imported.files.keys().collect();
    assert_eq!(files, ["a-default.obj", "a-same--1-.obj", "a-same.obj"]);
    assert_eq!(corners(&imported, 2).len(), 8);
    assert!(imported.chosen.iter().any(|said| said.contains("back faces are seen")));
}

#[test]
fn everything_dropped_is_said() {
    let imported = import(|all| {
        all["animations"] = json!([{}, {}]);
        all["extensionsUsed"] = json!(["KHR_texture_transform", "KHR_lights_punctual"]);
        all["nodes"][0]["skin"] = 0.into();
        all["nodes"][0]["extensions"] = json!({"EXT_mesh_gpu_instancing": {}});
        all["meshes"][0]["weights"] = json!([0.5]);
        let primitives = all["meshes"][0]["primitives"].as_array_mut().unwrap();
        primitives[0]["targets"] = json!([{}]);
        primitives[0]["attributes"]["COLOR_0"] = 0.into();
        primitives[0]["attributes"]["_MINE"] = 0.into();
        primitives.push(json!({"attributes": {"POSITION": 0}, "mode": 0}));
        primitives.push(json!({"attributes": {"POSITION": 0}, "mode": 3}));
        primitives.push(json!({"attributes": {"NORMAL": 0}}));
    });
    let found = lost(&imported.unwrap());
    for part in [
        "animations: 2 of them are left out",
        "extensionsUsed: KHR_texture_transform: this extension is used and not read",
        "nodes[0]: the skin is left out",
        "nodes[0]: EXT_mesh_gpu_instancing: this extension is not read",
        "meshes[0]: weights of morph targets",
        "meshes[0].primitives[0]: morph targets",
        "primitives[0]: COLOR_0: colors of vertices",
        "primitives[0]: _MINE: numbers of the file's own",
        "primitives[1]: points are left out",
        "primitives[2]: lines are left out",
        "primitives[3]: it has no POSITION",
    ] {
        assert!(found.contains(part), "{part}: {found}");
    }
    assert!(!found.contains("KHR_lights_punctual"), "{found}");
}
