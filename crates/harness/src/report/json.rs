//! Outcomes as JSON, with a schema version that changes when a field does.

use serde_json::{Map, Value, json};

use super::text::summarize;
use crate::metric::{Comparison, DIFFERENCE_STEPS, METRICS};
use crate::verdict::{Outcome, Verdict};

/// The version of both documents below.
const SCHEMA: u32 = 1;

/// A run: `{"schema":1,"summary":{...},"fixtures":[...]}`.
///
/// `summary` has `total`, `green`, `elapsed_ms` and a count for each verdict,
/// zeros included. A fixture has `name`, `verdict`, `findings`, `width`,
/// `height`, `render_ms`, `compare_ms`, `relate_ms`, `strip`,
/// `breaks_expectations`, `breaks_relations`, `command` and every metric of
/// [`comparison_json`]; what there is not is null.
pub fn run_json(outcomes: &[Outcome], elapsed_ms: f64) -> Value {
    let summary = summarize(outcomes);
    let mut counts = Map::new();
    counts.insert("total".into(), json!(summary.total));
    counts.insert("green".into(), json!(summary.is_green()));
    counts.insert("elapsed_ms".into(), json!(elapsed_ms));
    for verdict in Verdict::ALL {
        let count = summary.counts.get(&verdict).copied().unwrap_or(0);
        counts.insert(verdict.id().into(), json!(count));
    }
    let fixtures: Vec<_> = outcomes.iter().map(fixture_json).collect();
    json!({ "schema": SCHEMA, "summary": counts, "fixtures": fixtures })
}

fn fixture_json(outcome: &Outcome) -> Value {
    let mut fixture = Map::new();
    let mut put = |key: &str, value: Value| fixture.insert(key.to_owned(), value);
    put("name", json!(outcome.name));
    put("verdict", json!(outcome.verdict.id()));
    put("findings", json!(outcome.findings));
    put("width", json!(outcome.size.map(|size| size.0)));
    put("height", json!(outcome.size.map(|size| size.1)));
    put("render_ms", json!(outcome.render_ms));
    put("compare_ms", json!(outcome.compare_ms));
    put("relate_ms", json!(outcome.relate_ms));
    put("strip", json!(outcome.strip));
    put("breaks_expectations", json!(outcome.breaks_expectations));
    put("breaks_relations", json!(outcome.breaks_relations));
    put("command", json!(outcome.remedy().map(|remedy| format!("cargo xtask {remedy}"))));
    fixture.extend(metrics(outcome.comparison.as_ref()));
    Value::Object(fixture)
}

/// A comparison: `{"schema":1, ...}` with every metric by name, where the worst
/// window and the first differing pixel are, and `pixels_over`, the count of
/// pixels that differ by more than each threshold.
pub fn comparison_json(comparison: &Comparison) -> Value {
    let mut document = Map::from_iter([("schema".to_owned(), json!(SCHEMA))]);
    document.extend(metrics(Some(comparison)));
    Value::Object(document)
}

/// Every metric; all null without a comparison, so that the keys are the same.
fn metrics(comparison: Option<&Comparison>) -> Map<String, Value> {
    let mut map = Map::new();
    for metric in METRICS {
        map.insert(metric.name.to_owned(), number(comparison.and_then(metric.value)));
    }
    let pixels_over = |c: &Comparison| {
        let steps = DIFFERENCE_STEPS.iter().zip(c.pixels_over);
        steps.map(|(step, count)| (step.to_string(), json!(count))).collect::<Map<_, _>>()
    };
    map.insert("ssim_min_at".into(), json!(comparison.map(|c| c.ssim_min_at)));
    map.insert("first_differing".into(), json!(comparison.and_then(|c| c.first_differing)));
    map.insert("pixels_over".into(), json!(comparison.map(pixels_over)));
    map
}

/// Whole numbers without a fraction, as counts should be.
fn number(value: Option<f64>) -> Value {
    match value {
        Some(v) if v.fract() == 0.0 && v.abs() < 1e15 => json!(v as i64),
        other => json!(other),
    }
}
