//! STL files, good ones and broken ones.

use super::*;
use crate::import::tests::{TETRAHEDRON, check_refused, lost, picture};

/// The sample body as binary STL with this header.
pub(in crate::import) fn binary(header: &str) -> Vec<u8> {
    let mut bytes = header.as_bytes().to_vec();
    bytes.resize(80, b' ');
    bytes.extend(4_u32.to_le_bytes());
    for corners in TETRAHEDRON {
        for x in [[0.0; 3]].iter().chain(&corners).flatten() {
            bytes.extend((*x as f32).to_le_bytes());
        }
        bytes.extend([0, 0]);
    }
    bytes
}

/// The same as text.
pub(in crate::import) fn text() -> String {
    let mut text = "solid facet normal\n".to_owned();
    for corners in TETRAHEDRON {
        text += "facet normal 0 0 0\n outer loop\n";
        text += &corners.map(|[x, y, z]| format!("  vertex {x:e} {y:e} {z:e}\n")).concat();
        text += " endloop\nendfacet\n";
    }
    text + "endsolid facet normal\n"
}

fn import(bytes: &[u8]) -> Result<Imported, Vec<Unreadable>> {
    let source = Source { name: "a.STL", bytes };
    crate::import::import(source, &Wishes::default(), &scene::NoAssets)
}

#[test]
fn text_and_bytes_give_the_same_picture_whatever_they_start_with() {
    let one = import(&binary("a box")).unwrap();
    let text_one = import(text().as_bytes()).unwrap();
    let obj = String::from_utf8(one.files["a-mesh.obj"].clone()).unwrap();
    assert_eq!(obj.matches("v ").count(), 4, "welded: {obj}");
    assert_eq!(obj.matches("f ").count(), 4, "{obj}");
    assert_eq!(one, text_one);
    assert_eq!(one, import(&binary("solid that is no text")).unwrap());
    assert!(one.lost.is_empty());
    assert_eq!(picture(&one), picture(&text_one));
}

#[test]
fn what_is_lost_is_said() {
    let mut bytes = binary("COLOR=....");
    let last = bytes.len() - 1;
    bytes[last] = 0x80;
    bytes.extend(b"more");
    let found = lost(&import(&bytes).unwrap());
    for part in ["4 bytes after", "1 of them, which are colors", "COLOR in the header"] {
        assert!(found.contains(part), "{part}: {found}");
    }
    // The first facet's normal points along -x; this one says +x.
    let text = text().replacen("normal 0 0 0", "normal 1 1 1", 1);
    let found = lost(&import(text.as_bytes()).unwrap());
    assert!(found.contains("1 of them point to the other side"), "{found}");
    let two = self::text() + &self::text();
    assert!(import(two.as_bytes()).unwrap().chosen[0].contains("2 solids are one mesh"));
}

#[test]
fn broken_files() {
    let check = |bytes: &[u8], expected| check_refused(&import(bytes), expected);
    check(b"", "or 84 bytes or more, found 0 bytes");
    check(b"hello", "found 5 bytes");
    check(b"solid", "1:6: expected `facet` or `endsolid`, found the file's end");
    check(b"solid a\nendsolid", "expected triangles or polygons, found none");
    let text = text();
    check(text.replacen("vertex", "edge", 1).as_bytes(), "4:3: expected `vertex`, found \"edge\"");
    check(text.replacen("loop", "loops", 1).as_bytes(), "3:8: expected `loop`, found \"loops\"");
    check(text.replacen("0e0", "zero", 1).as_bytes(), "expected a number, found \"zero\"");
    check(text.replacen("0e0", "nan", 1).as_bytes(), "expected a number, found \"nan\"");
    check(text.replacen("0e0", "1e61", 1).as_bytes(), "2:1: expected a corner");
    let four = text.replacen(" endloop", "vertex 0 0 0\n endloop", 1);
    check(four.as_bytes(), "expected `endloop`, found \"vertex\"");
    let bytes = binary("x");
    check(&bytes[..bytes.len() - 1], "expected 284 bytes for 4 facets, found 283");
    let mut lying = bytes.clone();
    lying[80..84].copy_from_slice(&u32::MAX.to_le_bytes());
    check(&lying, "expected 214748364834 bytes for 4294967295 facets, found 284");
    let mut lying = binary("solid");
    lying[80] = 5;
    let error = import(&lying).unwrap_err();
    assert!(error[0].help.as_ref().unwrap().contains("5 facets would take 334 bytes"), "{error:?}");
    let mut nan = bytes;
    nan[84 + 12..84 + 16].copy_from_slice(&f32::NAN.to_le_bytes());
    check(&nan, "facet 0: expected a corner of three finite numbers");
}
