//! Trials: runs as other renderers might have made them, of goldray's own pictures
//! that are damaged on purpose.
//!
//! They are what tests and the pages in a browser are tried with, where nobody has
//! another renderer.

use std::collections::{BTreeMap, BTreeSet};

use harness::check::Check;
use harness::fixture::Fixture;
use interchange::Feature;
use interchange::feature::features;
use tracer::{LinearImage, Rgb, objects_seen};

use crate::scale::Scale;
use crate::{Conformed, Evidence, FixtureResult, Numbers, Outcome, RendererInfo, Run};

/// How far an interior pixel may be off in a trial, relative.
pub const TOLERANCE: f64 = 1e-5;

/// A renderer that there is not.
#[derive(Debug, Clone)]
pub struct Trial {
    /// Its id, and its name for people.
    pub id: String,
    /// What it says of its version.
    pub version: String,
    /// What becomes of its pictures.
    pub damage: Damage,
    /// What its adapter does not ask for.
    pub unsupported: BTreeSet<Feature>,
    /// Fixtures with these make it crash.
    pub crashes: BTreeSet<Feature>,
}

/// What becomes of a picture.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Damage {
    /// It is right.
    None,
    /// It is moved to the right by so many pixels.
    Shift(u32),
    /// Its values are gamma-encoded where linear ones are expected.
    Gamma,
    /// One object has other colors, by its number.
    Recolor(u32),
    /// It is brighter by so much, relative.
    Gain(f64),
    /// One feature is painted wrong: fixtures with it are half as bright.
    Feature(Feature),
}

impl Trial {
    /// One that is right, and has everything.
    pub fn right(id: &str) -> Self {
        Self {
            id: id.to_owned(),
            version: String::new(),
            damage: Damage::None,
            unsupported: BTreeSet::new(),
            crashes: BTreeSet::new(),
        }
    }

    /// The same with this damage.
    #[must_use]
    pub fn with(self, damage: Damage) -> Self {
        Self { damage, ..self }
    }

    /// Its run over these fixtures, by name.
    pub fn run(&self, fixtures: &BTreeMap<String, Fixture>) -> Conformed {
        let mut conformed = Conformed { run: run(&self.id), evidence: BTreeMap::new() };
        conformed.run.renderer.version.clone_from(&self.version);
        for (name, fixture) in fixtures {
            let (result, evidence) = self.result(fixture);
            conformed.run.fixtures.insert(name.clone(), result);
            conformed.evidence.extend(evidence.map(|evidence| (name.clone(), evidence)));
        }
        conformed
    }

    fn result(&self, fixture: &Fixture) -> (FixtureResult, Option<Evidence>) {
        let file = scene::parse::<Check>(&fixture.text);
        let features = file.as_ref().map(features).unwrap_or_default();
        let without = |outcome, finding: String| FixtureResult {
            features: features.clone(),
            outcome,
            findings: vec![finding],
            numbers: None,
            elapsed_ms: 12.0,
        };
        let lacks: Vec<_> = features.intersection(&self.unsupported).map(|f| f.name()).collect();
        if !lacks.is_empty() {
            let finding = format!("the adapter does not support {}", lacks.join(", "));
            return (without(Outcome::Unsupported, finding), None);
        }
        if let Some(feature) = features.intersection(&self.crashes).next() {
            let finding = format!("it ended with exit code 3; it said: no <{feature}> & no way");
            return (without(Outcome::Crashed, finding), None);
        }
        let reference = fixture.render_linear();
        let actual = self.damage.of(&reference, fixture, &features);
        let evidence = judged(reference, actual, edges(fixture));
        let numbers = numbers(&evidence);
        let is_right = numbers.interior_off == 0;
        let mut result =
            FixtureResult { numbers: Some(numbers), ..without(Outcome::Pass, String::new()) };
        result.findings.clear();
        if !is_right {
            result.outcome = Outcome::Fail;
            result.findings = vec![format!(
                "expected interior pixels within {TOLERANCE:e}, found {} beyond it",
                numbers.interior_off
            )];
        }
        (result, Some(evidence))
    }
}

impl Damage {
    fn of(self, picture: &LinearImage, fixture: &Fixture, has: &BTreeSet<Feature>) -> LinearImage {
        let size = picture.size();
        let map = |change: &dyn Fn(f64) -> f64| {
            LinearImage::from_fn(size, |x, y| {
                let [r, g, b] = picture.get(x, y).unwrap_or_default().channels();
                Rgb::new(change(r), change(g), change(b))
            })
        };
        match self {
            Self::Shift(by) => LinearImage::from_fn(size, |x, y| {
                picture.get(x.saturating_sub(by), y).unwrap_or_default()
            }),
            Self::Gamma => map(&|value| libm::pow(value.max(0.0), 1.0 / 2.2)),
            Self::Gain(by) => map(&|value| value * (1.0 + by)),
            Self::Feature(feature) if has.contains(&feature) => map(&|value| value / 2.0),
            Self::None | Self::Feature(_) => picture.clone(),
            Self::Recolor(number) => {
                let seen = objects_seen(&fixture.scene);
                let mut pixels = picture.pixels().to_vec();
                for (pixel, object) in pixels.iter_mut().zip(seen) {
                    if object.is_some_and(|object| object.0 == number) {
                        *pixel = Rgb::new(pixel.b + 0.1, pixel.r, pixel.g);
                    }
                }
                LinearImage::from_pixels(size, pixels).unwrap_or_else(|| picture.clone())
            }
        }
    }
}

/// Pixels beside which another object is seen.
fn edges(fixture: &Fixture) -> Vec<bool> {
    let seen = objects_seen(&fixture.scene);
    let tracer::Size { width, height } = fixture.scene.size();
    let at = |x: u32, y: u32| {
        seen.get(y as usize * width as usize + x as usize).copied().flatten().map(|o| o.0)
    };
    let is_edge = |x: u32, y: u32| {
        let columns = x.saturating_sub(1)..=(x + 1).min(width - 1);
        let mut rows = y.saturating_sub(1)..=(y + 1).min(height - 1);
        rows.any(|row| columns.clone().any(|column| at(column, row) != at(x, y)))
    };
    (0..height).flat_map(|y| (0..width).map(move |x| (x, y))).map(|(x, y)| is_edge(x, y)).collect()
}

/// The evidence of two pictures of one size.
pub fn judged(reference: LinearImage, actual: LinearImage, edges: Vec<bool>) -> Evidence {
    let pairs = reference.pixels().iter().zip(actual.pixels());
    let scale = Scale::of(&reference);
    let off = pairs.map(|(a, b)| !(scale.error(*a, *b) <= TOLERANCE)).collect();
    let (low, high) = (actual.clone(), actual.clone());
    Evidence { reference, actual, low, high, edges, off }
}

fn numbers(evidence: &Evidence) -> Numbers {
    let width = evidence.reference.size().width as usize;
    let scale = Scale::of(&evidence.reference);
    let errors = evidence.reference.pixels().iter().zip(evidence.actual.pixels());
    let mut numbers = Numbers {
        pixels: evidence.off.len() as u64,
        edge_pixels: 0,
        edge_off: 0,
        interior_off: 0,
        worst_interior: 0.0,
        worst_at: None,
    };
    for (i, (a, b)) in errors.enumerate() {
        let is_off = u64::from(evidence.off[i]);
        if evidence.edges[i] {
            numbers.edge_pixels += 1;
            numbers.edge_off += is_off;
            continue;
        }
        numbers.interior_off += is_off;
        let error = scale.error(*a, *b);
        if error > numbers.worst_interior {
            numbers.worst_interior = error;
            numbers.worst_at = Some(((i % width) as u32, (i / width) as u32));
        }
    }
    numbers
}

/// A run without fixtures.
pub fn run(id: &str) -> Run {
    let renderer = RendererInfo { name: id.to_owned(), id: id.to_owned(), version: String::new() };
    Run {
        schema: Run::SCHEMA,
        renderer,
        tolerance: TOLERANCE,
        edge_reach: 1.0 / 64.0,
        fixtures: BTreeMap::new(),
    }
}

/// A result of a hundred pixels, of which ten are edges and one of those is off.
pub fn result(outcome: Outcome, worst_interior: f64) -> FixtureResult {
    let has_picture = matches!(outcome, Outcome::Pass | Outcome::Fail);
    let is_off = !(worst_interior <= TOLERANCE);
    let numbers = Numbers {
        pixels: 100,
        edge_pixels: 10,
        edge_off: 1,
        interior_off: u64::from(is_off),
        worst_interior,
        worst_at: Some((3, 4)).filter(|_| is_off),
    };
    FixtureResult {
        features: BTreeSet::new(),
        outcome,
        findings: Vec::new(),
        numbers: Some(numbers).filter(|_| has_picture),
        elapsed_ms: 1.0,
    }
}
