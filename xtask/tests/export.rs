//! `export`, and scenes as JSON, by the real binary.
#![allow(clippy::unwrap_used, clippy::disallowed_methods)]

mod tree;

use std::fs;

use tree::{SQUARE, Tree};

#[test]
fn a_scene_is_written_and_never_over_another_file() {
    let tree = Tree::blessed(&[("a", SQUARE)]);
    let export = ["export", "a", "--to", "povray", "--out", "pov"];
    tree.run(&export).expect_code(0).expect("wrote pov/scene.pov");
    let first = fs::read(tree.path("pov/scene.pov")).unwrap();
    tree.run(&export).expect_code(0);
    tree.write("pov/scene.pov", b"mine");
    tree.run(&export).expect_code(2).expect("pov/scene.pov: expected no such file");
    assert_eq!(fs::read(tree.path("pov/scene.pov")).unwrap(), b"mine");
    assert!(first.starts_with(b"#version 3.7;"));
    tree.run(&["export", "a", "--to", "PovRay", "--out", "fixtures"])
        .expect_code(2)
        .expect("outside of the suite's fixtures/");
    tree.run(&["export", "a", "--to", "Blender", "--out", "pov"]).expect_code(2).expect("Mitsuba");
}

#[test]
fn what_a_language_cannot_say_is_said_and_nothing_written() {
    let filtered = SQUARE.replacen("version: 1,", "version: 1, filter: Tent(),", 1);
    let tree = Tree::blessed(&[("a", &filtered)]);
    tree.run(&["export", "a", "--to", "Nff", "--out", "nff"])
        .expect_code(1)
        .expect("Nff has no words for")
        .expect("PixelFilter");
    assert!(!tree.path("nff").exists());
}

#[test]
fn a_scene_as_json_makes_the_same_picture() {
    let tree = Tree::blessed(&[("a", SQUARE)]);
    tree.run(&["export", "a", "--to", "Json", "--out", "json"]).expect_code(0);
    tree.run(&["render", "a", "--out", "ron.exr"]).expect_code(0);
    tree.run(&["render", "json/scene.json", "--out", "json.exr"]).expect_code(0);
    let picture = |name| fs::read(tree.path(name)).unwrap();
    assert!(picture("ron.exr") == picture("json.exr"));
    let text = fs::read_to_string(tree.path("json/scene.json")).unwrap();
    tree.write("bad.json", text.replace("\"version\"", "\"vresion\"").as_bytes());
    tree.run(&["render", "bad.json", "--out", "bad.exr"])
        .expect_code(2)
        .expect("bad.json:2:11: unknown field `vresion`");
    tree.write("bad.json", text.replace("\"version\": 1", "\"version\": 7").as_bytes());
    tree.run(&["render", "bad.json", "--out", "bad.exr"])
        .expect_code(2)
        .expect("bad.json: expected version 1");
}
