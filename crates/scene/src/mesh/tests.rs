//! Mesh files, good ones and broken ones.

use tracer::glam::dvec3;

use super::*;

const SQUARE_OBJ: &str = "\
mtllib nowhere.mtl
o square
v 0 0 0
v 1 0 0
v 1 1 0
v 0 1 0
vn 0 0 1
f 1//1 2//1 3//1 4//1
";

const SQUARE_PLY: &str = "\
ply
format ascii 1.0
element vertex 4
property float x
property float y
property float z
element face 1
property list uchar int vertex_indices
end_header
0 0 0
1 0 0
1 1 0
0 1 0
4 0 1 2 3
";

#[test]
fn a_square_is_two_triangles_in_both_formats() {
    for (name, text) in [("a.obj", SQUARE_OBJ), ("A.PLY", SQUARE_PLY)] {
        let mesh = read(name, text.as_bytes()).unwrap();
        assert_eq!(mesh.vertices[2], dvec3(1.0, 1.0, 0.0), "{name}");
        assert_eq!(mesh.faces, [[0, 1, 2], [0, 2, 3]], "{name}");
        assert_eq!(mesh.normals.is_some(), name == "a.obj");
    }
}

#[test]
fn positions_keep_all_their_digits() {
    let mesh = read("a.obj", b"v 0.1 1e-17 3\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").unwrap();
    assert_eq!(mesh.vertices[0], dvec3(0.1, 1e-17, 3.0));
}

#[test]
fn objects_of_a_file_are_put_together() {
    let text = "o a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\no b\nv 0 0 1\nf 4 2 3\nf -1 -2 -3\n";
    let mesh = read("a.obj", text.as_bytes()).unwrap();
    let corner = |face: usize, k: usize| mesh.vertices[mesh.faces[face][k] as usize];
    assert_eq!(mesh.faces.len(), 3);
    assert_eq!(corner(1, 0), dvec3(0.0, 0.0, 1.0));
    assert_eq!(corner(1, 1), dvec3(1.0, 0.0, 0.0));
    assert_eq!(corner(2, 1), dvec3(0.0, 1.0, 0.0), "counted from the end");
}

#[test]
fn normals_follow_their_objects_and_count_only_where_all_faces_have_them() {
    let corner = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    let two = format!(
        "o a\n{corner}vn 0 0 1\nf 1//1 2//1 3//1\no b\n{corner}vn 1 0 0\nf 4//2 5//2 6//2\n"
    );
    let normals = read("a.obj", two.as_bytes()).unwrap().normals.unwrap();
    let first_of = |face: usize| normals.normals[normals.faces[face][0] as usize];
    assert_eq!((first_of(0), first_of(1)), (dvec3(0.0, 0.0, 1.0), dvec3(1.0, 0.0, 0.0)));
    let partial = two.replace("f 4//2 5//2 6//2", "f 4 5 6");
    assert!(read("a.obj", partial.as_bytes()).unwrap().normals.is_none());
    let other_name = SQUARE_PLY.replace("vertex_indices", "vertex_index");
    assert_eq!(read("a.ply", other_name.as_bytes()).unwrap().faces.len(), 2);
}

#[test]
fn texture_coordinates_count_only_where_all_corners_have_them() {
    let corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0.5\nvt -2 3 0\n";
    let one = format!("{corners}f 1/3 2/1 3/2\n");
    let uvs = read("a.obj", one.as_bytes()).unwrap().uvs.unwrap();
    assert_eq!(uvs.faces[0].map(|i| uvs.uvs[i as usize]), [[-2.0, 3.0], [0.0, 0.0], [1.0, 0.5]]);
    // The second object's own indices, with normals beside them.
    let two = format!("o a\n{one}o b\n{corners}vn 0 0 1\nf 4/4/1 5/5/1 6/6/1\n");
    let uvs = read("a.obj", two.as_bytes()).unwrap().uvs.unwrap();
    assert_eq!(uvs.faces[1].map(|i| uvs.uvs[i as usize]), [[0.0, 0.0], [1.0, 0.5], [-2.0, 3.0]]);
    for partial in ["f 1/1 2/2 3\n", "f 1//1 2//1 3//1\n", "f 1 2 3\nf 1/1 2/2 3/3\n"] {
        let why = read("a.obj", format!("{corners}vn 0 0 1\n{partial}").as_bytes()).unwrap().uvs;
        assert!(why.unwrap_err().contains("but not at every corner"), "{partial}");
    }
    assert!(read("a.obj", SQUARE_OBJ.as_bytes()).unwrap().uvs.unwrap_err().contains("no texture"));
}

#[test]
fn texture_coordinates_of_vertices_by_every_name() {
    let with = |names: [&str; 2]| {
        let [u, v] = names.map(|name| format!("property float {name}\n"));
        let text = SQUARE_PLY.replace("property float z\n", &format!("property float z\n{u}{v}"));
        text.replace("0 0 0\n1 0 0\n1 1 0\n0 1 0\n", "0 0 0 0 0\n1 0 0 2 0\n1 1 0 2 1\n0 1 0 0 1\n")
    };
    for names in [["s", "t"], ["u", "v"], ["texture_u", "texture_v"], ["texture_s", "texture_t"]] {
        let mesh = read("a.ply", with(names).as_bytes()).unwrap();
        let uvs = mesh.uvs.unwrap();
        assert_eq!((uvs.uvs[2], uvs.faces), ([2.0, 1.0], mesh.faces), "{names:?}");
    }
    for text in [with(["s", "v"]), SQUARE_PLY.to_owned()] {
        let why = read("a.ply", text.as_bytes()).unwrap().uvs.unwrap_err();
        assert!(why.contains("without texture coordinates (`s` and `t`"), "{why}");
    }
}

#[track_caller]
fn check_error(name: &str, text: &str, expected: &str) {
    let error = read(name, text.as_bytes()).unwrap_err();
    assert!(error.contains(expected), "{error:?} does not contain {expected:?}");
}

#[test]
fn broken_files() {
    check_error("a.stl", "", "neither an OBJ nor a PLY");
    check_error("a", "", "neither an OBJ nor a PLY");
    check_error("a.obj", "v 0 0 0\nv 1 0 zero\nv 0 1 0\nf 1 2 3\n", "line 2: position");
    check_error("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n", "line 4: face");
    check_error("a.ply", "", "not a readable PLY");
    check_error("a.ply", "ply\nformat ascii 1.0\nend_header\n", "no element `vertex`");
    let absurd = SQUARE_PLY.replace("element vertex 4", "element vertex 4000000000");
    check_error("a.ply", &absurd, "not a readable PLY");
    let nothing = "ply\nformat binary_little_endian 1.0\nelement foo 300000000\nend_header\n";
    check_error("a.ply", nothing, "300000000 elements `foo` of 0 properties");
    let no_z = SQUARE_PLY.replace("property float z", "property float q");
    check_error("a.ply", &no_z, "without the numbers");
    let negative = SQUARE_PLY.replace("4 0 1 2 3", "4 0 1 2 -3");
    check_error("a.ply", &negative, "face without a list");
}

#[test]
fn mutated_files_never_panic() {
    let mut rng = fastrand::Rng::with_seed(5);
    for (name, text) in [("a.obj", SQUARE_OBJ), ("a.ply", SQUARE_PLY)] {
        for _ in 0..5_000 {
            let mut bytes = text.as_bytes().to_vec();
            for _ in 0..rng.usize(1..4) {
                let at = rng.usize(0..bytes.len());
                match rng.u8(0..3) {
                    0 => bytes[at] = rng.u8(..),
                    1 => bytes.insert(at, b"0123456789-./ \n"[rng.usize(0..15)]),
                    _ => drop(bytes.drain(at..(at + rng.usize(0..9)).min(bytes.len()))),
                }
            }
            // Either way is fine; coming back at all is what counts.
            let _ = read(name, &bytes);
        }
    }
}
