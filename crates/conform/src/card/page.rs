//! `html`: the page of a scorecard, one file that needs nothing else.
//!
//! `id="card"` has what [`json`](super::json()) tells; one element for each fixture,
//! `id="fixture-N"`, has its pictures, and is read when they are looked at.

use std::collections::BTreeMap;

use harness::picture::HEAT;
use harness::report::page::shell::put;
use serde_json::{Map, Value, json};

use super::{Card, Entry, json};
use crate::consensus::{COLORS, SEVERAL, UNDECIDED, disagreement};
use crate::pictures::{self, EDGE, STEP};
use crate::{Conformed, Outcome, page};

/// The most bytes of pictures in a page, as they are written in it: 64 MiB. What is
/// beyond is left out, passing fixtures first, and the page says so.
const MAX_PICTURE_BYTES: usize = 64 << 20;

/// What a page with a card in it may use: the data, results with their pictures.
const SHARED: [&str; 5] = [
    include_str!("script/data.js"),
    include_str!("script/words.js"),
    include_str!("script/pictures.js"),
    include_str!("script/facts.js"),
    include_str!("script/details.js"),
];

/// What shows the card as a whole.
const OVERVIEW: [&str; 5] = [
    include_str!("script/summary.js"),
    include_str!("script/matrix.js"),
    include_str!("script/consensus.js"),
    include_str!("script/table.js"),
    include_str!("script/overview.js"),
];

/// What begins.
const MAIN: &str = include_str!("script/main.js");

/// The page of a card of these runs.
pub fn html(card: &Card, runs: &[Conformed]) -> String {
    html_within(card, runs, MAX_PICTURE_BYTES)
}

/// The same with at most so many bytes of pictures.
fn html_within(card: &Card, runs: &[Conformed], max_bytes: usize) -> String {
    page_of("scorecard", &title(card), &data(card, runs, max_bytes), &OVERVIEW)
}

/// The page of a grade by this card of its run; `more` is the script element of the
/// grade, `script` shows it.
pub(crate) fn grade_html(
    card: &Card,
    runs: &[Conformed],
    title: &str,
    more: &str,
    script: &str,
) -> String {
    let data = data(card, runs, MAX_PICTURE_BYTES) + more;
    page_of("grade", title, &data, &[CONSENSUS, script])
}

/// The consensus of a scene, which a fixture's page shows.
const CONSENSUS: &str = OVERVIEW[2];

fn page_of(kind: &str, title: &str, data: &str, overview: &[&str]) -> String {
    let scripts: Vec<&str> = SHARED.iter().chain(overview).chain([&MAIN]).copied().collect();
    page::page(kind, title, data, &scripts)
}

/// The script elements of a card and of each fixture's pictures.
fn data(card: &Card, runs: &[Conformed], max_bytes: usize) -> String {
    let mut document = json(card);
    document["colors"] = json!({
        "voters": COLORS,
        "several": SEVERAL,
        "undecided": UNDECIDED,
        "edge": EDGE,
        "heat": HEAT,
        "step": STEP,
    });
    let mut left = max_bytes;
    // Failures first: there is room for them if for anything.
    let has_failed = |entry: &Entry| {
        let outcomes = entry.results.iter().flatten().map(|answered| answered.result.outcome);
        outcomes.into_iter().any(|outcome| outcome == Outcome::Fail)
    };
    let mut order: Vec<_> = card.fixtures.iter().enumerate().collect();
    order.sort_by_key(|(_, (_, entry))| !has_failed(entry));
    let mut elements = BTreeMap::new();
    for (number, (name, entry)) in order {
        let shown = fixture(name, entry, runs);
        let bytes = shown.to_string().len();
        let fits = bytes <= left;
        left -= if fits { bytes } else { 0 };
        elements.insert(number, if fits { shown } else { json!({ "left_out": true }) });
    }
    let mut data = String::new();
    put(&mut data, "card", &document);
    for (number, shown) in &elements {
        put(&mut data, &format!("fixture-{number}"), shown);
    }
    data
}

fn title(card: &Card) -> String {
    let names: Vec<_> = card.renderers.iter().map(|column| column.info.name.as_str()).collect();
    match names[..] {
        [] => "goldray scorecard".to_owned(),
        _ => format!("goldray scorecard: {}", names.join(", ")),
    }
}

/// The pictures of a fixture: of goldray, of each renderer with where it differs, and
/// of who disagrees. `actual` is null where it has the codes of the reference.
fn fixture(name: &str, entry: &Entry, runs: &[Conformed]) -> Value {
    let evidence = || runs.iter().filter_map(|one| Some((one, one.evidence.get(name)?)));
    let Some((_, first)) = evidence().next() else { return json!({}) };
    let reference = pictures::seen(&first.reference);
    let mut by = Map::new();
    for (one, evidence) in evidence() {
        let actual = pictures::seen(&evidence.actual);
        // Another state of the suite has another reference.
        let own = Some(&evidence.reference).filter(|own| **own != first.reference);
        let own = own.and_then(pictures::seen);
        let is_same = own.is_none() && actual == reference;
        let difference = pictures::difference(evidence, one.run.tolerance)
            .filter(|_| evidence.off.contains(&true));
        let shown = json!({
            "reference": pictures::base64(own.as_ref()),
            "is_same": is_same,
            "actual": if is_same { None } else { pictures::base64(actual.as_ref()) },
            "difference": pictures::base64(difference.as_ref()),
        });
        by.insert(one.run.renderer.id.clone(), shown);
    }
    let told = entry.told.as_ref().zip(reference.as_ref());
    let apart = told.and_then(|(told, base)| disagreement(told, base, &first.edges));
    let size = first.reference.size();
    json!({
        "size": [size.width, size.height],
        "reference": pictures::base64(reference.as_ref()),
        "by": by,
        "consensus": pictures::base64(apart.as_ref()),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::card::tests::{fixtures, four};

    /// The JSON of an element.
    #[track_caller]
    fn element(page: &str, id: &str) -> Value {
        let start = format!("<script type=\"application/json\" id=\"{id}\">");
        let (_, rest) = page.split_once(&start).unwrap_or_else(|| panic!("no {id}"));
        serde_json::from_str(rest.split_once("</script>").unwrap().0).unwrap()
    }

    #[test]
    fn a_page_has_the_card_and_every_picture() {
        let runs = four();
        let card = Card::of(&runs, &|_| None).unwrap();
        let page = html(&card, &runs);
        assert!(
            page.contains("<title>goldray scorecard: right, gamma, &lt;wrong&gt;, few</title>")
        );
        let told = element(&page, "card");
        assert_eq!(told["fixtures"].as_array().unwrap().len(), fixtures().len());
        assert_eq!(told["colors"]["heat"].as_array().unwrap().len(), 8);
        let index = card.fixtures.keys().position(|name| name == "ball").unwrap();
        let pictures = element(&page, &format!("fixture-{index}"));
        assert_eq!(pictures["size"], json!([24, 18]));
        assert_eq!(pictures["by"]["right"]["is_same"], true);
        assert!(pictures["by"]["right"]["difference"].is_null());
        let png = pictures["by"]["gamma"]["difference"].as_str().unwrap();
        assert!(png.starts_with("iVBORw0KGgo"), "{png}");
        assert!(pictures["by"].get("few").is_none(), "it does not support it");
        assert!(pictures["consensus"].is_string());
    }

    #[test]
    fn what_is_too_much_is_left_out_and_said_passing_fixtures_first() {
        let runs = four();
        let card = Card::of(&runs, &|_| None).unwrap();
        let page = html_within(&card, &runs, 0);
        assert_eq!(element(&page, "fixture-0"), json!({ "left_out": true }));
        let whole = html(&card, &runs);
        let right: Vec<_> = card
            .fixtures
            .values()
            .map(|entry| entry.results.iter().flatten().all(|a| a.result.outcome != Outcome::Fail))
            .collect();
        let (good, bad) = (right.iter().position(|r| *r), right.iter().position(|r| !*r));
        let (good, bad) = (good.unwrap(), bad.unwrap());
        let failing: usize = (0..right.len())
            .filter(|&i| !right[i])
            .map(|i| element(&whole, &format!("fixture-{i}")).to_string().len())
            .sum();
        let page = html_within(&card, &runs, failing);
        assert_eq!(element(&page, &format!("fixture-{good}")), json!({ "left_out": true }));
        assert!(element(&page, &format!("fixture-{bad}"))["reference"].is_string());
    }

    #[test]
    fn nothing_that_is_said_breaks_out_of_its_place() {
        let mut runs = four();
        let first = runs[0].run.fixtures.values_mut().next().unwrap();
        first.findings = vec!["</script><!--<script>".to_owned()];
        let card = Card::of(&runs, &|_| None).unwrap();
        let page = html(&card, &runs);
        assert!(!page.contains("</script><!--"));
        let said = element(&page, "card")["fixtures"][0]["results"]["right"]["findings"][0].clone();
        assert_eq!(said, "</script><!--<script>");
    }

    #[test]
    fn a_card_of_nothing_is_a_page_too() {
        let card = Card::of(&[], &|_| None).unwrap();
        let page = html(&card, &[]);
        assert!(page.contains("<title>goldray scorecard</title>"));
        assert_eq!(element(&page, "card")["fixtures"], json!([]));
    }
}
