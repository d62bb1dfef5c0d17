//! Textures of MTL: what is seen of them, what is lost, what is broken.

use scene::format::{TexelEncoding, TexelFilter, Texture, Wrap};

use super::*;
use crate::import::tests::{at_unit_square, four_colors, letters, png};

const UNIT: &str = "mtllib lib/a.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\n\
                    vt 0 1\nusemtl m\nf 1/1 2/2 3/3 4/4\n";

/// A square with this library and these files, which are beside the library.
fn unit_with(statements: &str, files: &[(&str, Vec<u8>)]) -> Result<Imported, Vec<Unreadable>> {
    let beside = |(name, bytes): &(&str, Vec<u8>)| (format!("lib/{name}"), bytes.clone());
    let mut assets: BTreeMap<_, _> = files.iter().map(beside).collect();
    let library = format!("newmtl m\nKd 1\n{statements}\n");
    assets.insert("lib/a.mtl".to_owned(), library.into_bytes());
    let source = Source { name: "a.obj", bytes: UNIT.as_bytes() };
    crate::import::import(source, &at_unit_square(), &assets)
}

/// The four pixels of the square and everything that is lost.
#[track_caller]
fn check(statements: &str, pixels: &str, expected_lost: &str) {
    let files = [("a.png", four_colors()), ("my a.png", four_colors())];
    let imported = unit_with(statements, &files).unwrap();
    assert_eq!(letters(&imported), pixels, "{statements}");
    assert_eq!(lost(&imported), expected_lost, "{statements}");
    let said = imported.chosen.join("; ");
    assert!(said.contains("textures multiply Kd"), "{said}");
}

const UPRIGHT: &str = "r-- -g- --b rgb";

#[test]
fn textures_are_seen_as_they_are_laid() {
    check("illum 0\nmap_Kd a.png", UPRIGHT, "");
    check("illum 0\nmap_kd my a.png", UPRIGHT, "");
    check("illum 0\nmap_Kd -blendu on -mm 0 1 -t 0 0 0 -cc off -s 1 1 1 a.png", UPRIGHT, "");
    check("illum 0\nKd 1 0 0\nmap_Kd a.png", "r-- --- --- r--", "");
    check("illum 0\nmap_Kd -o 0.5 a.png", "-g- r-- rgb --b", "");
    check("illum 0\nmap_Kd -o 0 0.5 0 a.png", "--b rgb r-- -g-", "");
    check("illum 0\nmap_Kd -s -1 1 1 a.png", "-g- r-- rgb --b", "");
    check("illum 0\nmap_Kd -s 2 2 -o 0.75 0.75 -clamp on a.png", "-g- -g- -g- -g-", "");
    check("illum 0\nmap_Kd -clamp off -s 3 -o 0.5 -clamp off a.png", "r-- -g- --b rgb", "");
}

#[test]
fn every_lit_model_takes_one() {
    for (statements, expected) in [
        ("illum 1", "Lambert"),
        ("illum 2\nKs 1\nNs 5", "BlinnPhong"),
        ("illum 3\nKs 0.5\nNs 5", "Whitted"),
    ] {
        let files = [("a.png", four_colors())];
        let imported = unit_with(&format!("{statements}\nmap_Kd a.png"), &files).unwrap();
        let material = &imported.scene.materials["m"];
        assert!(format!("{material:?}").starts_with(expected), "{material:?}");
        let texture = Texture::Image {
            file: "lib/a.png".to_owned(),
            filter: TexelFilter::Bilinear,
            wrap: Wrap::Repeat,
            encoding: TexelEncoding::Srgb,
            scale: [1.0; 2],
            offset: [0.0; 2],
        };
        assert_eq!(material.texture(), Some(&texture));
        assert_eq!(imported.files["lib/a.png"], four_colors());
        picture(&imported);
    }
}

#[test]
fn options_that_are_not_done_are_lost() {
    for (option, what) in [
        ("-mm 0.5 1", "a range of values of its own"),
        ("-t 0 0 1", "turbulence"),
        ("-cc on", "a correction of colors"),
        ("-blendu off", "a texture without smoothing"),
        ("-blendv OFF", "a texture without smoothing"),
        ("-texres 64", "a resolution of its own"),
        ("-boost 1.5", "a sharpness of its own"),
        ("-imfchan r", "one channel alone"),
        ("-type sphere", "a shape to be laid around"),
        ("-bm 1", "a strength of relief"),
    ] {
        let keyword = option.split(' ').next().unwrap();
        let said =
            format!("1:8: map_Kd {keyword} of material \"m\" (lib/a.mtl:4): {what} is left out\n");
        check(&format!("illum 0\nmap_Kd {option} a.png"), UPRIGHT, &said);
    }
}

#[test]
fn pictures_that_are_not_read_are_lost_and_broken_ones_refused() {
    let lost_with = |name: &str, bytes: Vec<u8>| {
        let imported = unit_with(&format!("illum 0\nmap_Kd {name}"), &[(name, bytes)]).unwrap();
        assert_eq!(letters(&imported), "rgb rgb rgb rgb");
        lost(&imported)
    };
    let said = |name: &str, why: &str| {
        format!(
            "1:8: map_Kd of material \"m\" (lib/a.mtl:4): the texture is left out, Kd stays: \
             \"{name}\" {why}\n"
        )
    };
    let other = "is no PNG file, the only pictures that are read";
    assert_eq!(lost_with("a.jpg", b"\xff\xd8\xff\xe0".to_vec()), said("a.jpg", other));
    assert_eq!(lost_with("a", b"".to_vec()), said("a", other));
    let glass = png(1, &[[0, 0, 0, 255], [0, 0, 0, 128]]);
    let why = "is not opaque, first at (0, 1) from its upper left: expected no alpha below 1";
    assert_eq!(lost_with("a.png", glass), said("a.png", why));
    // By its bytes it is one.
    let imported = unit_with("illum 0\nmap_Kd a.tga", &[("a.tga", four_colors())]).unwrap();
    assert_eq!((letters(&imported).as_str(), lost(&imported).as_str()), (UPRIGHT, ""));

    let refused = |files: &[(&str, Vec<u8>)], name: &str, expected: &str| {
        check_refused(&unit_with(&format!("map_Kd {name}"), files), expected);
    };
    let place = "1:8: map_Kd of material \"m\" (lib/a.mtl:3): the texture";
    refused(&[], "a.png", &format!("{place} \"a.png\" does not exist"));
    refused(&[], "a.jpg", &format!("{place} \"a.jpg\" does not exist"));
    refused(&[], "/a.png", &format!("{place} \"/a.png\" is not"));
    refused(&[], "b\\a.png", &format!("{place} \"b\\a.png\" is not"));
    let whole = four_colors();
    for length in [0, 4, 8, 20, whole.len() / 2, whole.len() - 1] {
        let cut = [("a.png", whole[..length].to_vec())];
        refused(&cut, "a.png", &format!("{place} \"a.png\" is not a readable PNG file"));
    }
}

#[test]
fn faces_without_coordinates_have_no_texture() {
    let text = format!("{UNIT}v 9 0 0\nv 9 1 0\nf 1 5 6\nusemtl m\nf 5 6 1\n");
    let library = b"newmtl m\nmap_Kd a.png\nillum 1\n".to_vec();
    let assets = BTreeMap::from(
        [("lib/a.mtl", library), ("lib/a.png", four_colors())].map(|(n, b)| (n.to_owned(), b)),
    );
    let source = Source { name: "a.obj", bytes: text.as_bytes() };
    let imported = crate::import::import(source, &at_unit_square(), &assets).unwrap();
    let said = "faces without texture coordinates are shown without its texture";
    assert_eq!(lost(&imported), format!("material \"m\": {said}\n"));
    let materials = &imported.scene.materials;
    assert_eq!(materials.keys().collect::<Vec<_>>(), ["m", "m without texture"]);
    let white = Material::Lambert { diffuse: Some([1.0; 3]), texture: None };
    assert_eq!(materials["m without texture"], white);
    picture(&imported);
    // Where no face has any, the textured material is nobody's.
    let none = text.replace("f 1/1 2/2 3/3 4/4", "f 1 2 3 4");
    let source = Source { name: "a.obj", bytes: none.as_bytes() };
    let imported = crate::import::import(source, &at_unit_square(), &assets).unwrap();
    assert_eq!(imported.scene.materials.keys().collect::<Vec<_>>(), ["m without texture"]);
    picture(&imported);
}
