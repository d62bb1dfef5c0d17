//! `Rubric`: what a grade gives points for, as a teacher writes it.

use interchange::Feature;
use serde::Deserialize;

use crate::Outcome;

/// The version of the format that is read.
pub const VERSION: u32 = 1;

/// What a grade gives points for.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Rubric {
    /// The version of the format, [`VERSION`].
    pub version: u32,
    /// What is graded.
    pub title: String,
    /// What points are given for.
    pub parts: Vec<Part>,
    /// What they are taken for.
    #[serde(default)]
    pub penalties: Vec<Penalty>,
}

/// Something that points are given for: fixtures that must pass.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Part {
    /// Its name.
    pub name: String,
    /// How many points all of it is worth, with two decimals at most.
    pub points: f64,
    /// Which fixtures, by filters as on the command line; all if there are only
    /// features.
    #[serde(default)]
    pub fixtures: Vec<String>,
    /// Of those, the ones that ask for any of these; all if there are none.
    #[serde(default)]
    pub features: Vec<Feature>,
    /// How points are given.
    #[serde(default)]
    pub per: Per,
}

/// How points are given.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Deserialize)]
pub enum Per {
    /// As many as fixtures pass.
    #[default]
    Share,
    /// All if all pass, else none.
    All,
}

/// Something that points are taken for: how a renderer must not end.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Penalty {
    /// Its name.
    pub name: String,
    /// How many points are taken, with two decimals at most.
    pub points: f64,
    /// For what.
    pub outcomes: Vec<Ending>,
    /// Of which fixtures, by filters; of all that a part asks for if there are none.
    #[serde(default)]
    pub fixtures: Vec<String>,
    /// How often.
    #[serde(default)]
    pub per: Often,
    /// The most that is taken.
    #[serde(default)]
    pub at_most: Option<f64>,
}

/// How often points are taken.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Deserialize)]
pub enum Often {
    /// For each fixture.
    #[default]
    Each,
    /// Once, however many fixtures there are.
    Once,
}

/// An outcome that is no pass.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
pub enum Ending {
    /// A picture that is wrong.
    Fail,
    /// The adapter does not have what the scene asks for.
    Unsupported,
    /// It ended with an error, or by a signal.
    Crashed,
    /// It was killed after its timeout.
    TimedOut,
    /// It ended well and wrote no picture.
    NoPicture,
    /// What it wrote is no picture.
    BadPicture,
    /// A picture of another size.
    WrongSize,
}

impl Ending {
    /// The outcome that it is.
    pub fn outcome(self) -> Outcome {
        match self {
            Self::Fail => Outcome::Fail,
            Self::Unsupported => Outcome::Unsupported,
            Self::Crashed => Outcome::Crashed,
            Self::TimedOut => Outcome::TimedOut,
            Self::NoPicture => Outcome::NoPicture,
            Self::BadPicture => Outcome::BadPicture,
            Self::WrongSize => Outcome::WrongSize,
        }
    }
}
