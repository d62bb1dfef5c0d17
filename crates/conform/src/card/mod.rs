//! The scorecard: renderers beside what scenes ask of them, made only from runs.
//!
//! ```text
//! Conformed, one for each renderer -> Card -> scorecard.json, .md, .html, badge-ID.svg
//! ```

mod badge;
mod json;
mod markdown;
mod page;
mod rule;
mod selection;
mod tally;
#[cfg(test)]
pub(crate) mod tests;
mod write;

use std::collections::{BTreeMap, BTreeSet};

use interchange::Feature;

pub use badge::badge;
pub use json::json;
pub(crate) use markdown::{counted, error};
pub use markdown::{markdown, sentences};
pub(crate) use page::grade_html;
pub use page::html;
pub use rule::{Reading, Standing, Suspicion};
pub use selection::Selection;
pub use tally::{Tally, Worst};
pub use write::{WriteError, file_names, write};

use crate::consensus::{self, Overall, Told};
use crate::objects::{Objects, Seen};
use crate::{Conformed, FixtureResult, RendererInfo, outcome};

/// Looks up what the pixels of a fixture show, by its name; `None` where that is not
/// known.
pub type Look<'a> = dyn Fn(&str) -> Option<Objects> + 'a;

/// Renderers beside what scenes ask of them.
#[derive(Debug, Clone, PartialEq)]
pub struct Card {
    /// Which part of the suite was asked for; `None` where it was all of it.
    pub selection: Option<Selection>,
    /// The renderers, in the order of the runs.
    pub renderers: Vec<Column>,
    /// What the fixtures ask for, by family.
    pub rows: Vec<Row>,
    /// What no fixture of any run asks for.
    pub unasked: Vec<Feature>,
    /// The fixtures of all runs, by name.
    pub fixtures: BTreeMap<String, Entry>,
    /// What came of the consensus; without fixtures where too few renderers have a
    /// picture of one.
    pub consensus: Overall,
}

/// A renderer.
#[derive(Debug, Clone, PartialEq)]
pub struct Column {
    /// Who it is.
    pub info: RendererInfo,
    /// How far an interior pixel may be off, relative.
    pub tolerance: f64,
    /// How far a sample is moved to tell edges, in pixels.
    pub edge_reach: f64,
    /// What came of all its fixtures.
    pub tally: Tally,
}

/// A feature beside every renderer.
#[derive(Debug, Clone, PartialEq)]
pub struct Row {
    /// The feature.
    pub feature: Feature,
    /// One for each renderer.
    pub cells: Vec<Cell>,
}

/// A feature with a renderer.
#[derive(Debug, Clone, PartialEq)]
pub struct Cell {
    /// What the run says of it.
    pub standing: Standing,
    /// What came of the fixtures that ask for it.
    pub tally: Tally,
}

/// A fixture beside every renderer.
#[derive(Debug, Clone, PartialEq)]
pub struct Entry {
    /// What its scene asks for.
    pub features: BTreeSet<Feature>,
    /// What came of it with each renderer; `None` where the run is without it.
    pub results: Vec<Option<Answered>>,
    /// What the renderers say of it together; `None` where too few have a picture.
    pub told: Option<Told>,
}

/// What came of a fixture with a renderer.
#[derive(Debug, Clone, PartialEq)]
pub struct Answered {
    /// The run's own result.
    pub result: FixtureResult,
    /// What a failure may be put down to.
    pub suspicion: Option<Suspicion>,
    /// What the worst pixel of a failure shows.
    pub worst_on: Option<Seen>,
}

/// Runs that make no card.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum NoCard {
    /// Two runs are of one renderer.
    TwoOfOneId(String),
    /// An id that is no name of a file: letters, digits, `-` and `_` are.
    BadId(String),
}

impl std::fmt::Display for NoCard {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::TwoOfOneId(id) => {
                write!(f, "expected one run of each renderer, found two of \"{id}\"")
            }
            Self::BadId(id) => write!(
                f,
                "expected an id of letters, digits, `-` and `_`, found \"{}\"",
                scene::visible(id)
            ),
        }
    }
}

impl std::error::Error for NoCard {}

impl Card {
    /// The card of these runs; `look` is asked only of fixtures that some renderer
    /// fails.
    ///
    /// # Errors
    /// See [`NoCard`].
    pub fn of(runs: &[Conformed], look: &Look<'_>) -> Result<Self, NoCard> {
        check_ids(runs)?;
        let readings: Vec<_> = runs.iter().map(|one| Reading::of(&one.run)).collect();
        let names: BTreeSet<&String> =
            runs.iter().flat_map(|one| one.run.fixtures.keys()).collect();
        let fixtures: BTreeMap<_, _> = names
            .into_iter()
            .map(|name| (name.clone(), entry(name, runs, &readings, look)))
            .collect();
        let asked: BTreeSet<_> = fixtures.values().flat_map(|f| &f.features).copied().collect();
        let (asked, unasked) = Feature::ALL.iter().partition(|feature| asked.contains(feature));
        let row = |feature: Feature| {
            let cell = |(one, reading): (&Conformed, &Reading)| cell(feature, one, reading);
            Row { feature, cells: runs.iter().zip(&readings).map(cell).collect() }
        };
        let told = fixtures.iter().filter_map(|(name, f)| Some((name.as_str(), f.told.as_ref()?)));
        let consensus = consensus::overall(told);
        let rows = Vec::into_iter(asked).map(row).collect();
        Ok(Self {
            selection: None,
            renderers: runs.iter().map(column).collect(),
            rows,
            unasked,
            fixtures,
            consensus,
        })
    }

    /// The same card, of a part of the suite.
    #[must_use]
    pub fn of_part(self, selection: Option<Selection>) -> Self {
        Self { selection, ..self }
    }

    /// Whether nothing was asked of anybody.
    pub fn is_empty(&self) -> bool {
        self.renderers.is_empty() || self.fixtures.is_empty()
    }

    /// The names of those who were heard about a scene, in order, goldray first.
    pub fn names<'a>(&'a self, told: &'a Told) -> Vec<&'a str> {
        told.voters.iter().map(|id| self.name(id)).collect()
    }

    /// The name of a voter; goldray itself may not be among the renderers.
    fn name<'a>(&'a self, id: &'a str) -> &'a str {
        let column = self.renderers.iter().find(|column| column.info.id == id);
        column.map_or(id, |column| column.info.name.as_str())
    }

    /// The ids of the renderers, in order.
    pub fn ids(&self) -> impl Iterator<Item = &str> {
        self.renderers.iter().map(|column| column.info.id.as_str())
    }
}

/// Whether this is a name of files: letters, digits, `-` and `_`.
fn is_id(id: &str) -> bool {
    let is_good = |c: char| c.is_ascii_alphanumeric() || c == '-' || c == '_';
    !id.is_empty() && id.chars().all(is_good)
}

fn check_ids(runs: &[Conformed]) -> Result<(), NoCard> {
    let mut seen = BTreeSet::new();
    for one in runs {
        let id = &one.run.renderer.id;
        if !is_id(id) {
            return Err(NoCard::BadId(id.clone()));
        }
        // Some systems do not tell upper from lower case in names of files.
        if !seen.insert(id.to_ascii_lowercase()) {
            return Err(NoCard::TwoOfOneId(id.clone()));
        }
    }
    Ok(())
}

fn column(one: &Conformed) -> Column {
    Column {
        info: one.run.renderer.clone(),
        tolerance: one.run.tolerance,
        edge_reach: one.run.edge_reach,
        tally: Tally::of(one.run.fixtures.iter().map(|(name, result)| (name.as_str(), result))),
    }
}

fn cell(feature: Feature, one: &Conformed, reading: &Reading) -> Cell {
    let having = one.run.fixtures.iter().filter(|(_, f)| f.features.contains(&feature));
    Cell {
        standing: reading.standing(&one.run, feature),
        tally: Tally::of(having.map(|(name, result)| (name.as_str(), result))),
    }
}

fn entry(name: &str, runs: &[Conformed], readings: &[Reading], look: &Look<'_>) -> Entry {
    let results = || runs.iter().map(|one| one.run.fixtures.get(name));
    let is_off =
        |result: &FixtureResult| outcome::is_failure(result.outcome) && result.numbers.is_some();
    let objects = if results().flatten().any(is_off) { look(name) } else { None };
    let told = consensus::of_fixture(name, runs, &|| objects.clone().or_else(|| look(name)));
    let answered = |(i, result): (usize, Option<&FixtureResult>)| {
        let result = result?.clone();
        let at = result.numbers.filter(|_| is_off(&result)).and_then(|n| n.worst_at);
        let width = runs[i].evidence.get(name).map(|e| e.reference.size().width as usize);
        let pixel = at.zip(width).map(|((x, y), width)| y as usize * width + x as usize);
        let worst_on = pixel.zip(objects.as_ref()).and_then(|(pixel, objects)| objects.at(pixel));
        let suspicion = readings[i].suspicions.get(name).cloned();
        Some(Answered { result, suspicion, worst_on })
    };
    Entry {
        features: results().flatten().flat_map(|result| &result.features).copied().collect(),
        results: results().enumerate().map(answered).collect(),
        told,
    }
}
