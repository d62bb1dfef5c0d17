//! The document of files that are there, missing, and of another form.

use serde_json::json;

use super::*;

fn files(of: &[(&str, Value)]) -> Vec<Option<Value>> {
    let find = |part: &Part| {
        of.iter().find(|(name, _)| *name == part.name).map(|(_, value)| value.clone())
    };
    PARTS.iter().map(find).collect()
}

/// No plot was drawn.
const NONE: [Option<String>; PARTS.len()] = [const { None }; PARTS.len()];

fn trace_file() -> Value {
    let row = |engine: &str, query: &str, rate: f64, wrong: u32| {
        json!({"scene": "bunny", "rays": "primary", "query": query, "engine": engine,
               "mrays_s": rate, "spread": [rate * 0.9, rate * 1.1], "wrong": wrong})
    };
    json!({
        "schema": 1,
        "machine": "a box of 2 threads",
        "rows": [
            row("goldray-accurate", "closest", 12.0, 0),
            row("goldray-accurate", "any", 8.0, 0),
            row("embree4-avx2", "closest", 10.0, 3),
            row("embree4-avx2", "any", 10.0, 0),
        ],
        "builds": [{"scene": "bunny", "engine": "embree4", "threads": 1, "ms": 20.5,
                    "bytes_per_triangle": 90}],
        "aimed": [{"scene": "bunny", "rays": "edges", "engine": "embree4", "wrong": 7, "of": 900}],
    })
}

#[test]
fn what_is_missing_is_said_not_to_be_measured() {
    let (text, plots) = document("performance", &Machine::here(), &files(&[]), &NONE);
    assert_eq!(text.matches("Not measured here: `cargo xtask bench ").count(), PARTS.len());
    assert!(plots.is_empty());
    for part in &PARTS {
        assert!(text.contains(part.heading), "{}", part.name);
    }
}

#[test]
fn rays_are_compared_engine_by_engine() {
    let (text, _) =
        document("performance", &Machine::here(), &files(&[("trace", trace_file())]), &NONE);
    assert!(text.contains("`cargo xtask bench trace` on a box of 2 threads."), "{text}");
    // The geometric mean of 1.2 and 0.8.
    let ratios = "| goldray-accurate / embree4-avx2 | 0.98 | 0.80 (bunny primary any) | 2 |";
    assert!(text.contains(ratios), "{text}");
    assert!(text.contains("| embree4-avx2 | 10.0 [9.00-11.0], 3 wrong |"), "{text}");
    assert!(text.contains("| bunny | embree4 | 1 | 20.5 | 90.0 |"), "{text}");
    assert!(text.contains("| bunny | edges | embree4 | 7 | 900 |"), "{text}");
    assert_eq!(text.matches("Not measured here").count(), PARTS.len() - 1);
}

#[test]
fn pictures_have_a_table_and_the_plot_that_was_drawn() {
    let reached = |engine: &str, rmse: f64, seconds: f64, how: &str| json!({"scene": "nine balls", "engine": engine, "rmse": rmse, "seconds": seconds, "how": how});
    let file = json!({"schema": 1, "scenes": [{"scene": "nine balls"}],
        "reached": [
            reached("goldray", 0.01, 0.02, "cheapest"),
            reached("goldray", 0.001, 0.25, "between"),
            reached("povray", 0.001, 3.0, "not within")],
        "ratios": [{"scene": "nine balls", "rmse": 0.001, "engine": "povray", "times": 12.0}]});
    let folder = tempfile::tempdir().unwrap();
    place::write(&folder.path().join("image.svg"), "<svg>nine</svg>").unwrap();
    let drawn = drawn(folder.path()).unwrap();
    let files = files(&[("image", file)]);
    let (text, plots) = document("performance", &Machine::here(), &files, &drawn);
    assert_eq!(plots, [("image.svg".to_owned(), "<svg>nine</svg>".to_owned())]);
    assert!(text.contains("![image](performance/image.svg)"), "{text}");
    assert!(text.contains("| nine balls: seconds to RMSE | 0.01 | 0.001 |"), "{text}");
    assert!(text.contains("| goldray | 0.02 | 0.25 |"), "{text}");
    assert!(text.contains("| povray | - | over 3.00, 12.0x |"), "{text}");
}

#[test]
fn skipping_is_added_up() {
    let row = |scene: &str, same: bool| json!({"scene": scene, "same_bits": same, "with": {"eye_rays": 25}, "without": {"eye_rays": 100}});
    let file = json!({"schema": 1, "rows": [row("a", true), row("b", false)]});
    let (text, _) = document("performance", &Machine::here(), &files(&[("skipping", file)]), &NONE);
    assert!(text.contains("| eye rays | 50 | 200 | 25 % |"), "{text}");
    assert!(text.contains("1 of 2 pictures") && text.contains("Other bits: b."), "{text}");
}

#[test]
fn a_file_of_another_form_makes_a_section_all_the_same() {
    let of_all: Vec<_> =
        PARTS.iter().map(|_| Some(json!({"rows": [{}], "scenes": [{}]}))).collect();
    let (text, _) = document("performance", &Machine::here(), &of_all, &NONE);
    assert_eq!(text.matches("is of another form than").count(), 3);
    assert!(!text.contains("Not measured"));
}

#[test]
fn a_folder_without_files_or_with_no_json_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let error = read(folder.path()).unwrap_err();
    assert!(error.contains("expected one at least of image.json, trace.json"), "{error}");
    place::write(&folder.path().join("trace.json"), "{").unwrap();
    assert!(read(folder.path()).unwrap_err().contains("trace.json: expected JSON"));
    place::write_json(&folder.path().join("trace.json"), &trace_file()).unwrap();
    assert_eq!(read(folder.path()).unwrap().iter().flatten().count(), 1);
}
