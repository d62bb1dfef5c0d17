//! `minimize` with the real binary, held against itself and against another
//! renderer.
#![cfg(unix)]
#![allow(clippy::unwrap_used, clippy::disallowed_methods)]

mod tree;

use std::os::unix::fs::PermissionsExt;

use tree::{SQUARE, Tree};

/// Two boxes, a mesh and two lights.
const MANY: &str = "// Many.
(
    version: 1,
    image: (32, 24),
    camera: Parallel(view_point: (0, 0, 5), view_width: 8, view_height: 6),
    objects: [
        Box(min: (-3, -1, -1), max: (-1, 1, 1)),
        Box(min: (1, -1, -1), max: (3, 1, 1), material: Named(\"paint\")),
        Mesh(file: \"quad.obj\"),
    ],
    materials: {\"paint\": Lambert(diffuse: (1, 0.5, 0.2))},
    lights: [Directional(direction: (0, 0, -1)), Ambient(intensity: (0.1, 0.1, 0.1))],
)";

fn many() -> Tree {
    let tree = Tree::new(&[("area/many", MANY)]);
    let quad = "v -1 2 0\nv 1 2 0\nv 1 3 0\nv -1 3 0\nf 1 2 3 4\n";
    tree.write("fixtures/area/quad.obj", quad.as_bytes());
    tree.run(&["bless", "--all"]).expect_code(0);
    tree
}

/// A program that renders what `edit` of sed makes of a scene.
fn renderer(tree: &Tree, edit: &str) -> String {
    let (path, real) = (tree.path("other"), env!("CARGO_BIN_EXE_xtask"));
    let script = format!("#!/bin/sh\nsed -i '{edit}' \"$2\" && exec {real} \"$@\"\n");
    tree.write("other", script.as_bytes());
    std::fs::set_permissions(&path, std::fs::Permissions::from_mode(0o755)).unwrap();
    path.to_str().unwrap().to_owned()
}

#[test]
fn a_large_fixture_becomes_a_small_one_that_fails_alike() {
    let tree = many();
    // The other renderer has another red; so only what has the paint is left.
    let other = renderer(&tree, "s/(1.0, 0.5, 0.2)/(0.9, 0.5, 0.2)/");
    tree.run(&["minimize", "area/many", "--reference", &other]).expect_code(0).expect(
        "wrote fixtures/area/many-minimized.ron, and golden/area/many-minimized.png as the",
    );
    let small = std::fs::read_to_string(tree.path("fixtures/area/many-minimized.ron")).unwrap();
    assert_eq!(small.matches("Box(").count(), 1, "{small}");
    assert!(!small.contains("Mesh("), "{small}");
    assert!(small.starts_with("// What is left of fixtures/area/many.ron by"), "{small}");
    tree.run(&["check", "many-minimized"]).expect_code(1).expect("differs");
    // What is there already is kept.
    tree.run(&["minimize", "area/many", "--reference", &other])
        .expect_code(2)
        .expect("is there already: name another with --out");
    let out = ["minimize", "area/many", "--reference", &other, "--out", "area/small"];
    tree.run(&out).expect_code(0).expect("wrote fixtures/area/small.ron, and");
}

#[test]
fn what_does_not_fail_or_cannot_be_asked_says_so() {
    let tree = many();
    let right = renderer(&tree, "s/x/x/");
    tree.run(&["minimize", "area/many", "--reference", &right])
        .expect_code(1)
        .expect("area/many does not fail");
    tree.run(&["minimize", "area/many"]).expect_code(1).expect("name a build that is right");
    tree.run(&["minimize", "area/few"]).expect_code(2).expect("area/few");
    tree.run(&["minimize", "area/many", "--reference", "nowhere"])
        .expect_code(2)
        .expect("expected a program, found no such file");
    let broken = renderer(&tree, "s/version/vision/");
    tree.run(&["minimize", "area/many", "--reference", &broken]).expect_code(2).expect("other");
    tree.run(&["minimize", "area/many", "--out", "../x"]).expect_code(2).expect("expected a name");
    tree.run_with(&["minimize", "area/many", "--reference", &right], &[("CI", "true")])
        .expect_code(2)
        .expect("by hand");
    let golden = std::fs::read_dir(tree.path("golden/area")).unwrap().count();
    assert_eq!(golden, 1, "nothing was written");
}

#[test]
fn another_renderer_is_believed_only_what_it_makes_now() {
    let tree = many();
    // Makes one picture, and then none without saying so.
    let real = env!("CARGO_BIN_EXE_xtask");
    let once = format!(
        "#!/bin/sh\n[ -e \"$0.done\" ] && exit 0\ntouch \"$0.done\"\nsed -i s/0.5/0.9/ \"$2\"\n\
         exec {real} \"$@\"\n"
    );
    let other = renderer(&tree, "s/x/x/");
    tree.write("other", once.as_bytes());
    std::fs::set_permissions(&other, std::fs::Permissions::from_mode(0o755)).unwrap();
    tree.run(&["minimize", "area/many", "--reference", &other])
        .expect_code(1)
        .expect("area/many does not fail");
    // A golden that is there is kept, and files are found where they are.
    let other = renderer(&tree, "s/(1.0, 0.5, 0.2)/(0.9, 0.5, 0.2)/");
    tree.write("golden/area/many-minimized.png", b"mine");
    tree.run(&["minimize", "area/many", "--reference", &other])
        .expect_code(2)
        .expect("is there already");
    let elsewhere = ["minimize", "area/many", "--reference", &other, "--out", "elsewhere"];
    tree.run(&elsewhere).expect_code(2).expect("expected a name beside area/many");
    assert!(!tree.path("fixtures/elsewhere.ron").exists());
}

#[test]
fn a_small_suite_has_nothing_to_minimize() {
    let tree = Tree::blessed(&[("a", SQUARE)]);
    tree.run(&["minimize", "a"]).expect_code(1).expect("breaks no relation");
}
