//! What `docs/course.md` shows is what is read.

use std::collections::{BTreeMap, BTreeSet};

use harness::fixture::{Build, Fixture};
use interchange::Feature;

use super::{Ending, Per, Plan};

const DOCUMENT: &str = include_str!("../../../../docs/course.md");

/// The block of RON that begins with the name of this file.
#[track_caller]
fn block(file: &str) -> &'static str {
    let mut blocks = DOCUMENT.split("```ron\n").skip(1).map(|rest| rest.split("```").next());
    let found = blocks.find_map(|block| block.filter(|b| b.starts_with(&format!("// {file}\n"))));
    found.unwrap_or_else(|| panic!("no {file}"))
}

#[test]
fn every_block_is_of_a_file_that_is_tried() {
    assert_eq!(DOCUMENT.matches("```ron\n").count(), 3);
}

#[test]
fn the_rubric_makes_sense() {
    let suite = [
        ("basics/ball", Feature::Sphere),
        ("shadow/hard", Feature::Shadows),
        ("boxes/one", Feature::Box),
        ("extra/shiny", Feature::BlinnPhong),
    ];
    let suite: BTreeMap<_, _> =
        suite.into_iter().map(|(name, has)| (name.to_owned(), BTreeSet::from([has]))).collect();
    let text = block("rubric.ron");
    let plan = Plan::read(text, &suite);
    let plan = plan.unwrap_or_else(|why| panic!("{}", scene::report("rubric.ron", text, &why)));
    assert_eq!(plan.rubric.parts[1].per, Per::All);
    assert_eq!(plan.rubric.penalties[0].outcomes, [Ending::Crashed, Ending::TimedOut]);
    assert_eq!(plan.unasked, [""; 0]);
}

#[test]
fn the_fixture_is_one() {
    let name = "fixtures/basics/ball.ron";
    let fixture = Fixture::read(name, block(name), &scene::NoAssets, Build::Bvh).unwrap();
    assert!(fixture.render().is_ok());
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
