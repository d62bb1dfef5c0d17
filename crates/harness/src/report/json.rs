//! Outcomes as JSON, with a schema version that changes when a field does.

use serde_json::{Map, Value, json};

use super::summary::summarize;
use crate::blame::Blamed;
use crate::called;
use crate::metric::{Comparison, DIFFERENCE_STEPS, METRICS, Metric};
use crate::verdict::{Origin, Outcome, Verdict};

/// The version of both documents below.
const SCHEMA: u32 = 1;

/// A run: `{"schema":1,"summary":{...},"fixtures":[...]}`, by the schema
/// `docs/schemas/check.schema.json`, to which `.ci/outputs` holds it.
///
/// `summary` has `total`, `green`, `elapsed_ms`, a count for each verdict, zeros
/// included, and `unchanged` (since their last match), `audited` (of those,
/// rendered all the same), `belied` (of those, no match). A fixture has `name`,
/// `verdict`, `findings`, `width`, `height`, `render_ms`, `compare_ms`,
/// `relate_ms`, `strip`, `breaks_expectations`, `breaks_relations`, `line` and
/// `column` (where in the fixture's file to look first), `blamed`,
/// `command`, `cached` (not rendered, as nothing changed since its last match:
/// it has no numbers), `audited` and every metric of [`comparison_json`]; what
/// there is not is null. `blamed` has, the most blamed first, `object` (its
/// number), `kind`, `line` and `column`, all null for the background, with
/// `pixels` and `share`.
pub fn run_json(outcomes: &[Outcome], elapsed_ms: f64) -> Value {
    let fixtures: Vec<_> = outcomes.iter().map(|o| Value::Object(fixture_json(o))).collect();
    let summary = summary_json(outcomes, elapsed_ms);
    json!({ "schema": SCHEMA, "summary": summary, "fixtures": fixtures })
}

/// How many of each verdict, as in a run.
pub(super) fn summary_json(outcomes: &[Outcome], elapsed_ms: f64) -> Value {
    let summary = summarize(outcomes);
    let mut counts = Map::new();
    counts.insert("total".into(), json!(summary.total));
    counts.insert("green".into(), json!(summary.is_green()));
    counts.insert("elapsed_ms".into(), json!(elapsed_ms));
    for verdict in Verdict::ALL {
        let count = summary.counts.get(&verdict).copied().unwrap_or(0);
        counts.insert(verdict.id().into(), json!(count));
    }
    counts.insert("unchanged".into(), json!(summary.unchanged));
    counts.insert("audited".into(), json!(summary.audited));
    counts.insert("belied".into(), json!(summary.belied));
    Value::Object(counts)
}

/// What is said of a fixture, as in a run.
pub(super) fn fixture_json(outcome: &Outcome) -> Map<String, Value> {
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
    put("line", json!(outcome.place.map(|place| place.0)));
    put("column", json!(outcome.place.map(|place| place.1)));
    put("blamed", blamed(&outcome.blamed));
    put("command", json!(outcome.remedy().map(|remedy| format!("{} {remedy}", called::command()))));
    put("cached", json!(outcome.origin == Origin::Unchanged));
    put("audited", json!(matches!(outcome.origin, Origin::Audited | Origin::Belied)));
    fixture.extend(metrics(outcome.comparison.as_ref()));
    fixture
}

/// What each metric is: `name`, `measures`, `range`, `unit`, `direction`,
/// `limit` (null where it is reported only) and `blind_spot`.
pub fn metrics_json() -> Value {
    let metric = |metric: &Metric| {
        json!({
            "name": metric.name, "measures": metric.measures, "range": metric.range,
            "unit": metric.unit, "direction": metric.direction.words(), "limit": metric.limit,
            "blind_spot": metric.blind_spot,
        })
    };
    METRICS.iter().map(metric).collect()
}

/// What a difference lies on, as in a run.
pub(crate) fn blamed(all: &[Blamed]) -> Value {
    all.iter().map(blamed_json).collect()
}

fn blamed_json(blamed: &Blamed) -> Value {
    let object = blamed.object.as_ref();
    json!({
        "object": object.map(|(number, _)| number),
        "kind": object.map(|(_, place)| &place.kind),
        "line": object.map(|(_, place)| place.line),
        "column": object.map(|(_, place)| place.column),
        "pixels": blamed.pixels,
        "share": blamed.share,
    })
}

/// A comparison: `{"schema":1, ...}` with every metric by name, where the worst
/// window, the worst pixel of FLIP and the first differing pixel are, and `pixels_over`, the count of
/// pixels that differ by more than each threshold.
pub fn comparison_json(comparison: &Comparison) -> Value {
    let mut document = Map::from_iter([("schema".to_owned(), json!(SCHEMA))]);
    document.extend(metrics(Some(comparison)));
    Value::Object(document)
}

/// Every metric of a comparison by name, with what else it knows.
pub(crate) fn distances(comparison: &Comparison) -> Map<String, Value> {
    metrics(Some(comparison))
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
    map.insert("flip_max_at".into(), json!(comparison.map(|c| c.flip_max_at)));
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
