//! Tables of Markdown, and values of JSON whose form is not sure.

use serde_json::Value;

use crate::bars::short;

/// A table; columns whose first cell begins as a number does are set to the
/// right. Without rows there is none.
pub(super) fn table(heads: &[&str], rows: &[Vec<String>]) -> String {
    let Some(first) = rows.first() else { return String::new() };
    let mut text = format!("\n| {} |\n", heads.join(" | "));
    for cell in first {
        let is_number = cell == "-" || cell.starts_with(|c: char| c.is_ascii_digit());
        text.push_str(if is_number { "|--:" } else { "|---" });
    }
    text.push_str("|\n");
    for row in rows {
        let cells: Vec<_> = row.iter().map(|cell| cell.replace('|', "\\|")).collect();
        text.extend(["| ", &cells.join(" | "), " |\n"]);
    }
    text
}

/// The rows below a key; none if there is no such list.
pub(super) fn rows<'a>(value: &'a Value, key: &str) -> &'a [Value] {
    value.get(key).and_then(Value::as_array).map_or(&[], Vec::as_slice)
}

/// The text below a key; a dash if there is none.
pub(super) fn text(value: &Value, key: &str) -> String {
    match value.get(key) {
        Some(Value::String(text)) => text.clone(),
        Some(Value::Number(number)) => number.to_string(),
        Some(Value::Bool(is)) => if *is { "yes" } else { "no" }.to_owned(),
        _ => "-".to_owned(),
    }
}

/// The number below a key, also the median of a spread.
pub(super) fn number(value: &Value, key: &str) -> Option<f64> {
    let found = value.get(key)?;
    found.as_f64().or_else(|| found.get("median")?.as_f64())
}

/// A number in three digits, or a dash.
pub(super) fn shown(number: Option<f64>) -> String {
    /// Below this, three digits need an exponent.
    const SMALL: f64 = 0.01;
    match number {
        Some(x) if x != 0.0 && x.abs() < SMALL => format!("{x:.1e}"),
        Some(x) => short(x),
        None => "-".to_owned(),
    }
}

/// The lowest and highest of a `spread`, which may be a pair or an object, or a
/// number that is a share; empty if it is not there.
pub(super) fn spread(value: &Value) -> String {
    let ends = match value {
        Value::Array(ends) if ends.len() == 2 => (ends[0].as_f64(), ends[1].as_f64()),
        Value::Object(fields) => {
            let end = |keys: [&str; 3]| keys.iter().find_map(|key| fields.get(*key)?.as_f64());
            (end(["low", "min", "lo"]), end(["high", "max", "hi"]))
        }
        Value::Number(share) => {
            return share.as_f64().map_or(String::new(), |s| format!(" (±{s:.2})"));
        }
        _ => return String::new(),
    };
    match ends {
        (Some(low), Some(high)) => format!(" [{}-{}]", shown(Some(low)), shown(Some(high))),
        _ => String::new(),
    }
}

/// What a file says of its machine, on one line.
pub(super) fn machine(file: &Value) -> Option<String> {
    let machine = file.get("machine")?;
    if let Ok(known) = serde_json::from_value::<crate::machine::Machine>(machine.clone()) {
        return Some(known.sentence());
    }
    match machine {
        Value::String(text) => Some(text.clone()),
        Value::Object(fields) => {
            let word = |value: &Value| match value {
                Value::String(text) => text.clone(),
                Value::Array(all) => {
                    let words: Vec<_> = all.iter().filter_map(Value::as_str).collect();
                    words.join(", ")
                }
                other => other.to_string(),
            };
            let parts: Vec<_> =
                fields.iter().map(|(key, value)| format!("{key} {}", word(value))).collect();
            Some(parts.join("; "))
        }
        _ => None,
    }
}

/// The values under a key, each once, in the order in which they come.
pub(super) fn distinct(rows: &[Value], key: &str) -> Vec<String> {
    let mut all = Vec::new();
    for row in rows {
        let value = text(row, key);
        if !all.contains(&value) {
            all.push(value);
        }
    }
    all
}

/// The geometric mean; `None` of none, and of what is not above 0.
pub(super) fn geometric_mean(values: &[f64]) -> Option<f64> {
    let usable = !values.is_empty() && values.iter().all(|&v| v > 0.0 && v.is_finite());
    let logs: f64 = values.iter().map(|v| v.ln()).sum();
    usable.then(|| (logs / values.len() as f64).exp())
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    #[test]
    fn values_of_any_form_are_shown() {
        let value = json!({"a": 1.5, "b": {"median": 2.0, "low": 1.0, "high": 3.0}, "c": "word"});
        assert_eq!((number(&value, "a"), number(&value, "b")), (Some(1.5), Some(2.0)));
        assert_eq!((number(&value, "c"), number(&value, "d")), (None, None));
        assert_eq!((text(&value, "c"), text(&value, "d")), ("word".into(), "-".into()));
        assert_eq!(spread(&value["b"]), " [1.00-3.00]");
        assert_eq!(spread(&json!([0.5, 20.0])), " [0.50-20.0]");
        assert_eq!(spread(&json!(null)), "");
        assert_eq!(
            [Some(0.001), Some(0.0), Some(120.4), None].map(shown),
            ["1.0e-3", "0.00", "120", "-"]
        );
    }

    #[test]
    fn machines_of_any_form_are_named() {
        let named = |machine: Value| super::machine(&json!({ "machine": machine }));
        assert_eq!(named(json!("a box")), Some("a box".into()));
        assert_eq!(
            named(json!({"cpu": "x", "flags": ["a", "b"]})),
            Some("cpu x; flags a, b".into())
        );
        assert_eq!(super::machine(&json!({})), None);
    }

    #[test]
    fn means_of_ratios() {
        let mean = geometric_mean(&[0.5, 2.0, 8.0]).unwrap();
        assert!((mean - 2.0).abs() < 1e-12);
        assert_eq!((geometric_mean(&[]), geometric_mean(&[1.0, 0.0])), (None, None));
    }

    #[test]
    fn a_table_keeps_its_columns() {
        let text = table(&["a", "b", "c"], &[vec!["x|y".into(), "1 [0-2]".into(), "z".into()]]);
        assert_eq!(text, "\n| a | b | c |\n|---|--:|---|\n| x\\|y | 1 [0-2] | z |\n");
        assert_eq!(table(&["a"], &[]), "");
    }
}
