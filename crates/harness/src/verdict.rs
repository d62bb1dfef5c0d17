//! `Verdict`: what is said of a fixture, and `Outcome`: why.

use crate::blame::Blamed;
use crate::evidence::Evidence;
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
    /// The picture is its golden and as expected, but not as like the picture
    /// of a related scene as the fixture says.
    RelationFailed,
    /// Renders of the very same scene differ.
    Unsteady,
    /// There is no golden.
    MissingGolden,
    /// There is a golden but no fixture.
    OrphanGolden,
    /// Picture and golden have different sizes.
    WrongSize,
    /// The golden's picture is not the one that was accepted.
    TamperedGolden,
    /// The golden was accepted for another scene than the fixture is now, or
    /// does not say for which.
    StaleGolden,
    /// The golden's file is too large, or small where its fixture says that it
    /// is large.
    GoldenFileSize,
    /// The golden cannot be read.
    Unreadable,
    /// There is no picture: the fixture has problems, or its picture a NaN.
    RenderRefused,
}

impl Verdict {
    /// Every verdict, the good one first.
    pub const ALL: [Self; 13] = [
        Self::Match,
        Self::Differs,
        Self::ExpectationFailed,
        Self::RelationFailed,
        Self::Unsteady,
        Self::MissingGolden,
        Self::OrphanGolden,
        Self::WrongSize,
        Self::TamperedGolden,
        Self::StaleGolden,
        Self::GoldenFileSize,
        Self::Unreadable,
        Self::RenderRefused,
    ];

    /// Its name for machines.
    pub fn id(self) -> &'static str {
        match self {
            Self::Match => "match",
            Self::Differs => "differs",
            Self::ExpectationFailed => "expectation_failed",
            Self::RelationFailed => "relation_failed",
            Self::Unsteady => "unsteady",
            Self::MissingGolden => "missing_golden",
            Self::OrphanGolden => "orphan_golden",
            Self::WrongSize => "wrong_size",
            Self::TamperedGolden => "tampered_golden",
            Self::StaleGolden => "stale_golden",
            Self::GoldenFileSize => "golden_file_size",
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
                | Self::TamperedGolden
                | Self::StaleGolden
                | Self::Unreadable
        )
    }
}

/// Where a verdict is from.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Origin {
    /// The fixture was rendered.
    #[default]
    Rendered,
    /// Nothing that it follows from changed since it was last a match; it was
    /// not rendered.
    Unchanged,
    /// Nothing changed, and it was rendered all the same.
    Audited,
    /// It was rendered as an audit, and is no match although it was recorded
    /// as one.
    Belied,
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
    /// Whether the picture breaks what its fixture expects, so that it cannot
    /// be accepted, whatever the verdict.
    pub breaks_expectations: bool,
    /// Whether the picture breaks a relation of its fixture, likewise.
    pub breaks_relations: bool,
    /// Whether the golden must not be replaced, as nobody here has looked at it: a
    /// newer goldray accepted it, or Git LFS has not fetched it.
    pub keeps_golden: bool,
    /// The metrics, where picture and golden could be compared.
    pub comparison: Option<Comparison>,
    /// What the difference from the golden lies on, the most blamed first.
    pub blamed: Vec<Blamed>,
    /// Line and column in the fixture's file, from 1, of what is to be looked at
    /// first; `None` for a match and where the file does not say.
    pub place: Option<(usize, usize)>,
    /// Width and height of the picture.
    pub size: Option<(u32, u32)>,
    /// How long reading and rendering took, in milliseconds.
    pub render_ms: f64,
    /// How long reading the golden and comparing took, in milliseconds.
    pub compare_ms: f64,
    /// How long related scenes took, in milliseconds.
    pub relate_ms: f64,
    /// Where a picture of the failure was put, relative to the suite.
    pub strip: Option<String>,
    /// What there is to see of a picture that is not its golden, for a report.
    pub evidence: Option<Box<Evidence>>,
    /// Where the verdict is from.
    pub origin: Origin,
}

impl Outcome {
    /// The verdict on what was not rendered, without reasons or numbers.
    pub(crate) fn unrendered(name: &str, verdict: Verdict) -> Self {
        Self {
            name: name.to_owned(),
            verdict,
            findings: Vec::new(),
            breaks_expectations: false,
            breaks_relations: false,
            keeps_golden: false,
            comparison: None,
            blamed: Vec::new(),
            place: None,
            size: None,
            render_ms: 0.0,
            compare_ms: 0.0,
            relate_ms: 0.0,
            strip: None,
            evidence: None,
            origin: Origin::Rendered,
        }
    }

    /// The verb of `cargo xtask` that settles it, if it was meant, with its
    /// arguments; `None` for a match and where no verb does.
    pub fn remedy(&self) -> Option<String> {
        let name = shell_word(&self.name);
        match self.verdict {
            Verdict::OrphanGolden => Some(format!("bless --prune {name}")),
            verdict
                if verdict.can_be_blessed() && !self.breaks_its_word() && !self.keeps_golden =>
            {
                Some(format!("bless {name}"))
            }
            _ => None,
        }
    }

    /// Whether the picture is wrong by what its fixture says, whatever the
    /// golden.
    pub fn breaks_its_word(&self) -> bool {
        self.breaks_expectations || self.breaks_relations
    }
}

/// A name as a shell takes it for one word, and no flag.
pub fn shell_word(name: &str) -> String {
    let is_plain = |c: char| c.is_ascii_alphanumeric() || matches!(c, '/' | '_' | '-' | '.');
    match name {
        name if name.starts_with('-') => format!("-- '{}'", name.replace('\'', r"'\''")),
        name if name.chars().all(is_plain) => name.to_owned(),
        name => format!("'{}'", name.replace('\'', r"'\''")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_words() {
        assert_eq!(shell_word("sphere/far-away"), "sphere/far-away");
        assert_eq!(shell_word("it's $x"), r"'it'\''s $x'");
        assert_eq!(shell_word("star*"), "'star*'");
        assert_eq!(shell_word("-dash"), "-- '-dash'");
    }
    fn outcome(verdict: Verdict) -> Outcome {
        Outcome::unrendered("a/b c", verdict)
    }

    #[test]
    fn only_what_accepting_settles_is_blessed() {
        use Verdict::{
            Differs, MissingGolden, OrphanGolden, StaleGolden, TamperedGolden, Unreadable,
            WrongSize,
        };
        let blessed = [Differs, MissingGolden, WrongSize, TamperedGolden, StaleGolden, Unreadable];
        for verdict in Verdict::ALL {
            let expected = match verdict {
                OrphanGolden => Some("bless --prune 'a/b c'"),
                verdict if blessed.contains(&verdict) => Some("bless 'a/b c'"),
                _ => None,
            };
            assert_eq!(outcome(verdict).remedy().as_deref(), expected, "{verdict:?}");
        }
    }

    #[test]
    fn a_picture_that_is_wrong_is_not_blessed() {
        let differs = || outcome(Verdict::Differs);
        let breaks_expectations = Outcome { breaks_expectations: true, ..differs() };
        let breaks_relations = Outcome { breaks_relations: true, ..differs() };
        let keeps_golden = Outcome { keeps_golden: true, ..differs() };
        assert!(differs().remedy().is_some() && !differs().breaks_its_word());
        assert!(breaks_expectations.breaks_its_word() && breaks_relations.breaks_its_word());
        assert!(!keeps_golden.breaks_its_word(), "the golden is to blame, not the picture");
        for wrong in [breaks_expectations, breaks_relations, keeps_golden] {
            assert_eq!(wrong.remedy(), None, "{wrong:?}");
        }
        // What has no fixture has no word to break.
        let orphan = Outcome { keeps_golden: true, ..outcome(Verdict::OrphanGolden) };
        assert!(orphan.remedy().is_some());
    }
}
