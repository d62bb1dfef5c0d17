//! What the page has of a fixture: its entry in the overview, and its pictures.

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD as BASE64;
use scene::{Encoding, MAX_SCENE_BYTES};
use serde_json::{Map, Value, json};

use super::super::json::fixture_json;
use super::super::text::{Reader, command, rerun};
use crate::check::{Check, File};
use crate::evidence::{Evidence, ObjectMap};
use crate::limits::{Bound, Limits};
use crate::metric::{Comparison, Direction};
use crate::run::read_golden;
use crate::store;
use crate::suite::Suite;
use crate::verdict::Outcome;

/// The largest golden that is put into the page, in bytes: 64 MiB.
const MAX_GOLDEN_BYTES: usize = 64 << 20;

/// What the page has of a fixture, or of a golden without one.
pub(super) struct Shown {
    /// What a run's JSON has of it, and more.
    ///
    /// `rank` is its place among the failures, 0 for the worst, null for a match;
    /// `path` is that of its file, as the reader finds it; `rerun` the command
    /// that checks it again; `transfer` the curve from linear values to codes,
    /// null where the file cannot be read; `has_golden` and `has_actual` say
    /// which pictures there are; `limits` what the fixture allows, empty where
    /// the pictures must be identical: `limit`, `metric`, `at_least` or at most,
    /// `accepted`, `found` (null where nothing was compared) and `broken`.
    pub(super) entry: Value,
    /// `source`, the text of its file; `golden` and `actual`, PNG files in
    /// base64, the latter null where it is the golden; `ssim` and `flip`, the
    /// maps of [`Maps`](crate::evidence::Maps); `linear` and `objects`, the
    /// values of [`Evidence`] in base64, `objects` with `kind`, `line` and
    /// `column` of each in `places`. What there is not is null.
    pub(super) pictures: Value,
}

/// What the page has of an outcome; without its linear values unless they fit.
pub(super) fn shown(suite: &Suite, outcome: &Outcome, has_linear: bool, reader: &Reader) -> Shown {
    let name = outcome.name.as_str();
    let source = store::read(&suite.fixture_path(name), MAX_SCENE_BYTES as u64).ok().flatten();
    let source = source.map(|bytes| String::from_utf8_lossy(&bytes).into_owned());
    let golden = read_golden(&suite.golden_path(name)).ok().flatten();
    let golden = golden.filter(|golden| golden.len() <= MAX_GOLDEN_BYTES);
    let evidence = outcome.evidence.as_deref();
    let file = source.as_deref().and_then(scene::parse::<Check>);
    let more = json!({
        "path": format!("{}{}", reader.path_prefix, Suite::fixture_label(name)),
        "rerun": rerun(name, reader),
        "transfer": file.as_ref().map(transfer),
        "has_golden": golden.is_some(),
        "has_actual": evidence.is_some(),
        "limits": file.as_ref().map_or(Value::Null, |file| limits(file, outcome)),
    });
    let mut entry = fixture_json(outcome);
    entry.extend(more.as_object().cloned().unwrap_or_default());
    entry.insert("command".to_owned(), json!(command(outcome, reader)));
    let mut pictures = Map::new();
    pictures.insert("source".to_owned(), json!(source));
    pictures.insert("golden".to_owned(), json!(golden.map(|png| BASE64.encode(png))));
    pictures.extend(evidence_json(evidence, has_linear));
    Shown { entry: Value::Object(entry), pictures: Value::Object(pictures) }
}

fn transfer(file: &File) -> &'static str {
    match file.encoding {
        Encoding::Gamma22 => "gamma22",
        Encoding::Srgb => "srgb",
    }
}

fn limits(file: &File, outcome: &Outcome) -> Value {
    let limits = file.check.as_ref().and_then(|check| check.limits.as_ref());
    let bounds = limits.map(Limits::bounds).unwrap_or_default();
    let compared = outcome.comparison.as_ref();
    let found = |bound: &Bound, c: &Comparison| Some(bound.found(c)).filter(|f| f.is_finite());
    let row = |bound: &Bound| {
        json!({
            "limit": bound.limit,
            "metric": bound.metric,
            "at_least": bound.direction == Direction::HigherIsBetter,
            "accepted": bound.accepted,
            "found": compared.and_then(|c| found(bound, c)),
            "broken": compared.is_some_and(|c| !c.is_identical() && !bound.holds(c)),
        })
    };
    bounds.iter().map(row).collect()
}

fn evidence_json(evidence: Option<&Evidence>, has_linear: bool) -> Map<String, Value> {
    let maps = evidence.and_then(|evidence| evidence.maps.as_ref());
    let base64 = |bytes: &Vec<u8>| BASE64.encode(bytes);
    let linear = evidence.filter(|_| has_linear).and_then(|e| e.linear.as_ref()).map(base64);
    let values = [
        ("actual", json!(evidence.map(|evidence| base64(&evidence.actual)))),
        ("ssim", json!(maps.map(|maps| base64(&maps.ssim)))),
        ("flip", json!(maps.map(|maps| base64(&maps.flip)))),
        ("linear", json!(linear)),
        ("objects", json!(evidence.map(|evidence| objects(&evidence.objects)))),
    ];
    values.into_iter().map(|(key, value)| (key.to_owned(), value)).collect()
}

fn objects(map: &ObjectMap) -> Value {
    let place = |p: &scene::Place| json!({ "kind": p.kind, "line": p.line, "column": p.column });
    let places: Vec<_> = map.places.iter().map(place).collect();
    json!({ "places": places, "numbers": BASE64.encode(&map.numbers) })
}
