//! Writes scorecards and a grade of renderers that there are not, for the tests of
//! their pages in a browser, and to look at without other renderers.
//!
//! ```text
//! cargo run -p conform --example scorecards -- SUITE OUT
//! ```
//!
//! `OUT/many` has four renderers over every fixture of the suite at `SUITE`, `OUT/few`
//! over some, `OUT/one` one, `OUT/empty` none; `OUT/grade` has a grade.

use std::collections::{BTreeMap, BTreeSet};
use std::error::Error;
use std::path::{Path, PathBuf};

use conform::card::Selection;
use conform::grade::{self, Grade, Plan};
use conform::trial::{Damage, Trial};
use conform::{Conformed, Objects, card};
use harness::check::Check;
use harness::fixture::{Build, Fixture};
use harness::suite::Suite;
use interchange::Feature;
use interchange::feature::features;

type Fixtures = BTreeMap<String, Fixture>;

/// What the scorecard of some fixtures is about.
const FEW: [&str; 8] = [
    "scene/balls-on-floor",
    "scene/temple",
    "shading/classic",
    "shadow/hard",
    "show/silhouette",
    "sphere/facing",
    "torus/annulus",
    "torus/chain",
];

const RUBRIC: &str = r#"(
    version: 1,
    title: "Ray tracing basics",
    parts: [
        (name: "Spheres", points: 10, features: [Sphere]),
        (name: "Shadows & lights", points: 7.5, fixtures: ["shadow", "shading"]),
        (name: "Tori", points: 5, fixtures: ["torus"], per: All),
        (name: "Silhouettes", points: 2.5, features: [Silhouette]),
    ],
    penalties: [
        (name: "It must not crash", points: 1, outcomes: [Crashed, TimedOut], at_most: 3),
    ],
)"#;

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<_> = std::env::args_os().skip(1).map(PathBuf::from).collect();
    let [root, out] = &arguments[..] else { return Err("expected a suite and a folder".into()) };
    let all = fixtures(&Suite::open(root)?)?;
    let few: Fixtures = all
        .iter()
        .filter(|(name, _)| FEW.contains(&name.as_str()))
        .map(|(n, f)| (n.clone(), f.clone()))
        .collect();
    write(&out.join("many"), (&four(&all), None), &all)?;
    let four_of_few = four(&few);
    let part = Selection::of(&FEW.map(str::to_owned), few.len(), all.len());
    write(&out.join("few"), (&four_of_few, part), &few)?;
    write(&out.join("one"), (&four_of_few[1..2], None), &few)?;
    write(&out.join("empty"), (&[], None), &few)?;
    write_grade(&out.join("grade"), &four_of_few[3], &few)
}

fn fixtures(suite: &Suite) -> Result<Fixtures, Box<dyn Error>> {
    let open = |name: String| {
        let path = suite.fixture_path(&name);
        let fixture = Fixture::open(&Suite::fixture_label(&name), &path, Build::Bvh)?;
        Ok((name, fixture))
    };
    suite.select(&[])?.fixtures.into_iter().map(open).collect()
}

/// One is right, one without a gamma, one has a wrong color in each scene, and one is
/// wrong, lacks something and crashes.
fn four(all: &Fixtures) -> Vec<Conformed> {
    let named = |trial: Trial, name: &str, version: &str| {
        let mut conformed = Trial { version: version.to_owned(), ..trial }.run(all);
        name.clone_into(&mut conformed.run.renderer.name);
        conformed
    };
    let limited = Trial {
        unsupported: [Feature::Oblique, Feature::Depth, Feature::Normals].into(),
        crashes: [Feature::Torus].into(),
        ..Trial::right("limited").with(Damage::Feature(Feature::BlinnPhong))
    };
    vec![
        named(Trial::right("exact"), "Exact", "exact 1.2.3\n(built for a trial)"),
        named(Trial::right("gamma").with(Damage::Gamma), "No gamma", "0.9"),
        named(Trial::right("recolored").with(Damage::Recolor(1)), "Recolored", ""),
        named(
            limited,
            "Limited <b>&amp;",
            "a version with very many words in it, so that it is cut",
        ),
    ]
}

type Runs<'a> = (&'a [Conformed], Option<Selection>);

fn write(folder: &Path, runs: Runs<'_>, all: &Fixtures) -> Result<(), Box<dyn Error>> {
    card::write(folder, runs, &|name| all.get(name).map(Objects::of))?;
    Ok(())
}

fn write_grade(folder: &Path, run: &Conformed, all: &Fixtures) -> Result<(), Box<dyn Error>> {
    let asks = |fixture: &Fixture| -> BTreeSet<Feature> {
        scene::parse::<Check>(&fixture.text).as_ref().map(features).unwrap_or_default()
    };
    let suite = all.iter().map(|(name, fixture)| (name.clone(), asks(fixture))).collect();
    let plan = Plan::read(RUBRIC, &suite)
        .map_err(|problems| scene::report("rubric.ron", RUBRIC, &problems))?;
    let look = |name: &str| all.get(name).map(Objects::of);
    grade::write(folder, &Grade::of(&plan, run), run, &look)?;
    Ok(())
}
