//! The command as a whole, small, and what it writes.

use clap::Parser;

use super::*;

#[derive(Debug, Parser)]
struct Cli {
    #[command(flatten)]
    args: Args,
}

fn args(flags: &[&str]) -> Args {
    Cli::try_parse_from(["trace"].iter().chain(flags)).unwrap().args
}

#[test]
fn a_quick_run_needs_no_peers_and_finds_goldray_right() {
    let mut run =
        Run::new(&args(&["--quick", "--engines", "goldray-accurate,goldray-fast"])).unwrap();
    run.measure(&meshes::named(QUICK_SCENE).unwrap().unwrap()).unwrap();
    let json: serde_json::Value = serde_json::from_str(&run.report.json().unwrap()).unwrap();
    assert_eq!(json["schema"], 1);
    assert!(json["machine"]["cpu"].is_string());
    let rows = json["rows"].as_array().unwrap();
    assert_eq!(rows.len(), 2 * Kind::ALL.len());
    for row in rows {
        for (key, is_right) in [
            ("scene", row["scene"] == QUICK_SCENE),
            ("rays", row["rays"].is_string()),
            ("query", row["query"] == if row["rays"] == "shadow" { "any" } else { "closest" }),
            ("engine", row["engine"].as_str().unwrap().starts_with("goldray")),
            ("mrays_s", row["mrays_s"].as_f64().unwrap() > 0.0),
            ("spread", row["spread"][0].as_f64() <= row["mrays_s"].as_f64()),
            ("spread", row["spread"][1].as_f64() >= row["mrays_s"].as_f64()),
            ("wrong", row["engine"] != "goldray-accurate" || row["wrong"] == 0),
        ] {
            assert!(is_right, "{key}: {row}");
        }
    }
    let of_exact = |rows: &str| {
        let rows = json[rows].as_array().unwrap().clone();
        rows.into_iter().filter(|row| row["engine"] == "goldray-accurate").collect::<Vec<_>>()
    };
    let aimed = of_exact("aimed");
    assert_eq!(aimed.len(), 4, "from in and outside, at corners and edges");
    assert!(aimed.iter().all(|row| row["hit_or_miss"] == 0 && row["elsewhere"] == 0));
    assert_eq!(of_exact("builds").len(), 2, "with one thread and with two");
    assert!(run.report.checked.rays > 0);
    assert_eq!(run.report.checked.differ, 0);
    assert!(plot::svg(&run.report.rows).starts_with("<svg"));
}

#[test]
fn wrong_names_are_answered_with_the_right_ones() {
    let why = engine_names(&["embree4-avx2".into(), "embre".into()]).unwrap_err();
    assert!(why.starts_with("--engines: expected some of goldray-accurate, "), "{why}");
    assert!(why.ends_with("found `embre`"), "{why}");
    let asked = ["embree4-avx2".to_owned(), "goldray-fast".to_owned()];
    assert_eq!(engine_names(&asked).unwrap(), ["goldray-fast", "embree4-avx2"]);
    for flags in [&["--quick", "--size", "9"][..], &["--size", "7"], &["--reps", "0"]] {
        assert!(Cli::try_parse_from(["trace"].iter().chain(flags)).is_err(), "{flags:?}");
    }
}
