//! `Verdict`: what is said of a fixture, and `Outcome`: why.

use crate::metric::Comparison;

/// What is said of a fixture. Everything but a match fails a run.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Verdict {
    /// The picture is its golden, within the fixture's limits, and as expected.
    Match,
    /// The picture is not its golden.
    Differs,
    /// The picture is its golden, but not what the fixture expects on paper.
    ExpectationFailed,
    /// There is no golden.
    MissingGolden,
    /// There is a golden but no fixture.
    OrphanGolden,
    /// Picture and golden have different sizes.
    WrongSize,
    /// The golden was accepted for another scene than the fixture is now, or
    /// does not say for which.
    StaleGolden,
    /// The golden cannot be read.
    Unreadable,
    /// There is no picture: the fixture has problems, or its picture a NaN.
    RenderRefused,
}

impl Verdict {
    /// Every verdict, the good one first.
    pub const ALL: [Self; 9] = [
        Self::Match,
        Self::Differs,
        Self::ExpectationFailed,
        Self::MissingGolden,
        Self::OrphanGolden,
        Self::WrongSize,
        Self::StaleGolden,
        Self::Unreadable,
        Self::RenderRefused,
    ];

    /// Its name for machines.
    pub fn id(self) -> &'static str {
        match self {
            Self::Match => "match",
            Self::Differs => "differs",
            Self::ExpectationFailed => "expectation_failed",
            Self::MissingGolden => "missing_golden",
            Self::OrphanGolden => "orphan_golden",
            Self::WrongSize => "wrong_size",
            Self::StaleGolden => "stale_golden",
            Self::Unreadable => "unreadable",
            Self::RenderRefused => "render_refused",
        }
    }

    /// Its name for people.
    pub fn words(self) -> String {
        self.id().replace('_', " ")
    }

    /// Whether accepting the picture as the new golden would settle it.
    pub fn can_be_blessed(self) -> bool {
        matches!(
            self,
            Self::Differs
                | Self::MissingGolden
                | Self::WrongSize
                | Self::StaleGolden
                | Self::Unreadable
        )
    }
}

/// A verdict with its reasons and numbers.
#[derive(Debug, Clone, PartialEq)]
pub struct Outcome {
    /// The fixture's name: its path below `fixtures/`, without `.ron`.
    pub name: String,
    /// What is said of it.
    pub verdict: Verdict,
    /// Why, in sentences; empty for a plain match.
    pub findings: Vec<String>,
    /// The metrics, where picture and golden could be compared.
    pub comparison: Option<Comparison>,
    /// Width and height of the picture.
    pub size: Option<(u32, u32)>,
    /// How long reading and rendering took, in milliseconds.
    pub render_ms: f64,
    /// How long reading the golden and comparing took, in milliseconds.
    pub compare_ms: f64,
    /// Where a picture of the failure was put, relative to the suite.
    pub strip: Option<String>,
}

impl Outcome {
    /// The command that helps with it; `None` for a match.
    pub fn command(&self) -> Option<String> {
        let Self { name, verdict, .. } = self;
        match verdict {
            Verdict::Match => None,
            Verdict::OrphanGolden => Some(format!("cargo xtask bless --prune {name}")),
            Verdict::RenderRefused | Verdict::ExpectationFailed => {
                Some(format!("cargo xtask check {name}"))
            }
            _ => Some(format!("cargo xtask bless {name}")),
        }
    }
}
