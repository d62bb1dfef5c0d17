//! OBJ files with their materials, good ones and broken ones.

use scene::format::{Material, Object};

mod textures;

use super::material::lacks;
use super::*;
use crate::import::tests::{TETRAHEDRON, check_refused, lost, picture};

/// The sample body, with a normal for each face if asked for.
pub(in crate::import) fn sample(has_normals: bool) -> String {
    let mut text = String::new();
    for (i, corners) in TETRAHEDRON.iter().enumerate() {
        text += &corners.map(|[x, y, z]| format!("v {x} {y} {z}\n")).concat();
        if has_normals {
            let n = i + 1;
            let face = [3, 2, 1].map(|k| format!(" -{k}//{n}")).concat();
            text = format!("{text}vn {} -2 0.5\nf{face}\n", i as f64 * 0.125);
        } else {
            text += "f -3 -2 -1\n";
        }
    }
    text
}

/// The sample library.
pub(in crate::import) const LIBRARY: &str = "\
# a comment
newmtl red
Kd 1 0 0.25
newmtl gloss \t
\tKd 0.5
  Ks 0.25 0.5 1
  Ns 20
  illum 2
newmtl lamp
Kd 1 1 0
illum 0
";

fn import_with(text: &str, library: Option<&str>) -> Result<Imported, Vec<Unreadable>> {
    let mut assets = BTreeMap::new();
    if let Some(library) = library {
        assets.insert("lib.mtl".to_owned(), library.as_bytes().to_vec());
    }
    let source = Source { name: "a.obj", bytes: text.as_bytes() };
    crate::import::import(source, &Wishes::default(), &assets)
}

fn import(text: &str) -> Result<Imported, Vec<Unreadable>> {
    import_with(text, Some(LIBRARY))
}

const THREE: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
const SQUARE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

/// The files of meshes by name, as text.
fn meshes(imported: &Imported) -> Vec<(&str, String)> {
    let text = |bytes: &Vec<u8>| String::from_utf8(bytes.clone()).unwrap();
    imported.files.iter().map(|(name, bytes)| (&name[..], text(bytes))).collect()
}

#[test]
fn each_material_has_its_mesh_with_what_it_uses() {
    let text = format!(
        "mtllib lib.mtl\n{SQUARE}vt 0 0\nvt 1 0.5\nvn 0 0 1\nusemtl red\nf 1/1/1 2/2/1 3/1/1\n\
         f 1 2 4\nusemtl gloss\nf 2//1 3//1 4//1\nusemtl red\nf 2 3 4\n"
    );
    let imported = import(&text).unwrap();
    let (v, vn) = ("v 0 0 0\nv 1 0 0\n", "vn 0 0 1\n");
    assert_eq!(
        meshes(&imported),
        [
            ("a-gloss.obj", format!("v 1 0 0\nv 1 1 0\nv 0 1 0\n{vn}f 1//1 2//1 3//1\n")),
            ("a-red-2.obj", format!("{v}v 0 1 0\nv 1 1 0\nf 1 2 3\nf 2 4 3\n")),
            ("a-red.obj", format!("{v}v 1 1 0\nvt 0 0\nvt 1 0.5\n{vn}f 1/1/1 2/2/1 3/1/1\n")),
        ]
    );
    assert_eq!(imported.lost, []);
    let material = |name: &str| imported.scene.materials[name].clone();
    assert_eq!(
        material("red"),
        Material::Lambert { diffuse: Some([1.0, 0.0, 0.25]), texture: None }
    );
    let gloss = Material::BlinnPhong {
        diffuse: Some([0.5; 3]),
        specular: [0.25, 0.5, 1.0],
        exponent: 20.0,
        texture: None,
    };
    assert_eq!(material("gloss"), gloss);
    assert_eq!(imported.scene.materials.len(), 2, "the unused one is not there");
    let of = |object: &Object| object.material().cloned();
    let named = |name: &str| Some(Material::Named(name.to_owned()));
    let all: Vec<_> = imported.scene.objects.iter().map(of).collect();
    assert_eq!(all, [named("red"), named("red"), named("gloss")]);
    picture(&imported);
}

#[test]
fn numbers_keep_every_digit_and_corners_count_from_both_ends() {
    let text = "v 0.1 1e-17 3 1\nv 1 0.30000000000000004 \\\n 0\nv 0 1 0 # x\r\nf -3 -2 3\r\n";
    let imported = import(text).unwrap();
    assert_eq!(
        meshes(&imported)[0].1,
        "v 0.1 1e-17 3\nv 1 0.30000000000000004 0\nv 0 1 0\nf 1 2 3\n"
    );
    let back = import(&meshes(&imported)[0].1).unwrap();
    assert_eq!(back.files["a-mesh.obj"], imported.files["a-mesh.obj"]);
    assert_eq!(
        picture(&import(&sample(false)).unwrap()),
        picture(&import(&sample(false)).unwrap())
    );
}

#[test]
fn polygons_are_cut_and_said_where_not_flat() {
    let arrow = "v 0 0 0\nv 4 4 0\nv 0 1 0\nv -4 4 0\n";
    let imported = import(&format!("{arrow}f 1 2 3 4")).unwrap();
    // The diagonal from the inner corner: the other one is outside.
    let text = &meshes(&imported)[0].1;
    assert!(text.contains("f 1 2 3\n") || text.contains("f 2 3 1\n"), "{text}");
    let bent = SQUARE.replace("1 1 0", "1 1 0.5");
    let imported = import(&format!("{bent}f 1 2 3 4\nf 4 3 2 1")).unwrap();
    assert!(imported.chosen[0].contains("2 polygons are not flat, the first at line 5"));
    let text = format!("{SQUARE}f 1 2 3\nf 1 3 2 4\nf 1 2 1 2\nf 1 2 1 2 1\n");
    let found = lost(&import(&text).unwrap());
    // The first of these is a square with two corners exchanged: its halves cancel.
    let crosses = "6:1: `f`: a polygon that crosses itself is left out";
    let no_area = "7:1: `f`: a polygon that has no area is left out (2 times)";
    assert_eq!(found, format!("{crosses}\n{no_area}\n"));
}

#[track_caller]
fn check_lost(statements: &str, expected: &str) {
    let text = format!("{THREE}{statements}\nf 1 2 3\n");
    assert_eq!(lost(&import(&text).unwrap()), expected, "{statements}");
}

#[test]
fn every_statement_is_looked_at() {
    check_lost("o a\ng b c\ns off\nlod 1", "");
    check_lost(
        "l 1 2\nl 2 3\np 1",
        "4:1: `l`: lines are left out (2 times)\n6:1: `p`: points are left out\n",
    );
    check_lost("v 0 0 0 0.5", "4:1: `v`: weights other than 1 are left out\n");
    check_lost("v 0 0 0 1 1 1", "4:1: `v`: colors of vertices are left out\n");
    check_lost("cstype bezier", "4:1: `cstype`: free-form curves and surfaces are left out\n");
    check_lost("csh rm -rf /", "4:1: `csh`: a command is called, which is not run\n");
    check_lost("call b.obj", "4:1: `call`: another file is called, which is not read\n");
    check_lost("nonsense 1", "4:1: `nonsense`: a statement that OBJ has not is left out\n");
    check_lost("s 1", "5:1: `s`: faces without normals are asked to look smooth, and look flat\n");
    check_lost(
        "usemtl blue",
        "4:1: usemtl blue: no library has it: its faces are of the default material\n",
    );
}

#[track_caller]
fn check_material(statements: &str, expected: &Material, expected_lost: &str) {
    let library = format!("newmtl m\n{statements}\n");
    let text = format!("mtllib lib.mtl\n{THREE}usemtl m\nf 1 2 3\n");
    let imported = import_with(&text, Some(&library)).unwrap();
    assert_eq!(imported.scene.materials["m"], *expected, "{statements}");
    assert_eq!(lost(&imported), expected_lost, "{statements}");
}

#[test]
fn materials_are_what_their_model_says() {
    let white = || Material::Lambert { diffuse: Some([1.0; 3]), texture: None };
    check_material("", &Material::Lambert { diffuse: None, texture: None }, "");
    check_material("Kd 1\nillum 1\nKs 1 1 1", &white(), "");
    check_material("Kd 1\nillum 0", &Material::Constant { color: [1.0; 3], texture: None }, "");
    check_material("Kd 1\nKs 0 0 0\nNs 0\nillum 2\nNi 1.5\nd 1\nTf 1 1 1\nKa 1", &white(), "");
    let everywhere =
        Material::BlinnPhong { diffuse: None, specular: [1.0; 3], exponent: 1e-60, texture: None };
    check_material("Ks 1\nNs 0", &everywhere, "");
    let of = |what: &str| format!("1:8: {what}\n");
    let said = of(
        "Ks of material \"m\" (lib.mtl:3): a highlight without Ns, which says how sharp, is left out",
    );
    check_material("Kd 1\nKs 1", &white(), &said);
    let said = of("Ka of material \"m\" (lib.mtl:3): ambient light is reflected as by Kd");
    check_material("Kd 1\nKa 1 0 1", &white(), &said);
    let said = of("Tr of material \"m\" (lib.mtl:3): it is not transparent");
    check_material("Kd 1\nTr 0.25", &white(), &said);
    let said = of("bump of material \"m\" (lib.mtl:3): a surface's relief is left out");
    check_material("Kd 1\nbump b.png", &white(), &said);
    let said =
        of("Kd of material \"m\" (lib.mtl:2): a color by its spectrum or in CIE XYZ is left out");
    check_material("Kd xyz 1 1 1", &Material::Lambert { diffuse: None, texture: None }, &said);
    let said =
        of("newmtl of material \"m\" (lib.mtl:3): a second material of the same name is left out");
    check_material("Kd 1\nnewmtl m\nKd 0", &white(), &said);
}

#[test]
fn models_that_send_rays_are_whitted() {
    let whitted = |reflect: f64, transmit: [f64; 3], ior: f64, schlick: bool| Material::Whitted {
        texture: None,
        diffuse: Some([0.25; 3]),
        specular: [reflect; 3],
        exponent: if reflect > 0.0 { 9.0 } else { 1.0 },
        reflect: [reflect; 3],
        transmit,
        ior,
        schlick,
    };
    let with = |more: &str| format!("Kd 0.25\nNs 9\nNi 1.5\nTf 1 0.5 0\n{more}");
    let lambert = Material::Lambert { diffuse: Some([0.25; 3]), texture: None };
    check_material(&with("Ks 0.5\nillum 3"), &whitted(0.5, [0.0; 3], 1.0, false), "");
    check_material(&with("illum 3"), &lambert, "");
    let through = [0.5, 0.25, 0.0];
    check_material(&with("Ks 0.5\nillum 6"), &whitted(0.5, through, 1.5, false), "");
    check_material(&with("illum 6"), &whitted(0.0, [1.0, 0.5, 0.0], 1.5, false), "");
    let said = |illum: u32, line: u32, what: &str| {
        format!("1:8: illum {illum} of material \"m\" (lib.mtl:{line}): {what}\n")
    };
    let lack = said(5, 7, lacks(5));
    check_material(&with("Ks 0.5\nillum 5"), &whitted(0.5, [0.0; 3], 1.0, true), &lack);
    let lack = said(7, 7, lacks(7));
    check_material(&with("Ks 0.5\nillum 7"), &whitted(0.5, through, 1.5, true), &lack);
    check_material(&with("illum 8"), &lambert, &said(8, 6, lacks(8)));
    let much = Material::BlinnPhong {
        diffuse: Some([0.25; 3]),
        specular: [2.0; 3],
        exponent: 9.0,
        texture: None,
    };
    let what = "it reflects and refracts nothing: its shares are more than 1";
    check_material(&with("Ks 2\nillum 3"), &much, &said(3, 7, what));
}

#[test]
fn libraries_are_found_by_names_with_spaces_or_dots() {
    let mut assets = BTreeMap::new();
    assets.insert("my lib.mtl".to_owned(), LIBRARY.as_bytes().to_vec());
    assets.insert("b.mtl".to_owned(), b"newmtl my red\nKd 0.5".to_vec());
    let text =
        format!("mtllib ./my lib.mtl\nmtllib b.mtl b.mtl\n{THREE}usemtl  my red \nf 1 2 3\n");
    let source = Source { name: "a.obj", bytes: text.as_bytes() };
    let imported = crate::import::import(source, &Wishes::default(), &assets).unwrap();
    assert_eq!(lost(&imported), "");
    assert!(imported.scene.materials.contains_key("my red"));
}

#[test]
fn broken_files() {
    let check = |text: &str, expected| check_refused(&import(text), expected);
    check("", "expected triangles or polygons, found none");
    check("v 0 0 0\nl 1 1", "expected triangles or polygons, found none");
    check(&format!("{THREE}f 1 2 1 2"), "expected triangles or polygons, found none");
    check("v 0 0\nv 0 0 zero\nf 1", "1:1: expected three numbers after `v`, found 2");
    check("v 0 0\nv 0 0 zero\nf 1", "2:7: expected a number, found \"zero\"");
    check("v 0 0\nv 0 0 zero\nf 1", "3:3: expected a number from 1 to 0");
    check("v nan 0 0", "1:3: expected a number, found \"nan\"");
    check("v 1e61 0 0", "1:1: expected numbers of at most 1e60");
    check("v 0 0 0 1 1", "expected 3, 4, 6 or 7 numbers after `v`, found 5");
    check("vt 1 2 3 4", "expected one to three numbers after `vt`, found 4");
    check("vn 1 2", "expected three numbers after `vn`, found 2");
    check(&format!("{THREE}f 1 2"), "4:1: expected three corners or more after `f`, found 2");
    check(&format!("{THREE}f 1 2 4"), "4:7: expected a number from 1 to 3");
    check(&format!("{THREE}vn 0 0 1\nf 1//1 2//1 3"), "found them at 2 of 3");
    check(&format!("{THREE}usemtl\nf 1 2 3"), "4:1: expected the name of a material");
    check("mtllib", "1:1: expected the name of a file");
    check("\n  mtllib gone.mtl", "2:10: the material library \"gone.mtl\" does not exist");
    for outside in ["../lib.mtl", "/lib.mtl", "C:\\lib.mtl", "a/../lib.mtl", "a\\lib.mtl"] {
        check(&format!("mtllib {outside}"), "in the file's own folder");
    }
    let long = format!("{THREE}f {}", "1 ".repeat(30_000));
    check(&long, "4:1: expected at most 20000 words");
    let many = import(&"v\n".repeat(1_000)).unwrap_err();
    assert_eq!(many.len(), MOST_PROBLEMS);
}

#[test]
fn broken_libraries() {
    let check = |library: &str, expected: &str| {
        let text = format!("mtllib lib.mtl\n{THREE}f 1 2 3");
        check_refused(&import_with(&text, Some(library)), expected);
    };
    check("Kd 1 1 1", "1:8: lib.mtl:1:1: expected `newmtl` before `Kd`");
    check("newmtl a\nKd 1 1", "lib.mtl:2:1: expected one or three numbers, found 2 words");
    check("newmtl a\nKd", "expected one or three numbers, found 0 words");
    check("newmtl a\nKd -1", "lib.mtl:2:1: expected a number from 0, found -1");
    check("newmtl a\nKd red", "expected a number, found \"red\"");
    check("newmtl a\nNs inf", "expected a number, found \"inf\"");
    check("newmtl a\nd 2", "expected a number from 0 to 1, found 2");
    check("newmtl a\nillum -1", "expected a whole number, found \"-1\"");
    check("newmtl a\nmap_Kd", "expected the name of a file");
    check("newmtl a\nmap_Kd -clamp on", "expected the name of a file, found none");
    check("newmtl a\nmap_Kd -s a.png", "-s: expected one to three numbers, found none");
    check("newmtl a\nmap_Kd -clamp maybe a.png", "-clamp: expected on or off, found \"maybe\"");
    check("newmtl a\nmap_Kd -mm 0", "-mm: expected two numbers");
    check("newmtl a\nmap_Kd -mm 0 x a.png", "-mm: expected a number, found \"x\"");
    check("newmtl a\nmap_Kd -boost", "-boost: expected a word after it, found none");
    check("newmtl a\nmap_Kd -x 1 a.png", "expected an option such as -s, -o or -clamp");
}
