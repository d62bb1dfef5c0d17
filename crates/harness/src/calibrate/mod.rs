//! Calibration: how far pictures of one scene are apart when nothing but the way
//! of making them changes, and which limits that justifies.

mod report;
mod spread;
mod way;

use serde::{Deserialize, Serialize};
use tracer::accel::Build;

pub use report::{Report, Together};
pub use spread::{MARGIN, Spread};
pub use way::{THREADS, Way, Ways};

use crate::digest::Digest;
use crate::expectation::Rendered;
use crate::fixture::Fixture;
use crate::suite::Suite;

/// What one build of goldray found.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Record {
    /// The version of this form.
    pub schema: u32,
    /// Which build.
    pub build: String,
    /// In how many ways each picture was made.
    pub ways: usize,
    /// How many times its spread a fixture's limit may be.
    pub margin: f64,
    /// Every fixture that was asked for, by name.
    pub fixtures: Vec<Calibrated>,
}

/// What was found of one fixture.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Calibrated {
    /// Its name.
    pub fixture: String,
    /// The bits of its linear picture, made in the first way.
    pub linear: String,
    /// The bits of its encoded picture, made in the first way.
    pub encoded: String,
    /// How far those made in other ways are from that.
    pub spread: Spread,
    /// Whether it has limits.
    pub has_limits: bool,
}

/// The build that runs: of the two profiles of a checkout, the one with debug
/// assertions or the one without.
pub fn this_build() -> &'static str {
    if cfg!(debug_assertions) { "dev" } else { "release" }
}

/// Makes the pictures of all these fixtures in all ways; `on_each` hears of each
/// as it is done.
///
/// # Errors
/// The first fixture that has no picture, or a number of threads that the
/// system does not give, as text for people.
pub fn calibrate(
    suite: &Suite,
    names: &[String],
    repeats: u32,
    on_each: &dyn Fn(&str),
) -> Result<Record, String> {
    let ways = Ways::new(repeats)?;
    let one = |name: &String| {
        let calibrated = calibrate_fixture(suite, name, &ways)?;
        on_each(name);
        Ok(calibrated)
    };
    Ok(Record {
        schema: 1,
        build: this_build().to_owned(),
        ways: ways.all().len(),
        margin: MARGIN,
        fixtures: names.iter().map(one).collect::<Result<_, String>>()?,
    })
}

/// Makes a fixture's picture in all ways.
///
/// # Errors
/// It has no picture.
pub fn calibrate_fixture(suite: &Suite, name: &str, ways: &Ways) -> Result<Calibrated, String> {
    let (label, path) = (Suite::fixture_label(name), suite.fixture_path(name));
    let render = |way: &Way| {
        let fixture = Fixture::open(&label, &path, way.build())?;
        fixture.render().map_err(|why| format!("{label}: {why}"))
    };
    let (digest, spread) = spread_of(ways, &render)?;
    let Digest { linear, encoded } = digest;
    let has_limits = Fixture::open(&label, &path, Build::List)?.check.limits.is_some();
    Ok(Calibrated { fixture: name.to_owned(), linear, encoded, spread, has_limits })
}

/// The bits of the picture that is made in the first way, and how far the others
/// are from it.
///
/// # Errors
/// Those of `render`.
pub fn spread_of(
    ways: &Ways,
    render: &(dyn Fn(&Way) -> Result<Rendered, String> + Sync),
) -> Result<(Digest, Spread), String> {
    let (first, others) = ways.all().split_first().ok_or("expected at least one way")?;
    let reference = ways.install(first, || render(first))?;
    let digest = Digest::of(&reference);
    let mut spread = Spread::default();
    for way in others {
        let picture = ways.install(way, || render(way))?;
        if Digest::of(&picture) != digest {
            spread.widen(&reference, &picture);
        }
    }
    Ok((digest, spread))
}

#[cfg(test)]
mod tests;
