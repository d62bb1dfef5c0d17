//! `conform` with renderers that are right, and with renderers that are wrong on
//! purpose, each in one way: every one gets exactly its outcome, and none stalls
//! the run.
#![cfg(unix)]
#![allow(clippy::unwrap_used, clippy::panic, clippy::disallowed_methods)]

mod tree;

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::process::Stdio;
use std::time::{Duration, Instant};

use serde_json::Value;
use tree::{Ran, SQUARE, Tree};

/// A lit ball over a slope, in whose shadow a part of it lies: nothing is the same
/// upside down.
const BALL: &str = r"// A ball.
(
    version: 1,
    image: (16, 12),
    camera: LookAt(eye: (0, 1, 6), at: (0, 0, 0), fov_deg: 40),
    objects: [
        Sphere(center: (0.1, 0.2, 0), radius: 1.1),
        Plane(point: (0, -1, 0), normal: (0.1, 1, 0)),
    ],
    lights: [Point(position: (3, 4, 5))],
    background: (0.1, 0.2, 0.4),
    check: (expect: [Pixel(at: (0, 0), rgb: (90, 123, 168))]),
)";

/// A suite of three, with an adapter called `t` of a program that is a script. In
/// it, `$1` is goldray, `$2` the scene and `$3` the picture, as `$goldray`, `$scene` and `$out`.
fn suite(script: &str, more: &str) -> Tree {
    let tree = Tree::blessed(&[("a/square", SQUARE), ("ball", BALL), ("flat", &tree::flat())]);
    let script = format!("goldray=$1 scene=$2 out=$3\n{script}\n");
    tree.write("adapters/t/t.sh", script.as_bytes());
    let adapter = format!(
        "(name: \"T\", command: [\"sh\", \"{{folder}}/t.sh\", \"{{self}}\", \"{{scene}}\", \
         \"{{output}}\"], scene: Ron, {more})"
    );
    tree.write("adapters/t/adapter.ron", adapter.as_bytes());
    tree
}

const RIGHT: &str = "\"$goldray\" render \"$scene\" --out \"$out\"";

/// What came of each fixture, by name.
fn outcomes(tree: &Tree) -> BTreeMap<String, Value> {
    let text = fs::read(tree.path("target/goldray-conform/t/results.json")).unwrap();
    let run: Value = serde_json::from_slice(&text).unwrap();
    assert_eq!((&run["schema"], &run["renderer"]["id"]), (&Value::from(1), &Value::from("t")));
    let fixtures = run["fixtures"].as_object().unwrap();
    fixtures.iter().map(|(name, result)| (name.clone(), result.clone())).collect()
}

/// Runs the suite by a script, and holds the outcomes of `a/square`, `ball` and
/// `flat` against these; the findings of the last that is no pass must have this
/// in them.
#[track_caller]
fn check(script: &str, more: &str, expected: [&str; 3], finding: &str) -> (Tree, Ran) {
    let tree = suite(script, more);
    let ran = tree.run(&["conform", "--renderer", "t", "--timeout", "60"]);
    let found = outcomes(&tree);
    let names: Vec<_> = found.keys().map(String::as_str).collect();
    assert_eq!(names, ["a/square", "ball", "flat"]);
    let said: Vec<_> = found.values().map(|result| result["outcome"].as_str().unwrap()).collect();
    let (stdout, stderr) = (ran.stdout(), ran.stderr());
    assert_eq!(said, expected, "{stdout}{stderr}");
    let findings = found.values().rev().find(|result| result["outcome"] != "pass");
    let findings = findings.map_or(String::new(), |result| result["findings"].to_string());
    assert!(findings.contains(finding), "expected {finding:?} in {findings}");
    let is_fine = expected.iter().all(|outcome| matches!(*outcome, "pass" | "unsupported"));
    let ran = ran.expect_code(i32::from(!is_fine));
    (tree, ran)
}

#[test]
fn a_renderer_that_is_right_passes_everything() {
    let (_tree, ran) = check(RIGHT, "tolerance: 0, edges: 0", ["pass"; 3], "");
    ran.expect("T: 3 pass; worst interior error 0.00e0, 0 of ");
    // As 8-bit codes, with the curve that they have.
    let png = format!("{RIGHT}.png; mv \"$out.png\" \"$out\"");
    check(&png, "transfer: Gamma22", ["pass"; 3], "");
}

#[test]
fn goldray_in_another_process_agrees_with_itself() {
    let tree = suite("", "");
    let ran = tree.run(&["conform", "--renderer", "goldray", "--jobs", "3", "--json", "a.json"]);
    ran.expect_code(0).expect("goldray (goldray 0.1.0)").expect("goldray: 3 pass;");
    let all: Value = serde_json::from_slice(&fs::read(tree.path("a.json")).unwrap()).unwrap();
    assert_eq!(all[0]["fixtures"]["ball"]["outcome"], "pass");
    assert_eq!(all[0]["renderer"]["id"], "goldray");
}

#[test]
fn a_renderer_of_the_courses_xml_is_told_the_convention() {
    let lit = BALL.replace("background: (0.1, 0.2, 0.4)", "shading: Attenuated");
    let lit = lit.split("    check:").next().unwrap().to_owned() + ")";
    let tree = Tree::blessed(&[("ball", &lit)]);
    let script = "echo \"it is $1\" >&2; grep '^<!-- Shading: Attenuated -->$' \"$2\" >&2; exit 3";
    tree.write("adapters/t/t.sh", script.as_bytes());
    let adapter = "(name: \"T\", command: [\"sh\", \"{folder}/t.sh\", \"{shading}\", \"{scene}\"], \
                   scene: CornellXml)";
    tree.write("adapters/t/adapter.ron", adapter.as_bytes());
    let ran = tree.run(&["conform", "--renderer", "t"]);
    ran.expect_code(1).expect("it said: <!-- Shading: Attenuated -->");
    let printed = tree.path("target/goldray-conform/t/ball.files/printed.txt");
    assert!(fs::read_to_string(printed).unwrap().contains("it is attenuated\n"));
}

#[test]
fn jittered_pixel_centers_fail() {
    let jittered = format!("{RIGHT} --samples 1 --sampler stratified:7");
    let (_, ran) = check(&jittered, "", ["pass", "fail", "pass"], "interior pixels differ by more");
    ran.expect("by hand: cd ");
}

#[test]
fn a_missing_curve_fails_and_is_named() {
    let png = format!("{RIGHT}.png; mv \"$out.png\" \"$out\"");
    // White and black are the same by any curve.
    let (_, ran) = check(&png, "", ["pass", "fail", "pass"], "`transfer: Gamma22` in its adapter");
    ran.expect("fail        ball: ");
}

#[test]
fn rows_upside_down_fail_and_are_named() {
    let upright = ["pass", "fail", "fail"];
    check(RIGHT, "rows: BottomFirst", upright, "`rows: TopFirst` in its adapter");
}

#[test]
fn a_hanging_renderer_is_killed_with_its_children() {
    let script = "trap '' TERM\nsh -c 'trap \"\" TERM; echo $$ >> \"$0\"; sleep 1000' \
                  PIDS & echo $$ >> PIDS\nwait";
    let tree = suite("", "");
    let pids = tree.path("pids").display().to_string();
    tree.write("adapters/t/t.sh", script.replace("PIDS", &pids).as_bytes());
    let began = Instant::now();
    let ran = tree.run(&["conform", "--renderer", "t", "ball", "flat", "--timeout", "3"]);
    assert!(began.elapsed() < Duration::from_secs(100), "{:?}", began.elapsed());
    ran.expect_code(1).expect("timed out   ball: it was killed after 3 s").expect("2 timed out");
    let pids = fs::read_to_string(pids).unwrap();
    assert_eq!(pids.lines().count(), 4, "{pids}");
    pids.lines().for_each(is_gone);
}

/// Waits for the end of a process, which takes the system a moment.
#[track_caller]
fn is_gone(pid: &str) {
    for _ in 0..2_000 {
        let stat = fs::read_to_string(format!("/proc/{pid}/stat"));
        let runs = match stat {
            Ok(stat) => !stat.contains(") Z "),
            // Elsewhere than on Linux another program knows.
            Err(_) if Path::new("/proc/self").exists() => false,
            Err(_) => {
                let mut ps = std::process::Command::new("ps");
                ps.args(["-p", pid]).stdout(Stdio::null()).status().unwrap().success()
            }
        };
        if !runs {
            return;
        }
        std::thread::sleep(Duration::from_millis(5));
    }
    panic!("{pid} still runs");
}

#[test]
fn half_a_picture_garbage_and_nan_are_bad_pictures() {
    let bad = ["bad_picture"; 3];
    let half = format!("{RIGHT}.png; head -c 60 \"$out.png\" > \"$out\"");
    check(&half, "output: \"o.png\"", bad, "o.png: is not a readable PNG");
    check("printf 'no picture at all' > \"$out\"", "", bad, "out.exr: is neither a PNG nor");
    check(": > \"$out\"", "", bad, "is empty");
    let nan = "printf 'Pf\\n16 12\\n-1.0\\n' > \"$out\"; head -c 768 /dev/zero | tr '\\0' '\\377' >> \"$out\"";
    check(nan, "output: \"o.pfm\"", bad, "192 px that are no finite numbers, the first (0, 0)");
    let large = "printf 'P6 60000 60000 255\\n' > \"$out\"";
    check(large, "", bad, "60000 x 60000, more pixels");
}

#[test]
fn crashes_and_missing_pictures_have_their_names() {
    check("kill -SEGV $$", "", ["crashed"; 3], "signal: 11 (SIGSEGV)");
    let said = "it ended by exit status: 3; it said: out of teapots";
    check("echo out of teapots >&2; exit 3", "", ["crashed"; 3], said);
    check("echo done", "", ["no_picture"; 3], "but there is no out.exr; it said: done");
    check("mkdir \"$out\"", "", ["bad_picture"; 3], "out.exr: is no file");
    // A reason of the system's own is no part of the file's name.
    let looped = "ln -s \"$(basename \"$out\")\" \"$out\"";
    check(looped, "", ["bad_picture"; 3], "out.exr: Too many levels of symbolic links");
}

#[test]
fn another_size_is_said() {
    let small = "sed -i.old 's/(16, 12)/(8, 6)/; s/(16,12)/(8,6)/' \"$scene\"\n";
    let script = format!("{small}{RIGHT}");
    check(&script, "", ["wrong_size"; 3], "expected 16 x 12 pixels, found 8 x 6");
}

#[test]
fn a_gigabyte_of_words_stalls_nothing() {
    let loud = format!("head -c 1000000000 /dev/zero\n{RIGHT}");
    let tree = suite(&loud, "");
    let ran = tree.run(&["conform", "--renderer", "t", "flat", "--timeout", "300"]);
    ran.expect_code(0).expect("T: 1 pass;");
}

#[test]
fn what_is_not_supported_is_said_and_not_asked() {
    let declared = "unsupported: {Plane: \"it has none\"}";
    let (_, ran) = check(RIGHT, declared, ["pass", "unsupported", "pass"], "no Plane: it has none");
    ran.expect("unsupported ball: its adapter says that it has no Plane: it has none");
    // A scene of several samples is asked of those who take the same ones.
    let tree = suite(RIGHT, "same_samples: true, tolerance: 0");
    let four = BALL.replace("image", "samples_per_pixel: 4, image");
    tree.write("fixtures/ball.ron", four.as_bytes());
    tree.run(&["bless", "ball"]).expect_code(0);
    tree.run(&["conform", "--renderer", "t"]).expect_code(0).expect("3 pass;");
    let plain = fs::read_to_string(tree.path("adapters/t/adapter.ron")).unwrap();
    let plain = plain.replace("same_samples: true", "same_samples: false");
    tree.write("adapters/t/adapter.ron", plain.as_bytes());
    tree.run(&["conform", "--renderer", "t"]).expect_code(0).expect("2 pass, 1 unsupported;");
}

#[test]
fn a_failure_can_be_run_by_hand() {
    let loud = "env: {\"WORD\": \"very loud\"}";
    let (tree, ran) = check("echo $WORD; exit 1", loud, ["crashed"; 3], "exit status: 1");
    let stdout = ran.stdout();
    let line = stdout.lines().find_map(|line| line.trim().strip_prefix("by hand: ")).unwrap();
    let by_hand = std::process::Command::new("sh").args(["-c", line]).output().unwrap();
    assert_eq!(by_hand.stdout, b"very loud\n", "{line}");
    let kept = "target/goldray-conform/t/a/square.files";
    assert!(tree.path(&format!("{kept}/scene.ron")).exists());
    let printed = fs::read_to_string(tree.path(&format!("{kept}/printed.txt"))).unwrap();
    assert!(printed.contains("very loud"), "{printed}");
    // A check leaves that alone, and the next run takes it away.
    tree.run(&["check"]).expect_code(0);
    assert!(tree.path(kept).exists());
    tree.write("adapters/t/t.sh", format!("goldray=$1 scene=$2 out=$3\n{RIGHT}").as_bytes());
    tree.run(&["conform", "--renderer", "t"]).expect_code(0);
    assert!(!tree.path(kept).exists());
}

#[test]
fn a_wrong_picture_leaves_a_strip() {
    let jittered = format!("{RIGHT} --samples 1 --sampler stratified:7");
    let (tree, ran) = check(&jittered, "", ["pass", "fail", "pass"], "");
    // The line says what it is on, and where to look.
    let stdout = ran.stdout();
    let line = stdout.lines().find(|line| line.starts_with("fail        ball: ")).unwrap();
    let (what, strip) = line.rsplit_once(" | see ").unwrap();
    assert!(what.contains(" | the worst is on the Plane of fixtures/ball.ron:8:9"), "{line}");
    assert!(tree.path(strip).is_file(), "{line}");
    for file in ["ball.png", "ball.exr", "ball.files/out.exr", "ball.files/scene.ron"] {
        assert!(tree.path(&format!("target/goldray-conform/t/{file}")).exists(), "{file}");
    }
    assert!(!tree.path("target/goldray-conform/t/flat.png").exists());
}

#[test]
fn a_program_in_a_relative_folder_of_the_path_is_run() {
    let tree = suite("", "");
    let version = "[ \"$1\" = -v ] && echo 1.2 && exit";
    let script = format!("#!/bin/sh\n{version}\ngoldray=$1 scene=$2 out=$3\n{RIGHT}\n");
    tree.write("build/tracer", script.as_bytes());
    let mode = std::os::unix::fs::PermissionsExt::from_mode(0o755);
    fs::set_permissions(tree.path("build/tracer"), mode).unwrap();
    let adapter = "(name: \"T\", command: [\"tracer\", \"{self}\", \"{scene}\", \"{output}\"], \
                   version: [\"tracer\", \"-v\"], scene: Ron)";
    tree.write("adapters/t/adapter.ron", adapter.as_bytes());
    let path = format!("build:{}", std::env::var("PATH").unwrap());
    let ran = tree.run_with(&["conform", "--renderer", "t"], &[("PATH", &path)]);
    ran.expect_code(0).expect("T (1.2)").expect("T: 3 pass;");
}

#[test]
fn what_cannot_be_asked_is_said_at_once() {
    let tree = suite("exit 1", "");
    let ask = |adapter: &str| tree.run(&["conform", "--renderer", adapter]).expect_code(2);
    ask("goldary").expect("there is no adapter \"goldary\": did you mean \"goldray\"?");
    ask("./no/such.ron").expect("./no/such.ron: expected an adapter file, found no such file");
    let write = |text: &str| tree.write("adapters/u.ron", text.as_bytes());
    write(
        "(name: \"U\", command: [\"/no/such/tracer\", \"{scene}\"], help: \"build it\", scene: Ron)",
    );
    ask("u").expect("U cannot be asked: there is no program \"/no/such/tracer\" here; build it");
    write("(name: \"U\", command: [\"no-such-tracer\", \"{scene}\"], scene: Ron)");
    ask("u").expect("there is no program \"no-such-tracer\" here");
    write("(name: \"U\", command: [\"./u\", \"{scene}\"], scene: Ron)");
    ask("u").expect("write {folder}/... for what is beside the adapter file");
    write("(name: \"U\", command: [\"sh\", \"{scne}\"], scene: Ron)");
    ask("u").expect("adapters/u.ron:1:").expect("did you mean {scene}?");
    write("(name: \"U\", command: [\"sh\", \"{scene}\"], scene: Ron,\n colour: 1)");
    ask("u").expect("adapters/u.ron:2:2: unknown field `colour`");
    let version = "version: [\"sh\", \"-c\", \"echo not here >&2; exit 1\"]";
    write(&format!("(name: \"U\", command: [\"sh\", \"{{scene}}\"], scene: Ron, {version})"));
    ask("u").expect("failed: exit status: 1: not here");
    tree.run(&["conform", "--renderer", "t", "--renderer", "adapters/t"])
        .expect_code(2)
        .expect("found the id \"t\" twice");
    tree.run(&["conform", "--renderer", "t", "nothing-like-it"]).expect_code(2);
    tree.run(&["conform", "--renderer", "t", "--json", "golden/a.json"]).expect_code(2);
    tree.run(&["conform", "--renderer", "t", "--timeout", "0"]).expect_code(2);
    tree.run(&["conform"]).expect_code(2);
    // No renderer was run for any of these.
    assert!(!tree.path("target/goldray-conform/t/results.json").exists());
}

const RUBRIC: &str =
    "(version: 1, title: \"R\", parts: [(name: \"All\", points: 1, fixtures: [\"*\"])])";

#[test]
fn who_is_wrong_judges_nobody() {
    let tree = suite(RIGHT, "");
    fs::remove_file(tree.path("golden/ball.png")).unwrap();
    let ran = tree.run(&["conform", "--renderer", "t"]).expect_code(2);
    ran.expect("nobody is judged by fixtures that goldray does not match itself, and 1 of 3")
        .expect("ball: missing golden: there is no golden")
        .expect("1 of 3 is no match, so that nothing was run:\n")
        .expect("; what is right is accepted by: cargo xtask bless ball\n")
        .expect("\nor ask for the others: cargo xtask conform --renderer t 'a/*' flat\n");
    tree.write("rubric.ron", RUBRIC.as_bytes());
    let grade = tree.run(&["grade", "--renderer", "t", "--rubric", "rubric.ron"]);
    grade.expect_code(2).expect("cargo xtask bless ball\nor leave them out of rubric.ron\n");
    tree.run(&["conform", "--renderer", "t", "flat"]).expect_code(0);
}

#[test]
fn ctrl_c_ends_the_renderer_as_well() {
    let tree = suite("", "");
    let pid = tree.path("pid");
    let script = format!("echo $$ > {0}.new; mv {0}.new {0}; sleep 1000", pid.display());
    tree.write("adapters/t/t.sh", script.as_bytes());
    let mut command = tree.command(&["conform", "--renderer", "t"]);
    let mut child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    while !pid.exists() {
        assert!(child.try_wait().unwrap().is_none(), "it has ended");
        std::thread::sleep(Duration::from_millis(5));
    }
    let own = nix::unistd::Pid::from_raw(child.id().cast_signed());
    nix::sys::signal::kill(own, nix::sys::signal::Signal::SIGINT).unwrap();
    let ran = Ran(child.wait_with_output().unwrap()).expect_code(130);
    ran.expect("interrupted: T has not rendered everything");
    is_gone(fs::read_to_string(pid).unwrap().trim());
}

#[test]
fn a_card_of_a_part_of_the_suite_says_so() {
    let tree = suite(RIGHT, "");
    tree.run(&["conform", "--renderer", "t", "f*", "--out", "card"]).expect_code(0);
    let card = || -> Value {
        serde_json::from_slice(&fs::read(tree.path("card/scorecard.json")).unwrap()).unwrap()
    };
    let words = "Only a part of the suite was asked for: 1 of 3 fixtures, by the filter \"f*\"";
    assert_eq!(card()["selection"]["words"], words);
    // What selects everything is no part.
    tree.run(&["conform", "--renderer", "t", "*", "--out", "card"]).expect_code(0);
    assert_eq!(card()["selection"], Value::Null);
}
