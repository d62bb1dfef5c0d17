//! What is in the page, and that nothing in it breaks out of its place.

use super::*;
use serde_json::Value;

/// The JSON of an element.
#[track_caller]
fn data(page: &str, id: &str) -> Value {
    let start = format!("<script type=\"application/json\" id=\"{id}\">");
    let (_, rest) = page.split_once(&start).unwrap_or_else(|| panic!("no {id}"));
    serde_json::from_str(rest.split_once("</script>").unwrap().0).unwrap()
}

const SCENE: &str = r#"(version: 1, image: (8, 6), show: Silhouette, encoding: Srgb,
    camera: Parallel(view_point: (0, 0, 5), view_width: 8, view_height: 6),
    objects: [Box(min: (-2, -2, 0), max: (2, 2, 0))],
    check: (limits: (ssim: 0.5, ssim_worst: 0.2, max_abs: 9, reason: "</script><!--")))"#;

/// A suite of one fixture whose golden is not its picture.
fn broken_suite() -> (tempfile::TempDir, Suite) {
    let folder = tempfile::tempdir().unwrap();
    let root = folder.path();
    crate::store::write(&root.join("fixtures/a b.ron"), SCENE.as_bytes()).unwrap();
    let suite = Suite::open(root).unwrap();
    let all = suite.select(&[]).unwrap();
    crate::bless::bless(&suite, &all, false).unwrap();
    let picture =
        crate::encode::EncodedImage::from_fn(tracer::Size { width: 8, height: 6 }, |x, _| {
            [x as u8, 0, 0]
        });
    let png = crate::golden::to_png(&picture, None).unwrap();
    crate::store::write(&suite.golden_path("a b"), &png).unwrap();
    (folder, suite)
}

fn page_of(suite: &Suite) -> String {
    let outcomes = crate::run::run(suite, &suite.select(&[]).unwrap(), &|_| ()).unwrap();
    let reader = Reader { path_prefix: "s/".into(), root_flag: " --root s".into() };
    html(suite, &outcomes, 1.5, Kind::Report, &reader)
}

#[test]
fn a_failure_is_shown_with_everything() {
    let (_folder, suite) = broken_suite();
    let page = page_of(&suite);
    assert!(page.contains("<title>goldray: 1 of 1 do not match</title>"), "{page:.300}");
    let report = data(&page, "report");
    assert_eq!(report["kind"], "report");
    assert_eq!(report["summary"]["differs"], 1);
    let entry = &report["fixtures"][0];
    assert_eq!(entry["name"], "a b");
    assert_eq!(entry["path"], "s/fixtures/a b.ron");
    assert_eq!(entry["rerun"], "cargo xtask --root s check 'a b'");
    assert_eq!(entry["command"], "cargo xtask --root s bless 'a b'");
    assert_eq!(entry["transfer"], "srgb");
    let limits = entry["limits"].as_array().unwrap();
    let names: Vec<_> = limits.iter().map(|row| row["limit"].as_str().unwrap()).collect();
    assert_eq!(names, ["ssim", "ssim_worst", "max_abs"]);
    assert!(limits.iter().all(|row| row["broken"] == true), "{limits:?}");
    assert_eq!(limits[2]["found"], 255.0);
    let pictures = data(&page, "fixture-0");
    assert_eq!(pictures["source"], SCENE);
    for key in ["golden", "actual", "ssim", "flip", "linear"] {
        assert!(pictures[key].is_string(), "{key}");
    }
    assert_eq!(pictures["objects"]["places"][0]["kind"], "Box");
    assert_eq!(pictures["objects"]["places"][0]["line"], 3);
}

#[test]
fn pictures_are_those_of_the_run() {
    use base64::Engine as _;
    use std::io::Read as _;
    let (_folder, suite) = broken_suite();
    let pictures = data(&page_of(&suite), "fixture-0");
    let bytes = |value: &Value| {
        let text = value.as_str().unwrap();
        base64::engine::general_purpose::STANDARD.decode(text).unwrap()
    };
    let inflate = |value: &Value| {
        let mut all = Vec::new();
        flate2::read::ZlibDecoder::new(&bytes(value)[..]).read_to_end(&mut all).unwrap();
        all.as_chunks::<4>().0.to_vec()
    };
    let (_, rendered) = crate::run::render_fixture(&suite, "a b").unwrap();
    let actual = crate::golden::from_png(&bytes(&pictures["actual"])).unwrap().picture;
    assert_eq!(actual, rendered.encoded);
    let linear: Vec<_> = inflate(&pictures["linear"]).into_iter().map(f32::from_le_bytes).collect();
    let expected = rendered.linear.pixels().iter().flat_map(|p| [p.r, p.g, p.b]);
    assert_eq!(linear, expected.map(|v| v as f32).collect::<Vec<_>>());
    let numbers = inflate(&pictures["objects"]["numbers"]);
    let seen: Vec<_> = numbers.into_iter().map(u32::from_le_bytes).collect();
    let expected = rendered.encoded.pixels().iter().map(|p| u32::from(p[0] > 0));
    assert_eq!(seen, expected.collect::<Vec<_>>(), "the box is white, and nothing else is seen");
    let golden = crate::golden::from_png(&bytes(&pictures["golden"])).unwrap().picture;
    let pair = crate::metric::Pair::new(&golden, &actual).unwrap();
    let check = |key: &str, values: &[f64]| {
        let map = crate::golden::from_png(&bytes(&pictures[key])).unwrap().picture;
        let expected = values.iter().map(|v| (v.clamp(0.0, 1.0) * 255.0).round() as u8);
        assert_eq!(
            map.pixels().iter().map(|p| p[0]).collect::<Vec<_>>(),
            expected.collect::<Vec<_>>()
        );
    };
    check("ssim", &crate::metric::ssim_map(&pair).scores);
    check("flip", &crate::metric::flip_map(&pair).errors);
}

#[test]
fn nothing_ends_its_element_early() {
    let (_folder, suite) = broken_suite();
    let page = page_of(&suite);
    assert_eq!(page.matches("<script type=\"application/json\"").count(), 2);
    let after = page.split_once("<script type=").unwrap().1;
    assert!(!after.contains("<!--"), "a comment would swallow what follows");
    let odd = ["</script>", "<!--DATA-->", "/*SCRIPT*/", "\u{2028}", "\\u003c", "\"<\""];
    for text in odd {
        let mut data_elements = String::new();
        put(&mut data_elements, "x", &json!({ text: text }));
        let page = fill(PAGE, "t", STYLES, &data_elements, SCRIPTS);
        assert_eq!(data(&page, "x"), json!({ text: text }));
        assert!(page.contains("use strict"), "the script is in its place");
    }
}

#[test]
fn a_match_and_what_cannot_be_read_are_shown_too() {
    let folder = tempfile::tempdir().unwrap();
    crate::store::write(&folder.path().join("fixtures/good.ron"), SCENE.as_bytes()).unwrap();
    let suite = Suite::open(folder.path()).unwrap();
    crate::bless::bless(&suite, &suite.select(&[]).unwrap(), false).unwrap();
    crate::store::write(&folder.path().join("fixtures/odd.ron"), b"(version: \xff").unwrap();
    crate::store::write(&folder.path().join("golden/orphan.png"), b"no picture").unwrap();
    let page = page_of(&suite);
    let report = data(&page, "report");
    let verdicts = report["fixtures"].as_array().unwrap().iter().map(|f| f["verdict"].clone());
    assert_eq!(verdicts.collect::<Vec<_>>(), ["match", "render_refused", "orphan_golden"]);
    assert_eq!(report["fixtures"][0]["limits"][0]["broken"], false);
    assert_eq!(report["fixtures"][1]["limits"], Value::Null);
    assert_eq!(data(&page, "fixture-0")["actual"], Value::Null);
    assert!(data(&page, "fixture-0")["golden"].is_string());
    assert_eq!(data(&page, "fixture-1")["source"], "(version: \u{fffd}");
    assert_eq!(data(&page, "fixture-2")["source"], Value::Null);
}
