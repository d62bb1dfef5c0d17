//! What pictures take: rays and tests counted, with skipping and without.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use rayon::prelude::*;
use serde::Serialize;
use tracer::{Event, LinearImage, Skipping, Stats};

use crate::fixture::{Build, Fixture};
use crate::suite::Suite;

/// Numbers by the names of what they count.
pub type ByName = BTreeMap<&'static str, u64>;

/// How often everything happened while one picture was made.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Counts {
    /// The version of this form.
    pub schema: u32,
    /// The fixture or file.
    pub scene: String,
    /// Whether what cannot change the picture was skipped.
    pub skips: bool,
    /// Each event by its name.
    pub counts: ByName,
}

impl Counts {
    /// These numbers, for this scene.
    pub fn new(scene: String, skipping: Skipping, stats: &Stats) -> Self {
        let counts = Event::ALL.into_iter().map(|event| (event.name(), stats.get(event)));
        Self { schema: 1, scene, skips: skipping == Skipping::On, counts: counts.collect() }
    }
}

/// One picture made with skipping and without.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Pair {
    /// The fixture's name.
    pub scene: String,
    /// Whether both pictures are the same, to the bit.
    pub same_bits: bool,
    /// What was done with skipping.
    pub with: ByName,
    /// What was done without.
    pub without: ByName,
}

/// What is written for machines.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Table {
    /// The version of this form.
    pub schema: u32,
    /// A row for each fixture.
    pub rows: Vec<Pair>,
}

/// Renders each fixture twice; `on_each` hears of each as it is done.
///
/// # Errors
/// The first fixture that cannot be read, as text for people.
pub fn with_and_without(
    suite: &Suite,
    names: &[String],
    on_each: &(dyn Fn(&str) + Sync),
) -> Result<Vec<Pair>, String> {
    let pair = |name: &String| {
        let label = Suite::fixture_label(name);
        let fixture = Fixture::open(&label, &suite.fixture_path(name), Build::default())?;
        let [with, without] = [Skipping::On, Skipping::Off].map(|skipping| {
            let (picture, stats) = fixture.render_counted(&fixture.plan(skipping));
            (bits(&picture), Counts::new(name.clone(), skipping, &stats).counts)
        });
        on_each(name);
        Ok(Pair {
            scene: name.clone(),
            same_bits: with.0 == without.0,
            with: with.1,
            without: without.1,
        })
    };
    names.par_iter().map(pair).collect()
}

/// A title, and the number under it.
type Column = (&'static str, fn(&ByName) -> u64);

/// What [`text`] shows.
const COLUMNS: [Column; 4] = [
    ("eye rays", |counts| get(counts, Event::EyeRay)),
    ("shadow rays", |counts| get(counts, Event::ShadowRay)),
    ("box tests", |counts| get(counts, Event::Node)),
    ("primitive tests", primitive_tests),
];

/// A line for each fixture, and one for all.
pub fn text(rows: &[Pair]) -> String {
    let mut text = format!("{:<36}", "with skipping / without");
    for (title, _) in COLUMNS {
        let _ = write!(text, "{title:>22}");
    }
    let mut line = |name: &str, rows: &[Pair]| {
        let _ = write!(text, "\n{name:<36}");
        for (_, number) in COLUMNS {
            let with: u64 = rows.iter().map(|row| number(&row.with)).sum();
            let without: u64 = rows.iter().map(|row| number(&row.without)).sum();
            let _ = write!(text, "{:>22}", format!("{with} / {without}"));
        }
    };
    for row in rows {
        line(&row.scene, std::slice::from_ref(row));
    }
    line("all", rows);
    text + "\n"
}

fn get(counts: &ByName, event: Event) -> u64 {
    counts.get(event.name()).copied().unwrap_or(0)
}

fn primitive_tests(counts: &ByName) -> u64 {
    let tests = Event::ALL.into_iter().filter(|event| event.is_primitive_test());
    tests.map(|event| get(counts, event)).sum()
}

fn bits(picture: &LinearImage) -> Vec<u64> {
    picture.pixels().iter().flat_map(|pixel| pixel.channels()).map(f64::to_bits).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn pair(scene: &str, sphere_tests: [u64; 2]) -> Pair {
        let [with, without] = sphere_tests.map(|n| ByName::from([("sphere_tests", n)]));
        Pair { scene: scene.to_owned(), same_bits: true, with, without }
    }

    #[test]
    fn the_table_has_a_line_for_each_and_one_for_all() {
        let text = text(&[pair("a", [3, 10]), pair("b", [0, 5])]);
        let last = |line: usize| {
            let words: Vec<_> = text.lines().nth(line).unwrap().split_whitespace().collect();
            (words[0], words[words.len() - 3..].join(" "))
        };
        assert_eq!(last(1), ("a", "3 / 10".to_owned()));
        assert_eq!(last(2), ("b", "0 / 5".to_owned()));
        assert_eq!(last(3), ("all", "3 / 15".to_owned()));
    }
}
