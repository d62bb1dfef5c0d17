//! PLY files, good ones and broken ones.

use super::*;
use crate::import::tests::{TETRAHEDRON, check_refused, lost, picture};

/// How a sample is stored.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::import) enum Stored {
    Text,
    Little,
    Big,
}

/// The sample body, three vertices to a face, with normals if asked for.
pub(in crate::import) fn sample(stored: Stored, has_normals: bool) -> Vec<u8> {
    let name = match stored {
        Stored::Text => "ascii",
        Stored::Little => "binary_little_endian",
        Stored::Big => "binary_big_endian",
    };
    let normals = if has_normals {
        "property double nx\nproperty double ny\nproperty double nz\n"
    } else {
        ""
    };
    let mut bytes = format!(
        "ply\nformat {name} 1.0\ncomment of a test\nelement vertex 12\nproperty float x\n\
         property float32 y\nproperty float z\n{normals}element face 4\n\
         property list uchar int vertex_indices\nend_header\n"
    )
    .into_bytes();
    let mut put = |x: f64, size: usize| match (stored, size) {
        (Stored::Text, _) => bytes.extend(format!("{x} ").as_bytes()),
        (Stored::Little | Stored::Big, 1) => bytes.push(x as u8),
        (Stored::Little, 4) => bytes.extend((x as f32).to_le_bytes()),
        (Stored::Big, 4) => bytes.extend((x as f32).to_be_bytes()),
        (Stored::Little, 8) => bytes.extend(x.to_le_bytes()),
        (Stored::Big, 8) => bytes.extend(x.to_be_bytes()),
        (Stored::Little, _) => bytes.extend((x as i32).to_le_bytes()),
        (Stored::Big, _) => bytes.extend((x as i32).to_be_bytes()),
    };
    for (i, corners) in TETRAHEDRON.iter().enumerate() {
        for corner in corners {
            for &x in corner {
                put(x, 4);
            }
            if has_normals {
                for x in [i as f64 * 0.125, -2.0, 0.5] {
                    put(x, 8);
                }
            }
        }
    }
    for i in 0..4 {
        put(3.0, 1);
        (0..3).for_each(|k| put(f64::from(3 * i + k), 0));
    }
    bytes
}

fn import(bytes: &[u8]) -> Result<Imported, Vec<Unreadable>> {
    let source = Source { name: "a.ply", bytes };
    crate::import::import(source, &Wishes::default(), &scene::NoAssets)
}

#[test]
fn all_ways_of_storing_give_the_same() {
    for has_normals in [false, true] {
        let text = import(&sample(Stored::Text, has_normals)).unwrap();
        assert_eq!(text, import(&sample(Stored::Little, has_normals)).unwrap());
        assert_eq!(text, import(&sample(Stored::Big, has_normals)).unwrap());
        assert_eq!(lost(&text), "");
        let obj = String::from_utf8(text.files["a-mesh.obj"].clone()).unwrap();
        assert_eq!(obj.contains("vn 0.375 -2 0.5\n"), has_normals, "{obj}");
        picture(&text);
    }
    let crlf = String::from_utf8(sample(Stored::Text, true)).unwrap().replace('\n', "\r\n");
    assert_eq!(import(crlf.as_bytes()).unwrap(), import(&sample(Stored::Text, true)).unwrap());
}

const SQUARE: &str = "\
ply
format ascii 1.0
element vertex 4
property double x
property double y
property double z
element face 1
property list uchar uint vertex_index
end_header
0 0 0
1 0 0
1 1 0
0 1 0
4 0 1 2 3
";

/// The mesh of a file, as text.
fn mesh(text: &str) -> String {
    let imported = import(text.as_bytes()).unwrap();
    String::from_utf8(imported.files["a-mesh.obj"].clone()).unwrap()
}

#[test]
fn polygons_strips_and_coordinates_are_read() {
    assert!(mesh(SQUARE).ends_with("f 1 2 3\nf 1 3 4\n"), "{}", mesh(SQUARE));
    let strip = SQUARE
        .replace("element face", "element tristrips")
        .replace("uchar uint", "int int")
        .replace("4 0 1 2 3", "8 0 1 2 3 -1 0 1 3");
    assert!(mesh(&strip).ends_with("f 1 2 3\nf 3 2 4\nf 1 2 4\n"), "{}", mesh(&strip));
    let uv = SQUARE
        .replace("double z\n", "double z\nproperty float s\nproperty float t\n")
        .replace("0\n1 1 0", "0 0.5 0.25\n1 1 0 0 0")
        .replace("0 0 0\n1 0 0", "0 0 0 1 1\n1 0 0")
        .replace("0 1 0\n4", "0 1 0 1 0\n4");
    assert!(mesh(&uv).contains("vt 0.5 0.25\n") && mesh(&uv).contains("f 1/1 2/2 3/3\n"));
    let before = "\
ply\nformat ascii 1.0\nelement face 1\nproperty list uchar int vertex_indices\nelement vertex 3
property float x\nproperty float y\nproperty float z\nend_header\n3 0 1 2\n0 0 0 1 0 0 0 1 0";
    assert!(mesh(before).ends_with("f 1 2 3\n"), "faces may come first");
}

#[test]
fn what_is_lost_is_said() {
    let colors = SQUARE
        .replace(
            "list uchar uint vertex_index\n",
            "list uchar uint vertex_index\nproperty uchar red\nproperty float quality\n",
        )
        .replace("4 0 1 2 3", "4 0 1 2 3 255 0.5 and more");
    let colors = colors
        .replace(
            "ascii 1.0\n",
            "ascii 1.0\ncomment TextureFile a.png\nelement edge 1\nproperty int vertex1\n",
        )
        .replace("end_header\n", "end_header\n7 ");
    let imported = import(colors.as_bytes()).unwrap();
    let found = lost(&imported);
    for part in [
        "comment TextureFile: the texture",
        "element edge: 1 of them are left out",
        "property red of `face`: colors are left out",
        "19:19: end of the file: words after all that the header declares",
    ] {
        assert!(found.contains(part), "{part}: {found}");
    }
    assert!(imported.chosen[0].contains("nothing of quality"), "{:?}", imported.chosen);
    let two = SQUARE.replace("element face 1", "element face 2") + "2 0 1\n";
    assert!(lost(&import(two.as_bytes()).unwrap()).contains("`face`: a polygon that has no area"));
    let bow = SQUARE.replace("element face 1", "element face 2") + "4 0 2 1 3\n";
    assert!(
        lost(&import(bow.as_bytes()).unwrap()).contains("`face`: a polygon that crosses itself")
    );
}

#[test]
fn broken_files() {
    let check = |text: &str, expected| check_refused(&import(text.as_bytes()), expected);
    check("", "1:1: expected `ply` as the first word");
    check("plyx", "expected `ply`");
    check("ply\n", "expected a line `end_header`");
    check("ply\nend_header\n", "2:1: expected a line `format` before");
    check("ply\nformat ascii 2.0\n", "2:1: expected `ascii 1.0`");
    check("ply\nformat ascii 1.0\nend_header\n", "expected elements `vertex` and `face`");
    check("ply\nproperty int x\n", "expected `element` before `property`");
    check("ply\nnonsense\n", "2:1: expected `comment`");
    let change = |from: &str, to: &str| SQUARE.replacen(from, to, 1);
    check(&change("double x", "quad x"), "4:1: expected a type and a name");
    check(&change("uchar uint", "float uint"), "expected a type and a name, or `list`");
    check(&change("vertex 4", "vertex -4"), "3:16: expected a whole number, found \"-4\"");
    check(&change("vertex 4", "vertex 4000000000"), "24000000000 bytes or more for 4000000000");
    check(&change("vertex 4", "vertex 18446744073709551615"), "bytes or more");
    check(&change("element face", "element vertex"), "`vertex` is there already");
    check(&change("double z", "double q"), "element `vertex` with properties x, y and z");
    check(&change("vertex_index", "corners"), "element `face` with a list `vertex_indices`");
    check(&change("uint vertex", "float vertex"), "element `face` with a list `vertex_indices`");
    check(&change("1 0 0", "1 zero 0"), "11:3: `vertex` number 1: property `y`: expected a number");
    check(&change("1 0 0", "1 1e61 0"), "`vertex` number 1: expected numbers of at most 1e60");
    check(&change("4 0 1 2 3", "4 0 1 2 4"), "`face` number 0: expected numbers below 4");
    check(&change("4 0 1 2 3", "4 0 1 2"), "found the file's end");
    check(&change("4 0 1 2 3", "4 0 1 2 -3"), "expected a whole number from 0 to 4294967295");
    check(&change("4 0 1 2 3", "4 0 1 2 0.5"), "expected a whole number from 0 to 4294967295");
    check(&change("4 0 1 2 3", "256 0 1 2"), "expected a whole number from 0 to 255");
    let nothing = change("element vertex", "element nothing 300000000000\nelement vertex");
    check(&nothing, "expected 300000000000 bytes or more for 300000000000 of element `nothing`");
    let binary = sample(Stored::Little, true);
    check_refused(&import(&binary[..binary.len() - 1]), "`face` number 3: property");
    let mut long = binary.clone();
    // The length of the last list.
    let list = binary.len() - 13;
    long[list] = 200;
    check_refused(&import(&long), "property `vertex_indices`: expected more bytes");
}
