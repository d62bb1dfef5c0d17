//! `Case`: a fixture with its golden.

use tracer::accel::Build;

use crate::fixture::Fixture;
use crate::golden::Golden;
use crate::judge::Found;
use crate::run::find_golden;
use crate::suite::Suite;

/// What is asked of a fixture beyond today's verdict starts from this.
#[derive(Debug, Clone)]
pub struct Case {
    /// The fixture's name.
    pub name: String,
    /// The fixture.
    pub fixture: Fixture,
    /// Its golden.
    pub golden: Golden,
}

impl Case {
    /// The fixture of this name and its golden.
    ///
    /// # Errors
    /// Everything that is wrong with the fixture, or that there is no golden to
    /// be read, as text for people.
    pub fn open(suite: &Suite, name: &str) -> Result<Self, String> {
        let (label, path) = (Suite::fixture_label(name), suite.fixture_path(name));
        let fixture = Fixture::open(&label, &path, Build::default())?;
        let golden = match find_golden(&suite.golden_path(name)) {
            Found::Golden(golden) => golden,
            Found::Nothing => return Err(format!("{label}: there is no golden")),
            Found::Unreadable(why) => return Err(format!("{label}: the golden {why}")),
        };
        Ok(Self { name: name.to_owned(), fixture, golden })
    }

    /// The line of the text with what is at this path, from 1.
    pub fn line_of(&self, path: &[scene::Step]) -> usize {
        scene::line_column(&self.fixture.text, scene::span_of(&self.fixture.text, path).start).0
    }
}
