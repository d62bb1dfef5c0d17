//! The real binary in a temporary tree: exit codes and text.
#![allow(clippy::unwrap_used, clippy::disallowed_methods)]

mod tree;

use std::fs;
use std::path::Path;
use std::process::Command;

use tree::{Ran, SQUARE, Tree};

/// What changes from run to run, made plain.
fn plain(json: &str) -> String {
    let times = ["render_ms", "compare_ms", "relate_ms", "elapsed_ms"];
    let plain = |line: &str| match times.iter().find(|key| line.contains(&format!("\"{key}\""))) {
        Some(key) => format!("      {key}: [a time]"),
        None => line.to_owned(),
    };
    json.lines().map(plain).collect::<Vec<_>>().join("\n")
}

#[test]
fn help_of_every_verb() {
    let tree = Tree::new(&[]);
    let help = |verb: &str| {
        let args: Vec<_> = verb.split_whitespace().chain(["--help"]).collect();
        tree.run(&args).expect_code(0).stdout()
    };
    let verbs = [
        "",
        "check",
        "bless",
        "review",
        "watch",
        "new",
        "minimize",
        "list",
        "render",
        "export",
        "compare",
        "contact-sheet",
        "digest",
        "meshes",
        "bench",
        "sensitivity",
        "lint",
        "calibrate",
        "completions",
    ];
    let all = verbs.map(|verb| format!("==== {verb} ====\n{}", help(verb))).join("\n");
    insta::assert_snapshot!(all);
}

#[test]
fn check_answers_yes_no_and_cannot_ask() {
    let tree = Tree::blessed(&[("a", SQUARE), ("b", SQUARE)]);
    tree.run(&["check"]).expect_code(0).expect("2 judged: 2 match");
    tree.run(&["check", "a"]).expect_code(0).expect("1 judged: 1 match");
    tree.run(&["check", "c"]).expect_code(2).expect("the filter \"c\" selects nothing");
    tree.run(&["check", "--no-such-flag"]).expect_code(2);
    tree.run(&["no-such-verb"]).expect_code(2);
    tree.run(&["check", "--root", "/nowhere"]).expect_code(2).expect("fixtures/");
    fs::remove_file(tree.path("golden/b.png")).unwrap();
    let ran = tree.run(&["check"]).expect_code(1).expect("1 match, 1 missing golden");
    ran.expect("missing golden      b: there is no golden | see target/goldray/b.png | if meant: cargo xtask bless b");
    assert!(tree.path("target/goldray/b.png").is_file());
}

#[test]
fn check_says_what_is_wrong_with_a_fixture() {
    let tree = Tree::blessed(&[("a", SQUARE), ("b", SQUARE)]);
    tree.write("fixtures/b.ron", SQUARE.replace("image", "imgae").as_bytes());
    let ran = tree.run(&["check"]).expect_code(1);
    ran.expect("fixtures/b.ron:4:5: unknown field `imgae`").expect("did you mean `image`?");
    tree.write("fixtures/b.ron", b"\xff");
    tree.run(&["check"]).expect_code(1).expect("expected UTF-8 text");
}

#[test]
fn check_works_from_a_folder_below_the_suite() {
    let tree = Tree::blessed(&[("deep/a", SQUARE)]);
    let mut command = Command::new(env!("CARGO_BIN_EXE_xtask"));
    let output = command.arg("check").current_dir(tree.path("fixtures/deep")).output().unwrap();
    Ran(output).expect_code(0).expect("1 match");
}

#[test]
fn the_shape_of_the_json() {
    let tree = Tree::blessed(&[("a", SQUARE), ("b", SQUARE), ("c", SQUARE)]);
    tree.write("fixtures/b.ron", SQUARE.replace("(1, 1, 1)", "(1, 0.5, 1)").as_bytes());
    fs::remove_file(tree.path("golden/c.png")).unwrap();
    tree.run(&["check", "--json", "out/all.json"]).expect_code(1);
    let json = fs::read_to_string(tree.path("out/all.json")).unwrap();
    insta::assert_snapshot!(plain(&json));
}

#[test]
fn a_relation_that_fails_is_said_and_not_blessed() {
    // Two squares at one place: which one is seen follows from their order.
    let tie = SQUARE.replace("Silhouette", "SurfaceColor").replace(
        "objects: [",
        "check: (relations: [PermuteObjects()]),
    objects: [Box(min: (-1, -1, -1), max: (0, 1, 1), material: Constant(color: (1, 0, 0))), ",
    );
    let tree = Tree::new(&[("a", &tie)]);
    let found = "relation PermuteObjects(): pixel (4, 2): expected [1.0, 0.0, 0.0], found \
                 [1.0, 1.0, 1.0]; 32 of 192 pixels differ";
    tree.run(&["bless", "--all"]).expect_code(1).expect("refused   a: ").expect(found);
    let apart = tie.replace("-1, -1, -1), max: (0, 1, 1)", "-1, -1, -1), max: (0, 1, 1.5)");
    tree.write("fixtures/a.ron", apart.as_bytes());
    tree.run(&["bless", "--all"]).expect_code(0);
    tree.run(&["check"]).expect_code(0).expect("1 judged: 1 match");
    let none = apart.replace("PermuteObjects()", "SumOfLights()");
    tree.write("fixtures/a.ron", none.as_bytes());
    let ran = tree.run(&["check"]).expect_code(1);
    ran.expect("fixtures/a.ron:7:").expect("SumOfLights: expected two lights or more, found 0");
}

#[test]
fn bless_is_deliberate_narrow_and_impossible_in_ci() {
    let tree = Tree::new(&[("a", SQUARE), ("b", SQUARE)]);
    tree.run(&["bless"]).expect_code(2);
    tree.run(&["bless", "--all", "a"]).expect_code(2);
    for value in ["true", "1", ""] {
        let ran = tree.run_with(&["bless", "--all"], &[("CI", value)]);
        ran.expect_code(2).expect("found the variable CI set");
    }
    assert!(!tree.path("golden").exists());
    tree.run(&["bless", "zzz"]).expect_code(2).expect("selects nothing");

    tree.run(&["bless", "a"]).expect_code(0).expect("added     a").expect("1 written");
    assert!(tree.path("golden/a.png").is_file() && !tree.path("golden/b.png").exists());
    tree.run(&["bless", "--all"]).expect_code(0).expect("1 written, 1 left as they were");

    tree.write("fixtures/a.ron", SQUARE.replace("(1, 1, 1)", "(1, 0.5, 1)").as_bytes());
    let ran = tree.run(&["bless", "a"]).expect_code(0);
    ran.expect("replaced  a: was stale golden, old to new: 16 px differ");
    let left = fs::read_dir(tree.path("golden")).unwrap().count();
    assert_eq!(left, 2, "no temporary file is left behind");
}

#[test]
fn bless_removes_orphans_only_when_asked() {
    let tree = Tree::blessed(&[("a", SQUARE), ("b", SQUARE)]);
    fs::remove_file(tree.path("fixtures/b.ron")).unwrap();
    tree.run(&["check"]).expect_code(1).expect("cargo xtask bless --prune b");
    tree.run(&["bless", "--all"]).expect_code(0).expect("--prune removes it");
    assert!(tree.path("golden/b.png").is_file());
    tree.run(&["bless", "--prune", "b"]).expect_code(0).expect("pruned    b");
    assert!(!tree.path("golden/b.png").exists());
    tree.run(&["check"]).expect_code(0);
}

#[test]
fn new_writes_a_fixture_that_can_be_blessed() {
    let tree = Tree::blessed(&[("a", SQUARE)]);
    tree.run(&["new", "area/mine"]).expect_code(0).expect("wrote fixtures/area/mine.ron");
    tree.run(&["new", "area/mine"]).expect_code(2).expect("is there already");
    tree.run(&["new", "../mine"]).expect_code(2).expect("expected a name");
    tree.run(&["check"]).expect_code(1).expect("missing golden");
    tree.run(&["bless", "area/mine"]).expect_code(0);
    tree.run(&["check"]).expect_code(0).expect("2 match");
}

#[test]
fn list_names_and_metrics() {
    let tree = Tree::blessed(&[("a", SQUARE), ("b", SQUARE)]);
    assert_eq!(tree.run(&["list"]).expect_code(0).stdout(), "a\nb\n");
    assert_eq!(tree.run(&["list", "b"]).expect_code(0).stdout(), "b\n");
    tree.run(&["list", "zzz"]).expect_code(2);
    tree.run(&["list", "--json"]).expect_code(0).expect("\"file\": \"fixtures/a.ron\"");
    tree.run(&["list", "--metrics"]).expect_code(0).expect("ssim_min").expect("cannot see");
    tree.run(&["list", "--metrics", "--json"]).expect_code(0).expect("\"name\": \"flip_mean\"");
    tree.run(&["list", "--metrics", "--markdown"]).expect_code(0).expect("| identical | Same |");
    tree.run(&["list", "--markdown"]).expect_code(2).expect("--metrics");
}

#[test]
fn render_and_compare() {
    let tree = Tree::blessed(&[("a", SQUARE)]);
    tree.run(&["render", "a", "--out", "a.png"]).expect_code(0);
    tree.run(&["render", "fixtures/a.ron", "--out", "a.exr"]).expect_code(0);
    tree.write("fixtures/fixtures/x.ron", SQUARE.as_bytes());
    tree.run(&["render", "fixtures/x", "--out", "x.png"]).expect_code(0);
    tree.run(&["render", "fixtures/", "--out", "x.png"]).expect_code(2).expect("an empty filter");
    tree.run(&["compare", "golden/a.png", "a.png"]).expect_code(0).expect("ssim_mean");
    tree.run(&["compare", "a.png", "a.exr"]).expect_code(0);
    tree.run(&["compare", "a.exr", "a.exr"]).expect_code(0).expect("linear_max_abs");
    tree.write("fixtures/b.ron", SQUARE.replace("(1, 1, 1)", "(1, 0.5, 1)").as_bytes());
    tree.run(&["render", "b", "--out", "b.png"]).expect_code(0);
    let ran = tree.run(&["compare", "a.png", "b.png", "--json"]).expect_code(1);
    ran.expect("\"schema\": 1").expect("\"differing_pixels\": 16").expect("\"max_abs\": 255");

    tree.run(&["render", "a", "--out", "a.gif"]).expect_code(2).expect(".png or .exr");
    tree.run(&["render", "nowhere.ron", "--out", "a.png"]).expect_code(2).expect("no such file");
    tree.run(&["compare", "a.png", "nowhere.png"]).expect_code(2).expect("no such file");
    tree.run(&["compare", "a.png", "fixtures/a.ron"]).expect_code(2).expect("neither a PNG nor");
    tree.write("fixtures/c.ron", SQUARE.replace("(16, 12)", "(8, 6)").as_bytes());
    tree.run(&["render", "c", "--out", "c.png"]).expect_code(0);
    let ran = tree.run(&["compare", "a.png", "c.png"]).expect_code(2);
    ran.expect("expected a picture of 16 x 12, found 8 x 6");
}

#[test]
fn what_belongs_to_the_suite_is_not_written_over() {
    let tree = Tree::blessed(&[("a", SQUARE)]);
    let outside = "expected a place outside of the suite's";
    tree.run(&["check", "--json", "fixtures/a.ron"]).expect_code(2).expect(outside);
    tree.run(&["check", "--json", "golden/new/a.json"]).expect_code(2).expect(outside);
    tree.run(&["render", "a", "--out", "golden/a.png"]).expect_code(2).expect(outside);
    let mut command = Command::new(env!("CARGO_BIN_EXE_xtask"));
    command.args(["check", "--json", "new/a.json"]).current_dir(tree.path("fixtures"));
    Ran(command.output().unwrap()).expect_code(2).expect(outside);
    fs::create_dir(tree.path("folder")).unwrap();
    tree.run(&["check", "--json", "folder"]).expect_code(2).expect("is no file");
    tree.run(&["check"]).expect_code(0);
    #[cfg(unix)]
    {
        fs::create_dir(tree.path("golden/s")).unwrap();
        std::os::unix::fs::symlink("golden/s", tree.path("lnk")).unwrap();
        tree.run(&["check", "--json", "lnk/../a.png"]).expect_code(2).expect(outside);
        tree.run(&["check"]).expect_code(0);
    }
    fs::remove_dir_all(tree.path("golden")).unwrap();
    tree.run(&["check", "--json", "golden/a.png"]).expect_code(2).expect(outside);
    tree.run(&["check", "--json", "golden"]).expect_code(2).expect(outside);
    assert!(!tree.path("golden").exists());
}

#[test]
fn commands_are_printed_as_they_work_where_the_reader_is() {
    let tree = Tree::new(&[("it's", SQUARE), ("-x", SQUARE)]);
    let ran = tree.run(&["check"]).expect_code(1);
    let ran = ran.expect(r"see target/goldray/it's.png | if meant: cargo xtask bless 'it'\''s'");
    ran.expect("cargo xtask bless -- '-x'");
    let root = tree.path("").display().to_string();
    let mut command = Command::new(env!("CARGO_BIN_EXE_xtask"));
    let output = command.args(["check", "--root", &root]).current_dir("/").output().unwrap();
    let ran = Ran(output).expect_code(1).expect(&format!("cargo xtask --root {root} bless"));
    ran.expect(&format!("see {root}target/goldray/"));
    tree.run(&["bless", ""]).expect_code(2).expect("an empty filter");
    assert!(!tree.path("golden").exists());
}

#[test]
fn the_contact_sheet_shows_every_golden() {
    let tree = Tree::blessed(&[("a", SQUARE), ("b", SQUARE)]);
    tree.run(&["contact-sheet", "--out", "sheet.png"]).expect_code(0).expect("2 goldens");
    assert!(Path::new(&tree.path("sheet.png")).is_file());
    tree.run(&["contact-sheet", "a"]).expect_code(2);
    fs::remove_file(tree.path("golden/b.png")).unwrap();
    tree.run(&["contact-sheet", "--out", "sheet.png"]).expect_code(2).expect("expected a golden");
}

#[test]
fn digests_are_written_and_held_against() {
    let tree = Tree::blessed(&[("a", SQUARE), ("b", SQUARE)]);
    tree.run(&["digest", "--check"]).expect_code(2).expect("cargo xtask digest --write");
    tree.run_with(&["digest", "--write"], &[("CI", "1")]).expect_code(2).expect("CI");
    tree.run(&["digest", "--write"]).expect_code(0).expect("wrote golden/digests.txt, 2 lines");
    tree.run(&["digest", "--check"]).expect_code(0).expect("2 pictures have the bits of");
    tree.run(&["check"]).expect_code(0).expect("2 match");
    let printed = tree.run(&["digest", "b"]).expect_code(0).stdout();
    let table = fs::read_to_string(tree.path("golden/digests.txt")).unwrap();
    assert!(printed.starts_with("b ") && table.ends_with(&printed), "{printed}");

    // Another picture of the same name.
    let dim = SQUARE.replace("show: Silhouette", "exposure: 0.5, background: (0.1, 0.1, 0.1)");
    tree.write("fixtures/a.ron", dim.as_bytes());
    let ran = tree.run(&["digest", "--check"]).expect_code(1);
    let ran = ran
        .expect("a: expected the linear picture ")
        .expect("if meant: cargo xtask digest --write");
    ran.expect("a: expected the encoded picture ");
    tree.run(&["digest", "--check", "b"]).expect_code(0).expect("1 picture has the bits of");
    tree.run(&["digest", "--write", "a"]).expect_code(0);
    tree.write("fixtures/c.ron", SQUARE.as_bytes());
    fs::remove_file(tree.path("fixtures/b.ron")).unwrap();
    let ran = tree.run(&["digest", "--check"]).expect_code(1);
    ran.expect("c: expected a line in").expect("b: expected a fixture");
    tree.run(&["digest", "--write"]).expect_code(0);
    tree.run(&["digest", "--check"]).expect_code(0);
    tree.write("fixtures/c.ron", b"()");
    tree.run(&["digest", "--check"]).expect_code(1).expect("fixtures/c.ron");
    tree.run(&["digest", "--write"]).expect_code(1).expect("nothing is written");
    tree.write("golden/digests.txt", b"nonsense");
    tree.run(&["digest", "--check", "a"]).expect_code(2).expect("line 1");
}

#[test]
fn meshes_are_looked_for_beside_the_scene_and_nowhere_else() {
    let mesh = SQUARE.replace("Box(min: (-1, -1, -1), max: (1, 1, 1))", "Mesh(file: \"m/a.obj\")");
    let tree = Tree::new(&[("area/a", &mesh)]);
    let obj = b"v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nf 1 2 3 4\n";
    tree.run(&["check"]).expect_code(1).expect("mesh \"m/a.obj\" does not exist");
    tree.write("fixtures/area/m/a.obj", obj);
    tree.run(&["bless", "--all"]).expect_code(0);
    tree.run(&["check"]).expect_code(0);
    // The picture is the same, but not by the golden's word.
    tree.write("fixtures/area/m/a.obj", &[&obj[..], b"# a comment\n"].concat());
    tree.run(&["check"]).expect_code(1).expect("a file that the scene names changed");
    #[cfg(unix)]
    {
        tree.write("secret.obj", obj);
        fs::remove_file(tree.path("fixtures/area/m/a.obj")).unwrap();
        std::os::unix::fs::symlink(tree.path("secret.obj"), tree.path("fixtures/area/m/a.obj"))
            .unwrap();
        tree.run(&["check"]).expect_code(1).expect("is a link that leaves the scene's folder");
    }
}

#[test]
fn a_reader_that_leaves_gets_no_panic() {
    let (reader, writer) = std::io::pipe().unwrap();
    drop(reader);
    let tree = Tree::new(&[("square", SQUARE)]);
    let mut command = Command::new(env!("CARGO_BIN_EXE_xtask"));
    let command = command.args(["list"]).current_dir(tree.0.path()).stdout(writer);
    let ran = command.stderr(std::process::Stdio::piped()).spawn().unwrap();
    let output = ran.wait_with_output().unwrap();
    assert_eq!(output.status.code(), Some(2));
    assert_eq!(String::from_utf8_lossy(&output.stderr), "");
}

#[test]
fn render_explains_counts_and_skips_nothing_if_asked() {
    let tree = Tree::new(&[("square", SQUARE)]);
    let ran = tree.run(&["render", "square", "--explain"]).expect_code(0);
    ran.expect("shapes: 1 box; no code runs for spheres, triangles,").expect("shading: none");
    tree.run(&["render", "square"]).expect_code(2);
    let counted = |flags: &[&str]| {
        let args = [&["render", "square", "--stats", "n.json", "--out", "p.exr"][..], flags];
        tree.run(&args.concat()).expect_code(0);
        let text = fs::read_to_string(tree.path("n.json")).unwrap();
        let counts: serde_json::Value = serde_json::from_str(&text).unwrap();
        (fs::read(tree.path("p.exr")).unwrap(), counts)
    };
    let ((with, skipping), (without, all)) = (counted(&[]), counted(&["--no-skip"]));
    assert!(with == without, "the same picture");
    assert_eq!((&skipping["skips"], &all["skips"]), (&true.into(), &false.into()));
    assert_eq!(all["counts"]["eye_rays"], 16 * 12);
    assert_eq!(skipping["counts"]["shaded_hits"], 0);
    assert!(all["counts"]["shaded_hits"].as_u64() > Some(0));
    // Its edges are between pixels: more samples see the same.
    let (adaptive, counts) = counted(&["--error", "0.01"]);
    assert!(adaptive == with && counts["counts"]["pixels_refined"].as_u64() > Some(0));
    let ran = tree.run(&["render", "square", "--error", "0", "--out", "p.exr"]).expect_code(2);
    ran.expect("expected a number from 1e-6 to 1");
    // Other samples than the scene asks for.
    let (_, counts) = counted(&["--no-skip", "--samples", "5", "--sampler", "sobol:7"]);
    assert_eq!(counts["counts"]["eye_rays"], 5 * 16 * 12);
    assert!(counted(&["--filter", "tent"]).0 == with && counted(&["--filter", "tent:2"]).0 != with);
    let refused = |flags: &[&str], why: &str| {
        let args = [&["render", "square", "--out", "p.exr"][..], flags];
        tree.run(&args.concat()).expect_code(2).expect(why);
    };
    refused(&["--samples", "5"], "a square number");
    refused(&["--filter", "tent:9"], "a number of pixels from 0.5 to 4, found 9");
    refused(&["--sampler", "halton"], "expected grid, stratified or sobol");
    refused(&["--error", "0.1", "--samples", "4"], "cannot be used with");
    let flags = ["render", "square", "--explain", "--sampler", "stratified", "--filter", "tent"];
    let ran = tree.run(&flags).expect_code(0).expect("1 sample stratified a pixel");
    ran.expect("tent filter of radius 1: a pixel is made of the samples of 3 x 3 pixels");
}
