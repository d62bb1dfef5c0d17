//! What a card says of runs that are right, wrong, and few.

use std::collections::BTreeMap;

use harness::fixture::Fixture;
use interchange::Feature;
use scene::NoAssets;
use tracer::accel::Build;

use super::*;
use crate::Outcome;
use crate::trial::{self, Damage, Trial};

const LIT: &str = "camera: LookAt(eye: (0, 0, 5), at: (0, 0, 0), fov_deg: 40),
    lights: [Point(position: (3, 4, 5))]";

/// Three small scenes: a ball, a box, and the ball's outline.
pub(crate) fn fixtures() -> BTreeMap<String, Fixture> {
    let read = |(name, rest): (&str, String)| {
        let text = format!("(version: 1, image: (24, 18), {rest})");
        (name.to_owned(), Fixture::read(name, &text, &NoAssets, Build::Bvh).unwrap())
    };
    let ball = "objects: [\n Sphere(center: (0, 0, 0), radius: 1)]";
    let block = "objects: [Box(min: (-1, -1, -1), max: (1, 1, 1))]";
    let all = [
        ("ball", format!("{LIT}, {ball}")),
        ("block", format!("{LIT}, {block}")),
        ("outline", format!("{LIT}, {ball}, show: Silhouette")),
    ];
    all.into_iter().map(read).collect()
}

/// A right renderer, one without a gamma, one that paints boxes wrong and one that has
/// no spheres but in the dark.
pub(crate) fn four() -> Vec<Conformed> {
    let all = fixtures();
    let mut wrong = Trial::right("wrong").with(Damage::Feature(Feature::Box)).run(&all);
    wrong.run.renderer.name = "<wrong>".to_owned();
    let few = Trial { unsupported: [Feature::Sphere].into(), ..Trial::right("few") };
    let gamma = Trial::right("gamma").with(Damage::Gamma);
    vec![Trial::right("right").run(&all), gamma.run(&all), wrong, few.run(&all)]
}

fn card() -> Card {
    let all = fixtures();
    Card::of(&four(), &|name| all.get(name).map(Objects::of)).unwrap()
}

#[track_caller]
fn check(feature: Feature, expected: [Standing; 4]) {
    let card = card();
    let row = card.rows.iter().find(|row| row.feature == feature).unwrap();
    let found: Vec<_> = row.cells.iter().map(|cell| cell.standing).collect();
    assert_eq!(found, expected, "{feature}");
}

#[test]
fn each_feature_stands_as_its_pictures_show() {
    use Standing::{Cleared, Fails, Passes, Suspect, Unsupported};
    // Without a gamma black and white are right, so balls are, and shading is not.
    check(Feature::Sphere, [Passes, Cleared, Passes, Unsupported]);
    check(Feature::Lambert, [Passes, Suspect, Cleared, Passes]);
    check(Feature::Silhouette, [Passes, Passes, Passes, Unsupported]);
    check(Feature::Box, [Passes, Suspect, Fails, Passes]);
}

#[test]
fn a_failure_has_its_numbers_suspects_and_place() {
    let card = card();
    let gamma = card.fixtures["ball"].results[1].clone().unwrap();
    assert_eq!(gamma.result.outcome, Outcome::Fail);
    assert_eq!(gamma.worst_on.unwrap().words("f"), "the Sphere of f:3:2");
    assert!(gamma.suspicion.unwrap().features.contains(&Feature::Lambert));
    let right = card.fixtures["ball"].results[0].clone().unwrap();
    assert_eq!((right.suspicion, right.worst_on), (None, None));
    let tally = &card.renderers[1].tally;
    assert_eq!((tally.passed(), tally.failed(), tally.total()), (1, 2, 3));
    assert!(tally.worst.as_ref().unwrap().error > 0.1);
    assert!(card.unasked.contains(&Feature::Torus) && !card.unasked.contains(&Feature::Box));
}

#[test]
fn a_fixture_of_one_run_only_is_in_the_card() {
    let mut runs = four();
    runs.truncate(2);
    runs[1].run.fixtures.remove("block");
    let card = Card::of(&runs, &|_| None).unwrap();
    assert!(card.fixtures["block"].results[1].is_none());
    let json = json(&card);
    assert!(json["fixtures"][1]["results"].get("gamma").is_none());
    assert_eq!(json["fixtures"][1]["results"]["right"]["outcome"], "pass");
}

#[test]
fn runs_that_cannot_be_told_apart_make_no_card() {
    #[track_caller]
    fn check(ids: &[&str], expected: &str) {
        let runs: Vec<_> = ids
            .iter()
            .map(|id| Conformed { run: trial::run(id), evidence: BTreeMap::new() })
            .collect();
        assert_eq!(Card::of(&runs, &|_| None).unwrap_err().to_string(), expected);
    }
    check(&["a", "a"], "expected one run of each renderer, found two of \"a\"");
    check(&["a", "b", "A"], "expected one run of each renderer, found two of \"A\"");
    check(&["../a"], "expected an id of letters, digits, `-` and `_`, found \"../a\"");
    check(&[""], "expected an id of letters, digits, `-` and `_`, found \"\"");
    check(&["a\u{1b}"], "expected an id of letters, digits, `-` and `_`, found \"a\\u{1b}\"");
}

#[test]
fn the_page_of_markdown_says_it_all() {
    let page = markdown(&card());
    for line in [
        "| right |  | 3 of 3 |  | 1e-5 | 0 |",
        "| gamma |  | 1 of 3 | 2 fail | 1e-5 |",
        "| Lambert | passes 2/2 | suspect 0/2 | cleared 1/2 | passes 1/2 |",
        "| Sphere | passes 2/2 | cleared 1/2 | passes 2/2 | unsupported |",
        "\n## What fails with gamma\n",
        "\n## What fails with &#60;wrong&#62;\n",
        "on the Sphere of fixtures/ball.ron:3:2 |",
        "| <code>block</code> | fail |",
        "| Box |\n",
        "gamma stands alone in ",
    ] {
        assert!(page.contains(line), "{line}\n{page}");
    }
    assert!(!page.contains("What fails with right"), "{page}");
    let empty = markdown(&Card::of(&[], &|_| None).unwrap());
    assert_eq!(empty, "# Scorecard\n\nNo renderer was asked for a picture.\n");
}

#[test]
fn a_sentence_tells_who_where_and_on_what() {
    let card = card();
    let told = card.fixtures["block"].told.as_ref().unwrap();
    let expected = "gamma and <wrong> are against the majority in 100 px of block, in one region \
                    at (7, 4)..(16, 13), on the Box of fixtures/block.ron:2:53";
    assert_eq!(sentences("block", told, &card.names(told)), [expected]);
    // Smaller regions that are not listed may be of this opinion too.
    let mut more = told.clone();
    more.untold = (1, 2);
    let [line] = &sentences("block", &more, &card.names(told))[..] else { panic!("one opinion") };
    assert!(line.contains(", in one region or more, the largest of 100 px at (7, 4)"), "{line}");
    let ball = {
        let told = card.fixtures["ball"].told.as_ref().unwrap();
        sentences("ball", told, &card.names(told))
    };
    assert_eq!(ball.len(), 1, "{ball:?}");
    assert!(ball[0].starts_with("gamma stands alone in "), "{ball:?}");
    assert!(ball[0].ends_with(", on the Sphere of fixtures/ball.ron:3:2"), "{ball:?}");
}

#[test]
fn every_file_is_written_whole() {
    let folder = tempfile::tempdir().unwrap();
    let (card, files) = write(folder.path(), (&four(), None), &|_| None).unwrap();
    assert_eq!(card.renderers.len(), 4);
    let names: Vec<_> =
        files.iter().map(|path| path.file_name().unwrap().to_string_lossy().into_owned()).collect();
    let expected = [
        "scorecard.json",
        "scorecard.md",
        "scorecard.html",
        "badge-right.svg",
        "badge-gamma.svg",
        "badge-wrong.svg",
        "badge-few.svg",
    ];
    assert_eq!(names, expected);
    let read = |i: usize| harness::store::read(&files[i], 1 << 30).unwrap().unwrap();
    assert!(read(0) == format!("{:#}\n", json(&card)).into_bytes());
    assert!(read(3).starts_with(b"<svg "));
}

#[test]
fn the_document_lists_every_feature() {
    let document = include_str!("../../../../docs/scorecard.md");
    let listed = document.lines().filter_map(|line| line.strip_prefix("| ")?.split_once("| `"));
    let listed = listed.filter_map(|(_, rest)| rest.split_once("` |")).map(|(name, _)| name);
    let all: Vec<_> = Feature::ALL.iter().map(|feature| feature.name()).collect();
    assert_eq!(listed.collect::<Vec<_>>(), all, "docs/scorecard.md, \"The features\"");
}

#[test]
fn what_is_a_part_of_the_suite_says_so_everywhere() {
    let folder = tempfile::tempdir().unwrap();
    let part = Selection { filters: vec!["b*".to_owned()], fixtures: 3, of: 9 };
    let words = "Only a part of the suite was asked for: 3 of 9 fixtures, by the filter \"b*\"";
    assert_eq!(part.words(), words);
    let (card, files) = write(folder.path(), (&four(), Some(part)), &|_| None).unwrap();
    let read = |i: usize| {
        let bytes = harness::store::read(&files[i], 1 << 30).unwrap().unwrap();
        String::from_utf8(bytes).unwrap()
    };
    let told: serde_json::Value = serde_json::from_str(&read(0)).unwrap();
    let expected = serde_json::json!({ "filters": ["b*"], "fixtures": 3, "of": 9, "words": words });
    assert_eq!(told["selection"], expected);
    let page = read(1);
    let line = "by the filter \"b&#42;\".\n";
    assert!(page.starts_with("# Scorecard\n\nOnly a part") && page.contains(line), "{page}");
    let page = html(&card, &four());
    assert!(page.contains("\"selection\":{"), "the page has what the document has");
    assert!(page.contains("selectionLine"), "and shows it");
    let badge = read(3);
    assert!(badge.contains(">3 of 3 pass, a part of the suite</text>"), "{badge}");
    assert!(badge.contains("3 of 9 fixtures, by the filter &quot;b*&quot;</title>"), "{badge}");
    let (whole, _) = write(folder.path(), (&four(), None), &|_| None).unwrap();
    assert_eq!(json(&whole)["selection"], serde_json::Value::Null);
}

#[test]
fn badges_of_an_earlier_card_go_and_those_of_strangers_stay() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    let put = |name: &str| harness::store::write(&path(name), b"<svg >mine</svg>").unwrap();
    let is_there = |name: &str| harness::store::is_file(&path(name));
    put("badge-coverage.svg");
    write(folder.path(), (&four(), None), &|_| None).unwrap();
    // Somebody drew this one anew.
    put("badge-few.svg");
    write(folder.path(), (&four()[..1], None), &|_| None).unwrap();
    let found = ["right", "gamma", "wrong", "few", "coverage"]
        .map(|id| is_there(&format!("badge-{id}.svg")));
    assert_eq!(found, [true, false, false, true, true]);
    // An earlier file of that name that is no card, and one that names files elsewhere.
    for text in ["no JSON", "{\"renderers\": [{\"id\": \"../outside\"}, {\"id\": \"a/b\"}, 7]}"] {
        harness::store::write(&path("scorecard.json"), text.as_bytes()).unwrap();
        write(folder.path(), (&four()[1..2], None), &|_| None).unwrap();
        assert!(is_there("badge-right.svg") && is_there("badge-gamma.svg"));
    }
}
