//! What `check` writes for machines, of a suite with every verdict that a right
//! tracer can get, and with names and findings that are hard to write down.
//!
//! `.ci/outputs` has these very files held against their schemas: it names a
//! folder for them in `GOLDRAY_OUTPUTS`.
#![cfg(unix)]
#![allow(clippy::unwrap_used, clippy::disallowed_methods)]

mod tree;

use std::fs;
use std::path::Path;

use harness::encode::EncodedImage;
use harness::golden::{from_png, to_png};
use serde_json::Value;
use tree::{SQUARE, Tree};

/// Where the suite is in the repository, as it need not be on top.
const SUITE: &str = "sub folder";

/// What XML, Markdown and GitHub's runner take for their own.
const UGLY: &str = "u<g>l&y ]]> \"'|`@x`/100%,a:b Kügelchen";

/// What its picture must be, after `check:`.
fn with_check(text: &str, check: &str) -> String {
    text.replace("    objects:", &format!("    check: ({check}),\n    objects:"))
}

/// A square whose half is there twice, so that the order of objects decides.
fn tie() -> String {
    let left = "Box(min: (-1, -1, -1), max: (0, 1, 1), material: Constant(color: (1, 0, 0)))";
    let colored = SQUARE.replace("Silhouette", "SurfaceColor");
    colored.replace("objects: [", &format!("objects: [{left}, "))
}

/// The suite, and how many of each verdict it has.
fn every_verdict() -> (Tree, Vec<(&'static str, u64)>) {
    let tie = tie();
    let square = |name: &'static str| (name, SQUARE);
    let fixtures = [
        square("fine"),
        square(UGLY),
        square("differs"),
        square("area/expectation"),
        ("area/relation", &tie),
        square("area/missing"),
        square("gone/orphan"),
        square("size"),
        square("tampered"),
        square("stale"),
        square("large"),
        square("unreadable"),
        square("refused"),
    ];
    let inside: Vec<_> = fixtures
        .iter()
        .map(|(name, text)| (format!("../{SUITE}/fixtures/{name}"), *text))
        .collect();
    let inside: Vec<_> = inside.iter().map(|(name, text)| (name.as_str(), *text)).collect();
    let tree = Tree::new(&inside);
    tree.run(&["--root", SUITE, "bless", "--all"]).expect_code(0);
    let fixture = |name: &str| tree.path(&format!("{SUITE}/fixtures/{name}.ron"));
    let golden = |name: &str| tree.path(&format!("{SUITE}/golden/{name}.png"));
    let write = |name: &str, text: String| fs::write(fixture(name), text).unwrap();

    repaint(&golden(UGLY));
    repaint(&golden("differs"));
    let expectation = "\n        expect: [Count(rgb: (255, 255, 255), pixels: 65)]";
    write("area/expectation", with_check(SQUARE, expectation));
    write("area/relation", with_check(&tie, "relations: [IdentityGroup, PermuteObjects()]"));
    fs::remove_file(golden("area/missing")).unwrap();
    fs::remove_file(fixture("gone/orphan")).unwrap();
    crop(&golden("size"));
    tamper(&golden("tampered"));
    write("stale", SQUARE.replace("(-1, -1, -1)", "(-1, -1, -2)"));
    write("large", with_check(SQUARE, "large: \"it is not\""));
    fs::write(golden("unreadable"), "version https://git-lfs.github.com/spec/v1\n").unwrap();
    write("refused", SQUARE.replace("image: (16, 12)", "imgae: \"]]>\u{1b}%0A::error::\""));
    let counts = [
        ("match", 1),
        ("differs", 2),
        ("expectation_failed", 1),
        ("relation_failed", 1),
        ("unsteady", 0),
        ("missing_golden", 1),
        ("orphan_golden", 1),
        ("wrong_size", 1),
        ("tampered_golden", 1),
        ("stale_golden", 1),
        ("golden_file_size", 1),
        ("unreadable", 1),
        ("render_refused", 1),
    ];
    (tree, counts.to_vec())
}

/// Changes a golden's picture: the note stays, and is as true as it was of it.
fn repaint(path: &Path) {
    accept(path, |golden| {
        EncodedImage::from_fn(golden.size(), |x, y| match (x, y) {
            (5, 4) => [0, 0, 9],
            _ => golden.get(x, y).unwrap(),
        })
    });
}

/// Leaves the last row away.
fn crop(path: &Path) {
    accept(path, |golden| {
        let mut size = golden.size();
        size.height -= 1;
        EncodedImage::from_fn(size, |x, y| golden.get(x, y).unwrap())
    });
}

/// What would be written if this other picture had been accepted.
fn accept(path: &Path, other: impl Fn(&EncodedImage) -> EncodedImage) {
    let golden = from_png(&fs::read(path).unwrap()).unwrap();
    let png = to_png(&other(&golden.picture), golden.provenance.as_ref()).unwrap();
    fs::write(path, png).unwrap();
}

/// Another picture with the text chunk of the golden, as a program leaves it
/// that edits pictures.
fn tamper(path: &Path) {
    // A PNG's signature and header take so many bytes.
    const HEAD: usize = 33;
    let golden = fs::read(path).unwrap();
    let at = golden.windows(4).position(|w| w == b"tEXt").unwrap() - 4;
    let length = u32::from_be_bytes(golden[at..at + 4].try_into().unwrap()) as usize;
    repaint(path);
    let png = to_png(&from_png(&fs::read(path).unwrap()).unwrap().picture, None).unwrap();
    let note = &golden[at..at + length + 12];
    fs::write(path, [&png[..HEAD], note, &png[HEAD..]].concat()).unwrap();
}

/// Runs a check that writes all there is to write; what it prints, and a way to
/// its files.
fn checked(tree: &Tree) -> (String, impl Fn(&str) -> String) {
    let files = ["--json", "o/all.json", "--junit", "o/all.xml", "--summary", "o/all.md"];
    let root = ["--root", SUITE, "check"];
    let folder = tree.path("").display().to_string();
    tree.write("step.md", b"from before\n");
    let step = tree.path("step.md").display().to_string();
    let variables = [
        ("GITHUB_ACTIONS", "true"),
        ("GITHUB_WORKSPACE", folder.as_str()),
        ("GITHUB_STEP_SUMMARY", step.as_str()),
    ];
    let ran = tree.run_with(&[&root[..], &files].concat(), &variables).expect_code(1);
    let base = tree.path("");
    (ran.stdout(), move |file| fs::read_to_string(base.join(file)).unwrap())
}

#[test]
fn every_verdict_is_in_every_output() {
    let (tree, verdicts) = every_verdict();
    let (printed, file) = checked(&tree);
    let json: Value = serde_json::from_str(&file("o/all.json")).unwrap();
    let (xml, page) = (file("o/all.xml"), file("o/all.md"));
    for (verdict, count) in verdicts {
        assert_eq!(json["summary"][verdict], count, "{verdict}\n{printed}");
        if verdict == "match" || count == 0 {
            continue;
        }
        let words = verdict.replace('_', " ");
        assert!(xml.contains(&format!(" type=\"{verdict}\" message=\"{words}: ")), "{xml}");
        assert!(page.contains(&format!("</code> | {words} | ")), "{words}: {page}");
    }
    let elements = |name: &str| xml.matches(&format!("<{name} type=")).count();
    assert_eq!((elements("failure"), elements("error")), (10, 2));
    assert!(xml.contains("tests=\"13\" failures=\"10\" errors=\"2\""), "{xml}");
    assert!(page.starts_with("### goldray: 12 of 13 do not match\n"), "{page}");

    let plan = ["--root", SUITE, "bless", "--all", "--prune", "--plan", "o/plan.json"];
    tree.run(&plan).expect_code(1);
    if let Some(folder) = std::env::var_os("GOLDRAY_OUTPUTS") {
        for name in ["all.json", "all.xml", "all.md", "plan.json"] {
            let to = Path::new(&folder).join(name);
            fs::copy(tree.path("o").join(name), &to).unwrap();
        }
    }
}

#[test]
fn annotations_are_on_the_lines_that_failures_are_about() {
    let (tree, _) = every_verdict();
    let (printed, file) = checked(&tree);
    let errors: Vec<_> = printed.lines().filter(|line| line.starts_with("::error ")).collect();
    assert_eq!(errors.len(), 10, "{printed}");
    let on = |name: &str, line: u32, column: u32| {
        let start = format!("::error file={SUITE}/fixtures/{name}.ron,line={line},col={column},");
        let found = errors.iter().copied().find(|error| error.starts_with(&start));
        assert!(found.is_some(), "expected {start} in {errors:#?}");
        found.unwrap_or_default().to_owned()
    };
    let first = errors[0];
    assert!(first.contains("title=render refused%3A refused::"), "the worst first: {first}");
    on("refused", 4, 5);
    // The line after `check: (`, and the second relation in its list.
    on("area/expectation", 8, 18);
    on("area/relation", 7, 40);
    on("differs", 7, 15);
    let ugly = UGLY.replace('%', "%25").replace(',', "%2C").replace(':', "%3A");
    assert!(on(&ugly, 7, 15).contains("again: cargo xtask --root 'sub folder' check 'u<g>"));
    assert!(printed.contains("::notice title=goldray::2 more of the 12 failures"), "{printed}");

    let step = file("step.md");
    let page = file("o/all.md");
    // Times are of the same run.
    assert_eq!(step, format!("from before\n\n{page}"));
    for sign in ["<g>", "`@x`", "@x", "]]>"] {
        assert!(!page.contains(sign), "{sign} in {page}");
    }
}

#[test]
fn what_github_is_told_can_be_had_anywhere_and_left_out_elsewhere() {
    let tree = Tree::new(&[("a", SQUARE)]);
    let said = |args: &[&str], variables: &[(&str, &str)]| {
        tree.run_with(args, variables).expect_code(1).stdout().contains("::error file=")
    };
    assert!(!said(&["check"], &[]));
    assert!(!said(&["check"], &[("GITHUB_ACTIONS", "false")]));
    assert!(!said(&["check"], &[("GITHUB_STEP_SUMMARY", "step.md")]));
    assert!(!tree.path("step.md").exists());
    assert!(said(&["check", "--github"], &[]));
    assert!(said(&["check"], &[("GITHUB_ACTIONS", "true"), ("GITHUB_STEP_SUMMARY", "")]));
    assert!(said(&["check", "--github"], &[("GITHUB_STEP_SUMMARY", "step.md")]));
    let page = fs::read_to_string(tree.path("step.md")).unwrap();
    assert!(page.starts_with("\n### goldray: 1 of 1 do not match"), "{page}");
    // A full summary is one that nobody adds to.
    let full = vec![b'x'; (1 << 20) - 9];
    tree.write("step.md", &full);
    assert!(said(&["check", "--github"], &[("GITHUB_STEP_SUMMARY", "step.md")]));
    assert!(fs::read(tree.path("step.md")).unwrap() == full);
    tree.write("step.md", &[&full[..], &[b'x'; 10]].concat());
    let variables = [("GITHUB_STEP_SUMMARY", "step.md")];
    let ran = tree.run_with(&["check", "--github"], &variables).expect_code(1);
    ran.expect("the summary of this step could not be added to: step.md: is larger than");
    // A suite that is not in the repository is named in full.
    let variables = [("GITHUB_WORKSPACE", "fixtures"), ("GITHUB_ACTIONS", "true")];
    let whole = tree.path("").canonicalize().unwrap().join("fixtures/a.ron");
    let ran = tree.run_with(&["check"], &variables).expect_code(1);
    ran.expect(&format!("::error file={},line=1,", whole.display()));
    // Nor does anything go among fixtures and goldens.
    for flag in ["--junit", "--summary", "--json"] {
        let ran = tree.run(&["check", flag, "fixtures/a.ron"]).expect_code(2);
        ran.expect("expected a place outside of the suite's fixtures/");
    }
    for flag in ["--junit", "--json"] {
        let place = "target/goldray/report.html";
        tree.run(&["check", flag, place]).expect_code(2).expect("expected a place outside");
    }
    let twice = ["check", "--json", "o/a", "--junit", "o/../o/a"];
    tree.run(&twice).expect_code(2).expect("expected a file for each output");
}

#[test]
fn what_the_runner_names_changes_no_answer() {
    let tree = Tree::blessed(&[("a", SQUARE)]);
    for (name, value) in [
        ("GITHUB_STEP_SUMMARY", "golden/a.png"),
        ("GITHUB_STEP_SUMMARY", "fixtures"),
        ("GITHUB_STEP_SUMMARY", "/dev/null"),
        ("GITHUB_WORKSPACE", ""),
        ("GITHUB_WORKSPACE", "/there/is/none"),
    ] {
        let ran = tree.run_with(&["check", "--github"], &[(name, value)]).expect_code(0);
        ran.expect(if name == "GITHUB_WORKSPACE" { "1 match" } else { "could not be added to" });
    }
}

#[test]
fn nothing_of_a_fixture_is_taken_for_a_command() {
    let odd = "x\\u{1b}[41m\\n::error file=a::b.obj";
    let text = SQUARE.replace("objects: [", &format!("objects: [Mesh(file: \"{odd}\"), "));
    let tree = Tree::new(&[("a", &text)]);
    let printed = tree.run(&["check", "--github"]).expect_code(1).stdout();
    assert!(!printed.contains('\u{1b}'), "{printed:?}");
    let lines: Vec<_> = printed.lines().map(str::trim_start).collect();
    let commands: Vec<_> = lines.iter().filter(|line| line.starts_with("::")).collect();
    assert_eq!(commands.len(), 3, "{printed}");
    let word = commands[0].strip_prefix("::stop-commands::").unwrap();
    assert_eq!(*commands[1], &format!("::{word}::"), "as nobody could know before");
    assert!(commands[2].starts_with("::error file=fixtures/a.ron,line=7,"), "{printed}");
    assert!(!tree.run(&["check"]).expect_code(1).stdout().contains("::stop-commands::"));
}
