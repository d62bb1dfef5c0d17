//! `import` by its real binary: exit codes, what is written, and what is not.
#![allow(clippy::unwrap_used, clippy::disallowed_methods)]

mod tree;

use std::fs;

use tree::{SQUARE, Tree};

/// A ball that fills a window of 4 x 3.
const BALL: &str = r#"<scene>
  <camera type="ParallelCamera">
    <viewPoint>0 0 5</viewPoint><viewWidth>4</viewWidth><viewHeight>3</viewHeight>
  </camera>
  <image>16 12</image>
  <surface type="Sphere"><shader type="Normal"/></surface>
</scene>
"#;

const MESH: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

fn with(more: &str) -> String {
    BALL.replace("</scene>", &format!("{more}\n</scene>"))
}

/// A folder with these files in `in/`.
fn tree(files: &[(&str, &str)]) -> Tree {
    let tree = Tree::new(&[]);
    for (name, text) in files {
        tree.write(&format!("in/{name}"), text.as_bytes());
    }
    tree
}

/// The files in a folder, sorted; none if it is not there.
fn files(tree: &Tree, folder: &str) -> Vec<String> {
    let entries = fs::read_dir(tree.path(folder));
    let names = entries.into_iter().flatten().map(|entry| entry.unwrap().file_name());
    let mut names: Vec<_> = names.map(|name| name.into_string().unwrap()).collect();
    names.sort();
    names
}

#[test]
fn what_cannot_be_read_is_told_and_nothing_is_written() {
    #[track_caller]
    fn check(name: &str, text: &str, expected: &str) {
        let tree = tree(&[(name, text)]);
        let ran = tree.run(&["import", &format!("in/{name}"), "--out", "out/a.ron"]);
        ran.expect_code(2).expect(expected).expect("unreadable  in/");
        assert_eq!(files(&tree, "out"), [""; 0]);
    }
    check("a.xml", &BALL[..60], "in/a.xml:3:20: expected the file's elements to be closed");
    check("a.xml", &with("<exposure>x</exposure>"), "in/a.xml:7:1: exposure: expected a number");
    check("a.xml", "<!DOCTYPE s []><scene/>", "expected no document type declaration");
    let mesh = "<surface type=\"Mesh\"><data>none.obj</data></surface>";
    check("a.xml", &with(mesh), "data: the mesh \"none.obj\" does not exist");
    check("a.nff", "s 0 0 0 x", "in/a.nff:1:9: s, number 4 of 4: expected a number");
    check("a.blend", "", "expected a file that ends in .xml, .nff");
    let tree = tree(&[]);
    tree.run(&["import", "in/a.xml", "--out", "a.ron"]).expect_code(2).expect("no such file");
    tree.run(&["import", ".", "--out", "a.ron"]).expect_code(2).expect("is no file");
}

#[test]
fn usage() {
    let tree = tree(&[("a.xml", BALL), ("b.xml", BALL), ("b.nff", "")]);
    let check = |args: &str, expected: &str| {
        let args: Vec<_> = args.split(' ').collect();
        tree.run(&args).expect_code(2).expect(expected);
    };
    check("import", "FILE");
    check("import in/a.xml", "--out");
    check("import in/a.xml in/b.xml --out a.ron", "expected a folder");
    check("import in/b.xml in/b.nff --out out", "two files would be written here");
    check("import in/a.xml --out in/b.xml", "expected a folder or a name that ends in .ron");
    check("import in/a.xml --out out/a.ron --assets in", "--assets: expected the folder");
    check("import in/a.xml --out out/a.ron --assets out/..", "--assets: expected the folder");
    check("import in/a.xml --out a.ron --shading phong", "classic, attenuated or radiometric");
    check("import in/a.xml --out a.ron --image 3", "320x240");
    check("import in/a.xml --out a.ron --camera Fisheye()", "--camera");
    check("import in/a.xml --out a.ron --within 1", "--compare-to");
    for within in ["inf", "nan", "1e9", "1.001", "-0.1", "x"] {
        let args = format!("import in/a.xml --out out/a.ron --compare-to x --within={within}");
        check(&args, "expected a finite number from 0 to 1");
    }
    for pattern in ["{nmae}.png", "{file.png", "{name}{}.png"] {
        let args = format!("import in/a.xml --out out/a.ron --if-there --compare-to {pattern}");
        check(&args, "expected {file} or {name}, found {");
    }
    assert_eq!(files(&tree, "out"), [""; 0]);
}

#[test]
fn losses_are_refused_unless_they_are_wanted() {
    let tree = tree(&[("a.xml", &with("<samples>8</samples>"))]);
    let run = |more: &[&str]| tree.run(&[&["import", "in/a.xml", "--out", "a.ron"], more].concat());
    let found = "in/a.xml:7:1: samples: is not known inside scene and is left out";
    run(&[]).expect_code(1).expect(found).expect("refused     in/a.xml: 1 thing would be lost");
    assert!(!tree.path("a.ron").exists());
    run(&["--lossy"]).expect_code(0).expect(found).expect("wrote a.ron, without 1 thing");
    let text = fs::read_to_string(tree.path("a.ron")).unwrap();
    assert!(text.starts_with("// Imported from in/a.xml.\n// Chosen: Classic shading"), "{text}");
    assert!(text.contains("// Lost: 7:1: samples: is not known"), "{text}");
    tree.run(&["render", "a.ron", "--out", "a.png"]).expect_code(0);
}

#[test]
fn files_that_are_there_stay_unless_forced() {
    let tree = tree(&[("a.xml", BALL)]);
    let run = |more: &[&str]| tree.run(&[&["import", "in/a.xml", "--out", "a.ron"], more].concat());
    run(&[]).expect_code(0).expect("imported    in/a.xml: wrote a.ron");
    run(&[]).expect_code(0);
    let first = fs::read(tree.path("a.ron")).unwrap();
    for mine in ["mine".to_owned(), "mine".repeat(1_000)] {
        tree.write("a.ron", mine.as_bytes());
        run(&[]).expect_code(2).expect("a.ron: is there already and is not the same: --force");
        assert_eq!(fs::read(tree.path("a.ron")).unwrap(), mine.as_bytes());
        run(&["--force"]).expect_code(0);
        assert_eq!(fs::read(tree.path("a.ron")).unwrap(), first);
    }
}

#[test]
fn nothing_is_written_among_fixtures_and_goldens() {
    let tree = Tree::blessed(&[("b", SQUARE)]);
    tree.write("in/a.xml", BALL.as_bytes());
    for place in ["fixtures/a.ron", "golden/a.ron", "target/goldray/a.ron"] {
        let ran = tree.run(&["import", "in/a.xml", "--out", place]).expect_code(2);
        let ran = ran.expect("expected a place outside of the suite's");
        let said = ran.expect("/: write it elsewhere").stdout();
        let says_more = said.contains("then copy it there with the files that it names, and");
        assert_eq!(says_more, place.starts_with("fixtures/"), "{said}");
        assert!(!tree.path(place).exists());
    }
    // Which works.
    tree.run(&["import", "in/a.xml", "--out", "out/a.ron"]).expect_code(0);
    tree.write("fixtures/a.ron", &fs::read(tree.path("out/a.ron")).unwrap());
    tree.run(&["bless", "a"]).expect_code(0);
    tree.run(&["check", "a"]).expect_code(0);
}

#[test]
fn the_help_names_every_format_that_is_read() {
    let tree = Tree::blessed(&[("b", SQUARE)]);
    let help = tree.run(&["import", "--help"]).expect_code(0).stdout();
    let endings: Vec<_> = interchange::import::endings().collect();
    assert!(endings.len() > 5, "{endings:?}");
    for ending in endings {
        assert!(help.contains(&format!(".{ending}")), ".{ending}: {help}");
    }
}

#[test]
fn meshes_go_where_they_are_told_whole_or_not_at_all() {
    let text = with("<surface type=\"Mesh\"><data>m/a.obj</data></surface>");
    let tree = tree(&[("a.xml", &text), ("m/a.obj", MESH)]);
    tree.run(&["import", "in/a.xml", "--out", "out/a.ron"]).expect_code(0).expect("and 1 file");
    assert_eq!(fs::read(tree.path("out/m/a.obj")).unwrap(), MESH.as_bytes());
    let args = ["import", "in/a.xml", "--out", "two/a.ron", "--assets", "two/meshes"];
    tree.run(&args).expect_code(0);
    assert_eq!(fs::read(tree.path("two/meshes/m/a.obj")).unwrap(), MESH.as_bytes());
    tree.run(&["render", "two/a.ron", "--out", "a.png"]).expect_code(0);
    // A mesh that is another file, and a folder in the scene's place.
    tree.write("three/m/a.obj", b"mine");
    tree.run(&["import", "in/a.xml", "--out", "three/a.ron"]).expect_code(2).expect("a.obj");
    assert_eq!(files(&tree, "three"), ["m"]);
    fs::create_dir_all(tree.path("four/a.ron")).unwrap();
    tree.run(&["import", "in/a.xml", "--out", "four/a.ron"]).expect_code(2).expect("is no file");
    assert_eq!(files(&tree, "four"), ["a.ron"]);
}

#[cfg(unix)]
#[test]
fn nothing_is_written_or_read_through_a_link_that_leads_out() {
    let text = with("<surface type=\"Mesh\"><data>m/a.obj</data></surface>");
    let tree = tree(&[("a.xml", &text), ("m/a.obj", MESH)]);
    for folder in ["elsewhere", "out"] {
        fs::create_dir_all(tree.path(folder)).unwrap();
    }
    std::os::unix::fs::symlink(tree.path("elsewhere"), tree.path("out/m")).unwrap();
    let ran = tree.run(&["import", "in/a.xml", "--out", "out/a.ron"]).expect_code(2);
    ran.expect("a link leads out of the scene's folder");
    assert_eq!(files(&tree, "elsewhere"), [""; 0]);
    assert_eq!(files(&tree, "out"), ["m"]);
    fs::rename(tree.path("in/m/a.obj"), tree.path("b.obj")).unwrap();
    std::os::unix::fs::symlink(tree.path("b.obj"), tree.path("in/m/a.obj")).unwrap();
    let ran = tree.run(&["import", "in/a.xml", "--out", "two/a.ron"]).expect_code(2);
    ran.expect("the mesh \"m/a.obj\" is a link that leaves the scene's folder");
}

#[test]
fn a_file_may_name_others_beside_its_folder_if_it_is_allowed() {
    let text = with("<surface type=\"Mesh\"><data>../../m/a.obj</data></surface>");
    let tree = tree(&[("s/t/a.xml", &text), ("m/a.obj", MESH)]);
    let run =
        |more: &[&str]| tree.run(&[&["import", "in/s/t/a.xml", "--out", "a.ron"], more].concat());
    let ran = run(&[]).expect_code(2).expect("\"../../m/a.obj\" leads out of the scene's folder");
    ran.expect("--assets-from DIR");
    run(&["--assets-from", "in/s"]).expect_code(2).expect("leads out of the scene's folder");
    run(&["--assets-from", "in"]).expect_code(0).expect("wrote a.ron and 1 file");
    assert_eq!(fs::read(tree.path("m/a.obj")).unwrap(), MESH.as_bytes());
}

#[test]
fn many_files_have_a_line_each() {
    let lossy = with("<fog/>");
    let tree = tree(&[("a.xml", BALL), ("b.xml", "<scene"), ("c.xml", &lossy), ("d.xml", BALL)]);
    let run = |files: &[&str]| {
        let files = files.iter().map(|file| format!("in/{file}"));
        let args: Vec<_> = files.chain(["--out", "out"].map(str::to_owned)).collect();
        tree.run(&[&["import"], &*args.iter().map(String::as_str).collect::<Vec<_>>()].concat())
    };
    let ran = run(&["a.xml", "b.xml", "c.xml", "d.xml"]).expect_code(2);
    let ran = ran.expect("imported    in/a.xml").expect("unreadable  in/b.xml");
    ran.expect("refused     in/c.xml").expect("imported    in/d.xml");
    assert_eq!(files(&tree, "out"), ["a.ron", "d.ron"]);
    run(&["a.xml", "c.xml"]).expect_code(1);
    run(&["a.xml", "d.xml"]).expect_code(0);
}

#[test]
fn pictures_are_compared_with_those_that_came_along() {
    let tree = tree(&[("a.xml", BALL)]);
    let run = |more: &[&str]| tree.run(&[&["import", "in/a.xml", "--compare-to"], more].concat());
    run(&["{file}.png"]).expect_code(2).expect("no answer   in/a.xml: expected the picture");
    tree.run(&["import", "in/a.xml", "--out", "a.ron"]).expect_code(0);
    tree.run(&["render", "a.ron", "--out", "in/a.xml.png"]).expect_code(0);
    tree.run(&["render", "a.ron", "--out", "in/a_ref.exr"]).expect_code(0);
    let none = "agrees      in/a.xml: no difference in 192 pixels";
    run(&["{file}.png"]).expect_code(0).expect(none);
    let ran = run(&["none.png", "--compare-to", "{name}_ref.exr"]);
    ran.expect_code(1).expect("differs     in/a.xml: largest difference").expect("(linear)");
    run(&["{name}_ref.exr", "--within", "1e-7"]).expect_code(0).expect("agrees");
    // A little larger, so that its normals are others.
    let larger = BALL.replace("<shader", "<radius>1.05</radius><shader");
    tree.write("in/a.xml", larger.as_bytes());
    let ran = run(&["{file}.png", "--max-abs", "1", "--most", "1"]).expect_code(1);
    ran.expect("differs     in/a.xml: largest difference 10/255 at (4, 4), 51 of");
    run(&["{file}.png", "--max-abs", "10", "--most", "51"]).expect_code(0);
    run(&["{file}.png", "--max-abs", "255", "--most", "50"]).expect_code(1);
    tree.write("in/a.xml", BALL.replace("16 12", "16 16").as_bytes());
    run(&["{file}.png"]).expect_code(2).expect("expected a picture of 16 x 12");
    tree.write("in/a.xml.png", b"GIF89a");
    run(&["{file}.png"]).expect_code(2).expect("is neither a PNG nor an EXR");
    run(&["{file}.png", "--if-there"]).expect_code(2).expect("is neither a PNG nor an EXR");
}

#[test]
fn pictures_may_be_missing_beside_some_files_but_not_beside_all() {
    let lossy = with("<fog/>");
    let tree = tree(&[("a.xml", BALL), ("b.xml", BALL), ("c.xml", &lossy)]);
    let run = |files: &[&str]| {
        let compare = ["--compare-to", "{name}.exr", "--compare-to", "{file}.png", "--if-there"];
        tree.run(&[&["import"], files, &compare].concat())
    };
    let alone = "rendered    in/a.xml: no picture to compare it with";
    let none = |n: &str| {
        format!(
            "no answer   --compare-to {{name}}.exr, {{file}}.png: expected a picture beside one \
             FILE or more, found none beside {n}"
        )
    };
    run(&["in/a.xml"]).expect_code(2).expect(alone).expect(&none("1 FILE:"));
    run(&["in/a.xml", "in/b.xml"]).expect_code(2).expect(&none("2 FILEs:"));
    run(&["in/a.xml", "in/c.xml"]).expect_code(2).expect("refused").expect(&none("1 FILE:"));
    tree.run(&["import", "in/b.xml", "--out", "b.ron"]).expect_code(0);
    tree.run(&["render", "b.ron", "--out", "in/b.xml.png"]).expect_code(0);
    let ran = run(&["in/a.xml", "in/b.xml"]).expect_code(0).expect(alone);
    let stdout = ran.expect("agrees      in/b.xml").stdout();
    assert!(!stdout.contains("no answer"), "{stdout}");
    run(&["in/a.xml", "in/b.xml", "in/c.xml"]).expect_code(1);
    // One that differs was compared.
    tree.write("in/b.xml", BALL.replace("<shader", "<radius>1.05</radius><shader").as_bytes());
    run(&["in/a.xml", "in/b.xml"]).expect_code(1).expect(alone).expect("differs     in/b.xml");
}

#[test]
fn a_picture_that_cannot_be_looked_for_is_not_missing() {
    let tree = tree(&[("a.xml", BALL), ("b.xml", BALL), ("folder/x", "")]);
    tree.run(&["import", "in/b.xml", "--out", "b.ron"]).expect_code(0);
    tree.run(&["render", "b.ron", "--out", "in/b.png"]).expect_code(0);
    #[cfg(unix)]
    std::os::unix::fs::symlink("nothing", tree.path("in/link")).unwrap();
    let mut cases = vec![
        ("none/{name}.png", "in/none: there is no such folder"),
        ("b.xml/{name}.png", "in/b.xml: is no folder"),
        ("folder", "in/folder: is no file"),
    ];
    if cfg!(unix) {
        cases.push(("link", "in/link: is a link to nothing"));
    }
    for (pattern, expected) in cases {
        // Even where another pattern would be there, which may ask for less.
        let patterns = ["--compare-to", pattern, "--compare-to", "b.png"];
        let args = [&["import", "in/a.xml"], &patterns[..]].concat();
        let said = format!("no answer   in/a.xml: expected a picture, {expected}");
        tree.run(&args).expect_code(2).expect(&said);
        tree.run(&[&args[..], &["--if-there"]].concat()).expect_code(2).expect(&said);
    }
}
