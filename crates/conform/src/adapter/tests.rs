//! Adapter files: what is read, and all that is said of a bad one.

use harness::store;

use super::*;

const SMALL: &str = r#"(name: "x", command: ["x", "{scene}"], scene: Ron)"#;

#[test]
fn a_small_file_has_the_defaults_of_the_documents() {
    let adapter = Adapter::read("a.ron", SMALL).unwrap();
    assert_eq!((adapter.output.as_str(), adapter.timeout.as_secs()), ("out.exr", 60));
    assert_eq!(adapter.meaning, Meaning::default());
    assert_eq!((adapter.tolerance, adapter.edges, adapter.edge_reach), (1e-5, 1.0, 1.0 / 64.0));
    assert!(!adapter.same_samples && adapter.unsupported.is_empty());
}

#[test]
fn all_fields_are_read() {
    let text = r#"(
        name: "x", command: ["x", "{scene}"], version: ["x", "-v"], help: "buy it",
        scene: PovRay, output: "a.png", transfer: Srgb, rounding: Down, rows: BottomFirst,
        timeout_s: 1.5, unsupported: {Torus: "no quartics", Depth: ""}, same_samples: true,
        tolerance: 1e-3, edges: 0.5, edge_reach: 0.1, env: {"A": "b"},
    )"#;
    let adapter = Adapter::read("a.ron", text).unwrap();
    let meaning =
        Meaning { transfer: Transfer::Srgb, rounding: Rounding::Down, rows: Rows::BottomFirst };
    assert_eq!(adapter.meaning, meaning);
    assert_eq!(adapter.timeout.as_millis(), 1_500);
    assert_eq!(adapter.unsupported[&Feature::Torus], "no quartics");
    assert_eq!(adapter.env["A"], "b");
}

#[track_caller]
fn refused(text: &str, expected: &[&str]) {
    let found = Adapter::read("a.ron", text).unwrap_err();
    for expected in expected {
        assert!(found.contains(expected), "expected {expected:?} in:\n{found}");
    }
    assert_eq!(found.matches("a.ron:").count(), expected.len(), "{found}");
}

#[test]
fn problems_are_told_together_with_their_places() {
    refused("", &["a.ron:1:1: "]);
    refused(
        "(name: \"x\",\n comand: [\"x\"],\n scene: Povray,\n transfer: Gamma,\n)",
        &["a.ron:2:2: ", "a.ron:3:9: ", "a.ron:4:12: "],
    );
    refused(
        &SMALL.replace("{scene}", "{scen}"),
        &["a.ron:1:28: nothing is called {scen}; did you mean {scene}?"],
    );
    refused(&SMALL.replace("{scene}", "a"), &["a.ron:1:22: expected a word with {scene}"]);
    refused(&SMALL.replace("\"x\", \"{scene}\"", ""), &["expected a program and its arguments"]);
    refused(&SMALL.replace("\"x\", \"{sc", "\"{width}\", \"{sc"), &["{width} is known only where"]);
    refused(&SMALL.replace("name: \"x\"", "name: \" \""), &["expected a name"]);
    let with = |more: &str| SMALL.replace("scene: Ron", &format!("scene: Ron, {more}"));
    refused(&with("output: \"../a.png\""), &["expected the name of a file"]);
    refused(&with("output: \"\""), &["expected the name of a file"]);
    refused(&with("version: [\"x\", \"{output}\"]"), &["{output} is known only where"]);
    refused(&with("version: [\"x\", \"{shading}\"]"), &["{shading} is known only where"]);
    refused(
        &with("timeout_s: 0, tolerance: 0.5, edges: -1, edge_reach: 1"),
        &["from 0.1 to 86400", "from 0 to 0.1", "from 0 to 1", "from 0.000001 to 0.1"],
    );
    refused(&with("tolerance: NaN"), &["from 0 to 0.1, found NaN"]);
    refused(&with("unsupported: {Torsu: \"\"}"), &["`Torus`"]);
    refused(&with("env: {\"A=B\": \"\"}"), &["expected the name of a variable"]);
}

#[test]
fn a_language_without_cameras_is_refused_with_another() {
    refused(
        &SMALL.replace("scene: Ron", "scene: Obj"),
        &["a.ron:1:47: expected a language with cameras and lights, found Obj"],
    );
    let why = Adapter::read("a.ron", &SMALL.replace("Ron", "Obj")).unwrap_err();
    assert!(why.contains("take `scene: Json`"), "{why}");
    for &dialect in Dialect::ALL.iter().filter(|&&dialect| dialect != Dialect::Obj) {
        Adapter::read("a.ron", &SMALL.replace("Ron", dialect.name())).unwrap();
    }
}

#[test]
fn what_no_program_is_started_with_is_refused_by_its_place() {
    let with = |more: &str| SMALL.replace("scene: Ron", &format!("scene: Ron,\n{more}"));
    let long = "a".repeat(30_000);
    refused(
        &SMALL.replace("{scene}", "{scene}\\u{0}"),
        &["a.ron:1:28: expected a word without zero"],
    );
    refused(&with("version: [\"x\",\n\"\\u{0}\"]"), &["a.ron:3:1: expected a word without zero"]);
    refused(
        &with("env: {\"A\": \"b\",\n\"B\": \"x\\u{0}y\"}"),
        &["a.ron:3:6: expected a value without zero bytes, found \"x\\u{0}y\""],
    );
    refused(
        &with("env: {\"A\\u{0}\": \"b\"}"),
        &["expected the name of a variable, found \"A\\u{0}\""],
    );
    let place = "expected a command of at most 24576 bytes, found 30008";
    refused(&SMALL.replace("\"{sc", &format!("\"{long}\", \"{{sc")), &[place]);
    let found = Adapter::read("a.ron", &with(&format!("env: {{\"A\": \"{long}\"}}"))).unwrap_err();
    assert!(found.starts_with("a.ron:2:6: expected variables of at most 24576 bytes"), "{found}");
    assert!(found.contains("put it into a script beside the adapter"), "{found}");
    refused(&with(&format!("output: \"{}\"", "o".repeat(256))), &["at most 255 bytes, found 256"]);
}

#[test]
fn what_is_built_in_is_good_and_is_what_the_folder_has() {
    for builtin in BUILTIN {
        Adapter::read(builtin.name, builtin.text).unwrap_or_else(|why| panic!("{why}"));
        let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../adapters");
        let folder = folder.join(builtin.name);
        let files = store::names(&folder, "ron").unwrap();
        assert_eq!(files, ["adapter"], "{}", builtin.name);
        for program in store::names(&folder, "py").unwrap() {
            let name = format!("{program}.py");
            let held = builtin.programs.iter().find(|(known, _)| *known == name);
            let (_, held) = held.unwrap_or_else(|| panic!("{name} is not built in"));
            assert_eq!(Some(held.to_vec()), store::read(&folder.join(&name), 1 << 20).unwrap());
        }
    }
}
