//! `junit`: a run as JUnit XML, which build servers read.

use std::collections::BTreeMap;
use std::fmt::{self, Write};

use super::json::distances;
use super::text::{Reader, advice, evidence, file, rerun};
use crate::verdict::{Origin, Outcome, Verdict};

/// A run: a `testsuite` for each area, a `testcase` for each fixture. What has
/// no picture or an unreadable golden is an `error`, every other failure a
/// `failure`; their `type` is the verdict's id.
///
/// Metrics and the picture strip are in `system-out`, as the lines
/// `[[PROPERTY|name=value]]` and `[[ATTACHMENT|path]]` that GitLab and Jenkins
/// read: the schema of Jenkins' xUnit plugin, by which this is valid as by
/// `docs/schemas/junit.xsd`, lets a test case have no properties.
pub fn junit(outcomes: &[Outcome], elapsed_ms: f64, reader: &Reader) -> String {
    let mut areas: BTreeMap<String, Vec<&Outcome>> = BTreeMap::new();
    for outcome in outcomes {
        areas.entry(area_and_name(&outcome.name).0).or_default().push(outcome);
    }
    let mut xml = String::from("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
    // Writing to a String cannot fail.
    let _ = write_suites(&mut xml, outcomes, &areas, elapsed_ms, reader);
    xml
}

fn write_suites(
    xml: &mut String,
    outcomes: &[Outcome],
    areas: &BTreeMap<String, Vec<&Outcome>>,
    elapsed_ms: f64,
    reader: &Reader,
) -> fmt::Result {
    let all: Vec<_> = outcomes.iter().collect();
    writeln!(xml, "<testsuites name=\"goldray\" {}>", counts(&all, elapsed_ms))?;
    for (area, outcomes) in areas {
        let spent_ms = outcomes.iter().map(|outcome| spent_ms(outcome)).sum();
        let (name, counts) = (attribute(area), counts(outcomes, spent_ms));
        writeln!(xml, "  <testsuite name=\"{name}\" {counts} skipped=\"0\">")?;
        for outcome in outcomes {
            write_case(xml, outcome, reader)?;
        }
        writeln!(xml, "  </testsuite>")?;
    }
    writeln!(xml, "</testsuites>")
}

fn write_case(xml: &mut String, outcome: &Outcome, reader: &Reader) -> fmt::Result {
    let (area, name) = area_and_name(&outcome.name);
    let (area, name, time) = (attribute(&area), attribute(name), seconds(spent_ms(outcome)));
    write!(xml, "    <testcase classname=\"{area}\" name=\"{name}\" time=\"{time}\">")?;
    if let Some(element) = element(outcome.verdict) {
        let (kind, message) = (outcome.verdict.id(), attribute(&message(outcome)));
        let details = text(&details(outcome, reader));
        write!(
            xml,
            "\n      <{element} type=\"{kind}\" message=\"{message}\">{details}</{element}>"
        )?;
    }
    let facts = facts(outcome, reader);
    if !facts.is_empty() {
        write!(xml, "\n      <system-out>{}</system-out>", text(&facts))?;
    }
    writeln!(xml, "\n    </testcase>")
}

/// Which element says it; none for a match.
fn element(verdict: Verdict) -> Option<&'static str> {
    match verdict {
        Verdict::Match => None,
        Verdict::RenderRefused | Verdict::Unreadable => Some("error"),
        _ => Some("failure"),
    }
}

/// `tests`, `failures`, `errors` and `time`.
fn counts(outcomes: &[&Outcome], spent_ms: f64) -> String {
    let count = |name| outcomes.iter().filter(|o| element(o.verdict) == Some(name)).count();
    let (tests, failures, errors) = (outcomes.len(), count("failure"), count("error"));
    let time = seconds(spent_ms);
    format!("tests=\"{tests}\" failures=\"{failures}\" errors=\"{errors}\" time=\"{time}\"")
}

fn spent_ms(outcome: &Outcome) -> f64 {
    outcome.render_ms + outcome.compare_ms + outcome.relate_ms
}

fn seconds(milliseconds: f64) -> String {
    format!("{:.6}", milliseconds / 1e3)
}

/// The folder that a fixture is in, and its name there.
fn area_and_name(name: &str) -> (String, &str) {
    match name.rsplit_once('/') {
        Some((area, name)) => (format!("fixtures/{area}"), name),
        None => ("fixtures".to_owned(), name),
    }
}

/// The verdict and its first reason, in one line.
fn message(outcome: &Outcome) -> String {
    let first = outcome.findings.first().and_then(|finding| finding.lines().next());
    let words = outcome.verdict.words();
    first.map_or(words.clone(), |first| format!("{words}: {first}"))
}

/// Every reason, and what to do, a line each.
fn details(outcome: &Outcome, reader: &Reader) -> String {
    let file = file(outcome, reader);
    let place = outcome.place.map(|(line, column)| format!(":{line}:{column}"));
    let mut lines = vec![format!("{file}{}", place.unwrap_or_default())];
    lines.extend(outcome.findings.iter().map(|finding| finding.trim_end().to_owned()));
    lines.extend(evidence(outcome, reader));
    lines.extend(advice(outcome, reader));
    lines.push(format!("again: {}", rerun(&outcome.name, reader)));
    lines.join("\n")
}

/// What is known of it as numbers, a line each.
fn facts(outcome: &Outcome, reader: &Reader) -> String {
    let mut lines = Vec::new();
    if outcome.origin == Origin::Unchanged {
        lines.push("[[PROPERTY|cached=true]]".to_owned());
    }
    for (name, value) in outcome.comparison.as_ref().map(distances).into_iter().flatten() {
        if value.is_number() {
            lines.push(format!("[[PROPERTY|{name}={value}]]"));
        }
    }
    // A path that would end the tag is left out.
    if let Some(strip) = outcome.strip.as_ref().filter(|strip| !strip.contains("]]")) {
        lines.push(format!("[[ATTACHMENT|{}{strip}]]", reader.path_prefix));
    }
    lines.join("\n")
}

/// The value of an attribute.
fn attribute(value: &str) -> String {
    // Unescaped, a reader would make a space of each.
    text(value).replace('\t', "&#9;").replace('\n', "&#10;").replace('"', "&quot;")
}

/// What stands between tags. What XML 1.0 cannot hold, escaped or not, becomes
/// U+FFFD.
///
/// Source: Extensible Markup Language (XML) 1.0, fifth edition, 2.2 and 2.4.
fn text(value: &str) -> String {
    let mut out = String::with_capacity(value.len());
    for c in value.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '\r' => out.push_str("&#13;"),
            '\t' | '\n' => out.push(c),
            '\0'..' ' | '\u{fffe}' | '\u{ffff}' => out.push('\u{fffd}'),
            c => out.push(c),
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(value: &str, in_text: &str, in_attribute: &str) {
        assert_eq!(text(value), in_text, "{value:?}");
        assert_eq!(attribute(value), in_attribute, "{value:?}");
    }

    #[test]
    fn whatever_is_written_stays_xml() {
        check("]]>", "]]&gt;", "]]&gt;");
        check(
            "<a href=\"b\">&amp;",
            "&lt;a href=\"b\"&gt;&amp;amp;",
            "&lt;a href=&quot;b&quot;&gt;&amp;amp;",
        );
        check("\0\u{1b}[1m\u{7f}", "\u{fffd}\u{fffd}[1m\u{7f}", "\u{fffd}\u{fffd}[1m\u{7f}");
        check("\u{fffe}\u{ffff}\u{fffd}", "\u{fffd}\u{fffd}\u{fffd}", "\u{fffd}\u{fffd}\u{fffd}");
        check("a\tb\r\nc", "a\tb&#13;\nc", "a&#9;b&#13;&#10;c");
        check("Kügelchen 🎱 \u{202e}", "Kügelchen 🎱 \u{202e}", "Kügelchen 🎱 \u{202e}");
        check("", "", "");
    }

    #[test]
    fn a_suite_for_each_area_with_its_counts() {
        let outcome = |name: &str, verdict| Outcome {
            render_ms: 1500.0,
            compare_ms: 0.25,
            ..Outcome::unrendered(name, verdict)
        };
        let all = [
            outcome("a/x", Verdict::Match),
            outcome("a/y", Verdict::Differs),
            outcome("deep/er/z", Verdict::RenderRefused),
            outcome("top", Verdict::Unreadable),
        ];
        let xml = junit(&all, 2e3, &Reader::default());
        for part in [
            "<testsuites name=\"goldray\" tests=\"4\" failures=\"1\" errors=\"2\" time=\"2.000000\">",
            "<testsuite name=\"fixtures/a\" tests=\"2\" failures=\"1\" errors=\"0\" time=\"3.000500\" skipped=\"0\">",
            "<testsuite name=\"fixtures/deep/er\" tests=\"1\" failures=\"0\" errors=\"1\"",
            "<testcase classname=\"fixtures/a\" name=\"x\" time=\"1.500250\">\n    </testcase>",
            "<failure type=\"differs\" message=\"differs\">fixtures/a/y.ron\nif meant: cargo xtask bless a/y",
            "<testcase classname=\"fixtures\" name=\"top\"",
            "<error type=\"unreadable\"",
        ] {
            assert!(xml.contains(part), "expected {part} in\n{xml}");
        }
    }

    #[test]
    fn every_finding_and_the_place_are_in_the_text() {
        let outcome = Outcome {
            findings: (1..=5).map(|i| format!("finding {i}\n")).collect(),
            place: Some((14, 9)),
            breaks_expectations: true,
            strip: Some("target/goldray/a.png".to_owned()),
            ..Outcome::unrendered("a", Verdict::ExpectationFailed)
        };
        let xml = junit(&[outcome], 0.0, &Reader::default());
        for part in [
            "message=\"expectation failed: finding 1\">fixtures/a.ron:14:9\nfinding 1\n",
            "finding 5\nmend the scene,",
            "again: cargo xtask check a</failure>",
            "<system-out>[[ATTACHMENT|target/goldray/a.png]]</system-out>",
        ] {
            assert!(xml.contains(part), "expected {part} in\n{xml}");
        }
    }
}
