//! What was measured, for people and for machines.

use std::fmt::Write as _;

use serde_json::{Value, json};

use super::{Cell, DEFECTS, Miss, OfDefect, Place, Row, Smallest, Summary, Visible};

/// A line for each fixture: the defect that it lets pass the most of.
pub fn fixture_lines(rows: &[Row]) -> String {
    let mut text = format!(
        "{:<36} {:<12} {:>16} {:>18}\n",
        "fixture", "weakest", "caught from", "times what is seen"
    );
    for row in rows {
        let Some(i) = row.weakest() else {
            let _ = writeln!(text, "{:<36} no defect has an effect", row.fixture);
            continue;
        };
        let cell = &row.cells[i];
        let (defect, strength) = (cell.defect.name, strength_words(cell));
        let times = times_words(cell.times_visible);
        let _ = writeln!(text, "{:<36} {defect:<12} {strength:>16} {times:>18}", row.fixture);
    }
    text
}

/// A line for each defect, and which fixture is the weakest.
pub fn summary_lines(summary: &Summary<'_>, visible: &Visible) -> String {
    let mut text = String::new();
    for (i, of) in summary.defects.iter().enumerate() {
        let [seen, median, worst] = numbers(i, of, visible);
        let name = of.defect.name;
        let worst = match worst_in(i, of) {
            Some(fixture) => format!("{worst} in the worst, {fixture}"),
            None => "and in none worse".to_owned(),
        };
        let counts = counts(of);
        let _ = writeln!(
            text,
            "{name:<12} seen from {seen}, caught from {median} in the median, {worst}{counts}"
        );
    }
    text + &weakest_line(summary) + "\n"
}

/// The same as a table of Markdown.
pub fn markdown(rows: &[Row], summary: &Summary<'_>, visible: &Visible) -> String {
    let mut text = "| defect | what it does | seen from | median | worst | in |\n".to_owned();
    text += "|---|---|--:|--:|--:|---|\n";
    for (i, of) in summary.defects.iter().enumerate() {
        let [seen, median, worst] = numbers(i, of, visible);
        let (name, does) = (of.defect.name, of.defect.does);
        let worst_in = worst_in(i, of).map_or("-".to_owned(), |name| format!("`{name}`"));
        let _ = writeln!(text, "| `{name}` | {does} | {seen} | {median} | {worst} | {worst_in} |");
    }
    let missed = rows.iter().filter(|row| row.cells.iter().any(|cell| cell.missed.is_some()));
    let _ = write!(
        text,
        "\n{} fixtures, of which {} let a defect pass that is seen.\n{}\n",
        rows.len(),
        missed.count(),
        weakest_line(summary)
    );
    text
}

/// Everything, for machines.
pub fn json(rows: &[Row], summary: &Summary<'_>, visible: &Visible) -> Value {
    let weakest = summary
        .weakest
        .map(|(row, i)| json!({ "fixture": row.fixture, "defect": DEFECTS[i].name }));
    let defects = summary.defects.iter().enumerate().map(|(i, of)| {
        let at = |row: Option<&Row>| row.map(|row| cell_json(&row.fixture, &row.cells[i]));
        json!({
            "defect": of.defect.name,
            "does": of.defect.does,
            "unit": of.defect.unit,
            "visible": visible.strength(of.defect),
            "median": at(of.median),
            "worst": at(of.worst),
            "never": of.never,
            "no_effect": of.no_effect,
        })
    });
    let cells = rows.iter().flat_map(|row| row.cells.iter().map(|c| cell_json(&row.fixture, c)));
    json!({
        "schema": 1,
        "visible_change": visible.change(),
        "weakest": weakest,
        "defects": defects.collect::<Vec<_>>(),
        "fixtures": cells.collect::<Vec<_>>(),
    })
}

fn cell_json(fixture: &str, cell: &Cell) -> Value {
    let (answer, strength, place) = match cell.smallest {
        Smallest::NoEffect => ("no_effect", None, None),
        Smallest::Caught { strength, place } => ("caught", Some(strength), Some(place)),
        Smallest::Never { place } => ("never", None, Some(place)),
    };
    let missed = cell.missed.map(|Miss { strength, place, change }| {
        json!({ "strength": strength, "place": place.to_string(), "change": change })
    });
    json!({
        "fixture": fixture,
        "defect": cell.defect.name,
        "answer": answer,
        "strength": strength,
        "place": place.as_ref().map(Place::to_string),
        "times_visible": cell.times_visible.filter(|times| times.is_finite()),
        "missed": missed,
    })
}

/// Seen from, median, worst.
fn numbers(i: usize, of: &OfDefect<'_>, visible: &Visible) -> [String; 3] {
    let words = |row: Option<&Row>| row.map_or("-".to_owned(), |row| strength_words(&row.cells[i]));
    let seen = with_unit(visible.strength(of.defect), of.defect.unit);
    [seen, words(of.median), words(of.worst)]
}

/// The fixture of the worst, where it is worse than the one in the middle.
fn worst_in<'a>(i: usize, of: &OfDefect<'a>) -> Option<&'a str> {
    let times = |row: Option<&Row>| row.and_then(|row| row.cells[i].times_visible);
    (times(of.worst) != times(of.median)).then(|| of.worst.map(|row| row.fixture.as_str()))?
}

fn counts(of: &OfDefect<'_>) -> String {
    let mut text = String::new();
    for (count, words) in [(of.never, "never caught in"), (of.no_effect, "no effect in")] {
        if count > 0 {
            let _ = write!(text, "; {words} {count}");
        }
    }
    text
}

fn weakest_line(summary: &Summary<'_>) -> String {
    let Some((row, i)) = summary.weakest else {
        return "No defect has an effect on any fixture.".to_owned();
    };
    let cell = &row.cells[i];
    let place = match cell.smallest {
        Smallest::Caught { place, .. } | Smallest::Never { place } => place,
        Smallest::NoEffect => Place::Whole,
    };
    let (name, defect) = (&row.fixture, cell.defect.name);
    let caught = match cell.smallest {
        Smallest::Never { .. } => "is never caught".to_owned(),
        _ => format!(
            "is caught from {} on, {} times what is seen",
            strength_words(cell),
            times_words(cell.times_visible)
        ),
    };
    format!("The weakest fixture is {name}: {defect} {place} {caught}.")
}

/// A strength with its unit, or what is said where there is none.
fn strength_words(cell: &Cell) -> String {
    match cell.smallest {
        Smallest::NoEffect => "no effect".to_owned(),
        Smallest::Never { .. } => "never".to_owned(),
        Smallest::Caught { strength, .. } => with_unit(strength, cell.defect.unit),
    }
}

/// A strength with its unit.
pub fn with_unit(strength: f64, unit: &str) -> String {
    let one = strength == 1.0 && unit.ends_with('s');
    let unit = if one { &unit[..unit.len() - 1] } else { unit };
    format!("{} {unit}", number(strength))
}

fn times_words(times: Option<f64>) -> String {
    match times {
        None => "-".to_owned(),
        Some(f64::INFINITY) => "any".to_owned(),
        Some(times) => number(times),
    }
}

/// Two digits behind the first one that counts, without zeros at the end.
pub fn number(value: f64) -> String {
    let digits = match value.abs() {
        100.0.. => 0,
        10.0.. => 1,
        1.0.. => 2,
        0.1.. => 3,
        0.01.. => 4,
        _ => 5,
    };
    let text = format!("{value:.digits$}");
    if text.contains('.') {
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    } else {
        text
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(value: f64, expected: &str) {
        assert_eq!(number(value), expected);
    }

    #[test]
    fn numbers_are_short_and_keep_what_counts() {
        check(0.0, "0");
        check(100.0, "100");
        check(1_234.5, "1234");
        check(10.04, "10");
        check(2.0, "2");
        check(0.5, "0.5");
        check(1.0 / 3.0, "0.333");
        check(1.0 / 512.0, "0.00195");
    }

    #[test]
    fn one_is_singular_where_the_unit_has_one() {
        assert_eq!(with_unit(1.0, "codes"), "1 code");
        assert_eq!(with_unit(1.5, "codes"), "1.5 codes");
        assert_eq!(with_unit(1.0, "%"), "1 %");
    }
}
