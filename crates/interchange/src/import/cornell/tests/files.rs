//! Files that a scene names.

use std::collections::BTreeMap;

use super::BALL;
use crate::import::{Imported, Source, Unreadable, Wishes, import};

#[test]
fn meshes_come_through_assets() {
    const OBJ: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    const MSH: &str = "3\n1\nvertices\n0\n0\n0\n1\n0\n0\n0\n1\n0\ntriangles\n0\n1\n2\n";
    #[track_caller]
    fn check(found: Result<Imported, Vec<Unreadable>>, name: &str) {
        let imported = found.unwrap();
        assert_eq!(imported.files.keys().collect::<Vec<_>>(), [name]);
        assert_eq!(imported.files[name], OBJ.as_bytes());
        imported.text("a.xml").unwrap();
    }
    #[track_caller]
    fn refused(found: Result<Imported, Vec<Unreadable>>, message: &str) {
        let problem = &found.unwrap_err()[0];
        assert_eq!(problem.place, Some((6, 22)));
        assert!(problem.message.contains(message), "{problem:?}");
    }
    let file = |name: &str, text: &str| (name.to_owned(), text.as_bytes().to_vec());
    let assets = BTreeMap::from([
        file("a.obj", OBJ),
        file("../m/a.obj", OBJ),
        file("a.msh", MSH),
        file("bad.msh", "3 1 vertices"),
        file("bad.obj", "v 0 0\nf 1 2 3\n"),
        file("a.stl", "solid"),
    ]);
    let mesh = |data: &str| {
        let text = BALL.replace(
            "</scene>",
            &format!("<surface type=\"Mesh\"><data>{data}</data></surface></scene>"),
        );
        import(Source { name: "a.xml", bytes: text.as_bytes() }, &Wishes::default(), &assets)
    };
    check(mesh("a.obj"), "a.obj");
    check(mesh(" ./a.obj "), "a.obj");
    check(mesh("../m/a.obj"), "m/a.obj");
    check(mesh("a.msh"), "a.obj");
    refused(mesh("none.obj"), "data: the mesh \"none.obj\" does not exist");
    refused(mesh("../../etc/a.obj"), "data: the mesh \"../../etc/a.obj\" does not exist");
    refused(mesh("/etc/passwd"), "the mesh \"/etc/passwd\" is not a path inside");
    refused(mesh("m\\a.obj"), "is not a path inside");
    refused(mesh(""), "is not a path inside");
    refused(mesh("bad.msh"), "has a mistake at 1:13");
    refused(mesh("bad.obj"), "is not a readable OBJ file: line 1");
    refused(mesh("a.stl"), "is neither an OBJ nor a PLY");
}

#[test]
fn files_can_be_moved_into_a_folder() {
    let obj = b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n".to_vec();
    let assets = BTreeMap::from([("a.obj".to_owned(), obj)]);
    let mesh = "<surface type=\"Mesh\"><data>a.obj</data></surface>";
    let more = format!("{mesh}<surface type=\"Group\">{mesh}</surface></scene>");
    let text = BALL.replace("</scene>", &more);
    let source = Source { name: "a.xml", bytes: text.as_bytes() };
    let mut imported = import(source, &Wishes::default(), &assets).unwrap();
    imported.move_files("meshes/old");
    assert_eq!(imported.files.keys().collect::<Vec<_>>(), ["meshes/old/a.obj"]);
    let text = imported.text("dir/a\u{202e}.xml").unwrap();
    assert_eq!(text.matches("meshes/old/a.obj").count(), 2);
    assert!(text.starts_with("// Imported from dir/a\\u{202e}.xml.\n// Chosen: "), "{text}");
    imported.files.clear();
    assert!(imported.text("a.xml").unwrap_err()[0].message.contains("does not exist"));
}
