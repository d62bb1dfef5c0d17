//! What `docs/course.md` shows is what is read.

use std::collections::BTreeMap;

use harness::fixture::{Build, Fixture};
use interchange::Feature;

use super::{Ending, Per, Plan};

const DOCUMENT: &str = include_str!("../../../../docs/course.md");

const FIXTURES: [&str; 2] = ["fixtures/basics/ball.ron", "fixtures/shadow/on-a-box.ron"];

#[track_caller]
fn fixture(name: &str) -> Fixture {
    Fixture::read(name, block(name), &scene::NoAssets, Build::Bvh).unwrap()
}

/// The block of RON that begins with the name of this file.
#[track_caller]
fn block(file: &str) -> &'static str {
    let mut blocks = DOCUMENT.split("```ron\n").skip(1).map(|rest| rest.split("```").next());
    let found = blocks.find_map(|block| block.filter(|b| b.starts_with(&format!("// {file}\n"))));
    found.unwrap_or_else(|| panic!("no {file}"))
}

#[test]
fn every_block_is_of_a_file_that_is_tried() {
    assert_eq!(DOCUMENT.matches("```ron\n").count(), 4);
}

#[test]
fn the_rubric_makes_sense() {
    // What the scenes of the document ask for, and no others.
    let suite: BTreeMap<_, _> = FIXTURES
        .iter()
        .map(|name| {
            let fixture = fixture(name);
            let asked = crate::asks(&fixture, &fixture.render_linear());
            let name = name.strip_prefix("fixtures/").and_then(|name| name.strip_suffix(".ron"));
            (name.unwrap().to_owned(), asked)
        })
        .collect();
    let text = block("rubric.ron");
    let plan = Plan::read(text, &suite);
    let plan = plan.unwrap_or_else(|why| panic!("{}", scene::report("rubric.ron", text, &why)));
    assert_eq!(plan.rubric.parts[1].per, Per::All);
    assert_eq!(plan.rubric.penalties[0].outcomes, [Ending::Crashed, Ending::TimedOut]);
    assert_eq!(plan.unasked, [""; 0]);
}

#[test]
fn the_fixtures_are_fixtures_and_in_the_template() {
    for name in FIXTURES {
        assert!(fixture(name).render().is_ok());
        assert!(DOCUMENT.contains(&format!("\n  {name}")), "{name}");
    }
}

#[test]
fn the_adapter_names_what_there_is() {
    #[derive(serde::Deserialize)]
    struct Adapter {
        scene: interchange::export::Dialect,
        unsupported: BTreeMap<Feature, String>,
        tolerance: f64,
    }
    let text = block("adapters/mine.ron");
    let adapter: Adapter = scene::read(text).unwrap();
    assert_eq!(adapter.scene, interchange::export::Dialect::CornellXml);
    assert!(adapter.unsupported.contains_key(&Feature::Torus) && adapter.tolerance > 0.0);
}
